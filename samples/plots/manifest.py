#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints MANIFEST.md: what each plot of this folder truly shows. manifest.py CSV-FOLDER

CSV-FOLDER holds one BUTTON.csv (stroke,displacement_mm,force_N) per button of plots.tsv, the curves that were drawn. Tactile
points are read off those points here, without any code of Detent.
"""

import csv
import json
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROMINENCE_OF_SPAN = 0.03  # as in model/sections.h


def strokes(path):
    points = {"press": [], "release": []}
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            points[row["stroke"]].append((float(row["displacement_mm"]), float(row["force_N"])))
    return points


def tactile_points(points, sign, bar_N):
    """Extrema in the order travelled that the force turns back from by the bar: maxima for sign 1, minima for sign -1."""
    found, best, lowest = [], None, None
    for x, force in points:
        height = sign * force
        if best is None:
            if lowest is None or height < lowest:
                lowest = height
            if height >= lowest + bar_N:
                best = (x, force)
        elif height > sign * best[1]:
            best = (x, force)
        elif height <= sign * best[1] - bar_N:
            found.append(best)
            best, lowest = None, height
    return found


def listed(points):
    return ", ".join(f"{x:.2f} mm {force:.3f} N" for x, force in points) or "none"


def callouts(name, button):
    """The points that this plot calls out, from the button's file; a dash where it calls out none."""
    if "operating_mm" not in (HERE / "gnuplot" / f"{name}.gp").read_text():
        return "-"
    state = json.loads((HERE.parent / "buttons" / f"{button}.button.json").read_text())["states"][0]
    return f"{state['operatingPoint_mm']:.2f} mm, {state['resetPoint_mm']:.2f} mm"


def main():
    folder = Path(sys.argv[1])
    print("""# The sample plots and what they truly show

Written by `draw.sh` (through `manifest.py`); do not edit. The pictures are drawn by gnuplot from the curves of
[the sample buttons](../buttons), whose own manifest says where each number comes from: a paper's text, a datasheet's value, or
our choice because the paper gives only a picture. The styles follow real datasheets; nothing of one is copied.

| file | button | x axis | y axis | travel | tactile points, press | tactile points, release | operating, reset point called out | style |
|---|---|---|---|---|---|---|---|---|""")
    rows = [line.split("\t") for line in (HERE / "plots.tsv").read_text().splitlines() if not line.startswith("#")]
    for name, button, state, form, x_axis, y_axis, style in rows:
        curves = strokes(folder / f"{button}.csv")
        forces = [force for _, force in curves["press"]]
        bar_N = PROMINENCE_OF_SPAN * (max(forces) - min(forces))
        travel_mm = max(x for x, _ in curves["press"])
        print(f"| [{name}.{form}]({name}.{form}) | {button}{'' if state == '-' else ', ' + state} | {x_axis} | {y_axis} | {travel_mm:.2f} mm "
              f"| {listed(tactile_points(curves['press'], 1, bar_N))} "
              f"| {listed(tactile_points(curves['release'], -1, bar_N))} | {callouts(name, button)} | {style} |")
    print("""
`force-meter-log.csv` is the log a force meter would give of button C, made by `force_meter_log.py` from the same curves: a row
every 0.02 s at 0.25 mm/s, Gaussian noise of 0.002 mm and 0.4 gf, rounded to 0.001 mm and 0.1 gf, fixed seed.""")


if __name__ == "__main__":
    main()
