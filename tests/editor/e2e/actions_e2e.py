#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How many actions a person needs in a real window, from a sheet to a saved button.

    actions_e2e.py --bin FOLDER [--root FOLDER] [--keep FOLDER] [--walk sheets|by-hand|screens] [--times N] [SHEET...]

Walks: sheets that import (those named, else a sample and six vendors' sheets of the corpus), where a click, a drag or a key is an action; by hand, a page of which
nothing is read, neither frame nor numbers nor curves, where clicks and drags count; and the windows on small screens and at twice
the size, in both languages. What is typed into a field belongs to the click on it.
"""

import argparse
import json
import math
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import time
import zlib
from pathlib import Path

from desktop import Desktop, Editor, read_to_its_end, save_as, wait_for

MOST_ACTIONS_THAT_IMPORT, MOST_CLICKS_BY_HAND = 5, 15
# Of the corpus that DETENT_CORPUS names, or that lies beside the checkout: four vendors, traces and pictures, first and later pages.
VENDOR_SHEETS = ["Cherry/EN_CHERRY_MX1A-1xxA_B.pdf", "Cherry/EN_CHERRY_MX3A-1xxA_B.pdf", "Gateron/Gateron ks-27 datasheet.pdf",
                 "Kailh/CPG151001D02-Brown-Sun.pdf", "Kailh/CPG1353S01D01-01.pdf", "Greetech/SPEC_GT02A1BFN_Rev_A.pdf"]
SCREENS = [("1024x700", 1, "en"), ("1024x700", 1, "de"), ("1366x768", 1, "en"), ("1366x768", 2, "en"), ("1366x768", 2, "de")]


def write_png(path, width, height, ink):
    """8-bit grey; ink(x, y) gives 0 (black) to 255."""
    rows = b"".join(b"\0" + bytes(ink(x, y) for x in range(width)) for y in range(height))

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)) +
                     chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


class BarePage:
    """A plot without a single number or word: the person knows that it goes to 4 mm and 1 N."""

    WIDTH, HEIGHT = 700, 500
    LEFT, TOP, RIGHT, BOTTOM = 80, 40, 620, 420
    TRAVEL_MM, FORCE_N = 4.0, 1.0

    def force_N(self, x_mm):
        bump = 0.25 * math.exp(-((x_mm - 1.2) / 0.5) ** 2)
        return min(0.2 + 0.1 * x_mm + bump, 1)

    def place(self, x_mm):
        return (self.LEFT + x_mm / self.TRAVEL_MM * (self.RIGHT - self.LEFT),
                self.BOTTOM - self.force_N(x_mm) / self.FORCE_N * (self.BOTTOM - self.TOP))

    def ink(self, x, y):
        on_frame = (x in (self.LEFT, self.RIGHT) and self.TOP <= y <= self.BOTTOM) or \
                   (y in (self.TOP, self.BOTTOM) and self.LEFT <= x <= self.RIGHT)
        if on_frame:
            return 90
        if not self.LEFT < x < self.RIGHT:
            return 255
        x_mm = (x - self.LEFT) / (self.RIGHT - self.LEFT) * self.TRAVEL_MM
        return 20 if abs(y - self.place(x_mm)[1]) <= 1 else 255


def from_a_sheet_that_imports(programs, sheet, folder):
    """Dropped on the window (here: named on the command line), imported, saved."""
    with Desktop(folder) as desktop:
        editor = Editor(desktop, programs / "detent-edit", [sheet])
        desktop.actions = 1  # the drop
        editor.click("import", "importDialog")
        editor.widget("graphCanvas")
        saved = folder / "imported.button.json"
        save_as(editor, saved)
        return desktop.actions


def by_hand(programs, folder):
    page = BarePage()
    sheet = folder / "bare.png"
    write_png(sheet, page.WIDTH, page.HEIGHT, page.ink)
    with Desktop(folder) as desktop:
        try:
            return walk_by_hand(page, Editor(desktop, programs / "detent-edit", [sheet]), desktop, folder)
        except BaseException:
            desktop.screenshot(folder / "failure.png")
            raise


def walk_by_hand(page, editor, desktop, folder):
    dialog = "importDialog"
    wait_for("the page", lambda: editor.find("pageView", dialog) and editor.find("adviceBar", dialog))
    editor.active(dialog)
    desktop.key("alt+3")
    editor.drag_on_page((page.LEFT, page.TOP), (page.RIGHT, page.BOTTOM))
    read_to_its_end(editor, dialog)
    for field, value in (("xMin", "0"), ("xMax", "4"), ("yMin", "0"), ("yMax", "1")):
        editor.replace_text(field, value, dialog)
    desktop.xdotool("key", "Tab")
    desktop.key("alt+9")
    read_to_its_end(editor, dialog)
    place, steps = editor.page_places(), 60
    desktop.trail([place(*page.place(page.TRAVEL_MM * (0.01 + 0.98 * i / steps))) for i in range(steps + 1)], pause_s=0.1)
    desktop.key("Return")
    read_to_its_end(editor, dialog)
    settle_doubts(editor, dialog)
    editor.click("import", dialog)
    editor.widget("graphCanvas")
    saved = folder / "by-hand.button.json"
    save_as(editor, saved)
    check_curve(page, saved)
    return desktop.clicks


def settle_doubts(editor, dialog):
    """The units are asked for; what is in doubt still is confirmed."""
    for choice in ("lengthUnit_mm", "forceUnit_N", "confirmed"):
        if editor.find("import", dialog, enabled=True):
            return
        if editor.find(choice, dialog):
            editor.click(choice, dialog)
            read_to_its_end(editor, dialog)


def check_curve(page, saved):
    for knot in json.loads(saved.read_text())["states"][0]["press"]:
        x, force = knot["displacement_mm"], knot["force_N"]
        if 0.1 < x < 3.9 and abs(force - page.force_N(x)) > 0.03:
            raise AssertionError(f"drawn by hand: {force:.3f} N at {x:.2f} mm, not {page.force_N(x):.3f} N")


class Fitting:
    """All that is seen lies on a small screen."""

    def __init__(self, editor, desktop):
        self.editor, self.desktop = editor, desktop
        self.width, self.height = (int(part) / desktop.scale for part in desktop.size.split("x"))

    def check(self, *names):
        """Widgets and windows, once they lie still."""
        for name in names:
            widget = self.editor.at_rest(name)
            window = next(w for w in self.editor.report()["windows"] if w["name"] == widget["window"])
            for what, (x, y, width, height) in ((name, widget["rect"]), (f"the window of {name}", window["rect"])):
                if x < 0 or y < 0 or x + width > self.width or y + height > self.height:
                    raise AssertionError(f"{what} is at {(x, y, width, height)}, the screen has {self.width:g} x {self.height:g}")

    def look(self, what):
        self.desktop.screenshot(self.desktop.folder / f"{what}.png")


def fits(programs, root, folder, size, scale, language):
    with Desktop(folder, size, scale, language) as desktop:
        editor = Editor(desktop, programs / "detent-edit", [root / "samples/plots/two-level-legend.png"])
        screen = Fitting(editor, desktop)
        editor.widget("import", "importDialog", enabled=True)
        screen.look("import")
        screen.check("import", "close", "pageView", "findingsPanel")
        editor.click("import", "importDialog")
        editor.gone("import")
        screen.check("graphCanvas", "inspectorDock", "unitButton", "tabBar")
        screen.look("window")
        for keys, dock in (("alt+5", "checksDock"), ("alt+4", "feelArea")):
            desktop.key(keys)
            screen.check(dock, "graphCanvas")
            screen.look(dock)


def vendor_sheets(root):
    folder = Path(os.environ.get("DETENT_CORPUS", root.parent / "shared/corpus")) / "datasheets/pdf"
    sheets = [folder / name for name in VENDOR_SHEETS if (folder / name).is_file()]
    if len(sheets) < len(VENDOR_SHEETS):
        print(f"SKIPPED {len(VENDOR_SHEETS) - len(sheets)} of {len(VENDOR_SHEETS)} vendors' sheets: not in {folder}", flush=True)
    return sheets


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("sheets", nargs="*", type=Path)
    parser.add_argument("--bin", type=Path, required=True)
    parser.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[3])
    parser.add_argument("--keep", type=Path)
    parser.add_argument("--walk", choices=("sheets", "by-hand", "screens"), help="this alone")
    parser.add_argument("--times", type=int, default=1, help="how often to walk by hand")
    arguments = parser.parse_args()
    missing = [tool for tool in ("Xvfb", "openbox", "xdotool") if not shutil.which(tool)]
    if missing:
        print(f"SKIPPED counting the editor's actions: {', '.join(missing)} not installed")
        return 0
    root, programs = arguments.root.resolve(), arguments.bin.resolve()
    failed = 0
    with tempfile.TemporaryDirectory(prefix="detent-actions-") as name:
        def walk(what, run, most=None):
            nonlocal failed
            folder = Path(name) / what.replace(" ", "-").replace("/", "-")
            folder.mkdir()
            try:
                actions = run(folder)
                print(f"{what}: " + (f"{actions} (at most {most})" if most else "fits"), flush=True)
                failed += bool(most and actions > most)
            except (AssertionError, subprocess.SubprocessError) as failure:
                print(f"{what}: {type(failure).__name__}: {failure}", flush=True)
                failed += 1

        asked = [arguments.walk] if arguments.walk else ["sheets", "by-hand", "screens"]
        sheets = [s.resolve() for s in arguments.sheets] or [root / "samples/plots/white-vector.pdf"] + vendor_sheets(root)
        for sheet in sheets if "sheets" in asked else []:
            walk(sheet.name, lambda folder: from_a_sheet_that_imports(programs, sheet, folder), MOST_ACTIONS_THAT_IMPORT)
        for time_walked in range(arguments.times if "by-hand" in asked else 0):
            walk(f"by hand {time_walked + 1}", lambda folder: by_hand(programs, folder), MOST_CLICKS_BY_HAND)
        for size, scale, language in SCREENS if "screens" in asked else []:
            walk(f"screen {size} at {scale}, {language}", lambda folder: fits(programs, root, folder, size, scale, language))
        if arguments.keep:
            shutil.copytree(name, arguments.keep, dirs_exist_ok=True, ignore_dangling_symlinks=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
