#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""rest_under_a_hand.py DETENT_PLAY [OTHER_DETENT_PLAY]: what a resting finger feels of hum, tremor and noise, and what that costs a press.

Finger, hum and tremor are made here (numpy), apart from the product and its tests. With a second program, how much later the second one
plays each jump and bottom-out. Figures: docs/develop/decisions/0906-sensor-noise.md.
"""
import argparse
import csv
import json
import pathlib
import subprocess
import tempfile

import numpy as np

BUTTONS = pathlib.Path(__file__).resolve().parents[2] / "samples" / "buttons"
RISE_S, SETTLE_S, HOLD_S, LEVEL_N = 0.2, 0.4, 1.6, 0.1
LAST = ("press_jump", "release_jump", "bottom_out")


def minimum_jerk(share):
    u = np.clip(share, 0, 1)
    return u**3 * (10 - 15 * u + 6 * u * u)


def hum(t, mains_hz, amplitude_n, random):
    parts = ((1, 1), (2, 0.3), (3, 0.2), (5, 0.1))
    return amplitude_n * sum(a * np.sin(2 * np.pi * mains_hz * k * t + random.uniform(0, 2 * np.pi)) for k, a in parts)


def sine_tremor(t, random):
    return np.sin(2 * np.pi * 9 * t + random.uniform(0, 2 * np.pi))


def noise_tremor(t, random):
    """8 to 12 Hz, as strong as a sine of amplitude 1."""
    frequency = np.fft.rfftfreq(len(t), t[1] - t[0])
    spectrum = random.normal(size=len(frequency)) + 1j * random.normal(size=len(frequency))
    wave = np.fft.irfft(spectrum * ((frequency > 8) & (frequency < 12)), len(t))
    return wave / wave.std() / np.sqrt(2)


def events(program, button, t, force_n):
    with tempfile.TemporaryDirectory() as folder:
        press, out = pathlib.Path(folder, "press.csv"), pathlib.Path(folder, "events.csv")
        np.savetxt(press, np.c_[t, force_n], fmt="%.6f", delimiter=",", header="time_s,force_N", comments="")
        subprocess.run([program, "render", BUTTONS / f"{button}.button.json", "--press", press, "-o",
                        pathlib.Path(folder, "press.wav"), "--events", out], check=True, capture_output=True)
        with open(out, newline="", encoding="utf-8") as file:
            return [(row["event"], float(row["time_s"])) for row in csv.DictReader(file)]


def disturbed(t, force_n, case, random):
    wave = (noise_tremor if case.get("noisy") else sine_tremor)(t, random)
    return (force_n + hum(t, case.get("mains_Hz", 50.03), case.get("hum_N", 0), random) +
            case.get("tremor", 0) * force_n * wave + case.get("noise_N", 0) * random.normal(size=len(t)))


def held_events_per_s(program, button, sensor_hz, case, seed, highest_n=1.2):
    levels, level_s = round(highest_n / LEVEL_N), RISE_S + SETTLE_S + HOLD_S
    t = np.arange(0, 0.5 + level_s * levels, 1 / sensor_hz)
    since = np.maximum(t - 0.5, 0)
    force = LEVEL_N * np.where(t < 0.5, 0, since // level_s + minimum_jerk(since % level_s / RISE_S))
    felt = [(s - 0.5) % level_s for _, s in events(program, button, t, disturbed(t, force, case, np.random.default_rng(seed))) if s > 0.5]
    return sum(RISE_S + SETTLE_S <= s < level_s - 0.02 for s in felt) / (HOLD_S * levels)


def lateness_ms(programs, case, sensor_hz=1000):
    late = []
    for button in "ABCDEF":
        states = json.loads((BUTTONS / f"{button}.button.json").read_text())["states"]
        highest = 1.25 * max(k["force_N"] for s in states for k in s["press"])
        for press_s in (0.05, 0.1, 0.17, 0.3):
            t = np.arange(0, 1.8 + 2 * press_s, 1 / sensor_hz)
            force = highest * (minimum_jerk((t - 1) / press_s) - minimum_jerk((t - 1.5 - press_s) / press_s))
            pair = [events(p, button, t, disturbed(t, force, case, np.random.default_rng(1))) for p in programs]
            for kind in LAST:
                before, now = ([s for k, s in felt if k == kind] for felt in pair)
                late += [1000 * (b - a) for a, b in zip(before, now)] if len(before) == len(now) else [np.inf]
    return late


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("programs", nargs="+")
    programs = parser.parse_args().programs
    both = {"hum_N": 0.012, "tremor": 0.02}
    cases = {"clean": {}, "hum 50 Hz": {"hum_N": 0.012}, "hum 60 Hz": {"hum_N": 0.012, "mains_Hz": 60}, "tremor": {"tremor": 0.02},
             "tremor as noise": {"tremor": 0.02, "noisy": True}, "hum, tremor, noise": {**both, "noise_N": 0.003},
             "hum, tremor as noise, noise": {**both, "noise_N": 0.003, "noisy": True}, "noise": {"noise_N": 0.003}}
    for program in programs:
        print(f"{program}: events a second held, sensor at 200, 425, 1000, 3000, 10000 Hz")
        for name, case in cases.items():
            rates = [np.mean([held_events_per_s(program, b, hz, case, i) for i, b in enumerate("ABCF")])
                     for hz in (200, 425, 1000, 3000, 10000)]
            print(f"| {name} | " + " | ".join(f"{r:.2f}" for r in rates) + " |", flush=True)
    if len(programs) > 1:
        for name in ("hum 50 Hz", "tremor", "hum, tremor, noise"):
            late = lateness_ms(programs[:2], cases[name])
            print(f"{name}: jumps and bottom-outs later by {np.median(late):.3f} ms in the median, at most {max(late):.3f} ({len(late)})")


if __name__ == "__main__":
    main()
