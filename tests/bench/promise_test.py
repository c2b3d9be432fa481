#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is counted, bounded and promised about confidences; the pages themselves are judged elsewhere."""

import tempfile
import unittest
from pathlib import Path

import promise


def row(confidence, wrong=False, may="import", source="honesty", tactile=()):
    return {"source": source, "class": "scan", "may": may, "confidence": confidence, "wrong": wrong, "tactile": list(tactile)}


class Counting(unittest.TestCase):
    def test_bounds_are_those_of_clopper_and_pearson(self):
        self.assertAlmostEqual(promise.upper_bound(0, 299), 0.00997, places=5)
        self.assertAlmostEqual(promise.upper_bound(1, 74), 0.0625, places=4)
        self.assertEqual(promise.upper_bound(3, 3), 1)

    def test_refused_pages_and_those_without_an_answer_are_not_counted(self):
        rows = [row(0.95), row(0.7), row(0.99, True), row(None, None), row(0.99, None, "either")]
        self.assertEqual(promise.accepted(rows, 0.9), (2, 1))
        self.assertEqual(promise.accepted(rows, 0.5), (3, 1))

    def test_what_was_accepted_wrongly_was_not_read(self):
        self.assertTrue(promise.cells([row(0.95), row(0.95, True), row(0.6), row(None, None)], 0.9)[-1] == "25 %")

    def test_a_class_with_too_few_pages_is_promised_nothing_small(self):
        self.assertIn("too few pages", promise.promise([row(0.95)] * 50))
        self.assertIn("it takes 598", promise.promise([row(0.95)] * 50))
        self.assertIn("That is the promise", promise.promise([row(0.95)] * 598))
        self.assertIn("nothing is promised", promise.promise([row(0.8)]))

    def test_the_document_keeps_what_stands_around_the_tables(self):
        import json
        with tempfile.TemporaryDirectory() as folder:
            promise.PAGE = Path(folder, "page.md")
            promise.PAGE.write_text("before\n<!-- counted -->\nold\n<!-- /counted -->\nafter\n")
            rows = Path(folder, "rows.jsonl")
            rows.write_text(json.dumps(row(0.95, tactile=[(0.001, 0.002, 0.003, 0.001)])) + "\n")
            promise.main(["write", "--calibration", str(rows), "--test", str(rows)])
            text = promise.PAGE.read_text()
        self.assertTrue(text.startswith("before\n") and text.endswith("after\n"))
        self.assertNotIn("old", text)
        self.assertIn("| scan | 2 | 100 | 100 | 0 | 0 |", text)


class Tactile(unittest.TestCase):
    def test_the_vertex_stands_between_the_points_a_truth_is_drawn_with(self):
        x, force = promise.vertex(*((x, 5 - (x - 0.3) ** 2) for x in (-1, 0.5, 1)))
        self.assertAlmostEqual(x, 0.3)
        self.assertAlmostEqual(force, 5)
        self.assertEqual(promise.vertex((0, 1), (1, 1), (2, 1)), (1, 1))


class Degrading(unittest.TestCase):
    def test_paper_from_a_scanner_is_even_and_from_a_camera_it_is_not(self):
        try:
            import numpy
            from PIL import Image
        except ImportError:
            self.skipTest("needs python3-numpy and python3-pil")
        import random
        with tempfile.TemporaryDirectory() as folder:
            sheet = Path(folder, "sheet.png")
            Image.new("RGB", (600, 400), "white").save(sheet)
            spread = {}
            for degrade in (promise.as_scan, promise.as_photo):
                result = Path(folder, degrade.__name__ + ".jpg")
                degrade(sheet, result, random.Random(1))
                picture = numpy.asarray(Image.open(result).convert("L"), float)
                middle = picture[picture.shape[0] // 4:-picture.shape[0] // 4, picture.shape[1] // 4:-picture.shape[1] // 4]
                spread[degrade.__name__] = numpy.ptp(middle[::40].mean(1)) + numpy.ptp(middle.mean(0)[::40])
        self.assertLess(spread["as_scan"], 15)
        self.assertGreater(spread["as_photo"], 20)


if __name__ == "__main__":
    unittest.main()
