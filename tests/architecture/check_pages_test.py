#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Each rule of check_pages.py fires on a planted mistake, with its line."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
import check_pages

LONG = "word " * 22 + "x"
CASES = (
    ("[a](page.md) [b](page.md#first-part) [c](https://example.org/x)\n", []),
    ("[a](gone.md)\n", ["page.md:3: the link to gone.md leads nowhere"]),
    ("![a](gone.png)\n", ["page.md:3: the link to gone.png leads nowhere"]),
    ("[a](#no-part)\n", ["page.md:3: no heading of page.md has the anchor #no-part"]),
    ("```\n[a](gone.md) " + LONG + "\n```\n", []),
    ("| a | b |\n|---|---|\n| 1 | 2 |\n| 1 |\n", ["page.md:6: the row has 1 cells, its header 2"]),
    ("| a | b |\n|---|---|\n| 1 \\| 2 | 3 |\n", []),
    (LONG[:110] + "\n", []),
    ("    " + LONG + "\n", []),
    ("<!-- table: begin -->\n" + LONG + "\n<!-- table: end -->\n", []),
    (LONG + "\n", ["page.md:3: the line has 111 columns; at most 110 are allowed"]),
)


class Pages(unittest.TestCase):
    def found(self, text, linked=True, decision=False):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            docs = root / "docs" / ("develop/decisions" if decision else "")
            docs.mkdir(parents=True)
            name = "0001-page.md" if decision else "page.md"
            path = (docs / name).relative_to(root).as_posix()
            (root / "README.md").write_text(f"[page]({path})\n" if linked else "nothing\n")
            (docs / name).write_text("# Page\n\n" + text + "\n## First part\n")
            return [f"{Path(name).name}:{line}: {problem}" for name, line, problem in check_pages.findings(root)]

    def test_cases(self):
        for text, expected in CASES:
            self.assertEqual(self.found(text), expected, text)

    def test_an_orphan_is_found(self):
        self.assertEqual(self.found("", linked=False), ["page.md:1: no chain of links from README.md leads to this page"])

    def test_a_decision_is_a_page(self):
        self.assertEqual(self.found("line\n" * 60, decision=True), ["0001-page.md:1: the decision has 64 lines; at most 60 are allowed"])


if __name__ == "__main__":
    unittest.main()
