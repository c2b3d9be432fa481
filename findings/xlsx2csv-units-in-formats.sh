#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Guess: xlsx2csv gives a cell's number, or at worst its number rounded as the cell shows it.
# Surprise: where the cell's number format carries its unit, as force testers write it (0.000 "mm"), the number is gone: m is taken for a
# month, the cell for a date, and every row says 0.000 "12". With "N" or "s" the format itself stands in every row. Exit 0.
# Package: xlsx2csv 1:0.7.8-1 (Debian 12)
set -eu
t=$(mktemp -d); trap 'rm -rf "$t"' EXIT; cd "$t"
apt-get download -qq xlsx2csv=1:0.7.8-1 2>/dev/null
dpkg -x xlsx2csv_*.deb root
python3 - <<'PY'
import zipfile
main, office = "http://schemas.openxmlformats.org/spreadsheetml/2006/main", "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
package = "http://schemas.openxmlformats.org/package/2006"
kind, formats = "application/vnd.openxmlformats-officedocument.spreadsheetml.", ["0.000", '0.000 "mm"', '0.00 "s"']
relation = lambda target, what: f'<Relationships xmlns="{package}/relationships"><Relationship Id="r1" Type="{office}/{what}" Target="{target}"/></Relationships>'
parts = {"[Content_Types].xml": f'<Types xmlns="{package}/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
         + "".join(f'<Override PartName="/xl/{n}.xml" ContentType="{kind}{k}+xml"/>' for n, k in [("workbook", "sheet.main"), ("styles", "styles"), ("worksheets/sheet1", "worksheet")]) + "</Types>",
         "_rels/.rels": relation("xl/workbook.xml", "officeDocument"), "xl/_rels/workbook.xml.rels": relation("worksheets/sheet1.xml", "worksheet"),
         "xl/workbook.xml": f'<workbook xmlns="{main}" xmlns:r="{office}"><sheets><sheet name="S" sheetId="1" r:id="r1"/></sheets></workbook>',
         "xl/styles.xml": f'<styleSheet xmlns="{main}"><numFmts>' + "".join(f'<numFmt numFmtId="{170 + i}" formatCode="{f.replace(chr(34), "&quot;")}"/>' for i, f in enumerate(formats))
         + "</numFmts><cellXfs>" + "".join(f'<xf numFmtId="{170 + i}"/>' for i in range(3)) + "</cellXfs></styleSheet>",
         "xl/worksheets/sheet1.xml": f'<worksheet xmlns="{main}"><sheetData>' + "".join(f'<row r="{r}">' + "".join(
             f'<c r="{"ABC"[c]}{r}" s="{c}"><v>{1 + 0.2345 * r}</v></c>' for c in range(3)) + "</row>" for r in (1, 2)) + "</sheetData></worksheet>"}
with zipfile.ZipFile("log.xlsx", "w") as book:
    for name, text in parts.items():
        book.writestr(name, text)
PY
PYTHONPATH="$t/root/usr/lib/python3/dist-packages" /usr/bin/python3 root/usr/bin/xlsx2csv log.xlsx | tee told
[ "$(cut -d, -f1 told | head -n 1)" != "$(cut -d, -f1 told | tail -n 1)" ] && [ "$(cut -d, -f2- told | sort -u | wc -l)" -eq 1 ]
