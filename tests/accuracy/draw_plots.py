#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws force graphs in the styles of datasheets, with their true values, and pages that hold no readable force graph.

    draw_plots.py FOLDER        draws everything and writes FOLDER/truth.json; look at the pictures when a style is changed

The curves are made here, from a fixed seed; gnuplot, which knows nothing of Detent, draws them; ImageMagick turns some of them, and photograph.py makes photographs.
The same pictures come out each time on one machine. Lengths in mm, forces in N.
"""

import json
import math
import random
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))
import photograph  # noqa: E402

NEWTONS = {"N": 1.0, "cN": 0.01, "gf": 0.00980665}


@dataclass
class Style:
    """How a class of plots is drawn; `turn_deg` is applied to the finished picture."""
    terminal: str = "pngcairo size 760,540 enhanced font 'DejaVu Sans,12'"
    ending: str = "png"
    inks: tuple = ("black", "black")
    grid: str = "set grid lt 1 lw 0.6 lc rgb '#b8b8b8'"
    text: str = "black"
    border: str = "set border 15 lc rgb 'black'"
    width: float = 2.2
    turn_deg: float = 0
    quality: int = 0  # of a JPEG; 0: as gnuplot wrote it
    photographed: bool = False  # as a sheet before a camera
    widths_px: tuple = ()  # scaled down, by the plot's number
    lines: list = field(default_factory=list)


PRINTED = "pngcairo size 1520,1080 enhanced font 'DejaVu Sans,12' fontscale 2 linewidth 2"
STYLES = {
    "one ink": Style(),
    "two inks": Style(inks=("#c8102e", "#0b5cad")),
    "dashed grid": Style(inks=("black", "#c8102e"), grid="set grid dashtype 2 lw 1 lc rgb '#808080'"),
    "dashed axes": Style(inks=("#0b5cad", "#c8102e"), border="set border 15 dashtype 2 lc rgb 'black'",
                         grid="set grid dashtype 3 lw 1 lc rgb '#606060'"),
    "dark": Style(terminal="pngcairo size 760,540 enhanced font 'DejaVu Sans,12' background rgb '#1e2127'",
                  inks=("#61afef", "#e5c07b"), grid="set grid lt 1 lw 0.7 lc rgb '#454b57'", text="#d7dae0",
                  border="set border 15 lc rgb '#d7dae0'"),
    "no grid": Style(inks=("black", "#0b5cad"), grid="unset grid"),
    "rotated": Style(inks=("#0b5cad", "#c8102e")),
    "svg": Style(terminal="svg size 760,540 dynamic enhanced font 'DejaVu Sans,12'", ending="svg", inks=("#c8102e", "#0b5cad")),
    "pdf": Style(terminal="pdfcairo size 6.2in,4.4in enhanced font 'DejaVu Sans,11'", ending="pdf", inks=("#0b5cad", "black")),
    "jpeg": Style(ending="jpg", quality=85),
    "coloured jpeg": Style(inks=("#c8102e", "#0b5cad"), ending="jpg", quality=82),
    "page of two": Style(inks=("#c8102e", "#0b5cad"), terminal="pngcairo size 820,1100 enhanced font 'DejaVu Sans,12'"),
    "photo": Style(terminal=PRINTED, photographed=True),
    "coloured photo": Style(terminal=PRINTED, inks=("#c8102e", "#0b5cad"), photographed=True),
    "scaled down": Style(inks=("#c8102e", "#0b5cad"), widths_px=(300, 360, 430, 500)),
    "scaled far down": Style(inks=("#c8102e", "#0b5cad"), widths_px=(250, 270, 290, 310)),
    "drawn small": Style(terminal="pngcairo size 280,210 enhanced font 'DejaVu Sans,6.5'", width=1.0),
}
PER_CLASS = {"one ink": 8, "two inks": 8, "dashed grid": 3, "dashed axes": 3, "dark": 4, "no grid": 4, "rotated": 4, "svg": 4,
             "pdf": 4, "jpeg": 4, "coloured jpeg": 2, "page of two": 3, "photo": 4, "coloured photo": 4, "scaled down": 4, "scaled far down": 4,
             "drawn small": 4}


def smooth(points, x):
    """Cosine between neighbours: flat at every point, no overshoot."""
    for (x0, y0), (x1, y1) in zip(points, points[1:]):
        if x <= x1:
            return y0 + (y1 - y0) * 0.5 * (1 - math.cos(math.pi * (x - x0) / (x1 - x0)))
    return points[-1][1]


def strokes_of(chance):
    """A tactile button in N over mm: (press, release), each by increasing displacement, with its plausible hysteresis."""
    travel = chance.choice((0.6, 1.2, 2.0, 3.6, 4.0))
    peak_N = chance.uniform(0.4, 0.9) * (3 if travel < 1 else 1)
    top, valley = chance.uniform(0.28, 0.42), chance.uniform(0.55, 0.68)
    press = [(0, chance.uniform(0, 0.12) * peak_N), (top * travel, peak_N), (valley * travel, chance.uniform(0.55, 0.75) * peak_N),
             (0.95 * travel, 1.05 * peak_N), (travel, chance.uniform(1.5, 1.9) * peak_N)]
    loss = chance.uniform(0.10, 0.18) * peak_N
    release = [(0, max(0.0, press[0][1] - 0.02)), (0.85 * top * travel, press[1][1] - 1.3 * loss),
               (0.95 * valley * travel, press[2][1] - loss), (0.95 * travel, press[3][1] - loss), press[4]]
    places = [travel * i / 400 for i in range(401)]
    return [(x, smooth(press, x)) for x in places], [(x, smooth(release, x)) for x in places]


def nice(limit, steps=6):
    """The tick step of an axis that ends at or beyond `limit`, and that end."""
    raw = limit / steps
    size = 10 ** math.floor(math.log10(raw))
    step = next(size * m for m in (1, 2, 2.5, 5, 10) if size * m >= raw * 0.999)
    return step, step * math.ceil(limit / step - 1e-9)


def graph_lines(style, name, press, release, unit, title):
    """The gnuplot commands of one graph; data stands in here-documents, so that a script is complete."""
    factor = 1 / NEWTONS[unit]
    x_step, x_end = nice(press[-1][0] * 1.02)
    y_step, y_end = nice(max(f for _, f in press) * factor * 1.05)
    blocks = []
    for stroke, points in (("press", press), ("release", release)):
        rows = "\n".join(f"{x:.6g} {f * factor:.6g}" for x, f in points)
        blocks.append(f"$%s << EOD\n{rows}\nEOD" % f"{name}_{stroke}")
    return blocks + [
        f"set xrange [0:{x_end:g}]", f"set yrange [0:{y_end:g}]",
        f"set xtics 0,{x_step:g} textcolor rgb '{style.text}'", f"set ytics 0,{y_step:g} textcolor rgb '{style.text}'",
        f"set xlabel 'Travel (mm)' textcolor rgb '{style.text}'", f"set ylabel 'Force ({unit})' textcolor rgb '{style.text}'",
        f"set title '{title}' textcolor rgb '{style.text}'", style.border, style.grid, "unset key", *style.lines,
        f"plot ${name}_press with lines lt 1 lw {style.width} lc rgb '{style.inks[0]}', "
        f"${name}_release with lines lt 1 lw {style.width} lc rgb '{style.inks[1]}'"]


def gnuplot(script, what):
    run = subprocess.run(["gnuplot"], input=script, text=True, capture_output=True)
    if run.returncode != 0:
        sys.exit(f"draw_plots.py: gnuplot could not draw {what}: {run.stderr.strip()}")


def converted(picture, *words):
    """The picture after ImageMagick's operations; the intermediate one is removed."""
    result = picture.with_name(picture.name.replace(".raw", ""))
    subprocess.run(["convert", str(picture), *words, str(result)], check=True)
    picture.unlink()
    return result


def draw(folder, kind, number):
    """One page of a class; its file name and the truth of each graph on it, from top to bottom."""
    chance = random.Random(f"{kind} {number}")
    style = STYLES[kind]
    graphs, script = [], []
    name = f"{kind.replace(' ', '-')}-{number}"
    afterwards = []
    if kind == "rotated":
        afterwards = ["-background", "white", "-rotate", f"{(-1) ** number * (0.6 + 0.5 * number):g}", "+repage"]
    if style.ending == "jpg":
        afterwards = ["-quality", str(style.quality)]
    file = folder / f"{name}{'.raw' if afterwards else ''}.{style.ending if style.ending != 'jpg' or not afterwards else 'png'}"
    script += [f"set terminal {style.terminal}", f"set output '{file}'"]
    count = 2 if kind == "page of two" else 1
    if count == 2:
        script.append("set multiplot layout 2,1")
    for index in range(count):
        press, release = strokes_of(chance)
        unit = chance.choice(("N", "cN", "gf"))
        script += graph_lines(style, f"g{index}", press, release, unit, f"Type {chance.choice('ABCDEFGH')}{number}{index}")
        graphs.append({"press": press, "release": release})
    gnuplot("\n".join(script) + "\n", name)
    if afterwards:
        if style.ending == "jpg":
            target = folder / f"{name}.jpg"
            subprocess.run(["convert", str(file), *afterwards, str(target)], check=True)
            file.unlink()
            file = target
        else:
            file = converted(file, *afterwards)
    if style.photographed or style.widths_px:
        drawn, file = file, folder / f"{name}-seen.{'jpg' if style.photographed else 'png'}"
        if style.photographed:
            photograph.photographed(drawn, file, number)
        else:
            photograph.lowered(drawn, file, style.widths_px[number % len(style.widths_px)])
        drawn.unlink()
    return {"file": file.name, "kind": kind, "graphs": graphs}


# Pages without a force graph that could be read, as gnuplot commands; the importer must refuse each or be in doubt.
PNG = "set terminal pngcairo size 760,540 enhanced font 'DejaVu Sans,12'"
REFUSED = {
    "blank": "unset border; unset tics; unset key; set yrange [0:1]; plot 2 notitle",
    "text": "unset border; unset tics; unset key; set yrange [0:1]\n" + "\n".join(
        f"set label {i} 'Clause {i}: the contact resistance stays below {i}00 mOhm over {i},000,000 cycles.' at screen 0.08,{0.95 - i * 0.06:g}"
        for i in range(1, 14)) + "\nplot 2 notitle",
    "bars": "set style fill solid; set boxwidth 0.7; unset key; set ylabel 'Sales (pieces)'; set yrange [0:40]; "
            "plot '-' using 0:1 with boxes\n10\n25\n17\n31\n8\ne\n",
    "scatter": "unset key; set xlabel 'Year'; set ylabel 'Price (EUR)'; set xrange [1990:2020]; set yrange [0:50]; "
               "plot '-' with points pt 7\n1991 3\n1994 30\n1999 12\n2003 44\n2008 9\n2013 27\n2018 15\ne\n",
    "no numbers": "unset key; unset xtics; unset ytics; set xrange [0:6]; set yrange [0:1.2]; "
                  "plot 0.5+0.4*sin(x) with lines lw 2 lc rgb 'black'",
    "table": "unset border; unset tics; unset key; set yrange [0:1]\n" + "\n".join(
        f"set arrow {i + 1} from screen 0.1,{0.9 - i * 0.1:g} to screen 0.9,{0.9 - i * 0.1:g} nohead" for i in range(8)) + "\n" + "\n".join(
        f"set arrow {i + 20} from screen {0.1 + i * 0.2:g},0.2 to screen {0.1 + i * 0.2:g},0.9 nohead" for i in range(5)) + "\n" + "\n".join(
        f"set label {r * 10 + c + 1} '{r}.{c}' at screen {0.17 + 0.2 * c:g},{0.85 - 0.1 * r:g}" for r in range(7) for c in range(4)) +
        "\nplot 2 notitle",
    "axes without curves": "unset key; set xlabel 'Travel (mm)'; set ylabel 'Force (N)'; set xrange [0:4]; set yrange [0:1]; set grid; "
                           "plot 2 notitle",
}


def draw_refused(folder, name):
    file = folder / f"refused-{name.replace(' ', '-')}.png"
    gnuplot(f"{PNG}\nset output '{file}'\n{REFUSED[name]}\n", name)
    return {"file": file.name, "kind": "refused", "graphs": []}


def hatched(chance):
    """Strokes up and down over the whole plot: ink in abundance, and no curve."""
    return [(3.9 * i / 60, (0.05 if i % 2 else 0.92) + chance.uniform(-0.03, 0.03)) for i in range(61)]


# One page for each guard of the importer that no other page misses: what stands beside or behind two good curves, and what may be
# answered: exit codes, and the largest error where it is read or the largest confidence where it may only be doubted.
GUARDS = {
    "faint band": {"exit": [0], "worst_percent": 0.4,
                   "behind": "0.55+0.3*sin(3*x) with lines lw 16 lc rgb '#f6efe2' notitle"},
    "printed conflict": {"exit": [5], "pdf": True,
                         "lines": ["set bmargin 7", "set label 90 'Total travel 14.0 mm' at screen 0.1,0.06",
                                   "set label 91 'Operating force 30 N' at screen 0.1,0.02"]},
    "no units": {"exit": [0, 5], "confidence": 0.8, "units": False},
    "hatching": {"exit": [3, 4, 5], "hatched": True},
}


def draw_guard(folder, name):
    """The page of one guard, in the manner of `draw`."""
    guard, chance = GUARDS[name], random.Random(f"guard {name}")
    style = Style(**{**vars(STYLES["pdf" if guard.get("pdf") else "two inks"]), "lines": guard.get("lines", [])})
    file = folder / f"guard-{name.replace(' ', '-')}.{style.ending}"
    press, release = strokes_of(chance)
    if guard.get("hatched"):
        press = release = hatched(chance)
    script = graph_lines(style, "g", press, release, "N", name)
    if not guard.get("units", True):
        script = [line.replace(" (mm)", "").replace(" (N)", "") for line in script]
    if "behind" in guard:
        script[-1] = script[-1].replace("plot ", f"plot {guard['behind']}, ", 1)
    gnuplot("\n".join([f"set terminal {style.terminal}", f"set output '{file}'", "set samples 800", *script]) + "\n", name)
    return {"file": file.name, "kind": "guard", "name": name, "graphs": [{"press": press, "release": release}]}


# Several switches in one plot: what their legend calls them, how their strokes are drawn, where the legend stands.
SEVERAL = {
    "press only": {"names": ("Switch A", "Switch B", "Switch C"), "strokes": "press", "key": "bottom right"},
    "four inks": {"names": ("Brown", "Red"), "strokes": "inks", "key": "outside right top"},
    "loops": {"names": ("Alpha", "Beta", "Gamma"), "strokes": "loop", "key": "outside right top"},
    "vector": {"names": ("Gateron", "Kailh"), "strokes": "inks", "key": "top left", "svg": True},
    "vector loops": {"names": ("Type 1", "Type 2"), "strokes": "loop", "key": "outside right top", "svg": True},
}
SEVERAL_INKS = ("#c8102e", "#0b5cad", "#2e8b37", "#d98e04", "#7b3fa0", "#159a9c")


def unlike_strokes(chance, others):
    """Strokes whose press keeps clear of the others' tactile points, so that a person can tell the switches apart."""
    while True:
        travel = chance.uniform(3.0, 4.0)
        press, release = strokes_of(chance)
        scaled = [[(x / stroke[-1][0] * travel, f / press[-1][1] * 1.4) for x, f in stroke] for stroke in (press, release)]
        peak = max(scaled[0][:250], key=lambda p: p[1])
        if all(abs(peak[1] - max(o["press"][:250], key=lambda p: p[1])[1]) > 0.08 for o in others):
            return {"press": scaled[0], "release": scaled[1]}


def draw_several(folder, name):
    """Switches that share a plot, in the manner of `draw`; each graph's truth has its name."""
    page, chance = SEVERAL[name], random.Random(f"several {name}")
    style = STYLES["svg" if page.get("svg") else "two inks"]
    file = folder / f"several-{name.replace(' ', '-')}.{style.ending}"
    graphs, blocks, plots = [], [], []
    for index, called in enumerate(page["names"]):
        graphs.append({"name": called, **unlike_strokes(chance, graphs)})
        if page["strokes"] == "press":
            graphs[-1]["release"] = []
        for number, stroke in enumerate(("press", "release")):
            if not graphs[-1][stroke]:
                continue
            rows = "\n".join(f"{x:.6g} {f:.6g}" for x, f in graphs[-1][stroke])
            blocks.append(f"$g{index}_{stroke} << EOD\n{rows}\nEOD")
            ink = SEVERAL_INKS[2 * index + number if page["strokes"] == "inks" else index]
            entry = {"inks": f"title '{called} {stroke}'", "press": f"title '{called}'",
                     "loop": f"title '{called}'" if stroke == "press" else "notitle"}[page["strokes"]]
            plots.append(f"$g{index}_{stroke} with lines lt 1 lw {style.width} lc rgb '{ink}' {entry}")
    gnuplot("\n".join([f"set terminal {style.terminal}", f"set output '{file}'", *blocks, "set xrange [0:4.5]", "set yrange [0:1.6]",
                       "set xtics 0,0.5", "set ytics 0,0.2", "set xlabel 'Travel (mm)'", "set ylabel 'Force (N)'",
                       style.border, style.grid, f"set key {page['key']}", "plot " + ", ".join(plots)]) + "\n", name)
    return {"file": file.name, "kind": "several", "name": name, "graphs": graphs}


def draw_all(folder):
    folder.mkdir(parents=True, exist_ok=True)
    pages = [draw(folder, kind, number) for kind, count in PER_CLASS.items() for number in range(count)]
    pages += [draw_refused(folder, name) for name in REFUSED]
    pages += [draw_guard(folder, name) for name in GUARDS]
    pages += [draw_several(folder, name) for name in SEVERAL]
    (folder / "truth.json").write_text(json.dumps(pages))
    return pages


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("draw_plots.py: one argument, the folder to draw into")
    drawn = draw_all(Path(sys.argv[1]))
    print(f"{len(drawn)} pages, {sum(len(page['graphs']) for page in drawn)} graphs")
