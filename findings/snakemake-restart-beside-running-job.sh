#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Guess: Snakemake keeps its jobs' numbers on the cluster ("Resuming incomplete job 1 with external jobid ..."); killed and started again,
# with a status command, it waits for a job that still runs.
# Surprise: only for a job that has not begun. The Snakemake inside the job writes the same record anew when it begins, without the number.
# So a job that runs is submitted a second time and both write into the same files. Profiles with rerun-incomplete never look at all.
# Package: snakemake 7.21.0-1 (Debian 12; its dependencies have to be installed). The cluster is three lines of shell.
set -eu
t=$(mktemp -d); trap 'touch "$t/go"; sleep 2; rm -rf "$t"' EXIT; cd "$t"
apt-get download -qq snakemake=7.21.0-1 2>/dev/null
dpkg -x snakemake_*.deb root
export PATH="/usr/bin:/bin" PYTHONPATH="$t/root/usr/lib/python3/dist-packages" HOME="$t"
printf '#!/bin/sh\nnohup sh "$1" >/dev/null 2>&1 &\necho $!\n' > submit
printf '#!/bin/sh\nkill -0 "$1" 2>/dev/null && echo running || echo success\n' > status
chmod +x submit status
cat > Snakefile <<'RULE'
rule slow:
    output: "result"
    shell: "echo begun >> begun; until [ -e go ]; do sleep 0.2; done; touch {output}"
RULE
snake() { exec python3 root/usr/bin/snakemake --jobs 1 --cluster ./submit --cluster-status ./status --latency-wait 1 result > "$1" 2>&1; }
begun() { if [ -e begun ]; then wc -l < begun; else echo 0; fi; }
until_begun() { for _ in $(seq 400); do [ "$(begun)" -lt "$1" ] || return 0; sleep 0.2; done; }
(snake first) & running=$!
until_begun 1
kill -9 $running; wait $running 2>/dev/null || true
python3 root/usr/bin/snakemake --unlock result > /dev/null 2>&1
(snake second) & running=$!
for _ in $(seq 400); do grep -q 'Resuming\|Submitted' second && break; sleep 0.2; done
until_begun 2
echo "after a restart: $(grep -o 'Resuming incomplete job\|Submitted job' second); the shell command was begun $(begun) times, the first still at work"
kill -9 $running; wait $running 2>/dev/null || true
[ "$(begun)" -eq 2 ]
