#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What no way of asking can better: the least standard error of a threshold, by Fisher's information.

    /usr/bin/python3 tests/bench/threshold_limits.py

All questions at the one best difference, slope and lapses known beforehand. Prints rows of docs/coverage.md."""

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


def main():
    print("| slope | two choices, 60 questions, % | 120, % | three choices, 60, % | four choices, 60, % | questions of two choices for 10 % |\n|---|---|---|---|---|---|")
    for slope in (1.25, 2, 3.5):
        errors = [100 * least_error(slope, 1 / 2), 100 * least_error(slope, 1 / 2, 120), 100 * least_error(slope, 1 / 3), 100 * least_error(slope, 1 / 4)]
        needed = QUESTIONS * (least_error(slope, 1 / 2) / 0.1) ** 2
        print(f"| {slope} | " + " | ".join(f"{e:.0f}" for e in errors) + f" | {needed:.0f} |")


if __name__ == "__main__":
    main()
