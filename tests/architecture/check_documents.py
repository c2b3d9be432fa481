#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Documents say what is: check_documents.py ROOT

Reads README.md, CONTRIBUTING.md and docs/, and prints FILE:LINE of

- what stands in backticks and is the name of nothing: a function, type, member, file, CMake option, command-line option or test that occurs
  nowhere in the code. Names of other programs and libraries stand in foreign_names.txt beside this script, each with its owner;
- dates of days, and headings that tell a diary ("again", "once more", "later", ...). The changelog and the package's are the places for dates;
- decisions above 8000 characters: a page says what, why, the figures that decide, and what was rejected; and decisions that the index
  (docs/develop/decisions/README.md) does not list.

Fenced blocks are examples and are left alone.
"""

import re
import sys
from pathlib import Path

sys.dont_write_bytecode = True

CODE = (".h", ".cpp", ".py", ".sh", ".txt", ".cmake", ".toml", ".json", ".in", ".ts", ".qrc", ".ino", ".html", ".js", ".pd", ".css", ".xml", ".ini", ".svg", "")
ROOMS = ("model", "importer", "playback", "editor", "samples", "tests", "docs", ".ci")
SPAN = re.compile(r"(?<!`)`([^`\n]+)`(?!`)")
FENCE = re.compile(r"^(```|~~~).*?^\1[ \t]*$", re.S | re.M)
DAY = re.compile(r"\b20\d\d-(0[1-9]|1[0-2])-([0-2]\d|3[01])\b")
DIARY = re.compile(r"^#+ .*\b(again|once more|later|that day|same day|evening|morning|night|so far)\b.*$", re.I | re.M)
WORD = re.compile(r"[A-Za-z_]\w*")
MOST_CHARACTERS = 8000


def documents(root):
    return [root / "README.md", root / "CONTRIBUTING.md", *sorted((root / "docs").rglob("*.md"))]


def code_files(root):
    yield from (path for path in root.iterdir() if path.is_file() and path.suffix in CODE)
    for room in ROOMS:
        for path in sorted((root / room).rglob("*")) if (root / room).is_dir() else ():
            if path.is_file() and path.suffix != ".md":
                yield path


def known_words(root):
    """Every word of the code, and every name of a file and folder."""
    words, places = set(), set()
    for path in code_files(root):
        places.add(path.relative_to(root).as_posix())
        if path.suffix in CODE and path.stat().st_size < 3_000_000 and path.name != "foreign_names.txt":
            text = path.read_text(encoding="utf-8", errors="replace")
            words.update(WORD.findall(text))
            words.update(re.findall(r"--[a-z][\w-]*", text))
            words.update("--" + name for name in re.findall(r"[a-z][\w]*(?:-\w+)+|\"[a-z]+\"", text))
    places.update(path.relative_to(root).as_posix() for path in (root / "docs").rglob("*.md"))
    for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md", "LICENSE"):
        places.add(name)
    for place in list(places):
        words.update(WORD.findall(place))
    return words, places


def foreign_names(path):
    return {line.split()[0] for line in path.read_text(encoding="utf-8").splitlines() if line.strip() and not line.startswith("#")}


def is_place(span):
    return re.fullmatch(r"[\w.@-]+(/[\w.@-]+)*\.(h|cpp|py|sh|md|toml|json|cmake|supp)", span) or \
        re.fullmatch(r"(model|importer|playback|editor|samples|tests|docs|\.ci)/[\w./-]+", span)


def unknown_in(span, words, places):
    """The names in a span of code that nothing has."""
    span = span.strip()
    if span in words or "NNNN" in span:
        return
    if is_place(span):
        wanted = span.rstrip("/")
        if not any(("/" + place).endswith("/" + wanted) or ("/" + place).find("/" + wanted + "/") >= 0 or
                   re.sub(r"\.[a-z]+$", "", "/" + place).endswith("/" + wanted) for place in places):
            yield span
        return
    for option in re.findall(r"(?<![\w-])--[a-z][\w-]*", span):
        if option not in words:
            yield option
    if re.search(r"[=<>*$|{}\\]|\.\.\.|…", span):  # a formula, a pattern or a command
        span = " ".join(re.findall(r"\bDETENT_\w+", span))
    for name in re.findall(r"(?<![-\w/.])[A-Za-z]\w*(?:::\w+)*(?:\(\))?(?![-\w/])", span):
        for part in WORD.findall(name):
            looks_like_code = "_" in part or re.search(r"[a-z][A-Z]", part) or name.endswith("()") or "::" in name
            if looks_like_code and part not in words:
                yield part


def without_fences(text):
    return FENCE.sub(lambda match: re.sub(r"[^\n]", " ", match.group(0)), text)


def findings(root, foreign):
    words, places = known_words(root)
    words |= foreign
    for document in documents(root):
        whole = document.read_text(encoding="utf-8")
        text, name = without_fences(whole), document.relative_to(root).as_posix()

        def at(position):
            return whole.count("\n", 0, position) + 1

        for match in SPAN.finditer(text):
            for unknown in unknown_in(match.group(1), words, places):
                yield name, at(match.start()), f"`{unknown}` is the name of nothing in the code"
        for match in DAY.finditer(text):
            yield name, at(match.start()), f"{match.group(0)}: documents are undated; what was stands in git"
        for match in DIARY.finditer(text):
            yield name, at(match.start()), f"the heading tells a diary: {match.group(0)}"
        if re.match(r"docs/develop/decisions/\d", name) and len(whole) > MOST_CHARACTERS:
            yield name, 1, f"{len(whole)} characters are more than a page ({MOST_CHARACTERS})"
    index = root / "docs/develop/decisions/README.md"
    listed = index.read_text(encoding="utf-8") if index.is_file() else ""
    for decision in sorted((root / "docs/develop/decisions").glob("[0-9]*.md")):
        if f"({decision.name})" not in listed:
            yield "docs/develop/decisions/README.md", 1, f"the index does not list {decision.name}"


def main():
    root = Path(sys.argv[1]).resolve()
    found = [f"{name}:{line}: {what}" for name, line, what in findings(root, foreign_names(Path(__file__).with_name("foreign_names.txt")))]
    print("\n".join(found) if found else "Documents name what there is, and no days.")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
