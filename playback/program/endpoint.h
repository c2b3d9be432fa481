// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// PORT, ADDRESS:PORT and HOST:PORT of the command line.

#include <cstdint>
#include <string>

#include "model/result.h"

namespace detent::playback {

struct Endpoint {
  std::string host;
  std::uint16_t port = 0;
};

/// "9000" (at `standardHost`; empty: a host must be given) or "192.168.1.5:9000". Failure wrongUsage, about
/// `option`: no port from `lowestPort` to 65535.
Result<Endpoint> parseEndpoint(const std::string& text, const std::string& option,
                               const std::string& standardHost, unsigned lowestPort);

}  // namespace detent::playback
