#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plants the faults of faults.toml one by one and tells which test kills each. A guard that no test misses guards nothing.

    run.py [--build FOLDER] [--only WORDS] [--check | --compile]

For each fault the pattern `search` is replaced by `replace` in the function `function` of `file` (places.py), its `target`s are built in FOLDER (default build/release) and
its `tests` (a regular expression for ctest) are run; then the file is as it was. Prints one line per fault and the share killed;
exit 1 if that is below 90 %, or if a fault does not count: its pattern is gone or stands more than once, or the file with it does not
compile, so that no test was asked: then look at what became of the guard and mend the list. --only: faults whose name contains one
of these words, separated by commas. --check: only whether every fault's pattern stands once. --compile: whether every file compiles
with its fault, without building or testing anything (a header by the first file of its target that includes it).
"""

import argparse
import json
import os
import shlex
import subprocess
import sys
import tempfile
import tomllib
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import places

ROOT = Path(__file__).resolve().parent.parent.parent
BAR = 0.9


@dataclass(frozen=True)
class Fault:
    name: str     # what is taken out, in a few words
    file: str
    function: str # as places.py names it; empty: the whole file
    search: str   # stands once in the function, whatever its white space
    replace: str
    target: str   # what to build, separated by spaces
    tests: str    # for ctest -R

    def trouble(self):
        """Why it cannot be planted; None if it can."""
        path = ROOT / self.file
        if not path.is_file():
            return f"{self.file} is gone"
        where = places.place(path, self.function, self.search)
        return where if isinstance(where, str) else None

    def planted(self):
        """The file's text with the fault in it."""
        path = ROOT / self.file
        start, end = places.place(path, self.function, self.search)
        text = path.read_text()
        return text[:start] + self.replace + text[end:]


def read_faults(words):
    data = tomllib.loads((Path(__file__).resolve().parent / "faults.toml").read_text())
    faults = [Fault(**entry) for entry in data["fault"]]
    return [fault for fault in faults if not words or any(word in fault.name for word in words)]


class Planted:
    """The fault in the file, and the file as it was afterwards, whatever happens."""

    def __init__(self, fault):
        self.path, self.fault = ROOT / fault.file, fault

    def __enter__(self):
        self.before = self.path.read_text()
        self.path.write_text(self.fault.planted())

    def __exit__(self, *_):
        self.path.write_text(self.before)


class DoesNotBuild(Exception):
    """No test was asked."""


def killers(fault, build, jobs):
    """Names of the tests that fail with the fault planted."""
    with Planted(fault):
        built = subprocess.run(["cmake", "--build", str(build), "--parallel", str(jobs), "--target", *fault.target.split()],
                               capture_output=True, text=True)
        if built.returncode != 0:
            raise DoesNotBuild
        tests = subprocess.run(["ctest", "--test-dir", str(build), "-R", fault.tests, "--timeout", "300"], capture_output=True, text=True)
    if "No tests were found" in tests.stdout + tests.stderr:
        sys.exit(f"run.py: no test matches '{fault.tests}' (fault '{fault.name}')")
    return [line.split(" - ", 1)[1].split(" (")[0] for line in tests.stdout.splitlines() if line.endswith(("(Failed)", "(Timeout)"))
            or "(SEGFAULT)" in line or "(Subprocess aborted)" in line]


def including(header):
    """The lines that bring a header in: of itself, and of the headers that include it."""
    own = f'#include "{header}"'
    others = (path for room in ("model", "importer", "playback", "editor") for path in (ROOT / room).rglob("*.h") if own in path.read_text())
    return [own, *(f'#include "{path.relative_to(ROOT)}"' for path in others)]


def compiled_with(fault, commands):
    """The command that compiles the fault's file; of a header, that of the first file that includes it. None for what no compiler reads."""
    if fault.file.endswith(".cpp"):
        return next((command for command in commands if Path(command["file"]) == ROOT / fault.file), None)
    if fault.file.endswith(".h"):
        lines = including(fault.file)
        own = [command for command in commands if not Path(command["file"]).is_relative_to(ROOT / "build")]
        return next((command for command in own if any(line in Path(command["file"]).read_text() for line in lines)), None)
    return None


def first_error(fault, commands):
    """What the compiler says of the fault, planted beside the checkout; None if nothing."""
    command = compiled_with(fault, commands)
    if command is None:
        return None if not fault.file.endswith((".cpp", ".h")) else "no target of this build compiles it"
    with tempfile.TemporaryDirectory() as folder:
        planted = Path(folder, fault.file)
        planted.parent.mkdir(parents=True)
        planted.write_text(fault.planted())
        words = shlex.split(command["command"])
        source = str(planted) if fault.file.endswith(".cpp") else command["file"]
        words = words[:words.index("-o")] + ["-fsyntax-only", source]
        words.insert(next(i for i, word in enumerate(words) if word.startswith("-I")), f"-I{folder}")
        told = subprocess.run(words, cwd=command["directory"], capture_output=True, text=True)
    return None if told.returncode == 0 else next((line for line in told.stderr.splitlines() if " error: " in line), told.stderr.strip())


def compile_all(faults, build, jobs):
    """How many do not compile; prints each."""
    commands = json.loads((build / "compile_commands.json").read_text())
    bad = 0
    with ThreadPoolExecutor(jobs) as pool:
        for fault, error in zip(faults, pool.map(lambda each: first_error(each, commands), faults)):
            if error:
                bad += 1
                print(f"DOES NOT COMPILE {fault.name}: {error}", flush=True)
    print(f"{len(faults) - bad} of {len(faults)} faults compile.")
    return bad


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--build", type=Path, default=ROOT / "build/release")
    parser.add_argument("--only", default="")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--compile", action="store_true")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    arguments = parser.parse_args()
    faults = read_faults([word for word in arguments.only.split(",") if word])
    stale = [(fault, fault.trouble()) for fault in faults if fault.trouble()]
    for fault, trouble in stale:
        print(f"STALE    {fault.name}: {trouble}")
    if arguments.check:
        print(f"{len(faults) - len(stale)} of {len(faults)} faults apply.")
        return 1 if stale else 0
    planted = [fault for fault in faults if not fault.trouble()]
    if arguments.compile:
        return 1 if compile_all(planted, arguments.build.resolve(), arguments.jobs) or stale else 0
    killed, unbuilt = 0, 0
    for fault in planted:
        try:
            by = killers(fault, arguments.build, arguments.jobs)
        except DoesNotBuild:
            unbuilt += 1
            print(f"NO BUILD {fault.name} ({fault.file}): no test was asked", flush=True)
            continue
        killed += bool(by)
        print(f"{'killed  ' if by else 'SURVIVED'} {fault.name}{': ' + ', '.join(by) if by else f' ({fault.file})'}", flush=True)
    # What was built last held a fault.
    targets = {target for fault in planted for target in fault.target.split()}
    if targets:
        subprocess.run(["cmake", "--build", str(arguments.build), "--target", *sorted(targets)], capture_output=True)
    asked = len(planted) - unbuilt
    share = killed / asked if asked else 0
    print(f"{killed} of {asked} planted faults killed ({100 * share:.0f} %, bar {100 * BAR:.0f} %); {len(stale)} do not apply, {unbuilt} do not build.")
    return 0 if asked and share >= BAR and not stale and not unbuilt else 1


if __name__ == "__main__":
    sys.exit(main())
