# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds where a planted fault goes: a pattern of tokens inside a named function, whatever its layout and its surroundings.

A pattern is a piece of C++ of which white space does not count. It stands exactly once in the function. A function is named as
Universal Ctags names it, without its namespaces (`StrokeTracker::updateForce`, `knotRefusal`); overloads count as one place.
An empty name means the whole file: constants, tables, files that are not C++.
"""

import functools
import json
import re
import subprocess
from pathlib import Path


def tokens(text):
    """Words, numbers and single signs of a text, without white space."""
    return re.findall(r"\w+|[^\w\s]", text)


def pattern(text):
    """A regular expression for these tokens with any white space between them."""
    words = tokens(text)
    parts = [re.escape(words[0])] if words else []
    for before, word in zip(words, words[1:]):
        glued = before[-1].isalnum() or before[-1] == "_"
        parts.append((r"\s+" if glued and (word[0].isalnum() or word[0] == "_") else r"\s*") + re.escape(word))
    edge = r"(?<!\w)" if words and (words[0][0].isalnum() or words[0][0] == "_") else ""
    end = r"(?!\w)" if words and (words[-1][-1].isalnum() or words[-1][-1] == "_") else ""
    return re.compile(edge + "".join(parts) + end)


@functools.lru_cache(maxsize=None)
def functions(path):
    """[(name, first character, end)] of every function of a C++ file."""
    text = Path(path).read_text()
    starts = [0]
    for line in text.splitlines(keepends=True):
        starts.append(starts[-1] + len(line))
    told = subprocess.run(["ctags", "--options=NONE", "--output-format=json", "--fields=+neZ", "--language-force=C++", "--c++-kinds=f",
                           "-f", "-", str(path)], capture_output=True, text=True, check=True).stdout
    found = []
    for line in told.splitlines():
        tag = json.loads(line)
        if "end" not in tag:
            continue
        scope = [part for part in tag.get("scope", "").split("::") if part and not part.startswith("__anon")]
        classes = [part for part in scope if part[0].isupper()]  # namespaces are written small
        name = "::".join([*classes, tag["name"]])
        if tag["name"].startswith("__anon"):  # a lambda is part of the function around it
            continue
        found.append((name, starts[tag["line"] - 1], starts[tag["end"]]))
    return found


def spans(path, function):
    """Where the function's definitions stand; the whole file for an empty name."""
    if not function:
        return [(0, len(Path(path).read_text()))]
    return [(start, end) for name, start, end in functions(path) if name == function]


def place(path, function, search):
    """(start, end) of the pattern, or a sentence that says why there is no such place."""
    where = spans(path, function)
    if not where:
        return f"there is no function {function} in {path.name}"
    text = path.read_text()
    hits = {(start + hit.start(), start + hit.end()) for start, end in where for hit in pattern(search).finditer(text[start:end])}
    return hits.pop() if len(hits) == 1 else f"its pattern stands {len(hits)} times in {function or path.name}"
