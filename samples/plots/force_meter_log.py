#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the log a force meter would give of a button: force_meter_log.py GRAPH.csv LOG.csv

GRAPH.csv holds the true curves (stroke,displacement_mm,force_N). The log has one row per 1/50 s at 0.25 mm/s, first pressing,
then releasing. What an instrument adds, all by formula and with a fixed seed, so that every run writes the same file:
Gaussian noise of 0.002 mm and 0.4 gf (standard deviations), and rounding to 0.001 mm and 0.1 gf.
"""

import csv
import random
import sys

NOISE_MM = 0.002
NOISE_GF = 0.4
SPEED_MM_PER_S = 0.25
PERIOD_S = 0.02
NEWTONS_PER_GF = 0.00980665


def strokes(path):
    points = {"press": [], "release": []}
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            points[row["stroke"]].append((float(row["displacement_mm"]), float(row["force_N"])))
    return points


def force_at(points, displacement_mm):
    """Linear interpolation along increasing displacement; at a wall the force before it."""
    for (x0, f0), (x1, f1) in zip(points, points[1:]):
        if displacement_mm <= x1:
            return f0 if x1 == x0 else f0 + (f1 - f0) * max(0.0, displacement_mm - x0) / (x1 - x0)
    return points[-1][1]


def main():
    graph, log = sys.argv[1:3]
    curves = strokes(graph)
    noise = random.Random(2013)
    number = 0
    with open(log, "w", newline="\r\n") as file:
        file.write("Force gauge,simulated\nSpecimen,sample button C\nSpeed (mm/s),0.25\n\n")
        file.write("No.,Time (s),Travel (mm),Force (gf)\n")
        for stroke in ("press", "release"):
            points = sorted(curves[stroke])
            start, end = points[0][0], points[-1][0]
            steps = int((end - start) / (SPEED_MM_PER_S * PERIOD_S))
            for step in range(steps + 1):
                moved = step * SPEED_MM_PER_S * PERIOD_S
                displacement_mm = start + moved if stroke == "press" else end - moved
                force_gf = force_at(points, displacement_mm) / NEWTONS_PER_GF
                number += 1
                file.write(f"{number},{number * PERIOD_S:.2f},{displacement_mm + noise.gauss(0, NOISE_MM):.3f},"
                           f"{force_gf + noise.gauss(0, NOISE_GF):.1f}\n")


if __name__ == "__main__":
    main()
