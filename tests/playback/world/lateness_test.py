#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""lateness_test.py: which runs the world's own lateness explains (session.Lateness)."""

import sys

from session import Lateness

UNTIL_S = 1.0
# Name; ends of loops after the first force, s, and how long they took, ms; whether they explain what the program did.
TABLE = [
    ("punctual", [(0.1 + 0.0004 * i, 0.4) for i in range(100)], False),
    ("as many in a row as the safeguard bridges", [(0.5, 1.0), (0.502, 1.0), (0.504, 1.0)], False),
    ("one more", [(0.5, 1.0), (0.502, 1.0), (0.504, 1.0), (0.506, 1.0)], True),
    ("a pause of 3.2 ms is four periods", [(0.5, 3.2)], True),
    ("a pause of 3 ms is three", [(0.5, 2.9)], False),
    ("often, but never in a row: each answer is bridged", [(0.1 + 0.02 * i, 1.5) for i in range(40)], False),
    ("every fourth loop of CI: no pause above 3 ms", [(0.1 + 0.0016 * i, 1.2) for i in range(100)], True),
    ("answers by which the delay is measured", [(-0.9 + 0.009 * i, 0.9) for i in range(4)], True),
    ("three of them", [(-0.9 + 0.009 * i, 0.9) for i in range(3)], False),
    ("four, when the delay has been measured", [(-0.7 + 0.009 * i, 0.9) for i in range(4)], False),
    ("before the first force", [(-0.2, 9.0)], True),
    ("after all that is judged", [(1.2, 30.0)], False),
]


def main():
    wrong = 0
    for name, loops, explained in TABLE:
        lateness = Lateness()
        lateness.add(1.0, 50.0)  # the program has said nothing yet
        lateness.heard_s, lateness.began_s = 2.0, 3.0
        for end_s, took_ms in loops:
            lateness.add(lateness.began_s + end_s, took_ms / 1000)
        if lateness.explains(UNTIL_S) != explained:
            wrong += 1
            print(f"FAILED {name}: {'not ' if explained else ''}explained by {list(lateness.recent)}")
    print(f"{len(TABLE)} runs, {wrong} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
