#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The expected numbers of preference_test.cpp and quest_plus_test.cpp, by numpy and scipy and by another way than the product's: a
general minimiser in place of Newton's steps, one product over all answers in place of one update for each. Run it to print them anew."""

import numpy
from scipy.optimize import minimize
from scipy.stats import norm, t

# person, winner, loser; as in the test
CHOICES = [(p, w, l) for p in range(8) for w, l in ((0, 1), (0, 1), (0, 2), (1, 2), (2, 1))]
CHOICES = [(p, l, w) if (p * 7 + i * 3) % 5 == 0 else (p, w, l) for i, (p, w, l) in enumerate(CHOICES)]


def scores_of(choices, things):
    pairs = {tuple(sorted((w, l))) for _, w, l in choices}

    def loss(free):
        s = numpy.append(free, -free.sum())
        value = sum(numpy.log1p(numpy.exp(s[l] - s[w])) for _, w, l in choices)
        return value + sum(0.5 * (numpy.log1p(numpy.exp(s[b] - s[a])) + numpy.log1p(numpy.exp(s[a] - s[b]))) for a, b in pairs)

    free = minimize(loss, numpy.zeros(things - 1), method="BFGS", options={"gtol": 1e-12}).x
    return numpy.append(free, -free.sum()), pairs


def spread_of(choices, things):
    """Covariance over persons and over trials, in the free scores and carried over to all."""
    s, pairs = scores_of(choices, things)
    carry = numpy.vstack([numpy.eye(things - 1), -numpy.ones(things - 1)])
    counts = {pair: 1 + sum(1 for _, w, l in choices if tuple(sorted((w, l))) == pair) for pair in pairs}
    information = numpy.zeros((things, things))
    for (a, b), n in counts.items():
        q = 1 / (1 + numpy.exp(s[b] - s[a]))
        d = numpy.zeros(things)
        d[a], d[b] = 1, -1
        information += n * q * (1 - q) * numpy.outer(d, d)
    bread = numpy.linalg.inv(carry.T @ information @ carry)
    people = sorted({p for p, _, _ in choices})
    meat = numpy.zeros((things - 1, things - 1))
    for person in people:
        pull = numpy.zeros(things)
        for p, w, l in choices:
            if p == person:
                surprise = 1 - 1 / (1 + numpy.exp(s[l] - s[w]))
                pull[w] += surprise
                pull[l] -= surprise
        meat += numpy.outer(carry.T @ pull, carry.T @ pull)
    n = len(people)
    persons = carry @ (bread @ meat @ bread * n / (n - 1)) @ carry.T
    trials = carry @ bread @ carry.T
    return s, t.ppf(0.975, n - 1) * numpy.sqrt(numpy.diag(persons)), norm.ppf(0.975) * numpy.sqrt(numpy.diag(trials))


def quest_plus():
    levels = 0.01 * 10 ** (numpy.arange(25) / 12)
    thresholds = numpy.geomspace(levels[0], 1.5 * levels[-1], 81)
    slopes, lapses = numpy.array([1, 1.4, 2, 2.8, 4]), numpy.array([0, 0.02, 0.05])
    th, sl, la = numpy.meshgrid(thresholds, slopes, lapses, indexing="ij")

    def right(level):
        return 0.5 + (0.5 - la) * (1 - 0.5 ** ((level / th) ** sl))

    def entropy(p):
        p = p[p > 0]
        return -(p * numpy.log(p)).sum()

    asked = []
    likelihood = numpy.ones_like(th)
    for i in range(20):
        posterior = likelihood / likelihood.sum()
        expected = []
        for level in levels:
            yes, no = posterior * right(level), posterior * (1 - right(level))
            expected.append(yes.sum() * entropy(yes / yes.sum()) + no.sum() * entropy(no / no.sum()))
        at = int(numpy.argmin(expected))
        asked.append(at)
        correct = levels[at] > 0.12 or i % 3 == 0
        likelihood = likelihood * (right(levels[at]) if correct else 1 - right(levels[at]))
    by_threshold = likelihood.sum(axis=(1, 2)) / likelihood.sum()
    # Each threshold stands for the stretch half way to its neighbours, on a log scale.
    logs = numpy.log(thresholds)
    step = logs[1] - logs[0]
    edges = numpy.append(logs - step / 2, logs[-1] + step / 2)
    cumulated = numpy.append(0, numpy.cumsum(by_threshold))
    return asked, numpy.exp(numpy.interp([0.025, 0.5, 0.975], cumulated, edges))


if __name__ == "__main__":
    numpy.set_printoptions(precision=10)
    values, by_persons, by_trials = spread_of(CHOICES, 3)
    print("scores", values, "half widths, persons", by_persons)
    few = [c for c in CHOICES if c[0] < 5]
    values, _, by_trials = spread_of(few, 3)
    print("five people", values, "half widths, trials", by_trials)
    print("QUEST+", *quest_plus())
