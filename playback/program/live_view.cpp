// SPDX-License-Identifier: GPL-3.0-or-later
// The terminal view of `detent-play BUTTON`.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <set>

#include <nlohmann/json.hpp>

#include "model/file/json_text.h"
#include "playback/device/steady_clock.h"
#include "playback/device/terminal.h"
#include "playback/program/live_command.h"
#include "playback/program/live_warnings.h"

namespace detent::playback {

namespace {

constexpr double frame_s = 0.05;
constexpr double tapHold_s = 0.15;
constexpr double gainStep = 1.1220184543;  // 1 dB
constexpr double highestGain = 10;
constexpr double traceLead_s = 0.2;
constexpr double traceTail_s = 0.6;

const char* viewName(SensorCondition condition) {
  switch (condition) {
    case SensorCondition::none:
      return "keyboard";
    case SensorCondition::starting:
      return "sensor starts";
    case SensorCondition::running:
      return "sensor runs";
    case SensorCondition::silent:
      return "SENSOR SILENT";
    case SensorCondition::stuck:
      return "SENSOR STUCK";
    case SensorCondition::unplugged:
      break;
  }
  return "SENSOR UNPLUGGED";
}

double peakForceOf(const Button& button) {
  double strongest = 0;
  for (const ButtonState& s : button.states())
    strongest = std::max(strongest, s.graph.press().forceRange_N().second);
  return std::max(1.25 * strongest, 0.1);
}

class LiveView {
 public:
  LiveView(const LiveArguments& a, const std::vector<Button>& buttons, const DeviceProfile& profile)
      : a_(a), buttons_(buttons), profile_(profile), settings_(a.feel.settings), gain_(a.gain) {}

  int run(const Cancelled& cancelled) {
    Result<LiveProgram> program = prepare();
    if (!program) return fail(program.failure());
    Result<std::unique_ptr<LivePlayer>> player = LivePlayer::start(a_.player, *program);
    if (!player) return fail(player.failure());
    player_ = std::move(*player);
    if (Result<Done> ok = connect(); !ok) return fail(ok.failure());
    std::fprintf(stderr,
                 "%s on %s. Space presses, Tab changes the button, + - gain, m mode, p placement, q ends.\n",
                 buttons_[current_].name().c_str(), player_->status().device.c_str());
    const double end_s = a_.seconds > 0 ? now_s() + a_.seconds : 1e300;
    {
      RawTerminal terminal;
      while (!cancelled() && !ended_ && now_s() < end_s) {
        if (const std::optional<char> key = terminal.key(frame_s)) handle(*key);
        follow();
      }
    }
    finish();  // first, because closing a device may take longer than a person waits after Ctrl-C
    player_.reset();
    return exitCode_;
  }

 private:
  Result<LiveProgram> prepare() {
    Result<PreparedProgram> prepared = prepareProgram(buttons_[current_], profile_, settings_);
    if (!prepared) return prepared.failure();
    for (const PrepareWarning& w : prepared->summary.warnings) warn(english(w.message));
    for (const Message& w : doubtsAbout(a_, buttons_[current_], profile_, *prepared)) warn(english(w));
    return prepareLive(*prepared, buttons_[current_], profile_, settings_);
  }

  /// Prints a line; on a terminal the status line is drawn again below it.
  static void tell(const std::string& sentence) {
    std::fprintf(stderr, "%s%s\n", errorIsTerminal() ? "\r\033[K" : "", sentence.c_str());
  }
  static void warn(const std::string& sentence) { tell("warning: " + sentence); }

  Result<Done> connect() {
    player_->setGain(gain_);
    if (!a_.sensor.port.empty()) {
      if (Result<Done> ok = player_->attachSensor(a_.sensor.port, a_.sensor.baud, profile_.sensor); !ok)
        return ok;
    }
    if (a_.udp) {
      if (Result<Done> ok = listen(*a_.udp, &LivePlayer::listenFudi, "FUDI"); !ok) return ok;
    }
    if (a_.osc) {
      if (Result<Done> ok = listen(*a_.osc, &LivePlayer::listenOsc, "OSC"); !ok) return ok;
    }
    if (a_.signalTarget) {
      if (Result<Done> ok = player_->sendSignals(a_.signalTarget->host, a_.signalTarget->port); !ok)
        return ok;
    }
    if (a_.pressFile.empty()) return Done{};
    Result<PressTrace> trace = readPressTrace(a_.pressFile);
    if (!trace) return trace.failure();
    Result<std::int64_t> started = player_->playTrace(*trace, traceLead_s);
    if (!started) return started.failure();
    tracing_ = true;
    return Done{};
  }

  Result<Done> listen(const Endpoint& endpoint,
                      Result<std::uint16_t> (LivePlayer::*open)(std::uint16_t, const std::string&),
                      const char* name) {
    const Result<std::uint16_t> port = ((*player_).*open)(endpoint.port, endpoint.host);
    if (!port) return port.failure();
    std::fprintf(stderr, "%s on UDP port %u of %s\n", name, *port, endpoint.host.c_str());
    return Done{};
  }

  void handle(char key) {
    switch (key) {
      case ' ':
        player_->fingerTap(a_.fingerPeak_N > 0 ? a_.fingerPeak_N : peakForceOf(buttons_[current_]),
                           tapHold_s);
        break;
      case '\t':
        current_ = (current_ + 1) % buttons_.size();
        exchange();
        break;
      case 'm':
        settings_.mode = static_cast<FeedbackMode>((static_cast<int>(settings_.mode) + 1) % 4);
        exchange();
        break;
      case 'p':
        settings_.placement = settings_.placement == EventPlacement::atOnce ? EventPlacement::timeStamped
                                                                            : EventPlacement::atOnce;
        exchange();
        break;
      case '+':
      case '=':
        player_->setGain(gain_ = std::min(gain_ * gainStep, highestGain));
        break;
      case '-':
        player_->setGain(gain_ /= gainStep);
        break;
      case 'q':
      case 4:  // Ctrl-D
        ended_ = true;
        break;
      default:
        break;
    }
  }

  void exchange() {
    Result<LiveProgram> program = prepare();
    if (program) {
      player_->setProgram(*program);
    } else {
      exitCode_ = fail(program.failure());
      ended_ = true;
    }
  }

  void follow() {
    for (const EngineEvent& e : player_->takeEvents()) {
      if (e.kind == EventKind::pressJump) last_ = "press jump";
      if (e.kind == EventKind::releaseJump) last_ = "release jump";
      if (e.kind == EventKind::bottomOut) last_ = "bottom-out";
    }
    if (tracing_ && !player_->tracePlaying()) {
      tracing_ = false;
      if (a_.seconds <= 0) traceEnd_s_ = now_s() + traceTail_s;
    }
    if (traceEnd_s_ > 0 && now_s() > traceEnd_s_) ended_ = true;
    const PlayerStatus status = player_->status();
    for (const LiveWarning& w : warnings_.update(status, now_s())) {
      warn(english(messageOf(w)));
      warned_.insert(nameOf(w.code));
    }
    if (lost_ && !status.deviceLost)
      tell("the sound device is back, at " + std::to_string(std::lround(status.sampleRate_Hz)) +
           " samples per second");
    lost_ = status.deviceLost;
    if (!status.sensorGreeting.empty() && status.sensorGreeting != greeting_) {
      greeting_ = status.sensorGreeting;
      tell("sensor: " + greeting_);
    }
    if (errorIsTerminal()) draw(status);
  }

  /// "felt 38 dB"; "felt ~38 dB" if the device's level was not measured.
  std::string feltWords(const PlayerStatus& s) const {
    if (!(s.felt_dB > 0)) return "felt  - dB";
    char words[32];
    std::snprintf(words, sizeof words, "felt %s%.0f dB", profile_.fullScale_dB ? "" : "~", s.felt_dB);
    return words;
  }

  /// " 47 mm/s": speed of the press, for a button with graphs at several speeds.
  static std::string speedWords(const PlayerStatus& s) {
    if (!(s.speed_mm_per_s > 0)) return "";
    char words[32];
    std::snprintf(words, sizeof words, " %3.0f mm/s", s.speed_mm_per_s);
    return words;
  }

  void draw(const PlayerStatus& s) {
    const std::size_t bars = static_cast<std::size_t>(std::lround(std::clamp(s.level, 0.0, 1.0) * 10));
    char text[400];
    std::snprintf(
        text, sizeof text,
        "%s%s%s%s %5.2f N %6.3f mm%s %s%s |%-10s| %s gain %+.0f dB %s %s grains %llu jumps %llu %s load "
        "%2.0f%% xruns %llu %s",
        warnings_.mostUrgent() ? titleOf(*warnings_.mostUrgent()) : "", warnings_.mostUrgent() ? " | " : "",
        buttons_[current_].name().substr(0, 20).c_str(),
        buttons_[current_].selfLocking() ? (s.state == 0 ? " (1)" : " (2)") : "", s.force_N,
        s.displacement_mm, speedWords(s).c_str(), s.releasing ? "up  " : "down", s.contact ? "*" : " ",
        std::string(bars, '#').c_str(), feltWords(s).c_str(), 20 * std::log10(std::max(gain_, 1e-6)),
        nameOf(settings_.mode), settings_.placement == EventPlacement::atOnce ? "fast" : "time-stamped",
        static_cast<unsigned long long>(s.counts.grains),
        static_cast<unsigned long long>(s.counts.pressJumps + s.counts.releaseJumps), last_, 100 * s.load,
        static_cast<unsigned long long>(s.xruns), viewName(s.sensor));
    std::string line(text);
    line.resize(static_cast<std::size_t>(std::max(terminalColumns() - 1, 20)), ' ');
    std::fprintf(stderr, "\r%s", line.c_str());
  }

  void finish() {
    const PlayerStatus s = player_->status();
    std::fprintf(
        stderr,
        "\n%llu grains, %llu press jumps, %llu release jumps, %llu bottom-outs, %llu xruns, load %.1f %%\n",
        static_cast<unsigned long long>(s.counts.grains),
        static_cast<unsigned long long>(s.counts.pressJumps),
        static_cast<unsigned long long>(s.counts.releaseJumps),
        static_cast<unsigned long long>(s.counts.bottomOuts), static_cast<unsigned long long>(s.xruns),
        100 * s.meanLoad);
    if (!a_.json) return;
    const nlohmann::ordered_json json{{"status", "ok"},
                                      {"device", s.device},
                                      {"sample_rate_Hz", s.sampleRate_Hz},
                                      {"block_frames", s.blockFrames},
                                      {"grains", s.counts.grains},
                                      {"press_jumps", s.counts.pressJumps},
                                      {"release_jumps", s.counts.releaseJumps},
                                      {"bottom_outs", s.counts.bottomOuts},
                                      {"triggers", s.counts.triggers},
                                      {"late", s.counts.late},
                                      {"suppressed", s.counts.suppressed},
                                      {"xruns", s.xruns},
                                      {"device_losses", s.deviceLosses},
                                      {"mean_load", s.meanLoad},
                                      {"rejected_readings", s.rejectedReadings},
                                      {"malformed_lines", s.malformedLines},
                                      {"sensor_reconnects", s.sensorReconnects},
                                      {"signal_messages", s.signalMessages},
                                      {"malformed_messages", s.malformedMessages},
                                      {"dropped_readings", s.droppedReadings},
                                      {"dropped_events", s.droppedEvents},
                                      {"clipped_blocks", s.limitedBlocks},
                                      {"sensor_noise_N", s.sensorNoise_N},
                                      {"warning_codes", warned_}};
    std::cout << jsonText(json) << std::endl;
  }

  const LiveArguments& a_;
  const std::vector<Button>& buttons_;
  const DeviceProfile& profile_;
  PlaybackSettings settings_;
  double gain_;
  std::size_t current_ = 0;
  std::unique_ptr<LivePlayer> player_;
  LiveWarnings warnings_{profile_.sensor.weights > 0};
  std::string greeting_;
  std::set<std::string> warned_;  // codes of all reported warnings
  const char* last_ = "";
  bool ended_ = false, tracing_ = false, lost_ = false;
  double traceEnd_s_ = 0;
  int exitCode_ = 0;
};

}  // namespace

int runLive(const LiveArguments& arguments, const std::vector<Button>& buttons, const DeviceProfile& profile,
            const Cancelled& cancelled) {
  return LiveView(arguments, buttons, profile).run(cancelled);
}

}  // namespace detent::playback
