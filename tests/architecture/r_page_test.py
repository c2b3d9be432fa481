#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/guide/r.md as a reader follows it: its commands, then its R, in one folder. r_page_test.py --root FOLDER --bin FOLDER

Without Rscript: SKIPPED."""

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path


def blocks(text, language):
    return "\n".join(re.findall(rf"^```{language}\n(.*?)^```$", text, re.S | re.M))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--root", type=Path, required=True)
    parser.add_argument("--bin", type=Path, required=True)
    chosen = parser.parse_args()
    if not shutil.which("Rscript"):
        print("SKIPPED docs/guide/r.md: Rscript is not installed")
        return 0
    page = (chosen.root / "docs/guide/r.md").read_text()
    environment = {**os.environ, "PATH": f"{chosen.bin.resolve()}:{os.environ['PATH']}", "LC_ALL": "C.UTF-8"}
    with tempfile.TemporaryDirectory() as folder:
        os.symlink(chosen.root.resolve() / "samples", Path(folder, "samples"))
        for command in (["bash", "-euo", "pipefail", "-c", blocks(page, "sh")], ["Rscript", "-e", blocks(page, "r")]):
            ran = subprocess.run(command, cwd=folder, env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
            if ran.returncode != 0:
                print(ran.stdout[-2000:], ran.stderr[-2000:])
                return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
