#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Shows that check_types.py finds a name that stands for two types, and nothing else."""

import sys
import unittest

sys.dont_write_bytecode = True
from check_types import defined_twice  # noqa: E402

A = "namespace detent::importer {\n/// A reading.\nstruct Reading {\n  struct Part {};\n};\n}\n"


class TypesTest(unittest.TestCase):
    def test_two_headers_define_one_name(self):
        b = "namespace detent::importer {\nclass Reading final : public Base {\n};\n}\n"
        self.assertEqual(defined_twice({"a.h": A, "b.h": b}), {"detent::importer::Reading": ["a.h", "b.h"]})
        enum = "namespace detent { namespace importer {\nenum class Reading : int { none };\n} }\n"
        self.assertEqual(defined_twice({"a.h": A, "b.h": enum}), {"detent::importer::Reading": ["a.h", "b.h"]})

    def test_declarations_other_scopes_and_words_are_no_definitions(self):
        for text in ("namespace detent::importer {\nstruct Reading;\n}\n",
                     "namespace detent::playback {\nstruct Reading {};\n}\n",
                     "namespace detent::importer {\nclass Other { struct Reading {}; };\n}\n",
                     "namespace detent::importer {\ntemplate <class Reading>\nstruct Printed {};\n}\n",
                     "namespace detent::importer {\n// struct Reading {\nconst char* text = \"struct Reading {\";\n}\n",
                     "namespace detent::importer {\nnamespace {\nstruct Reading {};\n}\n}\n",
                     "namespace detent::importer {\nstruct Reading::Impl {};\n}\n",
                     "namespace detent::importer {\nstruct Reading read() { return {}; }\n}\n"):
            self.assertEqual(defined_twice({"a.h": A, "b.h": text}), {}, text)


if __name__ == "__main__":
    unittest.main()
