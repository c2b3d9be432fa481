#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A simulated study, killed at random moments: no answer that was confirmed may be missing, and work must go on at the very
trial. The whole of it is 1,000 kills: study_kill_test.py --detent-play BIN --samples DIR --kind abx --kills 1000."""

import argparse
import json
import pathlib
import random
import subprocess
import sys
import tempfile
import time

TRIALS = 150
# Kinds whose simulated participants answer 150 trials; in a threshold study the next question hangs on all answers before it.
KINDS = {
    "abx": (list("ABCDEF"), [], "errors=0.1"),
    "threshold": (["C"], ["--kind", "threshold", "--trials", "150"], "threshold=0.1"),
    "rating": (["A", "B", "C"], ["--kind", "rating", "--trials", "50"], "errors=0.1"),
    "timing": (["B", "C"], ["--kind", "timing", "--task", "window", "--trials", "75"], "timing=0.2,0.09"),
}


def confirmed(text):
    """Numbers of the answers the program said are on the disk."""
    return [int(line.split()[1]) for line in text.splitlines(keepends=True)
            if line.startswith("recorded ") and line.endswith("\n")]


def answers(journal):
    """Whole answer lines of a journal, by trial."""
    if not journal.exists():
        return []
    whole = journal.read_bytes().split(b"\n")[:-1]
    events = [json.loads(line) for line in whole]
    return [event for event in events if event.get("event") == "answer"]


class Study:
    def __init__(self, program, samples, folder, kind):
        self.program = program
        self.folder = folder
        names, options, self.simulation = KINDS[kind]
        buttons = [str(samples / f"{name}.button.json") for name in names]
        subprocess.run([program, "study", "new", str(folder), *buttons, "--seed", "12", *options], check=True,
                       stderr=subprocess.DEVNULL)

    def command(self, participant):
        return [self.program, "study", "run", str(self.folder), "--participant", participant, "--simulate", self.simulation]

    def journal(self, participant):
        return self.folder / "participants" / f"{participant}.jsonl"


def kill_once(study, participant, delay):
    """Starts or resumes the participant and kills it; gives what it confirmed."""
    process = subprocess.Popen(study.command(participant), stderr=subprocess.PIPE, text=True)
    time.sleep(delay)
    process.kill()
    return confirmed(process.communicate()[1])


def run(study, kills, seed):
    chance = random.Random(seed)
    lost = wrong = broken = amid = 0
    begun = time.monotonic()
    subprocess.run(study.command("P0000"), check=True, stderr=subprocess.DEVNULL)  # how long one takes here and now
    number, done, whole_s = 1, 0, time.monotonic() - begun
    for _ in range(kills):
        participant = f"P{number:04d}"
        before = len(answers(study.journal(participant)))
        begun = time.monotonic()
        told = kill_once(study, participant, chance.uniform(0, 1.2 * whole_s))
        kept = answers(study.journal(participant))
        trials = [answer["trial"] for answer in kept]
        if trials != list(range(1, len(trials) + 1)):
            broken += 1
        if told and told[-1] > len(kept):
            lost += told[-1] - len(kept)
        if told and told[0] != before + 1:
            wrong += 1
        amid += before < len(kept) < TRIALS
        if len(kept) == TRIALS:
            whole_s = max(0.05, 0.5 * whole_s + 0.5 * (time.monotonic() - begun))
            number += 1
        done += 1
        if done % 100 == 0:
            print(f"{done} kills, {amid} between answers: {lost} lost, {wrong} resumed wrong, {broken} out of order", flush=True)
    print(f"{done} kills, {amid} of them between two answers, over {number + 1} participants: {lost} answers lost, "
          f"{wrong} resumed at another trial, {broken} journals out of order")
    subprocess.run(study.command(f"P{number:04d}"), check=True, stderr=subprocess.DEVNULL)  # the last one ends by itself
    report = subprocess.run([study.program, "study", "report", str(study.folder), "--json"], check=True, capture_output=True,
                            text=True)
    rows = json.loads(report.stdout)["trials"]
    if rows != TRIALS * (number + 1):
        print(f"{rows} rows instead of {TRIALS * (number + 1)}")
        return False
    return lost == wrong == broken == 0


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--detent-play", required=True)
    parser.add_argument("--samples", required=True, type=pathlib.Path)
    parser.add_argument("--kind", choices=KINDS, action="append", help="default: all")
    parser.add_argument("--kills", type=int, default=20, help="of each kind")
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    kinds = given.kind or list(KINDS)
    with tempfile.TemporaryDirectory() as folder:
        passed = [run(Study(given.detent_play, given.samples, pathlib.Path(folder) / kind, kind), given.kills, given.seed)
                  for kind in kinds]
        sys.exit(0 if all(passed) else 1)


if __name__ == "__main__":
    main()
