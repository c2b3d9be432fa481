#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Same/different studies from outside: lists are balanced, and what `study report --json` says of a pair is what scipy finds in trials.csv.

    same_different_test.py --detent-play BIN --samples DIR

1. Every participant's list holds the four kinds of a pair (AA, BB, AB, BA) equally often.
2. d' by both models, its likelihood interval, hits, false alarms and the exact p are computed again by scipy's own root finder, minimiser and
   hypergeometric distribution (models: Macmillan & Creelman 2005, chapter 9; psyphy::dprime.SD in R has the same formulas).
3. Observers with a known d' by differencing (--simulate d-prime=D) are found again: D lies in the interval, and the estimate within 0.25 of it.
4. Guessers: p is not small; people who never err: d' has no upper end."""

import argparse
import collections
import csv
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy
from scipy import optimize, stats

TOLERANCE = 1e-6


def differencing_shares(d_prime, criterion):
    difference = stats.norm(0, 2 ** 0.5)
    return difference.sf(criterion - d_prime) + difference.cdf(-criterion - d_prime), 2 * difference.sf(criterion)


def negative_likelihood(d_prime, criterion, different, hits, same, alarms):
    hit_share, alarm_share = differencing_shares(d_prime, criterion)
    return -stats.binom.logpmf(hits, different, hit_share) - stats.binom.logpmf(alarms, same, alarm_share)


def profile(d_prime, counts):
    """Least negative likelihood over the criterion: the best of a grid, then refined."""
    grid = numpy.linspace(0.001, 12, 120)
    best = grid[numpy.argmin([negative_likelihood(d_prime, k, *counts) for k in grid])]
    return optimize.minimize_scalar(lambda k: negative_likelihood(d_prime, k, *counts), bounds=(max(1e-6, best - 0.2), best + 0.2), method="bounded",
                                    options={"xatol": 1e-10}).fun


def expected(counts):
    different, hits, same, alarms = counts
    hit = min(max(hits / different, 0.5 / different), 1 - 0.5 / different)
    alarm = min(max(alarms / same, 0.5 / same), 1 - 0.5 / same)
    if hit <= alarm:
        return 0, 0, None, None
    criterion = stats.norm.isf(alarm / 2) * 2 ** 0.5
    differencing = optimize.brentq(lambda d: differencing_shares(d, criterion)[0] - hit, 0, 30)
    most_right = stats.norm.cdf((stats.norm.ppf(hit) - stats.norm.ppf(alarm)) / 2)
    # Both stimuli identified rightly, or both wrongly.
    independent = optimize.brentq(lambda d: stats.norm.cdf(d / 2) ** 2 + stats.norm.cdf(-d / 2) ** 2 - most_right, 0, 30)
    least = negative_likelihood(differencing, criterion, *counts) if 0 < hits < different and 0 < alarms < same else None
    if least is None:
        return differencing, independent, None, None
    limit = least + stats.chi2.ppf(0.95, 1) / 2
    low = 0 if profile(0, counts) <= limit else optimize.brentq(lambda d: profile(d, counts) - limit, 0, differencing)
    return differencing, independent, low, optimize.brentq(lambda d: profile(d, counts) - limit, differencing, 12)


def exact_p(persons):
    """So many hits or more, each person's number of "different" kept."""
    total = numpy.array([1.0])
    for different, hits, same, alarms in persons:
        total = numpy.convolve(total, stats.hypergeom(different + same, different, hits + alarms).pmf(numpy.arange(different + 1)))
    return total[sum(p[1] for p in persons):].sum()


class Laboratory:
    def __init__(self, program, samples, folder):
        self.program, self.samples, self.folder, self.wrong = program, samples, folder, []

    def run(self, *arguments):
        return subprocess.run([self.program, "study", *map(str, arguments)], check=True, capture_output=True, text=True).stdout

    def study(self, name, buttons, people, trials):
        """A study whose people answer as told; its tables and rows."""
        study = self.folder / name
        self.run("new", study, *(self.samples / f"{b}.button.json" for b in buttons), "--kind", "same-different", "--trials", trials, "--seed", 5)
        for number, answers in enumerate(people):
            self.run("run", study, "--participant", f"P{number:02d}", "--simulate", answers)
        out = self.folder / f"{name}.csv"
        report = json.loads(self.run("report", study, "--json", "--csv", out, "--bids", self.folder / f"{name}-bids"))
        with open(out, encoding="utf-8") as text:
            return report["tables"][0]["rows"], list(csv.DictReader(text))

    def say(self, right, words):
        if not right:
            self.wrong.append(words)

    def balanced(self, rows, trials):
        kinds = collections.Counter((r["participant"], r["pair"], r["a"], r["b"]) for r in rows)
        self.say(set(kinds.values()) == {trials // 4}, f"unbalanced: {sorted(set(kinds.values()))}")
        self.say(all((r["a"] == r["b"]) == (r["x"] == "same") and (r["answer"] == r["x"]) == (r["correct"] == "1") for r in rows), "x or correct is wrong")

    def compared(self, table, rows):
        persons = collections.defaultdict(lambda: collections.defaultdict(lambda: [0, 0, 0, 0]))
        for r in rows:
            count = persons[r["pair"]][r["participant"]]
            at = 2 if r["a"] == r["b"] else 0
            count[at] += 1
            count[at + 1] += r["answer"] == "different"
        for row in table:
            each = list(persons[f"{row['first']}-{row['second']}"].values())
            counts = [sum(p[i] for p in each) for i in range(4)]
            differencing, independent, low, high = expected(counts)
            told = {"hits_percent": 100 * counts[1] / counts[0], "false_alarms_percent": 100 * counts[3] / counts[2], "d_prime_differencing": differencing,
                    "d_prime_independent": independent, "p": exact_p(each)}
            if low is not None:
                told.update(d_prime_low=low, d_prime_high=high)
            for key, value in told.items():
                tolerance = 1e-4 if key in ("d_prime_low", "d_prime_high") else TOLERANCE
                self.say(abs(row[key] - value) <= tolerance * max(1, abs(value)), f"{row['first']}-{row['second']} {key}: {row[key]}, scipy {value}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--detent-play", required=True)
    parser.add_argument("--samples", required=True, type=pathlib.Path)
    options = parser.parse_args()
    memory = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None  # a disk's sync takes most of the time
    with tempfile.TemporaryDirectory(dir=memory) as name:
        lab = Laboratory(str(pathlib.Path(options.detent_play).resolve()), options.samples.resolve(), pathlib.Path(name))
        table, rows = lab.study("mixed", "ABE", ["d-prime=1.5", "d-prime=2", "errors=0.3", "guess"], 20)
        lab.balanced(rows, 20)
        lab.say(len(rows) == 4 * 3 * 20 and len(table) == 3, f"{len(rows)} rows, {len(table)} pairs")
        lab.compared(table, rows)
        for true in (1, 2, 3.5):
            [row], rows = lab.study(f"known{true}", "AB", [f"d-prime={true}"] * 4, 600)
            lab.compared([row], rows)
            lab.say(row["d_prime_low"] <= true <= row["d_prime_high"] and abs(row["d_prime_differencing"] - true) < 0.25, f"d' {true}: {row}")
            print(f"d' {true}: {row['d_prime_differencing']:.3f} ({row['d_prime_low']:.3f} to {row['d_prime_high']:.3f})")
        [row], rows = lab.study("guessing", "AB", ["guess"] * 4, 40)
        lab.compared([row], rows)
        lab.say(row["p"] > 0.01 and row["d_prime_low"] == 0, f"guessers: {row}")
        [row], rows = lab.study("perfect", "AB", ["perfect"], 20)
        lab.compared([row], rows)
        lab.say(row["d_prime_high"] is None and row["moved"] == "*" and row["d_prime_low"] > 1, f"perfect: {row}")
        events = next((pathlib.Path(name) / "mixed-bids").glob("sub-*/beh/*_events.tsv")).read_text().splitlines()
        lab.say(all(line.split("\t")[2] == "same-different" and line.split("\t")[7] in ("same", "different") for line in events[1:]), "BIDS: " + events[1])
    print("\n".join(lab.wrong) or "all agree")
    return 1 if lab.wrong else 0


if __name__ == "__main__":
    sys.exit(main())
