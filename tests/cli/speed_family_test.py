#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A button with graphs at several speeds, evaluated by scipy from its file's knots alone.

    speed_family_test.py --bin FOLDER

Needs Debian's python3-scipy: without it, SKIPPED.
"""

import argparse
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

    def test_what_the_commands_refuse_they_name(self):
        family = self.family([10.0, 100.0])
        plain = self.folder / "10.button.json"
        for arguments, code, part in (
                (("convert", plain, self.folder / "o.csv", "--speed", 10), 2, "--speed: is for a button with graphs at several"),
                (("convert", family, self.folder / "o.csv", "--speed", -1), 2, "above 0"),
                (("family", plain, plain, "--speeds", "10,10", "-o", self.folder / "o.button.json"), 3, "10 mm/s twice"),
                (("family", plain, plain, "--speeds", "10", "-o", self.folder / "o.button.json"), 2, "1 speeds for 2 buttons"),
                (("family", plain, plain, "--speeds", "10,20", "-o", self.folder / "o.csv"), 2, "is no button's name")):
            result = run("detent-graph", *arguments)
            self.assertEqual(result.returncode, code, result.stderr)
            self.assertIn(part, result.stderr)
        self.assertFalse((self.folder / "o.button.json").exists())
        self.assertIn("At 100 mm/s", run("detent-graph", "show", family).stdout)
        self.assertEqual(run("detent-graph", "check", family).returncode, 0)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--bin", type=pathlib.Path, required=True)
    ARGUMENTS, others = parser.parse_known_args()
    unittest.main(argv=["speed_family_test.py", *others])
