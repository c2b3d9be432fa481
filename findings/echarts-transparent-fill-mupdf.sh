#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Guess: a line chart that ECharts renders to SVG on a server holds no filled area, so MuPDF draws two thin lines.
# Surprise: ECharts gives every line fill="transparent". MuPDF does not know that colour and fills the area below the line with black: the
# curve is an edge of a black shape. A reader of plots that looks at pixels finds no line. SVG, valid CSS 3 colour, drawn right by browsers.
# Packages: echarts 5.5.1 (npm), mupdf-tools 1.21.1+ds2-1+deb12u1 (Debian 12)
set -eu
t=$(mktemp -d); trap 'rm -rf "$t"' EXIT; cd "$t"
apt-get download -qq mupdf-tools=1.21.1+ds2-1+deb12u1 2>/dev/null
dpkg -x mupdf-tools_*.deb root
npm install --silent --no-audit --no-fund --prefix "$t" echarts@5.5.1
node - <<'JS'
const echarts = require("echarts");
const chart = echarts.init(null, null, { renderer: "svg", ssr: true, width: 400, height: 300 });
const data = Array.from({ length: 41 }, (_, i) => [i / 10, 0.5 + 0.3 * Math.sin(i / 4)]);
chart.setOption({ animation: false, xAxis: {}, yAxis: {}, series: [{ type: "line", showSymbol: false, data }] });
require("fs").writeFileSync("chart.svg", chart.renderToSVGString());
process.exit(0);
JS
root/usr/bin/mutool draw -q -F pgm -o chart.pgm chart.svg 2>/dev/null
python3 - <<'PY'
head, pixels = open("chart.pgm", "rb").read().split(b"\n255\n", 1)
width, height = map(int, head.split()[-2:])
share = 100 * sum(grey < 16 for grey in pixels) / (width * height)
print("lines with fill=\"transparent\":", open("chart.svg").read().count('fill="transparent"'))
print(f"black: {share:.1f} % of the page; a line 2 units wide and its labels would be less than 2 %")
raise SystemExit(share < 5)
PY
