#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The editor on a desktop whose C library writes half as "0,5": pages are read and files are written as anywhere else.

    german_e2e.py --bin FOLDER [--root FOLDER] [--keep FOLDER]
"""

import argparse
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from desktop import Desktop, Editor, read_to_its_end, saved_press, wait_for

DRAWING = "samples/plots/black-inch-ounce.svg"
LARGEST_ERROR = 1e-4  # of a sample, in mm and N
LEAST_SHARE, MOST_MM = 0.98, 0.05  # of the forces of what was written, and of its places


def read_a_drawing(root, programs, folder, desktop):
    """A drawing's coordinates have points: what is imported is what the command line finds."""
    saved = folder / "imported.button.json"
    editor = Editor(desktop, programs / "detent-edit", [root / DRAWING])
    read_to_its_end(editor, "importDialog")
    editor.click("import", "importDialog")
    editor.widget("graphCanvas")
    desktop.key("ctrl+s")
    editor.replace_text("fileNameEdit", str(saved))
    desktop.key("Return")
    editor.gone("fileNameEdit")
    expected, found = imported_press(programs, root / DRAWING, folder), saved_press(programs, saved)
    check("press samples", len(found), len(expected))
    check("the press in mm and N", max(abs(a - b) for pair in zip(found, expected) for a, b in zip(*pair)) < LARGEST_ERROR, True)
    return editor


def write_a_drawing(editor, programs, folder, desktop):
    """Labels are as a German writes them, coordinates as every program reads them: what is drawn is read back."""
    file = folder / "graph.svg"
    desktop.key("ctrl+shift+e")
    editor.click("graphForce", "graphExportDialog")
    desktop.key("Home", "Return")  # newton, whose labels have fractions
    editor.click("graphExport", "graphExportDialog")
    editor.replace_text("fileNameEdit", str(file))
    desktop.key("Return")
    editor.gone("fileNameEdit")
    wait_for("the drawing", file.exists)
    texts = [text.text for text in ElementTree.parse(file).getroot().iter("{http://www.w3.org/2000/svg}text")]
    check("a label with a comma", any(re.fullmatch(r"\d+,\d+", text or "") for text in texts), True)
    written, read = saved_press(programs, folder / "imported.button.json"), imported_press(programs, file, folder)
    check("travel in mm", abs(written[-1][0] - read[-1][0]) < MOST_MM, True)
    most_N = [max(force_N for _, force_N in press) for press in (written, read)]
    check("share of the largest force", min(most_N) / max(most_N) > LEAST_SHARE, True)


def imported_press(programs, file, folder):
    """The press as the command line reads it: mm, N."""
    button = folder / "read.button.json"
    told = subprocess.run([programs / "detent-import", file, "-o", button], capture_output=True, text=True, timeout=120)
    check(f"detent-import {file.name}: {told.stderr}", told.returncode, 0)
    return saved_press(programs, button)


def check(what, found, wanted):
    if found != wanted:
        raise AssertionError(f"{what}: {found}, not {wanted}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--bin", type=Path, required=True)
    parser.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[3])
    parser.add_argument("--keep", type=Path)
    arguments = parser.parse_args()
    missing = [tool for tool in ("Xvfb", "openbox", "xdotool", "localedef") if not shutil.which(tool)]
    if missing:
        print(f"SKIPPED the editor on a German desktop: {', '.join(missing)} not installed")
        return 0
    root, programs = arguments.root.resolve(), arguments.bin.resolve()
    with tempfile.TemporaryDirectory(prefix="detent-german-") as temporary:
        folder = Path(temporary)
        try:
            with Desktop(folder, language="de") as desktop:
                desktop.compile_locale()
                editor = read_a_drawing(root, programs, folder, desktop)
                write_a_drawing(editor, programs, folder, desktop)
        except (AssertionError, subprocess.SubprocessError) as failure:
            print(f"{type(failure).__name__}: {failure}")
            return 1
        finally:
            if arguments.keep:
                shutil.copytree(folder, arguments.keep, dirs_exist_ok=True, ignore_dangling_symlinks=True)
    print("read a drawing, and wrote one, where numbers have commas")
    return 0


if __name__ == "__main__":
    sys.exit(main())
