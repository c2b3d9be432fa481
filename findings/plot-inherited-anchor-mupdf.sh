#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Guess: text-anchor is inherited in SVG, so tick labels in a group with text-anchor="end" end beside their ticks in every renderer.
# Surprise: Observable Plot says text-anchor once, on the group. MuPDF takes it from the text element alone, so the labels of the y axis
# begin where they should end: they cover their own ticks and reach into the plot. librsvg and browsers place them right.
# Packages: @observablehq/plot 0.6.16, jsdom 24.1.3 (npm), mupdf-tools 1.21.1+ds2-1+deb12u1 (Debian 12)
set -eu
t=$(mktemp -d); trap 'rm -rf "$t"' EXIT; cd "$t"
apt-get download -qq mupdf-tools=1.21.1+ds2-1+deb12u1 2>/dev/null
dpkg -x mupdf-tools_*.deb root
npm install --silent --no-audit --no-fund --prefix "$t" @observablehq/plot@0.6.16 jsdom@24.1.3
cat > chart.mjs <<'JS'
import * as Plot from "@observablehq/plot";
import { JSDOM } from "jsdom";
import fs from "fs";
const data = Array.from({ length: 41 }, (_, i) => ({ x: i / 10, y: 100 + i }));
const chart = Plot.plot({ document: new JSDOM("").window.document, marks: [Plot.line(data, { x: "x", y: "y" })] });
chart.setAttribute("xmlns", "http://www.w3.org/2000/svg");
fs.writeFileSync("chart.svg", chart.outerHTML);
JS
node chart.mjs
root/usr/bin/mutool draw -q -F stext -o chart.xml chart.svg 2>/dev/null
python3 - <<'PY'
import re
group = re.search(r'aria-label="y-axis tick label" text-anchor="end"[^>]*translate\((-?\d+)', open("chart.svg").read())
axis, gap = 40, -int(group[1])  # Plot's left margin; how far from it labels are to end
labels = [(float(a), float(b)) for a, b in re.findall(r'<line bbox="([-\d.]+) [-\d.]+ ([-\d.]+)', open("chart.xml").read()) if float(a) < axis < float(b)]
print(f"labels of the y axis are to end at {axis - gap}, 9 left of the axis at {axis}; they reach over it, from and to: {labels[:3]}")
raise SystemExit(not (len(labels) >= 3 and all(abs(a - (axis - gap)) < 1 for a, _ in labels)))
PY
