#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""live_ratio.py LIVE_SPEED_PROBE OTHER_PROBE: what live playback costs beside another build, and when its events play.

The probe (tests/playback/realtime/live_speed_probe.cpp) passes readings at 425 Hz through conditioner and engine in blocks of 64
samples, as a callback does. Both programs play the same 60 s of presses of each sample button, in turns, five times. Prints, for
each button, the least processor time of each, their ratio, and how much later this build plays its jumps and bottom-outs. Processor
time is user and system time, so that a busy computer changes little. Figures: docs/measurements/bench-playback.md.
"""

import argparse
import math
import os
import pathlib
import resource
import statistics
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUTTONS = ("A", "B", "C", "D", "E", "F", "EF", "push", "latch")
RATE_HZ, SECONDS, ROUNDS, GRAIN = 425, 60.0, 5, 0
PRESS_S, REST_S, PAUSE_S = 0.12, 0.1, 0.2


def eased(share):
    u = min(max(share, 0.0), 1.0)
    return u**3 * (10 - 15 * u + 6 * u * u)


def presses(path, most_N):
    """Minimum-jerk presses, each a little harder than the one before and from the start again after ten."""
    every_s = 2 * PRESS_S + REST_S + PAUSE_S
    with open(path, "w", encoding="utf-8") as file:
        file.write("time_s,force_N\n")
        for i in range(int(SECONDS * RATE_HZ)):
            at_s = i / RATE_HZ
            number, within_s = divmod(at_s, every_s)
            share = eased(within_s / PRESS_S) - eased((within_s - PRESS_S - REST_S) / PRESS_S)
            noise_N = 0.003 * math.sin(12.9898 * i)
            file.write(f"{at_s:.6f},{most_N * (0.8 + 0.04 * (number % 10)) * share + noise_N:.5f}\n")


def run(program, button, press, folder):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    out = subprocess.run([program, ROOT / f"samples/buttons/{button}.button.json", press, os.path.join(folder, "samples")],
                         check=True, capture_output=True, text=True).stdout
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    felt = [line.split(",") for line in out.splitlines() if line.startswith("felt,")]
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, [(float(row[1]), row[2]) for row in felt if int(row[2]) != GRAIN], len(felt)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("other")
    chosen = parser.parse_args()
    sums = [0.0, 0.0]
    print("| button | processor s of 60 s: this, other | ratio | jumps and bottom-outs: this, other | later, ms: median, most |\n|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        press = os.path.join(folder, "press.csv")
        for button in BUTTONS:
            presses(press, 3.0)
            least, events = [math.inf, math.inf], [[], []]
            for _ in range(ROUNDS):
                for i, program in enumerate((chosen.program, chosen.other)):
                    spent_s, events[i], _ = run(program, button, press, folder)
                    least[i] = min(least[i], spent_s)
            sums = [a + b for a, b in zip(sums, least)]
            same = [e[1] for e in events[0]] == [e[1] for e in events[1]]
            later = [1000 * (a[0] - b[0]) for a, b in zip(*events)] if same else []
            delay = f"{statistics.median(later):+.3f}, {max(later):+.3f}" if later else "other events"
            print(f"| {button} | {least[0]:.3f}, {least[1]:.3f} | {least[0] / least[1]:.3f} | {len(events[0])}, {len(events[1])} | {delay} |", flush=True)
    print(f"All: {sums[0] / sums[1]:.3f}")


if __name__ == "__main__":
    main()
