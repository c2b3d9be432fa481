#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""detent-play magnetic: its C table, compiled and asked for places; its simulation's limits; what it refuses.

    magnetic_test.py --program DETENT-PLAY --samples FOLDER --cc C-COMPILER --cxx C++-COMPILER
"""

import argparse
import csv
import json
import pathlib
import re
import subprocess
import tempfile
import unittest

ARGUMENTS = None

ASKING = """
#include <stdio.h>
#include "key.h"
int main(void) {
  double reading;
  while (scanf("%lf", &reading) == 1) {
    double place = (reading - DETENT_READING_AT_REST) * 255.0 / (DETENT_READING_AT_END - DETENT_READING_AT_REST);
    int i = place < 0 ? 0 : place > 254 ? 254 : (int)place;
    printf("%u ", (unsigned)detent_travel_um_at((int32_t)reading));
    printf("%.6f\\n", detent_travel_um[i] + (place - i) * ((double)detent_travel_um[i + 1] - (double)detent_travel_um[i]));
  }
  return 0;
}
"""


def law(displacement):
    """Counts of a falling sensor, as no magnet of the program's gives them."""
    return 3000 - 400 * displacement - 60 * displacement ** 2


class Magnetic(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)
        self.addCleanup(self.temporary.cleanup)

    def magnetic(self, *options, button="C"):
        return subprocess.run([ARGUMENTS.program, "magnetic", str(ARGUMENTS.samples / f"{button}.button.json"),
                               *map(str, options)], capture_output=True, text=True)

    def settings(self, *options):
        result = self.magnetic("--json", *options)
        self.assertEqual(result.returncode, 0, result.stderr)
        return {one["rapid_trigger_mm"]: one for one in reversed(json.loads(result.stdout)["settings"])}

    def measured(self):
        path = self.folder / "readings.csv"
        rows = [f"{i / 50},{law(i / 50)}" for i in range(201)]
        path.write_text("displacement_mm,reading\n" + "\n".join(rows) + "\n")
        return path

    def test_the_table_turns_readings_back(self):
        out = self.folder / "key.h"
        result = self.magnetic("--readings", self.measured(), "-o", out)
        self.assertEqual(result.returncode, 0, result.stderr)
        source = self.folder / "asking.c"
        source.write_text(ASKING)
        for compiler, standard in ((ARGUMENTS.cc, ["-std=c99"]), (ARGUMENTS.cxx, ["-std=c++17", "-x", "c++"])):
            program = self.folder / "asking"
            subprocess.run([compiler, *standard, "-Wall", "-Wextra", "-pedantic", "-Werror", str(source), "-o", str(program)],
                           check=True)
            places = [i / 97 * 4 for i in range(98)]
            told = subprocess.run([str(program)], input="\n".join(str(law(x)) for x in places), text=True,
                                  capture_output=True, check=True).stdout.splitlines()
            for place, line in zip(places, told):
                whole, um = line.split()
                self.assertAlmostEqual(float(um) / 1000, place, delta=0.005)
                # A reading cut to whole counts, and micrometres cut to whole ones; a plain entry is up to 32 micrometres off.
                self.assertAlmostEqual(float(whole) / 1000, place, delta=0.005 + 1 / 400 + 0.001)
        self.assertNotIn("ASSUMED", out.read_text())

    def test_the_error_in_the_header_holds_for_every_whole_reading(self):
        pairs = [(i / 50, 2000.4 + 60 * i / 50 + 90 * (i / 50) ** 2) for i in range(201)]
        readings = self.folder / "rising.csv"
        readings.write_text("displacement_mm,reading\n" + "\n".join(f"{x},{r}" for x, r in pairs) + "\n")
        result = self.magnetic("--readings", readings, "-o", self.folder / "key.h")
        self.assertEqual(result.returncode, 0, result.stderr)
        told = float(re.search(r"is off by up to ([0-9.]+) mm", (self.folder / "key.h").read_text())[1])
        (self.folder / "asking.c").write_text(ASKING)
        subprocess.run([ARGUMENTS.cc, "-std=c99", str(self.folder / "asking.c"), "-o", str(self.folder / "asking")], check=True)
        whole = range(2001, int(pairs[-1][1]) + 1)
        lines = subprocess.run([str(self.folder / "asking")], input="\n".join(map(str, whole)), text=True,
                               capture_output=True, check=True).stdout.splitlines()
        worst = 0
        for reading, line in zip(whole, lines):
            (x0, r0), (x1, r1) = next((a, b) for a, b in zip(pairs, pairs[1:]) if a[1] <= reading <= b[1])
            worst = max(worst, abs(int(line.split()[0]) / 1000 - (x0 + (reading - r0) / (r1 - r0) * (x1 - x0))))
        self.assertAlmostEqual(told, worst, delta=1e-4)

    def test_the_sensor_along_the_travel(self):
        out = self.folder / "sensor.csv"
        self.magnetic("--readings", self.measured(), "--noise", 4, "-o", out)
        with open(out, newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 201)
        for row in rows:
            x = float(row["displacement_mm"])
            self.assertAlmostEqual(float(row["reading"]), law(x), delta=0.1)
            self.assertAlmostEqual(float(row["noise_mm"]), 4 / (400 + 120 * x), delta=2e-4)

    def test_without_readings_it_says_assumed_the_same_every_time(self):
        result = self.magnetic("--json", "-o", self.folder / "key.h")
        again = self.magnetic("--json", "-o", self.folder / "key.h")
        self.assertEqual(result.stdout, again.stdout)
        self.assertEqual(json.loads(result.stdout)["readings"], "assumed")
        self.assertIn("ASSUMED", (self.folder / "key.h").read_text())

    def test_limits_of_the_simulation(self):
        quiet = self.settings("--readings", self.measured(), "--noise", 0)
        fixed = quiet[None]
        self.assertEqual((fixed["lost_per_1000"], fixed["doubled_per_1000"], fixed["lets_go_per_minute"]), (0, 0, 0))
        # A finger that trembles counts twice the more easily the less travel is asked for.
        doubled = [quiet[mm]["doubled_per_1000"] for mm in (0.1, 0.2, 0.3, 0.5, 1.0)]
        self.assertEqual(doubled, sorted(doubled, reverse=True))
        # Noise far above the rapid trigger's way makes a held key let go; fixed points 0.6 mm apart do not care.
        loud = self.settings("--readings", self.measured(), "--noise", 60)
        self.assertGreater(loud[0.1]["lets_go_per_minute"], 100)
        self.assertEqual(loud[None]["lets_go_per_minute"], 0)
        # Scanned so rarely that a press falls between two readings.
        rare = self.settings("--scan-ms", 100, "--noise", 0)
        self.assertGreater(rare[None]["lost_per_1000"], 0)

    def test_rapid_trigger_with_all_its_settings(self):
        out = self.folder / "key.h"
        self.assertEqual(self.magnetic("--rapid-trigger", 0.2, "-o", out).returncode, 0)
        macros = dict(re.findall(r"#define (DETENT_\w+_UM|DETENT_RAPID_CONTINUOUS) (\d+)", out.read_text()))
        self.assertEqual(macros, {"DETENT_TRAVEL_UM": "4000", "DETENT_ACTUATE_UM": "2000", "DETENT_RESET_UM": "1400",
                                  "DETENT_RAPID_UM": "200"})
        result = self.magnetic("--rapid-trigger", 0.2, "--rapid-release", 0.35, "--continuous", "--top-dead-zone", 0.1,
                               "--bottom-dead-zone", 0.25, "--json", "-o", out)
        self.assertEqual(result.returncode, 0, result.stderr)
        macros |= {"DETENT_RAPID_RELEASE_UM": "350", "DETENT_RAPID_CONTINUOUS": "1", "DETENT_TOP_DEAD_ZONE_UM": "100",
                   "DETENT_BOTTOM_DEAD_ZONE_UM": "250"}
        self.assertEqual(dict(re.findall(r"#define (DETENT_\w+_UM|DETENT_RAPID_CONTINUOUS) (\d+)", out.read_text())), macros)
        subprocess.run([ARGUMENTS.cc, "-std=c99", "-Wall", "-pedantic", "-Werror", "-fsyntax-only", str(out)], check=True)
        told = json.loads(result.stdout)
        self.assertEqual((told["top_dead_zone_mm"], told["bottom_dead_zone_mm"]), (0.1, 0.25))
        chosen = told["settings"][0]
        self.assertEqual((chosen["rapid_trigger_mm"], chosen["rapid_release_mm"], chosen["continuous"]), (0.2, 0.35, True))
        self.assertIn("0.2/0.35 mm", result.stderr)

    def test_a_bottom_dead_zone_holds_a_noisy_key(self):
        noisy = ("--readings", self.measured(), "--noise", 20, "--rapid-trigger", 0.05)
        free = self.settings(*noisy)[0.05]
        self.assertGreater(free["lets_go_per_minute"], 100)
        # Longer upwards, it lets go less often where there is no dead zone.
        kept = self.settings(*noisy, "--bottom-dead-zone", 0.5, "--rapid-release", 0.4)[0.05]
        self.assertEqual(kept["lets_go_per_minute"], 0)
        self.assertLess(kept["lets_go_shallow_per_minute"], free["lets_go_shallow_per_minute"])

    def test_what_is_refused(self):
        bad = self.folder / "bad.csv"
        out = self.folder / "key.h"
        for text in ("", "x,y\n1,2\n", "displacement_mm,reading\n0,1\n", "displacement_mm,reading\n0,1\n1,3\n2,2\n",
                     "displacement_mm,reading\n0,1\n0,2\n", "displacement_mm,reading\n0,1\n1,nan\n"):
            bad.write_text(text)
            result = self.magnetic("--readings", bad, "-o", out)
            self.assertEqual(result.returncode, 3, text + result.stderr)
            self.assertEqual(result.stderr.count("\n"), 1)
        self.assertEqual(self.magnetic("--readings", self.folder / "none.csv").returncode, 3)
        self.assertEqual(self.magnetic("-o", self.folder / "key.txt").returncode, 2)
        for options in (("--reset-at", 3), ("--noise", -1), ("--operate-at", 9), ("--rapid-release", 0.3),
                        ("--continuous",), ("--rapid-trigger", 0), ("--rapid-trigger", 5), ("--bottom-dead-zone", "nan"),
                        ("--rapid-trigger", 0.1, "--rapid-release", 5), ("--top-dead-zone", 1.5), ("--bottom-dead-zone", 2.1)):
            self.assertEqual(self.magnetic(*options, "-o", out).returncode, 2, options)
        self.assertEqual(self.magnetic(button="latch").returncode, 2)
        self.assertFalse(out.exists())


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", required=True)
    parser.add_argument("--samples", type=pathlib.Path, required=True)
    parser.add_argument("--cc", required=True)
    parser.add_argument("--cxx", required=True)
    ARGUMENTS, rest = parser.parse_known_args()
    unittest.main(argv=[__file__, *rest])
