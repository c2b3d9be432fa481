#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Shows that check_documents.py fires on each kind of stale name and on diaries, and lets be what only looks like them."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))
import check_documents  # noqa: E402

CODE = """namespace detent {
struct StrokeCurve {};
double travel_mm(const StrokeCurve& curve);
app.add_option("--press-line", line);
"""
PLANTED = (
    ("The curve is a `PressCurve`.", "`PressCurve`"),
    ("Its length is `press_mm`.", "`press_mm`"),
    ("Call `fitCurve()` for it.", "`fitCurve`"),
    ("The type is `detent::StrokeGraph`.", "`StrokeGraph`"),
    ("It stands in `model/no_curve.h`.", "`model/no_curve.h`"),
    ("Build with `DETENT_WITH_MAGIC=ON`.", "`DETENT_WITH_MAGIC`"),
    ("Pass `--no-such-line X,Y`.", "`--no-such-line`"),
    ("It took 3 s on 2026-11-22.", "2026-11-22"),
    ("## Once more, on a quiet machine", "a diary"),
    ("# What happened later", "a diary"),
)
HARMLESS = (
    "A `StrokeCurve` of `travel_mm` in `model/curve.h`, or `curve.h`, read by `detent::StrokeCurve`.",
    "Pass `--press-line X,Y`; the rest is `k = a + b_1 x`, `plain words` and `grep -n`.",
    "```\nno_such_name in an example of 2026-11-22\n```",
    "`LibraryName` of somebody else's library.",
    "It is read again and again, later than before.",
)


class PlantedName(unittest.TestCase):
    def found_in(self, text, decision=False, listed=True):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            for room in ("model", "docs/develop/decisions"):
                (root / room).mkdir(parents=True)
            (root / "README.md").write_text("# Nothing\n")
            (root / "CONTRIBUTING.md").write_text("# Nothing\n")
            (root / "model" / "curve.h").write_text(CODE)
            (root / "docs/develop/decisions/README.md").write_text("[0001](0001-page.md)\n" if listed else "nothing\n")
            (root / "docs" / ("develop/decisions/0001-page.md" if decision else "page.md")).write_text("# Page\n\n" + text + "\n")
            return list(check_documents.findings(root, {"LibraryName"}))

    def test_each_kind_is_found_with_its_line(self):
        for text, said in PLANTED:
            found = self.found_in(text)
            self.assertEqual([(name, line) for name, line, _ in found], [("docs/page.md", 3)], text)
            self.assertIn(said, found[0][2], text)

    def test_a_decision_is_a_page(self):
        text = "A long sentence.\n" * 600
        self.assertEqual(self.found_in(text), [])
        self.assertEqual(len(self.found_in(text, decision=True)), 1)

    def test_the_index_lists_every_decision(self):
        self.assertEqual(self.found_in("Short.", decision=True), [])
        self.assertEqual(len(self.found_in("Short.", decision=True, listed=False)), 1)

    def test_harmless_lines_are_let_be(self):
        for text in HARMLESS:
            self.assertEqual(self.found_in(text), [], text)

    def test_the_foreign_names_are_needed(self):
        root = Path(__file__).resolve().parents[2]
        foreign = check_documents.foreign_names(Path(__file__).with_name("foreign_names.txt"))
        asked = " ".join(what for _, _, what in check_documents.findings(root, set()))
        # What a command of the README leaves behind may be there, and is asked for on a clean checkout only.
        self.assertEqual({name for name in foreign if f"`{name}`" not in asked and not (root / name).exists()}, set())


if __name__ == "__main__":
    unittest.main()
