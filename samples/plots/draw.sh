#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Draws the plots of this folder from the sample buttons with gnuplot, a program that knows nothing of Detent, and writes
# MANIFEST.md and the force meter's log. Look at the pictures before they are committed.
#
#   samples/plots/draw.sh [DETENT-GRAPH]
#
# Needs what ./install-dependencies.sh ci installs (gnuplot, fonts) and detent-graph (default: the one in build/).
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
project=$(dirname "$(dirname "$here")")

graph=${1:-}
for candidate in "$project"/build/{release,import}/bin/detent-graph; do
  [[ -z $graph && -x $candidate ]] && graph=$candidate
done
if [[ -z $graph ]]; then
  echo "samples/plots/draw.sh: there is no detent-graph in build/. Build it (samples/demo.sh does) or pass its path." >&2
  exit 2
fi
for font in "Nimbus Sans" "DejaVu Sans" "WenQuanYi Zen Hei"; do
  if ! fc-list : family | grep -F "$font" >/dev/null; then
    echo "samples/plots/draw.sh: the font $font is missing. Run ./install-dependencies.sh ci." >&2
    exit 2
  fi
done

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Force on a stroke at a displacement, or nothing where the button names no such point.
force_at() {
  [[ -n $2 ]] || return 0
  awk -v x="$2" 'NR > 1 && (px - x) * ($1 - x) <= 0 && $1 != px { print py + (x - px) / ($1 - px) * ($2 - py); exit }
                 { px = $1; py = $2 }' "$1"
}

while IFS=$'\t' read -r name button _ format _; do
  [[ $name == \#* ]] && continue
  file=$project/samples/buttons/$button.button.json
  "$graph" convert "$file" "$work/$button.csv" >/dev/null
  for stroke in press release; do
    awk -F, -v stroke=$stroke '$1 == stroke { print $2, $3 }' "$work/$button.csv" >"$work/$button.$stroke"
  done
  operating=$(jq -r '.states[0].operatingPoint_mm // empty' "$file")
  reset=$(jq -r '.states[0].resetPoint_mm // empty' "$file")
  gnuplot -e "press='$work/$button.press'; release='$work/$button.release'; out='$here/$name.$format';
              operating_mm=${operating:-NaN}; operating_N=$(force_at "$work/$button.press" "$operating" || true) + 0;
              reset_mm=${reset:-NaN}; reset_N=$(force_at "$work/$button.release" "$reset" || true) + 0" \
    "$here/gnuplot/$name.gp" </dev/null
done <"$here/plots.tsv"

python3 "$here/force_meter_log.py" "$work/C.csv" "$here/force-meter-log.csv"
python3 "$here/manifest.py" "$work" >"$here/MANIFEST.md"
ls -l "$here"/*.{png,pdf,svg,csv}
