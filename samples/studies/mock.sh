#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A mock study in the folder $1: buttons A to F and two simulated participants, one who errs now and then, one who guesses.
set -euo pipefail
folder=${1:?name a folder to make}
buttons=$(dirname "$0")/../buttons
detent-play study new "$folder" "$buttons"/{A,B,C,D,E,F}.button.json --seed 2013
detent-play study run "$folder" --participant P01 --simulate errors=0.05 2> /dev/null
detent-play study run "$folder" --participant P02 --simulate guess 2> /dev/null
detent-play study status "$folder"
