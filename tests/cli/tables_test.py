#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables between the programs, R and pandas, as docs/reference/csv.md says: tables_test.py --root FOLDER --bin FOLDER

Without Rscript the half of R is SKIPPED."""

import argparse
import csv
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import pandas

ROOT = BIN = None
LABELS = ("T", "F", "NA", "B")  # buttons: three of them R takes for something else
TEXTS = ("participant", "pair", "a", "b", "x", "answer")


def block(language):
    page = (ROOT / "docs/reference/csv.md").read_text()
    return re.search(rf"^```{language}\n(.*?)^```$", page, re.S | re.M)[1]


class Tables(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def run_in(self, *command):
        environment = {**os.environ, "PATH": f"{BIN}:{os.environ['PATH']}", "LC_ALL": "C.UTF-8"}
        ran = subprocess.run(command, cwd=self.folder, env=environment, capture_output=True, text=True, stdin=subprocess.DEVNULL, check=False)
        self.assertEqual(ran.returncode, 0, ran.stdout + ran.stderr)
        return ran.stdout

    def curve(self):
        self.run_in("detent-graph", "convert", ROOT / "samples/buttons/F.button.json", "curve.csv")
        return self.rows("curve.csv")

    def rows(self, name):
        with open(self.folder / name, newline="") as table:
            return list(csv.DictReader(table))

    def trials(self):
        for label in LABELS:
            source = ROOT / f"samples/buttons/{label if label in 'BF' else 'C'}.button.json"
            shutil.copy(source, self.folder / f"{label}.button.json")
        self.run_in("detent-play", "study", "new", "s", *(f"{label}.button.json" for label in LABELS), "--trials", "2", "--seed", "3")
        self.run_in("detent-play", "study", "run", "s", "--participant", "007", "--simulate", "errors=0.2")
        self.run_in("detent-play", "study", "report", "s", "--csv", "trials.csv")
        return self.rows("trials.csv")

    def assert_texts(self, told, read):
        self.assertEqual({row["a"] for row in told} | {row["b"] for row in told}, set(LABELS))
        for name in TEXTS:
            self.assertEqual([row[name] for row in told], [row[name] for row in read], name)

    def test_pandas_reads_labels_and_numbers_as_they_are(self):
        told = self.trials()
        names = {}
        before = os.getcwd()
        os.chdir(self.folder)
        try:
            exec(block("python"), names)  # the page's own lines
        finally:
            os.chdir(before)
        self.assert_texts(told, names["trials"].astype(str).to_dict("records"))
        for row, value in zip(told, names["trials"]["answer_s"]):
            self.assertEqual(float(row["answer_s"]), value)

    def test_what_pandas_writes_is_read_to_the_last_bit(self):
        told = self.curve()
        table = pandas.read_csv(self.folder / "curve.csv", float_precision="round_trip")
        self.assertEqual([float(row["force_N"]) for row in told], list(table["force_N"]))
        for options in {}, {"index": False}, {"quoting": csv.QUOTE_ALL, "index": False}, {"quoting": csv.QUOTE_NONNUMERIC}:
            table.to_csv(self.folder / "back.csv", **options)
            self.run_in("detent-graph", "convert", "back.csv", "again.csv")
            self.run_in("detent-graph", "convert", "curve.csv", "same.csv")
            self.assertEqual((self.folder / "again.csv").read_text(), (self.folder / "same.csv").read_text())

    def test_what_jspsych_writes_is_read(self):
        rows = [f'"P1","0.8","","{0.1 + 0.001 * i}"' for i in range(19)] + ['"P1","0.8","","null"', '"P1","0.8","",""']
        (self.folder / "presses.csv").write_text("\r\n".join(['"participant","interval_s","window_s","press_s"', *rows]) + "\r\n")
        self.run_in("detent-play", "study", "presses", "presses.csv", "--task", "cue")

    @unittest.skipIf(not shutil.which("Rscript"), "no R")
    def test_r_reads_labels_as_they_are_and_what_it_writes_is_read(self):
        told = self.trials()
        self.curve()
        texts = "c(" + ", ".join(f'"{name}"' for name in TEXTS) + ")"
        self.run_in("Rscript", "-e", block("r") + f"""
write.csv(trials[, {texts}], "texts.csv", row.names = FALSE)
stopifnot(is.numeric(trials$answer_s), is.numeric(trials$correct))
curve <- read.csv("curve.csv")
write.csv(curve, "back.csv")
write.csv(data.frame(participant = "P1", interval_s = 0.8, window_s = "", press_s = c(0.1 + 0.001 * (1:19), NA)), "presses.csv")
write.csv(data.frame(time_s = 0:9 / 10, force_N = 0:9 / 10), "press.csv", row.names = FALSE)
""")
        self.assert_texts(told, self.rows("texts.csv"))
        self.run_in("detent-graph", "show", "back.csv")
        self.run_in("detent-play", "study", "presses", "presses.csv", "--task", "cue")
        self.run_in("detent-play", "render", ROOT / "samples/buttons/B.button.json", "--press", "press.csv", "-o", "press.wav")


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--root", type=Path, required=True)
    parser.add_argument("--bin", type=Path, required=True)
    chosen, rest = parser.parse_known_args()
    ROOT, BIN = chosen.root.resolve(), chosen.bin.resolve()
    if not shutil.which("Rscript"):
        print("SKIPPED R's half: Rscript is not installed")
    unittest.main(argv=[sys.argv[0], *rest])
