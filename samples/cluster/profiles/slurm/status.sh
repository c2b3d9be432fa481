#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# What Snakemake asks of a job: running, success or failed. A job whose node was lost says nothing of itself.
state=$(scontrol --oneliner show job "$1" 2>/dev/null | sed -n 's/.*JobState=\([A-Z_]*\).*/\1/p')
[ -n "$state" ] || state=$(sacct --jobs="$1" --noheader --parsable2 --allocations --format=State 2>/dev/null | head -n 1)
case $state in
  COMPLETED) echo success ;;
  PENDING | CONFIGURING | RUNNING | COMPLETING | SUSPENDED | REQUEUED | RESIZING | STOPPED) echo running ;;
  *) echo failed ;;
esac
