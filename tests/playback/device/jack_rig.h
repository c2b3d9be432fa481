// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Real parts for the device tests: a JACK server with its dummy driver and a client that listens to, filters
// or loops back what PortAudio plays. Started and stopped by process id; where a machine cannot, the reason
// is said.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace detent::test {

/// A process that ends with its owner.
class ChildProcess {
 public:
  explicit ChildProcess(const std::vector<std::string>& command);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  bool running();
  void stop();
  int pid() const { return pid_; }

 private:
  int pid_ = -1;
};

bool programExists(const std::string& name);

/// jackd with the dummy driver at 48 kHz under a name of its own, made the default of this process.
class JackServer {
 public:
  explicit JackServer(int period);
  ~JackServer();
  bool ready() const { return ready_; }
  std::string whyNot() const { return why_; }
  void stop();
  void start(int rate_Hz = 48000);
  /// Pauses the server: no callbacks come, and no client receives a shutdown notice.
  void pause();
  void resume();

 private:
  int period_;
  bool ready_ = false;
  std::string why_, name_;
  std::unique_ptr<ChildProcess> server_;
};

/// A JACK client that records one port of another client. Samples carry their JACK frame.
class JackListener {
 public:
  /// `filter` (may be empty) turns each input sample into one on the client's output port.
  explicit JackListener(std::function<float(float)> filter = {}, const std::string& name = "listener");
  ~JackListener();
  bool ready() const;
  /// Connects a port whose name begins with `source` to the input; waits up to `seconds`.
  bool listenTo(const std::string& source, double seconds = 3);
  /// Connects the output to an input port whose name begins with `target`.
  bool feed(const std::string& target, double seconds = 3);
  /// Keeps trying both in the background, for streams that a library opens and closes itself.
  void keepConnected(const std::string& source, const std::string& target);
  /// Everything recorded so far.
  std::vector<float> recorded() const;
  /// Time (CLOCK_MONOTONIC_RAW, s) at which the first sample above `threshold` since the last call stood in a
  /// callback (entry plus its place in the block); negative if there was none.
  double takeOnset();
  void armOnset(float threshold);
  std::uint64_t xruns() const;

 private:
  struct Client;
  std::unique_ptr<Client> client_;
};

}  // namespace detent::test
