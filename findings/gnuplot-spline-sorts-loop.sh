#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Guess: gnuplot's "smooth csplines" lays a spline through the points of a file in their order, as "with lines" joins them: a force loop of
# press and release stays a loop, or the spline is refused because x goes back.
# Surprise: the points are sorted by x first, and those of one x become their mean. Press and release become one curve between them that no
# switch has: 1.25 N where the press has 2.0 and the release 0.5. No word.
# Package: gnuplot-nox 5.4.4+dfsg1-2+b2 (Debian 12; its libraries have to be installed)
set -eu
t=$(mktemp -d); trap 'rm -rf "$t"' EXIT; cd "$t"
apt-get download -qq gnuplot-nox=5.4.4+dfsg1-2+b2 2>/dev/null
dpkg -x gnuplot-nox_*.deb root
printf '0 0\n1 2.0\n2 3.0\n3 4.0\n4 9\n3 2.0\n2 1.0\n1 0.5\n0 0\n' > loop.dat  # mm, N: press, then release
program=$(find root/usr/bin -name 'gnuplot*' -type f | head -n 1)
"$program" -e "set table 'spline'; set samples 9; plot 'loop.dat' smooth csplines" > told 2>&1; code=$?
cat told; awk 'NF >= 2 && $1 ~ /^[0-9]/ { print $1 " mm: " $2 " N"; n++ } $1 == 1 { one = $2 } $1 == 3 { three = $2 }
  END { exit !(n == 9 && one == 1.25 && three == 3) }' spline
[ $code -eq 0 ] && [ ! -s told ]
