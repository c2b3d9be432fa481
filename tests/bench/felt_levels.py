#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""felt_levels.py DETENT_PLAY [--feel clear|paper]: how far a jump stands above its neighbours, and how a slope's level grows with speed
and steepness.

Apart from the engine: presses, weights and levels are computed here (numpy, scipy), from sound files the program writes. Figures:
docs/develop/decisions/0915-clear-feel.md.
"""
import argparse
import csv
import json
import pathlib
import subprocess
import tempfile
import warnings

import numpy as np
from scipy import signal
from scipy.io import wavfile

RATE_HZ = 48000
NEIGHBOURS_S = 0.06
LOOK_S = 0.010
BUTTONS = pathlib.Path(__file__).resolve().parents[2] / "samples" / "buttons"


def minimum_jerk(share):
    u = np.clip(share, 0, 1)
    return u**3 * (10 - 15 * u + 6 * u * u)


class Judge:
    def __init__(self, program, feel, folder):
        self.program, self.feel, self.folder = program, feel, pathlib.Path(folder)

    def trace(self, quantity, time_s, values):
        path = self.folder / "press.csv"
        np.savetxt(path, np.c_[time_s, values], fmt="%.9g", delimiter=",", header=f"time_s,{quantity}", comments="")
        return path

    def render(self, button, trace, *options):
        sound, events = self.folder / "press.wav", self.folder / "events.csv"
        subprocess.run([self.program, "render", button, "--press", trace, "-o", sound, "--events", events,
                        "--feel", self.feel, *options], check=True, capture_output=True)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            samples = wavfile.read(sound)[1].astype(float)
        with open(events, newline="", encoding="utf-8") as file:
            return samples, list(csv.DictReader(file))


def weighted(samples):
    """Behind the Pacinian weight: best at 250 Hz, 12 dB per octave, without a delay."""
    count = 1 << int(np.ceil(np.log2(2 * len(samples))))
    frequency = np.maximum(np.fft.rfftfreq(count, 1 / RATE_HZ), 1e-3)
    weight = 1 / (1 + (0.9 * (frequency / 250 - 250 / frequency))**2)
    return np.fft.irfft(np.fft.rfft(samples, count) * weight, count)[:len(samples)]


def level_dB(samples):
    window = np.hanning(int(LOOK_S * RATE_HZ))
    power = signal.fftconvolve(2 * weighted(samples)**2, window / window.sum(), "same")
    return 45 + 10 * np.log10(np.maximum(power, 1e-12))


def margins(judge, name, press_s):
    button = BUTTONS / f"{name}.button.json"
    strongest = max(k["force_N"] for s in json.loads(button.read_text())["states"] for k in s["press"])
    t = np.arange(0, 0.45 + 1.83 * press_s, 0.001)
    up, lift = 0.1, 0.25 + press_s
    force = 1.25 * strongest * np.where(t < lift, minimum_jerk((t - up) / press_s),
                                        1 - minimum_jerk((t - lift) / (0.83 * press_s)))
    trace = judge.trace("force_N", t, force)
    whole, events = judge.render(button, trace)
    jumps, _ = judge.render(button, trace, "--mode", "click-only", "--bottom-amplitude", "0")
    count = max(len(whole), len(jumps)) + RATE_HZ // 2
    whole, jumps = (np.pad(x, (0, count - len(x))) for x in (whole, jumps))
    own, rest = level_dB(jumps), level_dB(whole - jumps)
    at = [round(float(e["time_s"]) * RATE_HZ) for e in events if e["event"] == "press_jump"]
    reach = int(NEIGHBOURS_S * RATE_HZ)
    return [own[i:min([i + reach] + [k for k in at if k > i])].max() - rest[max(0, i - reach):i + reach].max() for i in at]


def bottom_out_below(judge, name):
    """How far the bottom-out of a slow press lies below the last click before it, dB."""
    button = BUTTONS / f"{name}.button.json"
    strongest = max(k["force_N"] for s in json.loads(button.read_text())["states"] for k in s["press"])
    t = np.arange(0, 1.2, 0.001)
    trace = judge.trace("force_N", t, 1.25 * strongest * np.clip(t - 0.1, 0, 1))
    both, events = judge.render(button, trace, "--mode", "click-only")
    jumps, _ = judge.render(button, trace, "--mode", "click-only", "--bottom-amplitude", "0")
    count = max(len(both), len(jumps)) + RATE_HZ // 2
    both, jumps = (np.pad(x, (0, count - len(x))) for x in (both, jumps))
    last = max(round(float(e["time_s"]) * RATE_HZ) for e in events if e["event"] == "press_jump")
    return level_dB(jumps)[last:].max() - level_dB(both - jumps).max()


def slope(judge, speed_mm_per_s):
    t = np.arange(0, 3.9 / speed_mm_per_s, 0.001)
    samples, _ = judge.render(BUTTONS / "A.button.json", judge.trace("displacement_mm", t, t * speed_mm_per_s),
                              "--mode", "slope-only")
    energy = np.sum(weighted(samples)**2)
    return 48 + 10 * np.log10(energy / (t[-1] * RATE_HZ)), 10 * np.log10(energy)


STEEPNESSES_N_PER_MM = (0.05, 0.1, 0.2, 0.4, 0.8)


def straight(folder, steepness_n_per_mm):
    """A button of 4 mm without a jump."""
    knots = [{"displacement_mm": x, "force_N": 0.1 + steepness_n_per_mm * x, "slopeBefore_N_per_mm": steepness_n_per_mm,
              "slopeAfter_N_per_mm": steepness_n_per_mm} for x in (0.0, 4.0)]
    path = pathlib.Path(folder) / "straight.button.json"
    path.write_text(json.dumps({"format": "detent-button", "version": 2, "name": "straight", "states": [{"name": "", "press": knots}]}))
    return path


def steepness_steps(judge, speed_of):
    """Level of straight slopes, each pressed at its own speed in mm/s: steps per doubling of the steepness, dB."""
    levels = []
    for steepness in STEEPNESSES_N_PER_MM:
        t = np.arange(0, 3.9 / speed_of(steepness), 0.0005)
        samples, _ = judge.render(straight(judge.folder, steepness),
                                  judge.trace("displacement_mm", t, t * speed_of(steepness)), "--mode", "slope-only")
        levels.append(10 * np.log10(np.mean(weighted(samples[:int(t[-1] * RATE_HZ)])**2)))
    return " ".join(f"{d:.1f}" for d in np.diff(levels))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("--feel", default="clear")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        judge = Judge(options.program, options.feel, folder)
        print("| button | 50 ms | 100 ms | 170 ms | 300 ms |\n|---|---|---|---|---|")
        for name in "BCDEF":
            cells = [", ".join(f"{m:.1f}" for m in margins(judge, name, s)) for s in (0.05, 0.1, 0.17, 0.3)]
            print(f"| {name} | " + " | ".join(cells) + " |")
        levels, energies = zip(*(slope(judge, v) for v in (5, 10, 20, 40, 80, 160)))
        print("steps of a slope's level, 5 to 160 mm/s, per doubling, dB:", " ".join(f"{d:.1f}" for d in np.diff(levels)))
        for speed in (5, 20, 80, 200):
            print(f"steps per doubling of the steepness, 0.05 to 0.8 N/mm, at {speed} mm/s, dB:", steepness_steps(judge, lambda k: speed))
        for rate in (2, 10):
            print(f"the same at {rate} N/s, dB:", steepness_steps(judge, lambda k: rate / k))
        print("the bottom-out below the click before it, dB:", ", ".join(f"{n} {bottom_out_below(judge, n):.1f}" for n in "BCDEF"))
        print(f"energy of a stroke over speed: within {max(energies) - min(energies):.1f} dB")


if __name__ == "__main__":
    main()
