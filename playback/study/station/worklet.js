// SPDX-License-Identifier: GPL-3.0-or-later
// The audio thread of a station: the engine with the stimuli of a study. Every message of presses says which
// trial and slot it belongs to.
"use strict";

const tapHold_s = 0.15;  // a shorter press lasts as long as one by a key at a terminal

class DetentStation extends AudioWorkletProcessor {
  constructor(options) {
    super();
    const { module, stimuli, sound } = options.processorOptions;
    this.engine = detentInstance(module, stimuli);
    this.engine.detent_start(sampleRate);
    if (sound) {
      detentSound(this.engine, sound);
      this.ears = new Float32Array(this.engine.memory.buffer, this.engine.detent_heard(), 8192);
    }
    this.toldEvery = Math.max(1, Math.round(sampleRate / 128 / 60));
    this.blocks = 0;
    this.trial = this.slot = -1;
    this.mayLift = this.liftAt = 0;
    this.lifting = false;
    const memory = this.engine.memory.buffer;
    this.out = new Float32Array(memory, this.engine.detent_process(0), 8192);
    this.felt = new Float64Array(memory, this.engine.detent_felt(), 4);
    this.port.onmessage = ({ data }) => this.obey(data);
  }

  obey(message) {
    if (message.trial !== undefined) {
      this.engine.detent_lift();
      this.engine.detent_begin_trial();
      this.lifting = false;
      this.trial = message.trial;
      this.slot = -1;
    }
    if (message.slot !== undefined) {
      this.tell();
      this.engine.detent_place(message.slot, message.stimulus);
      this.engine.detent_press();
      this.lifting = false;
      this.slot = message.slot;
      this.mayLift = currentFrame + tapHold_s * sampleRate;
    }
    if (message.lift) {
      this.lifting = true;
      this.liftAt = Math.max(currentFrame, this.mayLift);
    }
  }

  process(inputs, outputs) {
    const channels = outputs[0], frames = channels[0].length;
    if (this.lifting && currentFrame >= this.liftAt) {
      this.lifting = false;
      this.engine.detent_lift();
    }
    this.engine.detent_process(frames);
    // With a sound of presses: the vibration is left, the sound right.
    channels.forEach((channel, c) => channel.set((this.ears && c === 1 ? this.ears : this.out).subarray(0, frames)));
    if (++this.blocks % this.toldEvery === 0) this.tell();
    return true;
  }

  // Presses of the stimulus under the finger since the last message, if there were any.
  tell() {
    if (this.slot < 0) return;
    this.engine.detent_felt();
    const [presses, whole, peak_N, travel_mm] = this.felt;
    if (presses || whole || peak_N || travel_mm)
      this.port.postMessage({ trial: this.trial, slot: this.slot, presses, whole, peak_N, travel_mm });
  }
}

registerProcessor("detent-station", DetentStation);
