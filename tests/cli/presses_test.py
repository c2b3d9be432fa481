#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Simulated people of known timing, fitted by `detent-play study presses`: are their laboratory's two figures within the 95 % intervals?

    presses_test.py --detent-play BIN [--laboratories N] [--table]

The people are made by numpy alone: each has a place and a spread of their own about the laboratory's, drifts, lapses, and
now and then does not press at all. The default is a short run that finds a broken fit; --laboratories 400 --table prints docs/measurements/coverage.md's rows.
Then bad input: refused with exit code 3, its line, and a remedy."""

import argparse
import json
import math
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy

PLACE = {"cue": -0.04, "window": 0.185, "tapping": 0.16}  # tapping: s
PLACE_SD = {"cue": 0.02, "window": 0.08, "tapping": 0.12}  # between people; tapping: of the logarithm
SPREAD, SPREAD_SD = {"cue": 0.06, "window": 0.09, "tapping": 0.08}, 0.25  # between people: of the logarithm
TRIALS, PEOPLE = 60, 10


def person(task, habits, chance):
    """Rows of one person: interval, window, press."""
    place = PLACE[task] + chance.normal(0, PLACE_SD[task]) if task != "tapping" else PLACE[task] * math.exp(chance.normal(0, PLACE_SD[task]))
    spread = SPREAD[task] * math.exp(chance.normal(0, SPREAD_SD))
    drift = numpy.zeros(TRIALS)
    if habits["drift"] == "steady":
        drift = chance.normal(0, 1.0) * spread * (numpy.arange(TRIALS) / (TRIALS - 1) - 0.5)
    elif habits["drift"] == "wandering":
        drift = numpy.cumsum(chance.normal(0, 0.04, TRIALS)) * spread
        drift -= drift.mean()
    rows = []
    for trial in range(TRIALS):
        interval, window = chance.choice([0.5, 0.7, 0.9]), chance.choice([0.08, 0.1, 0.15, 0.2])
        noise = chance.normal(0, 1) * spread + drift[trial]
        if task == "tapping":
            press = place * math.exp(noise)
        else:
            press = place * (window if task == "window" else interval) + noise * interval
        if chance.random() < habits["lapses"]:
            press = chance.uniform(0.02, 0.6) if task == "tapping" else chance.uniform(-0.9, 0.9) * interval
        if chance.random() < habits["asleep"]:
            press = None
        rows.append((interval, window, press))
    return rows


def laboratory(task, habits, seed):
    chance = numpy.random.default_rng(seed)
    lines = ["participant,interval_s,window_s,press_s"]
    for number in range(PEOPLE):
        for interval, window, press in person(task, habits, chance):
            lines.append(f"P{number:02d},{interval},{window},{'' if press is None else f'{press:.6f}'}")
    return "\n".join(lines) + "\n"


def fit(program, task, text, folder, name):
    file = Path(folder) / name
    file.write_text(text)
    ran = subprocess.run([program, "study", "presses", str(file), "--task", task, "--json"], capture_output=True, text=True, check=True)
    file.unlink()
    return json.loads(ran.stdout)["tables"][0]["rows"][0]


def covered(program, task, habits, laboratories, folder):
    """Laboratories whose place, and whose spread, lie within; and the mean of fitted over true spread."""
    unit = 1000 if task == "tapping" else 100
    what = "place_ms" if task == "tapping" else "place_percent"

    def one(seed):
        row = fit(program, task, laboratory(task, habits, seed), folder, f"{task}{seed}.csv")
        low, high = row[what.replace("_", "_low_", 1)], row[what.replace("_", "_high_", 1)]
        return low <= unit * PLACE[task] <= high, row["spread_low_percent"] <= 100 * SPREAD[task] <= row["spread_high_percent"], \
            row["spread_percent"] / (100 * SPREAD[task])

    with ThreadPoolExecutor(2) as pool:
        found = numpy.array(list(pool.map(one, range(laboratories))), dtype=float)
    return found.mean(axis=0)


def wilson(share, n, z=1.96):
    middle, half = share + z * z / (2 * n), z * math.sqrt(share * (1 - share) / n + z * z / (4 * n * n))
    return (middle - half) / (1 + z * z / n), (middle + half) / (1 + z * z / n)


HABITS = {"none": {"drift": "none", "lapses": 0.0, "asleep": 0.0},
          "2 % lapses, 2 % no press, steady drift": {"drift": "steady", "lapses": 0.02, "asleep": 0.02},
          "5 % lapses, 5 % no press, wandering drift": {"drift": "wandering", "lapses": 0.05, "asleep": 0.05}}

GOOD = "".join(f"P1,0.5,0.1,{0.02 + 0.001 * (i * 7 % 11)}\n" for i in range(12))
HEAD = "participant,interval_s,window_s,press_s\n"
BAD = [("window", "", "line 1"), ("window", HEAD, "no rows"), ("window", "participant,press_s\nP1,0.1\n", "window_s"),
       ("window", HEAD + GOOD + "P1,0,0.1,0.1\n", "line 14"), ("window", HEAD + GOOD + "P1,0.5,-1,0.1\n", "line 14"),
       ("window", HEAD + GOOD + "P1,0.5,0.1,nan\n", "line 14"), ("window", HEAD + GOOD + "P1,0.5,0.1,1e9\n", "line 14"),
       ("window", HEAD + GOOD + "../x,0.5,0.1,0.1\n", "line 14"), ("window", HEAD + GOOD + "P1,0.5\n", "line 14"),
       ("window", HEAD + "P1,0.5,0.1,0.02\n" * 9, "enough presses"), ("window", HEAD + "P1,0.5,0.1,0.02\n" * 40, "enough presses"),
       ("window", HEAD + "P1,0.5,0.1,\n" * 40, "enough presses"), ("tapping", "participant,press_s\n" + "P1,-0.1\n" * 20, "line 2"),
       ("cue", "participant,press_s\n" + "P1,0.1\n" * 20, "interval_s")]


def check_bad_input(program, folder):
    wrong = []
    for task, text, told in BAD:
        file = Path(folder) / "bad.csv"
        file.write_text(text)
        ran = subprocess.run([program, "study", "presses", str(file), "--task", task], capture_output=True, text=True, check=False)
        if ran.returncode != 3 or told not in ran.stderr or ran.stdout or ran.stderr.count("\n") != 1:
            wrong.append(f"{task}, {text[-40:]!r}: exit {ran.returncode}, {ran.stderr.strip()!r}")
    for target in (str(folder), str(Path(folder) / "none.csv"), "/dev/zero"):
        ran = subprocess.run([program, "study", "presses", target], capture_output=True, text=True, check=False)
        if ran.returncode != 3:
            wrong.append(f"{target}: exit {ran.returncode}")
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--detent-play", required=True)
    parser.add_argument("--laboratories", type=int, default=60)
    parser.add_argument("--table", action="store_true")
    options = parser.parse_args()
    n, wrong = options.laboratories, []
    if options.table:
        print("| task | habits | N | place within 95 % | spread within 95 % | spread fitted : true |\n|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory(prefix="detent-presses-") as folder:
        for task in PLACE:
            for name, habits in HABITS.items():
                if not options.table and name.startswith("none"):
                    continue
                place, spread, ratio = covered(options.detent_play, task, habits, n, folder)
                words = [f"{100 * share:.1f} ({100 * wilson(share, n)[0]:.1f}–{100 * wilson(share, n)[1]:.1f})" for share in (place, spread)]
                if options.table:
                    print(f"| {task} | {name} | {n} | {words[0]} | {words[1]} | {ratio:.3f} |", flush=True)
                for what, share in (("place", place), ("spread", spread)):
                    if wilson(share, n)[1] < 0.90 or not 0.9 < ratio < 1.1:
                        wrong.append(f"{task}, {name}: {what} within in {share:.3f} of {n}, spread {ratio:.3f} of the true one")
        wrong += check_bad_input(options.detent_play, folder)
    print("\n".join(wrong) or "all within their bars")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
