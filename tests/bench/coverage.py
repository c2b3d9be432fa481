#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the tables of one room into docs/measurements/coverage.md.

coverage.py ROOM PROGRAM...: what PROGRAM prints takes the place of all between `<!-- ROOM -->` and `<!-- /ROOM -->`.
    tests/bench/coverage.py playback build/release/tests/bench/detent_playback_coverage
"""

import subprocess
import sys
from pathlib import Path

PAGE = Path(__file__).resolve().parents[2] / "docs/measurements/coverage.md"


def with_section(page: str, room: str, tables: str) -> str:
    """The page with what stands between the room's two markers exchanged. ValueError where a marker is missing."""
    begin, end = f"<!-- {room} -->\n", f"<!-- /{room} -->"
    before, opened, rest = page.partition(begin)
    _, closed, after = rest.partition(end)
    if not opened or not closed:
        raise ValueError(f"{PAGE.name} has no {begin.strip()} and {end}")
    return before + begin + tables.strip("\n") + "\n\n" + end + after


def main(arguments: list[str]) -> int:
    if len(arguments) < 2:
        print(__doc__, file=sys.stderr)
        return 2
    room, *program = arguments
    tables = subprocess.run(program, check=True, capture_output=True, text=True).stdout
    try:
        PAGE.write_text(with_section(PAGE.read_text(encoding="utf-8"), room, tables), encoding="utf-8")
    except ValueError as problem:
        print(f"coverage.py: {problem}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
