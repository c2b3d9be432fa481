#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
""".ci/changed_tests chooses the tests that a changed file calls for, and none that it does not."""

import importlib.machinery
import importlib.util
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
SCRIPT = str(Path(__file__).resolve().parents[2] / ".ci" / "changed_tests")
LOADER = importlib.machinery.SourceFileLoader("changed_tests", SCRIPT)
changed_tests = importlib.util.module_from_spec(importlib.util.spec_from_loader("changed_tests", LOADER))
LOADER.exec_module(changed_tests)

THROUGH = {name for names in changed_tests.THROUGH.values() for name in names}
FILES = {name: "" for name in THROUGH} | {
    "tests/importer/axes/axes_test.cpp": '#include "importer/axes/read_axes.h"\n',
    "tests/importer/axes/title_test.cpp": '#include "tests/importer/axes/drawn.h"\n',
    "tests/importer/axes/drawn.h": '#include "importer/axes/axis_titles.h"\n',
    "tests/editor/axes_test.cpp": '#include "importer/axes/read_axes.h"\n',
    "tests/playback/plant/plant_test.cpp": '#include "playback/plant.h"\n',
}
ALWAYS = {"cli", "extremes"}
IMPORTER = ALWAYS | set(changed_tests.THROUGH["importer"])


class Chosen(unittest.TestCase):
    def test_each_kind_of_file(self):
        axes, title = "tests/importer/axes/axes_test.cpp", "tests/importer/axes/title_test.cpp"
        for changed, expected in {
            ("importer/axes/read_axes.cpp",): IMPORTER | {axes},  # not the editor's test, which is of another room
            ("importer/axes/axis_titles.h",): IMPORTER | {title},  # through a header of the tests
            ("importer/axes/inner.cpp",): IMPORTER | {axes, title},  # nobody includes it: its folder
            ("importer/doubts.cpp",): IMPORTER,
            ("model/units.cpp",): ALWAYS,
            ("tests/importer/axes/drawn.h",): ALWAYS | {title},
            ("tests/playback/plant/plant_test.cpp",): ALWAYS | {"tests/playback/plant/plant_test.cpp"},
            ("README.md", "editor/translations/detent_de.ts"): ALWAYS,
            ("importer/doubts.cpp", "CMakeLists.txt"): {"."},
            ("tests/catch_main.cpp",): {"."},
        }.items():
            with self.subTest(changed=changed):
                self.assertEqual(changed_tests.labels(changed, FILES), expected)

    def test_tests_that_go_through_a_room_exist(self):
        root = Path(SCRIPT).parents[1]
        self.assertEqual([name for name in THROUGH if not (root / name).is_file()], [])

    def test_a_missing_one_is_said(self):
        with self.assertRaises(SystemExit):
            changed_tests.labels(["importer/doubts.cpp"], {})


if __name__ == "__main__":
    unittest.main()
