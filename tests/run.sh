#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds everything (preset release) and runs all tests.
#
#   tests/run.sh [--again] [CTEST-OPTIONS...]
#
# Where all tests passed and nothing has changed since (sources, build, packages, corpus), it says so and stops;
# --again or CI=true runs them regardless. Further words go to ctest, e.g. -R trace.
#
# A test that keeps time or drives windows (tests/CMakeLists.txt) fails on a machine that others keep busy. If nothing else failed,
# those that did run once more, alone; what passes then has passed. A force above the limit is no matter of time and fails at once.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

again=${CI:-}
ctest_options=()
for argument in "$@"; do
  case "$argument" in
    --again) again=yes ;;
    -h | --help) sed -n '3,11s/^# \{0,1\}//p' "$0"; exit 0 ;;
    *) ctest_options+=("$argument") ;;
  esac
done

build=build/release
started=$SECONDS
./install-dependencies.sh test
# A folder that an older layout of the project configured is configured anew.
grep -qs '^DETENT_UNITY:' $build/CMakeCache.txt || rm -rf $build/CMakeCache.txt $build/CMakeFiles
cmake --preset release --log-level=WARNING >/dev/null
cmake --build --preset release --parallel "$(nproc)"

# Everything a test's outcome may depend on, by size and time of change.
fingerprint() {
  {
    find . -type f -not -path './build/*' -not -path './.git/*' -not -path './samples/out/*' -printf '%p %s %T@\n' | sort
    find $build -type f -perm -u+x -printf '%p %s %T@\n' | sort
    stat -c '%n %s %Y' /var/lib/dpkg/status 2>/dev/null || true
    corpus=${DETENT_CORPUS:-../shared/corpus}
    stat -c '%n %Y' "$corpus" "$corpus"/* 2>/dev/null || true
  } | sha256sum
}

stamp=$build/all-tests-passed
now=$(fingerprint)
if [[ -z $again && ${#ctest_options[@]} -eq 0 && -f $stamp && $(head -n 1 "$stamp") == "$now" ]]; then
  sed -n '2s/$/ Nothing has changed since; --again runs them once more./p' "$stamp"
  exit 0
fi

status=0
begun=$build/tests-begun
touch $begun
# Three places for each core, of which what computes takes all (tests/CMakeLists.txt).
ctest --preset release --parallel $((3 * $(nproc))) "${ctest_options[@]}" || status=$?
log=$build/all-tests.log
cp $build/Testing/Temporary/LastTest.log $log 2>/dev/null || : >$log
list=$build/Testing/Temporary/LastTestsFailed.log  # stays from an earlier run where nothing failed
failures() { [[ $list -nt $begun ]] && sed 's/^[0-9]*://' $list | sort; }
repeatable() { ctest --preset release -N -L '^(keeps_time|drives_windows)$' | sed -n 's/^ *Test *#[0-9]*: //p' | sort; }
repeated=0
if ((status)); then
  mapfile -t failed < <(failures)
  mapfile -t others < <(comm -23 <(failures) <(repeatable))
  if ((${#failed[@]} == 0 || ${#others[@]})) || grep -aq '^FORCE ABOVE THE LIMIT' "$log"; then
    echo "tests/run.sh: tests failed; their output stands above, all output in $log."
    exit 1
  fi
  echo "These failed beside other tests and run once more, alone: ${failed[*]}"
  if ! ctest --preset release --parallel 1 -R "^($(IFS='|' && echo "${failed[*]}"))$"; then
    echo "tests/run.sh: tests failed, alone too; their output stands above."
    exit 1
  fi
  repeated=${#failed[@]}
  cat $build/Testing/Temporary/LastTest.log >>$log
fi
count() { grep -acE "$1" "$log" || true; }
passed=$(count '^Test Passed\.$')
skipped=$(count '^SKIPPED')
if ((passed == 0)); then
  echo "tests/run.sh: no test ran."
  exit 1
fi
echo "The twenty slowest:"
awk -F'"' '/^[0-9]+\/[0-9]+ Testing: /{name = $0; sub(/.*Testing: /, "", name)} /^Test time = /{split($0, t, " "); print t[4], name}' "$log" |
  sort -rn | awk 'NR <= 20 {printf "  %6.1f s  %s\n", $1, $2}'
grep -aE '^SKIPPED' "$log" | sort | uniq -c | sed 's/^ *\([0-9]*\) /  \1 x /' || true
closing="All tests passed: $passed programs, $skipped checks skipped."
((repeated == 0)) || closing+=" Failed beside other tests, passed alone: ${failed[*]}."
if ((${#ctest_options[@]} == 0)); then
  printf '%s\n' "$now" "$closing ($(date '+%F %T'))" >"$stamp"
fi
echo "$closing $((SECONDS - started)) s in all."
