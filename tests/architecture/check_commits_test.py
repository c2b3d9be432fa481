#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""check_commits.py accepts imperative subjects and refuses others."""

import sys
import unittest

sys.dont_write_bytecode = True
import check_commits

GOOD = ("importer: reject axis units that contradict the named quantity", "editor, playback: share one unit parser",
        "tests/architecture: check commit subjects", "release: cut 0.3.0", 'Revert "docs: sort pages"', "study: process answers once")
BAD = ("A misread ü is one letter: ti as well as ii", "importer: rejects wrong units", "importer: rejected wrong units",
       "importer: Reject wrong units", "fix things", "docs: " + "x" * 67, "editor: handling of names")


class Subjects(unittest.TestCase):
    def test_good(self):
        for subject in GOOD:
            self.assertIsNone(check_commits.problem_of(subject), subject)

    def test_bad(self):
        for subject in BAD:
            self.assertIsNotNone(check_commits.problem_of(subject), subject)


if __name__ == "__main__":
    unittest.main()
