#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""One name, one type: check_types.py ROOT

Finds classes, structures and enumerations that two files of the rooms define under the same name in the same
namespace, but for those in an unnamed one. The linker takes the functions of one for both (a destructor, say), and no
compiler says so. Prints the name and its files; exit code 1 if there is one.
"""

import collections
import re
import sys
from pathlib import Path

ROOMS = ("model", "importer", "playback", "editor")
# What decides: comments and strings are skipped, braces counted.
TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'|template\s*<[^{};]*?>\s*(?=struct|class)|'
                   r"namespace(?P<space>\s+[\w:]+)?\s*\{|\b(?:enum\s+)?(?:struct|class|enum)\s+(?P<type>\w+)\s*(?:final\s*)?(?::(?!:)[^{};()]*)?\{|[{}]",
                   re.S)


def types_in(text):
    """Types that a file defines in a named namespace, with their full names."""
    scopes = []
    for token in TOKEN.finditer(text):
        word = token.group()
        if word == "}":
            del scopes[-1:]
        elif word.startswith("namespace"):
            scopes.append(token["space"].strip() if token["space"] else None)
        elif token["type"]:
            if None not in scopes:
                yield "::".join([*scopes, token["type"]])
            scopes.append(None)
        elif word == "{":
            scopes.append(None)


def defined_twice(files):
    """files: name to text. Full names of types and the files that define them, where there are two."""
    homes = collections.defaultdict(list)
    for name, text in files.items():
        for full in dict.fromkeys(types_in(text)):
            homes[full].append(name)
    return {full: names for full, names in sorted(homes.items()) if len(names) > 1}


def main():
    root = Path(sys.argv[1])
    files = {str(file.relative_to(root)): file.read_text(encoding="utf-8")
             for room in ROOMS for kind in ("*.h", "*.cpp") for file in sorted((root / room).rglob(kind))}
    twice = defined_twice(files)
    for full, names in twice.items():
        print(f"{full} is defined in {' and in '.join(names)}: give one of them another name.")
    if not twice:
        print(f"Each type of {len(files)} files has a name of its own.")
    return 1 if twice else 0


if __name__ == "__main__":
    sys.exit(main())
