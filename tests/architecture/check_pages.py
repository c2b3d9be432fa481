#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Form of the documents: check_pages.py ROOT

Reads README.md, CONTRIBUTING.md, CHANGELOG.md, docs/ and the Markdown files of samples/ and .github/, and prints FILE:LINE of

- links and pictures that lead to no file, and anchors that no heading of the target has;
- pages of docs/ that cannot be reached by links from README.md;
- table rows with another number of cells than their header;
- lines of text longer than 110 columns. Free are tables, fenced and indented blocks, headings, comments, links at the start of a
  line, and text that a program writes between "<!-- NAME: begin -->" and "<!-- NAME: end -->";
- decisions longer than 60 lines.
"""

import os
import re
import sys
from pathlib import Path

MOST_COLUMNS = 110
MOST_DECISION_LINES = 60
LINK = re.compile(r"!?\[(?:[^\[\]]|\[[^\]]*\])*\]\(([^)\s]+)\)")
FENCE = re.compile(r"^ {0,3}(```|~~~)")


def documents(root):
    single = [root / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md")]
    folders = [path for folder in ("docs", "samples", ".github") for path in sorted((root / folder).rglob("*.md"))]
    return [path for path in [*single, *folders] if path.is_file()]


def text_lines(text):
    """Lines outside fenced blocks and HTML comments, with their numbers."""
    fence, comment = None, False
    for number, line in enumerate(text.splitlines(), 1):
        mark = FENCE.match(line)
        if fence:
            if mark and mark[1] == fence:
                fence = None
            continue
        if mark:
            fence = mark[1]
            continue
        if line.lstrip().startswith("<!--"):
            comment = True
        if not comment:
            yield number, line
        if "-->" in line:
            comment = False


def anchor_of(heading):
    """The anchor that GitHub gives a heading."""
    plain = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading).strip().lower()
    return re.sub(r"[^\w\- ]", "", plain).replace(" ", "-")


def anchors(text):
    seen, found = {}, set()
    for _, line in text_lines(text):
        if match := re.match(r"#{1,6} +(.*?)#*$", line):
            anchor = anchor_of(match[1])
            found.add(anchor if anchor not in seen else f"{anchor}-{seen[anchor]}")
            seen[anchor] = seen.get(anchor, 0) + 1
    return found | set(re.findall(r'<a (?:id|name)="([^"]+)"', text))


def cells(row):
    """Number of cells of a table row; an escaped bar does not end a cell."""
    return len(re.findall(r"(?<!\\)\|", row.strip().strip("|").replace("\\\\", ""))) + 1


def links(text):
    for number, line in text_lines(text):
        for match in LINK.finditer(re.sub(r"`[^`]*`", lambda m: " " * len(m[0]) if "](" in m[0] else m[0], line)):
            yield number, match[1]


def broken_links(root, document, texts):
    for number, target in links(texts[document]):
        if re.match(r"[a-z]+:", target):
            continue
        file, _, anchor = target.partition("#")
        path = Path(os.path.normpath(document.parent / file)) if file else document
        if not path.exists():
            yield number, f"the link to {target} leads nowhere"
        elif anchor and path in texts and anchor not in anchors(texts[path]):
            yield number, f"no heading of {file or document.name} has the anchor #{anchor}"


def broken_tables(text):
    header = None
    for number, line in text_lines(text):
        if not line.lstrip().startswith("|"):
            header = None
        elif header is None:
            header = cells(line)
        elif cells(line) != header:
            yield number, f"the row has {cells(line)} cells, its header {header}"


def long_lines(text):
    written = [(text.count("\n", 0, match.start()) + 1, text.count("\n", 0, match.end()) + 1)
               for match in re.finditer(r"<!-- (\w+): begin -->.*?<!-- \1: end -->", text, re.S)]
    before = ""
    for number, line in text_lines(text):
        indented, before = line.startswith("    ") and (not before or before.startswith("    ")), line
        if indented or any(first <= number <= last for first, last in written):
            continue
        if len(line) > MOST_COLUMNS and not re.match(r"\s*(\||#|\[|!\[|<)", line) and " " in line[:MOST_COLUMNS].strip(" -*"):
            yield number, f"the line has {len(line)} columns; at most {MOST_COLUMNS} are allowed"


def unreached(root, texts):
    waiting, reached = [root / "README.md"], set()
    while waiting:
        page = waiting.pop()
        if page in reached or page not in texts:
            continue
        reached.add(page)
        for _, target in links(texts[page]):
            waiting.append(Path(os.path.normpath(page.parent / target.partition("#")[0])))
    return [page for page in texts if page not in reached and (root / "docs") in page.parents]


def findings(root):
    texts = {page: page.read_text(encoding="utf-8") for page in documents(root)}
    for page, text in texts.items():
        name = page.relative_to(root).as_posix()
        for number, problem in [*broken_links(root, page, texts), *broken_tables(text)]:
            yield name, number, problem
        if name != "CHANGELOG.md" and not name.startswith("samples/"):  # samples: written by programs
            for number, problem in long_lines(text):
                yield name, number, problem
        if re.match(r"docs/develop/decisions/\d", name) and text.count("\n") > MOST_DECISION_LINES:
            yield name, 1, f"the decision has {text.count(chr(10))} lines; at most {MOST_DECISION_LINES} are allowed"
    for page in unreached(root, texts):
        yield page.relative_to(root).as_posix(), 1, "no chain of links from README.md leads to this page"


def main():
    found = [f"{name}:{number}: {problem}" for name, number, problem in findings(Path(sys.argv[1]).resolve())]
    print("\n".join(found) if found else "Links, anchors, tables and lines of the documents are in order.")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
