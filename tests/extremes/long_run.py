#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every property of every room on many random cases, in as many processes as asked for.

    long_run.py [--bin FOLDER] [--cases 10000] [--seed N] [--jobs N] [--only WORDS] [--check]

One line for each test case as it ends, then one for each program: properties, cases that passed, processor time. Exit code 1 where one
failed; what it drew is printed, and `RC_PARAMS="seed=N max_success=CASES" PROGRAM "TEST CASE"` shows it again. --only: files whose path
contains one of these words, separated by commas. The seed is the day's unless given. --check: only whether every file with properties
belongs to a program, as PROGRAMS below says.
"""
import argparse
import concurrent.futures
import datetime
import os
import re
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import count_properties

ROOT = count_properties.ROOT
# Folder of tests (or one file's beginning) -> the program they are in; the first that fits.
PROGRAMS = {
    "extremes/": "extremes_tests", "model/": "model_tests", "importer/": "importer_tests", "playback/realtime/": "playback_tests",
    "editor/quantity/": "editor_tests",
}


@dataclass(frozen=True)
class Ended:
    program: str
    case: str
    properties: int  # that passed with all their cases
    seconds: float   # of the processor
    failure: str     # what was printed, if it failed


def program_of(file):
    """The program a file of properties is in; None if nobody said."""
    return next((program for beginning, program in PROGRAMS.items() if file.startswith(beginning)), None)


def cases_of(binary, file):
    """The test cases of one file of that program."""
    listed = subprocess.run([binary, "--filenames-as-tags", f"[#{Path(file).stem}]", "--list-test-names-only"], capture_output=True, text=True)
    return [line for line in listed.stdout.splitlines() if line]


def run(binary, case, cases, seed):
    environment = {**os.environ, "RC_PARAMS": f"seed={seed} max_success={cases}", "QT_QPA_PLATFORM": "offscreen"}
    process = subprocess.Popen([binary, "--success", re.sub(r"([\\,\[])", r"\\\1", case)], env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                               text=True, errors="replace")
    said = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    passed = len(re.findall(rf"passed\s+{cases}\s+tests", said))
    return passed, usage.ru_utime + usage.ru_stime, "" if status == 0 else said[-12000:]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=Path, default=ROOT / "build/release/bin")
    parser.add_argument("--cases", type=int, default=10000)
    parser.add_argument("--seed", type=int, default=int(datetime.date.today().strftime("%Y%m%d")))
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--only", default="")
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    strays = [file for file in count_properties.properties_by_file() if not program_of(file)]
    for file in strays:
        print(f"tests/{file} has properties, and no program here: PROGRAMS of tests/extremes/long_run.py")
    if strays or arguments.check:
        return 1 if strays else 0
    words = [w for w in arguments.only.split(",") if w]
    work = []
    for file in count_properties.properties_by_file():
        if not words or any(word in file for word in words):
            binary = arguments.bin / program_of(file)
            work += [(binary, case) for case in cases_of(binary, file)]
    ended = []
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        runs = {pool.submit(run, binary, case, arguments.cases, arguments.seed): (binary.name, case) for binary, case in work}
        for done in concurrent.futures.as_completed(runs):
            program, case = runs[done]
            ended.append(Ended(program, case, *done.result()))
            last = ended[-1]
            print(f"{'FAILED ' if last.failure else 'passed '}{last.seconds:8.1f} s  {last.properties:3d} properties  {program}: {case}", flush=True)
            if last.failure:
                print(last.failure, flush=True)
    print(f"\n{arguments.cases} cases each, seed {arguments.seed}\n\n| program | properties passed | cases | processor time |\n|---|---|---|---|")
    for program in sorted({e.program for e in ended}):
        own = [e for e in ended if e.program == program]
        properties = sum(e.properties for e in own)
        print(f"| {program} | {properties} | {properties * arguments.cases:,} | {sum(e.seconds for e in own):.0f} s |")
    failed = [e for e in ended if e.failure]
    for e in failed:
        print(f"FAILED: {e.program} \"{e.case}\"")
    return 1 if failed or not ended else 0


if __name__ == "__main__":
    sys.exit(main())
