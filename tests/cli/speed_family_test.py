#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A button with graphs at several speeds, evaluated by scipy from its file's knots alone.

    speed_family_test.py --bin FOLDER --samples FOLDER

Needs Debian's python3-scipy: without it, SKIPPED.
"""

import argparse
import hashlib
import json
import pathlib
import subprocess
import tempfile
import unittest

try:
    import numpy as np
    from scipy.interpolate import CubicHermiteSpline, interp1d
except ImportError:
    print("SKIPPED: needs python3-scipy")
    raise SystemExit(0)

ARGUMENTS = None
X_MM = np.linspace(0, 4, 801)
# What buttons of one speed played before there were others. Who changes what they play on purpose writes the new ones.
RECORDED = {
    ("push", "sim:falcon"): "3dedadb452dfece7e726dbdfbfb950074f0f3b1021bbdbf3c00f946d6875936e",
    ("latch", "sim:rig"): "1b5c155a157e56376e4167d210c701c4f071b1669680725dbb7f4131fe62e57a",
    ("B", "sim:rig"): "bddbfbd18abf3ef242ba9b7559019823153c4a58bf67401e35de8e46594b2670",
    ("B", "wav"): "0ee96c64bda684a70fbbc84bc97f8cd2fe230db8e33c00fd882659224ced34dd",
    ("latch", "wav"): "71739696e71da1f45fec8e602e5057c54b627dfbb9a43b015366de5f44f8ecc9",
}


def run(program, *arguments):
    return subprocess.run([str(ARGUMENTS.bin / program), *map(str, arguments)], capture_output=True, text=True)


def knot(x, force, slope):
    return {"displacement_mm": x, "force_N": force, "slopeBefore_N_per_mm": slope, "slopeAfter_N_per_mm": slope}


def graph(speed):
    """A dome whose peak rises and moves with speed, and whose release falls."""
    up, down = 0.6 + 0.08 * np.log10(speed), 0.25 - 0.03 * np.log10(speed)
    peak = 1.0 + 0.05 * np.log10(speed)
    return {"press": [knot(0, 0.1, 0.4), knot(peak, up, 0), knot(2, 0.5 * up, 0), knot(4, 1.1 * up, 0.6)],
            "release": [knot(0, 0.05, 0.1), knot(1.6, down, 0), knot(4, 1.1 * up, 0.7)]}


def write(path, states):
    path.write_text(json.dumps({"format": "detent-button", "version": 5, "name": path.stem, "states": states}),
                    encoding="utf-8")
    return path


def force_N(knots, at_mm):
    """Of a curve without walls, piece by piece: a knot may be a corner."""
    force = np.empty_like(at_mm)
    at_mm = np.clip(at_mm, knots[0]["displacement_mm"], knots[-1]["displacement_mm"])
    for a, b in zip(knots, knots[1:]):
        inside = (at_mm >= a["displacement_mm"]) & (at_mm <= b["displacement_mm"])
        piece = CubicHermiteSpline([k["displacement_mm"] for k in (a, b)], [k["force_N"] for k in (a, b)],
                                   [a["slopeAfter_N_per_mm"], b["slopeBefore_N_per_mm"]])
        force[inside] = piece(at_mm[inside])
    return force


class SpeedFamily(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.speeds = [5.0, 20.0, 90.0, 200.0]

    def family(self, speeds):
        files = [write(self.folder / f"{speed:g}.button.json", [graph(speed)]) for speed in speeds]
        out = self.folder / "family.button.json"
        made = run("detent-graph", "family", *files, "--speeds", ",".join(map(str, speeds)), "-o", out)
        self.assertEqual(made.returncode, 0, made.stderr)
        return out

    def test_between_stated_speeds_the_force_is_what_scipy_says(self):
        family = self.family([20.0, 5.0, 200.0, 90.0])
        state = json.loads(family.read_text(encoding="utf-8"))["states"][0]
        self.assertEqual(state["speed_mm_per_s"], 20)
        members = sorted([state, *state["otherSpeeds"]], key=lambda m: m["speed_mm_per_s"])
        self.assertEqual([m["speed_mm_per_s"] for m in members], self.speeds)
        one = self.folder / "one.button.json"
        for stroke in ("press", "release"):
            table = np.array([force_N(m[stroke], X_MM) for m in members])
            at = interp1d(self.speeds, table, axis=0, bounds_error=False, fill_value=(table[0], table[-1]))
            for speed in (0.5, 5, 7.5, 20, 33.3, 90, 150, 199.9, 200, 5000):
                self.assertEqual(run("detent-graph", "convert", family, one, "--speed", speed).returncode, 0)
                written = json.loads(one.read_text(encoding="utf-8"))
                self.assertEqual(written["version"], 2)
                worst = np.max(np.abs(force_N(written["states"][0][stroke], X_MM) - at(speed)))
                self.assertLess(worst, 1e-12, f"{stroke} at {speed} mm/s")

    def test_a_button_of_one_speed_plays_the_bytes_it_played(self):
        out = self.folder / "played"
        for (name, device), recorded in RECORDED.items():
            button = ARGUMENTS.samples / f"{name}.button.json"
            if device == "wav":
                out = out.with_suffix(".wav")
                played = run("detent-play", "render", button, "--standard-press", "-o", out)
            else:
                out = out.with_suffix(".csv")
                played = run("detent-play", "force", button, "--device", device, "--seconds", 2, "--fast", "--log", out)
            self.assertEqual(played.returncode, 0, played.stderr)
            self.assertEqual(hashlib.sha256(out.read_bytes()).hexdigest(), recorded, f"{name} on {device}")

    def test_a_button_of_one_speed_is_written_as_it_was(self):
        for sample in sorted(ARGUMENTS.samples.glob("*.button.json")):
            out = self.folder / sample.name
            self.assertEqual(run("detent-graph", "convert", sample, out).returncode, 0)
            self.assertEqual(out.read_bytes(), sample.read_bytes(), sample.name)

    def test_force_says_why_a_family_cannot_be_played(self):
        files = [write(self.folder / f"{speed}.button.json", [{"press": [knot(0, 0.1, 0.4), knot(1, peak, 0), knot(4, 1.2, 0.6)],
                                                               "release": [knot(0, 0.05, 0.1), knot(1.5, low, 0), knot(4, 1.2, 0.7)]}])
                 for speed, peak, low in ((10, 0.9, 0.7), (100, 0.4, 0.1))]
        family = self.folder / "f.button.json"
        self.assertEqual(run("detent-graph", "family", *files, "--speeds", "10,1000", "-o", family).returncode, 0)
        self.assertIn("speeds-give-energy", run("detent-graph", "check", family).stdout)
        refused = run("detent-play", "force", family, "--device", "sim", "--seconds", 1, "--fast")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("the release at 10 mm/s lies up to", refused.stderr)
        one = self.folder / "one.button.json"
        self.assertEqual(run("detent-graph", "convert", family, one, "--speed", 1000).returncode, 0)
        self.assertEqual(run("detent-play", "force", one, "--device", "sim", "--seconds", 1, "--fast").returncode, 0)

    def test_a_press_at_a_stated_speed_sounds_as_the_button_of_that_speed(self):
        family = self.family([20.0, 5.0, 200.0, 90.0])
        peaks = {}
        for speed in (3.0, 5.0, 20.0, 50.0, 90.0, 200.0, 400.0):
            trace = self.folder / "trace.csv"
            times = [0, 0.05, 0.05 + 4.2 / speed, 0.15 + 4.2 / speed, 0.15 + 8.4 / speed]
            trace.write_text("time_s,displacement_mm\n" + "".join(
                f"{t:.9f},{x}\n" for t, x in zip(times, (-0.1, -0.1, 4.1, 4.1, -0.1))), encoding="utf-8")
            rendered = {}
            one = self.folder / "one.button.json"
            run("detent-graph", "convert", family, one, "--speed", speed)
            for name, button in (("family", family), ("one", one)):
                out = self.folder / f"{name}.wav"
                played = run("detent-play", "render", button, "--press", trace, "-o", out, "--json")
                self.assertEqual(played.returncode, 0, played.stderr)
                rendered[name] = out.read_bytes()
                if name == "family":
                    told = json.loads(played.stdout)["press_speed_mm_per_s"]
                    self.assertLess(abs(told / speed - 1), 1e-6)
            if speed != 50:  # between stated speeds the two speeds differ by rounding
                self.assertEqual(rendered["family"], rendered["one"], f"{speed} mm/s")
            peaks[speed] = hashlib.sha256(rendered["one"]).hexdigest()
        self.assertGreaterEqual(len(set(peaks.values())), 5)

    def test_a_press_at_a_stated_speed_is_exported_as_the_button_of_that_speed(self):
        family = self.family([20.0, 5.0, 90.0])
        one, trace = self.folder / "one.button.json", self.folder / "trace.csv"
        seen = set()
        for speed in (5.0, 90.0):
            times = [0, 0.05, 0.05 + 4.2 / speed, 0.15 + 4.2 / speed, 0.15 + 8.4 / speed]
            trace.write_text("time_s,displacement_mm\n" + "".join(
                f"{t:.9f},{x}\n" for t, x in zip(times, (-0.1, -0.1, 4.1, 4.1, -0.1))), encoding="utf-8")
            run("detent-graph", "convert", family, one, "--speed", speed)
            for kind in ("package", "c", "haptic", "pcm"):
                written = []
                for button in (family, one):
                    out = self.folder / f"export.{kind}"
                    made = run("detent-play", "export", button, "--format", kind, "--press", trace, "-o", out, "--json")
                    self.assertEqual(made.returncode, 0, made.stderr)
                    written.append(out.read_bytes())
                    told = json.loads(made.stdout).get("press_speed_mm_per_s")
                    self.assertEqual(told is not None, button == family)
                self.assertEqual(written[0], written[1], f"{kind} at {speed} mm/s")
                seen.add(hashlib.sha256(written[0]).hexdigest())
        self.assertEqual(len(seen), 8)

    def record(self, speed, name=None, timed=True, halves=1.0, release_speed=None, noise_N=0.002):
        """A force meter's log at 2000 Hz of a press and release of the dome, with noise."""
        chance = np.random.default_rng(int(1000 * speed))
        rate = 2000
        one = graph(speed)
        down = 4.0 / speed
        t = np.arange(0, down, 1 / rate)
        x = np.where(t < down / 2, t * speed * 2 * halves / (1 + halves), 0)
        x = np.where(t >= down / 2, 4 - (down - t) * speed * 2 / (1 + halves), x)
        back = release_speed or speed
        up = np.arange(0, 4.0 / back, 1 / rate)
        places = np.concatenate([x, 4 - up * back])
        forces = np.concatenate([force_N(one["press"], x), force_N(one["release"], 4 - up * back)])
        times = np.arange(len(places)) / rate
        path = self.folder / (name or f"at-{speed:g}.csv")
        with open(path, "w", encoding="utf-8") as file:
            file.write("Time (s),Travel (mm),Force (N)\n" if timed else "Travel (mm),Force (N)\n")
            for when, where, force in zip(times, places, forces + chance.normal(0, noise_N, len(places))):
                file.write((f"{when:.5f}," if timed else "") + f"{where:.4f},{force:.4f}\n")
        return path

    def test_timed_records_make_a_family(self):
        speeds = [20.0, 5.0, 90.0]
        out = self.folder / "recorded.button.json"
        made = run("detent-import", "--family", *map(self.record, speeds), "-o", out, "--json")
        self.assertEqual(made.returncode, 0, made.stderr)
        told = json.loads(made.stdout)
        self.assertEqual(told["warning_codes"], [])
        for record, speed in zip(told["records"], speeds):
            self.assertLess(abs(record["press_speed_mm_per_s"] / speed - 1), 0.01)
            self.assertLess(abs(record["release_speed_mm_per_s"] / speed - 1), 0.01)
        state = json.loads(out.read_text(encoding="utf-8"))["states"][0]
        members = [state, *state["otherSpeeds"]]
        self.assertEqual(members[0]["speed_mm_per_s"], told["records"][0]["press_speed_mm_per_s"])
        inner = X_MM[(X_MM > 0.05) & (X_MM < 3.95)]
        for member in members:
            truth = graph(min(speeds, key=lambda speed: abs(speed - member["speed_mm_per_s"])))
            for stroke in ("press", "release"):
                off = force_N(member[stroke], inner) - force_N(truth[stroke], inner)
                self.assertLess(np.sqrt(np.mean(off ** 2)), 0.003, f"{stroke} at {member['speed_mm_per_s']} mm/s")

    def test_records_that_are_no_family_are_refused_and_doubtful_ones_told(self):
        out = self.folder / "o.button.json"
        slow, fast = self.record(5.0), self.record(50.0)
        untimed, same = self.record(20.0, "untimed.csv", timed=False), self.record(5.1, "same.csv")
        for records, code, part in (
                ([slow], 2, "all that is there was pressed at one speed, 5 mm/s"),
                ([slow, same], 2, "at least one and a half times as fast"),
                ([slow, fast, same], 2, "it was pressed at 5.1 mm/s, as "),
                ([slow, untimed], 3, "no column of times tells how fast it was pressed"),
                ([slow, fast, slow, fast, slow], 2, "is given 5 records")):
            result = run("detent-import", "--family", *records, "-o", out)
            self.assertEqual(result.returncode, code, result.stderr)
            self.assertIn(part, result.stderr)
            self.assertFalse(out.exists())
        close, uneven = self.record(7.0), self.record(40.0, "uneven.csv", halves=2.0)
        apart = self.record(30.0, "apart.csv", release_speed=10.0)
        for records, code in (([slow, close], "speeds-close"), ([slow, uneven], "press-uneven"),
                              ([slow, apart], "release-apart")):
            result = run("detent-import", "--family", *records, "-o", out, "--json")
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual(json.loads(result.stdout)["warning_codes"], [code])
        self.assertEqual(run("detent-import", slow, fast).returncode, 2)

    def test_what_the_commands_refuse_they_name(self):
        family = self.family([10.0, 100.0])
        plain = self.folder / "10.button.json"
        for arguments, code, part in (
                (("convert", plain, self.folder / "o.csv", "--speed", 10), 2, "--speed: this option is for a button with graphs at several"),
                (("convert", family, self.folder / "o.csv", "--speed", -1), 2, "above 0"),
                (("family", plain, plain, "--speeds", "10,10", "-o", self.folder / "o.button.json"), 3, "two graphs at the speed 10 mm/s"),
                (("family", plain, plain, "--speeds", "10", "-o", self.folder / "o.button.json"), 2, "1 speeds for 2 buttons"),
                (("family", plain, plain, "--speeds", "10,20", "-o", self.folder / "o.csv"), 2, "not the name of a button file")):
            result = run("detent-graph", *arguments)
            self.assertEqual(result.returncode, code, result.stderr)
            self.assertIn(part, result.stderr)
        self.assertFalse((self.folder / "o.button.json").exists())
        self.assertIn("At 100 mm/s", run("detent-graph", "show", family).stdout)
        self.assertEqual(run("detent-graph", "check", family).returncode, 0)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--bin", type=pathlib.Path, required=True)
    parser.add_argument("--samples", type=pathlib.Path, required=True)
    ARGUMENTS, others = parser.parse_known_args()
    unittest.main(argv=["speed_family_test.py", *others])
