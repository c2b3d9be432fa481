# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the programs. They do all the work, so that a notebook and a shell give the same numbers."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path
from typing import Any

from ._version import version
from .failure import failure_of


def program(name: str) -> str:
    """Where a program is: in the folder DETENT_PROGRAMS, beside a package in its build folder, or on the path."""
    given = os.environ.get("DETENT_PROGRAMS")
    places = [Path(given)] if given else [Path(__file__).resolve().parents[2] / "bin"]
    for place in places:
        if os.access(place / name, os.X_OK):
            return str(place / name)
    found = None if given else shutil.which(name)
    if found is None:
        where = f"in {given} (DETENT_PROGRAMS)" if given else "on the path"
        raise ImportError(f"detent: the program {name} is not {where}. Install the package detent, or set DETENT_PROGRAMS "
                          "to the folder of its programs.")
    return found


def check_version() -> None:
    """ImportError where the programs are of another release than this module."""
    answer = subprocess.run([program("detent-import"), "--version"], capture_output=True, text=True, check=False).stdout.split()
    theirs = answer[-1] if answer else "unknown"
    if theirs != version:
        raise ImportError(f"detent: the module is of version {version}, {program('detent-import')} of {theirs}. "
                          "Install both from the same release.")


def run(name: str, *arguments: str) -> dict[str, Any]:
    """The JSON object a program prints; the Failure it ends with. Its process ends with an exception such as KeyboardInterrupt."""
    command = [program(name), *arguments]
    with subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          encoding="utf-8", errors="replace") as process:
        try:
            out, err = process.communicate()
        except BaseException:
            process.kill()
            process.wait()
            raise
    report: dict[str, Any] = json.loads(out) if out.strip().startswith("{") else {}
    if process.returncode != 0:
        raise failure_of(*_told(name, process.returncode, report, err))
    return report


def _told(name: str, status: int, report: dict[str, Any], err: str) -> tuple[int, str, dict[str, Any]]:
    if status < 0:
        return 1, f"{name} was ended by signal {-status}. Run it by hand on the same file to see how far it comes.", report
    words = [line for line in err.splitlines() if line.strip() and not line.startswith("warning:")]
    sentence = report.get("message") or (report.get("problem") if "input" in report else None)
    return status, sentence or " ".join(words) or f"{name} ended with exit code {status}.", report
