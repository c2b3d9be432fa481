#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The power that `detent-play study plan` prints, against studies simulated here and tested by every sign pattern.

    power_reference.py --detent-play BIN --samples DIR [--studies N]

Written from what the table says of its assumptions, with numpy's random numbers: people whose log odds of an error vary normally (0.5, of
the difference 0.25), errors by trial, the exact two-sided sign-flip test. Fails where one figure for 6, 9 or 12 people is off by more than 3 points."""

import argparse
import itertools
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy

LEVEL, MOST_POINTS = 0.05, 3.0
PEOPLE = (6, 9, 12)
RATE = 0.10


def found_share(people, trials, difference, studies, chance):
    """How often the test finds the difference, per cent."""
    def odds(share):
        return numpy.log(share / (1 - share))

    person = odds(RATE) + 0.5 * chance.standard_normal((studies, people))
    effect = odds(RATE + difference) - odds(RATE) + 0.25 * chance.standard_normal((studies, people))
    errors = [chance.binomial(trials, 1 / (1 + numpy.exp(-o))) for o in (person, person + effect)]
    differences = errors[1] - errors[0]
    patterns = numpy.array(list(itertools.product((-1, 1), repeat=people)))
    observed = numpy.abs(differences.sum(axis=1))
    flipped = numpy.abs(differences @ patterns.T)
    return 100 * numpy.mean((flipped >= observed[:, None]).mean(axis=1) <= LEVEL + 1e-12)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--detent-play", required=True, type=pathlib.Path)
    parser.add_argument("--samples", required=True, type=pathlib.Path)
    parser.add_argument("--studies", type=int, default=20000)
    options = parser.parse_args()
    program, chance = options.detent_play.resolve(), numpy.random.default_rng(26)
    with tempfile.TemporaryDirectory() as folder:
        study = pathlib.Path(folder) / "s"
        buttons = [options.samples.resolve() / f"{letter}.button.json" for letter in "ABC"]
        subprocess.run([program, "study", "new", study, *buttons, "--modes", "full,click-only", "--trials", "20", "--seed", "1"], check=True,
                       capture_output=True)
        told = json.loads(subprocess.run([program, "study", "plan", study, "--json"], check=True, capture_output=True, text=True).stdout)
    table = next(t for t in told["power"] if t["key"] == "two_conditions")
    trials, worst = 60, 0.0
    print("| people | difference, points | told, % | by every sign pattern, % |\n|---|---|---|---|")
    for row in table["rows"]:
        people = int(row["people"])
        for points in (5, 10, 15, 20) if people in PEOPLE else ():
            told_share = row[f"more_{points}"]
            share = found_share(people, trials, points / 100, max(2000, options.studies * 9 // 2**people), chance)
            worst = max(worst, abs(told_share - share))
            print(f"| {people} | {points} | {told_share:.1f} | {share:.1f} |")
    print(f"\nLargest difference: {worst:.1f} points.")
    return 1 if worst > MOST_POINTS else 0


if __name__ == "__main__":
    sys.exit(main())
