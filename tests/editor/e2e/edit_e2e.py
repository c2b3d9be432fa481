#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The editor as a person uses it, in a real window: import, correct an axis, drag, undo, save, kill, recover.

    edit_e2e.py --bin FOLDER [--root FOLDER] [--keep FOLDER]

With --keep the folder with logs, saved files and a screenshot of the moment of failure stays there.
"""

import argparse
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from desktop import Desktop, Editor, save_as, wait_for

PX_TOLERANCE = 2.5


class Walk:
    def __init__(self, root, programs, folder):
        self.root, self.programs, self.folder = root, programs, folder
        self.saved = folder / "two-level.button.json"

    def press_points(self):
        """Tactile points of the press curve in the saved file, as detent-graph reads them: mm, N."""
        shown = subprocess.run([self.programs / "detent-graph", "show", "--json", self.saved], capture_output=True, text=True,
                               check=True, timeout=60)
        press = json.loads(shown.stdout)["states"][0]["press"]
        return [(p["displacement_mm"], p["force_N"]) for p in press["tactile_points"]]

    def run(self):
        with Desktop(self.folder) as self.desktop:
            try:
                self.import_with_a_corrected_axis()
                self.save_under_a_name()
                self.drag_and_undo()
                self.kill_and_recover()
            except BaseException:
                self.desktop.screenshot(self.folder / "failure.png")
                raise

    def start(self, *files):
        self.editor = Editor(self.desktop, self.programs / "detent-edit", files)

    def import_with_a_corrected_axis(self):
        self.start(self.root / "samples/plots/two-level-legend.png")
        dialog = "importDialog"
        self.editor.widget("import", dialog, enabled=True)
        self.found_yMax = float(self.editor.widget("yMax", dialog)["text"].replace(",", "."))
        self.editor.replace_text("yMax", f"{2 * self.found_yMax:g}", dialog)
        self.desktop.key("Tab")
        wait_for("the correction to be read", lambda: self.editor.find("resetY", dialog, enabled=True))
        self.editor.click("import", dialog)
        self.editor.widget("graphCanvas")
        close_if_open(self.editor, dialog, self.desktop)

    def save_under_a_name(self):
        save_as(self.editor, self.saved)
        self.editor.gone("fileNameEdit")
        self.imported = self.press_points()
        # True values of the sample, with the axis stretched to twice the force.
        check_near("tactile points", len(self.imported), 2, 0)
        truth = subprocess.run([self.programs / "detent-import", self.root / "samples/plots/two-level-legend.png", "--json"],
                               capture_output=True, text=True, check=True, timeout=120)
        for found, true in zip(self.imported, json.loads(truth.stdout)["press"]["tactile_points"]):
            check_near("displacement of a tactile point, mm", found[0], true["displacement_mm"], 0.02)
            check_near("force of a tactile point at twice the axis, N", found[1], 2 * true["force_N"], 0.02)

    def drag_first_point(self, by_px):
        start = self.editor.on_graph(*self.press_points()[0])
        self.desktop.drag(start, (start[0] + by_px[0], start[1] + by_px[1]))
        self.editor.widget("tabBar")
        wait_for("the unsaved mark", lambda: any("*" in text for text in self.editor.find("tabBar")["tabs"]))

    def check_dragged(self, by_px):
        mm_per_px, N_per_px = self.editor.per_pixel()
        (x, y), (was_x, was_y) = self.press_points()[0], self.imported[0]
        check_near("dragged displacement, px", (x - was_x) / mm_per_px, by_px[0], PX_TOLERANCE)
        check_near("dragged force, px", (y - was_y) / N_per_px, -by_px[1], PX_TOLERANCE)

    def save(self):
        # A document that is still being recovered has no mark either, and nothing would be waited for.
        wait_for("something to save", lambda: any("*" in text for text in self.editor.widget("tabBar")["tabs"]))
        self.editor.active("mainWindow")
        self.desktop.key("ctrl+s")
        wait_for("the mark to go", lambda: all("*" not in text for text in self.editor.find("tabBar")["tabs"]))

    def drag_and_undo(self):
        before = self.saved.read_bytes()
        self.drag_first_point((14, -24))
        self.save()
        self.check_dragged((14, -24))
        self.desktop.key("ctrl+z")
        wait_for("undo to be shown", lambda: any("*" in text for text in self.editor.find("tabBar")["tabs"]))
        self.save()
        if self.saved.read_bytes() != before:
            raise AssertionError("undo did not restore the button exactly")

    def kill_and_recover(self):
        before = self.saved.read_bytes()
        recovery = self.folder / "data"

        def kept():
            return list(recovery.rglob("*.recovery.json"))

        # What the save made superfluous goes in the background; it is not what is waited for below.
        wait_for("the recovery file of before the save to go", lambda: not kept())
        self.drag_first_point((-10, -16))
        wait_for("the recovery file", kept, 5)
        self.editor.kill()
        if self.saved.read_bytes() != before:
            raise AssertionError("the saved file changed without saving")
        self.start()
        self.editor.click("recover")
        self.editor.widget("graphCanvas")
        self.save()
        self.check_dragged((-10, -16))
        self.desktop.key("ctrl+q")
        if self.editor.process.wait(20) != 0:
            raise AssertionError(f"detent-edit ended with {self.editor.process.returncode}")
        left = [file for file in recovery.rglob("*") if file.is_file() and "recovery" in str(file)]
        if left:
            raise AssertionError(f"a clean close left {left}")


def close_if_open(editor, dialog, desktop):
    if editor.find(dialog):
        desktop.key("Escape")
        editor.gone(dialog)


def check_near(what, value, wanted, tolerance):
    if not abs(value - wanted) <= tolerance:
        raise AssertionError(f"{what}: {value}, not {wanted} ± {tolerance}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--bin", type=Path, required=True)
    parser.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[3])
    parser.add_argument("--keep", type=Path)
    arguments = parser.parse_args()
    missing = [tool for tool in ("Xvfb", "openbox", "xdotool") if not shutil.which(tool)]
    if missing:
        print(f"SKIPPED end-to-end run of the editor: {', '.join(missing)} not installed")
        return 0
    with tempfile.TemporaryDirectory(prefix="detent-e2e-") as folder:
        walk = Walk(arguments.root.resolve(), arguments.bin.resolve(), Path(folder))
        try:
            walk.run()
        except (AssertionError, subprocess.SubprocessError) as failure:
            print(f"{type(failure).__name__}: {failure}")
            log = Path(folder) / "editor.log"
            if log.exists():
                print(log.read_text()[-2000:])
            return 1
        finally:
            if arguments.keep:
                shutil.copytree(folder, arguments.keep, dirs_exist_ok=True, ignore_dangling_symlinks=True)
    print("imported, corrected, dragged, undone, saved, killed, recovered")
    return 0


if __name__ == "__main__":
    sys.exit(main())
