// SPDX-License-Identifier: GPL-3.0-or-later
// The UDP socket of this folder, and its protocols: FUDI and OSC for receiving, FUDI for sending.
#include "playback/device/signal_server.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <mutex>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <arpa/inet.h>
#include <lo/lo.h>
#include <netdb.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include "playback/device/steady_clock.h"

namespace detent::playback {

namespace {

constexpr int receiverPriority = 60;  // lower than that of the audio callback (JACK: 65)
constexpr int stopCheck_ms = 50;
constexpr std::size_t mostArguments = 3, largestPacket = 65536, deepestBundle = 8;
constexpr std::array<char, 8> bundleName{"#bundle"};  // including its terminating zero
constexpr std::size_t bundleHead = 16;                // name and time stamp

std::string systemWords(int error) { return std::system_category().message(error); }

class UdpSocket {
 public:
  UdpSocket() : descriptor_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {}
  ~UdpSocket() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  UdpSocket(const UdpSocket&) = delete;
  UdpSocket& operator=(const UdpSocket&) = delete;
  int descriptor() const { return descriptor_; }

  /// Binds the socket; returns 0 or the error. `port` receives the actual port.
  int bind(const std::string& address, std::uint16_t& port) const {
    sockaddr_in where{};
    where.sin_family = AF_INET;
    where.sin_port = htons(port);
    if (::inet_pton(AF_INET, address.c_str(), &where.sin_addr) != 1) return EADDRNOTAVAIL;
    socklen_t length = sizeof where;
    auto* name = reinterpret_cast<sockaddr*>(&where);
    if (descriptor_ < 0 || ::bind(descriptor_, name, length) != 0 ||
        ::getsockname(descriptor_, name, &length) != 0) {
      return errno;
    }
    port = ntohs(where.sin_port);
    return 0;
  }

 private:
  int descriptor_;
};

using Counted = std::function<void(const SignalMessage&)>;

/// Parses one OSC message or bundle. A bundle's time stamp is of another clock, so its messages count from
/// their arrival.
void parseOsc(std::string_view packet, SignalCounts& counts, const Counted& onMessage,
              std::size_t depth = 0) {
  if (packet.starts_with(std::string_view(bundleName.data(), bundleName.size())) &&
      packet.size() >= bundleHead && depth < deepestBundle) {
    packet.remove_prefix(bundleHead);
    std::uint32_t size = 0;
    while (packet.size() >= sizeof size) {
      std::memcpy(&size, packet.data(), sizeof size);
      size = ntohl(size);
      packet.remove_prefix(sizeof size);
      if (size > packet.size()) break;
      parseOsc(packet.substr(0, size), counts, onMessage, depth + 1);
      packet.remove_prefix(size);
    }
    counts.malformed += packet.empty() ? 0 : 1;
    return;
  }
  std::vector<char> copy(packet.begin(), packet.end());  // liblo changes the byte order in place
  int error = 0;
  lo_message parsed = copy.empty() ? nullptr : lo_message_deserialise(copy.data(), copy.size(), &error);
  std::array<double, mostArguments> values{};
  // A stop counts whatever arguments it has.
  const bool stop = parsed != nullptr && std::string_view(copy.data()) == "/detent/stop";
  const int count = stop ? 0 : parsed == nullptr ? -1 : lo_message_get_argc(parsed);
  bool ok = count >= 0 && count <= static_cast<int>(mostArguments);
  for (int i = 0; ok && i < count; ++i) {
    const auto type = static_cast<lo_type>(lo_message_get_types(parsed)[i]);
    const bool isTrue = type == LO_TRUE || type == LO_INFINITUM;  // a toggle, an impulse
    ok = isTrue || type == LO_FALSE || lo_is_numerical_type(type) != 0;
    if (ok)
      values[static_cast<std::size_t>(i)] =
          isTrue || type == LO_FALSE
              ? (isTrue ? 1 : 0)
              : static_cast<double>(lo_hires_val(type, lo_message_get_argv(parsed)[i]));
  }
  SignalMessage message;
  ok = ok && fromOsc(copy.data(), values.data(), static_cast<std::size_t>(count), message);
  if (parsed != nullptr) lo_message_free(parsed);
  ++counts.packets;
  ++(ok ? counts.messages : counts.malformed);
  if (ok && message.kind != SignalKind::none) onMessage(message);
}

class UdpServer : public SignalServer {
 public:
  using Parser = void (*)(std::string_view packet, SignalCounts& counts, const Counted& onMessage);
  UdpServer(Parser parse, SignalReceiver receiver) : parse_(parse), receiver_(std::move(receiver)) {}
  ~UdpServer() override {
    stopping_ = true;
    if (thread_.joinable()) thread_.join();
  }

  int start(std::uint16_t port, const std::string& address) {
    port_ = port;
    if (const int error = socket_.bind(address, port_); error != 0) return error;
    thread_ = std::thread([this] { receive(); });
    return 0;
  }

  /// Called on the receiving thread, or while it does not run.
  void handle(std::string_view packet) {
    const double arrival_s = now_s();
    SignalCounts counts = counts_;  // only this thread writes it
    parse_(packet, counts, [&](const SignalMessage& m) { receiver_(m, arrival_s); });
    const std::lock_guard lock(mutex_);
    counts_ = counts;
  }

  std::uint16_t port() const override { return port_; }
  SignalCounts counts() const override {
    const std::lock_guard lock(mutex_);
    return counts_;
  }

 private:
  void receive() {
    requestRealtime(receiverPriority);
    std::vector<char> buffer(largestPacket);
    while (!stopping_) {
      pollfd poll{socket_.descriptor(), POLLIN, 0};
      if (::poll(&poll, 1, stopCheck_ms) <= 0) continue;
      const ssize_t count = ::recv(socket_.descriptor(), buffer.data(), buffer.size(), MSG_DONTWAIT);
      if (count >= 0) handle({buffer.data(), static_cast<std::size_t>(count)});
    }
  }

  Parser parse_;
  SignalReceiver receiver_;
  UdpSocket socket_;
  std::uint16_t port_ = 0;
  std::atomic<bool> stopping_{false};
  mutable std::mutex mutex_;
  SignalCounts counts_;
  std::thread thread_;
};

Result<std::unique_ptr<SignalServer>> opened(const std::string& kind, UdpServer::Parser parse,
                                             std::uint16_t port, const std::string& address,
                                             SignalReceiver receiver) {
  auto server = std::make_unique<UdpServer>(parse, std::move(receiver));
  if (const int error = server->start(port, address); error != 0) {
    return Failure{FailureCode::deviceTrouble, kind + " port " + address + ":" + std::to_string(port), "",
                   Message("the port cannot be opened to receive messages (%1)", systemWords(error)),
                   Message("Choose another port")};
  }
  return std::unique_ptr<SignalServer>(std::move(server));
}

void parseOscPacket(std::string_view packet, SignalCounts& counts, const Counted& onMessage) {
  parseOsc(packet, counts, onMessage);
}

}  // namespace

Result<std::unique_ptr<SignalServer>> openFudiServer(std::uint16_t port, const std::string& address,
                                                     SignalReceiver receiver) {
  return opened("UDP", parseFudi, port, address, std::move(receiver));
}

Result<std::unique_ptr<SignalServer>> openOscServer(std::uint16_t port, const std::string& address,
                                                    SignalReceiver receiver) {
  return opened("OSC", parseOscPacket, port, address, std::move(receiver));
}

void handlePacket(SignalServer& server, std::string_view packet) {
  dynamic_cast<UdpServer&>(server).handle(packet);
}

struct SignalSender::Socket {
  UdpSocket socket;
  sockaddr_in target{};
  std::uint64_t failed = 0;
};

SignalSender::SignalSender(std::unique_ptr<Socket> socket) : socket_(std::move(socket)) {}
SignalSender::~SignalSender() = default;

Result<std::unique_ptr<SignalSender>> SignalSender::open(const std::string& host, std::uint16_t port) {
  auto s = std::make_unique<Socket>();
  addrinfo wanted{}, *found = nullptr;
  wanted.ai_family = AF_INET;
  wanted.ai_socktype = SOCK_DGRAM;
  const int error = ::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &wanted, &found);
  if (error != 0 || s->socket.descriptor() < 0) {
    const std::string why = error != 0 ? ::gai_strerror(error) : systemWords(errno);
    return Failure{FailureCode::deviceTrouble, host + ":" + std::to_string(port), "",
                   Message("the receiver cannot be reached (%1)", why), Message("Check host and port")};
  }
  std::memcpy(&s->target, found->ai_addr, sizeof s->target);
  ::freeaddrinfo(found);
  return std::unique_ptr<SignalSender>(new SignalSender(std::move(s)));
}

void SignalSender::send(const SignalMessage& message) {
  const std::string text = toFudi(message);
  const auto* target = reinterpret_cast<const sockaddr*>(&socket_->target);
  if (::sendto(socket_->socket.descriptor(), text.data(), text.size(), 0, target, sizeof socket_->target) < 0)
    ++socket_->failed;
}

std::uint64_t SignalSender::failed() const { return socket_->failed; }

}  // namespace detent::playback
