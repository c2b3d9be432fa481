// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes, as if a serial sensor or another program had sent them: lines, FUDI, OSC. Nothing may crash,
// hang, leak or pass what the limits forbid.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string_view>

#include "playback/device/sensor_line.h"
#include "playback/device/signal_message.h"
#include "playback/device/signal_server.h"

using namespace detent::playback;

namespace {

void demand(bool condition) {
  if (!condition) std::abort();
}

void onMessage(const SignalMessage& message) { demand(acceptable(message)); }

SignalServer& oscServer() {
  static const std::unique_ptr<SignalServer> server = [] {
    auto opened = openOscServer(0, thisMachineOnly, [](const SignalMessage& m, double) { onMessage(m); });
    demand(static_cast<bool>(opened));
    return std::move(*opened);
  }();
  return *server;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  switch (data[0] % 3) {
    case 0: {
      LineAssembler assembler;
      ClockAligner aligner;
      const std::size_t cut = bytes.size() / 3;
      const auto onReading = [&](const SensorLine& line) { aligner.hostTime_s(line.time_us, 1000); };
      assembler.feed(bytes.substr(0, cut), onReading);
      assembler.feed(bytes.substr(cut), onReading);
      demand(assembler.counts().bytes == bytes.size());
      break;
    }
    case 1: {
      SignalCounts counts;
      parseFudi(bytes, counts, onMessage);
      break;
    }
    default:
      handlePacket(oscServer(), bytes);
  }
  return 0;
}
