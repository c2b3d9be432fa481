#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What import detent costs beside the library and the programs, by Debian's Python.

    /usr/bin/python3 tests/bench/python_module.py [--build FOLDER] [--only WORDS] [--write]

Prints tables; --write: docs/measurements/bench-python.md, of which only the sections that ran are renewed. --only: sections
whose name contains one of these words, separated by commas. Times of both sides
are taken in turn, so that a busy machine slows both; the least of several counts. Memory is the resident set, each figure from a Python of
its own. Needs a build with DETENT_WITH_PYTHON (preset release).
"""

import argparse
import json
import os
import random
import resource
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
PAGE = ROOT / "docs/measurements/bench-python.md"
PLOTS, BUTTONS = ROOT / "samples/plots", ROOT / "samples/buttons"
LOG, PICTURE, SHEET = PLOTS / "force-meter-log.csv", PLOTS / "two-level-legend.png", PLOTS / "white-vector.pdf"
READABLE = (".png", ".pdf", ".svg", ".csv")
BUILD = ROOT / "build/release"

PREAMBLE = """
import gc, json, os, sys, time
import detent
def resident_kB():
    gc.collect()
    return int(next(line for line in open("/proc/self/status") if line.startswith("VmRSS")).split()[1])
"""


def python(code, *words):
    """What a Python of its own prints as JSON."""
    done = subprocess.run([sys.executable, "-c", PREAMBLE + code, *map(str, words)], env={**os.environ, "PYTHONPATH": str(BUILD / "python")},
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(done.stderr[-2000:])
    return json.loads(done.stdout)


def program(name, *words):
    return subprocess.run([BUILD / "bin" / name, *map(str, words)], capture_output=True, text=True, check=False)


# ---- a call

CALLS = """
import statistics
def median_ms(call, count):
    took = []
    for _ in range(count):
        begun = time.process_time()
        call()
        took.append(1000 * (time.process_time() - begun))
    return statistics.median(took)
path, count = sys.argv[1], int(sys.argv[2])
print(json.dumps(median_ms(lambda: detent.read(path), count)))
"""
SMALL_CALLS = """
import statistics
def median_us(call, count=2000):
    took = []
    for _ in range(count):
        begun = time.perf_counter()
        call()
        took.append(1e6 * (time.perf_counter() - begun))
    return statistics.median(took)
button = detent.load(sys.argv[1])
def refused():
    try:
        detent.read("/nowhere/page.png")
    except detent.UnreadableInput:
        pass
print(json.dumps({
    "`read` of a file that is not there": median_us(refused), "`load`": median_us(lambda: detent.load(sys.argv[1])),
    "`figures`": median_us(button.figures), "`press` of a loaded button": median_us(lambda: detent.Button.from_json(text).press) if (text := button.to_json()) else 0,
    "`edited`": median_us(lambda: button.edited(detent.edits.scale_force(1.1))), "`svg`": median_us(button.svg)}))
"""


def calls():
    yield "## What a call costs over the library"
    yield ""
    yield "Processor time (all threads) of reading the same file by the library alone (`read_bench`) and by `detent.read`, the least of seven medians each, in turn. Asked: at most 1 ms over it."
    yield ""
    yield "| file | library, ms | `detent.read`, ms | over it, ms |"
    yield "|---|---|---|---|"
    for path, count in ((LOG, 40), (SHEET, 10), (PICTURE, 7)):
        alone, module = [], []
        for _ in range(7):
            alone.append(float(subprocess.run([BUILD / "bin/read_bench", path, str(count)], capture_output=True, text=True, check=True).stdout))
            module.append(python(CALLS, path, count))
        yield f"| `{path.name}` | {min(alone):.2f} | {min(module):.2f} | {min(module) - min(alone):.2f} |"
    yield ""
    yield "Calls that compute little, whole, by the clock: " + ", ".join(f"{name} {us:.0f} µs" for name, us in python(SMALL_CALLS, BUTTONS / "C.button.json").items()) + "."


# ---- memory

THOUSAND = """
path = sys.argv[1]
made = (lambda: detent.read(path)) if sys.argv[2] == "read" else (lambda: detent.load(path))
kept = [made() for _ in range(20)]
for each in kept: each.press, each.release, each.figures()
before = resident_kB()
for _ in range(1000):
    kept.append(made())
    kept[-1].press, kept[-1].release, kept[-1].figures()
print(json.dumps((resident_kB() - before) / 1024))
"""
LEAK = """
path, hints = sys.argv[1], {"quality": "draft"} if sys.argv[1].endswith("png") else {}
total = int(sys.argv[2])
seen = []
for number in range(total):
    try:
        detent.read(path, **hints)
    except detent.Failure:
        pass
    if number + 1 in (total // 10, total // 2, total):
        seen.append(resident_kB() / 1024)
print(json.dumps(seen))
"""


def memory():
    yield "## Memory"
    yield ""
    yield "1,000 buttons kept, curves and figures asked for (asked: at most 50 MB): " + ", ".join(
        f"{python(THOUSAND, path, how):.1f} MB {words}" for path, how, words in
        ((BUTTONS / "C.button.json", "load", "from button files"), (LOG, "read", "read from a log, reports kept"))) + "."
    yield ""
    yield "Reads one after another, nothing kept; resident memory after a tenth, half and all of them:"
    yield ""
    yield "| what | reads | MB after a tenth | half | all |"
    yield "|---|---|---|---|---|"
    with tempfile.TemporaryDirectory() as folder:
        broken = Path(folder, "broken.png")
        broken.write_text("not a picture")
        for words, path, total in (("a log", LOG, 10000), ("a picture that is none", broken, 10000), ("a page, SVG", PLOTS / "black-inch-ounce.svg", 1000),
                                   ("a picture, draft", PICTURE, 300)):
            tenth, half, whole = python(LEAK, path, total)
            yield f"| {words} | {total} | {tenth:.1f} | {half:.1f} | {whole:.1f} |"


# ---- many

MANY = """
paths = sys.argv[1:]
begun, cpu = time.perf_counter(), time.process_time()
got = list(detent.import_many(paths, jobs=2))
print(json.dumps([time.perf_counter() - begun, time.process_time() - cpu, sum(isinstance(each, detent.Button) for _, each in got)]))
"""


def batch(paths, folder):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    begun = time.perf_counter()
    program("detent-import", "--batch", *paths, "--out-dir", folder, "--jobs", "2")
    took = time.perf_counter() - begun
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return took, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def many():
    yield "## Many files on two cores"
    yield ""
    yield "The same files by `import_many(jobs=2)` and by `detent-import --batch --jobs 2`, five times in turn (asked: at most 5 % slower). `--batch` writes files besides; to start Python is not counted."
    yield ""
    yield "| files | `--batch`, s | `import_many`, s | slower by | processor, s | processor, s | more by |"
    yield "|---|---|---|---|---|---|---|"
    plots = [path for path in sorted(PLOTS.iterdir()) if path.suffix in READABLE]
    with tempfile.TemporaryDirectory() as folder:
        for words, sources, copies in (("all samples, 6 copies", plots, 6), ("a log, 200 copies", [LOG], 200)):
            paths = []
            for source in sources:
                for number in range(copies):
                    paths.append(Path(folder, f"{source.stem}-{number}{source.suffix}"))
                    shutil.copy(source, paths[-1])
            ours, theirs = [], []
            for turn in range(5):
                theirs.append(batch(paths, Path(folder, f"out-{turn}")))
                shutil.rmtree(Path(folder, f"out-{turn}"))
                ours.append(python(MANY, *paths)[:2])
            (wall, cpu), (batch_wall, batch_cpu) = ([min(times) for times in zip(*each)] for each in (ours, theirs))
            yield (f"| {words} | {batch_wall:.2f} | {wall:.2f} | {100 * (wall / batch_wall - 1):+.1f} % | {batch_cpu:.2f} | {cpu:.2f} | "
                   f"{100 * (cpu / batch_cpu - 1):+.1f} % |")


# ---- Ctrl-C

INTERRUPTED = """
import threading, signal
buttons = [detent.load(f"{sys.argv[2]}/{name}.button.json") for name in "ABCDEF"]
plots = sys.argv[3:]
def many_times(call):
    def repeat():
        while True: call()
    return repeat
what = {"read, picture": many_times(lambda: detent.read(plots[0], quality="precise")), "read, PDF": many_times(lambda: detent.read(plots[1])),
        "import_many": many_times(lambda: list(detent.import_many(plots * 20, jobs=2))),
        "render": many_times(lambda: detent.render(buttons[1])),
        "confusion": many_times(lambda: detent.confusion(*buttons)), "performance": many_times(lambda: detent.performance(*buttons))}[sys.argv[1]]
took = []
import random
random.seed(7)
for _ in range(20):
    sent = []
    def send():
        sent.append(time.perf_counter())
        os.kill(os.getpid(), signal.SIGINT)
    threading.Timer(random.uniform(0.05, 1.0), send).start()
    try:
        what()
    except KeyboardInterrupt:
        took.append(1000 * (time.perf_counter() - sent[0]))
print(json.dumps(took))
"""


def interrupts():
    yield "## Ctrl-C"
    yield ""
    yield "From the signal to the exception in Python, 20 times at any moment of the call (asked: within 500 ms):"
    yield ""
    yield "| call | median, ms | longest, ms |"
    yield "|---|---|---|"
    for what in ("read, picture", "read, PDF", "import_many", "render", "confusion", "performance"):
        took = python(INTERRUPTED, what, BUTTONS, PICTURE, SHEET, LOG)
        yield f"| {what} | {statistics.median(took):.0f} | {max(took):.0f} |"


# ---- agreement

def without_times(report):
    return {key: value for key, value in report.items() if key not in ("seconds", "outputs")}


AGREE = """
results = []
for path in sys.argv[2:]:
    try:
        button = detent.read(path, quality=sys.argv[1])
        results.append([button.report, button.to_json()])
    except detent.Failure as failure:
        results.append([failure.report, str(failure)])
print(json.dumps(results))
"""


def agreement():
    yield "## The programs' numbers"
    yield ""
    yield "Every sample plot at every quality: report without times, and button file or refusal, by `detent.read` and by `detent-import`."
    yield ""
    plots = [path for path in sorted(PLOTS.iterdir()) if path.suffix in READABLE]
    same = compared = 0
    with tempfile.TemporaryDirectory() as folder:
        for quality in ("draft", "standard", "precise"):
            for path, (report, text) in zip(plots, python(AGREE, quality, *plots)):
                out = Path(folder, "x.button.json")
                ran = program("detent-import", path, "-o", out, "--quality", quality, "--json")
                told = json.loads(ran.stdout)
                compared += 1
                same += without_times(report) == without_times(told) and text == (out.read_text() if ran.returncode == 0 else told["problem"])
    yield f"Equal to the last bit: {same} of {compared}. What else is computed of buttons: `tests/editor/python/module_test.py`."


HEAD = """# What the Python module costs

Made by `/usr/bin/python3 tests/bench/python_module.py --write`, on two cores; times of a busy machine are the upper end."""
SECTIONS = {"agreement": agreement, "call": calls, "memory": memory, "many": many, "interrupts": interrupts}


def main():
    global BUILD
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--build", type=Path, default=BUILD)
    parser.add_argument("--only", default="")
    parser.add_argument("--write", action="store_true")
    arguments = parser.parse_args()
    BUILD = arguments.build.resolve()
    if not list((BUILD / "python/detent").glob("_core*.so")):
        sys.exit(f"python_module.py: {BUILD} has no module; build with DETENT_WITH_PYTHON=ON, or give --build.")
    kept = sections_of(PAGE.read_text()) if PAGE.is_file() else {}
    for name, section in SECTIONS.items():
        if arguments.only and not any(word in name for word in arguments.only.split(",")):
            continue
        lines = []
        for line in section():
            print(line, flush=True)
            lines.append(line)
        kept[lines[0]] = "\n".join(lines).strip()
        if arguments.write:
            PAGE.write_text("\n\n".join([HEAD, *kept.values()]) + "\n")


def sections_of(text):
    """What the page says already, by title."""
    parts = ["## " + part.strip() for part in text.split("\n## ")[1:]]
    return {part.split("\n", 1)[0]: part for part in parts}


if __name__ == "__main__":
    main()
