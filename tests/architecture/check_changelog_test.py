#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Each rule of check_changelog.py fires on a planted mistake, and only in the newest section."""

import sys
import unittest

sys.dont_write_bytecode = True
import check_changelog

OLD = "\n## 0.1.0 (2026-11-22)\n\n- " + "x" * 400 + "\n"


def lines_of(section):
    return [number for number, _ in check_changelog.findings("# Changelog\n\n## 0.2.0\n\n### Added\n\n" + section + OLD)]


class Rules(unittest.TestCase):
    def test_entries_within_the_limits_pass(self):
        self.assertEqual(lines_of("- " + "x" * 160 + "\n" + "- y\n" * 9 + "\n### Fixed\n\n- z\n\n<!-- for\nprograms -->\n"), [])

    def test_a_long_entry_is_found(self):
        self.assertEqual(lines_of("- " + "x" * 161 + "\n"), [7])

    def test_a_second_line_is_found(self):
        self.assertEqual(lines_of("- one\n  two\n"), [8])

    def test_an_eleventh_entry_is_found_once(self):
        self.assertEqual(lines_of("- y\n" * 12), [17])

    def test_the_release_below_an_empty_section_is_checked(self):
        release = "# Changelog\n\n## Unreleased\n\n## 0.2.0\n\n### Added\n\n- " + "x" * 161 + "\n" + OLD
        self.assertEqual([number for number, _ in check_changelog.findings(release)], [9])


if __name__ == "__main__":
    unittest.main()
