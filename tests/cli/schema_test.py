#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Holds what the programs print with --json against docs/reference/schema, unknown fields refused: schema_test.py --root FOLDER --bin FOLDER

schema_cases.json names for each schema command lines whose outputs it describes. {out} is a folder of the schema's own, the project's samples are at
samples/; the commands of a schema run in order. "| NAME" as the last word: the output is held against that schema instead. "write-record" writes a recorded
press. A schema without commands is one whose output needs a device: it is only checked for being a schema.
"""

import argparse
import copy
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import jsonschema

ROOT = BIN = None


def closed(schema):
    """The schema with every object refusing fields it does not list. docs/reference/compatibility.md: others must not refuse them."""
    schema = copy.deepcopy(schema)

    def close(part):
        if isinstance(part, dict):
            if "properties" in part:
                part.setdefault("additionalProperties", False)
            for value in part.values():
                close(value)
        elif isinstance(part, list):
            for value in part:
                close(value)

    close(schema)
    return schema


def complaints(schema, value, others=()):
    # RefResolver is old, and all that Debian 12 has.
    resolver = jsonschema.RefResolver("", {}, store={other["$id"]: closed(other) for other in others})
    return [f"{'/'.join(map(str, error.absolute_path)) or '(whole)'}: {error.message}"
            for error in jsonschema.Draft202012Validator(closed(schema), resolver=resolver).iter_errors(value)]


def write_record(path, damping_Ns_per_mm):
    """A press of 4 mm in 0.1 s as a force meter records it: 0.3 N/mm and this damping; without damping at constant speed."""
    rows = ["time_s,displacement_mm,force_N"]
    for i in range(101):
        t = i / 1000
        u = t / 0.1
        x = 4 * (10 * u**3 - 15 * u**4 + 6 * u**5) if damping_Ns_per_mm else 4 * u
        v = 40 * (30 * u**2 - 60 * u**3 + 30 * u**4) if damping_Ns_per_mm else 40
        rows.append(f"{t:.4f},{x:.6f},{0.2 + 0.3 * x + damping_Ns_per_mm * v + 0.005 * ((i * 37) % 11 - 5) / 5:.6f}")
    Path(path).write_text("\n".join(rows) + "\n")


class Schemas(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        cls.schemas = {path.name.removesuffix(".schema.json"): json.loads(path.read_text())
                       for path in sorted((ROOT / "docs/reference/schema").glob("*.schema.json"))}

    def test_all_are_schemas_and_listed(self):
        listed = (ROOT / "docs/reference/schema/README.md").read_text()
        self.assertGreater(len(self.schemas), 15)
        for name, schema in self.schemas.items():
            jsonschema.Draft202012Validator.check_schema(schema)
            self.assertIn(f"({name}.schema.json)", listed)

    def test_programs_print_what_the_schemas_say(self):
        cases = json.loads(Path(__file__).with_name("schema_cases.json").read_text())
        self.assertLessEqual(set(cases), set(self.schemas))
        environment = dict(os.environ, PATH=f"{BIN}:{os.environ['PATH']}", LC_ALL="C.UTF-8")
        for name, schema in self.schemas.items():
            with tempfile.TemporaryDirectory() as out:
                for words in cases.get(name, []):
                    wanted = schema
                    if words[-1].startswith("| "):
                        wanted = self.schemas[words[-1][2:]]
                        words = words[:-1]
                    words = [word.replace("{out}", out) for word in words]
                    if words[0] == "write-record":
                        write_record(words[1], float(words[2]))
                        continue
                    if not (BIN / words[0]).is_file() and words[0] != "cat":
                        continue
                    run = subprocess.run(words, cwd=ROOT, env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=200)
                    with self.subTest(schema=name, command=" ".join(words)):
                        lines = run.stdout.splitlines()
                        self.assertTrue(lines, f"nothing on stdout; {run.stderr}")
                        self.assertEqual([], [said for line in lines for said in complaints(wanted, json.loads(line), self.schemas.values())][:5])

    def test_progress_comes_as_lines_before_the_result(self):
        plots = [str(ROOT / "samples/plots" / name) for name in ("force-meter-log.csv", "two-level-legend.png")]
        with tempfile.TemporaryDirectory() as out:
            for words, last in (([plots[1], "--quality", "draft"], "import-report"), (["no-such-file.png"], "import-failure"),
                                (["--batch", *plots, "README.md", "--out-dir", out], "import-batch")):
                run = subprocess.run([BIN / "detent-import", *words, "--json-lines"], cwd=ROOT, capture_output=True, text=True, timeout=200)
                *lines, result = map(json.loads, run.stdout.splitlines())
                for line in lines:
                    self.assertEqual([], complaints(self.schemas["import-progress"], line))
                self.assertEqual([], complaints(self.schemas[last], result, self.schemas.values()))
                shares = [line["progress"] for line in lines]
                self.assertEqual(shares, sorted(shares))
                if last == "import-report":
                    self.assertIn("trace", [line["step"] for line in lines])
                if last == "import-batch":
                    self.assertEqual([(line["input"], line["exit_code"], line["done"]) for line in lines],
                                     [(plots[0], 0, 1), (plots[1], 0, 2), ("README.md", 4, 3)])

    def test_an_unknown_a_missing_and_a_wrong_field_are_refused(self):
        schema = self.schemas["graph-check"]
        good = {"status": "ok", "command": "check", "file": "a.button.json", "states": 1, "warnings": []}
        self.assertEqual(complaints(schema, good), [])
        self.assertTrue(complaints(schema, {**good, "knots": 3}))
        self.assertTrue(complaints(schema, {key: value for key, value in good.items() if key != "states"}))
        self.assertTrue(complaints(schema, {**good, "states": "one"}))


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--root", type=Path, required=True)
    parser.add_argument("--bin", type=Path, required=True)
    arguments, rest = parser.parse_known_args()
    ROOT, BIN = arguments.root.resolve(), arguments.bin.resolve()
    unittest.main(argv=[sys.argv[0], *rest], warnings="ignore")
