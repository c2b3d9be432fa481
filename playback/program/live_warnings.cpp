// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/live_warnings.h"

#include <algorithm>

namespace detent::playback {

namespace {

constexpr double shownFor_s = 3;         // time for which a counted event stays on the status line
constexpr double reportedEvery_s = 10;   // least time between two separate lines about it
constexpr double rarestForces_Hz = 100;  // with fewer, a press of 60 ms has only six readings

/// Texts of one warning.
struct Wording {
  LiveWarningCode code;
  bool counted;  ///< true: events are counted; false: a condition is present or not
  const char* name;
  const char* title;
  const char* words;
};

constexpr std::array<Wording, liveWarningCodes> wordings{{
    {LiveWarningCode::deviceLost, false, "device-lost", "DEVICE LOST",
     "the sound device is gone; playing goes on when it is back"},
    {LiveWarningCode::sensorUnplugged, false, "sensor-unplugged", "SENSOR UNPLUGGED",
     "the sensor's port is gone; check its cable, it is opened again when it is back"},
    {LiveWarningCode::sensorSilent, false, "sensor-silent", "SENSOR SILENT",
     "the sensor sends nothing; check that its firmware runs and that --baud fits"},
    {LiveWarningCode::sensorStuck, false, "sensor-stuck", "SENSOR STUCK",
     "the sensor has sent the same force for 10 s; lift the finger, check its wiring"},
    {LiveWarningCode::countsNotNewtons, false, "counts-not-newtons", "COUNTS, NOT NEWTONS",
     "the sensor sends counts and the profile does not say what they are in newtons; run `detent-play "
     "calibrate`"},
    {LiveWarningCode::xruns, true, "xruns", "XRUNS",
     "%1 dropouts (xruns); enlarge --buffer or close other programs"},
    {LiveWarningCode::readingsDropped, true, "readings-dropped", "READINGS DROPPED",
     "%1 readings came faster or waited longer than they can be played; send at most 2000 a second"},
    {LiveWarningCode::eventsDropped, true, "events-dropped", "EVENTS DROPPED",
     "%1 jumps came closer than they can be felt; some were left out"},
    {LiveWarningCode::readingsRejected, true, "readings-rejected", "READINGS REJECTED",
     "%1 readings that cannot be forces of a finger; see docs/reference/serial-protocol.md"},
    {LiveWarningCode::badLines, true, "bad-lines", "BAD LINES",
     "%1 lines or messages that cannot be read; check --baud, docs/reference/serial-protocol.md and "
     "docs/reference/osc.md"},
    {LiveWarningCode::clipping, true, "clipping", "CLIPPING",
     "%1 blocks louder than full scale were turned down; lower --gain"},
    {LiveWarningCode::forcesTooRare, false, "forces-too-rare", "FORCES TOO RARE",
     "forces by message come less than 100 times a second: fast presses are felt as steps; send 425 or "
     "more"},
}};

const Wording& wordingOf(LiveWarningCode code) { return wordings[static_cast<std::size_t>(code)]; }

}  // namespace

const char* nameOf(LiveWarningCode code) { return wordingOf(code).name; }
const char* titleOf(LiveWarningCode code) { return wordingOf(code).title; }
Message messageOf(const LiveWarning& warning) {
  return Message::of(wordingOf(warning.code).words, {MessageValue(warning.count)});
}

std::vector<Message> doubtsAbout(const LiveArguments& arguments, const Button& button,
                                 const DeviceProfile& profile, const PreparedProgram& program) {
  std::vector<Message> doubts;
  const bool damped = std::any_of(button.states().begin(), button.states().end(),
                                  [](const ButtonState& s) { return !s.damping.empty(); });
  if (damped)
    doubts.push_back(
        {"\"%1\" has damping, which vibration cannot give; `detent-play force` plays it on a force device",
         button.name()});
  const PrepareSummary& s = program.summary;
  if (arguments.signalTarget && s.grains + s.pressJumps + s.releaseJumps + s.bottomOuts == 0)
    doubts.push_back(
        {"--signals-to: \"%1\" has nothing to signal in this mode; choose another --mode", button.name()});
  if (arguments.signalTarget && !arguments.pressFile.empty())
    doubts.emplace_back(
        "--signals-to gets what sensor, keyboard and messages do, not the press that is played");
  if (!arguments.sensor.port.empty() && profile.sensor.weights == 0)
    doubts.push_back(
        {"the sensor has no calibration: what it sends as counts is taken for newtons. Run `detent-play "
         "calibrate --sensor %1 -o my.device` and pass --profile my.device",
         arguments.sensor.port});
  return doubts;
}

LiveWarnings::Values LiveWarnings::valuesIn(const PlayerStatus& s, double now_s) {
  if (rateSince_s_ < 0 || now_s - rateSince_s_ > 1) {
    messageRate_Hz_ =
        rateSince_s_ < 0 ? 0 : static_cast<double>(s.messageForces - messagesThen_) / (now_s - rateSince_s_);
    rateSince_s_ = now_s;
    messagesThen_ = s.messageForces;
  }
  const auto when = [](bool is) { return std::uint64_t{is ? 1U : 0U}; };
  return {when(s.deviceLost),
          when(s.sensor == SensorCondition::unplugged),
          when(s.sensor == SensorCondition::silent),
          when(s.sensor == SensorCondition::stuck),
          when(s.sensorSendsCounts && !calibrated_),
          s.xruns,
          s.droppedReadings,
          s.droppedEvents,
          s.rejectedReadings,
          s.malformedLines + s.malformedMessages,
          s.limitedBlocks,
          when(messageRate_Hz_ > 0 && messageRate_Hz_ < rarestForces_Hz)};
}

std::optional<LiveWarning> LiveWarnings::newsOf(LiveWarningCode code, std::uint64_t value, double now_s) {
  Watch& w = watches_[static_cast<std::size_t>(code)];
  const bool counted = wordingOf(code).counted;
  if (counted && value > w.seen) w.until_s = now_s + shownFor_s;
  w.seen = value;
  const bool active = counted ? now_s < w.until_s : value != 0;
  if (active && !mostUrgent_) mostUrgent_ = code;
  const bool begins = counted ? value > w.reported : active && !w.active;
  w.active = active;
  if (!begins || now_s - w.reported_s < (counted ? reportedEvery_s : 1)) return {};
  w.reported_s = now_s;
  const std::uint64_t before = w.reported;
  w.reported = value;
  return LiveWarning{code, counted ? value - before : 0};
}

std::vector<LiveWarning> LiveWarnings::update(const PlayerStatus& status, double now_s) {
  const Values values = valuesIn(status, now_s);
  std::vector<LiveWarning> news;
  mostUrgent_.reset();
  for (const Wording& w : wordings) {
    if (const auto one = newsOf(w.code, values[static_cast<std::size_t>(w.code)], now_s))
      news.push_back(*one);
  }
  return news;
}

}  // namespace detent::playback
