#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Tells Snakemake about a job: running, success or failed. A job counts as running while nobody can be asked; only a state, or a
# controller that does not know the job, makes it failed. Jobs that wait for a person are named once on standard error.
job=$1

say_once() {
  mark=.snakemake/held-$job  # where Snakemake was started
  [ -e "$mark" ] && return
  echo "Slurm job $job is held: $1. Release it (scontrol release $job) or cancel it (scancel $job)." >&2
  [ -d .snakemake ] && : >"$mark"
}

if told=$(LC_ALL=C scontrol --oneliner show job "$job" 2>&1); then
  state=$(printf '%s\n' "$told" | sed -n 's/.*JobState=\([A-Z_]*\).*/\1/p' | head -n 1)
  reason=$(printf '%s\n' "$told" | sed -n 's/.* Reason=\([^ ]*\).*/\1/p' | head -n 1)
else
  case $told in
    *"Invalid job id"*) ;;  # ended long ago, or never was
    *) echo running; exit ;;
  esac
  if told=$(LC_ALL=C sacct --jobs="$job" --noheader --parsable2 --allocations --format=State 2>&1); then
    state=$(printf '%s\n' "$told" | sed -n '1s/ .*//;1p')  # "CANCELLED by 1000"
    [ -n "$state" ] || state=unknown
  else
    case $told in
      *"accounting storage is disabled"*) state=unknown ;;
      *) echo running; exit ;;
    esac
  fi
fi

case $state in
  COMPLETED) echo success ;;
  BOOT_FAIL | CANCELLED | DEADLINE | FAILED | NODE_FAIL | OUT_OF_MEMORY | PREEMPTED | TIMEOUT | unknown) echo failed ;;
  RESV_DEL_HOLD | REQUEUE_HOLD | SPECIAL_EXIT | REVOKED)
    say_once "$state"
    echo running
    ;;
  *)  # PENDING, CONFIGURING, RUNNING, COMPLETING, SIGNALING, STAGE_OUT, STOPPED, SUSPENDED, RESIZING, REQUEUED, REQUEUE_FED
    case $state/$reason in PENDING/JobHeld* | PENDING/*_held | PENDING/*requeued_held*) say_once "$reason" ;; esac
    echo running
    ;;
esac
