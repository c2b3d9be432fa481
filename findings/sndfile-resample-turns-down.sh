#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Guess: a resampler keeps levels. Where the new samples of a recorded click exceed full scale, they are cut off there and nowhere else.
# Surprise: sndfile-resample begins again and turns the whole file down until its highest sample is full scale. Here a quiet tone beside a
# loud square wave is 1.9 dB lower at 48000 Hz than at 44100; without the square wave it keeps its level. Exit 0.
# Package: sndfile-tools 1.5-2 (Debian 12; its libraries have to be installed)
set -eu
t=$(mktemp -d); trap 'rm -rf "$t"' EXIT; cd "$t"
apt-get download -qq sndfile-tools=1.5-2 2>/dev/null
dpkg -x sndfile-tools_*.deb root
cat > waves.py <<'PY'
import math, struct, sys, wave

def write(name, samples):
    with wave.open(name, "wb") as file:
        file.setnchannels(1), file.setsampwidth(2), file.setframerate(44100)
        file.writeframes(b"".join(struct.pack("<h", round(32767 * x)) for x in samples))

def highest(name):
    """In the first third of a second, which is the quiet tone."""
    with wave.open(name, "rb") as file:
        return max(map(abs, struct.unpack("<16000h", file.readframes(16000)))) / 32767

tone = [0.5 * math.sin(2 * math.pi * 200 * i / 44100) for i in range(20000)]
square = [0.98 if i // 50 % 2 else -0.98 for i in range(4000)]
if sys.argv[1] == "write":
    write("alone.wav", tone), write("beside.wav", tone + square)
else:
    alone, beside = highest("alone-48.wav"), highest("beside-48.wav")
    print(f"the tone of 0.500 at 48000 Hz: alone {alone:.3f}, beside a square wave of 0.98: {beside:.3f}")
    sys.exit(not (abs(alone - 0.5) < 0.001 and 0.38 < beside < 0.42))
PY
python3 waves.py write
for name in alone beside; do root/usr/bin/sndfile-resample -to 48000 -c 0 $name.wav $name-48.wav > told; done
python3 waves.py read
