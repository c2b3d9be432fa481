#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""False alarms of the tests that a study's report prints, counted without Detent's code: null_studies.py [--studies N]

Each line is a kind of study in which nothing is there to be found, drawn by numpy and tested by what scipy has of the test that is named;
sign flips and permutations are written out. Figures: docs/measurements/coverage.md. Debian's numpy and scipy."""
import argparse
import itertools

import numpy as np
from scipy.stats import binom, rankdata

LEVEL = .05


def signs(people):
    return np.array(list(itertools.product((1, -1), repeat=people)), dtype=float)


def sign_flips(differences, patterns):
    """Two-sided p of each row: the share of sign patterns with a sum as far from 0."""
    sums = np.abs(differences @ patterns.T)
    return (sums >= np.abs(differences.sum(1))[:, None] - 1e-9).mean(1)


def holm(p):
    """Adjusted p of each row."""
    order = np.argsort(p, axis=1)
    steps = np.take_along_axis(p, order, 1) * np.arange(p.shape[1], 0, -1)
    adjusted = np.empty_like(p)
    np.put_along_axis(adjusted, order, np.minimum(np.maximum.accumulate(steps, 1), 1), 1)
    return adjusted


def group_permutation(first, second, draws, chance):
    """Two-sided p that two groups' means differ, members drawn anew; what was observed is one of the draws."""
    everyone = np.concatenate([first, second])
    observed = abs(first.mean() - second.mean()) - 1e-12
    drawn = chance.permuted(np.tile(everyone, (draws, 1)), axis=1)
    far = np.abs(drawn[:, :len(first)].mean(1) - drawn[:, len(first):].mean(1)) >= observed
    return (far.sum() + 1) / (draws + 1)


def wilson(errors, trials):
    z, share = 1.959964, errors / trials
    middle = (share + z * z / (2 * trials)) / (1 + z * z / trials)
    return middle, z / (1 + z * z / trials) * np.sqrt(share * (1 - share) / trials + z * z / (4 * trials ** 2))


def told(name, alarms):
    alarms = np.asarray(alarms)
    middle, half = wilson(alarms.sum(), alarms.size)
    print(f"| {name} | {alarms.size} | {100 * alarms.mean():.2f} ({100 * (middle - half):.2f}–{100 * (middle + half):.2f}) |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--studies", type=int, default=10000)
    studies = parser.parse_args().studies
    chance = np.random.default_rng(20131008)

    # abx: the rule "at most one error in ten", and exact p after Holm over a participant's 15 pairs
    errors = chance.binomial(10, .5, (studies, 15))
    p = binom.cdf(errors, 10, .5)
    told("one guessed pair of 10 trials passes the rule", errors[:, 0] <= 1)
    told("any of 15 guessed pairs after Holm", (holm(p) <= LEVEL).any(1))

    # conditions: the same people in both
    for people, trials, rate in ((6, 60, .5), (9, 60, .5), (9, 150, .1), (12, 60, .5)):
        share = chance.beta(20 * rate, 20 * (1 - rate), (studies, people, 1))  # people differ, conditions do not
        counts = chance.binomial(trials, np.broadcast_to(share, (studies, people, 2)))
        p = sign_flips((counts[:, :, 0] - counts[:, :, 1]) / trials, signs(people))
        told(f"same people in both, {people} people, {trials} trials, {100 * rate:.0f} % errors", p <= LEVEL)

    # conditions: other people in each
    alarms = []
    for _ in range(studies):
        share = chance.beta(2, 18, 18)
        rates = chance.binomial(150, share) / 150
        alarms.append(group_permutation(rates[:9], rates[9:], 999, chance) <= LEVEL)
    told("other people in each, 9 and 9, 10 % errors", alarms)

    # ratings of 1 to 7 of three buttons that are alike, sign flips of whole persons, Holm over the three pairs
    for people in (6, 9):
        taste = chance.normal(4, 1, (studies, people, 1, 1))
        ratings = np.clip(np.round(taste + chance.normal(0, 1, (studies, people, 3, 4))), 1, 7).mean(3)
        p = np.stack([sign_flips(ratings[:, :, i] - ratings[:, :, k], signs(people)) for i, k in ((0, 1), (0, 2), (1, 2))], 1)
        told(f"one of three pairs rated alike, {people} people", p[:, 0] <= LEVEL)
        told(f"any of three pairs rated alike, after Holm, {people} people", (holm(p) <= LEVEL).any(1))

    # preferences: choices between two that are alike, tastes differ or not
    for spread in (0, 1):
        odds = chance.normal(0, spread, (studies, 9))
        shares = chance.binomial(4, 1 / (1 + np.exp(-odds))) / 4 - .5
        told(f"two buttons preferred by 9 people, 4 choices each, tastes differ by {spread}", sign_flips(shares, signs(9)) <= LEVEL)

    # foretold and found: ranks of 15 pairs, pairs permuted
    alarms = []
    ranks = np.arange(1, 16)
    for _ in range(studies):
        found = rankdata(chance.binomial(90, .05, 15))
        observed = np.corrcoef(ranks, found)[0, 1] if np.ptp(found) else 0
        drawn = chance.permuted(np.tile(found, (999, 1)), axis=1)
        far = (drawn @ (ranks - ranks.mean())) >= found @ (ranks - ranks.mean()) - 1e-9
        alarms.append(observed != 0 and (far.sum() + 1) / 1000 <= LEVEL)
    told("Spearman of 15 pairs, one-sided", alarms)


if __name__ == "__main__":
    main()
