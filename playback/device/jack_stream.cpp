// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/jack_stream.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <jack/jack.h>

#include "playback/device/steady_clock.h"

namespace detent::playback {

namespace {
constexpr int mostChannels = 32;
constexpr double longestCallback_s = 2, poll_s = 0.001;
void ignoreMessage(const char*) {}

/// Inputs of the client with exactly this name. JACK would treat it as a regular expression and find none for
/// "... (HDMI)".
std::vector<std::string> inputsOf(jack_client_t* jack, const std::string& target) {
  std::vector<std::string> names;
  const char** all = jack_get_ports(jack, nullptr, JACK_DEFAULT_AUDIO_TYPE, JackPortIsInput);
  if (all == nullptr) return names;
  for (std::size_t i = 0; all[i] != nullptr; ++i) {
    if (std::string_view(all[i]).starts_with(target + ":")) names.emplace_back(all[i]);
  }
  jack_free(all);
  return names;
}
}  // namespace

struct JackStream::Client {
  explicit Client(StreamRenderer& r) : renderer(r) {}
  ~Client() {
    if (jack == nullptr) return;
    leaveCallback();
    jack_client_close(jack);
  }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  StreamRenderer& renderer;
  jack_client_t* jack = nullptr;
  std::array<jack_port_t*, mostChannels> ports{};
  std::size_t channels = 0, signalChannels = 0;
  std::atomic<bool> down{false}, leaving{false}, inside{false};

  static int process(jack_nframes_t frames, void* self) {
    Client& client = *static_cast<Client*>(self);
    client.inside = true;
    if (client.leaving)
      client.silence(frames);  // otherwise the buffer's old content would sound again
    else
      client.render(frames);
    client.inside = false;
    return 0;
  }

  /// Waits until the callback has returned for the last time. If a cycle takes too long, libjack cancels its
  /// thread at any point; inside our callback that would end the whole program by SIGABRT or SIGSEGV
  /// (docs/develop/decisions/0904).
  void leaveCallback() {
    leaving = true;
    for (double left_s = longestCallback_s; inside && left_s > 0; left_s -= poll_s)
      sleepUntil(now_s() + poll_s);
  }
  static int xrun(void* self) {
    static_cast<Client*>(self)->renderer.noteXrun();
    return 0;
  }
  static void shutdown(void* self) { static_cast<Client*>(self)->down = true; }

  void silence(jack_nframes_t frames) {
    for (std::size_t c = 0; c < channels; ++c)
      std::fill_n(static_cast<float*>(jack_port_get_buffer(ports[c], frames)), frames, 0.0F);
  }

  void render(jack_nframes_t frames) {
    const double entry_s = now_s();
    std::array<float*, mostChannels> out;
    for (std::size_t c = 0; c < channels; ++c)
      out[c] = static_cast<float*>(jack_port_get_buffer(ports[c], frames));
    renderer.render(frames, entry_s, &now_s,
                    [&](std::size_t first, const float* signal, const float* rain, std::size_t count) {
                      for (std::size_t c = 0; c < channels; ++c)
                        std::copy_n(c < signalChannels ? signal : rain, count, out[c] + first);
                    });
  }
};

JackStream::JackStream(std::unique_ptr<Client> client) : client_(std::move(client)) {}
JackStream::~JackStream() = default;
bool JackStream::available() { return true; }

int JackStream::inputCount(const std::string& target) {
  jack_set_error_function(ignoreMessage);
  jack_set_info_function(ignoreMessage);
  jack_client_t* const jack = jack_client_open("detent-look", JackNoStartServer, nullptr);
  if (jack == nullptr) return 0;
  const std::size_t count = inputsOf(jack, target).size();
  jack_client_close(jack);
  return static_cast<int>(count);
}

bool JackStream::alive() const { return !client_->down; }

double JackStream::latency_s() const {
  if (client_->down) return 0;
  jack_latency_range_t range{};
  jack_port_get_latency_range(client_->ports[0], JackPlaybackLatency, &range);
  return static_cast<double>(range.max) / jack_get_sample_rate(client_->jack);
}

Result<std::unique_ptr<JackStream>> JackStream::open(const std::string& target, OutputChannels channels,
                                                     double wanted_Hz, StreamRenderer& renderer) {
  const auto trouble = [&](Message problem, const Remedies& remedies) {
    return Failure{FailureCode::deviceTrouble, "JACK: " + target, "", std::move(problem), remedies};
  };
  jack_set_error_function(ignoreMessage);
  jack_set_info_function(ignoreMessage);
  auto client = std::make_unique<Client>(renderer);
  client->jack = jack_client_open("detent", JackNoStartServer, nullptr);
  if (client->jack == nullptr)
    return trouble(Message("the JACK server does not answer"), Message("Start the JACK server (jackd)"));
  const double rate_Hz = jack_get_sample_rate(client->jack);
  if (wanted_Hz > 0 && std::fabs(rate_Hz - wanted_Hz) > 1)
    return trouble(Message("the JACK server runs at another sample rate"),
                   {{RemedyKind::advice, Message("Choose the rate of the device")},
                    {RemedyKind::advice, Message("On the command line, leave --device-rate out")}});
  if (rate_Hz < HapticEngine::lowestSampleRate_Hz || rate_Hz > HapticEngine::highestSampleRate_Hz)
    return trouble(Message("the JACK server runs at a sample rate outside 8000 to 192000 Hz"),
                   Message("Restart the JACK server at another sample rate"));
  renderer.setSampleRate(rate_Hz);
  client->channels = static_cast<std::size_t>(std::clamp(channels.all(), 1, mostChannels));
  client->signalChannels = static_cast<std::size_t>(std::max(0, channels.signal));
  for (std::size_t c = 0; c < client->channels; ++c) {
    const std::string name = "out_" + std::to_string(c + 1);
    client->ports[c] =
        jack_port_register(client->jack, name.c_str(), JACK_DEFAULT_AUDIO_TYPE, JackPortIsOutput, 0);
    if (client->ports[c] == nullptr)
      return trouble(Message("the JACK server has no free ports"), Message("Close another JACK program"));
  }
  jack_on_shutdown(client->jack, &Client::shutdown, client.get());
  jack_set_xrun_callback(client->jack, &Client::xrun, client.get());
  if (jack_set_process_callback(client->jack, &Client::process, client.get()) != 0 ||
      jack_activate(client->jack) != 0) {
    return trouble(Message("the connection to the JACK server does not start"),
                   Message("Restart the JACK server (jackd)"));
  }
  const std::vector<std::string> inputs = inputsOf(client->jack, target);
  if (inputs.empty())
    return trouble(
        Message("this JACK device has no inputs to connect to"),
        Message("Choose another sound device; `detent-play devices` and the Feel panel (Setup) list them"));
  for (std::size_t c = 0; c < std::min(client->channels, inputs.size()); ++c)
    jack_connect(client->jack, jack_port_name(client->ports[c]), inputs[c].c_str());
  jack_recompute_total_latencies(client->jack);  // so that the latency is known right after opening
  return std::unique_ptr<JackStream>(new JackStream(std::move(client)));
}

}  // namespace detent::playback
