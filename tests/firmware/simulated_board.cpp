// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/firmware/simulated_board.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <stdexcept>

extern "C" {
#include <simavr/avr_adc.h>
#include <simavr/avr_ioport.h>
#include <simavr/avr_uart.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>
#include <simavr/sim_irq.h>
}

namespace detent::firmware {

// Data addresses from the chips' data sheets: ICR1 0x86, OCR1A 0x88; ICR3 0x96, OCR3A 0x98. COMnA1 is bit 7
// of TCCRnA.
const BoardKind uno{"uno",    "atmega328p", {'D', 2}, {'D', 3}, {'D', 4}, {'B', 1},
                    {'D', 6}, 0x86,         0x88,     2048,     40};
const BoardKind mega{"mega",   "atmega2560", {'E', 4}, {'E', 5}, {'G', 5}, {'E', 3},
                     {'H', 3}, 0x96,         0x98,     8192,     256};
const BoardKind leonardo{"leonardo", "atmega32u4", {'D', 1}, {'D', 0}, {'D', 4}, {'C', 6},
                         {'D', 7},   0x96,         0x98,     2560,     40};

namespace {

constexpr double clock_MHz = 16;
constexpr std::uint16_t stackPointer = 0x5D;  // data address, on all three chips

/// simavr's names of its calls are made of characters as int.
constexpr std::uint32_t code(int name) { return static_cast<std::uint32_t>(name); }

void quiet(avr_t*, const int, const char*, va_list) {}

}  // namespace

struct SimulatedBoard::Outside {
  std::map<char, std::pair<unsigned, unsigned>> ports;  ///< pins of each port, and their levels
};

SimulatedBoard::SimulatedBoard(const BoardKind& kind, const std::string& elfFile)
    : kind_(kind), outside_(std::make_unique<Outside>()) {
  avr_global_logger_set(quiet);
  elf_firmware_t firmware{};
  if (elf_read_firmware(elfFile.c_str(), &firmware) != 0) throw std::runtime_error("cannot read " + elfFile);
  avr_ = avr_make_mcu_by_name(kind.mcu);
  if (!avr_) throw std::runtime_error(std::string("simavr does not know ") + kind.mcu);
  avr_init(avr_);
  avr_->frequency = static_cast<std::uint32_t>(1e6 * clock_MHz);
  avr_->vcc = avr_->avcc = avr_->aref = 5000;
  avr_load_firmware(avr_, &firmware);
  avr_->frequency = static_cast<std::uint32_t>(1e6 * clock_MHz);
  avr_->sleep = [](avr_t*, avr_cycle_count_t) {};
  for (std::uint32_t i = 0; i < firmware.symbolcount; ++i)
    symbols_.emplace_back(firmware.symbol[i]->symbol, firmware.symbol[i]->addr);
  ramEnd_ = lowestStack_ = avr_->ramend;
  std::uint32_t flags = 0;
  avr_ioctl(avr_, code(AVR_IOCTL_UART_GET_FLAGS('0')), &flags);
  flags &= ~static_cast<std::uint32_t>(AVR_UART_FLAG_STDIO | AVR_UART_FLAG_POLL_SLEEP);
  avr_ioctl(avr_, code(AVR_IOCTL_UART_SET_FLAGS('0')), &flags);
  const auto listen = [this](avr_irq_t* irq, auto function) {
    if (irq) avr_irq_register_notify(irq, function, this);
  };
  listen(
      avr_io_getirq(avr_, code(AVR_IOCTL_UART_GETIRQ('0')), UART_IRQ_OUTPUT),
      +[](avr_irq_t*, std::uint32_t value, void* board) {
        static_cast<SimulatedBoard*>(board)->received_ += static_cast<char>(value);
      });
  listen(
      avr_io_getirq(avr_, code(AVR_IOCTL_UART_GETIRQ('0')), UART_IRQ_OUT_XON),
      +[](avr_irq_t*, std::uint32_t, void* board) { static_cast<SimulatedBoard*>(board)->portFree_ = true; });
  listen(
      avr_io_getirq(avr_, code(AVR_IOCTL_UART_GETIRQ('0')), UART_IRQ_OUT_XOFF),
      +[](avr_irq_t*, std::uint32_t, void* board) {
        static_cast<SimulatedBoard*>(board)->portFree_ = false;
      });
  listen(
      avr_io_getirq(avr_, code(AVR_IOCTL_IOPORT_GETIRQ(kind.pwm.port)), kind.pwm.bit),
      +[](avr_irq_t*, std::uint32_t value, void* board) {
        static_cast<SimulatedBoard*>(board)->notePwmEdge(value != 0);
      });
  setPin(kind.stopSwitch, false);  // the switch must be closed
}

SimulatedBoard::~SimulatedBoard() {
  if (!avr_) return;
  avr_terminate(avr_);
  std::free(avr_);
}

double SimulatedBoard::time_us() const { return static_cast<double>(avr_->cycle) / clock_MHz; }

void SimulatedBoard::run_us(double duration_us) {
  const auto end = avr_->cycle + static_cast<avr_cycle_count_t>(duration_us * clock_MHz);
  avr_irq_t* input = avr_io_getirq(avr_, code(AVR_IOCTL_UART_GETIRQ('0')), UART_IRQ_INPUT);
  std::size_t sent = 0;
  while (avr_->cycle < end) {
    // One byte each time: the simulated receiver says when it is full.
    if (sent < toSend_.size() && portFree_ && input)
      avr_raise_irq(input, static_cast<std::uint8_t>(toSend_[sent++]));
    const int state = avr_run(avr_);
    if (state == cpu_Done || state == cpu_Crashed)
      throw std::runtime_error("the simulated processor crashed");
    // The stack pointer's two bytes are written one after the other, so a value that lasts less than four
    // instructions is half written and does not count.
    recentStack_[recent_++ % 4] = avr_->data[stackPointer] | avr_->data[stackPointer + 1] << 8;
    const int stack = *std::max_element(std::begin(recentStack_), std::end(recentStack_));
    if (stack > 0 && stack < lowestStack_) lowestStack_ = stack;
  }
  toSend_.erase(0, sent);
}

void SimulatedBoard::send(const std::string& bytes) { toSend_ += bytes; }

std::string SimulatedBoard::take() {
  std::string taken;
  taken.swap(received_);
  return taken;
}

std::string SimulatedBoard::ask(const std::string& body, double wait_us) {
  received_.clear();
  send(lineOf(body));
  for (const double end_us = time_us() + wait_us; time_us() < end_us;) {
    run_us(20);
    const std::size_t end = received_.find('\n');
    if (end == std::string::npos) continue;
    const std::string line = received_.substr(0, end + 1), answer = line.substr(0, line.find('*'));
    return lineOf(answer) == line ? answer : "checksum wrong: " + line;
  }
  return {};
}

void SimulatedBoard::setPin(Pin pin, bool high) {
  auto& [mask, levels] = outside_->ports[pin.port];
  mask |= 1U << pin.bit;
  levels = (levels & ~(1U << pin.bit)) | static_cast<unsigned>(high) << pin.bit;
  avr_ioport_external_t outside{};
  outside.name = static_cast<unsigned char>(pin.port) & 0x7FU;
  outside.mask = mask & 0xFFU;
  outside.value = levels & 0xFFU;
  avr_ioctl(avr_, code(AVR_IOCTL_IOPORT_SET_EXTERNAL(pin.port)), &outside);
  avr_raise_irq(avr_io_getirq(avr_, code(AVR_IOCTL_IOPORT_GETIRQ(pin.port)), pin.bit), high);
}

bool SimulatedBoard::pinIsHigh(Pin pin) const {
  avr_ioport_state_t state{};
  avr_ioctl(avr_, code(AVR_IOCTL_IOPORT_GETSTATE(pin.port)), &state);
  return (state.ddr >> pin.bit & 1) && (state.port >> pin.bit & 1);
}

void SimulatedBoard::setAnalog_mV(int channel, unsigned value_mV) {
  avr_raise_irq(avr_io_getirq(avr_, code(AVR_IOCTL_ADC_GETIRQ), ADC_IRQ_ADC0 + channel), value_mV);
}

void SimulatedBoard::notePwmEdge(bool high) {
  if (high == pwmHigh_) return;
  if (high) ++pwmRises_, pwmHighSince_us_ = time_us();
  if (!high) pwmHigh_us_ += time_us() - pwmHighSince_us_;
  pwmHigh_ = high;
}

SimulatedBoard::Pwm SimulatedBoard::measurePwm(double window_us) {
  pwmHigh_us_ = 0, pwmRises_ = 0, pwmHighSince_us_ = time_us();
  run_us(window_us);
  if (pwmHigh_) pwmHigh_us_ += time_us() - pwmHighSince_us_;
  return {pwmHigh_us_ / window_us, 1e6 * pwmRises_ / window_us};
}

double SimulatedBoard::duty() const {
  const auto word = [this](std::uint16_t address) {
    return avr_->data[address] | avr_->data[address + 1] << 8;
  };
  avr_ioport_state_t state{};
  avr_ioctl(avr_, code(AVR_IOCTL_IOPORT_GETSTATE(kind_.pwm.port)), &state);
  if (!(state.ddr >> kind_.pwm.bit & 1)) return 0;
  const bool joined = avr_->data[kind_.icr - 6] & 0x80;
  if (!joined) return state.port >> kind_.pwm.bit & 1;
  return (word(kind_.ocr) + 1.0) / (word(kind_.icr) + 1.0);
}

std::uint32_t SimulatedBoard::addressOf(const std::string& name) const {
  for (const auto& [symbol, address] : symbols_)
    if (symbol == name) return address & 0xFFFF;  // without the linker's offset of data
  throw std::runtime_error("the sketch has no '" + name + "'");
}

std::uint8_t SimulatedBoard::byteAt(std::uint16_t address) const { return avr_->data[address]; }

std::uint32_t SimulatedBoard::variable(const std::string& name, int bytes) const {
  std::uint32_t value = 0;
  for (int i = 0; i < bytes; ++i)
    value |= static_cast<std::uint32_t>(avr_->data[addressOf(name) + static_cast<std::uint32_t>(i)])
             << (8 * i);
  return value;
}

void SimulatedBoard::setVariable(const std::string& name, int bytes, std::uint32_t value) {
  for (int i = 0; i < bytes; ++i)
    avr_->data[addressOf(name) + static_cast<std::uint32_t>(i)] = static_cast<std::uint8_t>(value >> (8 * i));
}

void SimulatedBoard::wrapClockIn(double before_us) {
  // micros() is (overflows << 8 | timer) * 4, in 32 bits. Forwards by less than half a turn each time: a
  // clock never runs back.
  for (std::uint32_t eighth = 1; eighth < 8; eighth += 2) {
    setVariable("timer0_overflow_count", 4, eighth << 19);
    run_us(3000);
  }
  setVariable("timer0_overflow_count", 4, (1U << 22) - static_cast<std::uint32_t>(before_us / 1024));
  run_us(3000);
}

int SimulatedBoard::stackAvailable() const { return ramEnd_ - static_cast<int>(addressOf("_end")); }

void SimulatedBoard::hang() {
  while (!(avr_->sreg[7])) run_us(1);
  hangingAt_ = avr_->pc;
  std::memcpy(saved_, avr_->flash + hangingAt_, 2);
  avr_->flash[hangingAt_] = 0xFF;  // rjmp to itself
  avr_->flash[hangingAt_ + 1] = 0xCF;
}

void SimulatedBoard::release() { std::memcpy(avr_->flash + hangingAt_, saved_, 2); }

std::string lineOf(const std::string& body) {
  unsigned sum = 0;
  for (const char c : body) sum ^= static_cast<unsigned char>(c);
  char tail[8];
  std::snprintf(tail, sizeof tail, "*%02X\n", sum);
  return body + tail;
}

}  // namespace detent::firmware
