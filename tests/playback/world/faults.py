#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""faults.py DETENT-PLAY [--record FILE] [--buttons N] [--only FAULT] [--workers N] [--minutes M]

64 faults on N of 20 buttons, by serial, ODrive and --upload.

Runs `detent-play force` at the plant and the boards beside this file and prints one row for each fault: runs,
largest force, the longest time from the fault to no force, the largest distance beyond the travel with force on.
A run in which the computer kept the board from answering (session.Lateness) is repeated, and not judged. Exit code 1
where a force was above the limit or a bar was missed. Figures: docs/measurements/bench-force.md.

A run takes 2.7 s of real time and 0.5 s of a processor: two workers need 80 minutes for all 3,820. Each
result is added to FILE at once, and runs of the same program that FILE holds are not repeated, so that the same
command resumes. After M minutes no run begins. Every button of a fault comes only after one of each other fault.
The line of pauses says how late the boards answered: compare it with that of one worker.
"""

import argparse
import hashlib
import json
import math
import os
import pathlib
import signal
import sys
import time
from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import asdict, dataclass, field

from boards import ODrive, SerialBoard
from plant import Finger, Link
from session import Scene, play

ROOT = pathlib.Path(__file__).resolve().parents[3]
LIMIT_N, TRAVEL_MM, OUTSIDE_MM, SLACK_S, ATTEMPTS = 3.0, 4.0, 3.0, 0.006, 3
RISE_S, RAMP_N = 0.2, 0.02  # tolerance above the ramp
FAULT_S, END_S = 1.2, 1.75
LINKS = ("serial", "ODrive", "upload")
SAMPLES = [str(ROOT / f"samples/buttons/{name}.button.json") for name in ("A", "B", "C", "D", "E", "F", "EF", "push")]
# Springs and dampers of our choice: nothing about them is known to the program in advance.
SPRINGS = [["--stiffness=" + k, "--travel", "4", *(["--damping=" + b] if b else [])] for k, b in (
    ("0.1", ""), ("0.2", "0.001"), ("0.3", ""), ("0.5", ""), ("0.8", "0.002"), ("1.0", ""), ("1.5", ""), ("0.6,-0.1", ""),
    ("0.3325,-0.25,0.05", "0.001,0.004,-0.0008"), ("0.2,0.1", ""), ("0.9,-0.2,0.02", ""), ("0.4", "0.004"))]
BUTTONS = [[path] for path in SAMPLES] + SPRINGS

STOPS, PLACE, POLARITY = ("late", "answer", "drop-outs", "place lost", "absurd"), ("place lost", "absurd", "drop-outs"), ("revers", "runaway")


@dataclass
class Fault:
    name: str
    none_s: float | None = 0.020  # from the fault to no force; none: the button may play on
    says: tuple = ()
    change: dict = field(default_factory=dict)  # of the scene
    link: dict = field(default_factory=dict)
    odrive_s: float | None = 0.055
    upload_none_s: float | None = -1.0  # -1: as `none_s`
    links: tuple = LINKS

    def bar_s(self, link):
        if self.none_s is None or (link == "upload" and self.upload_none_s is None):
            return None
        return self.odrive_s if link == "ODrive" else self.none_s


def faults():
    yield Fault("motor reversed", 0.05, POLARITY, link={"motor_sign": -1}, odrive_s=0.05)
    yield Fault("motor dead", None, link={"motor_sign": 0})
    yield Fault("encoder reversed", None, link={"encoder_sign": -1})
    yield Fault("encoder reversed, the finger leaves", None, link={"encoder_sign": -1}, change={"leaves_s": FAULT_S})
    yield Fault("encoder dead under a resting finger", 0.35, ("encoder",), link={"encoder_dead": True}, odrive_s=0.35,
                links=("serial", "ODrive"))
    for scale in (0.1, 10):
        yield Fault(f"encoder counts {scale} times as much", None, link={"scale": scale})
    for jump_mm in (0.3, 1, 5, 50, -0.3, -1, -5, -50):
        none_s = 0.020 if abs(jump_mm) >= 1 else None
        yield Fault(f"position jumps by {jump_mm} mm", none_s, PLACE if none_s else (), link={"offset_mm": jump_mm}, odrive_s=0.020)
    for drift in (5, 50, -50, 500):
        yield Fault(f"position drifts by {drift} mm/s", None, link={"drift_mm_per_s": drift})
    for noise_mm in (0.02, 0.1, 1):
        yield Fault(f"noise of {noise_mm} mm", None, link={"noise_mm": noise_mm})
    for flicker_mm in (0.5, 1.5, 4):
        yield Fault(f"flicker of {flicker_mm} mm", None, link={"flicker_mm": flicker_mm})
    for delay_ms in (0.5, 1, 2, 3, 4.2, 8, 20):
        late = {"link": {"delay_s": delay_ms / 1000}}
        if delay_ms < 3 or delay_ms == 20:
            yield Fault(f"answers {delay_ms} ms late", 0.020 if delay_ms == 20 else None, STOPS if delay_ms == 20 else (), **late)
        else:  # a board that runs its table is watched for 10 ms
            yield Fault(f"answers {delay_ms} ms late", 0.020, STOPS, **late, upload_none_s=None)
    for jitter_ms in (1, 3, 10):
        yield Fault(f"answers 0 to {jitter_ms} ms late", None, link={"jitter_s": jitter_ms / 1000})
    for lost in (0.05, 0.34, 0.6):
        yield Fault(f"{lost:.0%} of the answers lost", None, link={"lost": lost})
    yield Fault("answers stop", 0.020, STOPS, link={"mute": True})
    for kind, shares in (("garbled", (0.01, 0.1, 1)), ("cut", (0.1, 1)), ("doubled", (0.1, 1)), ("rubbish", (0.05, 1))):
        for share in shares:
            ends = share == 1 and kind in ("garbled", "cut")
            yield Fault(f"{share:.0%} of the answers {kind}", 0.020 if ends else None, STOPS if ends else (), link={kind: share})
    yield Fault("the board's clock stands; an ODrive's controller fails", 0.020, (*STOPS, "error", "under-voltage", "repeated"),
                {"board_event": "stop_clock"}, odrive_s=0.020)
    yield Fault("the board is reset", 0.020, ("place lost", "no force"), {"board_event": "reset"}, odrive_s=0.020)
    yield Fault("the board's switch; an axis that goes idle", 0.020, ("stop", "closed loop", "closed-loop"),
                {"board_event": "press_switch"}, odrive_s=0.020)
    yield Fault("answers to another question", 0.020, STOPS, {"board_event": "confuse"})
    yield Fault("unplugged", 0.020, ("place lost", "gone", "away"), {"away_s": 9.0})
    yield Fault("unplugged for 0.1 s", 0.020, ("place lost", "gone", "away"), {"away_s": 0.1})
    for name in ("SIGINT", "SIGTERM", "SIGHUP", "SIGUSR1"):
        yield Fault(name, 0.020, (), {"signal": getattr(signal, name)}, odrive_s=0.020)
    for name in ("SIGKILL", "SIGSEGV", "SIGQUIT"):
        yield Fault(name, 0.020, (), {"signal": getattr(signal, name)})
    # An ODrive's own watchdog waits for 50 ms.
    yield Fault("the program stands still for 58 ms", 0.020, (), {"stall_s": 0.058}, odrive_s=None)
    yield Fault("the program stands still for 500 ms", 0.020, (), {"stall_s": 0.5})
    yield Fault("a second program at the port", None, (), {"second": True})


def scene_of(fault, link, button):
    finger = Finger(depth_mm=3.0, comes_s=0.4, takes_s=0.2, leaves_s=fault.change.get("leaves_s", 1e9))
    changes = {key: value for key, value in fault.change.items() if key != "leaves_s"}
    words = ["force", *button, "--max-N", str(LIMIT_N), "--json"]
    words += ["--upload"] if link == "upload" else ["--mm-per-turn", "60", "--step-mm", "0.01"] if link == "ODrive" else []
    return Scene(arguments=words, port_option="odrive:" if link == "ODrive" else "serial:", seconds=END_S, finger=finger,
                 fault_s=FAULT_S, after=Link(**fault.link), wait_s=4.5, **changes)


@dataclass
class Found:
    fault: str
    link: str
    button: int
    there: bool = False  # a force stood on the motor when the fault came
    judged: bool = True
    pause_s: float = 0.0
    largest_N: float = 0.0
    none_s: float = 0.0
    outside_mm: float = 0.0
    wrong: list = field(default_factory=list)


def until_none_s(moments):
    """From the fault to the last moment with 0.1 N or more; infinite where there is force at the end of the record."""
    last_s = max((t for t, n, _ in moments if t >= FAULT_S and abs(n) >= 0.1), default=FAULT_S)
    return math.inf if last_s > moments[-1][0] - 0.03 else last_s - FAULT_S


def above_ramp_N(moments, goes_on_s):
    """By how much a force after a pause is above the ramp from nothing to the limit."""
    return max((abs(n) - LIMIT_N * (t - goes_on_s) / RISE_S for t, n, _ in moments if t >= goes_on_s), default=0.0)


def judge(program, fault, link, number):
    found = Found(fault.name, link, number)
    for attempt in range(ATTEMPTS):
        outcome = play(program, scene_of(fault, link, BUTTONS[number]), ODrive() if link == "ODrive" else SerialBoard())
        said, bar_s = outcome.said.lower(), fault.bar_s(link)
        found.largest_N, found.there = outcome.largest_N(), outcome.largest_N(FAULT_S - 0.2, FAULT_S - 0.005) > 0.15
        # A program that goes on gives force again: from nothing, along the ramp.
        goes_on_s = FAULT_S + fault.change["stall_s"] if "stall_s" in fault.change else math.inf
        found.none_s = until_none_s([m for m in outcome.moments if m[0] < goes_on_s]) if found.there and bar_s else 0.0
        found.outside_mm = outcome.outside_mm(TRAVEL_MM, FAULT_S)
        found.wrong = [f"{found.largest_N:.3f} N"] if found.largest_N > LIMIT_N + 0.001 else []
        if bar_s and found.none_s > bar_s + SLACK_S:
            found.wrong.append(f"no force after {1000 * found.none_s:.0f} ms")
        if above_ramp_N(outcome.moments, goes_on_s) > RAMP_N:
            found.wrong.append(f"{above_ramp_N(outcome.moments, goes_on_s):.2f} N above the ramp")
        if found.outside_mm > OUTSIDE_MM:
            found.wrong.append(f"{found.outside_mm:.1f} mm outside")
        if found.there and bar_s and fault.says and not any(word in said for word in fault.says):
            found.wrong.append(f"does not say {fault.says[0]}")
        found.pause_s = outcome.lateness.longest_s
        late = outcome.lateness.explains(END_S)
        over = found.largest_N > LIMIT_N + 0.001
        found.judged = over or not late or not found.wrong
        if over or (found.there and not found.wrong):
            break
        if not found.there and not late:
            break  # this button has no force there
    if found.wrong:
        found.wrong.append(f"button {number}, the board paused for {1000 * found.pause_s:.1f} ms: " + " | ".join(outcome.said.splitlines())[-300:])
    return found


def recorded(path, program):
    """The results of this program in the record, by fault, link and button."""
    lines = path.read_text().splitlines() if path and path.exists() else []
    # The last line may be cut off where a run was killed.
    rows = [json.loads(line) for line in lines if line.endswith("}")]
    return {(row["fault"], row["link"], row["button"]): Found(**{key: value for key, value in row.items() if key != "program"})
            for row in rows if row["program"] == program}


def run_all(jobs, chosen, found, digest):
    """Runs the jobs that are not in `found` yet, and adds each to it and to the record."""
    ends_s = time.monotonic() + 60 * chosen.minutes
    with ProcessPoolExecutor(chosen.workers) as pool:
        ahead, running = iter(jobs), {}
        while True:
            while len(running) < chosen.workers and time.monotonic() < ends_s and (job := next(ahead, None)):
                running[pool.submit(judge, os.path.abspath(chosen.program), *job)] = job
            if not running:
                return
            done = next(as_completed(running))
            fault, link, number = running.pop(done)
            found[fault.name, link, number] = done.result()
            if chosen.record:
                with open(chosen.record, "a") as file:
                    file.write(json.dumps({"program": digest, **asdict(done.result())}) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--record", type=pathlib.Path, help="results, one a line; those of the same program are kept")
    parser.add_argument("--buttons", type=int, default=len(BUTTONS), help="for each fault and link, in turns from all 20")
    parser.add_argument("--only", default="")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--minutes", type=float, default=math.inf)
    chosen = parser.parse_args()
    signal.signal(signal.SIGQUIT, signal.SIG_DFL)  # a shell's background job ignores it, and so would the program
    digest = hashlib.sha256(pathlib.Path(chosen.program).read_bytes()).hexdigest()[:16]
    table = [fault for fault in faults() if chosen.only.lower() in fault.name.lower()]
    jobs = [(fault, link, (7 * k + 3 * at + 11 * LINKS.index(link)) % len(BUTTONS))
            for k in range(chosen.buttons) for at, fault in enumerate(table) for link in fault.links]
    wanted = {(fault.name, link, number) for fault, link, number in jobs}
    found = {key: row for key, row in recorded(chosen.record, digest).items() if key in wanted}
    print(f"{len(table)} faults, {len(jobs)} runs, of which {len(found)} are recorded; at most {LIMIT_N} N", flush=True)
    run_all([job for job in jobs if (job[0].name, *job[1:]) not in found], chosen, found, digest)
    return tell(table, list(found.values()), chosen.only)


def tell(table, results, only):
    """Prints the table; 1 where a force was above the limit or a bar was missed."""
    missed = 0
    print("| fault | link | runs, judged | largest force, N | longest to none, ms | farthest outside, mm | missed |\n|---|---|---|---|---|---|---|")
    for fault in table:
        for link in fault.links:
            rows = [r for r in results if (r.fault, r.link) == (fault.name, link)]
            judged = [r for r in rows if r.judged and r.there]
            wrong = [r for r in judged if r.wrong]
            missed += len(wrong)
            longest_s = max((r.none_s for r in judged), default=0.0)
            print(f"| {fault.name} | {link} | {len(rows)}, {len(judged)} | {max((r.largest_N for r in rows), default=0.0):.2f} | "
                  + (("for ever" if math.isinf(longest_s) else f"{1000 * longest_s:.0f}") if fault.bar_s(link) else "plays on")
                  + f" | {max((r.outside_mm for r in judged), default=0.0):.1f} | {len(wrong)} |", flush=True)
            for r in wrong if not only else [r for r in rows if r.wrong]:
                print("    " + "; ".join(r.wrong))
    judged = [r for r in results if r.judged and r.there]
    over = sum(r.largest_N > LIMIT_N + 0.001 for r in results)
    print(f"{len(results)} runs, {len(judged)} judged, {sum(not r.there for r in results)} without a force at the fault: "
          f"above the limit {over}, a bar missed {missed}")
    pauses_ms = sorted(1000 * r.pause_s for r in results)
    if pauses_ms:
        print(f"longest pause of the board in a run: median {pauses_ms[len(pauses_ms) // 2]:.1f} ms, "
              f"nine tenths within {pauses_ms[9 * len(pauses_ms) // 10]:.1f} ms, largest {pauses_ms[-1]:.1f} ms")
    return 1 if over or missed else 0


if __name__ == "__main__":
    sys.exit(main())
