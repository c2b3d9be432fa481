#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What exported files say they lost, recounted by the players in readers.py; the exact formats against the engine's own samples.

    recount_test.py DETENT_PLAY [--table]

Bars: exact formats within 1e-3 of full scale at every sample; energies within 2 %; jumps and bottom-outs within 1 ms. Where
DETENT_MPEG_SYNTHESIZER names the synthesizer of MPEG's reference software, HJIF is also played by it. --table prints every figure
instead. Needs Debian's python3-numpy: without it, SKIPPED.
"""
import json
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

TABLE = "--table" in sys.argv
PLAY = sys.argv[1]
SAMPLES = Path(__file__).resolve().parents[3] / "samples/buttons"
ENDINGS = {"package": "json", "ahap": "ahap", "haptic": "haptic", "android": "kt", "openxr": "json", "hjif": "hjif", "bos1921": "h",
           "da728x": "h", "drv2605": "h", "pcm": "h"}
OWN_TESTS = {"c": "h", "touchpad": "json"}  # nothing of them is played as it stands
EXACT = ("package", "hjif", "pcm")
BUTTONS = ("A", "B", "C", "D", "E", "F", "latch", "push")


class Workplace:
    """A folder for exports, gone with the object."""

    def __init__(self):
        self.folder = tempfile.mkdtemp()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        shutil.rmtree(self.folder)

    def export(self, button, name, press="standard", feel="clear"):
        out = os.path.join(self.folder, f"out.{(ENDINGS | OWN_TESTS)[name]}")
        done = subprocess.run([PLAY, "export", SAMPLES / f"{button}.button.json", "--format", name, "--press", press, "--feel", feel,
                               "-o", out, "--json"], capture_output=True, text=True, check=False)
        if done.returncode:
            raise AssertionError(f"{button} {name} {press}: {done.stderr}")
        return out, json.loads(done.stdout)["loss"]

    def halves(self, button, name, press="standard", feel="clear"):
        """The file as it is played, and what it says of itself."""
        out, loss = self.export(button, name, press, feel)
        if name == "pcm":
            return [readers.Half(readers.read_pcm(out)[1], [])], loss
        if name == "ahap":
            return [readers.read_ahap(out.replace(".ahap", f".{half}.ahap")) for half in ("press", "release")], loss
        if name == "android":
            return [half["envelope"] or half["steps"] or readers.Half([0.0], []) for half in readers.read_android(out)], loss
        return getattr(readers, "read_" + name)(out), loss

    def met(self, button, press, feel):
        """Sample, kind and place of every event of a press."""
        with open(self.export(button, "package", press, feel)[0], encoding="utf-8") as file:
            return [(e["sample"], e["kind"], e["displacement_mm"]) for e in json.load(file)["example_press"]["events"]]

    def rendered(self, button, feel="clear"):
        wave = os.path.join(self.folder, "render.wav")
        subprocess.run([PLAY, "render", SAMPLES / f"{button}.button.json", "--standard-press", "--feel", feel, "-o", wave],
                       check=True, capture_output=True)
        return readers.read_wave(wave)[1]

    def engine(self, button, press, feel):
        """The engine's samples of any press: what `pcm` holds, which the test of the exact formats holds against `render`."""
        return readers.read_pcm(self.export(button, "pcm", press, feel)[0])[1]

    def events(self, button, press, feel):
        """Times of jumps and bottom-outs on the way down, and of jumps on the way up."""
        package = json.load(open(self.export(button, "package", press, feel)[0], encoding="utf-8"))["example_press"]["events"]
        return [[e["time_s"] for e in package if e["kind"] in kinds] for kinds in (("press_jump", "bottom_out"), ("release_jump",))]


def largest_difference(a, b):
    length = max(len(a), len(b))
    wide = [numpy.concatenate((x, numpy.zeros(length - len(x)))) for x in (a, b)]
    return numpy.abs(wide[0] - wide[1]).max()


def worst_onset_ms(events, places):
    """From each event to the nearest of the file's places. Time 0 of a half is its own: it lies where that fits best."""
    if not events or not places:
        return 1e3 * (max(events) if events else 0)
    places = numpy.array(places)
    zeros = [event - place for event in events for place in places]
    return min(max(numpy.abs(places + zero - event).min() for event in events) for zero in zeros) * 1e3


def figures(place, button, name, press, feel, engine):
    """Energy told and found per band, worst onset told and found (ms)."""
    halves, loss = place.halves(button, name, press, feel)
    before = readers.band_energies(engine)
    found = {band: sum(readers.band_energies(half.samples)[band] for half in halves) / before[band] if before[band] > 0 else None
             for band in before}
    down, up = place.events(button, press, feel)
    if len(halves) == 1:
        points = numpy.array(halves[0].points)
        worst = max((numpy.abs(points - event).min() for event in down + up), default=0) * 1e3 if len(points) else 0
    else:
        worst = max(worst_onset_ms(down, halves[0].points), worst_onset_ms(up, halves[1].points))
    return loss, found, worst


class Recount(unittest.TestCase):
    def test_exact_formats_give_the_engines_samples(self):
        with Workplace() as place:
            for feel in ("clear", "paper"):
                for button in ("A", "B", "F", "latch"):
                    original = place.rendered(button, feel)
                    for name in EXACT:
                        with self.subTest(button=button, format=name, feel=feel):
                            halves, loss = place.halves(button, name, feel=feel)
                            self.assertLess(largest_difference(halves[0].samples, original), 1e-3)
                            self.assertEqual(loss["worst_timing_error_ms"], 0)

    def test_a_package_has_the_equalizer_and_the_limiter(self):
        """A device four times too loud whose resonance is flattened: the limiter turns every jump down."""
        with Workplace() as place:
            profile = os.path.join(place.folder, "loud.device")
            with open(profile, "w", encoding="utf-8") as file:
                file.write("detent-device 1\ngain = 4\nequalizer = 390 8 -6\nequalizer = 150 2 3\n")
            for feel in ("clear", "paper"):
                for button in BUTTONS:
                    with self.subTest(button=button, feel=feel):
                        options = ["--profile", profile, "--equalizer", "full", "--feel", feel]
                        path = SAMPLES / f"{button}.button.json"
                        out, wave = os.path.join(place.folder, "out.json"), os.path.join(place.folder, "out.wav")
                        for arguments in (["export", path, "--format", "package", "-o", out],
                                          ["render", path, "--standard-press", "-o", wave]):
                            subprocess.run([PLAY, *arguments, *options], check=True, capture_output=True)
                        self.assertTrue(json.load(open(out, encoding="utf-8"))["example_press"]["limiter_gain"]["points"])
                        self.assertLess(largest_difference(readers.read_package(out)[0].samples, readers.read_wave(wave)[1]), 1e-3)

    def test_what_is_told_is_what_is_found(self):
        with Workplace() as place:
            for button, press, feel in (("A", "standard", "clear"), ("B", "standard", "clear"), ("B", "standard", "paper"),
                                        ("C", "human:60ms", "clear"), ("latch", "human:300ms", "clear")):
                engine = place.engine(button, press, feel)
                for name in ENDINGS:
                    if name in EXACT:
                        continue
                    with self.subTest(button=button, press=press, format=name, feel=feel):
                        loss, found, worst = figures(place, button, name, press, feel, engine)
                        for band, told in loss["energy_kept"].items():
                            self.assertAlmostEqual(found[band], told, delta=0.02 * told + 1e-3, msg=band)
                        self.assertLessEqual(loss["worst_timing_error_ms"], 1)
                        self.assertLessEqual(worst, 1)

    def test_a_header_sounds_as_its_loss_record_says(self):
        with Workplace() as place:
            for button in ("A", "B", "C", "D", "E", "F", "push"):
                for press, feel in (("standard", "clear"), ("standard", "paper"), ("human:60ms", "clear")):
                    with self.subTest(button=button, press=press, feel=feel):
                        out, loss = place.export(button, "c", press, feel)
                        header = readers.read_c_header(out)
                        if header is None:
                            self.skipTest("needs a C compiler")
                        engine = place.engine(button, press, feel)
                        before = readers.band_energies(engine)
                        after = readers.band_energies(readers.play_c_header(header, place.met(button, press, feel), len(engine)))
                        for band, told in loss["energy_kept"].items():
                            if told is not None:
                                self.assertAlmostEqual(after[band] / before[band], told, delta=0.02 * told + 1e-3, msg=band)

    def test_a_pad_clicks_where_the_button_does(self):
        with Workplace() as place:
            for button in BUTTONS:
                with self.subTest(button=button):
                    pad = readers.read_touchpad(place.export(button, "touchpad")[0])
                    with open(place.export(button, "package")[0], encoding="utf-8") as file:
                        state = json.load(file)["states"][0]
                    press, release = state["press_threshold"], state["release_threshold"]
                    if press:
                        self.assertAlmostEqual(pad["press_threshold_g"], min(max(press["force_g"], 110), 190), delta=0.1)
                    self.assertEqual(pad["release_ratio_known"], bool(press and release))
                    if pad["release_ratio_known"]:
                        ratio = release["force_N"] / press["force_N"]
                        self.assertAlmostEqual(pad["release_ratio"], min(max(ratio, 0.05), 1), delta=1e-3)
                    jumps = [max((t["wave"]["amplitude"] for t in state["triggers"] if (t["kind"], t["stroke"]) == ("jump", stroke)),
                                 default=0) for stroke in ("press", "release")]
                    for stroke, jump in zip(("press", "release"), jumps):
                        self.assertEqual(pad["intensity"][stroke], min(max(int(4 * jump + 0.5), 1), 4) if jump else 0)

    def test_the_reference_software_plays_the_same(self):
        synthesizer = os.environ.get("DETENT_MPEG_SYNTHESIZER")
        if not synthesizer:
            print("SKIPPED MPEG's synthesizer: DETENT_MPEG_SYNTHESIZER does not name it")
            return
        with Workplace() as place:
            for feel in ("clear", "paper"):
                for button in BUTTONS:
                    with self.subTest(button=button, feel=feel):
                        out, _ = place.export(button, "hjif", feel=feel)
                        wave = os.path.join(place.folder, "mpeg.wav")
                        done = subprocess.run([synthesizer, "-f", out, "-o", wave, "-fs", "48000"], capture_output=True, text=True,
                                              check=False)
                        self.assertTrue(os.path.exists(wave), done.stdout + done.stderr)
                        self.assertLess(largest_difference(readers.read_any_wave(wave), place.rendered(button, feel)), 1e-3)
                        os.remove(wave)


def table():
    print("| button | press | feel | format | told | found | onset told, ms | onset found, ms |\n|---|---|---|---|---|---|---|---|")
    with Workplace() as place:
        for feel in ("clear", "paper"):
            for button in BUTTONS:
                for press in ("standard", "human:60ms", "human:500ms"):
                    engine = place.engine(button, press, feel)
                    for name in ENDINGS:
                        loss, found, worst = figures(place, button, name, press, feel, engine)
                        told = loss["energy_kept"]
                        text = lambda shares: ", ".join("-" if v is None else f"{v:.3f}" for v in shares.values())
                        off = max((abs(found[b] - told[b]) / told[b] for b in told if told[b]), default=0)
                        print(f"| {button} | {press} | {feel} | {name} | {text(told)} | {text(found)} ({100 * off:.1f} %) | "
                              f"{loss['worst_timing_error_ms']:.2f} | {worst:.2f} |")


if __name__ == "__main__":
    if TABLE:
        table()
    else:
        unittest.main(argv=sys.argv[:1])
