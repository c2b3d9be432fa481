#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A rise of cost is found, an announced one passes, and what is measured is what ran."""

import contextlib
import io
import json
import tempfile
import unittest
from pathlib import Path

import cost


class Check(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        cost.BASELINE, cost.CHANGELOG = Path(folder.name, "cost.json"), Path(folder.name, "CHANGELOG.md")
        self.keep(cost.instruction_sets())
        cost.CHANGELOG.write_text("# Changelog\n\n## Unreleased\n\n## 0.1.0\n\n- `cost: list of a page`\n")

    def keep(self, instruction_sets):
        kept = {"list of a page": {"instructions": 1000, "libraries": 5, "memory_MB": 4}}
        cost.BASELINE.write_text(json.dumps({"instruction_sets": instruction_sets, "jobs": kept}))

    def check(self, instructions, name="list of a page"):
        with contextlib.redirect_stdout(io.StringIO()) as said:
            fine = cost.check({name: cost.Cost(instructions, 5, 4)})
        return fine, said.getvalue()

    def test_within_five_percent_passes(self):
        self.assertTrue(self.check(1049)[0])
        self.assertTrue(self.check(600)[0])

    def test_a_rise_fails_and_names_the_job(self):
        fine, said = self.check(1051)
        self.assertFalse(fine)
        self.assertIn("ROSE     list of a page: +5.1 %", said)

    def test_an_announced_rise_passes_and_only_since_the_last_release(self):
        cost.CHANGELOG.write_text("# Changelog\n\n## Unreleased\n\n- Doubts are data (`cost: list of a page`).\n\n## 0.1.0\n")
        self.assertTrue(self.check(2000)[0])

    def test_counts_of_another_processor_are_not_compared(self):
        self.keep("sse9")
        fine, said = self.check(2000)
        self.assertTrue(fine)
        self.assertTrue(said.startswith("SKIPPED"))

    def test_a_job_without_a_count_fails(self):
        self.assertFalse(self.check(1, "import of a log")[0])


class Measured(unittest.TestCase):
    def test_every_job_names_files_that_are_there(self):
        for name, command in cost.JOBS.items():
            for argument in command:
                if argument.startswith(str(cost.SAMPLES)):
                    self.assertTrue(Path(argument).is_file(), f"{name}: {argument}")

    def test_a_program_that_fails_is_no_measurement(self):
        with tempfile.TemporaryDirectory() as folder, self.assertRaises((RuntimeError, FileNotFoundError)):
            cost.measured(["false"], folder)


if __name__ == "__main__":
    unittest.main()
