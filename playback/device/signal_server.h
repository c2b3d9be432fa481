// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Signal messages from other programs: UDP FUDI (as a Pure Data patch would receive them) and OSC (liblo).

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "model/result.h"
#include "playback/device/signal_message.h"

namespace detent::playback {

/// Called on the receiving thread with the time of arrival on now_s().
using SignalReceiver = std::function<void(const SignalMessage&, double arrival_s)>;

class SignalServer {
 public:
  virtual ~SignalServer() = default;  ///< stops and joins its thread
  virtual std::uint16_t port() const = 0;
  virtual SignalCounts counts() const = 0;  ///< any thread
};

inline constexpr const char* thisMachineOnly = "127.0.0.1";

/// Listens on an IPv4 address of this machine. Port 0: the system chooses.
Result<std::unique_ptr<SignalServer>> openFudiServer(std::uint16_t port, const std::string& address,
                                                     SignalReceiver receiver);
Result<std::unique_ptr<SignalServer>> openOscServer(std::uint16_t port, const std::string& address,
                                                    SignalReceiver receiver);

/// Handles one packet as if it had arrived, on the calling thread. Nothing may arrive meanwhile. For fuzzing.
void handlePacket(SignalServer& server, std::string_view packet);

/// The other direction, the paper's own route: sends messages as UDP packets to a synthesizer such as
/// samples/puredata/detent.pd. One thread.
class SignalSender {
 public:
  static Result<std::unique_ptr<SignalSender>> open(const std::string& host, std::uint16_t port);
  ~SignalSender();
  void send(const SignalMessage& message);
  std::uint64_t failed() const;

 private:
  struct Socket;
  explicit SignalSender(std::unique_ptr<Socket> socket);
  std::unique_ptr<Socket> socket_;
};

}  // namespace detent::playback
