// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// An Arduino board in simavr: a compiled sketch on the real instruction set, with its port, pins, converter
// and clock as numbers.

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

struct avr_t;

namespace detent::firmware {

/// A pin by the name of its register: {'D', 4} is PD4.
struct Pin {
  char port = 'A';
  int bit = 0;
};

/// Addresses and pins of a board that the sketches use.
struct BoardKind {
  const char* name = "";  ///< as build_sketch.sh takes it
  const char* mcu = "";
  Pin encoderA, encoderB, direction, pwm, stopSwitch;
  std::uint16_t icr = 0, ocr = 0;  ///< data addresses of the PWM timer's top and compare registers
  std::uint16_t ramBytes = 0;
  std::uint16_t tableRows = 0;  ///< rows of the table that force1d offers on this board
};

extern const BoardKind uno, mega, leonardo;

class SimulatedBoard {
 public:
  SimulatedBoard(const BoardKind& kind, const std::string& elfFile);
  ~SimulatedBoard();
  SimulatedBoard(const SimulatedBoard&) = delete;
  SimulatedBoard& operator=(const SimulatedBoard&) = delete;

  void run_us(double duration_us);
  double time_us() const;

  /// Bytes to the board's port; they arrive at the speed that the sketch has set.
  void send(const std::string& bytes);
  /// Everything received so far and not taken yet.
  std::string take();
  /// Sends a body with its checksum and runs the board until a line comes back. Returns the line's body, or
  /// "" after `wait_us`.
  std::string ask(const std::string& body, double wait_us = 30000);

  void setPin(Pin pin, bool high);
  bool pinIsHigh(Pin pin) const;  ///< false if the board does not drive the pin
  void setAnalog_mV(int channel, unsigned value_mV);

  /// Share of the time that the PWM pin was high, and how often it rose a second, over the next `window_us`.
  struct Pwm {
    double duty = 0;
    double frequency_Hz = 0;
  };
  Pwm measurePwm(double window_us = 500);
  /// The same share as the timer's registers hold it; 0 where the pin is not joined to the timer. Costs no
  /// time.
  double duty() const;

  std::uint8_t byteAt(std::uint16_t address) const;  ///< of the data space
  std::uint32_t variable(const std::string& name, int bytes) const;
  void setVariable(const std::string& name, int bytes, std::uint32_t value);
  /// Runs some 15 ms, after which micros() wraps in `before_us` (timer 0 overflows every 1,024 us).
  void wrapClockIn(double before_us);

  /// Bytes from the end of RAM to the deepest place the stack came to, and to the end of the sketch's
  /// variables.
  int stackUsed() const { return ramEnd_ - lowestStack_; }
  int stackAvailable() const;

  /// The processor runs in a circle at the place where it is, until `release`.
  void hang();
  void release();

 private:
  std::uint32_t addressOf(const std::string& name) const;
  void notePwmEdge(bool high);

  struct Outside;  ///< signals that drive the pins

  const BoardKind& kind_;
  avr_t* avr_ = nullptr;
  std::vector<std::pair<std::string, std::uint32_t>> symbols_;
  std::string received_, toSend_;
  bool portFree_ = true;
  std::unique_ptr<Outside> outside_;
  int recentStack_[4] = {}, recent_ = 0, lowestStack_ = 0, ramEnd_ = 0;
  std::uint32_t hangingAt_ = 0;
  std::uint8_t saved_[2] = {};
  bool pwmHigh_ = false;
  double pwmHighSince_us_ = 0, pwmHigh_us_ = 0;
  int pwmRises_ = 0;
};

/// `body` as a line of docs/reference/force-protocol.md.
std::string lineOf(const std::string& body);

}  // namespace detent::firmware
