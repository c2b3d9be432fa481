#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Guess: a unit library knows the pond, in which older data sheets of switches state forces, as the weight of a gram (1 p = 1 gf = 9.80665 mN),
# or does not know it and says so.
# Surprise: pint and quantities both take it for the weight of a kilogram. A key of 60 pond has 588 N in place of 0.588, and a kilopond
# is 9807 N, 1000 kgf. gf and kgf are right in both, so a table with mixed units goes wrong in some rows only. Reported to
# quantities (issue 44) in 2012 and open; corrected in pint's repository in 2025 (pull request 2218), not in Debian 12.
# Packages: python3-pint 0.19.2-1, python3-quantities 0.13.0-2 (Debian 12; their dependencies have to be installed)
set -eu
t=$(mktemp -d); trap 'rm -rf "$t"' EXIT; cd "$t"
apt-get download -qq python3-pint=0.19.2-1 python3-quantities=0.13.0-2 2>/dev/null
for deb in *.deb; do dpkg -x "$deb" root; done
PYTHONPATH="$t/root/usr/lib/python3/dist-packages" /usr/bin/python3 - <<'PY'
import sys
import pint
import quantities
registry = pint.UnitRegistry()
in_pint = {unit: registry.Quantity(60, unit).to("N").magnitude for unit in ("gf", "pond")}
in_pint["kilopond"] = registry.Quantity(0.06, "kilopond").to("N").magnitude
in_quantities = {unit: float(quantities.Quantity(60, unit).rescale("N")) for unit in ("gf", "pond")}
right = 60 * 0.00980665
print(f"60 gf, 60 pond and 0.06 kilopond are {right:.4f} N; in pint {pint.__version__}: {in_pint}; in quantities {quantities.__version__}: {in_quantities}")
factors = [value / right for value in [*in_pint.values(), *in_quantities.values()]]
sys.exit([round(factor, 6) for factor in factors] != [1, 1000, 1000, 1, 1000])
PY
