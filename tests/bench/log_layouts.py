#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the confidence of a force log is worth, counted on tables drawn at random with known truth.

log_layouts.py draw FOLDER FIRST:COUNT              writes tables with their truth (NAME.truth.json) beside them
log_layouts.py count IMPORT_PROGRAM ROWS.jsonl FIRST:COUNT [--jobs N]    imports each with --sure 0 and appends a row a table
log_layouts.py write ROWS.jsonl...                  prints the reliability table

Layouts are perturbed: titles in many languages, units and where they stand, column order, delimiters, decimal commas, preambles, other
columns, trailing statistics, records stacked, beside each other or interleaved, signs and zeros of stages. The words here are written
without looking at the reader's lexicon.tsv: some are missing there. One table in eight is no force log.
Wrong: accepted with a stroke missing or invented, or more than 2 % of the span from the truth of every record of the file; any
acceptance of a table that is no force log. Needs Debian's python3-numpy."""

import argparse
import collections
import concurrent.futures
import csv
import json
import os
import random
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

sys.dont_write_bytecode = True
from promise import upper_bound  # noqa: E402

WRONG = 0.02  # of the span
TIMEOUT_s = 60
LENGTHS = {"mm": 1, "µm": 1e-3, "um": 1e-3, "in": 25.4, "cm": 10, "mil": 0.0254, "m": 1000}  # in mm
FORCES = {"N": 1, "gf": 9.80665e-3, "g": 9.80665e-3, "cN": 0.01, "mN": 1e-3, "kgf": 9.80665, "lbf": 4.4482216, "ozf": 0.27801385,
          "kN": 1000, "oz": 0.27801385, "lb": 4.4482216, "kg": 9.80665}
TRAVEL_TITLES = ["Travel", "Displacement", "Position", "Stroke", "Depth", "Deflection", "Key travel", "Plunger position", "Distance", "Indentation",
                 "Weg", "Hub", "Verfahrweg", "Eindringtiefe", "Course", "Déplacement", "Enfoncement", "Corsa", "Spostamento", "Recorrido",
                 "Desplazamiento", "Deslocamento", "Curso", "Verplaatsing", "Slag", "Zdvih", "Dráha", "Przemieszczenie", "Skok", "Elmozdulás",
                 "Siirtymä", "Matka", "Yol", "Yer değiştirme", "Ход", "Перемещение", "Διαδρομή", "行程", "位移", "变位", "ストローク", "変位",
                 "변위", "스트로크", "Crosshead", "Actuator pos", "Stage Z", "probe_pos", "xpos", "travel_act", "LVDT"]
FORCE_TITLES = ["Force", "Load", "Key force", "Push force", "Compression force", "Applied force", "Load cell", "Reaction", "Operating force",
                "Kraft", "Prüfkraft", "Betätigungskraft", "Kraftwert", "Force appliquée", "Effort", "Charge", "Forza", "Carico", "Fuerza", "Carga",
                "Força", "Kracht", "Síla", "Siła", "Erő", "Forță", "Voima", "Kuvvet", "Yük", "Сила", "Усилие", "Нагрузка", "Δύναμη", "力", "荷重",
                "压力", "力量", "フォース", "하중", "힘", "Fz", "F", "force_meas", "loadcell", "LC1", "fgauge"]
PRESS_WORDS = [("press", "release"), ("down", "up"), ("loading", "unloading"), ("Druck", "Rückhub"), ("Hinweg", "Rückweg"), ("aller", "retour"),
               ("forward", "return"), ("push", "pull back"), ("andata", "ritorno"), ("ida", "vuelta"), ("compression", "decompression"), ("往", "復"),
               ("按下", "释放"), ("нажатие", "отпускание"), ("tryck", "släpp")]
OTHERS = ["Time (s)", "Time (ms)", "Index", "No.", "Temperature (°C)", "Speed (mm/s)", "Raw counts", "Voltage (V)", "Energy (mJ)", "Stress (MPa)",
          "Peak force (same)", "Filtered (same)", "Battery", "Strain (%)", "Target pos (same x)"]
NOTES = ["Operator: {w}", "Date: 2026-03-{n:02d}", "Serial no.: {k}", "Speed: 0.{n} mm/s", "Sample rate = {k} Hz", "Max force: {n}.5 N", "Test {n}",
         "Software v{n}.2.1", "# {w} switch, lot {k}", "Limit;{n};{k}", "Comment: {w} {w}", "Probe diameter 4 mm", "{w}", "Load cell: 10 N class 0.5",
         "Prüfer: {w}", "Batch,{k}"]
WORDS = ["Alpha", "Müller", "blue", "tactile", "north", "Rev C", "K7", "unlubed", "factory", "Ana", "テスト", "lab 2"]


class Press:
    """A spring with a bump or a snap and a stop, and the way back below it."""

    def __init__(self, draw, count):
        finest = 3 / count  # of the travel: what rises within a row cannot be read from a table
        self.travel = float(np.exp(draw.uniform(np.log(0.2), np.log(6))))
        self.top = float(np.exp(draw.uniform(np.log(0.3), np.log(14))))
        kind = draw.choice(["linear", "bump", "bump", "snap", "stop"])
        t = np.linspace(0, 1, 400)
        f = draw.uniform(0.05, 0.3) * np.minimum(1, t / max(0.04, finest)) + 0.4 * t
        if kind in ("bump", "snap"):
            at, wide = draw.uniform(0.25, 0.6), 0.12 if kind == "bump" else max(0.05, finest)
            f = f + draw.uniform(0.2, 0.5) * np.exp(-((t - at) / wide) ** 2)
        stop = 0.9 if kind != "linear" else 1 - max(0.03, finest)
        f = f + np.where(t > stop, (t - stop) / (1 - stop), 0) * draw.uniform(0.6, 1.5)
        self.x, self.press = t * self.travel, f / f.max() * self.top
        loss = draw.uniform(0.04, 0.2) * np.sin(np.pi * np.minimum(1, t / 0.95)) * np.minimum(1, (1 - t) / max(0.05, finest))
        self.release = np.maximum(0.3 * self.press, self.press - loss * self.top)
        self.release[0] = 0

    def varied(self, draw):
        other = object.__new__(Press)
        scale = draw.uniform(0.8, 1.25)
        other.x, other.travel = self.x, self.travel
        other.press, other.release, other.top = self.press * scale, self.release * scale, self.top * scale
        return other

    def rows(self, draw, count, both):
        x = np.linspace(0, self.travel, count)
        noise = draw.uniform(0.0003, 0.002) * self.top
        chance = np.random.default_rng(draw.getrandbits(32))
        down = np.c_[x, np.interp(x, self.x, self.press) + chance.normal(0, noise, count)]
        up = np.c_[x, np.interp(x, self.x, self.release) + chance.normal(0, noise, count)][::-1]
        return (down, up[draw.choice([0, 1]):]) if both else (down, None)

    def truth(self, both, count):
        """Straight between the places that are written: more cannot be known."""
        x = np.linspace(0, self.travel, count)
        strokes = {"press": np.c_[x, np.interp(x, self.x, self.press)]}
        if both:
            strokes["release"] = np.c_[x, np.interp(x, self.x, self.release)][::-1]
        return strokes


class Layout:
    """One drawn table: `text`, `truths` (empty: no force log), `kind`."""

    def __init__(self, seed):
        draw = self.draw = random.Random(seed)
        self.xUnit = draw.choices(list(LENGTHS), [70, 8, 8, 5, 3, 3, 1])[0]
        self.yUnit = draw.choices(list(FORCES), [45, 12, 8, 6, 6, 3, 4, 3, 1, 3, 2, 2])[0]
        self.decimal = draw.choices([".", ","], [70, 30])[0]
        self.delimiter = draw.choices([",", ";", "\t", "|", "  "], [40, 25, 25, 3, 7])[0]
        if self.decimal == "," and self.delimiter == ",":
            self.delimiter = ";"
        self.truths, self.lines = [], []
        if draw.random() < 0.125:
            self.kind = "none"
            columns, titles = self.foreign()
        else:
            columns, titles = self.log()
        self.preamble()
        self.heading(titles)
        self.body(columns)
        self.after(columns)
        self.text = draw.choice(["\n", "\r\n"]).join(self.lines) + "\n"

    # -- columns ---------------------------------------------------------------------------------------------------

    def log(self):
        draw = self.draw
        self.kind = draw.choices(["run", "press", "beside", "labelled", "cycles", "interleaved", "specimens"], [45, 12, 13, 10, 8, 4, 8])[0]
        both = self.kind != "press"
        count = draw.choice([30, 60, 150, 400])
        press = Press(draw, count)
        sign = -1 if draw.random() < 0.06 else 1
        start = draw.choices([0, press.travel * draw.uniform(3, 12), -press.travel], [90, 7, 3])[0]
        self.zero = draw.choices([0, press.top * draw.uniform(-0.03, 0.03)], [93, 7])[0]
        x = lambda v: sign * (v + start) / LENGTHS[self.xUnit]
        f = lambda v: sign * v / FORCES[self.yUnit]
        title_x, title_f = draw.choice(TRAVEL_TITLES), draw.choice(FORCE_TITLES)
        self.named = draw.random() > 0.08
        columns, titles = [], []
        if self.kind in ("run", "press", "labelled", "cycles", "interleaved"):
            presses = [press]
            if self.kind in ("cycles", "interleaved"):
                presses += [press.varied(draw) for _ in range(draw.randint(1, 4))]
            parts = [each.rows(draw, count, both) for each in presses]
            self.truths = [each.truth(both, count) for each in presses]
            order = [[down, up] if both else [down] for down, up in parts]
            rows = np.vstack([stroke for each in order for stroke in each])
            labels = [n for each in order for n, stroke in enumerate(each) for _ in stroke]
            cycles = [i + 1 for i, each in enumerate(order) for stroke in each for _ in stroke]
            if self.kind == "interleaved":
                size = min(sum(len(s) for s in each) for each in order)
                whole = [np.vstack(each)[:size] for each in order]
                rows = np.stack(whole, 1).reshape(-1, 2)
                cycles, labels = list(range(1, len(order) + 1)) * size, []
            columns, titles = [x(rows[:, 0]), f(rows[:, 1])], [(title_x, self.xUnit), (title_f, self.yUnit)]
            if self.kind == "labelled":
                words = draw.choice(PRESS_WORDS + [("1", "2"), ("1", "0"), ("D", "U")])
                columns.append([words[n] for n in labels])
                titles.append((draw.choice(["Direction", "Phase", "Stroke", "Richtung", "Dir", "sens", "state"]), ""))
            if self.kind == "interleaved" or (self.kind == "cycles" and draw.random() < 0.7):
                columns.append(cycles)
                titles.append((draw.choice(["Cycle", "Run", "Zyklus", "Specimen", "Press no", "cycle_id", "Essai"]), ""))
        elif self.kind == "beside":
            down, up = press.rows(draw, count, True)
            up = up[::-1][-count:]
            if len(up) < len(down):
                down = down[:len(up)]
            self.truths = [press.truth(True, count)]
            words = draw.choice(PRESS_WORDS)
            shared = draw.random() < 0.5
            bracket = draw.choice(["{t} {s}", "{s} {t}", "{t}_{s}", "{t} ({s})"])
            named = [bracket.format(t=title_f, s=s) for s in words]
            if shared:
                columns, titles = [x(down[:, 0]), f(down[:, 1]), f(up[:, 1])], [(title_x, self.xUnit)] + [(n, self.yUnit) for n in named]
            else:
                columns = [x(down[:, 0]), f(down[:, 1]), x(up[:, 0]), f(up[:, 1])]
                titles = [(bracket.format(t=title_x, s=words[0]), self.xUnit), (named[0], self.yUnit),
                          (bracket.format(t=title_x, s=words[1]), self.xUnit), (named[1], self.yUnit)]
        else:
            presses = [press] + [press.varied(draw) for _ in range(draw.randint(1, 3))]
            self.truths = [each.truth(True, count) for each in presses]
            shared = draw.random() < 0.5
            for i, each in enumerate(presses):
                rows = np.vstack(each.rows(random.Random(seed_of(draw) if not shared else count), count, True))
                tag = draw.choice([f" {i + 1}", f" S{i + 1}", f"_{chr(65 + i)}"])
                if not shared or i == 0:
                    columns.append(x(rows[:, 0])), titles.append((title_x + ("" if shared else tag), self.xUnit))
                columns.append(f(rows[:, 1])), titles.append((title_f + tag, self.yUnit))
            least = min(len(c) for c in columns)
            columns = [c[:least] for c in columns]
        offset = sign * self.zero / FORCES[self.yUnit]
        columns = [c + offset if t[1] == self.yUnit and not isinstance(c, list) else c for c, t in zip(columns, titles)]
        self.digits = {}
        for unit, scale, span in ((self.xUnit, LENGTHS[self.xUnit], press.travel), (self.yUnit, FORCES[self.yUnit], press.top)):
            self.digits[unit] = max(0, int(np.ceil(-np.log10(span / scale / draw.choice([1000, 3000, 20000])))))
        self.withOthers(columns, titles)
        if draw.random() < 0.35 and self.kind not in ("beside", "specimens"):
            order = list(range(len(columns)))
            draw.shuffle(order)
            columns, titles = [columns[i] for i in order], [titles[i] for i in order]
        return columns, titles

    def withOthers(self, columns, titles):
        draw, rows = self.draw, len(columns[0])
        t = np.arange(rows)
        for name in draw.sample(OTHERS, draw.choices([0, 1, 2, 3], [45, 30, 17, 8])[0]):
            unit = name[name.find("(") + 1:-1] if "(" in name else ""
            plain, place = name.split(" (")[0], draw.choice([0, len(columns)])
            force = next(i for i, v in enumerate(titles) if v[1] == self.yUnit)
            travel = next(i for i, v in enumerate(titles) if v[1] == self.xUnit)
            values = {"s": t * 0.01, "ms": t * 10.0, "°C": 23 + 0.02 * np.sin(t / 9), "mm/s": 0.5 + 0 * t, "V": np.where(t % 97 > 40, 3.3, 0.01),
                      "mJ": np.cumsum(np.abs(np.asarray(columns[force], float))) * 1e-3, "MPa": np.asarray(columns[force], float) / 12.6,
                      "%": np.asarray(columns[travel], float) / 37 * 100}.get(unit)
            if unit == "same":
                values = np.maximum.accumulate(columns[force]) if plain.startswith("Peak") else np.convolve(columns[force], np.ones(3) / 3, "same")
                unit = self.yUnit
                plain = plain if plain.startswith("Peak") else "Filtered " + titles[force][0]
            elif unit == "same x":
                values, unit = np.round(columns[travel], 2), self.xUnit
            elif values is None:
                values = {"Index": t, "No.": t + 1, "Raw counts": np.round(np.asarray(columns[force], float) * 8123 + 51000), "Battery": 87 + 0 * t}[plain]
            columns.insert(place, values), titles.insert(place, (plain, unit))

    def foreign(self):
        draw, n = self.draw, self.draw.choice([30, 120])
        t = np.linspace(0, 1, n)
        self.digits, self.named, self.zero = {}, True, 0
        wave = np.sin(9 * t) + 0.01 * np.random.default_rng(draw.getrandbits(32)).normal(0, 1, n)
        tables = [([100 * t, 23 + wave], [("Time", "s"), ("Temperature", "°C")]),
                  ([100 * t, 5 * t + wave], [("Time", "s"), (draw.choice(FORCE_TITLES), self.yUnit)]),
                  ([100 * t, 4 * np.sin(3 * t)], [("Time", "ms"), (draw.choice(TRAVEL_TITLES), self.xUnit)]),
                  ([10 * t, 400 * t ** 0.5], [("Strain", "%"), ("Stress", "MPa")]),
                  ([4.2 - t, 2900 * t], [("Voltage", "V"), ("Capacity", "mAh")]),
                  ([20 * 10 ** (3 * t), -20 * t], [("Frequency", "Hz"), ("Level", "dB")]),
                  ([np.arange(n), 900 + 30 * wave, 60 + wave], [("Day", ""), ("Pressure", "hPa"), ("Humidity", "%")]),
                  ([1e4 * t, 3 * wave, 9.81 * wave], [("t", "ms"), ("ax", "m/s²"), ("ay", "m/s²")]),
                  ([500 * t, 30 * t], [("Angle", "°"), ("Torque", "N·cm")]),
                  ([12 * t, 40 * t], [("Quantity", ""), ("Price", "EUR")])]
        return draw.choice(tables)

    # -- text ------------------------------------------------------------------------------------------------------

    def preamble(self):
        draw = self.draw
        for _ in range(draw.choices([0, 1, 3, 6, 14], [45, 15, 15, 15, 10])[0]):
            note = draw.choice(NOTES)
            while "{w}" in note:
                note = note.replace("{w}", draw.choice(WORDS), 1)
            self.lines.append(note.format(n=draw.randint(1, 28), k=draw.randint(1000, 99999)))
        if self.lines and draw.random() < 0.6:
            self.lines.append("")

    def heading(self, titles):
        draw = self.draw
        self.place = draw.choices(["bracket", "square", "slash", "underscore", "line", "behind", "in", "missing"], [42, 14, 8, 8, 12, 5, 5, 6])[0]
        self.unitsSaid = self.named and self.place != "missing" and not (self.place == "behind" and self.delimiter == "  ")
        if not self.named:
            return
        form = {"bracket": "{t} ({u})", "square": "{t} [{u}]", "slash": "{t}/{u}", "underscore": "{t}_{u}", "in": "{t} in {u}"}.get(self.place, "{t}")
        cells = [form.format(t=t, u=u) if u else t for t, u in titles]
        if any(self.delimiter in cell for cell in cells):
            cells = ['"' + c + '"' for c in cells]
        self.lines.append(self.delimiter.join(cells))
        if self.place == "line":
            wrap = draw.choice(["{}", "({})", "[{}]"])
            self.lines.append(self.delimiter.join(wrap.format(u) if u else "" for _, u in titles))
        self.units = [u for _, u in titles]

    def cell(self, value, unit):
        if isinstance(value, str):
            return value
        if isinstance(value, (int, np.integer)):
            return str(value)
        digits = self.digits.get(unit, 4)
        text = f"{value:.{digits}f}"
        if float(text) == 0:
            text = text.lstrip("-")
        text = text.replace(".", self.decimal)
        return text + " " + unit if self.named and self.place == "behind" and unit and self.delimiter != "  " else text

    def body(self, columns):
        units = getattr(self, "units", [self.xUnit if i == 0 else self.yUnit for i in range(len(columns))])
        for row in range(len(columns[0])):
            self.lines.append(self.delimiter.join(self.cell(c[row], u) for c, u in zip(columns, units)))

    def after(self, columns):
        draw = self.draw
        if draw.random() > 0.08:
            return
        self.lines.append("")
        for name, of in (("Mean", np.mean), ("Max", np.max)):
            self.lines.append(self.delimiter.join([name] + [self.cell(float(of(c)), "") for c in columns[1:] if not isinstance(c[0], str)]))


def seed_of(draw):
    return draw.getrandbits(30)


# -- judging -------------------------------------------------------------------------------------------------------

def along(points, count=400):
    steps = np.hypot(*np.diff(points, axis=0).T)
    points = points[np.r_[True, steps > 0]]
    s = np.r_[0, np.cumsum(steps[steps > 0])]
    t = np.linspace(0, s[-1], count)
    return np.c_[np.interp(t, s, points[:, 0]), np.interp(t, s, points[:, 1])]


def off(points, line):
    a, v = line[:-1], np.diff(line, axis=0)
    w = points[:, None] - a[None]
    t = np.clip((w * v).sum(2) / np.maximum((v * v).sum(1), 1e-30), 0, 1)
    return np.hypot(*np.moveaxis(w - t[..., None] * v, 2, 0)).min(1).mean()


def distance(truth, found):
    if set(truth) != set(found):
        return 9.0
    span = np.ptp(np.vstack(list(truth.values())), axis=0)
    pairs = [(along(truth[s] / span), along(found[s] / span)) for s in truth]
    return max((off(a, b) + off(b, a)) / 2 for a, b in pairs)


def strokes_in(path):
    strokes = collections.defaultdict(list)
    with open(path, newline="", encoding="utf-8-sig") as file:
        for row in csv.DictReader(file):
            strokes[row["stroke"].strip().lower()].append((float(row["displacement_mm"]), float(row["force_N"])))
    return {name: np.array(points) for name, points in strokes.items() if name in ("press", "release") and len(points) > 1}


def imported(program, path, *options):
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder, "out.csv")
        try:
            run = subprocess.run([program, str(path), "--csv", str(out), "--json", "--sure", "0", "--quality", "draft", "--explain", *options],
                                 capture_output=True, timeout=TIMEOUT_s)
        except subprocess.TimeoutExpired:
            return "hang", {}, None
        try:
            report = json.loads(run.stdout.decode().strip().splitlines()[-1])
        except (ValueError, IndexError):
            report = {}
        return run.returncode, report, strokes_in(out) if run.returncode == 0 and out.exists() else None


def judged(program, seed):
    layout = Layout(seed)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "log.csv")
        path.write_text(layout.text, encoding="utf-8")
        code, report, found = imported(program, path)
        row = {"seed": seed, "kind": layout.kind, "exit": code, "confidence": report.get("confidence"), "problem": report.get("problem"),
               "open": layout.kind != "none" and not layout.unitsSaid}
        best = lambda strokes: min((distance(t, strokes) for t in layout.truths), default=9.0)
        row["sums"] = [round(each["sum"], 3) for each in report.get("interpretations", [])]
        if code == 0:
            row["distance"] = best(found)
            row["wrong"] = not row["distance"] <= WRONG
        choices = (report.get("question") or {}).get("choices", [])
        row["answered"] = False
        for choice in choices if code != 0 else []:
            answered, _, strokes = imported(program, path, *choice["option"].split(" ", 1))
            if answered == 0 and best(strokes) <= WRONG:
                row["answered"] = True
                break
    return row


# -- commands ------------------------------------------------------------------------------------------------------

def table(rows):
    """Lines of the reliability table and of what became of the tables."""
    logs, foreign = [r for r in rows if r["kind"] != "none"], [r for r in rows if r["kind"] == "none"]
    taken = [r for r in rows if r["exit"] == 0]
    lines = ["| confidence | accepted | mean confidence | right | wrong | at most wrong (95 %) |", "|---|---|---|---|---|---|"]
    edges = [0, 0.5, 0.7, 0.8, 0.9, 0.95, 0.98, 0.99, 0.995, 1.0001]
    for low, high in zip(edges, edges[1:]):
        part = [r for r in taken if low <= r["confidence"] < high]
        if part:
            wrong = sum(r["wrong"] for r in part)
            mean = sum(r["confidence"] for r in part) / len(part)
            lines.append(f"| {low:g} to {min(high, 1):g} | {len(part)} | {mean:.3f} | {1 - wrong / len(part):.3f} | {wrong} | {100 * upper_bound(wrong, len(part)):.1f} % |")
    single = [r for r in logs if r["kind"] in ("run", "press", "beside", "labelled")]
    share = lambda part, is_: f"{sum(map(is_, part))} of {len(part)} ({100 * sum(map(is_, part)) / max(1, len(part)):.1f} %)"
    right = lambda r: r["exit"] == 0 and not r["wrong"]
    lines += ["", f"One press, or press and release: {share([r for r in single if not r['open']], right)} right where the units are said, "
              f"{share([r for r in single if r['open']], right)} where they are not.",
              f"All logs: {share(logs, lambda r: right(r) or r['answered'])} right at once or after one answered question.",
              f"No force log: {share(foreign, lambda r: r['exit'] != 0)} refused."]
    ordered = sorted(taken, key=lambda r: r["confidence"])
    wrongs = [r["confidence"] for r in taken if r["wrong"]]
    rights = [r["confidence"] for r in taken if not r["wrong"]]
    if wrongs and rights:
        sorts = np.mean([np.mean(w < np.array(rights)) + 0.5 * np.mean(w == np.array(rights)) for w in wrongs])
        lines.append(f"A wrong one stands below a right one in {100 * sorts:.0f} % of their pairs; {len(set(r['confidence'] for r in ordered))} different values.")
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    seeds = lambda text: range(int(text.split(":")[0]), sum(int(n) for n in text.split(":")))
    drawing = commands.add_parser("draw")
    drawing.add_argument("folder", type=Path)
    drawing.add_argument("seeds", type=seeds)
    counting = commands.add_parser("count")
    counting.add_argument("program")
    counting.add_argument("rows", type=Path)
    counting.add_argument("seeds", type=seeds)
    counting.add_argument("--jobs", type=int, default=os.cpu_count())
    writing = commands.add_parser("write")
    writing.add_argument("rows", nargs="+", type=Path)
    a = parser.parse_args()
    if a.command == "draw":
        for seed in a.seeds:
            layout = Layout(seed)
            (a.folder / f"{seed}-{layout.kind}.csv").write_text(layout.text, encoding="utf-8")
            truths = [{s: p.tolist() for s, p in each.items()} for each in layout.truths]
            (a.folder / f"{seed}-{layout.kind}.truth.json").write_text(json.dumps(truths))
    elif a.command == "count":
        with open(a.rows, "a", encoding="utf-8") as out, concurrent.futures.ThreadPoolExecutor(a.jobs) as jobs:
            for row in jobs.map(lambda seed: judged(a.program, seed), a.seeds):
                out.write(json.dumps(row, ensure_ascii=False) + "\n")
    else:
        rows = [json.loads(line) for path in a.rows for line in path.read_text().splitlines()]
        print("\n".join(table(rows)))


if __name__ == "__main__":
    main()
