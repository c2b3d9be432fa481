#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""check_words.py finds each kind of forbidden word, and in strings only names of tests."""

import sys
import unittest

sys.dont_write_bytecode = True
import check_words

GLOSSARY = """# Glossary

## Words to avoid

| use | instead of | found in |
|---|---|---|
| bottom-out | wall, walls | comments, identifiers |
| traversal | walk | comments, identifiers |
| legend key | legend's sample | comments |
| what the value is | its | whole identifiers |
| Returns true if | Whether | comment openings |
"""
CASES = (
    ("// The wall of a curve\n", ["wall"]),
    ("int wallOf(double firstWall_mm);\n", ["wall", "wall"]),
    ("int wallet;\n", []),
    ('const char* text = "the wall";\n', []),
    ('auto text = R"(the "wall")";\n', []),
    ('TEST_CASE("a wall is found", "[wall]") {}\nSECTION(\n    "no wall")\n', ["wall", "wall"]),
    ("// the Legend's sample\n", ["legend's sample"]),
    ("fz_walk_path(context); walkPath();\n", ["walk"]),
    ("double its = 0, itself = 1;\n", ["its"]),
    ("/// Whether it falls.\n", ["Whether …"]),
    ("/// Returns true if it falls.\n/// Whether that matters is open.\n", []),
    ("int a;  ///< Whether a counts\nint b;  ///< Whether b counts\n", ["Whether …", "Whether …"]),
)


class Words(unittest.TestCase):
    def test_cases(self):
        rules = check_words.Rules(GLOSSARY)
        for text, expected in CASES:
            self.assertEqual([word for _, word in check_words.findings(text, rules)], expected, text)

    def test_a_glossary_without_the_table_is_refused(self):
        with self.assertRaises(SystemExit):
            check_words.Rules("# Glossary\n")


if __name__ == "__main__":
    unittest.main()
