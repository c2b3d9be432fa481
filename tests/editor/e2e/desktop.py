# SPDX-License-Identifier: GPL-3.0-or-later
"""A screen of its own for tests: Xvfb with a window manager, mouse and keys by xdotool, widgets found by name.

Everything that is started here is ended here, by its process id.
"""

import json
import os
import signal
import subprocess
import time
from pathlib import Path

PATIENCE_S = 60.0
LOCALES = {"en": "C.UTF-8", "de": "de_DE.UTF-8"}
REST_S = 0.35  # what has not moved for so long lies still; the report is written every 0.1 s
REPORTS = 3  # and in so many reports, which come later from a busy program


class NotThere(AssertionError):
    """Something that was waited for did not come."""


def wait_for(what, question, patience_s=PATIENCE_S):
    """The first true answer to question(); NotThere names `what` otherwise."""
    end = time.monotonic() + patience_s
    while time.monotonic() < end:
        answer = question()
        if answer:
            return answer
        time.sleep(0.05)
    raise NotThere(f"{what}: not within {patience_s:.0f} s")


def end(process):
    if process.poll() is None:
        process.terminate()
        try:
            process.wait(10)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()


class Desktop:
    """Xvfb on a display that is free, with openbox. Use with `with`. Places are in the editor's pixels, `scale` screen pixels each."""

    def __init__(self, folder, size="1500x950", scale=1, language="en"):
        self.folder, self.size, self.scale, self.language = Path(folder), size, scale, language
        self.started = []
        self.manager = None
        self.actions = 0  # clicks, drags and keys of a person; what is typed into a field belongs to its click
        self.clicks = 0  # clicks and drags alone

    def __enter__(self):
        try:
            self.open()
        except BaseException:
            self.__exit__()
            raise
        return self

    def open(self):
        reading, writing = os.pipe()
        log = (self.folder / "xvfb.log").open("w")
        self.start(["Xvfb", "-displayfd", str(writing), "-screen", "0", f"{self.size}x24", "-nolisten", "tcp", "-dpi", "96"],
                   stdout=log, stderr=log, pass_fds=[writing])
        os.close(writing)
        with os.fdopen(reading) as number:
            self.display = ":" + number.readline().strip()
        if self.display == ":":
            raise NotThere(f"Xvfb did not start; its words are in {log.name}")
        self.environment = dict(os.environ, DISPLAY=self.display, QT_QPA_PLATFORM="xcb", LC_ALL=LOCALES[self.language],
                                XDG_CONFIG_HOME=str(self.folder / "config"), XDG_DATA_HOME=str(self.folder / "data"),
                                XDG_RUNTIME_DIR=str(self.folder), HOME=str(self.folder), QT_SCALE_FACTOR=str(self.scale))
        self.environment.pop("WAYLAND_DISPLAY", None)
        wait_for("a window manager", self.is_managed)

    def compile_locale(self):
        """Gives programs started from now on the C library's rules of the language, too; without it they hold for Qt alone."""
        name = LOCALES[self.language]
        subprocess.run(["localedef", "-i", name.split(".")[0], "-f", "UTF-8", str(self.folder / name)], check=True,
                       capture_output=True, timeout=60)
        self.environment["LOCPATH"] = str(self.folder)

    def is_managed(self):
        """Whether windows are managed; on a busy machine openbox may end before the screen answers it, and is started again."""
        if self.manager is None or self.manager.poll() is not None:
            log = (self.folder / "openbox.log").open("a")
            self.manager = self.start(["openbox"], env=self.environment, stdout=log, stderr=log)
        return self.xdotool("get_desktop", check=False).returncode == 0

    def __exit__(self, *_):
        for process in reversed(self.started):
            end(process)

    def start(self, command, **options):
        process = subprocess.Popen(command, **options)
        self.started.append(process)
        return process

    def xdotool(self, *words, check=True):
        return subprocess.run(["xdotool", *map(str, words)], env=self.environment, check=check, capture_output=True, text=True,
                              timeout=30)

    def key(self, *keys):
        self.actions += 1
        self.xdotool("key", "--clearmodifiers", *keys)

    def type(self, text):
        self.xdotool("type", "--clearmodifiers", "--delay", 8, text)

    def move(self, place, *options):
        self.xdotool("mousemove", *options, *(round(self.scale * part) for part in place))

    def click(self, place):
        self.actions += 1
        self.clicks += 1
        self.move(place, "--sync")
        self.xdotool("click", 1)

    def drag(self, start, stop, steps=12):
        """Like a hand: several moves, a little time in each."""
        self.trail([start] + [[a + (b - a) * i / steps for a, b in zip(start, stop)] for i in range(1, steps + 1)])

    def trail(self, places, pause_s=0.02):
        """One drag along places. A busy window takes several moves for one: a longer pause lets it see each."""
        self.actions += 1
        self.clicks += 1
        self.move(places[0], "--sync")
        self.xdotool("mousedown", 1)
        for place in places[1:]:
            self.move(place)
            time.sleep(pause_s)
        self.xdotool("mouseup", 1)

    def darkest_near(self, place):
        """Red, green, blue of the darkest of 3 x 3 screen pixels."""
        x, y = (round(self.scale * part) - 1 for part in place)
        pixels = subprocess.run(["import", "-window", "root", "-crop", f"3x3+{x}+{y}", "-depth", "8", "rgb:-"], env=self.environment,
                                check=True, capture_output=True, timeout=30).stdout
        return min((pixels[i:i + 3] for i in range(0, len(pixels), 3)), key=sum)

    def screenshot(self, file):
        subprocess.run(["import", "-window", "root", str(file)], env=self.environment, check=False, timeout=30)


def geometry_report(program, file):
    """Environment in which a program of Qt writes names and places of its widgets to a file (tests/editor/geometry)."""
    return {"QT_PLUGIN_PATH": str(Path(program).resolve().parent / "test_plugins"), "QT_QPA_GENERIC_PLUGINS": "widget_geometry",
            "DETENT_WIDGET_GEOMETRY": str(file)}


class Editor:
    """A running detent-edit and what it tells about its widgets."""

    def __init__(self, desktop, program, files=()):
        self.desktop = desktop
        self.geometry = desktop.folder / "geometry.json"
        self.geometry.unlink(missing_ok=True)
        self.log = (desktop.folder / "editor.log").open("a")
        self.process = desktop.start([program, *map(str, files)], env={**desktop.environment, **geometry_report(program, self.geometry)},
                                     stdout=self.log, stderr=self.log)

    def report(self):
        if self.process.poll() is not None:
            raise NotThere(f"detent-edit has ended with {self.process.returncode}; its words are in {self.log.name}")
        try:
            return json.loads(self.geometry.read_text())
        except (FileNotFoundError, json.JSONDecodeError):
            return {"windows": [], "widgets": []}

    def find(self, name, window=None, report=None, **wanted):
        for widget in (report or self.report())["widgets"]:
            if widget["name"] == name and window in (None, widget["window"]) and all(widget.get(k) == v for k, v in wanted.items()):
                return widget
        return None

    def widget(self, name, window=None, patience_s=PATIENCE_S, **wanted):
        """Waits until it is there as wanted (enabled=True, text="...")."""
        return wait_for(f"widget {name} {wanted or ''}", lambda: self.find(name, window, **wanted), patience_s)

    def at_rest(self, name, window=None, **wanted):
        """As widget(), but waits until it lies still too, in a window that is on the screen: nobody aims at what is moving."""
        rest = Rest(self)

        def still():
            report = self.report()
            now = self.find(name, window, report, **wanted)
            shown = now and any(w["name"] == now["window"] and w["exposed"] for w in report["windows"])
            return rest.of(shown and (now["rect"], now.get("page"))) and now

        return wait_for(f"widget {name} {wanted or ''} to lie still", still)

    def active(self, window):
        """Waits until the window has the keys."""
        wait_for(f"{window} to have the keys",
                 lambda: any(w["name"] == window and w["active"] for w in self.report()["windows"]))

    def gone(self, name):
        wait_for(f"{name} to go away", lambda: not self.find(name))

    def click(self, name, window=None, **wanted):
        self.desktop.click(centre(self.at_rest(name, window, enabled=True, **wanted)))

    def replace_text(self, name, text, window=None):
        self.click(name, window)
        self.desktop.xdotool("key", "--clearmodifiers", "ctrl+a")
        self.desktop.type(text)

    def on_graph(self, x_mm, y_N, name="graphCanvas"):
        """Where a place of the force graph is on the screen; plots are in mm and N whatever is shown."""
        axes = self.widget(name)["axes"]
        left, top, width, height = axes["rect"]
        (_, x0, x1), (_, y0, y1) = axes["x"], axes["y"]
        return (left + (x_mm - x0) / (x1 - x0) * width, top + (y1 - y_N) / (y1 - y0) * height)

    def page_places(self):
        """Where places (x, y) of the page in the import dialogue are on the screen now."""
        view = self.at_rest("pageView")
        left, top = view["rect"][:2]
        m11, m12, m21, m22, dx, dy = view["page"]
        return lambda x, y: (left + m11 * x + m21 * y + dx, top + m12 * x + m22 * y + dy)

    def on_page(self, x, y):
        return self.page_places()(x, y)

    def drag_on_page(self, start, stop):
        """Both ends as the page lies when the drag begins."""
        place = self.page_places()
        self.desktop.drag(place(*start), place(*stop))

    def per_pixel(self, name="graphCanvas"):
        """mm and N of one pixel."""
        axes = self.widget(name)["axes"]
        _, _, width, height = axes["rect"]
        return ((axes["x"][2] - axes["x"][1]) / width, (axes["y"][2] - axes["y"][1]) / height)

    def kill(self):
        self.process.send_signal(signal.SIGKILL)
        self.process.wait(20)


class Rest:
    """Whether a place lies still: for REST_S, and in REPORTS further reports."""

    def __init__(self, editor):
        self.file, self.seen, self.since, self.times = editor.geometry, None, 0.0, set()

    def of(self, place):
        """True if the place, which a false one is not, was this for long enough."""
        if place != self.seen:
            self.seen, self.since, self.times = place, time.monotonic(), set()
        if self.file.exists():
            self.times.add(self.file.stat().st_mtime_ns)
        return bool(place) and time.monotonic() - self.since >= REST_S and len(self.times) > REPORTS


def read_to_its_end(editor, dialog):
    """Until what was given to the import is read, and for a while nothing more: a message about it may move the page."""
    time.sleep(0.2)  # what was done last reaches the program, and its report the file
    rest = Rest(editor)

    def read():
        view = editor.find("pageView", dialog)
        return rest.of(view and not view["reading"] and (view["rect"], view["page"]))

    wait_for("the page to be read", read, 2 * PATIENCE_S)


def save_as(editor, path):
    """Saves by keys under a name. Nobody types before the field has the keys, or confirms before it shows the name."""
    editor.active("mainWindow")
    editor.desktop.key("ctrl+s")
    field = editor.widget("fileNameEdit", focus=True)
    editor.active(field["window"])
    if str(path) not in field["text"]:  # where it is saved is the test's business, not an action of the person
        editor.desktop.xdotool("key", "--clearmodifiers", "ctrl+a")
        editor.desktop.type(str(path))
        editor.widget("fileNameEdit", text=str(path))
    editor.desktop.key("Return")
    wait_for(f"the saved file {path.name}", path.exists)


def saved_press(programs, file):
    """The press curve of a saved button: mm, N."""
    samples = file.with_suffix(".csv")
    subprocess.run([programs / "detent-graph", "convert", file, samples], check=True, capture_output=True, timeout=60)
    rows = (line.split(",") for line in samples.read_text().splitlines())
    return [(float(x), float(y)) for stroke, x, y in rows if stroke == "press"]


def centre(widget):
    x, y, width, height = widget["rect"]
    return (x + width // 2, y + height // 2)
