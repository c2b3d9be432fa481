#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Guess: a program that writes a formula into a sheet without calculating it leaves its result away, so that a reader finds an empty cell and
# sees that there is nothing.
# Surprise: XlsxWriter, with which many measuring programs write their logs, saves 0 as the result of each formula. A spreadsheet program
# calculates it when it opens the file; whatever reads saved results (openpyxl, pandas) has 0 N in every row, a number like any other.
# Packages: python3-xlsxwriter 3.0.2-2, python3-openpyxl 3.0.9-1, python3-et-xmlfile 1.0.1-2.1 (Debian 12)
set -eu
t=$(mktemp -d); trap 'rm -rf "$t"' EXIT; cd "$t"
apt-get download -qq python3-xlsxwriter=3.0.2-2 python3-openpyxl=3.0.9-1 python3-et-xmlfile=1.0.1-2.1 2>/dev/null
for deb in *.deb; do dpkg -x "$deb" root; done
PYTHONPATH="$t/root/usr/lib/python3/dist-packages" /usr/bin/python3 - <<'PY'
import sys
import openpyxl
import xlsxwriter
book = xlsxwriter.Workbook("log.xlsx")
sheet = book.add_worksheet()
sheet.write_row(0, 0, ["load (gf)", "force (N)"])
for row, load_gf in enumerate([30, 45, 60], start=1):
    sheet.write(row, 0, load_gf)
    sheet.write_formula(row, 1, f"=A{row + 1}*0.00980665")
book.close()
read = [cell.value for cell in openpyxl.load_workbook("log.xlsx", data_only=True).active["B"]]
print(read)
sys.exit(read != ["force (N)", 0, 0, 0])
PY
