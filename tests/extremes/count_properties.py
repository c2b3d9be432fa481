#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Counts the properties (random cases against a claim) of every room and names each.

  count_properties.py [--at-least N] [--list]     exit code 1 below N, or where two in one file have one name
"""
import argparse
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROPERTY = re.compile(r'(?:holdsAlways|rc::prop|rc::check)\(\s*"([^"]+)"')


def room_of(file):
    parts = pathlib.Path(file).parts
    return parts[0] if parts[0] != "extremes" else parts[1].replace("_extremes_test.cpp", " at the extremes")


def properties_by_file():
    """Path below tests/ -> the names of its properties, where there are any."""
    found = {str(path.relative_to(ROOT / "tests")): PROPERTY.findall(path.read_text(encoding="utf-8")) for path in sorted((ROOT / "tests").rglob("*_test.cpp"))}
    return {file: names for file, names in found.items() if names}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--at-least", type=int, default=0)
    parser.add_argument("--list", action="store_true", help="print every name")
    arguments = parser.parse_args()
    rooms, doubled = {}, []
    for file, names in properties_by_file().items():
        doubled += [f"tests/{file}: {name}" for name in set(names) if names.count(name) > 1]
        rooms.setdefault(room_of(file), []).extend(names)
    for room, names in rooms.items():
        print(f"{len(names):4d}  {room}")
        if arguments.list:
            for name in names:
                print(f"        {name}")
    total = sum(len(names) for names in rooms.values())
    print(f"{total:4d}  properties")
    for name in doubled:
        print(f"two properties have one name: {name}")
    if total < arguments.at_least:
        print(f"fewer than {arguments.at_least}")
    return 1 if doubled or total < arguments.at_least else 0


if __name__ == "__main__":
    sys.exit(main())
