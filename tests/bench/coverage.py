#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the tables of one room into docs/measurements/coverage.md.

coverage.py ROOM PROGRAM...: what PROGRAM prints takes the place of all between `<!-- ROOM -->` and `<!-- /ROOM -->`.
Wilson intervals are left out: the page states them by the number of measurements.
Rows of the knots of one button and of the coefficients of one curve become one row with the smallest and the largest share;
other estimates of one record become one row.
    tests/bench/coverage.py playback build/release/bin/detent_playback_coverage
"""

import re
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


def folded(tables: str) -> str:
    """The tables with one row for all knots of a button, and one for all coefficients of a curve."""
    lines, groups = [], {}
    for line in tables.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        name = re.sub(r"knot \d+ of (\d+)", r"knots 1 to \1", re.sub(r": c\d$", "", cells[0]))
        if len(cells) != 4 or name == cells[0]:
            lines.append(line)
            continue
        if name not in groups:
            groups[name] = (len(lines), cells[1], [])
            lines.append("")
        groups[name][2].append([float(cell.split()[0]) for cell in cells[2:]])
    for name, (place, count, shares) in groups.items():
        ranges = [f"{min(column):.1f} to {max(column):.1f}" for column in zip(*shares)]
        lines[place] = f"| {name} | {count} | {' | '.join(ranges)} |"
    return joined(re.sub(r" \(\d+(\.\d+)?–\d+(\.\d+)?\)", "", "\n".join(lines)))


def joined(tables: str) -> str:
    """The tables with one row for neighbouring rows of the same record and number of measurements ("record: estimate")."""
    lines, rows, previous = [], {}, None
    for line in tables.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        record, separator, estimate = cells[0].partition(": ")
        key = (record, cells[1]) if separator and len(cells) == 4 and cells[2] else None
        if key is None or key != previous:
            lines.append(line)
            rows[len(lines) - 1] = []
        if key:
            rows[len(lines) - 1].append((estimate, *cells[2:]))
        previous = key
    for place, estimates in rows.items():
        if len(estimates) > 1:
            cells = [cell.strip() for cell in lines[place].strip("|").split("|")]
            names, *figures = zip(*estimates)
            columns = [column[0] if len(set(column)) == 1 else "; ".join(column) for column in figures]
            name = cells[0].partition(": ")[0] + ": " + "; ".join(names)
            lines[place] = "| " + " | ".join([name, cells[1], *columns]) + " |"
    return "\n".join(lines)


def main(arguments: list[str]) -> int:
    if len(arguments) < 2:
        print(__doc__, file=sys.stderr)
        return 2
    room, *program = arguments
    tables = subprocess.run(program, check=True, capture_output=True, text=True).stdout
    tables = folded(tables)
    try:
        PAGE.write_text(with_section(PAGE.read_text(encoding="utf-8"), room, tables), encoding="utf-8")
    except ValueError as problem:
        print(f"coverage.py: {problem}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
