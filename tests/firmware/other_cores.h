// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Declarations of the Arduino functions that the sketches call on boards without a simulator, from the
// documents of these cores. other_cores_test.sh only checks syntax with them; nothing is linked or run.

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

constexpr int OUTPUT = 1, INPUT_PULLUP = 2, CHANGE = 3, A0 = 14;

std::uint32_t micros();
void pinMode(int pin, int mode);
void digitalWrite(int pin, int value);
int digitalRead(int pin);
int analogRead(int pin);
void analogWrite(int pin, int value);
void analogWriteResolution(int bits);
int digitalPinToInterrupt(int pin);
void attachInterrupt(int interrupt, void (*routine)(), int mode);
void noInterrupts();
void interrupts();
template <class Value>
Value constrain(Value value, Value low, Value high) {
  return value < low ? low : value > high ? high : value;
}

struct Port {
  void begin(unsigned long baud);
  int available();
  int availableForWrite();
  int read();
  std::size_t print(const char* text);
  std::size_t println(const char* text);
};
extern Port Serial;

#if defined(ARDUINO_ARCH_RP2040)
void analogWriteFreq(std::uint32_t frequency_Hz);
struct Rp2040 {
  void wdt_begin(std::uint32_t delay_ms);
  void wdt_reset();
};
extern Rp2040 rp2040;
#elif defined(ARDUINO_ARCH_STM32)
void analogWriteFrequency(std::uint32_t frequency_Hz);
#elif defined(TEENSYDUINO)
void analogWriteFrequency(int pin, float frequency_Hz);
#elif defined(ARDUINO_ARCH_ESP32)
#define IRAM_ATTR
bool ledcAttach(std::uint8_t pin, std::uint32_t frequency_Hz, std::uint8_t bits);
double ledcSetup(std::uint8_t channel, double frequency_Hz, std::uint8_t bits);
void ledcAttachPin(std::uint8_t pin, std::uint8_t channel);
void ledcWrite(std::uint8_t pinOrChannel, std::uint32_t duty);
#endif
