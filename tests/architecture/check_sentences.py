#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds sentences used as keys: words that were made for people and are compared, searched or cut up by code.

    check_sentences.py [ROOT]

Failures, doubts, evidence and remarks carry codes and values (model/result.h, importer/page/findings.h); what decides on their
words breaks silently when somebody improves the English. Each finding is one line, FILE:LINE: what is wrong and what to do.
"""

import re
import subprocess
import sys
from pathlib import Path

ROOMS = ("model", "importer", "playback", "editor")
# What holds words for people, as a member or as the result of a call.
WORDS = r"(?:problem|remedy|remedies|evidence|sentence\(\)|place|reason|remark|remarks|doubt|words\(\))"
LITERAL = r'(?:QLatin1String\(|QStringLiteral\(|std::string_view\(|std::string\()?"'
RULES = (
    ("compared with a literal", re.compile(rf"(?:\.|->){WORDS}\s*(?:==|!=)\s*{LITERAL}|{LITERAL}[^\"\n]*\"\)?\s*(?:==|!=)\s*[\w.>()-]+(?:\.|->){WORDS}(?!\w)")),
    ("searched for a literal", re.compile(rf"(?:\.|->|\b){WORDS}\.(?:find|rfind|contains|starts_with|ends_with|startsWith|endsWith|compare|indexOf)\(\s*{LITERAL}")),
    ("cut up", re.compile(rf"(?:\.|->){WORDS}\.(?:substr|mid|left|right|split|replace|remove|section)\(")),
    ("in English, searched or compared", re.compile(rf"\benglish\([^;]*\)(?:\.(?:find|rfind|substr|compare|starts_with)\(|\s*(?:==|!=)\s*{LITERAL})")),
    ("read back as a number", re.compile(rf"\b(?:sto(?:i|l|ul|ll|d|f)|from_chars|atoi|strtol|strtod)\([^;]*(?:\.|->){WORDS}")),
)


def files_of(root):
    """Sources of the rooms, as git knows them; in a folder without git, all there are."""
    listed = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard"], cwd=root, capture_output=True, text=True)
    names = listed.stdout.split("\n") if listed.returncode == 0 else [str(p.relative_to(root)) for p in root.rglob("*")]
    return sorted(n for n in names if n.startswith(tuple(room + "/" for room in ROOMS)) and n.endswith((".cpp", ".h")))


def without_comment(line):
    """The code of a line: a comment that quotes a sentence compares nothing."""
    at = line.find("//")
    return line if at < 0 or line.count('"', 0, at) % 2 else line[:at]


def findings(root):
    """(file, line, rule) of every sentence used as a key."""
    for name in files_of(root):
        path = root / name
        if not path.is_file():
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").split("\n"), 1):
            for rule, pattern in RULES:
                if pattern.search(without_comment(line)):
                    yield name, number, rule


def main():
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent.parent
    found = list(findings(root))
    for name, number, rule in found:
        print(f"{name}:{number}: a sentence used as a key: words for people, {rule}. Compare a code (FailureCode, RemedyKind, "
              "EvidenceCode, DoubtCode, RemarkCode, ImportStep) or take the value before it is put into words.")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
