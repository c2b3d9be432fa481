// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/live_warnings.h"

#include <algorithm>

namespace detent::playback {

namespace {

constexpr double shownFor_s = 3;         // a thing counted stays on the status line for so long
constexpr double toldEvery_s = 10;       // and makes a line of its own no more often than this
constexpr double rarestForces_Hz = 100;  // below, a press of 60 ms is six readings

}  // namespace

/// One thing that may be wrong.
struct LiveWarnings::Finding {
  bool counted;  ///< by `value` growing; else it is there while `value` is not 0
  std::uint64_t value;
  const char* title;
  const char* sentence;
};

std::vector<std::string> doubtsAbout(const LiveArguments& arguments, const Button& button,
                                     const DeviceProfile& profile, const PreparedProgram& program) {
  std::vector<std::string> doubts;
  const bool damped = std::any_of(button.states().begin(), button.states().end(),
                                  [](const ButtonState& s) { return !s.damping.empty(); });
  if (damped)
    doubts.push_back(
        "\"" + button.name() +
        "\" has damping, which vibration cannot give; `detent-play force` plays it on a force device");
  const PrepareSummary& s = program.summary;
  if (arguments.signalTarget && s.grains + s.pressJumps + s.releaseJumps + s.bottomOuts == 0)
    doubts.push_back("--signals-to: \"" + button.name() +
                     "\" has nothing to signal in this mode; choose another --mode");
  if (arguments.signalTarget && !arguments.pressFile.empty())
    doubts.push_back("--signals-to gets what sensor, keyboard and messages do, not the press that is played");
  if (!arguments.sensor.port.empty() && profile.sensor.weights == 0)
    doubts.push_back(
        "the sensor has no calibration: what it sends as counts is taken for newtons. Run `detent-play "
        "calibrate --sensor " +
        arguments.sensor.port + " -o my.device` and pass --profile my.device");
  return doubts;
}

std::vector<LiveWarnings::Finding> LiveWarnings::findingsIn(const PlayerStatus& s, double now_s) {
  if (rateSince_s_ < 0 || now_s - rateSince_s_ > 1) {
    messageRate_Hz_ =
        rateSince_s_ < 0 ? 0 : static_cast<double>(s.messageForces - messagesThen_) / (now_s - rateSince_s_);
    rateSince_s_ = now_s;
    messagesThen_ = s.messageForces;
  }
  const auto when = [](bool is) { return std::uint64_t{is ? 1U : 0U}; };
  return {
      {false, when(s.deviceLost), "DEVICE LOST", "the sound device is gone; playing goes on when it is back"},
      {false, when(s.sensor == SensorCondition::unplugged), "SENSOR UNPLUGGED",
       "the sensor's port is gone; check its cable, it is opened again when it is back"},
      {false, when(s.sensor == SensorCondition::silent), "SENSOR SILENT",
       "the sensor sends nothing; check that its firmware runs and that --baud fits"},
      {false, when(s.sensor == SensorCondition::stuck), "SENSOR STUCK",
       "the sensor has sent the same force for 10 s; lift the finger, check its wiring"},
      {false, when(s.sensorSendsCounts && !calibrated_), "COUNTS, NOT NEWTONS",
       "the sensor sends counts and the profile does not say what they are in newtons; run `detent-play "
       "calibrate`"},
      {true, s.xruns, "XRUNS", "dropouts (xruns); enlarge --buffer or close other programs"},
      {true, s.droppedReadings, "READINGS DROPPED",
       "readings came faster or waited longer than they can be played; send at most 2000 a second"},
      {true, s.droppedEvents, "EVENTS DROPPED",
       "jumps came closer than they can be felt; some were left out"},
      {true, s.rejectedReadings, "READINGS REJECTED",
       "readings that cannot be forces of a finger; see docs/serial-protocol.md"},
      {true, s.malformedLines + s.malformedMessages, "BAD LINES",
       "lines or messages that cannot be read; check --baud, docs/serial-protocol.md and docs/osc.md"},
      {true, s.limitedBlocks, "CLIPPING", "blocks louder than full scale were turned down; lower --gain"},
      {false, when(messageRate_Hz_ > 0 && messageRate_Hz_ < rarestForces_Hz), "FORCES TOO RARE",
       "forces by message come less than 100 times a second: fast presses are felt as steps; send 425 or "
       "more"},
  };
}

std::vector<std::string> LiveWarnings::look(const PlayerStatus& status, double now_s) {
  const std::vector<Finding> findings = findingsIn(status, now_s);
  std::vector<std::string> news;
  mostUrgent_.clear();
  for (std::size_t i = 0; i < findings.size() && i < kinds; ++i) {
    const Finding& f = findings[i];
    Watch& w = watches_[i];
    if (f.counted && f.value > w.seen) w.until_s = now_s + shownFor_s;
    w.seen = f.value;
    const bool active = f.counted ? now_s < w.until_s : f.value != 0;
    if (active && mostUrgent_.empty()) mostUrgent_ = f.title;
    const bool begins = f.counted ? f.value > w.told : active && !w.active;
    w.active = active;
    if (!begins || now_s - w.told_s < (f.counted ? toldEvery_s : 1)) continue;
    w.told_s = now_s;
    news.push_back(f.counted ? std::to_string(f.value - w.told) + " " + f.sentence : f.sentence);
    w.told = f.value;
  }
  return news;
}

}  // namespace detent::playback
