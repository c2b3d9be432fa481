#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws comments of the four rooms at random, for somebody who did not write them: draw_comments.py SEED COUNT [FOLDER...]

Prints each with the lines around it. The reader counts those that are understood at first reading: docs/measurements/readers.md.
"""

import random
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
ROOMS = ("model", "importer", "playback", "editor")
BEFORE, AFTER = 2, 4  # lines around a comment


def comments(text):
    """(first line, last line), from 0, of the comments of three words and more: blocks, and comments behind code."""
    lines, i = text.split("\n"), 0
    while i < len(lines):
        last = i
        if re.match(r"\s*//", lines[i]):
            while last + 1 < len(lines) and re.match(r"\s*//", lines[last + 1]):
                last += 1
            words = " ".join(lines[i:last + 1]).replace("SPDX-License-Identifier: GPL-3.0-or-later", "")
        else:
            behind = re.search(r"(?<!:)//(/<)? ", lines[i])
            words = lines[i][behind.end():] if behind and '"' not in lines[i][behind.start():] and "namespace" not in lines[i] else ""
        if len(re.findall(r"[A-Za-z]{2,}", words)) >= 3:
            yield i, last
        i = last + 1


def main(arguments):
    if len(arguments) < 2:
        print(__doc__, file=sys.stderr)
        return 2
    seed, count, *folders = arguments
    names = subprocess.run(["git", "ls-files", *(folders or ROOMS)], cwd=ROOT, check=True, capture_output=True, text=True).stdout.split()
    texts = {name: (ROOT / name).read_text(encoding="utf-8") for name in names if name.endswith((".h", ".cpp"))}
    places = [(name, *place) for name, text in texts.items() for place in comments(text)]
    random.seed(int(seed))
    for number, (name, first, last) in enumerate(random.sample(places, int(count)), 1):
        print(f"#{number} {name}:{first + 1}")
        lines = texts[name].split("\n")
        for i in range(max(0, first - BEFORE), min(len(lines), last + 1 + AFTER)):
            print((">" if first <= i <= last else " ") + " " + lines[i])
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
