#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the pictures of docs/pictures from the project's own samples, in a real window on a screen of its own.

    make_pictures.py --bin FOLDER [--out docs/pictures] [NAME...]

Without names all of them. Look at them before committing. contact-sheet shows every view at several sizes,
light and dark, in English and German, on one sheet.
"""

import argparse
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from desktop import Desktop, Editor, wait_for

SIZE = (1240, 780)


class Camera:
    def __init__(self, root, programs, out, desktop):
        self.root, self.programs, self.out, self.desktop = root, programs, out, desktop

    def start(self, appearance, *files):
        config = self.desktop.folder / "config/Detent/detent-edit.conf"
        config.parent.mkdir(parents=True, exist_ok=True)
        config.write_text(f"[view]\nappearance={appearance}\n[library]\nfolder={self.root / 'samples/buttons'}\n")
        self.editor = Editor(self.desktop, self.programs / "detent-edit", [self.root / "samples" / file for file in files])
        self.editor.widget("mainWindow")
        self.resize()

    def resize(self, corner=(20, 30), size=SIZE):
        # The active window may be a dialogue that has just been closed.
        wait_for("a window that moves",
                 lambda: self.desktop.xdotool("windowmove", self.active_window(), *corner, check=False).returncode == 0)
        self.desktop.xdotool("windowsize", "--sync", self.active_window(), *size)
        time.sleep(0.5)

    def active_window(self):
        return wait_for("an active window", lambda: self.desktop.xdotool("getactivewindow", check=False).stdout.strip())

    def take(self, name):
        self.desktop.xdotool("mousemove", 5, 5)
        time.sleep(1.2)  # pictures of the library, status messages
        file = self.out / f"{name}.png"
        window = self.active_window()
        subprocess.run(["import", "-window", window, "-strip", "-define", "png:compression-level=9", str(file)],
                       env=self.desktop.environment, check=True, timeout=60)
        print(f"{file}: {file.stat().st_size // 1024} KiB")

    # ---- the pictures

    def main_light(self):
        self.start("light", "buttons/C.button.json", "buttons/latch.button.json", "buttons/B.button.json")
        self.editor.widget("graphCanvas")
        self.take("main-light")

    def main_dark(self):
        self.start("dark", "buttons/C.button.json", "buttons/latch.button.json", "buttons/B.button.json")
        self.editor.widget("graphCanvas")
        self.take("main-dark")

    def import_dialogue(self):
        self.start("light", "plots/two-level-legend.png")
        self.editor.widget("import", "importDialog", enabled=True, patience_s=120)
        self.take("import-dialogue")

    def main_underlay(self):
        self.start("light", "plots/two-level-legend.png")
        self.editor.click("import", "importDialog")
        self.editor.widget("graphCanvas")
        if self.editor.find("importDialog"):
            self.desktop.key("Escape")
            self.editor.gone("importDialog")
        self.take("main-underlay")

    def feel_panel(self):
        self.start("dark", "buttons/C.button.json", "buttons/B.button.json")
        self.desktop.key("alt+4")
        time.sleep(2)  # until the panel stands where it will stay
        pad = self.editor.at_rest("pressPad")
        window = self.active_window()
        x, y, width, height = pad["rect"]
        self.desktop.xdotool("mousemove", x + width // 2, y + height // 4)
        self.desktop.xdotool("mousedown", 1)
        self.desktop.xdotool("mousemove", x + width // 2, y + height // 2)
        time.sleep(0.6)
        file = self.out / "feel-panel.png"
        subprocess.run(["import", "-window", window, "-strip", str(file)], env=self.desktop.environment, check=True, timeout=60)
        self.desktop.xdotool("mouseup", 1)
        print(f"{file}: {file.stat().st_size // 1024} KiB")

    def feel_force(self):
        """A simulated finger on a simulated Falcon, caught on its way."""
        self.start("light", "buttons/C.button.json")
        self.desktop.key("alt+4")
        self.editor.widget("pressPad")
        time.sleep(1)  # until the panel stands where it will stay
        self.editor.click("setupToggle")
        x, y, width, height = self.editor.widget("driveChoice")["rect"]
        place = (x + width + 8, y + height // 2)  # the scroll bar: a wheel on a field would change it
        self.wheel(place, 5)
        self.choose("forceDevice", 2)
        self.wheel(place, 4)
        self.editor.click("setupToggle")
        self.editor.click("forceSwitch")
        time.sleep(2.3)
        self.take("feel-force")

    def wheel(self, place, button):
        self.desktop.xdotool("mousemove", *place)
        self.desktop.xdotool("click", "--repeat", 60, "--delay", 10, button)
        time.sleep(1)

    def choose(self, name, entry, window=None):
        """The entry of a list, counted from 0."""
        self.editor.click(name, window)
        time.sleep(0.7)
        self.desktop.key("Home", *["Down"] * entry, "Return")
        time.sleep(0.3)

    def views(self, appearance, folder):
        """Import, edit, compare and feel, each as a picture in a folder."""
        self.start(appearance, "plots/two-level-legend.png", *(f"buttons/{letter}.button.json" for letter in "ADCB"))
        width, height = (int(part) for part in self.desktop.size.split("x"))
        self.editor.widget("import", "importDialog", enabled=True, patience_s=120)
        self.whole_screen(folder / "1-import.png")
        self.desktop.key("Escape")
        self.editor.gone("importDialog")
        self.resize((0, 0), (width, height))
        for number, (view, keys) in enumerate({"edit": "alt+0", "compare": "ctrl+k", "feel": "alt+4"}.items(), 2):
            self.desktop.key(keys)
            time.sleep(2)  # the forecast of a comparison, the signal of a press
            self.whole_screen(folder / f"{number}-{view}.png")

    def whole_screen(self, file):
        subprocess.run(["import", "-window", "root", "-strip", str(file)], env=self.desktop.environment, check=True, timeout=60)

    def compare(self):
        self.start("light", "buttons/C.button.json", "buttons/B.button.json")
        self.desktop.key("ctrl+k")
        self.editor.widget("comparePanel")
        time.sleep(2)  # the forecast
        self.take("compare")

    def forecast_matrix(self):
        self.start("light", *(f"buttons/{letter}.button.json" for letter in "ABCD"))
        self.desktop.key("ctrl+shift+k")
        self.editor.widget("forecastMatrix")
        time.sleep(4)
        self.take("forecast-matrix")

    def study_desk(self):
        self.make_study()
        for answers in (2, 3):  # two simulated participants
            self.choose("studyAnswers", answers, "studyDesk")
            self.editor.click("studyStart", "studyDesk")
            time.sleep(1)
        self.take("study-desk")

    def study_participant(self):
        self.make_study()
        self.choose("studyAnswers", 1, "studyDesk")
        self.editor.click("studyStart", "studyDesk")
        time.sleep(1.5)  # until the window is where it says
        self.editor.click("studyBegin", "studyWindow")
        self.editor.click("studyContinue", "studyWindow")
        time.sleep(0.5)
        self.desktop.key("1", "2", "x")
        self.take("study-participant")

    def make_study(self):
        self.start("light", *(f"buttons/{letter}.button.json" for letter in "ABC"))
        self.desktop.key("ctrl+alt+k")
        self.editor.click("studyNew", "studyDesk")
        self.editor.click("makerFolder", "studyMaker")
        self.desktop.type(str(self.desktop.folder / "clicks"))
        self.editor.click("makerMake", "studyMaker")
        self.editor.gone("studyMaker")


PICTURES = {name.replace("_", "-"): name for name in
            ("main_light", "main_dark", "import_dialogue", "main_underlay", "feel_panel", "feel_force", "compare", "forecast_matrix",
             "study_desk", "study_participant")}


SHEET_SCREENS = (("1366x768", 1), ("1920x1080", 1), ("2732x1536", 2))  # pixels, and how many make one of the editor's
SHEET_THUMBNAIL = "640x360"


def contact_sheet(root, programs, out):
    """A row for each screen, appearance and language, a column for each view."""
    with tempfile.TemporaryDirectory(prefix="detent-pictures-") as folder:
        pictures = []
        for size, scale in SHEET_SCREENS:
            for appearance in ("light", "dark"):
                for language in ("en", "de"):
                    place = Path(folder) / f"{size}-{appearance}-{language}"
                    place.mkdir()
                    with Desktop(place, size, scale, language) as desktop:
                        Camera(root, programs, out, desktop).views(appearance, place)
                    pictures += sorted(place.glob("?-*.png"))
        file = out / "contact-sheet.jpg"
        subprocess.run(["montage", *map(str, pictures), "-tile", "4x", "-geometry", f"{SHEET_THUMBNAIL}+4+4", "-quality", "80", str(file)],
                       check=True, timeout=300)
        print(f"{file}: {len(pictures)} pictures, {file.stat().st_size // 1024} KiB")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("names", nargs="*", metavar="NAME", help=", ".join([*PICTURES, "contact-sheet"]))
    parser.add_argument("--bin", type=Path, required=True)
    parser.add_argument("--out", type=Path)
    arguments = parser.parse_args()
    root = Path(__file__).resolve().parents[3]
    out = (arguments.out or root / "docs/pictures").resolve()
    out.mkdir(parents=True, exist_ok=True)
    for name in arguments.names or [*PICTURES, "contact-sheet"]:
        if name == "contact-sheet":
            contact_sheet(root, arguments.bin.resolve(), out)
            continue
        with tempfile.TemporaryDirectory(prefix="detent-pictures-") as folder, Desktop(folder) as desktop:
            camera = Camera(root, arguments.bin.resolve(), out, desktop)
            getattr(camera, PICTURES[name])()
    return 0


if __name__ == "__main__":
    sys.exit(main())
