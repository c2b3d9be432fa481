#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Graphs that leave for programs of others and come back: CSV, data packages, projects of WebPlotDigitizer, travel over force.

    exchange_test.py --bin FOLDER --samples FOLDER
"""

import argparse
import csv
import hashlib
import io
import json
import math
import pathlib
import struct
import subprocess
import tarfile
import tempfile
import unittest
import zlib

ARGUMENTS = None
MOST_SHARE = 0.002  # of the span, that a way out and back in may cost


def run(program, *arguments):
    return subprocess.run([str(ARGUMENTS.bin / program), *map(str, arguments)], capture_output=True, text=True)


def sample(name):
    return ARGUMENTS.samples / f"{name}.button.json"


def rows(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def strokes_of(name, folder):
    """Press and release of a sample as the contract's CSV has them."""
    out = folder / "samples.csv"
    run("detent-graph", "convert", sample(name), out)
    strokes = {"press": [], "release": []}
    for row in rows(out):
        strokes[row["stroke"]].append((float(row["displacement_mm"]), float(row["force_N"])))
    return strokes


def project(sets, axes=None, version=(4, 2)):
    axes = axes or {"name": "XY", "type": "XYAxes", "isLogX": False, "isLogY": False, "noRotation": False,
                    "calibrationPoints": []}
    return {"version": list(version), "axesColl": [axes], "measurementColl": [],
            "datasetColl": [{"name": name, "axesName": axes["name"], "metadataKeys": [], "data": data,
                             "autoDetectionData": None} for name, data in sets]}


def indexed(png):
    """A PNG of four bits a pixel with a palette: its size, rows of indexes, colours."""
    assert png[:8] == b"\x89PNG\r\n\x1a\n"
    at, chunks = 8, {}
    while at < len(png):
        size, kind = int.from_bytes(png[at:at + 4], "big"), png[at + 4:at + 8]
        body = png[at + 8:at + 8 + size]
        assert zlib.crc32(kind + body) == int.from_bytes(png[at + 8 + size:at + 12 + size], "big")
        chunks[kind] = body
        at += 12 + size
    width, height, bits, color = struct.unpack(">IIBB", chunks[b"IHDR"][:10])
    assert (bits, color) == (4, 3)
    raw, line = zlib.decompress(chunks[b"IDAT"]), 1 + (width + 1) // 2
    rows = [[v for byte in raw[y * line + 1:(y + 1) * line] for v in (byte >> 4, byte & 15)][:width] for y in range(height)]
    palette = chunks[b"PLTE"]
    return width, height, rows, [list(palette[i:i + 3]) for i in range(0, len(palette), 3)]


def valued(points):
    return [{"x": 0, "y": 0, "value": list(point)} for point in points]


class Exchange(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)
        self.addCleanup(self.temporary.cleanup)

    def imported(self, path, *options):
        out = self.folder / "back.button.json"
        out.unlink(missing_ok=True)
        result = run("detent-import", path, "-o", out, *options)
        return result, out

    def assert_like(self, path, button, *options):
        result, out = self.imported(path, *options)
        self.assertEqual(result.returncode, 0, result.stderr)
        compared = json.loads(run("detent-graph", "compare", button, out, "--json").stdout)
        self.assertLess(compared["max_of_span"], MOST_SHARE, f"{path.name}: {compared}")

    def test_every_sample_comes_back(self):
        for name in "ABCDEF":
            for ending in (".csv", ".wpd.json", ".tar"):
                with self.subTest(button=name, ending=ending):
                    out = self.folder / (name + ending)
                    self.assertEqual(run("detent-graph", "convert", sample(name), out).returncode, 0)
                    self.assert_like(out, sample(name))

    def test_a_project_in_other_units_comes_back(self):
        out = self.folder / "C.wpd.json"
        run("detent-graph", "convert", sample("C"), out, "--force-unit", "gf", "--length-unit", "in")
        self.assert_like(out, sample("C"))

    def test_a_project_stands_on_the_plot(self):
        """Places of the data sets, calibrated as WebPlotDigitizer does, are the values beside them."""
        out = self.folder / "C.wpd.json"
        run("detent-graph", "convert", sample("C"), out)
        written = json.loads(out.read_text(encoding="utf-8"))
        x1, x2, y1, y2 = written["axesColl"][0]["calibrationPoints"]
        for one in written["datasetColl"]:
            for point in one["data"]:
                x = float(x1["dx"]) + (point["x"] - x1["px"]) / (x2["px"] - x1["px"]) * (float(x2["dx"]) - float(x1["dx"]))
                y = float(y1["dy"]) + (point["y"] - y1["py"]) / (y2["py"] - y1["py"]) * (float(y2["dy"]) - float(y1["dy"]))
                self.assertAlmostEqual(x, point["value"][0], places=9)
                self.assertAlmostEqual(y, point["value"][1], places=9)
        svg = self.folder / "C.svg"
        run("detent-graph", "convert", sample("C"), svg)
        frame = f'<rect x="{x1["px"]:.2f}" y="{y2["py"]:.2f}"'
        self.assertIn(frame, svg.read_text(encoding="utf-8"))

    def test_an_archive_holds_its_picture(self):
        """As WebPlotDigitizer reads it: info.json names project and pictures; both strokes' pixels lie where the data sets are."""
        out = self.folder / "C.tar"
        run("detent-graph", "convert", sample("C"), out)
        with tarfile.open(out) as archive:
            files = {m.name: archive.extractfile(m).read() for m in archive.getmembers() if m.isfile()}
        root = next(n for n in files if n.endswith("/info.json"))[:-len("info.json")]
        info = json.loads(files[root + "info.json"])
        self.assertEqual(info["json"], "wpd.json")
        picture = files[root + info["images"][0]]
        plain = self.folder / "C.wpd.json"
        run("detent-graph", "convert", sample("C"), plain)
        self.assertEqual(files[root + "wpd.json"], plain.read_bytes())
        width, height, rows, colors = indexed(picture)
        self.assertEqual((width, height), (640, 460))
        for one in json.loads(files[root + "wpd.json"])["datasetColl"]:
            ink = [200, 0, 0] if one["name"] == "press" else [0, 80, 200]
            met = sum(any(colors[rows[round(p["y"]) + dy][round(p["x"]) + dx]] in (ink, [200, 0, 0])
                          for dy in (-1, 0, 1) for dx in (-1, 0, 1)) for p in one["data"])
            self.assertEqual(met, len(one["data"]), one["name"])

    def test_an_archive_of_another_program_without_values(self):
        """As AutoLineDigitizer writes it: places only, an empty default set first, a page turned by two degrees."""
        strokes = strokes_of("C", self.folder)
        cosine, sine = math.cos(math.radians(2)), math.sin(math.radians(2))

        def place(x, y):
            along, up = 100 + 100 * x, 500 - 300 * y
            return along * cosine - up * sine, along * sine + up * cosine

        def known(x, y):
            px, py = place(x, y)
            return {"px": px, "py": py, "dx": str(x), "dy": str(y), "dz": None}

        axes = {"name": "XY", "type": "XYAxes", "isLogX": False, "isLogY": False, "noRotation": False,
                "calibrationPoints": [known(0, 0), known(4, 0), known(0, 0), known(0, 1)]}

        def placed(points):
            return [{"x": place(*p)[0], "y": place(*p)[1], "value": None} for p in points]

        made = project([("Default Dataset", []), ("Dataset 1", placed(strokes["release"])),
                        ("Dataset 2", placed(strokes["press"]))], axes)
        archive = self.folder / "project.tar"
        with tarfile.open(archive, "w") as tar:
            for name, text in (("p/info.json", json.dumps({"version": [4, 0], "json": "wpd.json"})),
                               ("p/wpd.json", json.dumps(made)), ("p/image.png", "no picture")):
                member = tarfile.TarInfo(name)
                member.size = len(text.encode())
                tar.addfile(member, io.BytesIO(text.encode()))
        self.assert_like(archive, sample("C"))
        cut = self.folder / "cut.tar"
        cut.write_bytes(archive.read_bytes()[:2000])
        result, out = self.imported(cut)
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertFalse(out.exists())

    def test_strokes_traced_from_their_other_ends(self):
        strokes = strokes_of("C", self.folder)
        path = self.folder / "hand.json"
        path.write_text(json.dumps(project([("Cherry down", valued(strokes["press"][::-1])),
                                            ("Cherry return", valued(strokes["release"][::-1]))])))
        self.assert_like(path, sample("C"))

    def test_several_switches_are_asked_for(self):
        path = self.folder / "several.json"
        line = [(i / 10, 0.1 + i / 50) for i in range(41)]
        lower = [(x, f - 0.05) for x, f in line]
        path.write_text(json.dumps(project([("red press", valued(line)), ("red release", valued(lower)),
                                            ("blue press", valued([(x, 1.5 * f) for x, f in line])),
                                            ("blue release", valued([(x, 1.5 * f) for x, f in lower]))])))
        result, _ = self.imported(path)
        self.assertEqual(result.returncode, 5)
        self.assertIn("red", result.stderr)
        self.assertEqual(self.imported(path, "--curve", "blue")[0].returncode, 0)

    def test_points_of_both_strokes_in_one_set_are_refused(self):
        strokes = strokes_of("C", self.folder)
        both = sorted(strokes["press"][:-1] + strokes["release"][2:])
        path = self.folder / "mixed.json"
        path.write_text(json.dumps(project([("Default Dataset", valued(both))])))
        result, out = self.imported(path)
        self.assertEqual(result.returncode, 5, result.stderr)
        self.assertFalse(out.exists())

    def test_a_data_package_has_its_name_and_its_curve_is_what_is_imported(self):
        made = run("detent-graph", "convert", sample("B"), self.folder / "B.datapackage.json")
        self.assertEqual(made.returncode, 2, made.stderr)
        self.assertIn("FOLDER/datapackage.json", made.stderr)
        self.assertFalse((self.folder / "B.datapackage.json").exists())
        self.assertEqual(run("detent-graph", "convert", sample("B"), self.folder / "datapackage.json").returncode, 0)
        result, out = self.imported(self.folder / "datapackage.json")
        self.assertEqual(result.returncode, 4, result.stderr)
        self.assertIn("Import the CSV file of its curve", result.stderr)
        self.assertFalse(out.exists())
        self.assert_like(self.folder / "curve.csv", sample("B"))

    def test_bad_projects_are_refused(self):
        line = valued([(0, 0.1), (4, 0.9)])
        polar = {"name": "XY", "type": "PolarAxes"}
        for name, made, code in (("version", project([("press", line)], version=(5, 0)), 3),
                                 ("no version", {"axesColl": [], "datasetColl": []}, 3),
                                 ("empty", project([]), 4),
                                 ("polar", project([("press", line)], polar), 4),
                                 ("nowhere", project([("press", [{"x": 1e308, "y": 1, "value": [None, 0]}])]), 4),
                                 ("wrong kinds", {"version": [4], "axesColl": [3], "datasetColl": {"a": 1}}, 4),
                                 ("releases", project([("release", line)]), 4)):
            with self.subTest(name):
                path = self.folder / "bad.json"
                path.write_text(json.dumps(made))
                result, out = self.imported(path)
                self.assertEqual(result.returncode, code, result.stderr)
                self.assertFalse(out.exists())

    def test_a_thinned_table_is_no_bulge(self):
        """Straight pieces of which only the ends are left stay straight; a handful of rows are not smoothed away."""
        path = self.folder / "few.csv"
        path.write_text("stroke,displacement_mm,force_N\npress,0,0.38\npress,4,0.82\npress,4,1.1\n"
                        "release,4,1.1\nrelease,4,0.76\nrelease,0,0.32\n")
        result, out = self.imported(path)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertNotIn("reversed", result.stderr)
        back = strokes_of_button(out, self.folder)
        self.assertAlmostEqual(back["press"][0][1], 0.38, places=3)
        self.assertAlmostEqual(back["release"][-1][1], 0.32, places=3)

    def test_a_data_package_describes_its_tables(self):
        for name, states in (("C", 1), ("latch", 2)):
            with self.subTest(name):
                out = self.folder / name / "datapackage.json"
                out.parent.mkdir()
                self.assertEqual(run("detent-graph", "convert", sample(name), out).returncode, 0)
                package = json.loads(out.read_text(encoding="utf-8"))
                self.assertRegex(package["name"], r"^[a-z0-9._-]+$")
                self.assertEqual(len(package["resources"]), states + 1)
                for resource in package["resources"]:
                    table = out.parent / resource["path"]
                    data = table.read_bytes()
                    self.assertEqual(resource["bytes"], len(data))
                    self.assertEqual(resource["hash"], "sha256:" + hashlib.sha256(data).hexdigest())
                    fields = resource["schema"]["fields"]
                    read = rows(table)
                    self.assertEqual(list(read[0]), [field["name"] for field in fields])
                    for field in fields:
                        if field["type"] == "number":
                            self.assertTrue(all(math.isfinite(float(row[field["name"]])) for row in read))
                self.assertFalse(set(p.name for p in out.parent.iterdir()) -
                                 {r["path"] for r in package["resources"]} - {"datapackage.json"})

    def test_names_of_states_and_earlier_tables_are_safe(self):
        """A comma in a state's name is no column; where a table cannot be written, the others stay what they were."""
        latch = json.loads(sample("latch").read_text(encoding="utf-8"))
        latch["states"][0]["name"] = 'up, "free"'
        named = self.folder / "named.button.json"
        named.write_text(json.dumps(latch))
        out = self.folder / "datapackage.json"
        self.assertEqual(run("detent-graph", "convert", named, out).returncode, 0)
        figures = rows(self.folder / "figures.csv")
        self.assertEqual({row["state"] for row in figures}, {'up, "free"', latch["states"][1]["name"]})
        self.assertTrue(all(math.isfinite(float(row["value"])) for row in figures))
        before = {p.name: p.read_bytes() for p in self.folder.iterdir() if p.name != "curve-2.csv"}
        (self.folder / "curve-2.csv").unlink()
        (self.folder / "curve-2.csv").mkdir()
        failed = run("detent-graph", "convert", sample("latch"), out)
        self.assertEqual(failed.returncode, 2, failed.stderr)
        self.assertEqual({p.name: p.read_bytes() for p in self.folder.iterdir() if p.is_file()}, before)

    def test_travel_over_force_lies_on_the_curve(self):
        out = self.folder / "steps.csv"
        for name in "ABCDEF":
            with self.subTest(name):
                run("detent-graph", "convert", sample(name), out, "--force-step", "0.05")
                strokes = strokes_of(name, self.folder)
                found = {"press": [], "release": []}
                for row in rows(out):
                    force = float(row["force_N"])
                    self.assertAlmostEqual(force / 0.05, round(force / 0.05), places=9)
                    self.assertLess(distance(strokes[row["stroke"]], float(row["displacement_mm"]), force), 2e-4)
                    found[row["stroke"]].append(force)
                for stroke, points in strokes.items():
                    self.assertEqual(len(found[stroke]), crossings(points, 0.05), stroke)

    def test_force_over_travel_lies_on_the_curve(self):
        out = self.folder / "steps.csv"
        for name in "ABCDEF":
            with self.subTest(name):
                self.assertEqual(run("detent-graph", "convert", sample(name), out, "--travel-step", "0.1").returncode, 0)
                strokes = strokes_of(name, self.folder)
                press = [row for row in rows(out) if row["stroke"] == "press"]
                start, end = strokes["press"][0][0], strokes["press"][-1][0]
                steps = range(math.ceil(round(10 * start, 6)), math.ceil(round(10 * end, 6)))
                even = [f"{step / 10:g}" for step in steps]
                places = list(dict.fromkeys(row["displacement_mm"] for row in press))  # a vertical piece has two rows
                self.assertEqual([place for place in places[:-1] if place in even], even)
                self.assertLessEqual(len(places), len(even) + 3)  # the end, and the beginnings of two bottom-outs
                for row, at in zip(press[-2:], strokes["press"][-2:] if strokes["press"][-2][0] == end else []):
                    self.assertEqual([float(row["displacement_mm"]), float(row["force_N"])], [round(v, 11) for v in at])
                self.assertAlmostEqual(float(press[-1]["displacement_mm"]), end, places=9)
                for row in rows(out):
                    at, force = float(row["displacement_mm"]), float(row["force_N"])
                    self.assertLess(distance(strokes[row["stroke"]], at, force), 2e-4)
        self.assertEqual(run("detent-graph", "convert", sample("C"), out, "--travels", "0.5,2").returncode, 0)
        self.assertEqual([(r["stroke"], r["displacement_mm"]) for r in rows(out)],
                         [("press", "0.5"), ("press", "2"), ("release", "2"), ("release", "0.5")])

    def test_travels_that_make_no_table_are_refused(self):
        out = self.folder / "steps.csv"
        for given in ("--travel-step=0", "--travel-step=-1", "--travel-step=1e-9", "--travel-step=nan", "--travels=1,99",
                      "--travels=nan", "--travels=x"):
            failed = run("detent-graph", "convert", sample("C"), out, given)
            self.assertEqual(failed.returncode, 2, given)
            self.assertIn(given.partition("=")[0], failed.stderr)
        both = run("detent-graph", "convert", sample("C"), out, "--travels=1", "--travel-step=1")
        picture = run("detent-graph", "convert", sample("C"), self.folder / "a.svg", "--travel-step=1")
        self.assertEqual((both.returncode, picture.returncode), (2, 2))
        self.assertFalse(out.exists())

    def test_steps_that_make_no_table_are_refused(self):
        out = self.folder / "steps.csv"
        for step in ("0", "-1", "1e-9", "nan"):
            self.assertEqual(run("detent-graph", "convert", sample("C"), out, f"--force-step={step}").returncode, 2)
        self.assertEqual(run("detent-graph", "convert", sample("C"), self.folder / "a.svg", "--force-step=1").returncode, 2)
        self.assertFalse(out.exists())


def strokes_of_button(path, folder):
    out = folder / "back.csv"
    run("detent-graph", "convert", path, out)
    strokes = {"press": [], "release": []}
    for row in rows(out):
        strokes[row["stroke"]].append((float(row["displacement_mm"]), float(row["force_N"])))
    return strokes


def distance(points, x, y):
    """From a place to a line through points, mm and N taken alike."""
    best = math.inf
    for (ax, ay), (bx, by) in zip(points, points[1:]):
        dx, dy = bx - ax, by - ay
        length = dx * dx + dy * dy
        share = 0 if length == 0 else min(1, max(0, ((x - ax) * dx + (y - ay) * dy) / length))
        best = min(best, math.hypot(x - ax - share * dx, y - ay - share * dy))
    return best


def crossings(points, step):
    """How often a line passes a multiple; its first point counts if it lies on one."""
    def level(force):
        near = round(force / step)
        return near if abs(near * step - force) < 1e-12 else math.floor(force / step) + 0.5

    count = 1 if level(points[0][1]) == int(level(points[0][1])) else 0
    for (_, before), (_, after) in zip(points, points[1:]):
        low, high = sorted((level(before), level(after)))
        inside = math.floor(high) - math.ceil(low) + 1
        count += inside - (1 if level(before) == int(level(before)) and before != after else 0)
    return count


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--bin", type=pathlib.Path, required=True)
    parser.add_argument("--samples", type=pathlib.Path, required=True)
    ARGUMENTS, rest = parser.parse_known_args()
    unittest.main(argv=[__file__, *rest])
