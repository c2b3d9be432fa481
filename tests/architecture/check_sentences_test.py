#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Shows that check_sentences.py fires, on every way that was once taken, and lets be what only looks like it."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))
import check_sentences  # noqa: E402

PLANTED = (
    ('  return imported.failure->problem == "cancelled";', "compared with a literal"),
    ('  if ("plot frame" != step.evidence) return;', "compared with a literal"),
    ('  if (failure.place.rfind("point ", 0) == 0) return;', "searched for a literal"),
    ('  if (remedy.contains(QLatin1String("--frame"))) return;', "searched for a literal"),
    ('  if (report.failure().sentence().find("page 2") != npos) return;', "searched for a literal"),
    ('  const auto index = std::stoul(failure.place.substr(6));', "cut up"),
    ('  const auto index = std::stoul(failure.place.text);', "read back as a number"),
    ('  if (english(failure.problem) == "cancelled") return;', "in English, searched or compared"),
)
HARMLESS = (
    "  if (failure.code == FailureCode::cancelled) return;",
    '  // failure.problem == "cancelled" was how it was asked',
    '  text += failure.sentence() + "\\n";',
    '  if (argument == "--frame") return;',
    "  if (out.problem.empty()) return;",
)


class PlantedSentence(unittest.TestCase):
    def found_in(self, lines):
        with tempfile.TemporaryDirectory() as folder:
            source = Path(folder) / "editor" / "planted.cpp"
            source.parent.mkdir()
            source.write_text("\n".join(("// why", *lines)) + "\n")
            return list(check_sentences.findings(Path(folder)))

    def test_each_way_is_found_with_its_line(self):
        for line, rule in PLANTED:
            self.assertIn(("editor/planted.cpp", 2, rule), self.found_in([line]), line)

    def test_harmless_lines_are_let_be(self):
        self.assertEqual(self.found_in(HARMLESS), [])

    def test_the_project_has_none(self):
        self.assertEqual(list(check_sentences.findings(Path(__file__).resolve().parent.parent.parent)), [])


if __name__ == "__main__":
    unittest.main()
