#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Guess: a chart that tells two curves apart by dashes alone still shows them apart after SVG -> MuPDF -> picture.
# Surprise: Vega writes stroke-dasharray, MuPDF leaves it out without a word: both curves and both legend keys are solid, and nothing in the
# picture says which is which. librsvg draws the dashes.
# Packages: vega 5.30.0 (npm), mupdf-tools 1.21.1+ds2-1+deb12u1, librsvg2-bin 2.54.7+dfsg-1~deb12u2 (Debian 12)
set -eu
t=$(mktemp -d); trap 'rm -rf "$t"' EXIT; cd "$t"
apt-get download -qq mupdf-tools=1.21.1+ds2-1+deb12u1 librsvg2-bin=2.54.7+dfsg-1~deb12u2 2>/dev/null
for deb in *.deb; do dpkg -x "$deb" root; done
npm install --silent --no-audit --no-fund --prefix "$t" vega@5.30.0
cat > chart.mjs <<'JS'
import * as vega from "vega";
import fs from "fs";
const spec = { width: 400, height: 100, data: [{ name: "t", values: [{ x: 0, y: 50 }, { x: 400, y: 50 }] }],
  marks: [{ type: "line", from: { data: "t" }, encode: { enter: {
    x: { field: "x" }, y: { field: "y" }, stroke: { value: "black" }, strokeWidth: { value: 4 }, strokeDash: { value: [10, 10] } } } }] };
fs.writeFileSync("chart.svg", await new vega.View(vega.parse(spec), { renderer: "none" }).toSVG());
JS
node chart.mjs
root/usr/bin/mutool draw -q -F pgm -o mupdf.pgm chart.svg 2>/dev/null
root/usr/bin/rsvg-convert --background-color=white -o librsvg.png chart.svg
root/usr/bin/mutool draw -q -F pgm -o librsvg.pgm librsvg.png 2>/dev/null
python3 - <<'PY'
def black(name):
    head, pixels = open(name, "rb").read().split(b"\n255\n", 1)
    width = int(head.split()[-2])
    return 100 * max(sum(grey < 64 for grey in pixels[i:i + width]) / width for i in range(0, len(pixels), width))
mupdf, librsvg = black("mupdf.pgm"), black("librsvg.pgm")
print(f"black along the line: MuPDF {mupdf:.0f} %, librsvg {librsvg:.0f} %; the dashes cover 50 %")
raise SystemExit(not (mupdf > 90 and 40 < librsvg < 60))
PY
