#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Guess: a ConvolverNode, whose "normalize" is on unless switched off, brings impulse responses to one level, and silence behind a response
# adds nothing: a response of one sample passes a sound on as it is, with or without zeros behind it.
# Surprise: the response is divided by its root mean square over its whole length, so zeros at its end make the sound louder. One sample of 1
# turns a tone down by 59 dB; the same sample in front of a second of zeros by 12 dB. Recorded responses of two actuators that differ only
# in where they were cut drive a finger at different levels. The standard's text promises a uniform level; only the code in it tells this.
# Package: node-web-audio-api 0.21.5 (npm)
set -eu
t=$(mktemp -d); trap 'rm -rf "$t"' EXIT; cd "$t"
npm install --silent --no-audit --no-fund --prefix "$t" node-web-audio-api@0.21.5
cat > run.mjs <<'JS'
import { OfflineAudioContext } from "node-web-audio-api";
const rate = 48000;
const buffer = (context, samples) => {
  const made = context.createBuffer(1, samples.length, rate);
  made.copyToChannel(Float32Array.from(samples), 0);
  return made;
};
const tone = Array.from({ length: 4800 }, (_, i) => Math.sin((2 * Math.PI * 200 * i) / rate));
const levelAfter = async (length, normalize) => {  // dB of the tone behind a click followed by zeros
  const context = new OfflineAudioContext(1, tone.length, rate);
  const convolver = context.createConvolver(), source = context.createBufferSource();
  convolver.normalize = normalize;
  convolver.buffer = buffer(context, Array.from({ length }, (_, i) => (i === 0 ? 1 : 0)));
  source.buffer = buffer(context, tone);
  source.connect(convolver).connect(context.destination);
  source.start();
  const heard = (await context.startRendering()).getChannelData(0);
  return 20 * Math.log10(Math.max(...heard));
};
const [click, second, plain] = [await levelAfter(1, true), await levelAfter(rate, true), await levelAfter(rate, false)];
console.log(`a click alone: ${click.toFixed(1)} dB; in front of a second of zeros: ${second.toFixed(1)} dB; not normalized: ${plain.toFixed(1)} dB`);
process.exit(Math.abs(click + 58.8) < 1 && Math.abs(second + 12) < 1 && Math.abs(plain) < 0.1 ? 0 : 1);
JS
node run.mjs
