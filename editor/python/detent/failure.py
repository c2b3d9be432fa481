# SPDX-License-Identifier: GPL-3.0-or-later
"""What cannot be done, as exceptions with the sentences of the programs."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any


class Failure(Exception):
    """Something that could not be done. Its text is the sentence the program prints.

    code: the program's exit code (1 internal fault or disk error, 2 wrong usage, 3 input cannot be read,
        4 no force graph found, 5 found but not certain enough, 6 device trouble).
    remedies: what to do next, in sentences, the likeliest first; may be empty.
    report: what the program prints with --json; may be empty.
    """

    def __init__(self, code: int, sentence: str, remedies: Sequence[str] = (), report: dict[str, Any] | None = None) -> None:
        super().__init__(code, sentence, list(remedies), report)
        self.code = code
        self.sentence = sentence
        self.remedies: list[str] = list(remedies)
        self.report: dict[str, Any] = report or {}

    def __str__(self) -> str:
        return self.sentence


class WrongUsage(Failure):
    """A call or a value that cannot mean anything (code 2)."""


class UnreadableInput(Failure):
    """The input is missing, broken, too large, or not what it says it is (code 3)."""


class NoForceGraph(Failure):
    """Readable, but no force graph stands in it (code 4)."""


class NotCertain(Failure):
    """Found, but not certain enough; the remedies say what to give by hand (code 5)."""


def failure_of(code: int, sentence: str, remedies: Sequence[str] = (), report_json: str = "") -> Failure:
    """The exception for an exit code; what the compiled part raises."""
    kinds: dict[int, type[Failure]] = {2: WrongUsage, 3: UnreadableInput, 4: NoForceGraph, 5: NotCertain}
    return kinds.get(code, Failure)(code, sentence, remedies, json.loads(report_json) if report_json else None)
