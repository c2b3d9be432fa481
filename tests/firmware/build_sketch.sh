#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# build_sketch.sh BOARD SOURCE OUT.elf [FLAG...]: compiles a sketch (or a C file with setup and loop of its own) with Debian's
# Arduino core for AVR, with the flags of the core's platform.txt and all warnings, and prints flash and RAM. BOARD: uno, leonardo, mega.
set -euo pipefail
board=$1 source=$2 out=$3
shift 3
hardware=/usr/share/arduino/hardware/arduino/avr
case $board in
  uno) mcu=atmega328p variant=standard name=AVR_UNO usb=() ;;
  leonardo) mcu=atmega32u4 variant=leonardo name=AVR_LEONARDO
    usb=(-DUSB_VID=0x2341 -DUSB_PID=0x8036 '-DUSB_MANUFACTURER="Arduino"' '-DUSB_PRODUCT="Leonardo"') ;;
  mega) mcu=atmega2560 variant=mega name=AVR_MEGA2560 usb=() ;;
  *) echo "build_sketch.sh: '$board' is not one of uno, leonardo, mega." >&2; exit 2 ;;
esac
flags=(-mmcu=$mcu -DF_CPU=16000000L -DARDUINO=10819 -DARDUINO_$name -DARDUINO_ARCH_AVR "${usb[@]}" -I$hardware/cores/arduino
       -I$hardware/variants/$variant -Os -g -ffunction-sections -fdata-sections -flto)
c_flags=(-std=gnu11 -fno-fat-lto-objects)
cpp_flags=(-std=gnu++11 -fno-exceptions -fno-threadsafe-statics)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
# DECIMAL_DIG: the core's WString.cpp takes it from float.h, where the avr-gcc 5.4 of Debian 12 has it for C99 alone.
(cd "$folder" && avr-gcc "${flags[@]}" "${c_flags[@]}" -w -c $hardware/cores/arduino/*.c
 avr-g++ "${flags[@]}" "${cpp_flags[@]}" -fpermissive -w -DDECIMAL_DIG=__DECIMAL_DIG__ -c $hardware/cores/arduino/*.cpp
 avr-gcc-ar rcs core.a ./*.o)
if [[ $source == *.c ]]; then language=(-x c "${c_flags[@]}"); else language=(-x c++ "${cpp_flags[@]}" -include Arduino.h); fi
avr-gcc "${flags[@]}" "${language[@]}" -Wall -Wextra -Werror "$@" -c "$source" -o "$folder/sketch.o"
objects=("$folder/sketch.o")
avr-gcc "${flags[@]}" -fuse-linker-plugin -Wl,--gc-sections "${objects[@]}" "$folder/core.a" -lm -o "$out"
avr-size "$out" | awk -v what="$(basename "$source") $board" 'NR == 2 { printf "%s: flash %d bytes, RAM %d bytes\n", what, $1 + $2, $2 + $3 }'
