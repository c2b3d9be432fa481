#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Recomputes the figures of `study report --json` by scipy from the rows of `--csv`.

    study_statistics_test.py --detent-play BIN --samples DIR

Simulated ABX (two modes), matching, rating (all three scales) and threshold studies of seven people. Exact figures agree within
TOLERANCE: counts, Wilson's and Clopper-Pearson's intervals, tests against guessing and by sign flips, Holm, d' by both models,
Student's intervals, Bradley-Terry's scores with their sandwich. Resampled intervals agree with all 7 ** 7 resamples within what the
product's finite number of resamples leaves open, thresholds with a posterior on a finer grid within what the product's grid does.
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
FITTED = 1e-6  # of a score that two optimisers have found
RESAMPLED = 0.02  # of a rate; the rates of seven people's resamples lie about 0.005 apart
GRIDDED = 0.01  # of a threshold

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


def bradley_terry(choices, people, things):
    """Scores with half a choice added either way per pair, and half their 95 % intervals: sandwich over persons, Student."""
    pairs = list(itertools.combinations(range(things), 2))
    weighed = [(1, winner, loser) for _, winner, loser in choices] + [(0.5, *p) for a, b in pairs for p in ((a, b), (b, a))]
    loss = lambda s: sum(n * numpy.log1p(numpy.exp(s[loser] - s[winner])) for n, winner, loser in weighed) + s.mean() ** 2
    s = optimize.minimize(loss, numpy.zeros(things), method="BFGS", options={"gtol": 1e-10}).x
    preferred = lambda a, b: 1 / (1 + numpy.exp(s[b] - s[a]))
    hessian, gradients = numpy.zeros((things, things)), numpy.zeros((people, things))
    for n, a, b in weighed:
        hessian[numpy.ix_((a, b), (a, b))] += n * preferred(a, b) * preferred(b, a) * numpy.array([[1, -1], [-1, 1]])
    for person, winner, loser in choices:
        gradients[person, [winner, loser]] += preferred(loser, winner) * numpy.array([1, -1])
    inverse = numpy.linalg.pinv(hessian)
    covariance = inverse @ gradients.T @ gradients @ inverse * people / (people - 1)
    return s, stats.t.ppf(0.975, people - 1) * numpy.sqrt(numpy.diag(covariance))


def threshold(levels, answers):
    """Median and 95 % credible interval of the prior and the psychometric function that docs/guide/studies.md names."""
    half_step = 150 ** (1 / 160)  # the prior's 81 thresholds of 1 to 150 % represent the range around them
    grid = numpy.geomspace(0.01 / half_step, 1.5 * half_step, 5001)
    belief = numpy.zeros_like(grid)
    for slope, lapse in itertools.product((1, 1.4, 2, 2.8, 4), (0, 0.02, 0.05)):
        likelihood = numpy.ones_like(grid)
        for level, right in zip(levels, answers):
            share = 0.5 + (0.5 - lapse) * (1 - 2 ** -((level / grid) ** slope))
            likelihood *= share if right else 1 - share
        belief += likelihood
    below = numpy.concatenate(([0], numpy.cumsum((belief[1:] + belief[:-1]) / 2)))
    return [numpy.exp(numpy.interp(share, below / below[-1], numpy.log(grid))) for share in (0.5, 0.025, 0.975)]


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

    def test_magnitude(self):
        report, rows = self.study("errors=0.3", "ABC", "--kind", "rating", "--scale", "magnitude", "--trials", 4)
        given = {(x, b): numpy.log([float(r["rating"]) for r in rows if (r["participant"], r["pair"]) == (x, b)]).mean()
                 for x in PEOPLE for b in "ABC"}
        of_person = {x: numpy.mean([given[x, b] for b in "ABC"]) for x in PEOPLE}
        of_all = numpy.mean(list(of_person.values()))
        ratings, differences = (t["rows"] for t in report["tables"])
        for row in ratings:
            scaled = [given[x, row["button"]] - of_person[x] + of_all for x in PEOPLE]
            self.near([row[k] for k in ("value", "low", "high")], student(numpy.exp(scaled), log=True))
        self.assertEqual(len(differences), 3)
        for row in differences:
            mean, p, interval = sign_flips([given[x, row["first"]] - given[x, row["second"]] for x in PEOPLE])
            self.near([row[k] for k in ("difference", "p", "low", "high")], [numpy.exp(mean), p, *numpy.exp(interval)])
        self.near([row["p_holm"] for row in differences], holm([row["p"] for row in differences]))

    def test_pairwise(self):
        report, rows = self.study("errors=0.3", "ABC", "--kind", "rating", "--scale", "pairwise", "--trials", 4)
        choices = [(PEOPLE.index(row["participant"]), row["answer"], row["pair"].replace(row["answer"], "").strip("-")) for row in rows]
        ratings, differences = (t["rows"] for t in report["tables"])
        scores, half = bradley_terry([(x, "ABC".index(w), "ABC".index(l)) for x, w, l in choices], len(PEOPLE), 3)
        for row, score, error in zip(ratings, scores - scores.mean(), half, strict=True):
            self.near([row[k] for k in ("value", "low", "high")], [score, score - error, score + error], FITTED)
        self.assertEqual(len(differences), 3)
        for row in differences:
            pair = {row["first"], row["second"]}
            of_pair = [[w == row["first"] for x, w, l in choices if x == person and {w, l} == pair] for person in range(len(PEOPLE))]
            mean, p, interval = sign_flips([numpy.mean(chosen) - 0.5 for chosen in of_pair])
            self.near([row[k] for k in ("difference", "p", "low", "high")], [50 + 100 * mean, p, *(50 + 100 * e for e in interval)])
        self.near([row["p_holm"] for row in differences], holm([row["p"] for row in differences]))

    def test_threshold(self):
        report, rows = self.study("errors=0.3", "B", "--kind", "threshold", "--trials", 40)
        persons, over = (t["rows"] for t in report["tables"])
        self.assertEqual([row["participant"] for row in persons], PEOPLE)
        for row in persons:
            answered = [(float(r["level"]), r["correct"] == "1") for r in rows if r["participant"] == row["participant"]]
            self.assertEqual((row["right"], row["trials"]), (sum(right for _, right in answered), len(answered)))
            self.near(numpy.array([row[k] for k in ("threshold_percent", "low_percent", "high_percent")]) / 100,
                      threshold(*zip(*answered)), GRIDDED)
        self.near([over[0][k] for k in ("threshold_percent", "low_percent", "high_percent")],
                  student([row["threshold_percent"] for row in persons], log=True))


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--detent-play", required=True)
    parser.add_argument("--samples", type=pathlib.Path, required=True)
    ARGUMENTS, rest = parser.parse_known_args()
    unittest.main(argv=[__file__, *rest])
