#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Guess: sqlite3's .import of a CSV with numbers makes a table whose max() is the largest number: SQLite types are loose and values carry
# their own.
# Surprise: the table it makes has columns of type TEXT, so every value is a text and 9.5 is more than 10.2: max(), ORDER BY and < follow
# the alphabet. No word; sums and averages are right, because those convert.
# Package: sqlite3 3.40.1-2+deb12u2 (Debian 12)
set -eu
t=$(mktemp -d); trap 'rm -rf "$t"' EXIT; cd "$t"
apt-get download -qq sqlite3=3.40.1-2+deb12u2 2>/dev/null
dpkg -x sqlite3_*.deb root
printf 'displacement_mm,force_N\n9.5,1\n10.2,2\n' > curve.csv
told=$(root/usr/bin/sqlite3 :memory: '.mode csv' '.import curve.csv curve' \
  'select max(displacement_mm), max(displacement_mm + 0), sum(displacement_mm), count(*) from curve where displacement_mm < "9"')
all=$(root/usr/bin/sqlite3 :memory: '.mode csv' '.import curve.csv curve' 'select max(displacement_mm), max(displacement_mm + 0), sum(displacement_mm) from curve')
echo "largest as imported, largest number, sum: $all"; echo "rows below 9: $told"
[ "$all" = "9.5,10.2,19.7" ] && [ "${told##*,}" -eq 1 ]
