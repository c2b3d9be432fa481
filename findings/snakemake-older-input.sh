#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Guess: Snakemake 7 watches code, parameters, inputs and software, so an input file with other bytes leads to a new result.
# Surprise: of an input's content only its date counts, and only a date newer than the result. A file replaced by an older one (cp -p, tar,
# rsync -a, unzip: all keep the source's date) is never read: "Nothing to be done", exit 0, the old result stays.
# Package: snakemake 7.21.0-1 (Debian 12; its dependencies have to be installed)
set -eu
t=$(mktemp -d); trap 'rm -rf "$t"' EXIT; cd "$t"
apt-get download -qq snakemake=7.21.0-1 2>/dev/null
dpkg -x snakemake_*.deb root
export PATH="/usr/bin:/bin" PYTHONPATH="$t/root/usr/lib/python3/dist-packages" HOME="$t"
cat > Snakefile <<'RULE'
rule total:
    input: "log.csv"
    output: "total"
    shell: "wc -l < {input} > {output}"
RULE
run() { python3 root/usr/bin/snakemake --cores 1 total 2>&1 | grep -o 'Nothing to be done\|1 of 1 steps' || true; }
printf '1\n2\n3\n' > log.csv; run; cat total
printf '1\n2\n3\n4\n5\n' > other.csv; touch -d 2020-01-01 other.csv; cp -p other.csv log.csv
said=$(run); echo "$said; the log has $(wc -l < log.csv) lines, the result says $(cat total)"
[ "$said" = "Nothing to be done" ] && [ "$(cat total)" -eq 3 ]
