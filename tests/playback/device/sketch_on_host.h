// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The Arduino sketch of samples/firmware as part of a test program, which defines firmware::micros and firmware::analogRead: its own
// clock and its own sensor. One source file of a program includes this.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>

namespace firmware {

std::uint32_t micros();
int analogRead(std::uint8_t pin);

constexpr std::uint8_t A0 = 14;
std::string sent, incoming;  // what stands on the line, both ways

struct SerialPort {
  void begin(std::uint32_t) {}
  void print(const char* text) { sent += text; }
  void println(const char* text) { sent += std::string(text) + "\r\n"; }
  int available() { return static_cast<int>(incoming.size()); }
  int read() {
    const char c = incoming.front();
    incoming.erase(0, 1);
    return c;
  }
} Serial;

void sendReading(std::uint32_t time_us, int counts);  // the Arduino builder writes this declaration
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wold-style-cast"
using std::int32_t;
using std::snprintf;
using std::uint32_t;
using std::uint8_t;
#include "samples/firmware/fsr400/fsr400.ino"
#pragma GCC diagnostic pop

}  // namespace firmware
