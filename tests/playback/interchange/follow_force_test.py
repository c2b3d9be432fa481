#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What asks for a force instead of a time: headers (`c`) and `touchpad`, by another hand than their writer's.

    follow_force_test.py DETENT_PLAY

A board that knows nothing but a header's own words (play_header.c) is given the force of a press, sample by sample. What it meets is held
against the events of the engine under the same press, what it plays against the loss told: jumps and bottom-outs within 1 ms of their
constant delay, energies within 2 %. The boards' programs of samples/firmware/triggered, which anyone may start from, must play the same under
the same forces, triggered_minimal.c all but the grains: whole presses, halves, second thoughts, both states of a self-locking button. Needs Debian's python3-numpy and a C compiler: without them, SKIPPED.
"""
import json
import math
import os
import re
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
FIRMWARE = HERE.parents[2] / "samples/firmware/triggered"
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


def turning(peak_N, peaks=(0.12, 0.03, 0.5, 0.2, 1, 0.6, 1, 0.07, 1, 0, 0, 1, 0.02, 0.4, 0, 0), between_s=0.09):
    """Half presses, pushes back on the way up and down, releases that think better of it."""
    times, forces, before = [0.0], [0.0], 0.0
    for peak in peaks:
        for k in range(1, round(1000 * between_s) + 1):
            times.append(times[-1] + 0.001)
            forces.append(round(peak_N * (before + (peak - before) * (1 - math.cos(math.pi * k / 1000 / between_s)) / 2), 9))
        before = peak
    return times, forces


EXAMPLE_BOARD = """
#include <stdio.h>
static float force_N;
float board_force_N(void);
void board_play(float sample);
void step(float);
float board_force_N(void) { return force_N; }
void board_play(float sample) { printf("%.9g\\n", (double)sample); }
int main(void) {
  while (scanf("%f", &force_N) == 1) step(48000);
  return 0;
}
"""
DOME = ("press,0,0.1", "press,0.3,1.6", "press,0.5,0.5", "press,1,0.6", "press,1,1.2",
        "release,1,1.2", "release,1,0.4", "release,0.8,0.25", "release,0.5,0.3", "release,0.3,0.7", "release,0,0.05")
STRICT = ["-Wall", "-Wextra", "-Wpedantic", "-Werror"]


class FollowForce(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = temporary.name

    def at(self, name):
        return os.path.join(self.folder, name)

    def file_of(self, button):
        """A sample, or a dome: its bottom-out, at 0.6 N, is pressed with the 1.6 N of its peak."""
        if button != "dome":
            return SAMPLES / f"{button}.button.json"
        with open(self.at("dome.csv"), "w", encoding="utf-8") as file:
            file.write("stroke,displacement_mm,force_N\n" + "".join(f"{row}\n" for row in DOME))
        subprocess.run([Path(PLAY).with_name("detent-graph"), "convert", self.at("dome.csv"), self.at("dome.button.json")],
                       check=True, capture_output=True)
        return self.at("dome.button.json")

    def export(self, button, name, ending, *options):
        out = self.at(f"{name}.{ending}")
        done = subprocess.run([PLAY, "export", self.file_of(button), "--format", name, "-o", out, "--json", *options],
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

    def example(self, source, header, forces):
        """What a program of the samples plays, as C99 and as C++; both the same."""
        for compiler, language in (("cc", ["-std=c99", "-x", "c"]), ("c++", ["-std=c++11", "-x", "c++"])):
            if not shutil.which(compiler):
                continue
            with open(self.at("board.c"), "w", encoding="utf-8") as file:
                file.write(EXAMPLE_BOARD)
            os.replace(header, self.at("button.h"))
            program = self.at("example")
            subprocess.run([compiler, *language, *STRICT, "-O2", "-I", self.folder, FIRMWARE / source, self.at("board.c"), "-lm", "-o", program],
                           check=True)
            os.replace(self.at("button.h"), header)
            yield numpy.array(subprocess.run([program], input="\n".join(map(repr, map(float, forces))), capture_output=True, text=True,
                                             check=True).stdout.split(), float)

    @unittest.skipUnless(shutil.which("cc"), "needs a C compiler")
    def test_the_examples_play_all_that_a_board_may(self):
        """triggered_minimal.c watches forces alone: it plays all of a button without grains."""
        for button in [*(path.name.split(".")[0] for path in sorted(SAMPLES.glob("*.button.json"))), "dome"]:
            peak_N = PEAK_N.get(button, 3.0)
            for source, mode in (("triggered.c", "full"), ("triggered_minimal.c", "click-only")):
                header, _ = self.export(button, "c", "h", "--mode", mode)
                for name, (times, forces) in (("three presses", pressed(peak_N, 0.12, presses=3)), ("turning", turning(peak_N))):
                    given = numpy.interp(numpy.arange(int(times[-1] * RATE)) / RATE, times, forces)
                    _, read = self.board(header, given)
                    for played in self.example(source, header, given):
                        with self.subTest(button=button, source=source, forces=name):
                            self.assertGreater(numpy.abs(played).max(), 0.05)
                            self.assertLess(numpy.abs(played - numpy.clip(read, -1, 1)).max(), 1e-3)

    def test_the_small_example_is_small(self):
        text = re.sub(r"/\*.*?\*/", "", (FIRMWARE / "triggered_minimal.c").read_text(encoding="utf-8"), flags=re.DOTALL)
        self.assertLessEqual(sum(1 for line in text.splitlines() if line.strip()), 60)

    @unittest.skipUnless(shutil.which("cc"), "needs a C compiler")
    def test_a_board_meets_and_plays_what_the_engine_does(self):
        def once(down_s):
            return lambda peak_N: pressed(peak_N, down_s)

        whole = ((once(0.12), "clear"), (once(0.12), "paper"), (once(0.06), "clear"))
        others = ((lambda peak_N: pressed(peak_N, 0.12, presses=3), "clear"), (turning, "clear"))
        for button in ("A", "B", "C", "D", "E", "F", "push", "latch", "EF", "dome"):
            for number, (press, feel) in enumerate(whole + others):
                with self.subTest(button=button, number=number, feel=feel):
                    times, forces = press(PEAK_N.get(button, 3.0))
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
                    # A finger that turns halfway meets grains up to 0.8 ms beside the engine's own times: their sums differ by 6 %.
                    if number >= len(whole):
                        continue
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
