#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Form of commit subjects: check_commits.py [RANGE]

A subject is `component: imperative verb …` with at most 72 characters. Without RANGE, all commits since the rule was adopted are
checked; merges and reverts are free.
"""

import re
import subprocess
import sys

ADOPTED = "447c536b"
MOST_CHARACTERS = 72
# Verbs whose imperative ends like another form.
IMPERATIVES = {"access", "address", "bypass", "compress", "cross", "discuss", "embed", "express", "feed", "focus", "need", "pass",
               "press", "process", "proceed", "seed", "speed", "stress", "suppress", "bring", "ring", "string", "bias", "guess"}


def problem_of(subject):
    """What is wrong with a subject; None if nothing is."""
    if re.match(r"(Merge|Revert) ", subject):
        return None
    if len(subject) > MOST_CHARACTERS:
        return f"{len(subject)} characters; at most {MOST_CHARACTERS} are allowed"
    match = re.fullmatch(r"[a-z][\w./+-]*(?:, [\w./+-]+)*: (\S+)(?: .*)?", subject)
    if not match:
        return "not of the form 'component: imperative verb …'"
    verb = match[1].rstrip(",")
    if not re.fullmatch(r"[a-z][a-z-]*", verb) or (re.search(r"(ed|ing|s)$", verb) and verb not in IMPERATIVES):
        return f"'{verb}' is not an imperative verb in small letters"
    return None


def main():
    wanted = sys.argv[1] if len(sys.argv) > 1 else f"{ADOPTED}..HEAD"
    log = subprocess.run(["git", "log", "--format=%h %s", wanted], capture_output=True, text=True)
    if log.returncode:
        print(f"SKIPPED: git log {wanted}: {log.stderr.strip()}")
        return 0
    wrong = [(line, problem) for line in log.stdout.splitlines() if (problem := problem_of(line.partition(" ")[2]))]
    for line, problem in wrong:
        print(f"{line}\n  {problem}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
