#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Guess: a figure that matplotlib saves as SVG or PDF holds every point that was plotted; only a bitmap loses some. So measured samples can be
# taken back out of a published vector figure, one by one.
# Surprise: points that lie within a ninth of a pixel of the line between others are left out of vector files as well. Of 4,001 samples of a
# smooth force curve 63 are in the file: a distance between samples, a sampling rate or noise below 0.1 px cannot be read from it.
# Packages: python3-matplotlib 3.6.3-1+b1 with its libraries (Debian 12)
set -eu
t=$(mktemp -d); trap 'rm -rf "$t"' EXIT; cd "$t"
apt-get download -qq python3-matplotlib=3.6.3-1+b1 python-matplotlib-data=3.6.3-1 python3-numpy python3-cycler python3-dateutil python3-six \
  python3-kiwisolver python3-packaging python3-pyparsing python3-pil python3-contourpy python3-fonttools libblas3 liblapack3 libgfortran5 \
  libquadmath0 libjpeg62-turbo libopenjp2-7 libtiff6 libwebp7 libwebpdemux2 libwebpmux3 liblcms2-2 libimagequant0 libraqm0 libxcb1 \
  libfribidi0 libharfbuzz0b libgraphite2-3 libglib2.0-0 libjbig0 libdeflate0 liblerc4 libxau6 libxdmcp6 libbsd0 libqhull-r8.0 libfreetype6 \
  libpng16-16 libbrotli1 2>/dev/null
for deb in *.deb; do dpkg -x "$deb" root; done
cp -r root/usr/share/matplotlib/mpl-data root/usr/lib/python3/dist-packages/matplotlib
libraries=root/usr/lib/x86_64-linux-gnu
LD_LIBRARY_PATH="$libraries:$libraries/blas:$libraries/lapack" PYTHONPATH="$t/root/usr/lib/python3/dist-packages" \
  /usr/bin/python3 - <<'PY'
import re
import sys
import matplotlib
matplotlib.use("svg")
import matplotlib.pyplot
import numpy
travel_mm = numpy.linspace(0, 4, 4001)
figure, axes = matplotlib.pyplot.subplots()
axes.plot(travel_mm, 0.6 * numpy.sin(travel_mm) + 0.2)
figure.savefig("curve.svg")
with open("curve.svg", encoding="utf-8") as file:
    points = max(1 + path.count("L ") for path in re.findall(r' d="([^"]*)"', file.read()))
print(f"matplotlib {matplotlib.__version__}: {travel_mm.size} samples plotted, {points} in the SVG")
sys.exit(not points < 100)
PY
