#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads every #include of the rooms and fails on one that include_table.toml does not allow.

    check_includes.py [--root FOLDER]

Prints one line per violation, "FILE:LINE: SENTENCE [rule]", and exits 1; exits 0 if there is none. Looks at the files git
tracks; at all files where FOLDER is not a checkout. Only the standard library of Python is used.

Linking rules alone do not catch a wrong include: on Debian every library's headers lie on the default path.
"""

import argparse
import fnmatch
import functools
import re
import subprocess
import sys
import tomllib
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

ROOMS = ("model", "importer", "playback", "editor")
HEADERS = (".h", ".hpp", ".hh")
SOURCES = HEADERS + (".cpp", ".cc", ".cxx", ".c")
LICENCE = "SPDX-License-Identifier: GPL-3.0-or-later"
LICENSED = SOURCES + (".py", ".sh", ".cmake", ".ino", "CMakeLists.txt")

INCLUDE = re.compile(r'^[ \t]*#[ \t]*(include|include_next|import)\b[ \t]*(.*)$')
# Comments and literals, so that an include in a comment does not count and "//" in a string does not start one.
TOKENS = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(?P<mark>[^\s()\\]{0,16})\(.*?\)(?P=mark)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'', re.S)


@dataclass(frozen=True)
class Include:
    line: int
    target: str
    quoted: bool  # "room/file.h", not <library.h>


@dataclass(frozen=True, order=True)
class Violation:
    file: str
    line: int
    rule: str
    sentence: str

    def __str__(self):
        return f"{self.file}:{self.line}: {self.sentence} [{self.rule}]"


def blank_comments(text):
    """The text with comments and raw strings blanked, line breaks kept; other literals stand (an include has one)."""
    def blank(match):
        token = match.group(0)
        return re.sub(r"[^\n]", " ", token) if token[0] in "/R" else token
    return TOKENS.sub(blank, text)


@functools.cache
def includes_of(text):
    """Every include of a file; a target that is neither quoted nor bracketed (a macro) has an empty name."""
    found = []
    for number, line in enumerate(blank_comments(text.replace("\\\n", " \n")).split("\n"), 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        target = re.match(r'"([^"]*)"|<([^>]*)>', match.group(2))
        if match.group(1) != "include" or not target:
            found.append(Include(number, "", False))
        elif target.group(1) is not None:
            found.append(Include(number, target.group(1), True))
        else:
            found.append(Include(number, target.group(2), False))
    return found


def files_of(root):
    """Relative paths of what belongs to the project."""
    listing = subprocess.run(["git", "-C", str(root), "ls-files", "-z"], capture_output=True, text=True)
    if listing.returncode == 0 and (root / ".git").exists():
        return sorted(name for name in listing.stdout.split("\0") if name and (root / name).is_file())
    return sorted(str(PurePosixPath(path.relative_to(root))) for path in root.rglob("*")
                  if path.is_file() and path.relative_to(root).parts[0] not in (".git", "build")
                  and "__pycache__" not in path.parts)


class Table:
    """include_table.toml with the questions asked of it."""

    def __init__(self, path):
        data = tomllib.loads(path.read_text())
        self.areas = {area["path"]: area for area in data["area"]}
        self.doors = data["doors"]
        self.third_party = data["third_party"]
        self.standard = set(data["standard"]["headers"].split())
        self.top_level = set(data["top_level"]["required"])

    def area_of(self, file):
        """The area with the longest path that contains the file; None outside the rooms."""
        path = PurePosixPath(file)
        for candidate in [path, *path.parents]:
            if str(candidate) in self.areas:
                return self.areas[str(candidate)]
        return None

    def library_of(self, header):
        for library, patterns in self.third_party.items():
            if any(fnmatch.fnmatchcase(header, pattern) for pattern in patterns):
                return library
        return None


def room_of(file):
    return file.split("/", 1)[0]


class Checker:
    def __init__(self, root, table):
        self.root = root
        self.table = table
        self.files = files_of(root)
        self.known = set(self.files)
        self.includes = {}
        for file in self.files:
            if file.endswith(SOURCES) and room_of(file) in ROOMS + ("tests",):
                self.includes[file] = includes_of((root / file).read_text(encoding="utf-8", errors="replace"))

    def violations(self):
        found = list(self.top_level())
        for file, includes in self.includes.items():
            for include in includes:
                found.extend(self.form(file, include))
                if room_of(file) in ROOMS:
                    found.extend(self.direction(file, include) if include.quoted else self.library(file, include))
        found.extend(self.leaks())
        found.extend(self.circles())
        found.extend(self.unverified_headers())
        found.extend(self.bare_dumps())
        found.extend(self.without_licence())
        return sorted(set(found))

    def form(self, file, include):
        """How an include is written, in rooms and tests alike."""
        def fault(rule, sentence):
            return Violation(file, include.line, rule, sentence)
        if not include.target:
            yield fault("form", "this include names no file that can be checked: write #include \"room/file.h\" or <library.h>")
        elif not include.quoted and include.target in self.known:
            yield fault("form", f"<{include.target}> is a file of this project: write it in quotes")
        elif include.quoted and self.is_generated(file, include.target):
            return
        elif include.quoted and include.target not in self.known:
            there = "is not tracked by git yet: add it" if (self.root / include.target).is_file() else (
                "is no file of this project, counted from the top level")
            yield fault("form", f"\"{include.target}\" {there}")
        elif room_of(file) == "tests" and include.target.endswith(".ino"):
            return  # a sketch is one file without a header; its test compiles it for the PC
        elif include.quoted and not include.target.endswith(HEADERS):
            yield fault("headers only", f"\"{include.target}\" is not a header: only headers are included")

    def is_generated(self, file, target):
        area = self.table.area_of(file)
        return area and any(fnmatch.fnmatchcase(target, pattern) for pattern in area.get("generated", []))

    def direction(self, file, include):
        """Who may include whom among the project's own areas."""
        if include.target not in self.known or not include.target.endswith(HEADERS):
            return
        here, there = self.table.area_of(file), self.table.area_of(include.target)
        if there is None:
            yield Violation(file, include.line, "direction",
                            f"\"{include.target}\" belongs to no room: a room includes rooms only")
            return
        if there["path"] == here["path"] or {there["path"], include.target} & set(here["may_include"]):
            return
        rooms = {room_of(file), room_of(include.target)}
        if room_of(include.target) in here.get("doors", []):
            doors = self.table.doors[room_of(include.target)]
            if include.target not in doors:
                yield Violation(file, include.line, "front door",
                                f"{here['path']} reaches {room_of(include.target)} through {', '.join(doors)} only, "
                                f"not through \"{include.target}\"")
        elif room_of(include.target) == "editor" and room_of(file) != "editor":
            yield Violation(file, include.line, "nothing includes editor",
                            f"\"{include.target}\" is the editor's: nothing includes the editor")
        elif rooms == {"importer", "playback"}:
            yield Violation(file, include.line, "importer and playback never meet",
                            f"\"{include.target}\": importer and playback never meet; what both need belongs to model")
        else:
            allowed = ", ".join(here["may_include"]) or "nothing else"
            yield Violation(file, include.line, "direction",
                            f"{here['path']} may not include {there['path']} (\"{include.target}\"); "
                            f"besides itself it may include: {allowed}")

    def library(self, file, include):
        """Which libraries an area may use."""
        if not include.target or include.target in self.known:
            return
        area = self.table.area_of(file)
        if include.target in self.table.standard:
            if include.target in area.get("forbidden_standard", []):
                yield Violation(file, include.line, "callback",
                                f"<{include.target}>: {area['path']} runs in the audio callback; it may not lock, wait, "
                                "ask a clock or touch a file")
            return
        library = self.table.library_of(include.target)
        if library is None:
            yield Violation(file, include.line, "unknown library",
                            f"<{include.target}> belongs to no library that tests/architecture/include_table.toml knows")
        elif library not in area["third_party"]:
            allowed = ", ".join(area["third_party"]) or "the standard library only"
            rule = "POSIX" if library == "POSIX" else "third party"
            yield Violation(file, include.line, rule,
                            f"<{include.target}> is {library}; {area['path']} may use: {allowed}")

    def third_party_lines(self, header):
        return [include for include in self.includes[header]
                if not include.quoted and include.target and include.target not in self.table.standard
                and include.target not in self.known]

    def leaks(self):
        """A header that another room includes, itself or through others, carries no third-party include."""
        reached = {}  # header -> one file of another room that reaches it
        for file in self.includes:
            if room_of(file) not in ROOMS:
                continue
            stack, seen = [file], {file}
            while stack:
                for include in self.includes.get(stack.pop(), []):
                    target = include.target
                    if include.quoted and target in self.includes and target not in seen:
                        seen.add(target)
                        stack.append(target)
                        if room_of(target) != room_of(file):
                            reached.setdefault(target, file)
        for header, reader in reached.items():
            for include in self.third_party_lines(header):
                yield Violation(header, include.line, "third party in a shared header",
                                f"<{include.target}> stands in a header that another room includes ({reader}): "
                                "keep it in the .cpp, behind plain types")

    def circles(self):
        """A header and the source of the same name are one: none includes, itself or through others, what includes it."""
        def unit(file):
            return file.rsplit(".", 1)[0]
        uses = {}  # unit -> unit it includes -> (file, line) of that include
        for file, includes in self.includes.items():
            for include in includes:
                if room_of(file) in ROOMS and include.quoted and include.target in self.known and unit(include.target) != unit(file):
                    uses.setdefault(unit(file), {}).setdefault(unit(include.target), (file, include.line))
        reached = {}
        for start in uses:
            seen, stack = set(), [start]
            while stack:
                for other in uses.get(stack.pop(), {}):
                    if other not in seen:
                        seen.add(other)
                        stack.append(other)
            reached[start] = seen
        for here, targets in uses.items():
            for there, (file, line) in targets.items():
                if here in reached.get(there, ()) and file.endswith(HEADERS):
                    yield Violation(file, line, "circle",
                                    f"{there} includes {here}, itself or through others: what both need belongs into a header below them")

    def bare_dumps(self):
        """nlohmann's dump() throws where a text is not UTF-8, and names of files may be anything."""
        for file in self.includes:
            if room_of(file) not in ROOMS or file == "model/file/json_text.h":
                continue
            text = (self.root / file).read_text(encoding="utf-8", errors="replace")
            if "dump(" not in text:
                continue
            for number, line in enumerate(blank_comments(text).split("\n"), 1):
                if re.search(r"(\.|->)dump\(", line):
                    yield Violation(file, number, "json text", "dump() throws on text that is not UTF-8: write jsonText(json) of model/file/json_text.h")

    def unverified_headers(self):
        """A header in no CMakeLists.txt is in no header set, so nobody verifies that it stands alone."""
        lists = {str(PurePosixPath(file).parent): (self.root / file).read_text()
                 for file in self.files if PurePosixPath(file).name == "CMakeLists.txt"}
        for file in self.includes:
            if room_of(file) not in ROOMS or not file.endswith(HEADERS):
                continue
            path = PurePosixPath(file)
            listed = any(re.search(rf"(?<![\w/.]){re.escape(str(path.relative_to(folder)))}(?![\w.])", lists[str(folder)])
                         for folder in path.parents if str(folder) in lists and str(folder) != ".")
            if not listed:
                yield Violation(file, 1, "header set",
                                "this header stands in no CMakeLists.txt: name it under HEADERS, so that it is verified to stand alone")

    def without_licence(self):
        """A file that is copied elsewhere still says whose it is: the SPDX line is the first, or follows "#!"."""
        for file in self.files:
            if not file.endswith(LICENSED) or file.startswith("tests/fuzz/corpus/"):
                continue
            with open(self.root / file, encoding="utf-8", errors="replace") as text:
                head = text.readline() + text.readline()
            if LICENCE not in head:
                comment = "//" if file.endswith(SOURCES + (".ino",)) else "#"
                yield Violation(file, 1, "licence", f"this file does not begin with \"{comment} {LICENCE}\"")

    def top_level(self):
        entries = {file.split("/", 1)[0] for file in self.files}
        for entry in sorted(entries - self.table.top_level):
            if not entry.startswith("."):
                yield Violation(entry, 1, "top level", "nothing but the rooms and the listed files stands at the top level: "
                                                       "move it into a room, samples, tests or docs")
        for entry in sorted(self.table.top_level - entries):
            yield Violation(entry, 1, "top level", "this belongs to the top level and is missing")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    here = Path(__file__).resolve().parent
    parser.add_argument("--root", type=Path, default=here.parent.parent, help="top of the project")
    root = parser.parse_args().root.resolve()

    checker = Checker(root, Table(here / "include_table.toml"))
    found = checker.violations()
    for violation in found:
        print(violation)
    checked = sum(1 for file in checker.includes if room_of(file) in ROOMS)
    if checked == 0:
        print(f"{root}:1: no source file of a room stands here [nothing checked]")
        return 1
    if found:
        print(f"{len(found)} violations in {checked} files. The table: tests/architecture/include_table.toml, docs/develop/architecture.md.")
        return 1
    print(f"{checked} files of {len(ROOMS)} rooms keep to the include table.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
