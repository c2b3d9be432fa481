// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/serial_force_device.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "playback/device/round_trips.h"
#include "playback/device/sensor_line.h"
#include "playback/device/steady_clock.h"

namespace detent::playback {

namespace {

constexpr double serialAnswer_s = 0.5;  // longest wait for an answer outside of the loop
constexpr double bootPause_s = 2.0;     // an Arduino resets when its port is opened
constexpr double micro = 1e-6, nmPerMm = 1e6;

constexpr int protocol = 2;  // protocol version in which the device itself has limits
constexpr double silence_s = 0.015, silentPeriods = 5, longestSilence_s = 0.05;
constexpr double tableSilence =
    0.8;  // share of the device's own timeout, because our times and its clock differ a little
// Without answers a table continues for this many questions, or round trips of a slow link.
constexpr std::uint32_t unansweredQuestions = 3;
constexpr double unheard_s = 0.010, unheardTrips = 3, longestUnheardEver_s = 0.05;
// after these questions the line is sent again, answered or not
constexpr std::int32_t questionsForALine = 8;
constexpr int stoppedState = 1, unlimitedState = 2, deadCountState = 3;  // states that an answer reports

/// Fields between commas. A line with more fields than fit is not of this protocol.
struct Fields {
  std::array<std::string_view, 8> all{};
  std::size_t count = 0;
  explicit Fields(std::string_view text) {
    for (; count < all.size(); text.remove_prefix(text.find(',') + 1)) {
      all[count++] = text.substr(0, text.find(','));
      if (text.find(',') == std::string_view::npos) return;
    }
    count = 0;
  }
  std::string_view operator[](std::size_t i) const { return all[i]; }
};

template <class Integer>
bool read(std::string_view text, Integer& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

long long whole(double value) { return std::llround(value); }

}  // namespace

std::string forceLine(const std::string& body) {
  std::array<char, 8> sum{};
  std::snprintf(sum.data(), sum.size(), "*%02X\n", static_cast<unsigned>(lineChecksum(body)));
  return body + sum.data();
}

std::optional<std::string_view> forceLineBody(std::string_view line) {
  const std::size_t star = line.rfind('*');
  unsigned sum = 0;
  if (star == std::string_view::npos || line.size() != star + 3) return {};
  const auto [end, error] = std::from_chars(line.data() + star + 1, line.data() + line.size(), sum, 16);
  if (error != std::errc() || end != line.data() + line.size() || sum != lineChecksum(line.substr(0, star)))
    return {};
  return line.substr(0, star);
}

std::string forceLimitLine(const ForceLimits& limits, double period_s) {
  std::string line = "L";
  for (const double value :
       {limits.force_N / micro, limits.slew_N_per_s * 1e3, limits.speed_mm_per_s * 1e3,
        limits.startRamp_s * 1e3, std::clamp(silentPeriods * period_s, silence_s, longestSilence_s) * 1e3}) {
    line += "," + std::to_string(whole(std::min(value, 2e9)));
  }
  return line;
}

SerialForceDevice::SerialForceDevice(SerialLink link, double period_s, const ForceLimits& limits)
    : link_(std::move(link)),
      wait_s_(answerWaitOfPeriod * period_s),
      limits_(limits),
      limitLine_(forceLimitLine(limits, period_s)) {}

Result<std::unique_ptr<SerialForceDevice>> SerialForceDevice::open(const std::string& port, unsigned baud,
                                                                   double period_s,
                                                                   const ForceLimits& limits) {
  Result<SerialLink> link = SerialLink::open(port, baud);
  if (!link) return link.failure();
  std::unique_ptr<SerialForceDevice> device(new SerialForceDevice(*std::move(link), period_s, limits));
  auto problem = Message("does not answer");
  for (const double deadline_s = now_s() + bootPause_s; now_s() < deadline_s;) {
    if (!device->hello(problem)) continue;
    if (device->info_.force_N < limits.force_N * 0.999) {
      return Failure{
          FailureCode::wrongUsage,
          port,
          "",
          Message("the device can produce only %1, less than the playback was prepared for",
                  newtons(device->info_.force_N)),
          {{RemedyKind::advice, Message("Set this as the largest force and start again")},
           {RemedyKind::advice, Message("On the command line: --max-N %1", device->info_.force_N)}}};
    }
    if (device->limited()) return device;
    problem = Message(
        "the device does not confirm the limits that it was given, so nothing would limit its force if this "
        "program failed");
  }
  return Failure{FailureCode::deviceTrouble, port, "", problem,
                 Message("Check that the firmware follows docs/reference/force-protocol.md and that the baud "
                         "rate is the same")};
}

void SerialForceDevice::send(std::string_view body) {
  std::array<char, 100> line{};
  const int length = std::snprintf(line.data(), line.size(), "%.*s*%02X\n", static_cast<int>(body.size()),
                                   body.data(), static_cast<unsigned>(lineChecksum(body)));
  link_.send({line.data(), static_cast<std::size_t>(length)});
}

bool SerialForceDevice::hello(Message& problem) {
  send("?");
  for (const double deadline_s = now_s() + serialAnswer_s;;) {
    const std::optional<std::string_view> line = link_.line(deadline_s);
    if (!line) return false;
    const std::optional<std::string_view> body = forceLineBody(*line);
    if (!body) {
      if (const std::string quoted = quotable(*line); quoted.empty()) {
        problem = Message("the device gives an answer that is not part of the protocol");
      } else {
        problem = Message("the device answers \"%1\", which is not part of the protocol", quoted);
      }
      continue;
    }
    const Fields f(*body);
    long long step_nm = 0, force_uN = 0;
    std::uint32_t rate_Hz = 0;
    int version = 0;
    if (f.count < 6 || f[0] != "I" || !read(f[2], step_nm) || !read(f[3], force_uN) || !read(f[4], rate_Hz) ||
        !read(f[5], info_.tableRows) || step_nm <= 0 || force_uN <= 0) {
      continue;
    }
    if (f.count < 7 || !read(f[6], version) || version < protocol) {
      problem = Message(
          "the device uses an older protocol without its own force limit: install samples/firmware/force1d "
          "again");
      continue;
    }
    info_.name = f[1];
    info_.step_mm = static_cast<double>(step_nm) / nmPerMm;
    info_.force_N = static_cast<double>(force_uN) * micro;
    info_.rate_Hz = rate_Hz;
    return true;
  }
}

// Sets the limits and reads them back. The device may choose a shorter timeout than requested.
bool SerialForceDevice::limited() {
  send(limitLine_);
  for (const double deadline_s = now_s() + serialAnswer_s; !limitHeld_;) {
    const std::optional<std::string_view> line = link_.line(deadline_s);
    if (!line) return false;
    ForceReading ignored;
    take(*line, ignored);
  }
  return true;
}

bool SerialForceDevice::acknowledged(const std::string& line) {
  send(line);
  for (const double deadline_s = now_s() + serialAnswer_s;;) {
    const std::optional<std::string_view> answer = link_.line(deadline_s);
    if (!answer) return false;
    const std::optional<std::string_view> body = forceLineBody(*answer);
    if (body && *body == "A") return true;
    if (body && body->starts_with("N")) return false;
  }
}

std::vector<std::string> forceTableLines(const ForceProgram& program, std::uint32_t mostRows) {
  const ForceStateTable& t = program.states[0];
  const std::uint32_t rows = std::min(mostRows, t.rowCount);
  const double spacing_mm = t.spacing_mm * (t.rowCount - 1) / (rows - 1);
  const auto text = [](long long value) { return "," + std::to_string(value); };
  std::vector<std::string> lines{
      "T" + text(rows) + text(whole(t.first_mm * nmPerMm)) + text(whole(spacing_mm * nmPerMm)) +
      text(whole(program.law.playRadius_mm * nmPerMm)) + text(whole(t.bottomOutSlope_N_per_mm / micro)) +
      text(whole(program.limits.force_N / micro))};
  for (std::uint32_t i = 0; i < rows; ++i) {
    const auto at =
        static_cast<std::uint32_t>(std::lround(static_cast<double>(i) * (t.rowCount - 1) / (rows - 1)));
    const ForceRow& r = t.rows[at];
    lines.push_back("R" + text(i) + text(whole(static_cast<double>(r.press_N) / micro)) +
                    text(whole(static_cast<double>(r.release_N) / micro)) +
                    text(whole(static_cast<double>(r.damping_Ns_per_mm) / micro)));
  }
  lines.push_back("G");
  return lines;
}

std::optional<Failure> refusedAsTable(const ForceProgram& program, const std::string& device) {
  if (program.states[0].speedCount > 1) {
    return Failure{
        FailureCode::wrongUsage, device, "",
        Message("the device can hold the force of only one speed; this button has graphs at %1 speeds",
                program.states[0].speedCount),
        Message("Leave the upload out; this computer then computes the force. Or upload a button that "
                "has a single speed (detent-graph convert makes one)")};
  }
  if (program.stateCount != 1) {
    return Failure{FailureCode::wrongUsage, device, "",
                   Message("the device can run only one state; this button has %1", program.stateCount),
                   Message("Switch the upload of the force table off, so that this computer computes the "
                           "force of self-locking buttons")};
  }
  return {};
}

Result<Done> SerialForceDevice::upload(const ForceProgram& program) {
  Failure refused{FailureCode::deviceTrouble, info_.name, "",
                  Message("the device does not accept the force table"),
                  Message("Check the firmware and the cable, or switch the upload off: this computer "
                          "computes the force then")};
  if (std::optional<Failure> other = refusedAsTable(program, info_.name)) return *std::move(other);
  if (info_.tableRows < 2) {
    return Failure{
        FailureCode::wrongUsage, info_.name, "", Message("the device cannot hold a force table"),
        Message("Switch the upload of the force table off, so that this computer computes the force")};
  }
  const double requested_N = program.limits.force_N;
  if (!(requested_N > 0) || requested_N > limits_.force_N * (1 + 1e-9)) {
    return Failure{FailureCode::wrongUsage, info_.name, "",
                   Message("the device was opened with a limit of %1, but the table has %2 or no limit",
                           newtons(limits_.force_N), newtons(requested_N)),
                   Message("Prepare the button for the limit of the device")};
  }
  table_ = forceTableLines(program, info_.tableRows);
  for (const std::string& line : table_) {
    if (!acknowledged(line)) return refused;
  }
  ownLaw_ = true;
  acknowledgedLines_ = table_.size();
  // Forgotten, so that from now on only the device's clock reveals a pause that ended the table.
  heardTime_us_ = -1;
  ++sequence_;
  sendOrders(ForceCommand{});
  ForceReading begun;
  begun.fresh = false;
  for (const double deadline_s = now_s() + serialAnswer_s; !begun.fresh;) {
    const std::optional<std::string_view> line = link_.line(deadline_s);
    if (!line) return refused;
    take(*line, begun);
  }
  zeroLost_ = begun.zero == ForceReading::Zero::lost;
  return Done{};
}

void SerialForceDevice::setProgram(const ForceProgram& program) {
  if (table_.empty()) return;
  table_ = forceTableLines(program, info_.tableRows);
  if (ownLaw_) beginTable();
}

void SerialForceDevice::rearm() {
  arming_ = true;
  tableDue_ = !table_.empty() && !ownLaw_;
}

void SerialForceDevice::beginTable() {
  acknowledgedLines_ = 0;
  lineSince_ = sequence_ + 1;
  lineSent_ = sequence_;
}

// A line is sent once, and again if the question sent with it was answered without an acknowledgement.
// Sending it with each question would exceed the capacity of a serial port of 230,400 baud, whose queue would
// then grow until nothing arrives.
bool SerialForceDevice::lineIsDue() const {
  const auto sent = static_cast<std::int32_t>(lineSent_ - lineSince_);
  return sent < 0 || static_cast<std::int32_t>(heard_ - lineSent_) >= 0 ||
         static_cast<std::int32_t>(sequence_ - lineSent_) >= questionsForALine;
}

// Sends "no force" before the first line of another table, because a firmware might otherwise keep its last
// force. The device accepts repeated lines.
void SerialForceDevice::sendTableLine() {
  if (acknowledgedLines_ == 0) send("X");
  send(table_[acknowledgedLines_]);
  lineSent_ = sequence_;
}

// Answers arrive in the order of the questions, so an acknowledgement belongs to the question whose answer
// follows it.
void SerialForceDevice::noteAnswer(std::uint32_t sequence, long long time_us) {
  const bool ofThisLine = static_cast<std::int32_t>(sequence - lineSince_) >= 0;
  if (std::exchange(lineTaken_, false) && ofThisLine && acknowledgedLines_ < table_.size()) {
    ++acknowledgedLines_;
    lineSince_ = sequence_ + 1;
    lineSent_ = sequence_;
  }
  heard_ = sequence;
  heardAt_s_ = now_s();
  if (withdrawn_ && static_cast<std::int32_t>(sequence - withdrawnSince_) >= 0) {
    withdrawn_ = false;
    beginTable();
  }
  const long long before_us = std::exchange(heardTime_us_, time_us);
  if (before_us < 0 || !ownLaw_ || acknowledgedLines_ < table_.size()) return;
  // The device ends its table if it receives nothing for longer than its timeout. Its clock may wrap.
  if (micro * static_cast<std::uint32_t>(time_us - before_us) > silence_s_) beginTable();
}

double SerialForceDevice::longestUnheard_s() const {
  return std::min(std::max(unheard_s, unheardTrips * roundTrip_s_), longestUnheardEver_s);
}

// The device cannot be monitored any more. An F with zero force ends its table at once; an H would keep the
// table running.
void SerialForceDevice::withdrawLaw() {
  const bool unheard = sequence_ - heard_ > unansweredQuestions && now_s() - heardAt_s_ > longestUnheard_s();
  if (!unheard || !ownLaw_ || withdrawn_ || acknowledgedLines_ < table_.size()) return;
  withdrawn_ = true;
  withdrawnSince_ = sequence_;
  ++counts_.withdrawn;
}

void SerialForceDevice::loseLaw() {
  ownLaw_ = withdrawn_ = false;
  zeroLost_ = true;
}

// A device that was disconnected has no table, no limits and no zero.
bool SerialForceDevice::isBack() {
  if (!link_.reopen()) return false;
  ++counts_.reconnects;
  limitHeld_ = false;
  loseLaw();
  heardTime_us_ = -1;
  return true;
}

// Makes the device's own law follow the engine's state. Orders that were lost are repeated with the next
// state.
void SerialForceDevice::sendOrders(const ForceCommand& command) {
  if (!limitHeld_) send(limitLine_);
  if (command.halted) {
    send("S");
    stopSent_ = true;
  } else if (stopSent_ || arming_) {
    send("U");
    stopSent_ = arming_ = false;
    armedSince_ = sequence_;
  }
  std::array<char, 64> body{};
  int length = 0;
  if (ownLaw_ && !withdrawn_) {
    if (acknowledgedLines_ < table_.size() && lineIsDue()) sendTableLine();
    length = std::snprintf(body.data(), body.size(), "H,%u", sequence_);
  } else {
    // With an uploaded table the device computes the force, so the host sends none.
    const double force_N = command.halted || !limitHeld_ || !table_.empty() ? 0 : command.force_N;
    length = std::snprintf(body.data(), body.size(), "F,%u,%lld", sequence_, whole(force_N / micro));
  }
  send({body.data(), static_cast<std::size_t>(length)});
}

SerialForceDevice::Answer SerialForceDevice::take(std::string_view line, ForceReading& reading) {
  const std::optional<std::string_view> text = forceLineBody(line);
  if (!text) {
    lineTaken_ = false;  // the acknowledgement may have belonged to this answer
    return Answer::none;
  }
  const bool refused = text->starts_with("N,");
  if (*text == "A") lineTaken_ = true;
  if (refused && ownLaw_) loseLaw();
  if (refused || *text == "A" || text->starts_with("I,")) return Answer::other;
  if (text->starts_with("L,")) {
    const std::size_t silence = limitLine_.rfind(',');
    long long requested_ms = 0, holds_ms = 0;
    limitHeld_ = text->size() > silence &&
                 text->substr(0, silence + 1) == limitLine_.substr(0, silence + 1) &&
                 read(std::string_view(limitLine_).substr(silence + 1), requested_ms) &&
                 read(text->substr(silence + 1), holds_ms) && holds_ms > 0 && holds_ms <= requested_ms;
    silence_s_ = tableSilence * 1e-3 * static_cast<double>(holds_ms);
    return Answer::other;
  }
  const Fields f(*text);
  std::uint32_t sequence = 0;
  long long time_us = 0, position_nm = 0;
  int state = 0;
  if (f.count != 5 || f[0] != "P" || !read(f[1], sequence) || !read(f[2], time_us) ||
      !read(f[3], position_nm) || !read(f[4], state)) {
    return Answer::none;
  }
  // Invalid numbers, or a clock that stands still, say nothing about the handle: the device counts as silent,
  // so that its table's force is withdrawn.
  const bool isNew = static_cast<std::int32_t>(sequence_ - sequence) >= 0 &&
                     static_cast<std::int32_t>(sequence - heard_) > 0 && time_us != heardTime_us_;
  if (!isNew) {
    lineTaken_ = false;
    return Answer::old;
  }
  noteAnswer(sequence, time_us);
  // An answer to an earlier question is used only while the device runs a table.
  if (sequence != sequence_ && table_.empty()) return Answer::old;
  if (state == unlimitedState && limitHeld_) {  // the device was reset meanwhile
    limitHeld_ = false;
    loseLaw();
  }
  const bool sinceArmed = static_cast<std::int32_t>(sequence - armedSince_) >= 0;
  reading.stopped = state == stoppedState && !stopSent_ && sinceArmed;
  reading.deadCount = state == deadCountState && !arming_ && sinceArmed;
  reading.position_mm = last_mm_ = static_cast<double>(position_nm) / nmPerMm;
  reading.fresh = true;
  if (std::exchange(zeroLost_, false)) reading.zero = ForceReading::Zero::lost;
  return Answer::reading;
}

std::optional<double> SerialForceDevice::measureRoundTrip_s() {
  RoundTrips trips;
  while (trips.goOn()) {
    ++sequence_;
    const double requested_s = now_s();
    sendOrders(ForceCommand{});
    ForceReading reading;
    reading.fresh = false;
    while (!reading.fresh) {
      const std::optional<std::string_view> line = link_.line(requested_s + slowestRoundTrip_s);
      if (!line) break;
      take(*line, reading);
    }
    trips.add(now_s() - requested_s);
  }
  roundTrip_s_ = trips.usual_s();
  return roundTrip_s_;
}

bool SerialForceDevice::setPace(double period_s) {
  wait_s_ = answerWaitOfPeriod * period_s;
  const std::string line = forceLimitLine(limits_, period_s);
  if (line == limitLine_) return true;
  limitLine_ = line;
  limitHeld_ = false;
  return limited();
}

ForceReading SerialForceDevice::exchange(const ForceCommand& command) {
  ForceReading reading;
  reading.position_mm = last_mm_;
  reading.fresh = false;
  ++counts_.exchanges;
  if (!link_.isOpen()) {
    isBack();
    return reading;
  }
  if (tableDue_ && limitHeld_) {
    tableDue_ = false;
    ownLaw_ = true;
    beginTable();
  }
  ++sequence_;
  withdrawLaw();
  sendOrders(command);
  for (const double deadline_s = now_s() + wait_s_;;) {
    const std::optional<std::string_view> line = link_.line(deadline_s);
    if (!line) {
      counts_.late += reading.fresh ? 0 : 1;
      return reading;
    }
    switch (take(*line, reading)) {
      case Answer::reading:
        if (heard_ == sequence_) return reading;
        break;
      case Answer::old:
        ++counts_.repeated;
        break;
      case Answer::none:
        ++counts_.malformed;
        break;
      case Answer::other:
        break;
    }
  }
}

SerialForceDevice::~SerialForceDevice() {
  send("X");                 // if the link is gone, the firmware's own watchdog removes the force
  if (stopSent_) send("U");  // only now, when there is no table that could run
}

}  // namespace detent::playback
