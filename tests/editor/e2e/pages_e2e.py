#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages that are not read as they are, in a real window.

    pages_e2e.py --bin FOLDER [--keep FOLDER]

A page of three graphs: one whole, one whose force axis names no unit, one without numbers and with a gap in its curve, whose
frame, axes (by a click on the origin) and missing stretch are given by hand; all three imported at once and compared, with cursors. Then a page
askew: corners dragged freely, the grid that the axes imply drawn over it.
"""

import argparse
import math
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from desktop import Desktop, Editor, read_to_its_end, save_as, saved_press, wait_for

DIALOG = "importDialog"
TRAVEL_MM = 4.0


def force(x_mm, bump=0.25):
    """Of a full scale of 1."""
    return 0.2 + 0.1 * x_mm + bump * math.exp(-((x_mm - 1.2) / 0.5) ** 2)


class Plot:
    """A plot drawn into the quadrilateral of its corners (tl, tr, br, bl)."""

    def __init__(self, corners, title="", bump=0.25, top=None, unit="", gap=None):
        self.corners, self.title, self.bump, self.top, self.unit, self.gap = corners, title, bump, top, unit, gap
        self.map = square_to(corners)

    def place(self, x, y):
        """x, y: shares of the displacement and force axis."""
        return self.map(x, 1 - y)

    def curve(self, x_mm, lower=0.0):
        """The way back lies `lower`, but for the end of the travel, where the ways meet."""
        return self.place(x_mm / TRAVEL_MM, force(x_mm, self.bump) - lower * min(1, (TRAVEL_MM - x_mm) / 0.4))

    def svg(self):
        lines = [self.line([(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)], "#222", 1.5)]
        lines += [self.text(self.place(0.5, 1.05), self.title)]
        if self.top:
            lines += [self.line([(i / 4, 0), (i / 4, 1)], "#ccc", 1) for i in range(1, 4)]
            lines += [self.line([(0, i / 5), (1, i / 5)], "#ccc", 1) for i in range(1, 5)]
            lines += [self.text(self.place(i / 4, -0.08), f"{i * TRAVEL_MM / 4:g}") for i in range(5)]
            lines += [self.text(self.place(-0.05, i / 5 - 0.015), f"{i * self.top / 5:g}") for i in range(6)]
            lines += [self.text(self.place(0.5, -0.16), "Displacement (mm)"),
                      self.text(self.place(-0.13, 0.5), f"Force {self.unit}", turn=-90)]
        places = [TRAVEL_MM * i / 400 for i in range(401)]
        kept = [[x for x in places if not self.gap or x < self.gap[0]], [x for x in places if self.gap and x > self.gap[1]]]
        lines += [self.polyline([self.curve(x) for x in part], "#c00", 2) for part in kept if part]
        lines += [self.polyline([self.curve(x, 0.12) for x in places], "#06c", 2)]
        return "\n".join(lines)

    def line(self, shares, colour, width):
        return self.polyline([self.place(*share) for share in shares], colour, width)

    @staticmethod
    def polyline(places, colour, width):
        points = " ".join(f"{x:.2f},{y:.2f}" for x, y in places)
        return f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="{width}"/>'

    @staticmethod
    def text(place, words, turn=0):
        x, y = place
        return f'<text transform="translate({x:.1f},{y:.1f}) rotate({turn})" font-size="14" text-anchor="middle" ' \
               f'font-family="Helvetica">{words}</text>'


def square_to(quad):
    """From the unit square, y down, to four corners (tl, tr, br, bl)."""
    (x0, y0), (x1, y1), (x2, y2), (x3, y3) = quad
    dx1, dx2, dy1, dy2 = x1 - x2, x3 - x2, y1 - y2, y3 - y2
    sx, sy = x0 - x1 + x2 - x3, y0 - y1 + y2 - y3
    size = dx1 * dy2 - dx2 * dy1
    g, h = (sx * dy2 - dx2 * sy) / size, (dx1 * sy - sx * dy1) / size
    a, b, d, e = x1 - x0 + g * x1, x3 - x0 + h * x3, y1 - y0 + g * y1, y3 - y0 + h * y3
    return lambda u, v: ((a * u + b * v + x0) / (g * u + h * v + 1), (d * u + e * v + y0) / (g * u + h * v + 1))


def rectangle(left, top, width=340, height=260):
    return [(left, top), (left + width, top), (left + width, top + height), (left, top + height)]


def write_page(file, *plots):
    file.write_text('<svg xmlns="http://www.w3.org/2000/svg" width="1000" height="900" viewBox="0 0 1000 900">'
                    '<rect width="1000" height="900" fill="white"/>' + "\n".join(plot.svg() for plot in plots) + "</svg>")
    return file


WHOLE = Plot(rectangle(100, 80), "Switch Alpha", top=1, unit="(N)")
WITHOUT_UNIT = Plot(rectangle(600, 80), "Switch Beta", bump=0.4, top=100)
BARE = Plot(rectangle(100, 520), bump=0.3, gap=(2.5, 3.1))
ASKEW = Plot([(220, 120), (900, 170), (800, 700), (110, 640)])


class Walk:
    def __init__(self, programs, folder):
        self.programs, self.folder = programs, folder

    def run(self):
        with Desktop(self.folder) as self.desktop:
            try:
                self.several_graphs()
                self.compared()
                self.editor.kill()
                shutil.rmtree(self.folder / "data")  # what was not saved is not offered again
                self.askew()
            except BaseException:
                self.desktop.screenshot(self.folder / "failure.png")
                raise

    def open(self, page):
        self.editor = Editor(self.desktop, self.programs / "detent-edit", [page])
        wait_for("the page", lambda: self.editor.find("pageView", DIALOG))
        read_to_its_end(self.editor, DIALOG)

    def look(self, what):
        self.desktop.screenshot(self.folder / f"{what}.png")

    def text(self, name):
        widget = self.editor.find(name, DIALOG)
        return widget["text"] if widget and "text" in widget else ""

    def shows(self, name, text):
        wait_for(f"{name} to show {text!r}", lambda: text in self.text(name), 20)

    # ---- several graphs on one page

    def several_graphs(self):
        self.open(write_page(self.folder / "sheet.svg", WHOLE, WITHOUT_UNIT, BARE))
        self.editor.widget("import", DIALOG, enabled=True)
        self.ask_for_the_unit()
        self.give_a_third_graph()
        self.go_through_the_graphs()
        self.desktop.key("ctrl+shift+a")
        self.shows("import", "3")
        self.look("three-graphs")
        self.editor.click("import", DIALOG)
        wait_for("three tabs", lambda: len(self.editor.find("tabBar")["tabs"] if self.editor.find("tabBar") else []) == 3)
        titles = self.editor.find("tabBar")["tabs"]
        if not ("Alpha" in titles[0] and "Beta" in titles[1]):
            raise AssertionError(f"three graphs are called {titles}")

    def ask_for_the_unit(self):
        self.desktop.key("ctrl+Next")
        self.editor.widget("forceUnit_cN", DIALOG)
        if self.editor.find("import", DIALOG)["enabled"]:
            raise AssertionError("a force axis without a unit can be imported unasked")
        self.editor.click("forceUnit_cN", DIALOG)
        self.editor.widget("import", DIALOG, enabled=True)
        self.shows("yUnit", "cN")

    def give_a_third_graph(self):
        """Its frame, the origin by one click for both axes, one value of each, and the stretch that is missing."""
        self.desktop.key("ctrl+9")
        self.desktop.key("alt+3")
        self.editor.drag_on_page(BARE.corners[0], BARE.corners[2])
        self.shows("yMax", "")
        read_to_its_end(self.editor, DIALOG)
        self.desktop.key("alt+2")
        self.value_at((0, 0), "0")
        for reset in ("resetX", "resetY"):
            self.editor.widget(reset, DIALOG)
        self.value_at((1, 0), "4")
        self.value_at((0, 1), "1")
        self.shows("xMax", "4")
        self.shows("yMax", "1")
        for unit in ("lengthUnit_mm", "forceUnit_N"):
            self.editor.click(unit, DIALOG)
            read_to_its_end(self.editor, DIALOG)
        self.look("gap")
        self.desktop.key("alt+9")
        for i in range(9):
            self.desktop.click(self.editor.on_page(*BARE.curve(2.4 + 1.59 * i / 8)))
        self.look("bridging")
        self.desktop.key("Return")
        read_to_its_end(self.editor, DIALOG)
        self.shows("result", "tactile point 1.2")
        settle(self.editor)

    def value_at(self, share, value):
        self.desktop.click(self.editor.on_page(*BARE.place(*share)))
        self.editor.widget("tickValue", DIALOG)
        self.desktop.type(value)
        self.desktop.xdotool("key", "Return")
        self.editor.gone("tickValue")
        read_to_its_end(self.editor, DIALOG)

    def go_through_the_graphs(self):
        """The others kept their own findings."""
        for top in ("100", "1"):
            self.desktop.key("ctrl+Prior")
            wait_for(f"the graph up to {top}", lambda top=top: self.text("yMax") == top, 20)

    # ---- compared

    def compared(self):
        self.check_curve("the bridged curve", BARE, self.save("bridged"), 0.012)
        self.desktop.key("ctrl+k")
        self.editor.click("compareAdd")
        wait_for("a third button", lambda: self.editor.find("compareButtonC"))
        # What the panel has no room for stands beyond its scroll bar: the figure and the three values are in view.
        table = wait_for("three columns", lambda: self.columns_of(self.editor.find("compareTable"), 4))
        largest = [row for row in table if "largest force" in row[0]][0]
        for shown, plot in zip(largest[1:4], (BARE, WHOLE, WITHOUT_UNIT)):
            true_N = max(force(x / 100, plot.bump) for x in range(401))
            if abs(float(shown) - true_N) > 0.015:
                raise AssertionError(f"the largest forces {largest[1:4]} N, the unit of the pages, not {true_N:.3f}")
        left, top, width, height = self.editor.at_rest("comparePlot")["axes"]["rect"]
        middle = top + height / 2
        self.desktop.click((left + 0.3 * width, middle))
        self.desktop.move((left + 0.6 * width, middle))
        wait_for("values under both cursors",
                 lambda: len(self.reading()) == 2 and all(part.count(" press ") == 3 for part in self.reading()))
        self.look("compared")

    @staticmethod
    def columns_of(table, count):
        rows = {}
        for cell in table["cells"] if table else []:
            rows.setdefault(cell["row"], [cell["name"]] if "name" in cell else []).append(cell["text"])
        return list(rows.values()) if rows and len(rows[0]) >= count else None

    def reading(self):
        return self.editor.find("compareReading").get("text", "").splitlines()

    # ---- askew

    def askew(self):
        self.open(write_page(self.folder / "askew.svg", ASKEW))
        self.desktop.key("ctrl+9")
        self.desktop.key("alt+3")
        drawn = rectangle(200, 200, 500, 400)
        self.editor.drag_on_page(drawn[0], drawn[2])
        for corner, wanted in zip(drawn, ASKEW.corners):
            read_to_its_end(self.editor, DIALOG)
            self.editor.drag_on_page(corner, wanted)
        for field, value in (("xMin", "0"), ("xMax", "4"), ("yMin", "0"), ("yMax", "1")):
            self.editor.replace_text(field, value, DIALOG)
        self.desktop.xdotool("key", "Tab")
        read_to_its_end(self.editor, DIALOG)
        self.implied_grid()
        for key, lower in (("alt+4", 0), ("alt+5", 0.12)):  # where the frame's own lines are taken for curves
            self.desktop.key(key)
            self.desktop.click(self.editor.on_page(*ASKEW.curve(2.4, lower)))
            read_to_its_end(self.editor, DIALOG)
        for unit in ("lengthUnit_mm", "forceUnit_N"):
            self.editor.click(unit, DIALOG)
            read_to_its_end(self.editor, DIALOG)
        settle(self.editor)
        self.look("askew")
        self.editor.click("import", DIALOG)
        self.editor.widget("graphCanvas")
        self.check_curve("the curve of a page askew", ASKEW, self.save("askew"), 0.012)

    def implied_grid(self):
        """Its lines run as the corners do, not upright."""
        self.desktop.key("alt+1")
        self.desktop.move((5, 5))
        on_line, beside = ASKEW.place(0.5, 0.8), (ASKEW.place(0.5, 0)[0], ASKEW.place(0.5, 0.8)[1])
        before = [self.colour_at(place) for place in (on_line, beside)]
        self.desktop.key("alt+2")
        self.desktop.click(self.editor.on_page(*ASKEW.place(0.5, 0)))
        self.desktop.type("2")
        self.desktop.xdotool("key", "Return")
        read_to_its_end(self.editor, DIALOG)
        self.desktop.key("alt+1")
        self.desktop.move((5, 5))
        wait_for("the grid that the axes imply", lambda: differ(self.colour_at(on_line), before[0]), 20)
        if differ(self.colour_at(beside), before[1]):
            raise AssertionError("a line of the implied grid runs upright on a page askew")

    def colour_at(self, place):
        return self.desktop.darkest_near(self.editor.on_page(*place))

    # ---- saved

    def save(self, name):
        file = self.folder / f"{name}.button.json"
        save_as(self.editor, file)
        self.editor.gone("fileNameEdit")
        return file

    def check_curve(self, what, plot, file, within_N):
        press = saved_press(self.programs, file)
        if press[-1][0] < 0.98 * TRAVEL_MM:
            raise AssertionError(f"{what} ends at {press[-1][0]:.2f} mm")
        for x, found in press:
            if 0.1 < x < 3.9 and abs(found - force(x, plot.bump)) > within_N:
                raise AssertionError(f"{what}: {found:.3f} N at {x:.2f} mm, not {force(x, plot.bump):.3f} N")


def settle(editor):
    """What is in doubt still is confirmed."""
    if not editor.find("import", DIALOG, enabled=True):
        editor.click("confirmed", DIALOG)
        editor.widget("import", DIALOG, enabled=True)


def differ(a, b):
    return max(abs(p - q) for p, q in zip(a, b)) > 25


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--bin", type=Path, required=True)
    parser.add_argument("--keep", type=Path)
    arguments = parser.parse_args()
    missing = [tool for tool in ("Xvfb", "openbox", "xdotool", "import") if not shutil.which(tool)]
    if missing:
        print(f"SKIPPED pages given by hand: {', '.join(missing)} not installed")
        return 0
    with tempfile.TemporaryDirectory(prefix="detent-pages-") as folder:
        try:
            Walk(arguments.bin.resolve(), Path(folder)).run()
        except (AssertionError, subprocess.SubprocessError) as failure:
            print(f"{type(failure).__name__}: {failure}")
            return 1
        finally:
            if arguments.keep:
                shutil.copytree(folder, arguments.keep, dirs_exist_ok=True, ignore_dangling_symlinks=True)
    print("three graphs of one page, two of them helped, imported and compared; a page askew stood level")
    return 0


if __name__ == "__main__":
    sys.exit(main())
