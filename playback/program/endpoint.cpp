// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/endpoint.h"

#include <charconv>

namespace detent::playback {

Result<Endpoint> parseEndpoint(const std::string& text, const std::string& option,
                               const std::string& standardHost, unsigned lowestPort) {
  const std::size_t colon = text.rfind(':');
  const bool hasHost = colon != std::string::npos;
  const std::string host = hasHost ? text.substr(0, colon) : standardHost;
  const char* const first = text.data() + (hasHost ? colon + 1 : 0);
  const char* const last = text.data() + text.size();
  unsigned port = 0;
  const auto [end, error] = std::from_chars(first, last, port);
  if (host.empty() || first == last || error != std::errc() || end != last || port < lowestPort ||
      port > 65535) {
    const std::string form = standardHost.empty() ? "HOST:PORT" : "PORT or ADDRESS:PORT";
    return Failure{FailureCode::wrongUsage, Subject::option(option), "", "\"" + text + "\" is not " + form,
                   "Give a port from " + std::to_string(lowestPort) + " to 65535"};
  }
  return Endpoint{host, static_cast<std::uint16_t>(port)};
}

}  // namespace detent::playback
