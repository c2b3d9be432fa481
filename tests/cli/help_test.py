#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the --help of every program and of every subcommand, and refuses what only a programmer reads.

    help_test.py BIN_FOLDER

Values are named by words ("draft|standard"), a range ("1..64") or what they are ("NUMBER"), never as CLI11 names their C++ types.
"""

import re
import subprocess
import sys
import unittest
from pathlib import Path

PROGRAMS = ("detent-graph", "detent-import", "detent-play")
RAW = re.compile(r"\b(?:U?INT|FLOAT|ENUM|BOOLEAN)\b|->\d|\bvalue in \{|\bTEXT:|\bin \[")


def raw_parts(text):
    return [line.strip() for line in text.split("\n") if RAW.search(line)]


def helps(binary, words=()):
    """(words of the command, its help) of a program and all below it."""
    run = subprocess.run([binary, *words, "--help"], capture_output=True, text=True, timeout=60, check=True)
    yield words, run.stdout
    listed = re.search(r"(?ms)^Subcommands:\n(.*?)(?:\n\n|\Z)", run.stdout)
    for name in re.findall(r"(?m)^  (\S+)", listed.group(1)) if listed else ():
        yield from helps(binary, (*words, name))


class Help(unittest.TestCase):
    def test_nothing_raw_in_any_help(self):
        for program in PROGRAMS:
            commands = list(helps(BIN / program))
            if program == "detent-import":
                commands += helps(BIN / program, ("library",))
            else:
                self.assertGreater(len(commands), 4, f"{program}: its subcommands were not found")
            for words, text in commands:
                self.assertEqual(raw_parts(text), [], " ".join([program, *words]))

    def test_what_is_raw_is_seen(self):
        for raw in ("--page INT:INT in [1 - 1000000]", "--quality ENUM:value in {draft->0,precise->2}", "--gain FLOAT:0..10=1",
                    "--trials UINT=50",
                    "--condition TEXT:{quiet,masked}"):
            self.assertTrue(raw_parts(raw), raw)
        self.assertEqual(raw_parts("--jobs 1..1024=4  workers in parallel; a POINT, k(x) in N/mm; INTERVAL"), [])


if __name__ == "__main__":
    BIN = Path(sys.argv.pop())
    unittest.main()
