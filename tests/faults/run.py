#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plants the faults of faults.toml one by one and tells which test kills each. A guard that no test misses guards nothing.

    run.py [--build FOLDER] [--only WORDS] [--check]

For each fault the text `search` is replaced by `replace` in `file`, its `target`s are built in FOLDER (default build/release) and
its `tests` (a regular expression for ctest) are run; then the file is as it was. Prints one line per fault and the share killed;
exit 1 if that is below 90 %, or if a fault no longer applies (its text is gone, or stands more than once): then look at what
became of the guard and mend the list. --only: faults whose name contains one of these words, separated by commas. --check: only
whether every fault applies.
"""

import argparse
import os
import subprocess
import sys
import tomllib
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
BAR = 0.9


@dataclass(frozen=True)
class Fault:
    name: str     # what is taken out, in a few words
    file: str
    search: str   # stands once in the file
    replace: str
    target: str   # what to build, separated by spaces
    tests: str    # for ctest -R

    def trouble(self):
        """Why it cannot be planted; None if it can."""
        path = ROOT / self.file
        if not path.is_file():
            return f"{self.file} is gone"
        count = path.read_text().count(self.search)
        return None if count == 1 else f"its text stands {count} times in {self.file}"


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
        self.path.write_text(self.before.replace(self.fault.search, self.fault.replace))

    def __exit__(self, *_):
        self.path.write_text(self.before)


def killers(fault, build, jobs):
    """Names of the tests that fail with the fault planted; "the compiler" if it does not build."""
    with Planted(fault):
        built = subprocess.run(["cmake", "--build", str(build), "--parallel", str(jobs), "--target", *fault.target.split()],
                               capture_output=True, text=True)
        if built.returncode != 0:
            return ["the compiler"]
        tests = subprocess.run(["ctest", "--test-dir", str(build), "-R", fault.tests, "--timeout", "300"], capture_output=True, text=True)
    if "No tests were found" in tests.stdout + tests.stderr:
        sys.exit(f"run.py: no test matches '{fault.tests}' (fault '{fault.name}')")
    return [line.split(" - ", 1)[1].split(" (")[0] for line in tests.stdout.splitlines() if line.endswith(("(Failed)", "(Timeout)"))
            or "(SEGFAULT)" in line or "(Subprocess aborted)" in line]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--build", type=Path, default=ROOT / "build/release")
    parser.add_argument("--only", default="")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    arguments = parser.parse_args()
    faults = read_faults([word for word in arguments.only.split(",") if word])
    stale = [(fault, fault.trouble()) for fault in faults if fault.trouble()]
    for fault, trouble in stale:
        print(f"STALE    {fault.name}: {trouble}")
    if arguments.check:
        print(f"{len(faults) - len(stale)} of {len(faults)} faults apply.")
        return 1 if stale else 0
    killed = 0
    planted = [fault for fault in faults if not fault.trouble()]
    for fault in planted:
        by = killers(fault, arguments.build, arguments.jobs)
        killed += bool(by)
        print(f"{'killed  ' if by else 'SURVIVED'} {fault.name}{': ' + ', '.join(by) if by else f' ({fault.file})'}", flush=True)
    # What was built last held a fault.
    targets = {target for fault in planted for target in fault.target.split()}
    if targets:
        subprocess.run(["cmake", "--build", str(arguments.build), "--target", *sorted(targets)], capture_output=True)
    share = killed / len(planted) if planted else 0
    print(f"{killed} of {len(planted)} planted faults killed ({100 * share:.0f} %, bar {100 * BAR:.0f} %); {len(stale)} do not apply.")
    return 0 if planted and share >= BAR and not stale else 1


if __name__ == "__main__":
    sys.exit(main())
