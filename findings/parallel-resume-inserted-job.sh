#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Guess: parallel --joblog LOG --resume-failed runs what the log does not show as done: new arguments, and those that failed.
# Surprise: jobs are known by their place in the list, not by their argument. An argument that sorts between old ones takes the number of a
# job that is done and is never run; an old one runs twice instead. Exit 0, nothing said.
# Package: parallel 20221122+ds-2 (Debian 12)
set -eu
t=$(mktemp -d); trap 'rm -rf "$t"' EXIT; cd "$t"
apt-get download -qq parallel=20221122+ds-2 2>/dev/null
dpkg -x parallel_*.deb root
export HOME="$t" PERL5LIB="$t/root/usr/share/perl5"; mkdir lists
run() { perl root/usr/bin/parallel --will-cite --joblog log --resume-failed 'echo {/} >> ran' ::: lists/*; }
touch lists/a lists/c; run
touch lists/b; run; code=$?
echo "exit $code; ran, in order: $(tr '\n' ' ' < ran); never: $(for l in a b c; do grep -qx $l ran || echo $l; done)"
[ $code -eq 0 ] && ! grep -qx b ran && [ "$(grep -cx c ran)" -eq 2 ]
