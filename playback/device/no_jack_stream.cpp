// SPDX-License-Identifier: GPL-3.0-or-later
// Replacement for builds without JACK. PortAudio then uses a JACK server itself if it can.

#include "playback/device/jack_stream.h"

namespace detent::playback {

struct JackStream::Client {};
JackStream::JackStream(std::unique_ptr<Client> client) : client_(std::move(client)) {}
JackStream::~JackStream() = default;
int JackStream::inputCount(const std::string&) { return 0; }
bool JackStream::available() { return false; }
bool JackStream::alive() const { return false; }
double JackStream::latency_s() const { return 0; }
Result<std::unique_ptr<JackStream>> JackStream::open(const std::string& target, OutputChannels, double,
                                                     StreamRenderer&) {
  return Failure{FailureCode::deviceTrouble, "JACK: " + target, "",
                 Message("this build of Detent has no JACK output"),
                 Message("Choose a sound device without \"JACK:\", or install a build of Detent with JACK")};
}

}  // namespace detent::playback
