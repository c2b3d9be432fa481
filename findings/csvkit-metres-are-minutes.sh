#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Guess: csvkit guesses the types of columns, so that numbers become numbers; a column whose cells carry a unit ("3 m") is text and stays as it is.
# Surprise: "3 m" and "1.5 h" are lengths of time to it. A cable's length in metres or a field strength H comes out of csvjson as minutes and
# hours ("0:03:00"), while "3 mm" and "40 gf" stay text: whether a unit survives depends on its letter.
# Packages: csvkit 1.0.7-1 with its libraries (Debian 12)
set -eu
t=$(mktemp -d); trap 'rm -rf "$t"' EXIT; cd "$t"
apt-get download -qq csvkit=1.0.7-1 python3-csvkit=1.0.7-1 python3-agate=1.6.3-2 python3-agateexcel python3-agatesql python3-agatedbf \
  python3-parsedatetime=2.6-3 python3-pytimeparse python3-babel python-babel-localedata python3-isodate python3-leather python3-slugify \
  python3-text-unidecode python3-unidecode python3-six python3-sqlalchemy python3-openpyxl python3-xlrd python3-dbfread python3-future \
  python3-icu python3-tz 2>/dev/null
for deb in *.deb; do dpkg -x "$deb" root; done
cat >log.csv <<'CSV'
cable,field,travel,force
3 m,1.5 h,3 mm,40 gf
4 m,2.5 h,4 mm,41 gf
CSV
read_back=$(PYTHONPATH="$t/root/usr/lib/python3/dist-packages" /usr/bin/python3 root/usr/bin/csvjson log.csv)
echo "$read_back"
[[ $read_back == '[{"cable": "0:03:00", "field": "1:30:00", "travel": "3 mm", "force": "40 gf"}, {"cable": "0:04:00", "field": "2:30:00", "travel": "4 mm", "force": "41 gf"}]' ]]
