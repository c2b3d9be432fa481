#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# From force graphs to buttons: installs what is missing, builds detent-import, imports, prints what it found.
#
#   samples/demo.sh [FILE...]
#
# FILE: png, jpg, bmp, tiff, webp, gif, pdf, svg, svgz of a force graph, or a force meter's csv. Without one, the samples of samples/plots.
# Leaves for each a button file, a CSV of the fitted graph and a picture with the fit drawn over the page in samples/out.
# Goes on after a file that fails; exits 1 if any failed.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
project=$(dirname "$here")
out=$here/out

case "${1:-}" in
  -h | --help) sed -n '3,9s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; exit 0 ;;
esac

files=("$@")
if ((${#files[@]} == 0)); then
  for file in "$here"/plots/*.{png,jpg,svg,pdf,csv}; do
    [[ -e $file ]] && files+=("$file")
  done
fi
if ((${#files[@]} == 0)); then
  echo "samples/demo.sh: no sample stands in $here/plots. Pass a file." >&2
  exit 2
fi

"$project/install-dependencies.sh" import
(
  cd "$project"
  # A folder that an older layout of the project configured is configured anew.
  grep -qs '^DETENT_UNITY:' build/import/CMakeCache.txt || rm -rf build/import/CMakeCache.txt build/import/CMakeFiles
  cmake --preset import --log-level=WARNING >/dev/null
  # One line that says how long the rest will take; what the compiler says otherwise is passed on.
  NINJA_STATUS='[%f/%t %e] ' cmake --build --preset import --parallel "$(nproc)" --target detent-import detent-graph |
    awk -v terminal="$([[ -t 1 ]] && echo yes)" '
      /^\[[0-9]+\/[0-9]+ [0-9.]+\]/ {
        split(substr($1, 2), steps, "/"); seconds = $2 + 0
        if (!terminal || steps[1] == 0) next
        printf "\rBuilding: step %d of %d, about %d s left.   ", steps[1], steps[2], seconds / steps[1] * (steps[2] - steps[1])
        fflush(); shown = 1; next
      }
      { if (shown) printf "\n"; shown = 0; print }
      END { if (shown) printf "\n" }'
)
import=$project/build/import/bin/detent-import

# One name per file, also where two folders hold files of the same name.
declare -A taken
result_name() {
  local name number=1
  name=$(basename "$1")
  name=${name%.*}
  result=$name
  while [[ -n ${taken[$result]:-} ]]; do
    number=$((number + 1))
    result=$name-$number
  done
  taken[$result]=yes
}

# One row from the JSON of an import, its cells separated by an invisible character.
row='
  def rounded($digits): . * pow(10; $digits) | round / pow(10; $digits) | tostring;
  def fixed($digits): (. * pow(10; $digits) | round) as $whole
    | ($whole | fabs | tostring | if length <= $digits then "0" * ($digits + 1 - length) + . else . end)
    | (if $whole < 0 then "-" else "" end) + .[:-$digits] + "." + .[-$digits:];
  def axis: if . then "\(.min | rounded(3)) to \(.max | rounded(3)) \(.unit)" else "force meter" end;
  def points: if . == null then "not drawn"
              elif (.tactile_points | length) == 0 then "none"
              else [.tactile_points[] | "\(.displacement_mm | fixed(2)) mm \(.force_N | fixed(3)) N"] | join(", ") end;
  [ (.x_axis | axis), (.y_axis | axis), "\(.travel_mm | fixed(2)) mm", (.press | points), (.release | points),
    "\(.press.pieces + (.release.pieces // 0))",
    (if .x_axis then "\([.press.rms_px, (.release.rms_px // 0)] | max | fixed(2)) px" else "-" end) ] | join("\u001f")'

layout='%-28s %-17s %-17s %-8s %-33s %-33s %6s %8s %7s\n'
mkdir -p "$out"
echo
# shellcheck disable=SC2059
printf "$layout" file 'x axis' 'y axis' travel 'tactile points, press' 'tactile points, release' pieces rms time
failed=()
warnings=()
for file in "${files[@]}"; do
  result_name "$file"
  rm -f "$out/$result".{button.json,csv,overlay.png,json}
  begun=${EPOCHREALTIME/[.,]/}
  status=0
  "$import" "$file" -o "$out/$result.button.json" --csv "$out/$result.csv" --overlay "$out/$result.overlay.png" --json \
    >"$out/$result.json" 2>"$out/$result.err" </dev/null || status=$?
  took=$(((${EPOCHREALTIME/[.,]/} - begun) / 1000))
  took=$(printf '%d.%02d s' $((took / 1000)) $((took % 1000 / 10)))
  if ((status)); then
    failed+=("$file")
    sentence=$(jq -r '.problem // empty' "$out/$result.json" 2>/dev/null || true)
    [[ -n $sentence ]] || sentence=$(tail -n 1 "$out/$result.err")
    printf '%-28s not imported (exit %d, %s): %s\n' "$(basename "$file")" "$status" "$took" "${sentence:-no reason given}"
    rm -f "$out/$result".{json,err}
    continue
  fi
  IFS=$'\x1f' read -r x_axis y_axis travel press release pieces rms < <(jq -r "$row" "$out/$result.json")
  # shellcheck disable=SC2059
  printf "$layout" "$(basename "$file")" "$x_axis" "$y_axis" "$travel" "$press" "$release" "$pieces" "$rms" "$took"
  while IFS= read -r warning; do
    warnings+=("$(basename "$file"): $warning")
  done < <(jq -r '.warnings[]?' "$out/$result.json")
  rm -f "$out/$result.err"
done

if ((${#warnings[@]})); then
  printf '\nDoubts of the importer:\n'
  printf '  %s\n' "${warnings[@]}"
fi
printf '\nIn %s, for each file NAME:\n' "$out"
echo '  NAME.button.json   the button; edit it with detent-edit, feel it with detent-play'
echo '  NAME.csv           the fitted graph (stroke,displacement_mm,force_N)'
echo '  NAME.overlay.png   the fit drawn over the page: look at it'
echo '  NAME.json          what the importer reports'
if ((${#failed[@]})); then
  printf '\n%d of %d files were not imported: %s\n' "${#failed[@]}" "${#files[@]}" "${failed[*]}"
  exit 1
fi
printf '\nAll %d files imported.\n' "${#files[@]}"
