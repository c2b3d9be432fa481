#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What asks for a force instead of a time: headers (`c`) and `touchpad`, by another hand than their writer's.

    follow_force_test.py DETENT_PLAY

A board that knows nothing but a header's own words (play_header.c) is given the force of a press, sample by sample. What it meets is held
against the events of the engine under the same press, what it plays against the loss told: jumps and bottom-outs within 1 ms of their
constant delay, energies within 2 %. Needs Debian's python3-numpy and a C compiler: without them, SKIPPED.
"""
import json
import math
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

try:
    import numpy
except ImportError:
    print("SKIPPED: needs python3-numpy")
    sys.exit(0)

import readers

PLAY = sys.argv.pop(1)
HERE = Path(__file__).resolve().parent
SAMPLES = HERE.parents[2] / "samples/buttons"
RATE = 48000
PEAK_N = {"push": 4.0, "latch": 6.0}
HID_PRESS, HID_RELEASE = 0x1006, 0x1007  # HID usage tables 1.21, haptics page: WAVEFORM_PRESS, WAVEFORM_RELEASE
STANDARD_GRAVITY = 9.80665


def pressed(peak_N, down_s, presses=1, rest_s=0.02, held_s=0.08, up_s=0.1, gap_s=0.25):
    """Times in whole milliseconds and forces: raised cosines."""
    times, forces = [], []
    for k in range(round(1000 * presses * (rest_s + down_s + held_s + up_s + gap_s)) + 1):
        t = k / 1000 % (rest_s + down_s + held_s + up_s + gap_s) - rest_s
        if t <= 0:
            share = 0
        elif t < down_s:
            share = (1 - math.cos(math.pi * t / down_s)) / 2
        elif t < down_s + held_s:
            share = 1
        elif t < down_s + held_s + up_s:
            share = (1 + math.cos(math.pi * (t - down_s - held_s) / up_s)) / 2
        else:
            share = 0
        times.append(k / 1000)
        forces.append(round(peak_N * share, 9))
    return times, forces


class FollowForce(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = temporary.name

    def at(self, name):
        return os.path.join(self.folder, name)

    def export(self, button, name, ending, *options):
        out = self.at(f"{name}.{ending}")
        done = subprocess.run([PLAY, "export", SAMPLES / f"{button}.button.json", "--format", name, "-o", out, "--json", *options],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return out, json.loads(done.stdout)["loss"]

    def board(self, header, forces):
        """What a board meets and plays that follows the header."""
        program = self.at("board")
        subprocess.run(["cc", "-std=c99", "-Wall", "-Wextra", "-Werror", "-O2", "-include", header, HERE / "play_header.c", "-o", program,
                        "-lm"], check=True)
        told, samples = subprocess.run([program], input="\n".join(map(repr, map(float, forces))), capture_output=True, text=True,
                                       check=True).stdout.split("samples\n")
        met = {}
        for line in told.splitlines():
            _, sample, kind = line.split()
            met.setdefault(kind, []).append(int(sample) / RATE)
        return met, numpy.array(samples.split(), float)

    @unittest.skipUnless(shutil.which("cc"), "needs a C compiler")
    def test_a_board_meets_and_plays_what_the_engine_does(self):
        for button in ("A", "B", "C", "D", "E", "F", "push"):
            for down_s, feel in ((0.12, "clear"), (0.12, "paper"), (0.06, "clear")):
                with self.subTest(button=button, down_s=down_s, feel=feel):
                    times, forces = pressed(PEAK_N.get(button, 3.0), down_s)
                    trace = self.at("press.csv")
                    with open(trace, "w", encoding="utf-8") as file:
                        file.write("time_s,force_N\n" + "".join(f"{t},{f:.9f}\n" for t, f in zip(times, forces)))
                    options = ("--press", trace, "--feel", feel)
                    header, loss = self.export(button, "c", "h", *options)
                    met, played = self.board(header, numpy.interp(numpy.arange(int(times[-1] * RATE)) / RATE, times, forces))
                    engine = {}
                    with open(self.export(button, "package", "json", *options)[0], encoding="utf-8") as file:
                        for event in json.load(file)["example_press"]["events"]:
                            engine.setdefault(event["kind"], []).append(event["time_s"])
                    self.assertEqual({k: len(v) for k, v in met.items()}, {k: len(v) for k, v in engine.items()})
                    delays = [b - a for kind in met for a, b in zip(met[kind], engine[kind])]
                    self.assertLess(max(delays) - min(delays), 1e-3)
                    self.assertEqual(loss["worst_timing_error_ms"], 0)
                    before = readers.band_energies(readers.read_pcm(self.export(button, "pcm", "pcm.h", *options)[0])[1])
                    after = readers.band_energies(played)
                    for band, told in loss["energy_kept"].items():
                        if told is not None:
                            self.assertAlmostEqual(after[band] / before[band], told, delta=0.02 * told, msg=band)

    def test_a_touchpad_file_says_what_pads_take(self):
        for path in sorted(SAMPLES.glob("*.button.json")):
            button = path.name.split(".")[0]
            with self.subTest(button=button):
                name, loss = self.export(button, "touchpad", "json")
                with open(name, encoding="utf-8") as file:
                    pad = json.load(file)
                with open(self.export(button, "package", "json")[0], encoding="utf-8") as file:
                    state = json.load(file)["states"][0]
                self.assertEqual((pad["format"], pad["version"]), ("detent-touchpad", 1))
                self.assertTrue(110 <= pad["press_threshold_g"] <= 190)
                self.assertAlmostEqual(pad["press_threshold_N"], pad["press_threshold_g"] * STANDARD_GRAVITY / 1000, places=9)
                self.assertAlmostEqual(pad["release_threshold_g"], pad["press_threshold_g"] * pad["release_ratio"], places=9)
                self.assertEqual([int(pad["waveforms"][k], 16) for k in ("press", "release")], [HID_PRESS, HID_RELEASE])
                self.assertEqual(pad["intensity"]["range"], [0, 4])
                for stroke in ("press", "release"):
                    clicks = any(t["kind"] == "jump" and t["stroke"] == stroke for t in state["triggers"])
                    self.assertIn(pad["intensity"][stroke], range(1, 5) if clicks else (0,))
                if state["press_threshold"]:
                    own_g = state["press_threshold"]["force_N"] * 1000 / STANDARD_GRAVITY
                    self.assertAlmostEqual(pad["press_threshold_of_button_g"], own_g, places=6)
                    # Moved to what pads offer, and then told.
                    self.assertAlmostEqual(pad["press_threshold_g"], min(max(own_g, 110), 190), places=6)
                    self.assertEqual(any("outside" in words for words in loss["dropped"]), not 110 <= own_g <= 190)
                # Nothing of the wave is in the file, so nothing is kept and every grain is gone.
                for band, kept in loss["energy_kept"].items():
                    self.assertIn(kept, (0, None), band)
                self.assertEqual(pad["loss"], loss)


if __name__ == "__main__":
    unittest.main()
