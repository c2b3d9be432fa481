#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeps the newest section of CHANGELOG.md that has entries short: check_changelog.py ROOT

Prints FILE:LINE of entries longer than 160 characters, entries of more than one line, and groups of more than ten entries.
"""

import sys
from pathlib import Path

MOST_CHARACTERS = 160
MOST_ENTRIES = 10


def findings(text):
    """Yields (line number, problem) for the newest section; an empty "Unreleased" is passed over."""
    section, group, entries, comment, used = 0, "", 0, False, 0
    for number, line in enumerate(text.splitlines(), 1):
        if line.startswith("## "):
            section, group, entries = section + 1, line[3:], 0
        elif line.startswith("- ") and section > 0 and used == 0:
            used = section
        if section == 0 or used not in (0, section):
            continue
        if line.startswith("### "):
            group, entries = line[4:], 0
        elif line.startswith("- "):
            entries += 1
            if len(line) - 2 > MOST_CHARACTERS:
                yield number, f"the entry has {len(line) - 2} characters; at most {MOST_CHARACTERS} are allowed"
            if entries == MOST_ENTRIES + 1:
                yield number, f"the group '{group}' has more than {MOST_ENTRIES} entries; merge some"
        elif line.startswith("<!--"):
            comment = True
        elif line.strip() and not comment and not line.startswith("## "):
            yield number, "an entry is one sentence on one line"
        if line.endswith("-->"):
            comment = False


def main():
    found = list(findings((Path(sys.argv[1]) / "CHANGELOG.md").read_text(encoding="utf-8")))
    for number, problem in found:
        print(f"CHANGELOG.md:{number}: {problem}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
