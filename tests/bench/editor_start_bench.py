#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How long detent-edit takes to a window one can use, and how much memory it holds. Under Xvfb with openbox.

    editor_start_bench.py --bin FOLDER [--runs 15] [--pdf FILE]

A window counts as usable when its menus are drawn, its event loop answers and the button given is shown: the report of
its widgets is written by that loop. --pdf also opens a document in the import dialogue and prints the memory it ends with.
Bars: start <= 1 s warm; <= 400 MB with a 40-page PDF.
"""

import argparse
import os
import statistics
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "editor/e2e"))
from desktop import Desktop, Editor, wait_for  # noqa: E402


def memory_MB(process):
    """Resident now, and the largest it ever was."""
    values = {}
    for line in Path(f"/proc/{process.pid}/status").read_text().splitlines():
        key, _, value = line.partition(":")
        if key in ("VmRSS", "VmHWM"):
            values[key] = int(value.split()[0]) / 1024
    return values["VmRSS"], values["VmHWM"]



def processor_s(process):
    """Time the program itself has computed: what a start would cost on a machine with nothing else to do."""
    fields = Path(f"/proc/{process.pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def start(desktop, program, files, name):
    before = time.monotonic()
    editor = Editor(desktop, program, files)
    editor.widget(name, patience_s=60)
    return editor, time.monotonic() - before


def measure_starts(desktop, program, files, name, runs):
    times, computed, memories = [], [], []
    for _ in range(runs + 1):
        editor, seconds = start(desktop, program, files, name)
        times.append(seconds)
        computed.append(processor_s(editor.process))
        memories.append(memory_MB(editor.process)[0])
        editor.kill()
    return times[1:], computed[1:], memories[1:]  # the first one warms the disk's cache


def report(what, times, computed, memories):
    times = sorted(times)
    print(f"{what}: median {statistics.median(times):.2f} s, slowest {times[-1]:.2f} s of {len(times)}; "
          f"computing {statistics.median(computed):.2f} s; {statistics.median(memories):.0f} MB; "
          f"load of the machine {os.getloadavg()[0]:.1f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--bin", type=Path, required=True)
    parser.add_argument("--runs", type=int, default=15)
    parser.add_argument("--pdf", type=Path)
    arguments = parser.parse_args()
    program = arguments.bin.resolve() / "detent-edit"
    root = Path(__file__).resolve().parents[2]
    with tempfile.TemporaryDirectory(prefix="detent-bench-") as folder, Desktop(folder) as desktop:
        report("empty window", *measure_starts(desktop, program, [], "welcomePage", arguments.runs))
        button = root / "samples/buttons/B.button.json"
        report("with a button", *measure_starts(desktop, program, [button], "graphCanvas", arguments.runs))
        if arguments.pdf:
            editor, seconds = start(desktop, program, [arguments.pdf.resolve()], "importDialog")
            wait_for("the import", lambda: editor.find("import", "importDialog", enabled=True), 300)
            time.sleep(5)  # thumbnails of the other pages
            now, most = memory_MB(editor.process)
            print(f"{arguments.pdf.name}: dialogue after {seconds:.2f} s; {now:.0f} MB held, {most:.0f} MB at most")
            editor.kill()
    return 0


if __name__ == "__main__":
    sys.exit(main())
