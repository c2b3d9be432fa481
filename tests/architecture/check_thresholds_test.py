#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Shows that check_thresholds.py fires, and that the copy ablate.py builds has a threshold wherever the sources have one."""

import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "bench"))
import ablate  # noqa: E402
import check_thresholds  # noqa: E402

SILENT = (
    "constexpr double reach = 0.3;",
    "  constexpr float kReach = 0.3F;",
    "constexpr double reach_px = 3, other = 0.5;",
    "struct SearchOptions {\n  double paperCost = 0.5;\n};",
    'constexpr char text[] = "// of the width";\nconstexpr double reach = 0.3;',
)
SAID = (
    "constexpr double reach_px = 3;",
    "constexpr double reach = 0.3;  // of the frame's width",
    "// Of the frame's width:\nconstexpr double reach = 0.3;",
    "constexpr double unreached = 0;",
    "constexpr int rounds = 3;",
    "struct Found {\n  double confidence = 1;\n};",
    "// constexpr double reach = 0.3;",
)


class Thresholds(unittest.TestCase):
    def test_silent_ones_are_named(self):
        for text in SILENT:
            with self.subTest(text):
                self.assertEqual(len(list(check_thresholds.silent_thresholds(text))), 1)

    def test_others_are_let_be(self):
        for text in SAID:
            with self.subTest(text):
                self.assertEqual(list(check_thresholds.silent_thresholds(text)), [])


class Copy(unittest.TestCase):
    def rewritten(self, text, bare=False, fixed=()):
        source = ablate.Source(ablate.ROOT / "importer/step/file.cpp", bare, text)
        return source.rewritten(set(fixed)), source.values

    def test_constants_and_defaults_ask(self):
        text, values = self.rewritten("constexpr double a = 0.3, b_px = 2;\nstruct SearchOptions {\n  float c = 1.5F;\n};\n")
        self.assertEqual(values, {"step/file.cpp:a": 0.3, "step/file.cpp:b_px": 2, "step/file.cpp:c": 1.5})
        self.assertIn('const double a = DETENT_TUNED(double, "step/file.cpp:a", 0.3), b_px = DETENT_TUNED(double, "step/file.cpp:b_px", 2);', text)
        self.assertIn('float c = DETENT_TUNED(float, "step/file.cpp:c", 1.5);', text)

    def test_what_is_no_threshold_stays(self):
        for text in ('// constexpr double a = 0.3;\n', 'auto t = "x = 0.25";\n', "constexpr double none = 0;\n", "struct Found {\n  double confidence = 1;\n};\n"):
            self.assertEqual(self.rewritten(text, bare=True)[1], {})

    def test_bare_fractions_ask_where_wanted(self):
        line = "  if (share > 0.35F) return 0.5 * share;\n"
        self.assertEqual(self.rewritten(line)[0], line)
        self.assertIn('DETENT_TUNED(float, "step/file.cpp:1:0.35", 0.35)', self.rewritten(line, bare=True)[0])

    def test_what_does_not_compile_stays_as_it_is(self):
        line = "constexpr int size = 4;\n"
        self.assertEqual(self.rewritten(line, fixed=["step/file.cpp:size", ("step/file.cpp", 1)])[0], line)


if __name__ == "__main__":
    unittest.main()
