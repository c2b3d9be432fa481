#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Counts the words that docs/reference/glossary.md forbids: check_words.py ROOT [--accept | --list ROOM [WORD]]

The table "Words to avoid" of the glossary names the words and where they are looked for:
- comments: text of C++ comments and names of tests;
- identifiers: parts of identifiers in C++ code ("inkPieces" has the parts "ink" and "pieces");
- whole identifiers: complete identifiers in C++ code;
- comment openings: first word of a comment.

Names of other libraries (FOREIGN) do not count.

Fails if a room has more of them than words_baseline.json beside this script allows. --accept lowers the baseline to what is
found and never raises it. --list prints FILE:LINE: WORD of one room.
"""

import argparse
import json
import re
import sys
from collections import Counter
from pathlib import Path

FOREIGN = {"fz_walk_path"}  # names of other libraries that this code cannot change
ROOMS = ("model", "importer", "playback", "editor", "tests", "samples")
BASELINE = Path(__file__).with_name("words_baseline.json")
PIECE = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|[A-Za-z_]\w*', re.S)
TEST_NAME = re.compile(r'\b(?:TEST_CASE|SECTION|holdsAlways)\(\s*"((?:\\.|[^"\\])*)"')
PART = re.compile(r"[A-Z]?[a-z]+|[A-Z]+(?![a-z])")


class Rules:
    """The table "Words to avoid"."""

    def __init__(self, glossary):
        table = glossary.partition("## Words to avoid")[2]
        rows = [[cell.strip() for cell in line.strip().strip("|").split("|")] for line in table.splitlines() if line.startswith("|")]
        words = {"comments": set(), "identifiers": set(), "whole identifiers": set(), "comment openings": set()}
        for _, avoided, places in rows[2:]:
            for place in places.split(","):
                words[place.strip()].update(word.strip() for word in avoided.split(","))
        if not words["comments"]:
            raise SystemExit("docs/reference/glossary.md has no table 'Words to avoid'.")
        self.parts, self.whole = words["identifiers"], words["whole identifiers"]
        longest_first = sorted(words["comments"], key=len, reverse=True)
        self.comments = re.compile(r"(?<![\w-])(?:" + "|".join(map(re.escape, longest_first)) + r")(?![\w-])", re.I)
        self.openings = re.compile(r"(?:" + "|".join(sorted(words["comment openings"])) + r")\b")


def findings(text, rules):
    """Yields (position, word) for each forbidden word of a C++ file."""
    for name in TEST_NAME.finditer(text):
        for found in rules.comments.finditer(name[1]):
            yield name.start(1) + found.start(), found[0].lower()
    previous_end = -1  # of a comment: the lines of one comment have one opening
    for match in PIECE.finditer(text):
        piece = match[0]
        if piece.startswith(("//", "/*")):
            for found in rules.comments.finditer(piece):
                yield match.start() + found.start(), found[0].lower()
            opens = not text[max(previous_end, 0):match.start()].strip() == "" or previous_end < 0
            words = piece.lstrip("/*!< ")
            if opens and rules.openings.match(words):
                yield match.start(), rules.openings.match(words)[0] + " …"
            previous_end = match.end()
        elif piece[0] not in "\"'" and not piece.startswith('R"'):
            if piece in rules.whole:
                yield match.start(), piece
            for part in PART.findall(piece) if piece not in FOREIGN else ():
                if part.lower() in rules.parts and piece not in rules.whole:
                    yield match.start(), part.lower()


def files_of(root, room):
    return [path for path in sorted((root / room).rglob("*")) if path.suffix in (".h", ".cpp") and path.is_file()]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("root", type=Path)
    parser.add_argument("--accept", action="store_true")
    parser.add_argument("--list", nargs="+", metavar=("ROOM", "WORD"))
    arguments = parser.parse_args()
    rules = Rules((arguments.root / "docs/reference/glossary.md").read_text(encoding="utf-8"))
    allowed = json.loads(BASELINE.read_text()) if BASELINE.is_file() else {}
    counts, words = {}, {}
    for room in ROOMS:
        words[room] = Counter()
        for path in files_of(arguments.root, room):
            text = path.read_text(encoding="utf-8", errors="replace")
            for position, word in findings(text, rules):
                words[room][word] += 1
                if arguments.list and arguments.list[0] == room and word in (arguments.list[1:] or [word]):
                    print(f"{path.relative_to(arguments.root)}:{text.count(chr(10), 0, position) + 1}: {word}")
        counts[room] = sum(words[room].values())
    if arguments.list:
        return 0
    if arguments.accept:
        lowered = {room: min(count, allowed.get(room, count)) for room, count in counts.items()}
        BASELINE.write_text(json.dumps(lowered, indent=2) + "\n")
        return 0
    worse = [room for room in ROOMS if counts[room] > allowed.get(room, 0)]
    for room in ROOMS:
        print(f"{room}: {counts[room]} forbidden words, {allowed.get(room, 0)} allowed")
    for room in worse:
        common = ", ".join(f"{word} {count}" for word, count in words[room].most_common(8))
        print(f"{room} has more than before. Use the terms of docs/reference/glossary.md. Most frequent: {common}. "
              f"tests/architecture/check_words.py . --list {room} prints the places.")
    return 1 if worse else 0


if __name__ == "__main__":
    sys.exit(main())
