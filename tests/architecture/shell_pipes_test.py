#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Scripts with pipefail have no reader in a pipe that ends before its input does, such as `head`: now and then the writer is
killed by it, and the script ends with 141 though nothing is wrong. `sed -n 1,20p` reads to the end."""

import re
import subprocess
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
ENDS_EARLY = re.compile(r"(?<!\|)\|(?!\|)\s*(head\b|grep\s+(-\w*q|-m\b|--quiet)|sed\b[^|;)]*\d+q\b|awk\b[^|]*\bexit\b)")


def early_readers(text):
    """Numbers of the lines with such a reader; none without pipefail, where the writer's end does not count."""
    if not re.search(r"^\s*set\s.*pipefail", text, re.MULTILINE):
        return []
    return [number for number, line in enumerate(text.replace("|\n", "| ").split("\n"), 1)
            if ENDS_EARLY.search(line) and not line.lstrip().startswith("#")]


class ShellPipes(unittest.TestCase):
    def test_early_readers_are_found(self):
        for line, found in {"sort -rn | head -n 20": True, "sort |\n  head -n 1": True, "yes | grep -q y": True,
                            "ps | grep -aqE y": True, "ps | sed 5q": True, "ps | awk '{print; exit}'": True,
                            "ps | grep -m 1 y": True, "sort | sed -n 1,20p": False, "head -n 1 file": False,
                            "grep -q y file": False, "false || head file": False, "ps | grep y": False,
                            "# sort | head": False}.items():
            with self.subTest(line):
                self.assertEqual(bool(early_readers(f"set -euo pipefail\n{line}\n")), found)
                self.assertEqual(early_readers(line), [])

    def test_no_script_has_one(self):
        names = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.split("\n")
        scripts = {name: text for name in names if (ROOT / name).is_file() and not name.startswith("findings/")
                   for text in [(ROOT / name).read_bytes()[:200_000].decode(errors="replace")]
                   if re.match(r"#!.*\b(ba)?sh\b", text)}
        self.assertGreater(len(scripts), 10)
        self.assertEqual({name: lines for name, text in scripts.items() if (lines := early_readers(text))}, {})


if __name__ == "__main__":
    unittest.main()
