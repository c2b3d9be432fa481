#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# other_cores_test.sh COMPILER: checks the syntax of the sketches for every core that tests/firmware cannot simulate, and that
# force1d refuses a core it does not know.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
sketches=$here/../../samples/firmware
checked() {  # SKETCH FLAG...
  local sketch=$1
  shift
  "$compiler" -std=gnu++17 -fsyntax-only -Wall -Wextra -Werror -Wno-unused-const-variable -I"$here/stm32" "$@" -include "$here/other_cores.h" \
    -x c++ "$sketches/$sketch/$sketch.ino"
}
compiler=$1
for core in ARDUINO_ARCH_RP2040 ARDUINO_ARCH_STM32 TEENSYDUINO "ARDUINO_ARCH_ESP32 -DESP_ARDUINO_VERSION_MAJOR=2" \
  "ARDUINO_ARCH_ESP32 -DESP_ARDUINO_VERSION_MAJOR=3"; do
  # shellcheck disable=SC2086  # a core and its version are two words
  for sketch in force1d fsr400; do checked $sketch -D$core; done
done
if said=$(checked force1d -DARDUINO_ARCH_MEGAAVR 2>&1) || [[ $said != *"#error"* ]]; then
  echo "force1d does not refuse a core it does not know: $said" >&2
  exit 1
fi
