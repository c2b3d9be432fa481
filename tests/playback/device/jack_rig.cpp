// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/playback/device/jack_rig.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <thread>

#include <fcntl.h>
#include <jack/jack.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

namespace detent::test {

namespace {

void sleepFor(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

double rawNow_s() {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC_RAW, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void silent(const char*) {}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& command) {
  pid_ = ::fork();
  if (pid_ != 0) return;
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);  // a test that is killed leaves no server behind
  const int nowhere = ::open("/dev/null", O_RDWR);
  ::dup2(nowhere, 0);
  ::dup2(nowhere, 1);
  ::dup2(nowhere, 2);
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  ::execvp(words[0], words.data());
  ::_exit(127);
}

ChildProcess::~ChildProcess() { stop(); }

bool ChildProcess::running() { return pid_ > 0 && ::waitpid(pid_, nullptr, WNOHANG) == 0; }

void ChildProcess::stop() {
  if (pid_ <= 0) return;
  ::kill(pid_, SIGTERM);
  for (int i = 0; i < 50; ++i) {
    if (::waitpid(pid_, nullptr, WNOHANG) != 0) {
      pid_ = -1;
      return;
    }
    sleepFor(0.02);
  }
  ::kill(pid_, SIGKILL);
  ::waitpid(pid_, nullptr, 0);
  pid_ = -1;
}

bool programExists(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::string rest = path == nullptr ? "" : path;
  while (!rest.empty()) {
    const std::size_t colon = rest.find(':');
    if (::access((rest.substr(0, colon) + "/" + name).c_str(), X_OK) == 0) return true;
    rest = colon == std::string::npos ? "" : rest.substr(colon + 1);
  }
  return false;
}

JackServer::JackServer(int period) : period_(period) {
  static std::atomic<int> servers{0};
  name_ = "detent-test-" + std::to_string(::getpid()) + "-" + std::to_string(servers++);
  ::setenv("JACK_DEFAULT_SERVER", name_.c_str(), 1);
  ::setenv("JACK_NO_AUDIO_RESERVATION", "1", 1);
  ::setenv("JACK_NO_START_SERVER", "1", 1);
  jack_set_error_function(silent);
  jack_set_info_function(silent);
  if (!programExists("jackd")) {
    why_ = "jackd is not installed";
    return;
  }
  start();
}

JackServer::~JackServer() { stop(); }

void JackServer::stop() {
  server_.reset();
  ready_ = false;
}

void JackServer::start(int rate_Hz) {
  for (const bool realtime : {true, false}) {
    std::vector<std::string> command{"jackd", "-n", name_};
    if (realtime) command.insert(command.end(), {"-R", "-P70"});
    if (!realtime) command.push_back("-r");
    command.insert(command.end(),
                   {"-d", "dummy", "-r", std::to_string(rate_Hz), "-p", std::to_string(period_)});
    server_ = std::make_unique<ChildProcess>(command);
    for (int i = 0; i < 60 && server_->running(); ++i) {
      sleepFor(0.05);
      jack_client_t* probe = jack_client_open(
          "probe", static_cast<jack_options_t>(JackNoStartServer | JackServerName), nullptr, name_.c_str());
      if (probe == nullptr) continue;
      jack_client_close(probe);
      ready_ = true;
      return;
    }
    server_.reset();
  }
  why_ = "jackd with its dummy driver does not start here";
}

void JackServer::pause() { ::kill(server_->pid(), SIGSTOP); }
void JackServer::resume() { ::kill(server_->pid(), SIGCONT); }

struct JackListener::Client {
  jack_client_t* jack = nullptr;
  jack_port_t *input = nullptr, *output = nullptr;
  std::function<float(float)> filter;
  std::vector<float> ring = std::vector<float>(48000 * 120);
  std::atomic<std::size_t> count{0};
  std::atomic<float> threshold{2};
  std::atomic<double> onset_s{-1};
  std::atomic<std::uint64_t> xruns{0};
  std::atomic<bool> stopping{false};
  std::thread connector;

  static int process(jack_nframes_t frames, void* self) { return static_cast<Client*>(self)->run(frames); }
  static int xrun(void* self) {
    ++static_cast<Client*>(self)->xruns;
    return 0;
  }

  int run(jack_nframes_t frames) {
    const double entry_s = rawNow_s();
    const auto* in = static_cast<const float*>(jack_port_get_buffer(input, frames));
    auto* out = static_cast<float*>(jack_port_get_buffer(output, frames));
    std::size_t at = count.load(std::memory_order_relaxed);
    for (jack_nframes_t i = 0; i < frames; ++i) {
      if (at < ring.size()) ring[at++] = in[i];
      out[i] = filter ? filter(in[i]) : in[i];
      if (std::fabs(in[i]) > threshold.load(std::memory_order_relaxed)) {
        onset_s.store(entry_s + static_cast<double>(i) / jack_get_sample_rate(jack),
                      std::memory_order_relaxed);
        threshold.store(2, std::memory_order_release);
      }
    }
    count.store(at, std::memory_order_release);
    return 0;
  }

  bool connect(const std::string& source, unsigned long flags, bool intoUs) {
    const char** ports = jack_get_ports(jack, source.c_str(), JACK_DEFAULT_AUDIO_TYPE, flags);
    if (ports == nullptr) return false;
    bool done = false;
    for (int i = 0; ports[i] != nullptr && !done; ++i) {
      const int error = intoUs ? jack_connect(jack, ports[i], jack_port_name(input))
                               : jack_connect(jack, jack_port_name(output), ports[i]);
      done = error == 0 || error == EEXIST;
    }
    jack_free(ports);
    return done;
  }
};

JackListener::JackListener(std::function<float(float)> filter, const std::string& name)
    : client_(std::make_unique<Client>()) {
  Client& c = *client_;
  c.filter = std::move(filter);
  c.jack = jack_client_open(name.c_str(), JackNoStartServer, nullptr);
  if (c.jack == nullptr) return;
  c.input = jack_port_register(c.jack, "in", JACK_DEFAULT_AUDIO_TYPE, JackPortIsInput, 0);
  c.output = jack_port_register(c.jack, "out", JACK_DEFAULT_AUDIO_TYPE, JackPortIsOutput, 0);
  jack_set_process_callback(c.jack, &Client::process, client_.get());
  jack_set_xrun_callback(c.jack, &Client::xrun, client_.get());
  if (jack_activate(c.jack) == 0) return;
  jack_client_close(c.jack);
  c.jack = nullptr;
}

JackListener::~JackListener() {
  client_->stopping = true;
  if (client_->connector.joinable()) client_->connector.join();
  if (client_->jack != nullptr) jack_client_close(client_->jack);
}

bool JackListener::ready() const { return client_->jack != nullptr; }

bool JackListener::listenTo(const std::string& source, double seconds) {
  for (double t = 0; t < seconds; t += 0.02, sleepFor(0.02)) {
    if (client_->connect("^" + source, JackPortIsOutput, true)) return true;
  }
  return false;
}

bool JackListener::feed(const std::string& target, double seconds) {
  for (double t = 0; t < seconds; t += 0.02, sleepFor(0.02)) {
    if (client_->connect("^" + target, JackPortIsInput, false)) return true;
  }
  return false;
}

void JackListener::keepConnected(const std::string& source, const std::string& target) {
  client_->connector = std::thread([this, source, target] {
    while (!client_->stopping) {
      client_->connect("^" + source, JackPortIsOutput, true);
      client_->connect("^" + target, JackPortIsInput, false);
      sleepFor(0.01);
    }
  });
}

std::vector<float> JackListener::recorded() const {
  const std::size_t count = client_->count.load(std::memory_order_acquire);
  return {client_->ring.begin(), client_->ring.begin() + static_cast<long>(count)};
}

void JackListener::armOnset(float threshold) {
  client_->onset_s = -1;
  client_->threshold = threshold;
}

double JackListener::takeOnset() { return client_->onset_s.load(); }

std::uint64_t JackListener::xruns() const { return client_->xruns; }

}  // namespace detent::test
