#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Imports every plot of samples/plots without a hint and holds the result against the button that gnuplot drew.

    sample_plots_test.py --bin FOLDER [--root FOLDER]

Compared: axis ranges and units with MANIFEST.md's table (plots.tsv), the force on both strokes up to 0.15 mm before the wall (the
wall itself may lie on the frame line), and every tactile point of the press. The bounds are an order of magnitude
above what the importer reaches, and an order below what a wrong stroke, axis or unit costs.
"""

import argparse
import csv
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

MEAN_OF_SPAN = 0.004       # mean difference of force, as a share of the force axis (of the stroke's range for a log)
TACTILE_MM = 0.03
TACTILE_N = 0.01           # 1 gf
AXIS_OF_SPAN = 0.005
BEFORE_WALL_MM = 0.15


def strokes(path):
    """Both strokes by increasing displacement; at a wall the side of smaller displacements first."""
    points = {"press": [], "release": []}
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            points[row["stroke"]].append((float(row["displacement_mm"]), float(row["force_N"])))
    points["release"].reverse()
    return points


def force_at(points, displacement_mm):
    for (x0, f0), (x1, f1) in zip(points, points[1:]):
        if x0 <= displacement_mm <= x1 and x1 > x0:
            return f0 + (f1 - f0) * (displacement_mm - x0) / (x1 - x0)
    return points[0][1] if displacement_mm < points[0][0] else points[-1][1]


NEWTONS = {"N": 1, "cN": 0.01, "gf": 0.00980665, "ozf": 0.2780138509537812}


def stroke_faults(name, truth, found, span_N):
    if not found:
        yield f"{name} is missing"
        return
    start, end = truth[0][0] + 0.02, truth[-1][0] - BEFORE_WALL_MM
    places = [start + (end - start) * i / 400 for i in range(401)]
    drawn = [force_at(truth, x) for x in places]
    mean = sum(abs(force_at(found, x) - force) for x, force in zip(places, drawn)) / len(places)
    share = mean / (span_N or max(drawn) - min(drawn))
    if share > MEAN_OF_SPAN:
        yield f"{name} lies {100 * share:.2f} % of the span off on average (allowed {100 * MEAN_OF_SPAN} %)"


def axis_faults(name, stated, found):
    low, high, unit = re.fullmatch(r"(\S+) to (\S+) (\S+)", stated).groups()
    low, high = float(low), float(high)
    off = max(abs(found["min"] - low), abs(found["max"] - high)) / (high - low)
    if found["unit"] != unit or off > AXIS_OF_SPAN:
        yield f"{name} reads {found['min']:g} to {found['max']:g} {found['unit']} where {stated} is printed"


def tactile_faults(stated, found):
    """`stated` as the manifest prints it: "1.25 mm 0.550 N, ..."."""
    true = [(float(x), float(force)) for x, force in re.findall(r"([\d.]+) mm ([\d.]+) N", stated)]
    if len(true) != len(found):
        yield f"{len(found)} tactile points on the press where there are {len(true)}"
        return
    for (x, force), point in zip(true, found):
        if abs(point["displacement_mm"] - x) > TACTILE_MM or abs(point["force_N"] - force) > TACTILE_N:
            yield (f"the tactile point {x:.2f} mm {force:.3f} N is read as {point['displacement_mm']:.3f} mm "
                   f"{point['force_N']:.4f} N")


def manifest_rows(root):
    """file -> cells of its row in MANIFEST.md"""
    rows = {}
    for line in (root / "samples/plots/MANIFEST.md").read_text().splitlines():
        match = re.match(r"\| \[([^\]]+)\]", line)
        if match:
            rows[match.group(1)] = [cell.strip() for cell in line.strip("|").split("|")]
    return rows


def faults_of(root, programs, folder, file, button, cells):
    found, true = folder / "found.csv", folder / "true.csv"
    run = subprocess.run([programs / "detent-import", root / "samples/plots" / file, "--csv", found, "--json"],
                         capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=120)
    if run.returncode != 0:
        yield f"exit code {run.returncode}: {run.stderr.strip()}"
        return
    report = json.loads(run.stdout)
    subprocess.run([programs / "detent-graph", "convert", root / f"samples/buttons/{button}.button.json", true], check=True,
                   capture_output=True)
    span_N = None
    if cells:
        low, high, unit = cells[3].replace(" to ", " ").split()
        span_N = (float(high) - float(low)) * NEWTONS[unit]
        yield from axis_faults("x axis", cells[2], report["x_axis"])
        yield from axis_faults("y axis", cells[3], report["y_axis"])
        yield from tactile_faults(cells[5], report["press"]["tactile_points"])
    drawn, read = strokes(true), strokes(found)
    for stroke in ("press", "release"):
        yield from stroke_faults(stroke, drawn[stroke], read[stroke], span_N)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--bin", type=Path, required=True, help="folder of the built programs")
    parser.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[2])
    arguments = parser.parse_args()
    root, programs = arguments.root.resolve(), arguments.bin.resolve()

    plots = [(file, cells[1].split(",")[0], cells) for file, cells in manifest_rows(root).items()]
    plots.append(("force-meter-log.csv", "C", None))
    on_disk = {path.name for path in (root / "samples/plots").iterdir() if path.suffix in (".png", ".pdf", ".svg", ".csv")}
    wrong = 0
    for file in sorted(on_disk ^ {file for file, _, _ in plots}):
        wrong += 1
        print(f"{file}: stands in only one of samples/plots and its MANIFEST.md")
    with tempfile.TemporaryDirectory() as folder:
        for file, button, cells in plots:
            for fault in faults_of(root, programs, Path(folder), file, button, cells):
                wrong += 1
                print(f"{file}: {fault}")
    print(f"{len(plots)} sample plots, {wrong} faults")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
