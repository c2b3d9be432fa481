#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a package of Detent is made of: one version everywhere, man pages and completions from the programs' own --help, and
files of the desktop that name one another rightly.

    package_test.py --root FOLDER --bin FOLDER
"""

import argparse
import gzip
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml
from pathlib import Path

PROGRAMS = ("detent-import", "detent-graph", "detent-play", "detent-edit")
ROOT = BIN = None


def programs():
    return [name for name in PROGRAMS if (BIN / name).is_file()]


class Version(unittest.TestCase):
    def test_every_program_gives_the_version_of_the_project(self):
        project = re.search(r"project\(Detent VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1]
        for name in programs():
            run = subprocess.run([BIN / name, "--version"], capture_output=True, text=True)
            self.assertEqual((run.returncode, run.stdout, run.stderr), (0, f"{name} {project}\n", ""))
        released = xml.parse(ROOT / "editor/desktop/org.detent.edit.metainfo.xml").find("releases/release").get("version")
        self.assertEqual(released, project)
        self.assertTrue((ROOT / "docs/package/changelog.Debian").read_text().startswith(f"detent ({project}-"))
        self.assertIn(f"\n## {project}\n", (ROOT / "CHANGELOG.md").read_text())


class FromHelp(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.out = Path(cls.folder.name)
        subprocess.run([sys.executable, ROOT / "docs/package/from_help.py", "--bin", BIN, "--out", cls.out], check=True)

    def test_man_pages_name_every_option(self):
        for name in programs():
            page = gzip.decompress((self.out / "man1" / f"{name}.1.gz").read_bytes()).decode()
            offered = re.findall(r"(?m)^ +(?:-\w, ?)?(--[a-z][\w-]*)",
                                 subprocess.run([BIN / name, "--help"], capture_output=True, text=True).stdout)
            self.assertTrue(offered)
            for option in offered:
                self.assertIn(option.replace("-", "\\-"), page, name)
            self.assertNotIn(str(BIN), page, "a page of a package names no folder of the machine it was made on")

    def test_the_german_page_of_the_editor_has_its_options_and_letters(self):
        if not (BIN / "detent-edit").is_file():
            self.skipTest("detent-edit is not built")
        page = gzip.decompress((self.out / "de/man1/detent-edit.1.gz").read_bytes()).decode()
        for word in ("\\-\\-help", "\\-\\-version", "BEZEICHNUNG", "fühlen"):
            self.assertIn(word, page)

    def test_completions_are_bash_and_offer_options_and_subcommands(self):
        for name in programs():
            script = self.out / "completions" / name
            run = subprocess.run(["bash", "-c", f". {script}; COMP_WORDS=({name} --); COMP_CWORD=1; _{name.replace('-', '_')}; "
                                  'printf "%s\\n" "${COMPREPLY[@]}"'], capture_output=True, text=True)
            self.assertIn("--help", run.stdout.split(), name)
        run = subprocess.run(["bash", "-c", f". {self.out}/completions/detent-graph; COMP_WORDS=(detent-graph co); COMP_CWORD=1; "
                              '_detent_graph; printf "%s\\n" "${COMPREPLY[@]}"'], capture_output=True, text=True, cwd=self.out)
        self.assertEqual(sorted(run.stdout.split()), ["compare", "completions", "convert"])

    def test_a_folder_without_programs_is_refused(self):
        run = subprocess.run([sys.executable, ROOT / "docs/package/from_help.py", "--bin", self.out, "--out", self.out],
                             capture_output=True, text=True)
        self.assertEqual(run.returncode, 1)
        self.assertIn(str(self.out), run.stderr)


class Desktop(unittest.TestCase):
    def test_the_files_name_one_another(self):
        desktop = ROOT / "editor/desktop"
        entry = dict(line.split("=", 1) for line in (desktop / "detent-edit.desktop").read_text().splitlines() if "=" in line)
        kind = xml.parse(desktop / "detent-button.xml").find("{*}mime-type")
        self.assertIn(kind.get("type"), entry["MimeType"].split(";"))
        self.assertEqual(kind.find("{*}glob").get("pattern"), "*.button.json")
        self.assertTrue((desktop / f"{entry['Icon']}.svg").is_file())
        about = xml.parse(desktop / "org.detent.edit.metainfo.xml")
        self.assertEqual(about.find("launchable").text, "detent-edit.desktop")
        self.assertEqual(about.find("provides/mediatype").text, kind.get("type"))


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--root", type=Path, required=True)
    parser.add_argument("--bin", type=Path, required=True)
    arguments, rest = parser.parse_known_args()
    ROOT, BIN = arguments.root.resolve(), arguments.bin.resolve()
    unittest.main(argv=[sys.argv[0], *rest])
