// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The firmware of samples/firmware/force1d as part of a program, for the host's tests at the 4 kHz of a 32
// bit board: as an RP2040, whose clock, encoder and motor are numbers. One source file of a program includes
// this. The firmware by itself is tested in tests/firmware.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace firmware {

std::uint32_t time_us = 0;
std::string sent;
std::string incoming;
int direction = 0, pwm = 0;
int stopSwitch = 0;  // 0: closed, as it has to be
constexpr int OUTPUT = 1, CHANGE = 1, INPUT_PULLUP = 2;

std::uint32_t micros() { return time_us; }
void pinMode(std::uint8_t, int) {}
void digitalWrite(std::uint8_t, int value) { direction = value; }
int digitalRead(std::uint8_t pin) { return pin == 6 ? stopSwitch : 0; }
void analogWrite(std::uint8_t, int value) { pwm = value; }
int digitalPinToInterrupt(std::uint8_t pin) { return pin; }
void attachInterrupt(int, void (*)(), int) {}
void noInterrupts() {}
void interrupts() {}
void analogWriteFreq(int) {}
void analogWriteResolution(int) {}
struct Rp2040 {
  void wdt_begin(std::uint32_t) {}
  void wdt_reset() {}
} rp2040;

struct SerialPort {
  void begin(std::uint32_t) {}
  void print(const char* text) { sent += text; }
  int availableForWrite() { return 256; }
  int available() { return static_cast<int>(incoming.size()); }
  int read() {
    const char c = incoming.front();
    incoming.erase(0, 1);
    return c;
  }
} Serial;

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wold-style-cast"
using std::abs;
using std::int32_t;
using std::int64_t;
using std::snprintf;
using std::strlen;
using std::strrchr;
using std::uint16_t;
using std::uint32_t;
using std::uint8_t;
int32_t constrain(int32_t value, int32_t low, int32_t high) { return std::clamp(value, low, high); }
#define ARDUINO_ARCH_RP2040
#include "samples/firmware/force1d/force1d.ino"
#undef ARDUINO_ARCH_RP2040
#undef DETENT_IN_RAM
#pragma GCC diagnostic pop

/// The board for `us` microseconds of its own time.
void run(std::uint32_t us) {
  for (const std::uint32_t end = time_us + us; time_us != end; time_us += 10) loop();
}

std::string exchange(const std::string& sentLine) {
  incoming += sentLine + "\n";
  sent.clear();
  run(20);
  return sent;
}

}  // namespace firmware
