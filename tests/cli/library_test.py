#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The library under what happens to files: library_test.py --detent-import BIN

Killed while it indexes, two at once, a disk that is full, a file that changes meanwhile, names in any script, archives and tables made to harm, a database that
is damaged or of another version. After each the database is whole, nothing is in it twice, and the next run completes it."""

import argparse
import json
import math
import os
import random
import resource
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time
import unittest
import zipfile
from pathlib import Path

BIN = None
FILES = 120  # about two transactions


def table(start_gf, bump_gf, step_mm=0.02):
    """A switch in the layout of force-curves-tidy: down, then up 6 gf below."""
    def force_gf(x):
        return min(start_gf, 300 * x) + 8 * x + bump_gf * math.exp(-(x - 1.2) ** 2 / 0.08) + max(0, 400 * (x - 3.6))
    down = [(i * step_mm, force_gf(i * step_mm)) for i in range(int(3.8 / step_mm) + 1)]
    rows = down + [(x, max(0, f - 6)) for x, f in reversed(down)]
    return "force,displacement,judge,name\n" + "".join(f"{f:.2f},{x:.4f},0,switch\n" for x, f in rows)


def library(*words, **options):
    return subprocess.run([BIN, "library", *map(str, words)], capture_output=True, timeout=200, check=False, **options)


class LibraryTest(unittest.TestCase):
    def setUp(self):
        self.top = Path(tempfile.mkdtemp(prefix="detent-library-"))
        self.addCleanup(shutil.rmtree, self.top)
        self.folder = self.top / "switches"
        self.folder.mkdir()
        self.database = self.top / "l.db"

    def measured(self, count=FILES):
        for i in range(count):
            (self.folder / f"s{i}.csv").write_text(table(30 + i % 50, i % 30))

    def index(self, **options):
        return library("index", self.folder, "--db", self.database, "--json", **options)

    def whole(self):
        """How many switches there are; fails where something is torn, twice, or of no file."""
        with sqlite3.connect(self.database) as rows:
            def one(question):
                return rows.execute(question).fetchone()[0]
            self.assertEqual(one("PRAGMA integrity_check"), "ok")
            if one("SELECT count(*) FROM sqlite_master") == 0:
                return 0  # killed in its first transaction, which SQLite took back on opening
            count = one("SELECT count(*) FROM switch")
            self.assertEqual(one("SELECT count(*) FROM (SELECT DISTINCT file, part FROM switch)"), count)
            self.assertEqual(one("SELECT count(*) FROM switch WHERE file NOT IN (SELECT id FROM file)"), 0)
            self.assertEqual(one("SELECT count(*) FROM curve"), count)
            self.assertEqual(one("SELECT count(*) FROM rating WHERE file NOT IN (SELECT id FROM file)"), 0)
            self.assertEqual(one("SELECT count(*) FROM switch WHERE id NOT IN (SELECT switch FROM curve)"), 0)
        return count

    def completed(self, count=FILES):
        run = self.index()
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(self.whole(), count)

    def test_killed_while_indexing(self):
        self.measured()
        seed = random.Random(7)
        for _ in range(6):
            self.database.unlink(missing_ok=True)
            with subprocess.Popen([BIN, "library", "index", self.folder, "--db", self.database], stdout=subprocess.DEVNULL,
                                  stderr=subprocess.DEVNULL) as run:
                time.sleep(seed.uniform(0.01, 0.4))
                run.kill()
            if self.database.exists() and self.database.stat().st_size:
                self.assertIn(self.whole(), (0, 64, FILES))
            self.completed()

    def test_two_at_once(self):
        self.measured()
        runs = [subprocess.Popen([BIN, "library", "index", self.folder, "--db", self.database], stdout=subprocess.DEVNULL,
                                 stderr=subprocess.PIPE) for _ in range(2)]
        for run in runs:
            self.assertEqual((run.communicate()[1], run.returncode), (b"", 0))
        self.assertEqual(self.whole(), FILES)

    def test_full_disk(self):
        """A limit on the size of files stands for the disk."""
        self.measured()

        def limited():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (450_000, 450_000))
        run = self.index(preexec_fn=limited)
        self.assertEqual(run.returncode, 1)
        self.assertIn(b"the disk is full or failed", run.stderr)
        self.assertLess(self.whole(), FILES)
        self.completed()

    def test_a_file_that_changes_meanwhile(self):
        self.measured(40)
        changing = self.folder / "changing.csv"
        end = time.monotonic() + 1.0
        with subprocess.Popen([sys.executable, "-c", "import sys, time\nfor i in range(400):\n"
                               " open(sys.argv[1], 'w').write(sys.argv[2][:200 * i] if i % 2 else sys.argv[2])\n time.sleep(0.002)",
                               str(changing), table(40, 10)]) as writer:
            while time.monotonic() < end:
                self.assertIn(self.index().returncode, (0, 3))
                self.assertIn(self.whole(), (40, 41))
            writer.wait()
        changing.write_text(table(44, 12))
        self.completed(41)
        found = json.loads(library("find", "--db", self.database, "--limit", 99, "--json").stdout)["found"]
        self.assertEqual([each["name"] for each in found].count("changing"), 1)

    def test_names_in_any_script(self):
        names = ["茶轴", "Ключ", "مفتاح", "a b\tc", "quote\"'", "e\u0301", "😀", "-x", "x;DROP TABLE switch;", "new\nline"]
        for name in names:
            (self.folder / f"{name}.csv").write_text(table(40, 10))
        Path(os.fsdecode(os.fsencode(self.folder) + b"/\xff\xfe.csv")).write_text(table(40, 10))
        self.completed(len(names) + 1)
        found = json.loads(library("find", "--db", self.database, "--limit", 99, "--json").stdout)["found"]
        self.assertEqual(len(found), len(names) + 1)
        self.assertIn("茶轴", [each["name"] for each in found])

    def test_files_made_to_harm(self):
        (self.folder / "good.csv").write_text(table(40, 10))
        with zipfile.ZipFile(self.folder / "bomb.ods", "w", zipfile.ZIP_DEFLATED) as bomb:
            bomb.writestr("content.xml", b"<table:table " + b" " * (200 << 20))
        seed = random.Random(3)
        archive = (self.folder / "bomb.ods").read_bytes()[:4000] + (self.folder / "bomb.ods").read_bytes()[-200:]
        text = table(40, 10).encode()
        for i in range(30):
            for ending, source in (("ods", archive), ("csv", text)):
                harmed = bytearray(source)
                for _ in range(60):
                    harmed[seed.randrange(len(harmed))] = seed.randrange(256)
                (self.folder / f"m{i}.{ending}").write_bytes(harmed)
        (self.folder / "inf.csv").write_text("force,displacement\n" + "1e308,1\ninf,2\nnan,3\n" * 500)
        (self.folder / "zero.csv").write_bytes(b"\0" * 1_000_000)
        (self.folder / "long.csv").write_text("1," * 3_000_000)
        (self.folder / "deep.json").write_text("[" * 2_000_000)
        os.mkfifo(self.folder / "pipe.csv")
        (self.folder / "endless.csv").symlink_to("/dev/zero")
        (self.folder / "loop").symlink_to(self.folder)
        # What it holds at most is asked afterwards: a limit of addresses would refuse the shadow memory of a sanitizer's build.
        run = self.index()
        self.assertEqual(run.returncode, 0, run.stderr[-400:])
        self.assertLess(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss, 2 << 20, "kB of memory")
        told = json.loads(run.stdout)
        self.assertTrue(all(each["reason"] for each in told["refusals"]))
        refused = {Path(each["file"]).name for each in told["refusals"]}
        self.assertLessEqual({"bomb.ods", "zero.csv", "long.csv", "deep.json", "inf.csv"}, refused)
        self.assertNotIn("good.csv", refused)
        self.whole()

    def test_pages_where_they_are_asked_for(self):
        plots = Path(__file__).resolve().parents[2] / "samples/plots"
        shutil.copy(plots / "white-vector.pdf", self.folder)
        shutil.copy(plots / "brown-one-ink.png", self.folder)
        (self.folder / "broken.png").write_text("no picture")
        (self.folder / "LICENSE").write_text("MIT License")
        (self.folder / "meter.csv").write_text(table(40, 10))

        def counts(*words):
            told = json.loads(library("index", self.folder, "--db", self.database, "--json", *words).stdout)
            return [told[key] for key in ("imported", "refused", "unchanged", "gone")]
        for path in self.folder.iterdir():
            os.utime(path, (time.time() - 3600, time.time() - 3600))
        self.assertEqual(counts(), [1, 0, 0, 0])
        self.assertEqual(counts("--pages"), [2, 1, 1, 0])
        self.assertEqual(counts("--pages"), [0, 1, 3, 0])
        self.assertEqual(counts(), [0, 0, 1, 0])  # passed over, not gone
        found = json.loads(library("find", "--db", self.database, "--json").stdout)["found"]
        self.assertEqual({each["name"] for each in found}, {"white vector", "brown one ink", "meter"})
        self.assertEqual({each["licence"] for each in found}, {"MIT"})
        for each in found:
            if each["name"] != "meter":  # of a page an import knows how far the peak may be off
                for figure in ("peak_force_N", "peak_travel_mm"):
                    self.assertEqual(each[figure] is None, each["sigma_" + figure] is None, (each["name"], figure))
                    self.assertTrue(each[figure] is None or 0 < each["sigma_" + figure] < 0.03 * each[figure], (each["name"], figure))
                self.assertIsNone(each["sigma_total_travel_mm"])
        self.assertTrue(any(each["peak_force_N"] for each in found if each["name"] != "meter"))
        wanted = self.top / "wanted.button.json"
        run = library("find", "--db", self.database, "--like", plots.parent / "buttons/B.button.json", "--peak", "0.6..0.7", "--drop", "0.1..0.2", "-o", wanted)
        self.assertEqual(run.returncode, 0, run.stderr)  # the page is read again
        self.assertTrue(wanted.exists())
        (self.folder / "white-vector.pdf").unlink()
        self.assertEqual(counts()[3], 1)
        self.whole()

    def test_damaged_and_of_another_version(self):
        self.measured(5)
        self.completed(5)
        with sqlite3.connect(self.database) as rows:
            rows.execute("PRAGMA user_version = 77")
        self.assertEqual(library("find", "--db", self.database).returncode, 3)
        self.assertIn("rebuilt", json.loads(self.index().stdout))
        self.completed(5)
        harmed = bytearray(self.database.read_bytes())
        harmed[3000:9000] = bytes(6000)
        self.database.write_bytes(harmed)
        self.assertIn("rebuilt", json.loads(self.index().stdout))
        self.completed(5)
        self.assertTrue((self.top / "l.db.damaged").exists())


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--detent-import", required=True)
    BIN, rest = (lambda known: (known[0].detent_import, known[1]))(parser.parse_known_args())
    unittest.main(argv=[sys.argv[0], *rest])
