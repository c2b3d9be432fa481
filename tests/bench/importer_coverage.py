#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Do the errors that an import tells cover? Drawn buttons of known tactile points, page by page of every class.

importer_coverage.py PROGRAM [--number N] [--quality precise]     prints the table of docs/measurements/coverage.md

gnuplot draws (tests/accuracy/draw_plots.py), ImageMagick makes scans (turned, blurred, grainy) and photographs of it (photograph.py). A tactile
point of the result is held against the drawn one, the press' maximum and the release's minimum; the error is that of `--json`. Deterministic on one machine.
"""

import argparse
import json
import random
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "accuracy"))
import draw_plots  # noqa: E402

CLASSES = {"vector": ("svg", "pdf"), "drawn picture": ("one ink", "two inks", "no grid", "dark"), "scan": ("one ink", "two inks"),
           "photograph": ("photo", "coloured photo")}
FIRST = 500  # numbers below are what tests/accuracy draws, on which things were built


def scanned(picture: Path, number: int) -> Path:
    """As a flatbed gives it: turned by up to 1.2 degrees, slightly unsharp, grainy paper."""
    chance = random.Random(f"scan {number}")
    result = picture.with_name(f"{picture.stem}-scan.png")
    subprocess.run(["convert", str(picture), "-background", "white", "-rotate", f"{chance.uniform(-1.2, 1.2):.3f}", "+repage", "-blur", "0x0.7",
                    "-seed", str(number), "-attenuate", "0.25", "+noise", "Gaussian", str(result)], check=True)
    return result


def drawn_point(stroke: list[tuple[float, float]], sign: int) -> tuple[float, float] | None:
    """The first inner maximum (`sign` 1) or the last inner minimum (-1), between the drawn points: the top of the parabola through three."""
    turning = [index for index in range(1, len(stroke) - 1)
               if sign * stroke[index][1] > sign * stroke[index - 1][1] and sign * stroke[index][1] >= sign * stroke[index + 1][1]]
    if not turning:
        return None
    index = turning[0] if sign > 0 else turning[-1]
    (x0, y0), (x1, y1), (x2, y2) = stroke[index - 1:index + 2]
    bend = y0 - 2 * y1 + y2
    off = 0.5 * (y0 - y2) / bend
    return x1 + off * (x2 - x0) / 2, y1 - 0.25 * (y0 - y2) * off


def ratios_of(program: str, page: Path, graph: dict, quality: str) -> list[tuple[float, float]]:
    """Error over stated error, of travel and of force, for each stroke; empty where the page was refused."""
    done = subprocess.run([program, str(page), "--json", "--quality", quality, "-o", str(page.with_suffix(".button.json"))], capture_output=True, text=True)
    if done.returncode != 0:
        return []
    report, ratios = json.loads(done.stdout), []
    for stroke, sign in (("press", 1), ("release", -1)):
        truth = drawn_point(graph[stroke], sign)
        points = report.get(stroke, {}).get("tactile_points", [])
        if truth is None or not points:
            continue
        point = min(points, key=lambda each: abs(each["displacement_mm"] - truth[0]))
        ratios.append(((point["displacement_mm"] - truth[0]) / point["sigma_mm"], (point["force_N"] - truth[1]) / point["sigma_N"]))
    return ratios


def within(values: list[float], sigmas: float) -> str:
    return f"{100 * sum(abs(value) <= sigmas for value in values) / len(values):.0f}"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--number", type=int, default=24, help="pages of each class")
    parser.add_argument("--quality", default="precise")
    given = parser.parse_args()
    print("| pages | read | points | travel, 1 sigma | 1.96 sigma | force, 1 sigma | 1.96 sigma |\n|---|---|---|---|---|---|---|")
    for name, kinds in CLASSES.items():
        ratios, read = [], 0
        with tempfile.TemporaryDirectory() as folder:
            for index in range(given.number):
                drawn = draw_plots.draw(Path(folder), kinds[index % len(kinds)], FIRST + index)
                page = Path(folder, drawn["file"])
                if name == "scan":
                    page = scanned(page, FIRST + index)
                of_page = ratios_of(given.program, page, drawn["graphs"][0], given.quality)
                read += bool(of_page)
                ratios += of_page
        travel, force = zip(*ratios) if ratios else ((), ())
        cells = [within(values, sigmas) if values else "" for values in (travel, force) for sigmas in (1, 1.96)]
        print(f"| {name} | {read} of {given.number} | {len(ratios)} | " + " | ".join(cells) + " |")
    return 0


if __name__ == "__main__":
    sys.exit(main())
