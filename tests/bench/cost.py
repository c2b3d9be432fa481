#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What fixed jobs cost: instructions (valgrind's callgrind, whole process), shared libraries loaded, peak memory.

    cost.py [--bin FOLDER] [--only WORDS] [--check | --accept]

Without an option: prints the table. --accept: writes tests/bench/cost.json and docs/measurements/bench-cost.md. --check: compares with cost.json and
fails where a job costs more than 5 % beyond it, unless the newest section of CHANGELOG.md names the job as `cost: JOB`. --only: jobs whose
name contains one of these words, separated by commas. --bin: default build/release/bin.

Instructions do not depend on how loaded a machine is; they depend on the processor's instruction sets (libraries choose their code by them),
so a count is compared only with one of the same sets (cost.json says which), and a little on the versions of the libraries.
A job whose program is not there (built without devices or editor) is said to be skipped.
"""

import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
from dataclasses import asdict, dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
BASELINE = ROOT / "tests/bench/cost.json"
TABLE = ROOT / "docs/measurements/bench-cost.md"
CHANGELOG = ROOT / "CHANGELOG.md"
ALLOWED_RISE = 0.05
INSTRUCTION_SETS = ("sse4_2", "avx", "avx2", "fma")  # what libraries choose by, as far as valgrind passes it on

SAMPLES = ROOT / "samples"
PICTURE, PAGE, LOG = (str(SAMPLES / "plots" / name) for name in ("two-level-legend.png", "white-vector.pdf", "force-meter-log.csv"))
B = str(SAMPLES / "buttons/B.button.json")
A = str(SAMPLES / "buttons/A.button.json")

# Name and command line; outputs go to the folder the job runs in.
JOBS = {
    "import of a picture": ["detent-import", PICTURE, "-o", "out.button.json"],
    "import of a picture, draft": ["detent-import", PICTURE, "-o", "out.button.json", "--quality", "draft"],
    "import of a picture, precise": ["detent-import", PICTURE, "-o", "out.button.json", "--quality", "precise"],
    "import of a vector page": ["detent-import", PAGE, "-o", "out.button.json"],
    "import of a log": ["detent-import", LOG, "-o", "out.button.json"],
    "list of a page": ["detent-import", "--list", PAGE],
    "start of the importer": ["detent-import", "--version"],
    "check of a button": ["detent-graph", "check", B],
    "conversion to CSV": ["detent-graph", "convert", B, "out.csv"],
    "rendering of a press": ["detent-play", "render", B, "--standard-press", "-o", "out.wav"],
    "a second of force, simulated": ["detent-play", "force", B, "--device", "sim:falcon", "--seconds", "1", "--fast"],
    "forecast of a pair": ["detent-play", "confusion", A, B],
    "start of the editor": ["detent-edit", "--version"],
}


@dataclass(frozen=True)
class Cost:
    instructions: int
    libraries: int
    memory_MB: float


def measured(command, folder):
    """The cost of one command line; what it prints is dropped. Raises RuntimeError where it does not end with 0."""
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "LC_ALL": "C.UTF-8", "OMP_THREAD_LIMIT": "1"}
    def run(prefix, **extra):
        done = subprocess.run([*prefix, *command], cwd=folder, env={**environment, **extra}, capture_output=True, text=True, stdin=subprocess.DEVNULL)
        if done.returncode != 0:
            raise RuntimeError(f"{' '.join(command)} ended with {done.returncode}: {done.stderr[-300:]}")
        return done.stderr
    counted = run(["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null"])
    libraries = len(set(re.findall(r"calling init: (\S+)", run([], LD_DEBUG="files"))))
    memory_kB = run(["/usr/bin/time", "-f", "peak %M"]).rsplit("peak ", 1)[1]
    return Cost(int(re.search(r"Collected : (\d+)", counted)[1]), libraries, round(int(memory_kB) / 1024, 1))


def measure_all(binaries, words):
    costs = {}
    for name, (program, *arguments) in JOBS.items():
        if words and not any(word in name for word in words):
            continue
        if not (binaries / program).is_file():
            print(f"SKIPPED {name}: {program} is not in {binaries}")
            continue
        with tempfile.TemporaryDirectory() as folder:
            costs[name] = measured([str(binaries / program), *arguments], folder)
        print(row(name, costs[name]), flush=True)
    return costs


def row(name, cost):
    return f"| {name} | {cost.instructions / 1e6:.0f} | {cost.libraries} | {cost.memory_MB:.0f} |"


def instruction_sets():
    """Those of this processor, in a word."""
    flags = re.search(r"^flags\s*:(.*)$", Path("/proc/cpuinfo").read_text(), re.M)
    return " ".join(name for name in INSTRUCTION_SETS if flags and name in flags[1].split())


def excused():
    """Jobs that the newest section of the changelog announces as costing more."""
    newest = CHANGELOG.read_text().split("\n## ", 2)[1]
    return set(re.findall(r"`cost: ([^`]+)`", newest))


def check(costs):
    """Lines about every change; True if none is a rise that nobody announced."""
    kept = json.loads(BASELINE.read_text())
    if kept["instruction_sets"] != instruction_sets():
        print(f"SKIPPED: cost.json was counted with {kept['instruction_sets']}, this processor has {instruction_sets() or 'none of these'}")
        return True
    before, allowed, fine = kept["jobs"], excused(), True
    for name, cost in costs.items():
        if name not in before:
            print(f"NEW      {name}: accept it with tests/bench/cost.py --accept")
            fine = False
            continue
        change = cost.instructions / before[name]["instructions"] - 1
        rose = change > ALLOWED_RISE and name not in allowed
        fine = fine and not rose
        print(f"{'ROSE    ' if rose else 'fine    '} {name}: {100 * change:+.1f} % instructions")
    if not fine:
        print(f"Find what costs more, or announce it in the newest section of CHANGELOG.md (`cost: JOB`), then tests/bench/cost.py --accept.")
    return fine


def accept(costs):
    kept = json.loads(BASELINE.read_text())["jobs"] if BASELINE.is_file() else {}
    kept.update({name: asdict(cost) for name, cost in costs.items()})
    kept = {name: kept[name] for name in JOBS if name in kept}
    BASELINE.write_text(json.dumps({"instruction_sets": instruction_sets(), "jobs": kept}, indent=1) + "\n")
    rows = [row(name, Cost(**cost)) for name, cost in kept.items()]
    TABLE.write_text("\n".join([
        "# What fixed jobs cost", "",
        "Made by `tests/bench/cost.py --accept`: instructions of the whole process (callgrind), shared libraries that",
        "are loaded, peak memory. `.ci/run cost` compares with `tests/bench/cost.json` and fails beyond +5 % that no",
        "line of the changelog announces.", "",
        "| job | million instructions | libraries | MB |", "|---|---|---|---|", *rows, ""]))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--bin", type=Path, default=ROOT / "build/release/bin")
    parser.add_argument("--only", default="")
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--check", action="store_true")
    what.add_argument("--accept", action="store_true")
    arguments = parser.parse_args()
    costs = measure_all(arguments.bin.resolve(), [word for word in arguments.only.split(",") if word])
    if not costs:
        sys.exit(f"cost.py: nothing to measure in {arguments.bin}; build the programs first, or give --bin.")
    if arguments.accept:
        accept(costs)
    return 0 if not arguments.check or check(costs) else 1


if __name__ == "__main__":
    sys.exit(main())
