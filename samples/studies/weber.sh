#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Weber fractions in the folder $1: one threshold study for each quantity whose fraction the forecast assumes, with six SIMULATED people whose
# thresholds lie about that. People answer the same studies without --simulate.
set -euo pipefail
folder=${1:?name a folder to make}
buttons=$(dirname "$0")/../buttons
mkdir "$folder"
ask() {  # QUANTITY FRACTION SEED
  detent-play study new "$folder/$1" "$buttons"/{B,D}.button.json --kind threshold --quantity "$1" --seed "$3" 2> /dev/null
  local person=0
  for share in 0.7 0.85 0.95 1.05 1.2 1.4; do
    person=$((person + 1))
    detent-play study run "$folder/$1" --participant "P0$person" --simulate "threshold=$(awk "BEGIN { print $2 * $share }")" 2> /dev/null
  done
  echo "== $1: the forecast assumes $2"
  detent-play study report "$folder/$1"
}
ask event-size 0.20 1
ask travel 0.25 2
ask peak-force 0.32 3
