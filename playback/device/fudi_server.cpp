// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <atomic>
#include <mutex>
#include <thread>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>

#include "playback/device/signal_server.h"
#include "playback/device/steady_clock.h"

namespace detent::playback {

namespace {

constexpr int receiverPriority = 60;  // below the audio callback (JACK: 65)
namespace asio = boost::asio;
using asio::ip::udp;
using ErrorCode = boost::system::error_code;

class FudiServer : public SignalServer {
 public:
  explicit FudiServer(SignalReceiver receiver) : receiver_(std::move(receiver)), socket_(context_) {}
  ~FudiServer() override {
    context_.stop();
    if (thread_.joinable()) thread_.join();
  }

  ErrorCode start(const udp::endpoint& endpoint) {
    ErrorCode error;
    socket_.open(endpoint.protocol(), error);
    if (error) return error;
    socket_.bind(endpoint, error);
    if (error) return error;
    const udp::endpoint bound = socket_.local_endpoint(error);
    if (error) return error;
    port_ = bound.port();
    thread_ = std::thread([this] {
      requestRealtime(receiverPriority);
      receive();
      context_.run();
    });
    return {};
  }

  std::uint16_t port() const override { return port_; }
  SignalCounts counts() const override {
    const std::lock_guard lock(mutex_);
    return counts_;
  }

 private:
  void receive() {
    socket_.async_receive_from(asio::buffer(buffer_), sender_,
                               [this](const ErrorCode& error, std::size_t count) {
                                 if (error == asio::error::operation_aborted) return;
                                 if (!error) {
                                   const double arrival_s = now_s();
                                   SignalCounts counts = counts_;  // only this thread writes
                                   parseFudi({buffer_.data(), count}, counts,
                                             [&](const SignalMessage& m) { receiver_(m, arrival_s); });
                                   const std::lock_guard lock(mutex_);
                                   counts_ = counts;
                                 }
                                 receive();
                               });
  }

  SignalReceiver receiver_;
  asio::io_context context_;
  udp::socket socket_;
  udp::endpoint sender_;
  std::uint16_t port_ = 0;
  std::array<char, 65536> buffer_{};
  mutable std::mutex mutex_;
  SignalCounts counts_;
  std::thread thread_;
};

}  // namespace

DeviceResult<std::unique_ptr<SignalServer>> openFudiServer(std::uint16_t port, const std::string& address,
                                                           SignalReceiver receiver) {
  auto server = std::make_unique<FudiServer>(std::move(receiver));
  ErrorCode error;
  const asio::ip::address_v4 ip = asio::ip::make_address_v4(address, error);
  if (!error) error = server->start(udp::endpoint(ip, port));
  if (error) {
    return DeviceTrouble{"UDP port " + address + ":" + std::to_string(port),
                         "cannot be listened on (" + error.message() + ")", "Choose another port"};
  }
  return std::unique_ptr<SignalServer>(std::move(server));
}

struct SignalSender::Socket {
  asio::io_context context;
  udp::socket socket{context};
  udp::endpoint target;
  std::uint64_t failed = 0;
};

SignalSender::SignalSender(std::unique_ptr<Socket> socket) : socket_(std::move(socket)) {}
SignalSender::~SignalSender() = default;

DeviceResult<std::unique_ptr<SignalSender>> SignalSender::open(const std::string& host, std::uint16_t port) {
  auto s = std::make_unique<Socket>();
  ErrorCode error;
  udp::resolver resolver(s->context);
  const auto found = resolver.resolve(udp::v4(), host, std::to_string(port), error);
  if (!error && !found.empty()) {
    s->target = *found.begin();
    s->socket.open(udp::v4(), error);
  }
  if (error || found.empty()) {
    return DeviceTrouble{host + ":" + std::to_string(port), "cannot be sent to (" + error.message() + ")",
                         "Check host and port"};
  }
  return std::unique_ptr<SignalSender>(new SignalSender(std::move(s)));
}

void SignalSender::send(const SignalMessage& message) {
  const std::string text = toFudi(message);
  ErrorCode error;
  socket_->socket.send_to(asio::buffer(text), socket_->target, 0, error);
  if (error) ++socket_->failed;
}

std::uint64_t SignalSender::failed() const { return socket_->failed; }

}  // namespace detent::playback
