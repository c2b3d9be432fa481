#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How far the forecast can be believed, computed apart from it: confusion_fit.py [DETENT_PLAY]

Kim & Lee's noisy group (Table 2) against `confusion --feel paper`: rank correlation with its p over the six buttons, the same with buttons
left out, and four ways from d' to errors, each judged on pairs of two buttons that were left out of its fit. Figures and reasons:
docs/reference/predicted-confusion.md. ConfusionSettings holds the sensitivity, its spread and the lapses; fitted to the d' that is
printed, the factor is 1. Debian's numpy and scipy."""
import itertools
import json
import subprocess
import sys
from pathlib import Path

import numpy as np
from scipy.special import gammaln, ndtr, xlogy
from scipy.stats import rankdata

ROOT = Path(__file__).resolve().parents[2]
FOUND = np.array([3, 2, 5, 1, 3, 10, 0, 4, 5, 5, 1, 4, 1, 0, 2])  # errors in 90: A-B, A-C, B-C, A-D, ...
TRIALS, BAR = 90, 9
PAIRS = [(first, second) for second in range(1, 6) for first in range(second)]
NODES, WEIGHTS = np.polynomial.hermite_e.hermegauss(31)
WEIGHTS = WEIGHTS / WEIGHTS.sum()
SHIFTS = np.linspace(-2.2, 2.2, 89)
SPREADS = np.array([.05, .1, .15, .2, .25, .3, .35, .4, .45, .5, .55, .6, .7, .8, 1., 1.2])
LAPSES = np.concatenate([np.arange(0, .065, .005), [.07, .08, .1]])


def printed(play):
    files = [ROOT / f"samples/buttons/{name}.button.json" for name in "ABCDEF"]
    told = subprocess.run([play, "confusion", *files, "--feel", "paper", "--json"], capture_output=True, check=True)
    return json.loads(told.stdout)["pairs"]


def spearman(x, y):
    x, y = rankdata(x), rankdata(y)
    return float("nan") if np.ptp(x) == 0 or np.ptp(y) == 0 else np.corrcoef(x, y)[0, 1]


def over_buttons(likeness):
    """Spearman's coefficient and its one-sided p over all orders of the six buttons: pairs that share a button are not independent."""
    matrix = np.zeros((6, 6))
    for (first, second), value in zip(PAIRS, likeness):
        matrix[first, second] = matrix[second, first] = value
    observed = spearman(likeness, FOUND)
    orders = [[matrix[order[i], order[k]] for i, k in PAIRS] for order in itertools.permutations(range(6))]
    return observed, np.mean([spearman(order, FOUND) >= observed - 1e-12 for order in orders])


def without(likeness, left_out):
    kept = [i for i, pair in enumerate(PAIRS) if not set(pair) & set(left_out)]
    return spearman(np.asarray(likeness)[kept], FOUND[kept])


def wrong(d_prime):
    first, second = d_prime / np.sqrt(2), d_prime / np.sqrt(6)
    return 1 - ndtr(first) * ndtr(second) - ndtr(-first) * ndtr(-second)


def likelihoods(d_prime, power, lapses):
    """[pair][shift, spread, lapses]: log likelihood of the errors found, each pair with a log-normal sensitivity of its own."""
    shift, spread, lapse = np.meshgrid(SHIFTS, SPREADS, lapses, indexing="ij")
    tables = []
    for d, errors in zip(d_prime, FOUND):
        share = lapse[..., None] / 2 + (1 - lapse[..., None]) * wrong(np.exp(shift[..., None] + power * np.log(d) + spread[..., None] * NODES))
        share = np.clip(share, 1e-12, 1)
        log = gammaln(TRIALS + 1) - gammaln(errors + 1) - gammaln(TRIALS + 1 - errors) + xlogy(errors, share) + xlogy(TRIALS - errors, 1 - share)
        tables.append(np.log((WEIGHTS * np.exp(log)).sum(-1)))
    return np.array(tables), shift, spread, lapse


def log_d_prime_at_bar(lapse):
    grid = np.linspace(.02, 15, 3000)
    return np.log(grid[np.argmax(lapse / 2 + (1 - lapse) * wrong(grid) <= BAR / TRIALS)])


def judged(name, d_prime, power, lapses, surely=.9):
    tables, shift, spread, lapse = likelihoods(d_prime, power, lapses)
    best = np.unravel_index(tables.sum(0).argmax(), shift.shape)
    bars = np.vectorize(log_d_prime_at_bar)(lapses)[None, None, :]
    scores, verdicts = [], []
    for out in itertools.combinations(range(6), 2):
        left_out = [bool(set(pair) & set(out)) for pair in PAIRS]
        belief = tables[np.logical_not(left_out)].sum(0)
        belief = np.exp(belief - belief.max())
        belief /= belief.sum()
        for i in np.flatnonzero(left_out):
            scores.append(np.log((belief * np.exp(tables[i])).sum()))
            verdicts.append((i, (belief * ndtr((shift + power * np.log(d_prime[i]) - bars) / spread)).sum()))
    given = [(FOUND[i] <= BAR) == (apart >= surely) for i, apart in verdicts if not 1 - surely < apart < surely]
    print(f"{name:34} factor {np.exp(shift[best]):.2f} spread {spread[best]:.2f} lapses {lapse[best]:.3f} | left out: log score {np.mean(scores):.2f}, "
          f"verdicts {100 * len(given) / len(verdicts):.0f} %, right {100 * np.mean(given):.0f} %")


def main():
    play = sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/bin/detent-play"
    pairs = printed(play)
    d_prime = np.array([pair["d_prime"] for pair in pairs])
    jumps = np.array([name != "A" for name in "ABCDEF"])  # of the press
    rules = {"forecast": -d_prime, "both click or both do not": [float(jumps[first] == jumps[second]) for first, second in PAIRS]}
    for name, likeness in rules.items():
        coefficient, p = over_buttons(likeness)
        print(f"{name:34} Spearman {coefficient:.2f}, p over buttons {p:.3f}; without " +
              ", ".join(f"{'ABCDEF'[button]} {without(likeness, [button]):.2f}" for button in range(6)))
    two = [without(-d_prime, out) for out in itertools.combinations(range(6), 2)]
    print(f"two buttons left out in turn: median {np.median(two):.2f}, {min(two):.2f} to {max(two):.2f}")
    covered = sum(pair["errors_low"] <= found <= pair["errors_high"] for pair, found in zip(pairs, FOUND))
    given = [(found <= BAR) == (pair["verdict"] == "told apart") for pair, found in zip(pairs, FOUND) if pair["verdict"] != "undecided"]
    print(f"as printed: range covers {covered} of 15; verdicts {len(given)} of 15, right {sum(given)}")
    for name, power, lapses in (("d' times a factor", 1, LAPSES[:1]), ("the same, with lapses", 1, LAPSES), ("root of d', with lapses", .5, LAPSES),
                                ("the same for every pair", 0, LAPSES[:1])):
        judged(name, d_prime, power, lapses)


if __name__ == "__main__":
    main()
