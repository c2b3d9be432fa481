#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeps README.md and docs/ true: runs their command blocks, follows links to them, holds their tables against the build.

    documents_test.py --bin FOLDER [--root FOLDER]

A block after the line "<!-- run -->" is run by bash, in a folder of its own that has the project's samples/, with FOLDER (the
built programs) first in PATH. Every command in it has to exit 0.
"""

import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

BLOCK = re.compile(r"^<!-- run -->\n```sh\n(.*?)^```$", re.S | re.M)
LINK = re.compile(r"(?<!!)\[[^\]]*\]\(([^)#\s]+)(?:#[^)]*)?\)")


def documents(root):
    return [root / "README.md", *sorted((root / "docs").rglob("*.md")), *sorted((root / "samples").rglob("*.md"))]


def line_of(text, position):
    return text.count("\n", 0, position) + 1


def broken_links(root):
    for document in documents(root):
        text = document.read_text()
        for match in LINK.finditer(text):
            target = match.group(1)
            if not re.match(r"[a-z]+:", target) and not (document.parent / target).exists():
                yield f"{document.relative_to(root)}:{line_of(text, match.start())}: the link to {target} leads nowhere"


def broken_references(root):
    """Places of docs/ that code names and that are not there. "docs/develop/decisions/0700" may leave the title out."""
    for room in ("model", "importer", "playback", "editor", "tests", "samples"):
        for file in sorted((root / room).rglob("*")):
            if file.suffix not in (".h", ".cpp", ".txt"):
                continue
            text = file.read_text(encoding="utf-8", errors="replace")
            for match in re.finditer(r"docs/[\w./-]*\w", text):
                if not (root / match.group(0)).exists() and not list(root.glob(match.group(0) + "*.md")):
                    yield f"{file.relative_to(root)}:{line_of(text, match.start())}: {match.group(0)} is not there"


def undescribed(root):
    """Options of CMake and presets that docs/develop/building.md does not name, and the other way round."""
    name = "docs/develop/building.md"
    page = (root / name).read_text()
    options = set(re.findall(r"^option\((DETENT_\w+)", (root / "CMakeLists.txt").read_text(), re.M))
    described = set(re.findall(r"^\| `(DETENT_\w+)` \|", page, re.M))
    for option in sorted(options ^ described):
        yield f"{name}:1: {option} stands in only one of CMakeLists.txt and this page"
    presets = {preset["name"] for preset in json.loads((root / "CMakePresets.json").read_text())["configurePresets"]
               if not preset.get("hidden")}
    for preset in sorted(presets):
        if f"| `{preset}` |" not in page:
            yield f"{name}:1: the preset {preset} is not described"


def failed_commands(root, programs):
    environment = dict(os.environ, PATH=f"{programs}:{os.environ['PATH']}", LC_ALL="C.UTF-8")
    ran = 0
    for document in documents(root):
        text = document.read_text()
        for match in BLOCK.finditer(text):
            place = f"{document.relative_to(root)}:{line_of(text, match.start(1))}"
            with tempfile.TemporaryDirectory() as folder:
                os.symlink(root / "samples", Path(folder) / "samples")
                run = subprocess.run(["bash", "-euo", "pipefail", "-c", match.group(1)], cwd=folder, env=environment,
                                     stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=240)
            ran += 1
            if run.returncode != 0:
                yield f"{place}: the block ends with exit code {run.returncode}:\n{run.stdout[-2000:]}{run.stderr[-2000:]}"
    if ran == 0:
        yield "README.md:1: no command block is marked with <!-- run -->"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--bin", type=Path, required=True, help="folder of the built programs")
    parser.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[2])
    arguments = parser.parse_args()
    root = arguments.root.resolve()
    found = [*broken_links(root), *broken_references(root), *undescribed(root), *failed_commands(root, arguments.bin.resolve())]
    for finding in found:
        print(finding)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
