#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Recomputes the figures of `study report --json` by scipy from the rows of `--csv`.

    study_statistics_test.py --detent-play BIN --samples DIR

Simulated ABX (two modes), matching, rating and threshold studies of seven people. Exact figures agree within TOLERANCE: counts, Wilson's
and Clopper-Pearson's intervals, tests against guessing and by sign flips, Holm, d' by both models, Student's intervals. Resampled
intervals agree with all 7 ** 7 resamples within what the product's finite number of resamples leaves open.
"""

import argparse
import collections
import csv
import itertools
import json
import pathlib
import subprocess
import tempfile
import unittest

import numpy
from scipy import optimize, stats

TOLERANCE = 1e-9
RESAMPLED = 0.02  # of a rate; the rates of seven people's resamples lie about 0.005 apart

ARGUMENTS = None
PEOPLE = [f"P0{i}" for i in range(1, 8)]


def holm(p):
    order = sorted(range(len(p)), key=lambda i: p[i])
    adjusted, largest = [0.0] * len(p), 0.0
    for rank, i in enumerate(order):
        largest = max(largest, min(1.0, (len(p) - rank) * p[i]))
        adjusted[i] = largest
    return adjusted


def abx_share(d_prime, second):
    first, second = d_prime / 2 ** 0.5, d_prime / second
    return stats.norm.cdf(first) * stats.norm.cdf(second) + stats.norm.cdf(-first) * stats.norm.cdf(-second)


def d_prime(share, second):
    return 0 if share <= 0.5 else optimize.brentq(lambda d: abx_share(d, second) - share, 0, 40, xtol=1e-13)


DIFFERENCING, INDEPENDENT = 6 ** 0.5, 2


def sign_flips(differences):
    """Mean, two-sided p over all sign patterns, and the interval of the means this test does not refuse."""
    differences = numpy.array(differences)
    n = len(differences)
    signs = numpy.array(list(itertools.product((1, -1), repeat=n)))
    flipped = abs((signs * differences).sum(axis=1))
    p = (flipped >= abs(differences.sum()) - 1e-12).mean()
    outside = int(0.025 * 2 ** n)
    means = sorted(differences[list(chosen)].mean() for size in range(1, n + 1) for chosen in itertools.combinations(range(n), size))
    return differences.mean(), p, (means[outside - 1], means[len(means) - outside])


def stretched_bca(errors, trials):
    """BCa (Efron 1987) over all resamples, its normal quantile replaced by Student's times sqrt(n / (n - 1)) (Hesterberg 2015)."""
    errors, trials = numpy.array(errors), numpy.array(trials)
    n = len(errors)
    drawn = numpy.array(list(itertools.product(range(n), repeat=n)))
    rates = numpy.sort(errors[drawn].sum(axis=1) / trials[drawn].sum(axis=1))
    observed = errors.sum() / trials.sum()
    bias = stats.norm.ppf(((rates < observed - 1e-12).mean() + (rates <= observed + 1e-12).mean()) / 2)
    left_out = numpy.array([numpy.delete(errors, i).sum() / numpy.delete(trials, i).sum() for i in range(n)])
    off = left_out.mean() - left_out
    acceleration = (off ** 3).sum() / (6 * (off ** 2).sum() ** 1.5)
    ends = []
    for share in (0.025, 0.975):
        z = bias + (n / (n - 1)) ** 0.5 * stats.t.ppf(share, n - 1)
        ends.append(numpy.quantile(rates, stats.norm.cdf(bias + z / (1 - acceleration * z))))
    return ends


def student(values, log=False):
    values = numpy.log(values) if log else numpy.array(values)
    half = stats.t.ppf(0.975, len(values) - 1) * values.std(ddof=1) / len(values) ** 0.5
    ends = [values.mean(), values.mean() - half, values.mean() + half]
    return numpy.exp(ends) if log else ends


class StudyStatistics(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)

    def study(self, simulate, buttons, *options):
        """Report and rows of a study that seven simulated people did."""
        folder, table = pathlib.Path(self.temporary.name, "study"), pathlib.Path(self.temporary.name, "rows.csv")
        run = lambda *a: subprocess.run([ARGUMENTS.detent_play, "study", *map(str, a)], check=True, capture_output=True, text=True).stdout
        run("new", folder, *[ARGUMENTS.samples / f"{b}.button.json" for b in buttons], "--seed", 5, *options)
        for person in PEOPLE:
            run("run", folder, "--participant", person, "--simulate", simulate)
        report = json.loads(run("report", folder, "--csv", table, "--json"))
        with open(table, newline="", encoding="utf-8") as file:
            return report, list(csv.DictReader(file))

    def near(self, told, right, tolerance=TOLERANCE, what=""):
        numpy.testing.assert_allclose(told, right, rtol=tolerance, atol=tolerance, err_msg=what)

    def intervals(self, told, errors, trials):
        for name, method in (("wilson", "wilson"), ("clopper_pearson", "exact")):
            self.near(told[name], list(stats.binomtest(errors, trials).proportion_ci(0.95, method)), what=name)

    def test_abx(self):
        report, rows = self.study("errors=0.25", "ABC", "--trials", 10, "--modes", "full,click-only")
        wrong = collections.Counter()
        of = collections.Counter()
        for row in rows:
            for key in ((row["condition"],), (row["condition"], row["pair"]), (row["condition"], row["pair"], row["participant"]),
                        (row["condition"], row["participant"])):
                wrong[key] += row["correct"] == "0"
                of[key] += 1
        p_of, told_holm = {}, {}
        self.assertEqual(len(report["groups"]), 2)
        for group in report["groups"]:
            condition = group["condition"]
            self.assertEqual((group["errors"], group["trials"]), (wrong[condition,], of[condition,]))
            self.intervals(group, group["errors"], group["trials"])
            counts = [(wrong[condition, person], of[condition, person]) for person in PEOPLE]
            self.near(group["bootstrap"], stretched_bca(*zip(*counts)), RESAMPLED)
            for pair in group["pairs"]:
                name = f"{pair['a']}-{pair['b']}"
                errors, trials = wrong[condition, name], of[condition, name]
                self.assertEqual((pair["errors"], pair["trials"]), (errors, trials))
                self.intervals(pair, errors, trials)
                self.assertGreater(errors, 0)
                self.near(pair["d_prime_differencing"], d_prime(1 - errors / trials, DIFFERENCING))
                self.near(pair["d_prime_independent"], d_prime(1 - errors / trials, INDEPENDENT))
                most = stats.binomtest(errors, trials).proportion_ci(0.95, "exact").high
                self.near(pair["d_prime_low"], d_prime(1 - most, DIFFERENCING))
                for test in pair["tests"]:
                    key = (condition, name, test["participant"])
                    self.assertEqual((test["errors"], test["trials"]), (wrong[key], of[key]))
                    p_of[key] = stats.binom.cdf(wrong[key], of[key], 0.5)
                    told_holm[key] = test["p_holm"]
                    self.near(test["p"], p_of[key])
                    self.assertEqual(test["discriminates"], wrong[key] <= of[key] // 10)
        for person in PEOPLE:  # over a person's pairs and modes
            keys = [key for key in p_of if key[2] == person]
            self.assertEqual(len(keys), 6)
            self.near([told_holm[key] for key in keys], holm([p_of[key] for key in keys]))
        self.near(report["rule"]["p"], stats.binom.cdf(1, 10, 0.5))
        self.assertEqual(len(report["comparisons"]), 4)
        by_pair = [c for c in report["comparisons"] if c["pair"]]
        for comparison in report["comparisons"]:
            within = (comparison["pair"],) if comparison["pair"] else ()
            rate = lambda condition, person: wrong[(condition, *within, person)] / of[(condition, *within, person)]
            mean, p, interval = sign_flips([rate(comparison["first"], x) - rate(comparison["second"], x) for x in PEOPLE])
            self.near([comparison["difference"], comparison["p"], *comparison["interval"]], [mean, p, *interval])
        self.near([c["p_holm"] for c in by_pair], holm([c["p"] for c in by_pair]))

    def test_matching(self):
        report, rows = self.study("errors=0.3", "ABC", "--kind", "matching", "--trials", 8)
        matches, pairs = ({tuple(row[k] for k in key): row for row in t["rows"]} for t, key in
                          zip(report["tables"], (("button",), ("first", "second"))))
        taken = collections.Counter((row["participant"], row["x"], row["answer"]) for row in rows)
        count = lambda x, answer: sum(taken[person, x, answer] for person in PEOPLE)
        told, right = [], []
        for (button,), row in matches.items():
            asked = sum(count(button, answer) for answer in "ABC")
            self.assertEqual((row["right"], row["trials"]), (count(button, button), asked))
            self.near([row["low_percent"], row["high_percent"]],
                      [100 * e for e in stats.binomtest(int(row["right"]), asked).proportion_ci(0.95, "wilson")])
            self.near(row["p"], stats.binom.sf(row["right"] - 1, asked, 1 / 3))
            told.append(row["p_holm"])
            right.append(row["p"])
        self.near(told, holm(right))
        told, right = [], []
        self.assertEqual(set(pairs), {("A", "B"), ("A", "C"), ("B", "C")})
        for (a, b), row in pairs.items():
            confused = count(a, b) + count(b, a)
            trials = confused + count(a, a) + count(b, b)
            self.assertEqual((row["confused"], row["trials"]), (confused, trials))
            self.near([row["low_percent"], row["high_percent"]],
                      [100 * e for e in stats.binomtest(confused, trials).proportion_ci(0.95, "wilson")])
            self.near(row["p"], stats.binom.cdf(confused, trials, 0.5))
            per = [(taken[x, a, b] + taken[x, b, a], sum(taken[x, i, j] for i in (a, b) for j in (a, b))) for x in PEOPLE]
            self.near([row["resampled_low_percent"] / 100, row["resampled_high_percent"] / 100], stretched_bca(*zip(*per)), RESAMPLED)
            told.append(row["p_holm"])
            right.append(row["p"])
        self.near(told, holm(right))

    def test_rating(self):
        report, rows = self.study("errors=0.3", "AB", "--kind", "rating", "--trials", 4)
        given = {(x, b): [float(r["rating"]) for r in rows if (r["participant"], r["pair"]) == (x, b)] for x in PEOPLE for b in "AB"}
        ratings, differences, order = (t["rows"] for t in report["tables"])
        for row in ratings:
            mean, low, high = student([numpy.mean(given[x, row["button"]]) for x in PEOPLE])
            self.near([row["value"], row["low"], row["high"]], [mean, max(low, 1), min(high, 7)])
        mean, p, interval = sign_flips([numpy.mean(given[x, "A"]) - numpy.mean(given[x, "B"]) for x in PEOPLE])
        self.near([differences[0][k] for k in ("difference", "p", "low", "high")], [mean, p, *interval])
        higher = [numpy.mean([(a > b) + (a == b) / 2 for a in given[x, "A"] for b in given[x, "B"]]) for x in PEOPLE]
        mean, p, interval = sign_flips([h - 0.5 for h in higher])
        self.near([order[0][k] for k in ("higher_percent", "p", "low_percent", "high_percent")],
                  [50 + 100 * mean, p, *(50 + 100 * e for e in interval)])

    def test_threshold(self):
        report, _ = self.study("errors=0.3", "B", "--kind", "threshold", "--trials", 40)
        persons, over = (t["rows"] for t in report["tables"])
        self.near([over[0][k] for k in ("threshold_percent", "low_percent", "high_percent")],
                  student([row["threshold_percent"] for row in persons], log=True))


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--detent-play", required=True)
    parser.add_argument("--samples", type=pathlib.Path, required=True)
    ARGUMENTS, rest = parser.parse_known_args()
    unittest.main(argv=[__file__, *rest])
