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
        released = xml.parse(ROOT / "editor/desktop/org.detent.edit.metainfo.xml").find("releases/release")
        self.assertEqual(released.get("version"), project)
        self.assertTrue((ROOT / "docs/package/debian/changelog").read_text().startswith(f"detent ({project}-"))
        changelog = (ROOT / "CHANGELOG.md").read_text()
        self.assertIn(f"\n## {project} ({released.get('date')})\n", changelog)
        newest = changelog.split("\n## ")[1]
        self.assertTrue(newest.startswith(("Unreleased\n", f"{project} (")), "CHANGELOG.md begins with neither this version nor Unreleased")


class DebianSource(unittest.TestCase):
    # For people who build and run the tests of it: not needed for a package.
    NOT_BUILD_DEPENDS = {"fonts-liberation", "g++", "ccache", "jq", "tesseract-ocr-eng", "tesseract-ocr-deu", "tesseract-ocr-chi-sim", "qt6-translations-l10n"}

    def test_build_dependencies_are_those_of_the_installer(self):
        listed = subprocess.run([ROOT / "install-dependencies.sh", "build", "--list"], check=True, capture_output=True, text=True).stdout.split()
        field = re.search(r"(?m)^Build-Depends:\n((?: .*\n)+)", (ROOT / "docs/package/debian/control").read_text())[1]
        named = {entry.split()[0] for entry in field.replace(",", "\n").splitlines() if entry.strip()}
        self.assertEqual(named - {"debhelper-compat", "python3"}, set(listed) - self.NOT_BUILD_DEPENDS)


class Fonts(unittest.TestCase):
    def test_programs_carry_the_fonts_they_draw_with_and_no_others(self):
        """importer/page/mupdf_fonts.cpp has to be linked in place of MuPDF's own table, which names 40 MB of them."""
        for name in programs():
            fonts = set(re.findall(rb"_binary_resources_fonts_(\w+?)_", (BIN / name).read_bytes()))
            self.assertIn(fonts, (set(), {b"urw", b"noto", b"droid"}), name)


class FromHelp(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.out = Path(cls.folder.name)
        cls.said = subprocess.run([sys.executable, ROOT / "docs/package/from_help.py", "--bin", BIN, "--out", cls.out], check=True,
                                  capture_output=True, text=True).stderr

    def page(self, folder, name):
        return gzip.decompress((self.out / folder / f"{name}.1.gz").read_bytes()).decode()

    def test_man_pages_name_every_option_in_both_languages(self):
        for name in programs():
            offered = re.findall(r"(?m)^ +(?:-\w, ?)?(--[a-z][\w-]*)",
                                 subprocess.run([BIN / name, "--help"], capture_output=True, text=True).stdout)
            self.assertTrue(offered)
            for folder in ("man1", "de/man1"):
                page = self.page(folder, name)
                for option in offered:
                    self.assertIn(option.replace("-", "\\-"), page, f"{folder} {name}")
                self.assertNotIn(str(BIN), page, "a page of a package names no folder of the machine it was made on")

    def test_german_pages_are_german(self):
        for name in programs():
            page = self.page("de/man1", name)
            for word in ("BEZEICHNUNG", "Rückgabewerte: 0 fertig"):
                self.assertIn(word, page, name)
            for word in ("Exit codes", "Usage", "Print this help"):
                self.assertNotIn(word, page, name)

    def test_every_sentence_is_translated(self):
        self.assertEqual(self.said, "")

    def test_a_sentence_without_a_translation_is_named_and_stays_english(self):
        with tempfile.TemporaryDirectory() as folder:
            script = Path(folder) / "from_help.py"
            script.write_text((ROOT / "docs/package/from_help.py").read_text())
            (Path(folder) / "help.de.txt").write_text("Usage\nAufruf\n")
            run = subprocess.run([sys.executable, script, "--bin", BIN, "--out", folder], capture_output=True, text=True, check=True)
            self.assertIn("help.de.txt has no words for", run.stderr)
            for name in programs():
                self.assertIn("Aufruf", gzip.decompress((Path(folder) / "de/man1" / f"{name}.1.gz").read_bytes()).decode())

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
