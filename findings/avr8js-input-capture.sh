#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Guess: an ATmega328P simulator whose timer 1 has an ICR1 register and a capture interrupt in its configuration captures: an edge on ICP1
# (PB0) copies the counter into ICR1 and sets ICF1, as the data sheet says.
# Surprise: the timer counts and ICR1 can be written, but no edge is ever seen: ICR1 and ICF1 stay 0. Firmware that times a sensor's pulses
# by capture waits for ever in the simulator and runs on the chip.
# Package: avr8js 0.21.0 (npm)
set -eu
t=$(mktemp -d); trap 'rm -rf "$t"' EXIT; cd "$t"
npm install --silent --no-audit --no-fund --prefix "$t" avr8js@0.21.0
cat > run.cjs <<'JS'
const { CPU, AVRTimer, AVRIOPort, avrInstruction, timer1Config, portBConfig } = require("avr8js");
const [TCCR1B, TIFR1, TCNT1L, TCNT1H, ICR1L, ICR1H] = [0x81, 0x36, 0x84, 0x85, 0x86, 0x87];
const cpu = new CPU(new Uint16Array(0x4000));  // no operations
new AVRTimer(cpu, timer1Config);
const port = new AVRIOPort(cpu, portBConfig);
const run = (cycles) => { for (let i = 0; i < cycles; ++i) { avrInstruction(cpu); cpu.tick(); } };
port.setPin(0, false);
cpu.writeData(TCCR1B, 0x41);  // count at the clock's rate, capture rising edges
run(500);
port.setPin(0, true);
run(10);
const word = (low, high) => cpu.readData(low) | (cpu.readData(high) << 8);
const counter = word(TCNT1L, TCNT1H), captured = word(ICR1L, ICR1H), flag = (cpu.readData(TIFR1) >> 5) & 1;
console.log(`timer ${counter}, ICR1 ${captured} (chip: about 500), ICF1 ${flag} (chip: 1), capture vector configured: 0x${timer1Config.captureInterrupt.toString(16)}`);
process.exit(counter > 500 && captured === 0 && flag === 0 ? 0 : 1);
JS
node run.cjs
