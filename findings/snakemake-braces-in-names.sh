#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Guess: an input function returns file names as they are; Snakemake formats only the strings that stand in a rule.
# Surprise: names from an input function are searched for wildcards as well. One file called "log {3f25}.csv" among thousands stops the
# whole run with a WildcardError before any job starts, and doubling the braces, the usual escape, does not help.
# Package: snakemake 7.21.0-1 (Debian 12; its dependencies have to be installed)
set -eu
t=$(mktemp -d); trap 'rm -rf "$t"' EXIT; cd "$t"
apt-get download -qq snakemake=7.21.0-1 2>/dev/null
dpkg -x snakemake_*.deb root
export PATH="/usr/bin:/bin" PYTHONPATH="$t/root/usr/lib/python3/dist-packages" HOME="$t"
cat > Snakefile <<'RULE'
import glob
names = [name.replace("{", "{{").replace("}", "}}") if config.get("doubled") else name for name in glob.glob("pages/*")]
rule total:
    input: lambda wildcards: names
    output: "total"
    shell: "echo {input:q} > {output}"
RULE
mkdir pages; touch pages/plain.csv "pages/log {3f25}.csv"
run() { python3 root/usr/bin/snakemake --cores 1 total "$@" > said 2>&1 && echo "exit 0" || echo "exit $?: $(grep -o 'WildcardError\|MissingInputException' said | head -n 1)"; }
plain=$(run); doubled=$(run --config doubled=1)
echo "as it is: $plain"; echo "braces doubled: $doubled"; grep -m 2 -i "wildcard\|pages/log" said || true
[ "${plain%%:*}" = "exit 1" ] && [ "${doubled%%:*}" = "exit 1" ]
