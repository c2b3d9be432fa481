#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What no way of asking can better: the least standard error of a threshold, by Fisher's information.

    /usr/bin/python3 tests/bench/threshold_limits.py [--ways]

All questions at the one best difference, slope and lapses known beforehand. Prints rows of docs/measurements/coverage.md. With --ways: what four ways past it come
to with simulated observers, each question the one that leaves the least doubt; rows of docs/develop/decisions/1207-thresholds-and-ratings.md."""

import sys

import numpy

LAPSE, QUESTIONS = 0.02, 60


def least_error(slope, guess, questions=QUESTIONS):
    """Of ln threshold, by Weibull's form as in playback/study/statistics/quest_plus.h, `guess` right without feeling anything."""
    difference = numpy.exp(numpy.linspace(-3, 3, 2001))

    def told(threshold):
        return guess + (1 - guess - LAPSE) * (1 - 2.0 ** -((difference / threshold) ** slope))

    step = 1e-5
    rise = (told(numpy.exp(step)) - told(numpy.exp(-step))) / (2 * step)
    share = told(1.0)
    return 1 / numpy.sqrt(questions * (rise ** 2 / (share * (1 - share))).max())


def entropy(p):
    return -(p * numpy.log(numpy.maximum(p, 1e-300))).sum(axis=-1)


def asked(slope, guess, questions, observers=400, threshold=0.1, expected=None):
    """Errors of ln threshold of observers whose slope and lapses are known; `expected`: the standard deviation of people's thresholds, in ln, about
    the one that is right in the mean; none: from 1 to 150 % all are as likely."""
    chance = numpy.random.default_rng(26)
    levels, thresholds = 0.01 * 10 ** (numpy.arange(25) / 12), numpy.geomspace(0.01, 1.5, 161)
    told = guess + (1 - guess - LAPSE) * (1 - 2.0 ** -((levels[:, None] / thresholds) ** slope))
    prior = numpy.ones(len(thresholds)) if expected is None else numpy.exp(-0.5 * (numpy.log(thresholds / threshold) / expected) ** 2)
    truths = threshold * numpy.exp((expected or 0) * chance.normal(size=observers))
    belief = numpy.tile(prior / prior.sum(), (observers, 1))
    for _ in range(questions):
        right = belief @ told.T
        doubt = numpy.empty_like(right)
        for level, share in enumerate(told):
            of_right, of_wrong = belief * share, belief * (1 - share)
            p = right[:, level]
            doubt[:, level] = p * entropy(of_right / p[:, None]) + (1 - p) * entropy(of_wrong / (1 - p)[:, None])
        best = doubt.argmin(axis=1)
        shares = guess + (1 - guess - LAPSE) * (1 - 2.0 ** -((levels[best] / truths) ** slope))
        correct = chance.random(observers) < shares
        belief *= numpy.where(correct[:, None], told[best], 1 - told[best])
        belief /= belief.sum(axis=1, keepdims=True)
    middle = [numpy.interp(0.5, numpy.cumsum(b), numpy.log(thresholds)) for b in belief]
    return numpy.array(middle) - numpy.log(truths)


def ways():
    rows = [("slope and lapses known", {}), ("and twice the questions", {"questions": 120}), ("and four choices", {"guess": 1 / 4}),
            ("and people known to differ by 30 %", {"expected": 0.3})]
    print("| way | slope 1.25: standard error, % | 2 | 3.5 |\n|---|---|---|---|")
    for name, way in rows:
        errors = [asked(slope, **{"guess": 1 / 2, "questions": QUESTIONS, **way}) for slope in (1.25, 2, 3.5)]
        print(f"| {name} | " + " | ".join(f"{100 * numpy.sqrt((e ** 2).mean()):.0f}" for e in errors) + " |", flush=True)
    one = asked(1.25, 1 / 2, QUESTIONS)
    groups = one[: len(one) // 5 * 5].reshape(-1, 5).mean(axis=1)
    print(f"| the mean of five people, slope 1.25 | {100 * numpy.sqrt((groups ** 2).mean()):.0f} | | |")


def main():
    if "--ways" in sys.argv[1:]:
        return ways()
    print("| slope | two choices, 60 questions, % | 120, % | three choices, 60, % | four choices, 60, % | questions of two choices for 10 % |\n|---|---|---|---|---|---|")
    for slope in (1.25, 2, 3.5):
        errors = [100 * least_error(slope, 1 / 2), 100 * least_error(slope, 1 / 2, 120), 100 * least_error(slope, 1 / 3), 100 * least_error(slope, 1 / 4)]
        needed = QUESTIONS * (least_error(slope, 1 / 2) / 0.1) ** 2
        print(f"| {slope} | " + " | ".join(f"{e:.0f}" for e in errors) + f" | {needed:.0f} |")


if __name__ == "__main__":
    main()
