// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// An output stream as a separate JACK client. PortAudio supports JACK too, but after the server is gone its
// stream waits ten minutes before it can be closed; a separate client can reconnect at once
// (docs/develop/decisions/0904).

#include <memory>
#include <optional>
#include <string>

#include "model/result.h"
#include "playback/device/stream_renderer.h"

namespace detent::playback {

class JackStream {
 public:
  /// Returns false in a build without JACK.
  static bool available();
  /// Number of inputs of the client with exactly this name; 0 if no server answers.
  static int inputCount(const std::string& target);
  /// Connects its ports "detent:out_N", the vibration's first, to the inputs of the JACK client `target`
  /// ("system"). `wanted_Hz` 0: the server's rate. The renderer's session is set to the rate that results.
  static Result<std::unique_ptr<JackStream>> open(const std::string& target, OutputChannels channels,
                                                  double wanted_Hz, StreamRenderer& renderer);
  ~JackStream();
  /// Returns true while the server is running.
  bool alive() const;
  /// Seconds from the end of a buffer's computation to its output, as reported by the server; 0: not
  /// reported.
  double latency_s() const;

 private:
  struct Client;
  explicit JackStream(std::unique_ptr<Client> client);
  std::unique_ptr<Client> client_;
};

}  // namespace detent::playback
