#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The accuracy gate: imports what draw_plots.py draws, without a hint, and holds each class of plots against its bounds.

    accuracy_test.py --bin FOLDER [--measure] [--keep FOLDER]

A graph's error is the symmetric mean distance between the drawn strokes and the traced fit, both in shares of the graph's spans,
in percent; the worse of press and release. A graph that is refused, missing or without a stroke counts as lost. Bounds stand just
above what is reached: a change that makes a class worse has to say so here. --measure prints what is reached and fails nothing;
--keep leaves pictures and results in FOLDER.
"""

import argparse
import csv
import json
import math
import os
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))
import draw_plots  # noqa: E402


@dataclass(frozen=True)
class Bounds:
    lost: int                # graphs of the class that may be lost
    mean_percent: float      # mean error of those found
    worst_percent: float     # the worst of those found


BOUNDS = {
    "one ink": Bounds(0, 0.14, 0.21),
    "two inks": Bounds(0, 0.16, 0.22),
    "dashed grid": Bounds(0, 0.16, 0.20),
    "dashed axes": Bounds(0, 0.16, 0.19),
    "dark": Bounds(0, 0.15, 0.17),
    "no grid": Bounds(0, 0.16, 0.18),
    "rotated": Bounds(0, 0.16, 0.30),
    "svg": Bounds(0, 0.11, 0.14),
    "pdf": Bounds(0, 0.10, 0.12),
    "jpeg": Bounds(0, 0.20, 0.25),
    "coloured jpeg": Bounds(0, 0.20, 0.25),
    "page of two": Bounds(0, 0.17, 0.24),
    "photo": Bounds(0, 0.12, 0.16),
    "coloured photo": Bounds(1, 0.16, 0.20),
    "scaled down": Bounds(0, 0.24, 0.36),
    "scaled far down": Bounds(1, 0.34, 0.46),
    "drawn small": Bounds(0, 0.19, 0.26),
}
# Of a plot of several switches each is imported by its name.
SEVERAL = Bounds(0, 0.10, 0.16)
UNDECIDED = (4, 5)  # exit codes of a page that holds no force graph, or none that is certain


def polyline_distance(points, line):
    """Mean distance of points to a polyline."""
    total = 0.0
    for x, y in points:
        best = math.inf
        for (x0, y0), (x1, y1) in zip(line, line[1:]):
            dx, dy = x1 - x0, y1 - y0
            length = dx * dx + dy * dy
            t = 0 if length == 0 else max(0.0, min(1.0, ((x - x0) * dx + (y - y0) * dy) / length))
            best = min(best, (x - x0 - t * dx) ** 2 + (y - y0 - t * dy) ** 2)
        total += math.sqrt(best)
    return total / len(points)


def thinned(points, most=120):
    step = max(1, len(points) // most)
    return points[::step] + points[-1:]


def error_percent(truth, found):
    """The worse of the two strokes; nan if one is missing."""
    every = truth["press"] + truth["release"]
    span = [max(p[i] for p in every) - min(p[i] for p in every) for i in (0, 1)]
    worst = 0.0
    if not truth["release"] and found.get("release"):
        return math.inf  # a stroke that nobody drew
    for stroke in ("press", "release") if truth["release"] else ("press",):
        if len(found.get(stroke, [])) < 2:
            return math.nan
        drawn, read = ([(x / span[0], y / span[1]) for x, y in thinned(points)] for points in (truth[stroke], found[stroke]))
        worst = max(worst, 50 * (polyline_distance(drawn, read) + polyline_distance(read, drawn)))
    return worst


def strokes_in(path):
    found = {}
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            found.setdefault(row["stroke"], []).append((float(row["displacement_mm"]), float(row["force_N"])))
    return found


def import_page(program, folder, page):
    """Exit code and error of each graph of a page; of a page to be refused the exit code of an import without a hint."""
    results = []
    for index in range(max(1, len(page["graphs"]))):
        out = folder / f"{page['file']}.{index}.csv"
        words = [program, str(folder / page["file"]), "--csv", str(out), "--json"]
        if page["kind"] == "several":
            words += ["--curve", page["graphs"][index]["name"]]
        elif len(page["graphs"]) > 1:
            words += ["--page", "1", "--graph", str(index + 1)]
        run = subprocess.run(words, capture_output=True, text=True, env={**os.environ, "OMP_THREAD_LIMIT": "1"})
        error = error_percent(page["graphs"][index], strokes_in(out)) if page["graphs"] and run.returncode == 0 else math.nan
        results.append((run.returncode, error, confidence_in(run.stdout)))
    if page["kind"] == "several":  # and once unasked: which of them is not to be guessed
        unasked = subprocess.run([program, str(folder / page["file"])], capture_output=True, text=True)
        named = all(graph["name"] in unasked.stderr for graph in page["graphs"])
        results.append((unasked.returncode if named else -1, math.nan, 1))
    return results


def confidence_in(report):
    """Of an import's JSON; 1 where there is none."""
    try:
        return json.loads(report).get("confidence", 1)
    except ValueError:
        return 1


def guard_faults(page, code, error, confidence):
    """What a guard's page was answered with and must not be."""
    guard = draw_plots.GUARDS[page["name"]]
    if code not in guard["exit"]:
        yield f"{page['file']}: exit {code}, expected {' or '.join(map(str, guard['exit']))}"
    if error > guard.get("worst_percent", math.inf):
        yield f"{page['file']} lies {error:.3f} % of span off, bound {guard['worst_percent']} %"
    if code == 0 and confidence > guard.get("confidence", 1):
        yield f"{page['file']} is believed with {confidence:.2f}, at most {guard['confidence']} is due"


def measured(pages, results):
    """Per class: file, exit code and error of each graph."""
    table = {}
    for page, found in zip(pages, results):
        if page["kind"] in ("refused", "guard"):
            continue
        found = found[:len(page["graphs"])]
        table.setdefault(page["kind"], []).extend((page["file"], code, error) for code, error, _ in found)
    return table


def class_faults(kind, graphs, bounds):
    errors = [error for _, _, error in graphs if not math.isnan(error)]
    lost = [f"{file} (exit {code})" for file, code, error in graphs if math.isnan(error)]
    if len(lost) > bounds.lost:
        yield f"{kind}: {len(lost)} graphs are lost, {bounds.lost} may be: {', '.join(lost)}"
    if errors and sum(errors) / len(errors) > bounds.mean_percent:
        yield f"{kind}: mean error {sum(errors) / len(errors):.3f} % of span, bound {bounds.mean_percent} %"
    for file, _, error in graphs:
        if error > bounds.worst_percent:
            yield f"{kind}: {file} lies {error:.3f} % of span off, bound {bounds.worst_percent} %"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--bin", type=Path, required=True)
    parser.add_argument("--measure", action="store_true")
    parser.add_argument("--keep", type=Path)
    arguments = parser.parse_args()
    if subprocess.run(["which", "gnuplot", "convert"], capture_output=True).returncode != 0:
        print("SKIPPED: gnuplot or ImageMagick is missing (./install-dependencies.sh test)")
        return 0
    with tempfile.TemporaryDirectory() as scratch:
        folder = arguments.keep or Path(scratch)
        pages = draw_plots.draw_all(folder)
        program = str(arguments.bin.resolve() / "detent-import")
        with ThreadPoolExecutor(2) as pool:
            results = list(pool.map(lambda page: import_page(program, folder, page), pages))
    faults = []
    for kind, graphs in measured(pages, results).items():
        errors = sorted(error for _, _, error in graphs if not math.isnan(error))
        print(f"{kind:12} {len(graphs):2} graphs, {len(graphs) - len(errors)} lost, mean "
              f"{sum(errors) / max(1, len(errors)):.3f} %, worst {errors[-1] if errors else math.nan:.3f} %")
        if arguments.measure:
            for file, code, error in graphs:
                print(f"    {file:24} exit {code}  {error:.3f} %")
        else:
            faults += class_faults(kind, graphs, BOUNDS.get(kind, SEVERAL))
    for page, found in zip(pages, results):
        if page["kind"] == "several" and found[-1][0] != 5:
            faults.append(f"{page['file']} shows several switches; unasked it ends with {found[-1][0]} or does not name them all")
        if page["kind"] == "refused":
            print(f"{page['file']}: exit {found[0][0]}")
            if found[0][0] not in UNDECIDED:
                faults.append(f"{page['file']} holds no readable force graph and was imported (exit {found[0][0]})")
        if page["kind"] == "guard":
            code, error, confidence = found[0]
            print(f"{page['file']}: exit {code}, {error:.3f} %, confidence {confidence:.2f}")
            faults += guard_faults(page, code, error, confidence)
    for fault in [] if arguments.measure else faults:
        print(f"FAULT: {fault}")
    return 1 if faults and not arguments.measure else 0


if __name__ == "__main__":
    sys.exit(main())
