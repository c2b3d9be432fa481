// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// An output stream as a JACK client of our own. PortAudio plays through JACK too, but once the server is gone
// its stream waits ten minutes before it can be closed; a client of our own comes back at once
// (docs/develop/decisions/0904).

#include <memory>
#include <optional>
#include <string>

#include "model/result.h"
#include "playback/device/stream_renderer.h"

namespace detent::playback {

class JackStream {
 public:
  /// False in a build without JACK.
  static bool available();
  /// Inputs of the client of this very name; 0 where no server answers.
  static int inputCount(const std::string& target);
  /// Connects its ports "detent:out_N", the signal's first, to the inputs of the JACK client `target` ("system"). `wanted_Hz` 0: whatever rate
  /// the server has; the renderer's session is set to it.
  static Result<std::unique_ptr<JackStream>> open(const std::string& target, OutputChannels channels,
                                                  double wanted_Hz, StreamRenderer& renderer);
  ~JackStream();
  /// The server is still there.
  bool alive() const;
  /// From the end of a buffer's computation to where the server says it sounds; 0: it does not say.
  double latency_s() const;

 private:
  struct Client;
  explicit JackStream(std::unique_ptr<Client> client);
  std::unique_ptr<Client> client_;
};

}  // namespace detent::playback
