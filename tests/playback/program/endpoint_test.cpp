// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/endpoint.h"

#include <catch2/catch.hpp>

using namespace detent;
using namespace detent::playback;

TEST_CASE("endpoint: a port, an address and a port, nothing else") {
  const Result<Endpoint> port = parseEndpoint("9000", "--osc", "127.0.0.1", 0);
  REQUIRE(port);
  CHECK(port->host == "127.0.0.1");
  CHECK(port->port == 9000);
  const Result<Endpoint> endpoint = parseEndpoint("0.0.0.0:0", "--osc", "127.0.0.1", 0);
  REQUIRE(endpoint);
  CHECK(endpoint->host == "0.0.0.0");
  CHECK(endpoint->port == 0);
  for (const char* wrong :
       {"", ":", "99999", "65536", "-1", "+1", "9000x", "0x10", "1e3", "host:", ":9000", "9000 "}) {
    const Result<Endpoint> refused = parseEndpoint(wrong, "--osc", "", 1);
    INFO(wrong);
    REQUIRE_FALSE(refused);
    CHECK(refused.failure().exitCode() == 2);
  }
  CHECK_FALSE(parseEndpoint("9000", "--signals-to", "", 1));
  CHECK_FALSE(parseEndpoint("localhost:0", "--signals-to", "", 1));
}
