// SPDX-License-Identifier: GPL-3.0-or-later
// The audio thread of the page: Detent's engine, one instance, told what the finger does by plain messages.
"use strict";

class DetentProcessor extends AudioWorkletProcessor {
  constructor(options) {
    super();
    const { module, buttons } = options.processorOptions;
    this.engine = detentInstance(module, buttons);
    this.engine.detent_start(sampleRate);
    this.shownEvery = Math.max(1, Math.round(sampleRate / 128 / 60));
    this.blocks = 0;
    this.last = new Float64Array(9);
    this.views();
    this.port.onmessage = ({ data }) => this.obey(data);
  }

  // Memory does not grow after the start, so views of it are made once.
  views() {
    const memory = this.engine.memory.buffer;
    this.out = new Float32Array(memory, this.engine.detent_process(0), 8192);
    this.shown = new Float64Array(memory, this.engine.detent_shown(), 9);
  }

  obey(message) {
    if (message.use !== undefined) this.engine.detent_use(message.use);
    if (message.force_N !== undefined) this.engine.detent_steer(message.force_N);
    if (message.down === true) this.engine.detent_press();
    if (message.down === false) this.engine.detent_lift();
  }

  process(inputs, outputs) {
    const channels = outputs[0];
    const frames = channels[0].length;
    this.engine.detent_process(frames);
    for (let c = 0; c < channels.length; ++c) {
      const channel = channels[c];
      for (let i = 0; i < frames; ++i) channel[i] = this.out[i];
    }
    if (++this.blocks % this.shownEvery === 0) this.tell();
    return true;
  }

  // Only what has changed is told: a page at rest is silent.
  tell() {
    this.engine.detent_shown();
    let changed = false;
    for (let i = 0; i < 9; ++i) {
      if (this.last[i] !== this.shown[i]) changed = true;
      this.last[i] = this.shown[i];
    }
    if (changed) this.port.postMessage(this.last);
  }
}

registerProcessor("detent", DetentProcessor);
