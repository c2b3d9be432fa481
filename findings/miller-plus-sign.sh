#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Guess: Miller computes with numbers as force testers write them: +0.50, and 007 is 7; what it cannot compute makes it fail.
# Surprise: a leading plus sign makes a text of a number, and so do leading zeros of whole numbers (not of 00.5). Adding to it gives the word
# (error) in that cell, with exit 0: a column of signed forces is half gone after one mlr in a pipe.
# Package: miller 6.6.0-2+b3 (Debian 12)
set -eu
t=$(mktemp -d); trap 'rm -rf "$t"' EXIT; cd "$t"
apt-get download -qq miller=6.6.0-2+b3 2>/dev/null
dpkg -x miller_*.deb root
printf 'force\n+0.50\n-0.50\n007\n00.5\n' > forces.csv
root/usr/bin/mlr --icsv --ocsv put '$more = $force + 1; $type = typeof($force)' forces.csv > told; code=$?
cat told; echo "exit $code"
[ $code -eq 0 ] && grep -q '^+0.50,(error),string$' told && grep -q '^007,(error),string$' told && grep -q '^00.5,1.5,float$' told
