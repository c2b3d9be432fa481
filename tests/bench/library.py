#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The library against its bars: reading, figures' errors, search, map, spread, morph.

    library.py [--bin FOLDER] [--clones FOLDER] [--few] [--no-errors] [--out docs/measurements/bench-library.md]

Prints the table, writes it with --out. Draws the laboratories' layouts (switch_logs.py); with --clones also reads public clones in FOLDER (force-curves-tidy,
Open-Switch-Curve-Meter, topre-force-curves, switch-force-tester; none is needed, nothing of them is kept). --few: a tenth of everything, to try the script. --no-errors: without the figures'
errors, which docs/develop/decisions/0813 has by the same buttons. Times are of the processor,
of all threads together: bars of two cores are met at twice the wall clock. --bin: default build/release/bin."""

import argparse
import json
import math
import os
import random
import sqlite3
import subprocess
import sys
import tempfile
import threading
import time
from itertools import combinations
from pathlib import Path

import figure_truths as truths
import switch_logs as logs

ROOT = Path(__file__).resolve().parent.parent.parent
SURE = {"68": 1.0, "95": 1.959964}
FIGURES = ("initial_force_N total_travel_mm end_force_N press_work_mJ hysteresis_mJ bottom_out_force_N bottom_out_travel_mm slope_to_peak_N_per_mm peak_force_N peak_travel_mm "
           "valley_force_N valley_travel_mm drop_N snap_ratio slope_of_drop_N_per_mm slope_to_bottom_out_N_per_mm pre_travel_mm operating_force_N over_travel_mm reset_travel_mm "
           "reset_force_N differential_travel_mm").split()


def run(*words, env=None):
    """Output and processor seconds, largest memory in MB of a program."""
    process = subprocess.Popen([str(w) for w in words], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, env=env)
    peak_kB = []
    watch = threading.Thread(target=watch_memory, args=(process.pid, peak_kB))
    watch.start()
    out = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    watch.join()
    process.stdout.close()
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        sys.exit(f"{' '.join(map(str, words[:4]))} …: exit {process.returncode}")
    return out.decode(), usage.ru_utime + usage.ru_stime, max(peak_kB, default=0) / 1024


def watch_memory(pid, peak_kB):
    """The program's own high water until it ends: what wait4 tells holds this script's memory too, from before the program was loaded."""
    while True:
        try:
            lines = Path(f"/proc/{pid}/status").read_text().splitlines()
        except OSError:
            return
        high = [line for line in lines if line.startswith("VmHWM")]
        if not high:
            return  # it has ended and is not yet waited for
        peak_kB.append(int(high[0].split()[1]))
        time.sleep(0.02)


class Bench:
    def __init__(self, bin_folder, folder, few):
        self.import_, self.play = bin_folder / "detent-import", bin_folder / "detent-play"
        self.bin, self.folder, self.few = bin_folder, folder, few
        self.lines = []

    def of(self, count):
        return max(3, count // 10) if self.few else count

    def say(self, line=""):
        print(line, flush=True)
        self.lines.append(line)

    def row(self, what, bar, measured):
        self.say(f"| {what} | {bar} | {measured} |")

    def index(self, database, *folders):
        out, cpu_s, memory_MB = run(self.import_, "library", "index", *folders, "--db", database, "--json")
        return json.loads(out), cpu_s, memory_MB

    def find(self, database, *words, limit=100000):
        return json.loads(run(self.import_, "library", "find", "--db", database, "--limit", limit, "--json", *words)[0])["found"]

    # ---- layouts

    def draw(self, folder):
        """The layouts of seven kinds of files, as many as the public sets have."""
        kinds = {"force-curves-tidy": self.of(1107), "sheets, headings in one line": self.of(151), "sheets, headings in two": self.of(152),
                 "dome runs": self.of(331), "Geekboards": self.of(60), "raw CSV": self.of(40), "high resolution": self.of(20)}
        seed = 0
        for kind, count in kinds.items():
            where = folder / kind.replace(",", "").replace(" ", "-")
            where.mkdir(parents=True)
            for i in range(count):
                seed += 1
                switch, draw = logs.drawn(seed if kind != "dome runs" else 100000 + seed // 4)
                meter = logs.Meter(draw)
                name = f"Maker Model {seed}"
                if kind == "force-curves-tidy":
                    logs.write_tidy(where / f"{name}__{name} Raw Data CSV.csv", switch, meter, name)
                elif kind.startswith("sheets"):
                    logs.write_open_switch(where / f"{name.replace(' ', '-')}.ods", switch, meter, kind.endswith("one line"))
                elif kind == "dome runs":
                    at = where / f"Dome_{seed // 4}g"
                    at.mkdir(exist_ok=True)
                    logs.write_dome_run(at / f"DataLog_{seed % 4 + 1}.csv", switch, meter)
                elif kind == "Geekboards":
                    logs.write_geekboards(where / f"{name}.json", switch, meter)
                elif kind == "raw CSV":
                    logs.write_raw(where / f"{name} Raw Data CSV.csv", switch, meter)
                else:
                    logs.write_high_resolution(where / f"{name.replace(' ', '_')}_HighResolutionRaw.csv", switch, meter)
        return kinds

    def layouts(self):
        folder, database = self.folder / "drawn", self.folder / "drawn.db"
        kinds = self.draw(folder)
        summary, cpu_s, memory_MB = self.index(database, folder)
        again, again_s, _ = self.index(database, folder)
        files = sum(kinds.values())
        self.say("\n## Reading\n\n| layouts drawn (`switch_logs.py`) | bar | measured |\n|---|---|---|")
        self.row(f"{files} files: " + ", ".join(f"{n} {k}" for k, n in kinds.items()), "98 % imported", f"**{100 * summary['imported'] / files:.1f} %**")
        self.row("processor time, all threads", "60 s (30 s on two cores)", f"**{cpu_s:.1f} s**, {1e3 * cpu_s / files:.1f} ms a file")
        self.row("second run", "2 s (1 s on two cores)", f"**{again_s:.2f} s**, {100 * again_s / cpu_s:.1f} % of the first; {again['unchanged']} unchanged")
        size_MB = database.stat().st_size / 1e6
        self.row(f"memory, file ({summary['switches']} switches)", "60 MB each for 1,500", f"**{memory_MB:.0f} MB**, **{size_MB:.1f} MB**")
        domes = {e["name"]: e for e in self.find(database) if "dome-runs" in e["source"]}
        grouped = sum(e["records"] > 1 and e["spread_peak_force_N"] is not None or e["peak_force_N"] is None for e in domes.values())
        self.row("runs of one dome told as records of one switch, with their spread", "", f"{grouped} of {len(domes)} domes")
        doubted = [e for e in self.find(database) if "Geekboards" in e["source"]]
        self.row("Geekboards' rows with a warning of their scale", "all", f"{sum(e['scale_doubtful'] for e in doubted)} of {len(doubted)}")
        return database

    def clones(self, clones):
        measured = {"force-curves-tidy": ("data", ".csv"), "Open-Switch-Curve-Meter": ("Force curve measurements", ".ods"), "topre-force-curves": ("", ".csv"),
                    "switch-force-tester": ("python-app/results", ".json")}
        there = {name: where for name, where in measured.items() if (clones / name).is_dir()}
        if not there:
            return
        database = self.folder / "clones.db"
        summary, cpu_s, memory_MB = self.index(database, *(clones / name for name in there))
        again_s = self.index(database, *(clones / name for name in there))[1]
        self.say("\n| public clones | bar | measured |\n|---|---|---|")
        refused = [r["file"] for r in summary["refusals"]]
        files = imported = 0
        for name, (where, ending) in there.items():
            folder = clones / name / where
            own = [f for f in folder.rglob("*" + ending) if "Blank template" not in str(f) and "/." not in str(f)]
            no = sum(Path(r) in set(own) for r in refused)
            files, imported = files + len(own), imported + len(own) - no
            self.row(f"{name}: {len(own)} files of measurements", "98 % imported", f"{100 * (1 - no / len(own)):.1f} %")
        self.row(f"all {files}", "98 % imported", f"**{100 * imported / files:.1f} %**")
        self.row("processor time, all threads; second run", "60 s; 2 s", f"**{cpu_s:.1f} s**; **{again_s:.2f} s**")
        self.row(f"memory, file ({summary['switches']} switches)", "60 MB each for 1,500", f"**{memory_MB:.0f} MB**, **{database.stat().st_size / 1e6:.1f} MB**")
        if (self.bin / "library_bench").exists() and len(there) >= 2:
            only = self.folder / "two.db"
            self.index(only, clones / "force-curves-tidy", clones / "Open-Switch-Curve-Meter")
            self.say("\n## The same switch from the other laboratory\n\nAsked: top ten 80 %, median rank 3. ")
            self.say("<!-- library_bench -->\n" + run(self.bin / "library_bench", only)[0].rstrip() + "\n<!-- /library_bench -->")

    # ---- figures

    def coverage(self):
        """Buttons of known figures with a meter's noise, half of them as sheets with contact points."""
        self.say("\n## Errors of the figures\n\nButtons whose curve is known everywhere, their figures by numpy on a grid of 0.1 µm (`figure_truths.py`), as a meter of 0.15 gf noise, 0.1 gf and 5 µm resolution logs them. "
                 "*drawn*: bumps whose bend jumps at the top;\n*smooth*: logistic collapses; *threaded*: monotone cubics through random places, which nothing was chosen on. In the last two, half with noise that is carried on from "
                 "sample to sample. Asked: 68 and 95 % of truths within\n1 and 1.96 standard errors, ± 5. Error: what 68 % are below.")
        kinds = {"drawn": logs.Switch, "smooth": truths.SmoothSwitch, "threaded": truths.ThreadedSwitch}
        self.say("\n| figure |" + "".join(f" {kind}: N | 68 % | 95 % | error |" for kind in kinds) + "\n|---|" + 4 * len(kinds) * "---|")
        off = {kind: self.off(kind, of, 500000 + 100000 * i) for i, (kind, of) in enumerate(kinds.items())}
        for key in FIGURES:
            self.say(f"| `{key}` |" + "".join(f" {covered(off[kind][key])}" for kind in kinds))
        self.say("| **all** |" + "".join(f" {covered(sum(off[kind].values(), []))}" for kind in kinds))
        self.say("| outside ± 5 at either; by more than 10 |" + "".join(f" {outside(off[kind], 5)} of {len(FIGURES)}; {outside(off[kind], 10)} | | | |" for kind in kinds))

    def off(self, kind, of, seed):
        """Of every figure, what each button's is off and its standard error; a figure that was not told, or without an error, is a miss."""
        folder, database = self.folder / f"known-{kind}", self.folder / f"known-{kind}.db"
        folder.mkdir()
        known = {}
        for i in range(self.of(400)):
            draw = random.Random(seed + i)
            switch = of(draw)
            meter = (truths.CarryingMeter if kind != "drawn" and i % 4 >= 2 else logs.Meter)(draw)
            name = f"sw{i:04}"
            known[name] = truths.figures_of(switch)
            if i % 2:
                logs.write_open_switch(folder / f"{name}.ods", switch, meter, True)
                known[name].update(truths.contact_figures_of(switch))
            else:
                logs.write_tidy(folder / f"{name}.csv", switch, meter, name)
        self.index(database, folder)
        off = {key: [] for key in FIGURES}
        for each in self.find(database):
            for key, truth in known[each["name"]].items():
                told = each[key] is not None and each["sigma_" + key] is not None
                off[key].append((each[key] - truth, each["sigma_" + key]) if told else (math.inf, 1))
        return off

    # ---- 5,000

    def five_thousand(self, database):
        """Rows of the drawn library over and over, under other names, until there are 5,000."""
        many = self.folder / "many.db"
        many.write_bytes(database.read_bytes())
        with sqlite3.connect(many) as rows:
            columns = [r[1] for r in rows.execute("PRAGMA table_info(switch)")][2:]
            while (count := rows.execute("SELECT count(*) FROM switch").fetchone()[0]) < 5000:
                take = min(count, 5000 - count)
                shift, more = (rows.execute(f"SELECT max(id) FROM {table}").fetchone()[0] for table in ("file", "switch"))
                rows.execute(f"INSERT INTO file SELECT id + {shift}, path || 'x{shift}', bytes, modified_ns, looked_ns, sha256, version, refused_code, refused_reason, gone FROM file")
                named = ", ".join(f"name || ' {shift}'" if c == "name" else c for c in columns)
                rows.execute(f"INSERT INTO switch (id, file, {', '.join(columns)}) SELECT id + {more}, file + {shift}, {named} FROM switch ORDER BY id LIMIT {take}")
                rows.execute(f"INSERT INTO curve SELECT switch + {more}, travel_mm, press, release FROM curve ORDER BY switch LIMIT {take}")
        like = next((self.folder / "drawn" / "force-curves-tidy").iterdir())
        self.say("\n## 5,000 switches\n\n| what | bar | measured |\n|---|---|---|")
        seconds = sorted(run(self.import_, "library", "find", "--db", many, "--like", like)[1] for _ in range(5))[2]
        self.row("`library find --like`, the whole program: start, reading the log, the file and the curves of like travel", "50 ms", f"**{1e3 * seconds:.0f} ms**")
        if (self.bin / "measured_bench").exists():
            out = run(self.bin / "measured_bench", many, env={**os.environ, "QT_QPA_PLATFORM": "offscreen"})[0]
            for what, value in (line.split("\t") for line in out.splitlines()[1:]):
                self.row(f"window: {what}", "50 ms", f"**{float(value):.0f} ms**")

    def hundred_thousand(self):
        folder, database, count = self.folder / "full", self.folder / "full.db", self.of(100000)
        folder.mkdir()
        for i in range(count):
            (folder / f"n{i}.csv").write_text("no,measurement\n")
        summary, cpu_s, memory_MB = self.index(database, folder)
        again_s = self.index(database, folder)[1]
        self.row(f"{count:,} files that are none in one folder", "each refused with its reason", f"{summary['refused']:,} refused; {cpu_s:.0f} s, {memory_MB:.0f} MB; again {again_s:.1f} s")

    # ---- morph

    def morph(self):
        """Between all pairs of the sample buttons, and pairs of drawn ones."""
        buttons = sorted((ROOT / "samples/buttons").glob("[A-E].button.json"))
        drawn = []
        for i in range(8 if self.few else 16):
            switch, draw = logs.drawn(700000 + i)
            log, out = self.folder / f"m{i}.csv", self.folder / f"m{i}.button.json"
            logs.write_tidy(log, switch, logs.Meter(draw), "m")
            run(self.import_, log, "-o", out)
            drawn.append(out)
        self.say("\n## Between two buttons\n\n| pairs | bar | measured |\n|---|---|---|")
        middle = self.folder / "middle.button.json"
        for name, pairs in (("sample buttons A to E", list(combinations(buttons, 2))), ("drawn switches", list(zip(drawn[::2], drawn[1::2])))):
            answers = [json.loads(run(self.play, "between", a, b, "-o", middle, "--json")[0]) for a, b in pairs]
            equal = sum(abs(a["d_prime_from"] - a["d_prime_to"]) <= 0.05 * max(a["d_prime_from"], a["d_prime_to"]) for a in answers)
            ends = 0.0
            for (a, b) in pairs:
                for at, end in ((0, a), (1, b)):
                    run(self.play, "between", a, b, "--at", at, "-o", middle, "--json")
                    ends = max(ends, farthest(json.loads(end.read_text()), json.loads(middle.read_text())))
            self.row(f"{len(pairs)} of {name}: halves of d' within 5 %", "all", f"**{equal}**")
            self.row("the same: ends, largest difference of a knot's number", "1e-9", f"**{ends:.1g}**")


def farthest(a, b):
    """Largest difference of two buttons' knots."""
    def numbers(value, key=""):
        if isinstance(value, dict):
            return [n for k, v in value.items() if k not in ("provenance", "name", "version") for n in numbers(v, k)]
        if isinstance(value, list):
            return [n for v in value for n in numbers(v, key)]
        return [float(value)] if isinstance(value, (int, float)) and not isinstance(value, bool) else []
    first, second = numbers(a.get("states", a)), numbers(b.get("states", b))
    return max((abs(x - y) for x, y in zip(first, second)), default=0) if len(first) == len(second) else math.inf


def share(pairs, level):
    return f"{100 * sum(abs(d) <= SURE[level] * s for d, s in pairs) / len(pairs):.1f}"


def outside(off, by):
    """Figures whose coverage misses 68.3 or 95 % by more."""
    return sum(any(abs(float(share(pairs, level)) - asked) > by for level, asked in (("68", 68.3), ("95", 95))) for pairs in off.values() if pairs)


def covered(pairs):
    if not pairs:
        return "0 | | | |"
    within = sorted(abs(d) for d, _ in pairs)
    return f"{len(pairs)} | {share(pairs, '68')} | {share(pairs, '95')} | {within[int(0.683 * len(within))]:.2g} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=Path, default=ROOT / "build/release/bin")
    parser.add_argument("--clones", type=Path)
    parser.add_argument("--few", action="store_true")
    parser.add_argument("--no-errors", action="store_true")
    parser.add_argument("--out", type=Path)
    options = parser.parse_args()
    random.seed(29)
    with tempfile.TemporaryDirectory(prefix="detent-library-bench-") as folder:
        bench = Bench(options.bin.resolve(), Path(folder), options.few)
        bench.say("# The library against its bars\n\nPrinted by one command, which draws everything it needs; clones of public sets are read where they are given:\n\n"
                  "    tests/bench/library.py --clones FOLDER --out docs/measurements/bench-library.md\n\nTimes are of the processor, all threads together. Killed at any moment, two indexers at once, a full disk, a file "
                  "that changes meanwhile, names in any\nscript, damaged or other databases, hostile archives and tables: `library_test`.")
        database = bench.layouts()
        if options.clones:
            bench.clones(options.clones.resolve())
        if options.no_errors:
            bench.say("\n## Errors of the figures\n\nBy kind of curve, on seeds that nothing was chosen on: [0813](../develop/decisions/0813-errors-of-library-figures.md).")
        else:
            bench.coverage()
        bench.five_thousand(database)
        bench.hundred_thousand()
        bench.morph()
        if options.out:
            options.out.write_text("\n".join(bench.lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
