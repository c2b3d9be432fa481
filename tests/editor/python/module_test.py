#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""import detent against the programs, over all samples: module_test.py --root FOLDER --build FOLDER"""

import argparse
import importlib.util
import json
import os
import pickle
import random
import re
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import zlib
from pathlib import Path

import numpy as np

ROOT = BUILD = detent = None
UNTYPED = ("--ignore-missing-imports",)  # pandas and matplotlib of Debian 12 carry no types
SAMPLES = ("png", "svg", "pdf", "csv")


def program(name, *words):
    return subprocess.run([BUILD / "bin" / name, *map(str, words)], capture_output=True, text=True, errors="surrogateescape", check=False)


def plots():
    return [path for path in sorted((ROOT / "samples/plots").iterdir()) if path.suffix[1:] in SAMPLES]


def rows(csv, stroke):
    return np.array([[float(x) for x in line.split(",")[1:]] for line in csv.splitlines() if line.startswith(stroke + ",")])


def without_times(report):
    return {key: value for key, value in report.items() if key not in ("seconds", "outputs")}


class Reading(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def test_every_sample_gives_what_the_program_gives(self):
        read = 0
        for plot in plots():
            with self.subTest(plot.name):
                out, csv = self.folder / "x.button.json", self.folder / "x.csv"
                ran = program("detent-import", plot, "-o", out, "--csv", csv, "--json")
                if ran.returncode != 0:
                    with self.assertRaises(detent.Failure) as raised:
                        detent.read(plot)
                    self.assertEqual(raised.exception.code, ran.returncode)
                    self.assertEqual(str(raised.exception), json.loads(ran.stdout)["problem"])
                    continue
                button = detent.read(plot)
                read += 1
                self.assertEqual(without_times(button.report), without_times(json.loads(ran.stdout)))
                self.assertEqual(button.to_json(), out.read_text())
                np.testing.assert_array_equal(button.press, rows(csv.read_text(), "press"))
                if button.release is not None:
                    np.testing.assert_array_equal(button.release, rows(csv.read_text(), "release"))
                self.assertEqual(button.press.shape[1], 2)
        self.assertGreater(read, 5)

    def test_hints_settle_what_they_say(self):
        plot = ROOT / "samples/plots/black-red-curves.png"
        given = detent.read(plot, x_axis=(0, 10), x_unit="mm", quality="draft", page=1)
        self.assertEqual((given.report["x_axis"]["min"], given.report["x_axis"]["max"]), (0, 10))
        self.assertEqual(given.report["quality"], "draft")

    def test_failures_carry_code_and_remedies(self):
        (self.folder / "broken.png").write_text("not a picture")
        with self.assertRaises(detent.UnreadableInput) as raised:
            detent.read(self.folder / "broken.png")
        self.assertEqual(raised.exception.code, 3)
        with self.assertRaises(detent.NotCertain) as raised:
            detent.read(ROOT / "samples/plots/black-red-curves.png", sure=1.0)
        self.assertEqual(raised.exception.code, 5)
        self.assertTrue(raised.exception.remedies)
        with self.assertRaises(detent.WrongUsage) as raised:
            detent.read(ROOT / "samples/plots/black-red-curves.png", y_unit="furlong")
        self.assertIn("furlong", str(raised.exception))
        copy = pickle.loads(pickle.dumps(raised.exception))
        self.assertEqual((copy.code, str(copy)), (2, str(raised.exception)))

    def test_many_come_in_order_with_their_failures(self):
        (self.folder / "broken.png").write_text("not a picture")
        asked = [self.folder / "broken.png", *plots()[:3], self.folder / "absent.png"]
        got = list(detent.import_many(asked, jobs=2, quality="draft"))
        self.assertEqual([path for path, _ in got], asked)
        self.assertEqual([getattr(result, "code", 0) for _, result in got], [3, 0, 0, 0, 3])

    def test_what_was_read_before_changes_nothing(self):
        """The text engine and its thread live on between calls."""
        readable = [plot for plot in plots() if plot.suffix == ".png"]
        first = {plot: detent.read(plot, quality="draft", sure=0.0).to_json() for plot in readable}
        for plot, button in detent.import_many(readable[::-1], jobs=2, quality="draft", sure=0.0):
            self.assertEqual(button.to_json(), first[plot], plot)

    def test_what_python_refuses_is_not_begun(self):
        with self.assertRaises(detent.WrongUsage):
            detent.import_many(plots(), y_unit="furlong")
        with self.assertRaises(detent.WrongUsage):
            detent.import_many(plots(), jobs=0)
        with self.assertRaises(TypeError):
            detent.import_many(plots(), colour="red")

    def test_a_forked_process_reads(self):
        detent.read(plots()[0])  # by a thread that the child does not have
        pid = os.fork()
        if pid == 0:
            try:
                detent.read(plots()[0])
                os._exit(0)
            finally:
                os._exit(1)
        self.assertEqual(os.waitpid(pid, 0)[1], 0)

    def test_python_goes_on_while_the_library_reads(self):
        turns, over = [], threading.Event()

        def count():
            while not over.wait(0.001):
                turns.append(None)

        counter = threading.Thread(target=count)
        counter.start()
        detent.read(ROOT / "samples/plots/two-level-legend.png")  # some tenths of a second
        over.set()
        counter.join()
        self.assertGreater(len(turns), 10)

    def test_progress_is_shown_where_tqdm_is(self):
        code = "import detent, sys; print(sum(1 for _ in detent.import_many(sys.argv[1:], jobs=1, progress=True, quality='draft')))"
        ran = subprocess.run([sys.executable, "-c", code, *[str(ROOT / "samples/plots/force-meter-log.csv")] * 3], capture_output=True, text=True, check=True,
                             env={**os.environ, "PYTHONPATH": str(BUILD / "python")})
        self.assertEqual(ran.stdout.strip(), "3")
        if importlib.util.find_spec("tqdm"):
            self.assertIn("3/3", ran.stderr)

    def test_control_c_ends_many(self):
        page = self.long_page()
        threading.Timer(1.0, os.kill, (os.getpid(), signal.SIGINT)).start()
        begun = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            list(detent.import_many([page], jobs=2))
        self.assertLess(time.monotonic() - begun, 1.5)

    def test_control_c_ends_a_read_within_half_a_second(self):
        page = self.long_page()
        threading.Timer(1.0, os.kill, (os.getpid(), signal.SIGINT)).start()
        begun = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            detent.read(page)
        self.assertLess(time.monotonic() - begun, 1.5)

    def long_page(self):
        """A picture of noise, in which a graph is sought for several seconds."""
        page = self.folder / "page.png"
        noise = random.Random(1)
        page.write_bytes(grey_png(4000, 3000, lambda width: noise.randbytes(width)))
        return page


def grey_png(width, height, row=lambda width: b"\x80" * width):
    """A picture without a graph. `row`: gives the pixels of the next row."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)) + \
        chunk(b"IDAT", zlib.compress(b"".join(b"\0" + row(width) for _ in range(height)), 1)) + chunk(b"IEND", b"")


class Refusals(unittest.TestCase):
    """What a program refuses is refused with its sentence and code, and typed."""

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.b = ROOT / "samples/buttons/B.button.json"

    def assert_refused(self, call, ran):
        kinds = {2: detent.WrongUsage, 3: detent.UnreadableInput, 4: detent.NoForceGraph, 5: detent.NotCertain}
        said = re.sub("^detent-(play|graph|import): ", "", ran.stderr).split("\nRun with ")[0].rstrip("\n").splitlines()[0]
        self.assertNotEqual(ran.returncode, 0)
        with self.assertRaises(kinds[ran.returncode]) as raised:
            call()
        self.assertEqual((str(raised.exception), raised.exception.code), (said, ran.returncode))
        return raised.exception

    def file(self, name, content):
        (self.folder / name).write_bytes(content)
        return self.folder / name

    def test_inputs(self):
        page = (ROOT / "samples/plots/white-vector.pdf").read_bytes()
        inputs = [self.folder / "absent.png", self.folder, self.file("empty.png", b""), self.file("words.png", b"not a picture"),
                  self.file("cut.pdf", page[:len(page) // 2]), self.file("grey.png", grey_png(300, 200)), self.file("empty.svg", b"<svg"),
                  self.file("words.csv", b"a,b\nc,d\n"), self.file("picture.gif", b"GIF89a" + bytes(30)),
                  self.file("n\xc3\xa4ve \xff.png".encode("latin-1").decode("utf-8", "surrogateescape"), b"none"), self.file("--json", b"none")]
        for path in inputs:
            with self.subTest(path):
                self.assert_refused(lambda: detent.read(path), program("detent-import", path))

    def test_hints(self):
        plot = ROOT / "samples/plots/two-level-legend.png"
        for hints, options in (({"y_unit": "furlong"}, ["--y-unit", "furlong"]), ({"x_unit": "gf"}, ["--x-unit", "gf"]), ({"page": 0}, ["--page", "0"]),
                               ({"page": 9}, ["--page", "9"]), ({"graph": 7}, ["--graph", "7"]), ({"curve": "nobody"}, ["--curve", "nobody"]),
                               ({"sure": 2}, ["--sure", "2"]), ({"x_axis": (3, 3)}, ["--x-axis", "3.0:3.0"]), ({"frame": (1, 2, 3)}, ["--frame", "1.0,2.0,3.0"]),
                               ({"frame": (0, 0, 5, 5)}, ["--frame", "0.0,0.0,5.0,5.0"]), ({"press_color": "red"}, ["--press-color", "red"]),
                               ({"mask": [(1, 2)]}, ["--mask", "1.0,2.0"]), ({"mask": [(0, 0, 9999, 9999)]}, ["--mask", "0.0,0.0,9999.0,9999.0"]),
                               ({"quality": "best"}, ["--quality", "best"]), ({"dpi": 1}, ["--dpi", "1"]),
                               ({"y_axis": (0, float("nan"))}, ["--y-axis", "0.0:nan"]), ({"sure": 1.0}, ["--sure", "1.0"])):
            with self.subTest(hints):
                refusal = self.assert_refused(lambda: detent.read(plot, **hints), program("detent-import", plot, *options))
                if hints == {"sure": 1.0}:
                    self.assertTrue(refusal.remedies)

    def test_button_files(self):
        for name, content in (("n.button.json", b'{"format":"detent-button","version":99}'), ("w.button.json", b"{}"), ("c.button.json", self.b.read_bytes()[:300]),
                              ("x.csv", b"stroke,displacement_mm,force_N\npress,0,nan\n")):
            path = self.file(name, content)
            with self.subTest(name):
                self.assert_refused(lambda: detent.load(path), program("detent-graph", "show", path))

    def test_presses(self):
        button = detent.load(self.b)
        for name, content in (("p.csv", b"time_s,force_N\n0,0\n1,x\n"), ("h.csv", b"time,force\n"), ("e.csv", b"")):
            path = self.file(name, content)
            with self.subTest(name):
                self.assert_refused(lambda: detent.render(button, path),
                                    program("detent-play", "render", self.b, "--press", path, "-o", self.folder / "x.wav"))

    def test_what_has_no_option_is_an_error_of_python(self):
        with self.assertRaises(TypeError):
            detent.read(ROOT / "samples/plots/two-level-legend.png", colour="red")
        with self.assertRaises(TypeError):
            detent.render("a.button.json")


class Buttons(unittest.TestCase):
    def setUp(self):
        self.file = ROOT / "samples/buttons/C.button.json"
        self.button = detent.load(self.file)
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def test_figures_are_the_programs(self):
        shown = json.loads(program("detent-graph", "show", self.file, "--json").stdout)["states"][0]["figures"]
        self.assertEqual(self.button.figures(), shown)
        self.assertEqual(self.button.figures()["total_travel_mm"], self.button.press[:, 0].max() - self.button.press[:, 0].min())
        self.assertEqual(self.button.figures()["peak_force_N"], self.button.press[self.button.press[:, 0] <= self.button.figures()["peak_travel_mm"], 1].max())
        with self.assertRaises(IndexError):
            self.button.figures(2)

    def test_render_is_the_programs_sample_for_sample(self):
        wave = self.folder / "c.wav"
        program("detent-play", "render", self.file, "--standard-press", "-o", wave, "--bits", "float")
        samples = detent.render(self.button)
        self.assertEqual(wave.read_bytes()[-4 * samples.size:], samples.tobytes())
        self.assertGreater(np.abs(samples).max(), 0.01)
        program("detent-play", "render", self.file, "--standard-press", "--feel", "paper", "-o", wave, "--bits", "float")
        paper = detent.render(self.button, feel="paper")
        self.assertEqual(wave.read_bytes()[-4 * paper.size:], paper.tobytes())
        self.assertFalse(np.array_equal(paper, samples))
        for wrong in ({"rate_Hz": 1}, {"feel": "loud"}):
            with self.assertRaises(detent.WrongUsage):
                detent.render(self.button, **wrong)

    def test_a_button_is_a_value(self):
        self.button.save(self.folder / "copy.button.json")
        self.assertEqual((self.folder / "copy.button.json").read_bytes(), self.file.read_bytes())
        for copy in (detent.load(self.folder / "copy.button.json"), pickle.loads(pickle.dumps(self.button)),
                     detent.Button.from_json(self.button.to_json())):
            self.assertEqual(copy, self.button)
            self.assertEqual(hash(copy), hash(self.button))
        self.assertNotEqual(self.button, detent.load(ROOT / "samples/buttons/D.button.json"))
        with self.assertRaises(ValueError):
            self.button.press[0, 0] = 1
        with self.assertRaises(OSError):
            self.button.save(self.folder / "absent" / "x.button.json")
        self.assertEqual([path.name for path in self.folder.iterdir()], ["copy.button.json"])

    def test_edits_are_values(self):
        double = detent.edits.scale_force(2)
        self.assertEqual(pickle.loads(pickle.dumps(double)), double)
        both = self.button.edited(double, detent.edits.rename("twice"))
        self.assertEqual(both.name, "twice")
        self.assertAlmostEqual(both.figures()["peak_force_N"], 2 * self.button.figures()["peak_force_N"])
        self.assertEqual(self.button, detent.load(self.file))
        with self.assertRaises(detent.WrongUsage):
            self.button.edited(detent.edits.scale_force(0))

    def test_curves_are_views(self):
        graph = self.button.graphs[0]
        self.assertTrue(np.shares_memory(graph.press_force_N, graph.press))
        self.assertFalse(graph.press.flags.owndata)
        kept = detent.load(self.file).press  # outlives its button
        np.testing.assert_array_equal(kept, self.button.press)
        latch = detent.load(ROOT / "samples/buttons/latch.button.json")
        self.assertEqual([each.name for each in latch.graphs], ["off", "on"])

    def test_a_notebook_shows_the_graph(self):
        self.assertRegex(self.button._repr_svg_(), re.compile(r"<svg.*</svg>", re.S))
        self.assertIn("mm", repr(self.button))

    def test_every_sample_is_what_the_programs_say_of_it(self):
        for file in sorted((ROOT / "samples/buttons").glob("*.button.json")):
            with self.subTest(file.name):
                button = detent.load(file)
                self.assertEqual(button.to_json(), file.read_text())
                shown = json.loads(program("detent-graph", "show", file, "--json").stdout)["states"]
                self.assertEqual([graph.figures() for graph in button.graphs], [state["figures"] for state in shown])
                for ending in ("svg", "csv"):
                    program("detent-graph", "convert", file, self.folder / f"x.{ending}")
                self.assertEqual(button.svg(), (self.folder / "x.svg").read_text())
                if len(button.graphs) == 1:
                    csv = (self.folder / "x.csv").read_text()
                    np.testing.assert_array_equal(button.press, rows(csv, "press"))
                    if button.release is not None:
                        np.testing.assert_array_equal(button.release, rows(csv, "release"))
                wave = self.folder / "x.wav"
                program("detent-play", "render", file, "--standard-press", "-o", wave, "--bits", "float")
                self.assertEqual(wave.read_bytes()[-4 * detent.render(button).size:], detent.render(button).tobytes())

    def test_confusion_of_six_is_the_programs(self):
        """Pairs of four and more come in another order than two loops would give."""
        files = [ROOT / f"samples/buttons/{name}.button.json" for name in "ABCDEF"]
        told = json.loads(program("detent-play", "confusion", *files, "--json").stdout)["pairs"]
        place = {detent.load(file).name: at for at, file in enumerate(files)}
        expected = [{**pair, "a": place[pair["a"]], "b": place[pair["b"]]} for pair in told]
        self.assertEqual(len(expected), 15)
        self.assertEqual(detent.confusion(*map(detent.load, files)), expected)

    def test_performance_and_compare_are_the_programs(self):
        other = ROOT / "samples/buttons/D.button.json"
        told = json.loads(program("detent-play", "performance", self.file, other, "--operate-at", "1.5", "--json").stdout)["buttons"]
        self.assertEqual(detent.performance(self.button, detent.load(other), operate_at_mm=1.5), told)
        distance = json.loads(program("detent-graph", "compare", self.file, other, "--json").stdout)
        self.assertEqual(detent.compare(self.button, detent.load(other)), {key: value for key, value in distance.items() if key not in ("status", "command", "file", "other")})

    def test_confusion_names_places(self):
        pairs = detent.confusion(self.button, detent.load(ROOT / "samples/buttons/D.button.json"), self.button)
        self.assertEqual([(pair["a"], pair["b"]) for pair in pairs], [(0, 1), (0, 2), (1, 2)])
        self.assertAlmostEqual(pairs[1]["d_prime"], 0)
        self.assertGreater(pairs[0]["d_prime"], 0)


class Library(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.b, self.c = (detent.load(ROOT / f"samples/buttons/{name}.button.json") for name in "BC")

    def test_what_feels_alike(self):
        database = self.folder / "l.db"
        self.assertEqual(program("detent-import", "library", "index", ROOT / "samples/buttons", "--db", database).returncode, 0)
        found = detent.find_like(self.b, database, limit=3)
        self.assertEqual(len(found), 3)
        self.assertEqual((found[0]["name"], found[0]["group"]), (self.b.name, 1))
        self.assertLess(found[0]["distance_lab_noise"], 1e-6)
        with self.assertRaises(detent.UnreadableInput):
            detent.find_like(self.b, self.folder / "none.db")

    def test_between_and_average(self):
        self.assertTrue(np.array_equal(detent.between(self.b, self.c, 0).press, self.b.press))
        middle = detent.between(self.b, self.c)
        self.assertTrue(0 < middle.report["share"] < 1)
        mean, spread = detent.average(self.b, self.c)
        figure = spread["states"][0]["figures"]["total_travel_mm"]
        self.assertAlmostEqual(figure["mean"], (self.b.figures()["total_travel_mm"] + self.c.figures()["total_travel_mm"]) / 2)
        self.assertAlmostEqual(mean.figures()["total_travel_mm"], figure["mean"], places=6)
        with self.assertRaises(detent.WrongUsage):
            detent.average(self.b)
        with self.assertRaises(detent.WrongUsage):
            detent.between(self.b, self.c, 2)

    def test_performance_of_each(self):
        forecast = detent.performance(self.b)
        self.assertEqual(len(forecast), 1)
        self.assertIn("activation_s", forecast[0])


class Importing(unittest.TestCase):
    def imported(self, folder, **environment):
        return subprocess.run([sys.executable, "-c", "import detent"], env={**os.environ, "PYTHONPATH": str(folder), **environment},
                              capture_output=True, text=True, check=False)

    def test_installed_it_is_where_debians_python_looks(self):
        with tempfile.TemporaryDirectory() as folder:
            for prefix, place in (("usr", "usr/lib/python3/dist-packages"), ("local", "local/lib/python3.11/dist-packages")):
                subprocess.run(["cmake", "--install", BUILD, "--component", "python", "--prefix", Path(folder, prefix)], check=True, capture_output=True)
                self.assertEqual(self.imported(Path(folder, place)).returncode, 0, place)
                files = {path.name for path in Path(folder, place, "detent").iterdir()}
                self.assertTrue({"__init__.py", "_core.pyi", "_version.py", "py.typed"} <= files, files)

    def test_another_version_says_so(self):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(BUILD / "python/detent", Path(folder, "detent"))
            Path(folder, "detent/_version.py").write_text('version = "9.9.9"\n')
            ran = self.imported(folder)
        self.assertNotEqual(ran.returncode, 0)
        self.assertRegex(ran.stderr, r"ImportError: detent: the module is of version 9\.9\.9, its library \(.*\) of \d")


class OtherLibraries(unittest.TestCase):
    """Failures beside libraries that bring C++ of their own, whichever was imported first: in a child process, because a fault ends it."""

    FAILURES = """
import sys
root, empty = sys.argv[1:]
button, plot = root + "/samples/buttons/B.button.json", root + "/samples/plots/black-red-curves.png"
calls = [
    lambda: detent.read(plot, y_unit="furlong"),                                       # wrong usage
    lambda: detent.load(button).edited(detent.edits.scale_force(0)),
    lambda: detent.render(detent.load(button), feel="loud"),
    lambda: detent.confusion(detent.load(button)),
    lambda: detent.between(detent.load(button), detent.load(button), 2),
    lambda: detent.load("/absent.button.json"),                                        # unreadable
    lambda: detent.read("/absent.png"),
    lambda: detent.find_like(detent.load(button), "/absent.db"),
    lambda: detent.read(empty),                                                        # no force graph
    lambda: detent.read(plot, sure=1.0),                                               # not certain
]
for call in calls:
    try:
        call()
    except detent.Failure as failure:
        print(type(failure).__name__, failure.code, bool(str(failure)), flush=True)
print([getattr(result, "code", 0) for _, result in detent.import_many(["/absent.png", empty], jobs=2)], flush=True)
try:
    detent.load(button).figures(9)
except IndexError:
    print("IndexError", flush=True)
"""
    EXPECTED = ["WrongUsage 2 True"] * 5 + ["UnreadableInput 3 True"] * 3 + ["NoForceGraph 4 True", "NotCertain 5 True", "[3, 4]", "IndexError"]

    def test_every_failure_is_an_exception_with_each_library_first_and_last(self):
        with tempfile.TemporaryDirectory() as folder:
            empty = Path(folder, "grey.png")
            empty.write_bytes(grey_png(300, 200))
            for library in ("scipy.stats", "pandas", "matplotlib.pyplot"):
                if not importlib.util.find_spec(library.split(".")[0]):
                    print("SKIPPED", library, "is not installed")
                    continue
                for imports in (f"{library}, detent", f"detent, {library}"):
                    with self.subTest(imports):
                        ran = subprocess.run([sys.executable, "-c", f"import {imports}\n{self.FAILURES}", ROOT, empty], capture_output=True, text=True, check=False,
                                             env={**os.environ, "PYTHONPATH": str(BUILD / "python"), "MPLBACKEND": "agg"})
                        self.assertEqual((ran.returncode, ran.stdout.splitlines()), (0, self.EXPECTED), ran.stderr)

    def test_the_module_brings_no_second_unwinder(self):
        """libunwind and the compiler's unwinder define the same functions."""
        core = next((BUILD / "python/detent").glob("_core*.so"))
        loaded = subprocess.run(["ldd", core], capture_output=True, text=True, check=True).stdout
        self.assertIn("libgcc_s", loaded)
        self.assertNotIn("libunwind", loaded)


def cells_of(notebook):
    """The code of a notebook, a cell after the other."""
    cells = json.loads(notebook.read_text())["cells"]
    return "\n\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "code")


class Notebooks(unittest.TestCase):
    def test_they_run(self):
        for notebook in sorted((ROOT / "samples/notebooks").glob("*.ipynb")):
            with self.subTest(notebook.name), tempfile.TemporaryDirectory() as folder:
                ran = subprocess.run([sys.executable, "-c", cells_of(notebook)], cwd=ROOT, capture_output=True, text=True, check=False,
                                     env={**os.environ, "PYTHONPATH": str(BUILD / "python"), "MPLBACKEND": "agg", "TMPDIR": folder})
                if "No module named" in ran.stderr and "detent" not in ran.stderr.split("No module named")[1]:
                    print("SKIPPED", notebook.name, ran.stderr.splitlines()[-1])
                    continue
                self.assertEqual(ran.returncode, 0, ran.stderr)


class Page(unittest.TestCase):
    def test_what_the_page_shows_runs(self):
        text = (ROOT / "docs/guide/python.md").read_text()
        code = "\n".join(re.findall(r"^```python\n(.*?)^```$", text, re.S | re.M))
        ran = subprocess.run([sys.executable, "-c", code], cwd=ROOT, env={**os.environ, "PYTHONPATH": str(BUILD / "python")}, capture_output=True, text=True, check=False)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertIn("Pass --", ran.stdout)  # the doubt, and what to do next


class Types(unittest.TestCase):
    def test_types_are_strict(self):
        if not shutil.which("mypy", path="/usr/bin"):
            print("SKIPPED types: mypy is not installed")
            return
        with tempfile.TemporaryDirectory() as folder:
            scripts = []
            for notebook in (ROOT / "samples/notebooks").glob("*.ipynb"):
                scripts.append(Path(folder, notebook.stem.replace("-", "_") + ".py"))
                scripts[-1].write_text(cells_of(notebook))
            ran = subprocess.run(["/usr/bin/mypy", "--strict", "--cache-dir", folder, *UNTYPED, BUILD / "python/detent", *scripts],
                                 env={**os.environ, "MYPYPATH": str(BUILD / "python")}, capture_output=True, text=True, check=False)
        self.assertEqual(ran.returncode, 0, ran.stdout)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--root", type=Path, required=True)
    parser.add_argument("--build", type=Path, required=True)
    chosen, rest = parser.parse_known_args()
    ROOT, BUILD = chosen.root.resolve(), chosen.build.resolve()
    sys.path.insert(0, str(BUILD / "python"))
    import detent  # noqa: F811
    unittest.main(argv=[sys.argv[0], *rest])
