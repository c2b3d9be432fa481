// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of playback in one run: Detent beside Pure Data on JACK's dummy driver, sensor to onset,
// evenness in time, render speed, share of the callback, guarded calls.
//
//   detent_playback_bench [--short] [OUT.md]
//
// Prints the table and, with OUT.md, writes it. --short: a tenth of the trials, to see that everything runs.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "model/file/button_file.h"
#include "playback/device/audio_device.h"
#include "playback/device/signal_server.h"
#include "playback/device/steady_clock.h"
#include "playback/measurement/latency_statistics.h"
#include "playback/playback.h"
#include "tests/playback/device/jack_rig.h"
#include "tests/playback/device/pty_sensor.h"
#include "tests/playback/realtime/callback_guard.h"
#include "tests/playback/sample_buttons.h"

using namespace detent;
using namespace detent::playback;
using namespace detent::test;

namespace {

constexpr float onsetLevel = 1e-4f;
constexpr int warmUps = 5;
constexpr std::uint16_t pdPort = 9001;

std::string report;

void put(const std::string& line) {
  std::printf("%s\n", line.c_str());
  std::fflush(stdout);
  report += line + "\n";
}

template <class... Values>
std::string text(const char* format, Values... values) {
  char line[300];
  std::snprintf(line, sizeof line, format, values...);
  return line;
}

struct Spread {
  LatencyStatistics s;
  std::string cells() const {
    return text("%.2f | %.2f | %.2f | %.2f | %zu | %zu", 1e3 * s.median_s, 1e3 * s.p99_s,
                1e3 * (s.p95_s - s.p5_s), 1e3 * s.sd_s, s.n, s.lost);
  }
};

/// Waits for the armed onset; negative if none came.
double onsetWithin(JackListener& listener, double seconds) {
  for (const double end = now_s() + seconds; now_s() < end; sleepUntil(now_s() + 0.001)) {
    if (listener.takeOnset() > 0) return listener.takeOnset();
  }
  return -1;
}

/// Messages at random times, each answered by a burst of 20 ms.
Spread sendMessages(std::uint16_t port, JackListener& listener, int trials) {
  // An ordinary thread on a busy machine wakes when the sound server has just finished: its times would not
  // be random.
  requestRealtime(50);
  auto sender = SignalSender::open("127.0.0.1", port);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> pause(0.040, 0.070);
  SignalMessage jump;
  jump.kind = SignalKind::jump;
  jump.burst = {390, 0.020, 0.8};
  std::vector<double> delays;
  std::size_t lost = 0;
  for (int i = -warmUps; i < trials; ++i) {
    sleepUntil(now_s() + pause(random));
    listener.armOnset(onsetLevel);
    const double sent_s = now_s();
    (*sender)->send(jump);
    const double onset_s = onsetWithin(listener, 0.2);
    if (i < 0) continue;
    if (onset_s < 0) {
      ++lost;
    } else {
      delays.push_back(onset_s - sent_s);
    }
  }
  return {statisticsOf(delays, lost)};
}

/// On a thread of its own: programs started later must not inherit its priority.
Spread messagesTo(std::uint16_t port, JackListener& listener, int trials) {
  Spread spread;
  std::thread([&] { spread = sendMessages(port, listener, trials); }).join();
  return spread;
}

HapticProgram clickProgram(EventPlacement placement) {
  PlaybackSettings settings;
  settings.mode = FeedbackMode::clickOnly;
  settings.placement = placement;
  settings.faintestJump = 0.9;
  settings.bottomOutAmplitude = 0;
  return programOf(
      buttonOf("click", {stateOf("", {{0, 0}, {1, 0.6}, {1.4, 0.3}, {3, 1.0}}, {{0, 0}, {3, 0.9}})}),
      settings);
}

std::unique_ptr<LivePlayer> startPlayer(const HapticProgram& program, JackRoute route) {
  PlayerSettings settings;
  settings.device = "JACK Audio Connection Kit: system";
  settings.jackThroughPortAudio = route == JackRoute::portAudio;
  auto player = LivePlayer::start(settings, program);
  if (!player) return nullptr;
  return *std::move(player);
}

const char* portOf(JackRoute route) {
  return route == JackRoute::portAudio ? "PortAudio.*:out_0" : "detent:out_1";
}

bool benchDetentMessages(const std::string& name, int period, EventPlacement placement, JackRoute route,
                         int trials) {
  const auto program = std::make_unique<HapticProgram>(clickProgram(placement));
  const auto player = startPlayer(*program, route);
  if (!player) return false;
  JackListener listener;
  const Result<std::uint16_t> port = player->listenFudi(0);
  if (!port || !listener.listenTo(portOf(route))) return false;
  sleepUntil(now_s() + 0.3);
  const Spread spread = messagesTo(*port, listener, trials);
  put(text("| %d | %s | ", period, name.c_str()) + spread.cells() +
      text(" | %llu |", static_cast<unsigned long long>(listener.xruns())));
  return true;
}

void benchPd(const std::string& name, int period, const std::vector<std::string>& options, int trials) {
  std::vector<std::string> command{"pd",          "-nogui", "-jack",        "-r", "48000",
                                   "-inchannels", "0",      "-outchannels", "2",  "-rt"};
  command.insert(command.end(), options.begin(), options.end());
  command.insert(command.end(), {"-open", DETENT_SOURCE_DIR "/samples/puredata/detent.pd"});
  ChildProcess pd(command);
  JackListener listener;
  if (!listener.listenTo("pure_data.*:output", 8)) {
    put(text("| %d | %s | not measured: pd opens no JACK port | | | | | | |", period, name.c_str()));
    return;
  }
  sleepUntil(now_s() + 1);
  const Spread spread = messagesTo(pdPort, listener, trials);
  put(text("| %d | %s | ", period, name.c_str()) + spread.cells() +
      text(" | %llu |", static_cast<unsigned long long>(listener.xruns())));
}

/// A sensor of 425 Hz on a pty: ramps of 50 N/s through 0.6 N, from the true crossing to the first sample.
void pressSensor(int period, EventPlacement placement, int trials) {
  const auto program = std::make_unique<HapticProgram>(clickProgram(placement));
  const auto player = startPlayer(*program, JackRoute::ownClient);
  PtySensor pty;
  JackListener listener;
  if (!player || !pty.ready() || !player->attachSensor(pty.port(), 230400, {}) ||
      !listener.listenTo(portOf(JackRoute::ownClient))) {
    put(text("| %d | sensor | not measured | | | | | | |", period));
    return;
  }
  requestRealtime(50);
  constexpr double period_s = 1 / 425.0;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<double> delays;
  std::size_t lost = 0;
  const double began_s = now_s();
  double next_s = began_s;
  const auto send = [&](double force_N) {
    char line[40];
    std::snprintf(line, sizeof line, "%u,%.5fN\n", static_cast<unsigned>((now_s() - began_s) * 1e6), force_N);
    pty.send(line);
  };
  const auto idle = [&](double seconds, double force_N) {
    for (const double end = now_s() + seconds; now_s() < end;) {
      sleepUntil(next_s += period_s);
      send(force_N);
    }
  };
  idle(0.3, 0);
  for (int i = -warmUps; i < trials; ++i) {
    idle(0.06 + 0.01 * share(random), 0);
    listener.armOnset(onsetLevel);
    const double start_s = next_s + period_s * (1 + share(random));
    for (double force = 0; force < 1.2;) {
      sleepUntil(next_s += period_s);
      force = std::clamp(50 * (now_s() - start_s), 0.0, 1.2);
      send(force);
    }
    idle(0.03, 1.2);
    const double onset_s = listener.takeOnset();
    for (double force = 1.2; force > 0; force -= 0.1) {
      sleepUntil(next_s += period_s);
      send(force);
    }
    if (i < 0) continue;
    if (onset_s < 0) {
      ++lost;
    } else {
      delays.push_back(onset_s - (start_s + 0.6 / 50));
    }
  }
  const Spread spread{statisticsOf(delays, lost)};
  put(text("| %d | %s | ", period, placement == EventPlacement::atOnce ? "fast" : "time-stamped") +
      spread.cells() + text(" | %llu |", static_cast<unsigned long long>(listener.xruns())));
}

void benchSensor(int period, EventPlacement placement, int trials) {
  std::thread([&] { pressSensor(period, placement, trials); }).join();
}

/// Evenness of grains under the finger: time of each grain against the true crossing, a minimum-jerk press of
/// 4 mm read at 425 Hz. No sound server: the engine alone.
void benchEvenness(double press_s, EventPlacement placement) {
  const auto program = std::make_unique<HapticProgram>(programOf(linearButton()));
  program->placement = placement;
  constexpr double rate = 48000, sensor_Hz = 425;
  const auto jerk = [&](double t) {
    const double u = std::clamp(t / press_s, 0.0, 1.0);
    return u * u * u * (10 + u * (6 * u - 15));
  };
  const auto forceAt = [&](double t) { return 0.1 + 0.15 * 4 * jerk(t); };
  const auto engine = std::make_unique<HapticEngine>(rate);
  engine->use(program.get());
  std::vector<float> out(64);
  std::vector<double> errors;
  double reading_s = 0.0007;
  EngineEvent event;
  while (static_cast<double>(engine->frame()) < (press_s + 0.05) * rate) {
    while (reading_s * rate < static_cast<double>(engine->frame() + 64)) {
      engine->push({InputKind::force, reading_s * rate, forceAt(reading_s)});
      reading_s += 1 / sensor_Hz;
    }
    engine->render(out.data(), out.size());
    while (engine->nextEvent(event)) {
      if (event.kind != EventKind::grain || event.displacement_mm > 3.9) continue;
      double low = 0, high = press_s;
      for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (4 * jerk(middle) < event.displacement_mm ? low : high) = middle;
      }
      errors.push_back(static_cast<double>(event.frame) / rate - low);
    }
  }
  const LatencyStatistics s = statisticsOf(errors, 0);
  put(text("| %.0f | %s | %.3f | %.3f |", 1e3 * press_s,
           placement == EventPlacement::atOnce ? "fast" : "time-stamped", 1e3 * s.mean_s, 1e3 * s.sd_s));
}

double cpu_s() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Sample {
  std::string name;
  std::unique_ptr<HapticProgram> program;
  double peak_N = 0;
  std::size_t points = 0;
};

std::vector<Sample> sampleButtons() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(DETENT_SOURCE_DIR "/samples/buttons")) {
    if (entry.path().string().ends_with(".button.json")) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<Sample> samples;
  for (const auto& file : files) {
    Result<Button> button = readButtonFile(file.string());
    if (!button) continue;
    Result<PreparedProgram> prepared = prepareProgram(*button, {}, {});
    if (!prepared) continue;
    Sample s;
    s.name = file.stem().stem().string();
    s.program = std::make_unique<HapticProgram>(prepared->program);
    s.points = prepared->summary.tablePoints;
    for (const ButtonState& state : button->states()) {
      s.peak_N = std::max(s.peak_N, 1.2 * state.graph.press().forceRange_N().second);
    }
    samples.push_back(std::move(s));
  }
  return samples;
}

/// Presses of 0.25 s without a rest between them.
PressTrace busyTrace(double duration_s, double peak_N) {
  PressTrace trace;
  for (double t = 0; t < duration_s; t += 1 / 425.0) {
    trace.readings.push_back({t, peak_N * 0.5 * (1 - std::cos(2 * M_PI * t / 0.25))});
  }
  return trace;
}

void benchRender(const std::vector<Sample>& samples, double seconds) {
  for (const Sample& s : samples) {
    const PressTrace trace = busyTrace(seconds, s.peak_N);
    std::vector<double> speeds;
    for (int i = 0; i < 5; ++i) {
      const double before = cpu_s();
      const auto summary = renderPress(*s.program, trace, {}, [](const float*, std::size_t) { return true; });
      speeds.push_back(summary->duration_s / (cpu_s() - before));
    }
    std::sort(speeds.begin(), speeds.end());
    put(text("| %s | %zu | %.0f | %.0f |", s.name.c_str(), s.points, speeds.front(), speeds[2]));
  }
}

void benchCallback(const std::vector<Sample>& samples, int blocks) {
  for (const Sample& s : samples) {
    LiveSession session(48000);
    SessionCommand use;
    use.kind = CommandKind::program;
    use.program = s.program.get();
    session.send(Lane::control, use);
    std::vector<float> out(64);
    std::vector<double> shares;
    double reading_s = 0;
    SessionReport received;
    for (int i = 0; i < blocks; ++i) {
      const double time_s = i * 64 / 48000.0;
      for (; reading_s < time_s; reading_s += 1 / 425.0) {
        SessionCommand force;
        force.timeBase = TimeBase::clock;
        force.time = reading_s;
        force.value = s.peak_N * 0.5 * (1 - std::cos(2 * M_PI * reading_s / 0.25));
        session.send(Lane::sensor, force);
      }
      const double before = cpu_s();
      session.process(out.data(), out.size(), time_s);
      shares.push_back((cpu_s() - before) / (64 / 48000.0));
      while (session.receive(received)) {
      }
    }
    const LatencyStatistics st = statisticsOf(shares, 0);
    put(text("| %s | %.2f %% | %.2f %% | %.2f %% |", s.name.c_str(), 100 * st.mean_s, 100 * st.p99_s,
             100 * st.max_s));
  }
}

void benchGuard(std::uint64_t wanted) {
  for (const JackRoute route : {JackRoute::ownClient, JackRoute::portAudio}) {
    const auto program = std::make_unique<HapticProgram>(programOf(twoLevelButton()));
    LiveSession session(48000);
    SessionCommand use;
    use.kind = CommandKind::program;
    use.program = program.get();
    session.send(Lane::control, use);
    resetGuard();
    AudioSettings settings;
    settings.device = "JACK Audio Connection Kit: system";
    settings.jackRoute = route;
    auto output = AudioOutput::open(settings, session, {enterGuard, leaveGuard});
    if (!output) return;
    std::uint64_t events = 0;
    SessionReport received;
    const double end_s = now_s() + 60;
    for (int i = 0; events < wanted && now_s() < end_s; ++i) {
      SessionCommand force;
      force.timeBase = TimeBase::clock;
      force.time = now_s();
      force.value = i % 100 < 50 ? 0.08 * (i % 50) : 4 - 0.08 * (i % 50);
      session.send(Lane::sensor, force);
      while (session.receive(received)) events += received.kind == ReportKind::event ? 1 : 0;
      sleepUntil(now_s() + 0.0004);
    }
    (*output).reset();
    put(text("| %s | %llu | %llu %s |", route == JackRoute::ownClient ? "JACK client" : "PortAudio",
             static_cast<unsigned long long>(events), static_cast<unsigned long long>(guardHits()),
             firstGuardHit().c_str()));
  }
}

}  // namespace

int main(int argc, char** argv) {
  bool brief = false;
  std::string file;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--short") == 0) {
      brief = true;
    } else if (argv[i][0] == '-' || !file.empty()) {
      std::fprintf(stderr,
                   "detent_playback_bench: \"%s\"? It takes --short (20 trials instead of 200) and a file to "
                   "write to.\n",
                   argv[i]);
      return std::strcmp(argv[i], "--help") == 0 ? 0 : 2;
    } else {
      file = argv[i];
    }
  }
  const int trials = brief ? 20 : 200;
  put("# Playback, measured");
  put("");
  put("Written by `detent_playback_bench` (tests/bench). JACK with its dummy driver at 48 kHz, everything on "
      "one machine, so");
  put("without USB, converter, amplifier and transducer. Medians and spreads say something; on a virtual "
      "machine maxima and xruns");
  put(text("mostly do not. %u processors; delays in ms.", std::thread::hardware_concurrency()));
  put("");
  put("## Signal message to onset");
  put("");
  put("UDP message sent to first sample above 1e-4, at the entry of a JACK callback plus the sample's place "
      "in it; messages at");
  put("random times, 40 to 70 ms apart. Spread is the 95th minus the 5th percentile.");
  put("");
  put("| frames | engine | median | p99 | spread | SD | N | lost | xruns |");
  put("|---|---|---|---|---|---|---|---|---|");
  for (const int period : {64, 128, 256}) {
    JackServer server(period);
    if (!server.ready()) {
      put("| " + std::to_string(period) + " | not measured: " + server.whyNot() + " | | | | | | | |");
      continue;
    }
    if (programExists("pd")) {
      benchPd("Pure Data, default", period, {}, trials);
      benchPd("Pure Data, -audiobuf 5", period, {"-audiobuf", "5"}, trials);
      benchPd("Pure Data, -callback", period, {"-callback"}, trials);
    }
    benchDetentMessages("Detent, fast", period, EventPlacement::atOnce, JackRoute::ownClient, trials);
    benchDetentMessages("Detent through PortAudio, fast", period, EventPlacement::atOnce,
                        JackRoute::portAudio, trials);
    benchDetentMessages("Detent, time-stamped", period, EventPlacement::timeStamped, JackRoute::ownClient,
                        trials);
  }
  put("");
  put("## Force crossing on a 425 Hz serial sensor to onset");
  put("");
  put("A pty sends time-stamped lines; ramps of 50 N/s pass 0.6 N at random phases. From the true crossing. "
      "Kim & Lee's system: mean");
  put("51.12 ms, SD 1.65, N = 50, with USB and transducer.");
  put("");
  put("| frames | placement | median | p99 | spread | SD | N | lost | xruns |");
  put("|---|---|---|---|---|---|---|---|---|");
  for (const int period : {64, 128}) {
    JackServer server(period);
    if (!server.ready()) continue;
    benchSensor(period, EventPlacement::atOnce, trials);
    benchSensor(period, EventPlacement::timeStamped, trials);
  }
  put("");
  put("## How evenly grains follow the finger");
  put("");
  put("A minimum-jerk press of 4 mm on a linear button, read at 425 Hz: time of each grain after its true "
      "crossing.");
  put("");
  put("| press ms | placement | mean ms | SD ms |");
  put("|---|---|---|---|");
  for (const double press_s : {0.06, 0.1, 0.2, 0.5}) {
    benchEvenness(press_s, EventPlacement::atOnce);
    benchEvenness(press_s, EventPlacement::timeStamped);
  }
  const std::vector<Sample> samples = sampleButtons();
  put("");
  put("## Offline render");
  put("");
  put("Continuous presses at 48 kHz, one core (CPU time of the thread), five runs.");
  put("");
  put("| button | table points | times real time, slowest | median |");
  put("|---|---|---|---|");
  benchRender(samples, brief ? 10 : 60);
  put("");
  put("## Share of the callback");
  put("");
  put("Blocks of 64 samples at 48 kHz under continuous presses, CPU time over the block's time.");
  put("");
  put("| button | mean | p99 | max |");
  put("|---|---|---|---|");
  benchCallback(samples, brief ? 2000 : 20000);
  put("");
  put("## Guarded calls in the running callback");
  put("");
  put("malloc, free, locks, read, write, poll, sleep, counted while a stream runs.");
  put("");
  put("| route | events | hits |");
  put("|---|---|---|");
  {
    JackServer server(64);
    if (server.ready()) benchGuard(brief ? 1000 : 10000);
  }
  if (file.empty()) return 0;
  std::ofstream out(file);
  out << report;
  return out.good() ? 0 : 3;
}
