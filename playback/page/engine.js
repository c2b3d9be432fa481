// SPDX-License-Identifier: GPL-3.0-or-later
// An instance of the engine with its buttons; shared by the page and its audio worklet. A button is its numbers; a stimulus
// of a study is { numbers, settings }.
"use strict";

function detentInstance(module, buttons) {
  // The engine has no files and asks no clock but for how long a render took.
  const nothing = () => 0;
  const system = new Proxy({}, { get: (_, name) => (name === "proc_exit" ? (code) => { throw new Error("engine ended: " + code); } : nothing) });
  const { exports } = new WebAssembly.Instance(module, { wasi_snapshot_preview1: system });
  exports._initialize();
  for (const button of buttons) {
    const numbers = button.settings ? button.numbers : button;
    const at = exports.detent_numbers(numbers.length);
    new Float64Array(exports.memory.buffer, at, numbers.length).set(numbers);
    if ((button.settings ? exports.detent_add_stimulus(...button.settings) : exports.detent_add()) < 0) throw new Error("a button of this page is damaged");
  }
  return exports;
}

// What is heard of the presses of a study, beside what is felt; after detent_start.
function detentSound(engine, sound) {
  const at = engine.detent_sound_samples(sound.samples.length);
  new Float32Array(engine.memory.buffer, at, sound.samples.length).set(sound.samples);
  engine.detent_sound(sound.rendered ? 1 : 0, sound.rate, sound.level_dB, sound.delay_s);
}
