#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Guess: one second of sound at 44100 Hz, decoded into a context of 48000 Hz, is 48000 samples: 44100 * 48000 / 44100 is whole.
# Surprise: 48001, and a duration of 1.0000208 s; one second at 8000, 48000 or 96000 Hz is 48000. Two renderings of one clip that differ in
# the file's rate alone have different lengths, and comparing them sample by sample fails by length.
# Package: node-web-audio-api 0.21.5 (npm)
set -eu
t=$(mktemp -d); trap 'rm -rf "$t"' EXIT; cd "$t"
npm install --silent --no-audit --no-fund --prefix "$t" node-web-audio-api@0.21.5
cat > run.mjs <<'JS'
import { OfflineAudioContext } from "node-web-audio-api";
const wave = (rate) => {  // one second of silence, 16 bits
  const bytes = new DataView(new ArrayBuffer(44 + 2 * rate));
  const text = (at, word) => [...word].forEach((c, i) => bytes.setUint8(at + i, c.charCodeAt(0)));
  text(0, "RIFF"); bytes.setUint32(4, 36 + 2 * rate, true); text(8, "WAVEfmt "); bytes.setUint32(16, 16, true);
  [1, 1].forEach((n, i) => bytes.setUint16(20 + 2 * i, n, true)); bytes.setUint32(24, rate, true); bytes.setUint32(28, 2 * rate, true);
  bytes.setUint16(32, 2, true); bytes.setUint16(34, 16, true); text(36, "data"); bytes.setUint32(40, 2 * rate, true);
  return bytes.buffer;
};
const lengths = {};
for (const rate of [8000, 44100, 48000, 96000])
  lengths[rate] = (await new OfflineAudioContext(1, 48000, 48000).decodeAudioData(wave(rate))).length;
console.log("one second of each rate, decoded at 48000 Hz:", JSON.stringify(lengths));
process.exit(lengths[44100] === 48001 && lengths[8000] === 48000 && lengths[96000] === 48000 ? 0 : 1);
JS
node run.mjs
