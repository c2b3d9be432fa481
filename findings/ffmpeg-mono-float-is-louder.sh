#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Guess: ffmpeg's "-ac 1" makes one channel of two by one rule, so the level of the mono file does not depend on the file's kind of samples.
# Surprise: into samples of 16 bits it writes the mean of both channels, into floating-point samples 0.707 times their sum, which is 3 dB
# more where both are alike. The kind of the output alone decides: a FLAC file has the mean; an Ogg Vorbis file, or WAV with floats, is
# 3 dB louder, and a clip near full scale goes beyond it. Both from the same command and the same input, exit 0, no word.
# Package: ffmpeg 7:5.1.9-0+deb12u1 with its libraries (Debian 12)
set -eu
t=$(mktemp -d); trap 'rm -rf "$t"' EXIT; cd "$t"
mkdir -p debs/partial
apt-get install -qq --reinstall --download-only --no-install-recommends -y -o Debug::NoLocking=1 -o Dir::Cache::archives="$t/debs" \
  ffmpeg=7:5.1.9-0+deb12u1 > /dev/null 2>&1  # with those of its libraries that are missing
for deb in debs/*.deb; do dpkg -x "$deb" root; done
export LD_LIBRARY_PATH="$t/root/usr/lib/x86_64-linux-gnu"
cat > tone.py <<'PY'
import math, struct, sys, wave
if sys.argv[1] == "write":  # one second, two channels alike, peak 0.5
    tone = [round(16384 * math.sin(2 * math.pi * 200 * i / 48000)) for i in range(48000)]
    with wave.open("stereo.wav", "wb") as file:
        file.setnchannels(2), file.setsampwidth(2), file.setframerate(48000)
        file.writeframes(b"".join(struct.pack("<hh", x, x) for x in tone))
else:
    peak = {}
    for name in sys.argv[2:]:
        data = open(name + ".raw", "rb").read()
        peak[name] = max(struct.unpack(f"<{len(data) // 4}f", data))
        print(f"{name}: peak {peak[name]:.3f}; each of the two channels: 0.500")
    near = lambda name, right, error: abs(peak[name] - right) < error
    sys.exit(not (near("s16.wav", 0.5, 0.001) and near("16.flac", 0.5, 0.001) and near("f32.wav", 0.7071, 0.001) and near("vorbis.ogg", 0.7071, 0.05)))
PY
python3 tone.py write
run() { root/usr/bin/ffmpeg -nostdin -v error "$@"; }
run -i stereo.wav -ac 1 s16.wav
run -i stereo.wav -ac 1 16.flac
run -i stereo.wav -ac 1 -c:a pcm_f32le f32.wav
run -i stereo.wav -ac 1 -c:a libvorbis -q:a 8 vorbis.ogg
for name in s16.wav 16.flac f32.wav vorbis.ogg; do run -i $name -f f32le $name.raw; done  # one channel already: no mixing
python3 tone.py read s16.wav 16.flac f32.wav vorbis.ogg
