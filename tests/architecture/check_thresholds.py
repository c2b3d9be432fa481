#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A threshold says its unit: check_thresholds.py ROOT

Looks at every named number of the importer that is no count (`constexpr double`, `constexpr float`, and such members of options): its
name ends in a unit ("_px", "Share"), or a comment stands beside it or in the line above. Prints FILE:LINE of those that do neither.
"""

import re
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "bench"))
from ablate import CONSTANT, DECLARATOR, MEMBER, blanked, options_around  # noqa: E402

SAYS_UNIT = re.compile(r"(_(px|mm|pt|em|N|s|ms|deg|rad|share|per_\w+|N_per_mm)|Share|Dpi|Megabytes)$")


def numbers_in(text):
    """(place, name) of every named number that is no count."""
    plain = blanked(text)
    for m in CONSTANT.finditer(plain):
        if m["type"] in ("double", "float"):
            for d in DECLARATOR.finditer(m["rest"]):
                if float(d["value"].replace("'", "")) != 0:
                    yield m.start("rest") + d.start(), d["name"]
    for m in MEMBER.finditer(plain):
        if m["type"] in ("double", "float") and options_around(plain, m.start()) and float(m["value"].replace("'", "")) != 0:
            yield m.start(), m["name"]


def silent_thresholds(text):
    lines = text.split("\n")
    for place, name in numbers_in(text):
        line = text.count("\n", 0, place)
        last = text.count("\n", 0, text.index(";", place))
        above = line > 0 and lines[line - 1].lstrip().startswith("//")
        if not (SAYS_UNIT.search(name) or above or any("//" in said for said in lines[line : last + 1])):
            yield line + 1, name


def main():
    root = Path(sys.argv[1])
    found = [f"{path.relative_to(root)}:{line}: {name} has no unit, neither in its name nor in a comment beside it."
             for path in sorted((root / "importer").rglob("*")) if path.suffix in (".cpp", ".h")
             for line, name in silent_thresholds(path.read_text(encoding="utf-8"))]
    print("\n".join(found) if found else "Every threshold of the importer says its unit.")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
