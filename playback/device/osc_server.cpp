// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <atomic>
#include <cerrno>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include <arpa/inet.h>
#include <lo/lo.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "playback/device/signal_server.h"
#include "playback/device/steady_clock.h"

namespace detent::playback {

namespace {

constexpr int receiverPriority = 60;
constexpr int stopCheck_ms = 100;
constexpr std::size_t mostArguments = 3;

void ignoreError(int, const char*, const char*) {}

class OscServer : public SignalServer {
 public:
  explicit OscServer(SignalReceiver receiver) : receiver_(std::move(receiver)) {}
  ~OscServer() override {
    stopping_ = true;
    if (thread_.joinable()) thread_.join();
    if (server_ != nullptr) lo_server_free(server_);
  }

  /// Why not; 0 if it listens.
  int start(std::uint16_t port, const std::string& address) {
    // liblo listens on every address, on a port of the system's choice; its socket is then replaced by ours.
    server_ = lo_server_new_with_proto(nullptr, LO_UDP, ignoreError);
    if (server_ == nullptr) return ENOMEM;
    const int socket = boundSocket(port, address);
    if (socket < 0) return errno;
    const int replaced = ::dup2(socket, lo_server_get_socket_fd(server_));
    ::close(socket);
    if (replaced < 0) return errno;
    // A bundle stamped for the future would be held back by liblo on another clock; its messages count from
    // arrival.
    lo_server_enable_queue(server_, 0, 1);
    lo_server_add_method(server_, nullptr, nullptr, &OscServer::onMessage, this);
    thread_ = std::thread([this] {
      requestRealtime(receiverPriority);
      while (!stopping_) lo_server_recv_noblock(server_, stopCheck_ms);
    });
    return 0;
  }

  void dispatch(std::string_view packet) {
    std::vector<char> copy(packet.begin(), packet.end());  // liblo turns the bytes round in place
    lo_server_dispatch_data(server_, copy.data(), copy.size());
  }

  std::uint16_t port() const override { return port_; }
  SignalCounts counts() const override {
    const std::lock_guard lock(mutex_);
    return counts_;
  }

 private:
  static int onMessage(const char* path, const char* types, lo_arg** argv, int argc, lo_message, void* self) {
    static_cast<OscServer*>(self)->handle(path, types, argv, argc, now_s());
    return 0;
  }

  void handle(const char* path, const char* types, lo_arg** argv, int argc, double arrival_s) {
    std::array<double, mostArguments> values{};
    bool ok = argc >= 0 && argc <= static_cast<int>(mostArguments);
    for (int i = 0; ok && i < argc; ++i) {
      const auto type = static_cast<lo_type>(types[i]);
      ok = lo_is_numerical_type(type) != 0;
      if (ok) values[static_cast<std::size_t>(i)] = static_cast<double>(lo_hires_val(type, argv[i]));
    }
    SignalMessage message;
    ok = ok && fromOsc(path, values.data(), static_cast<std::size_t>(argc), message);
    {
      const std::lock_guard lock(mutex_);
      ++counts_.packets;
      ++(ok ? counts_.messages : counts_.malformed);
    }
    if (ok) receiver_(message, arrival_s);
  }

  /// A UDP socket on that address, or -1 with errno.
  int boundSocket(std::uint16_t port, const std::string& address) {
    sockaddr_in where{};
    where.sin_family = AF_INET;
    where.sin_port = htons(port);
    if (::inet_pton(AF_INET, address.c_str(), &where.sin_addr) != 1) {
      errno = EADDRNOTAVAIL;
      return -1;
    }
    const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    if (socket < 0) return -1;
    socklen_t length = sizeof where;
    auto* name = reinterpret_cast<sockaddr*>(&where);
    if (::bind(socket, name, sizeof where) != 0 || ::getsockname(socket, name, &length) != 0) {
      const int why = errno;
      ::close(socket);
      errno = why;
      return -1;
    }
    port_ = ntohs(where.sin_port);
    return socket;
  }

  SignalReceiver receiver_;
  std::uint16_t port_ = 0;
  lo_server server_ = nullptr;
  std::atomic<bool> stopping_{false};
  mutable std::mutex mutex_;
  SignalCounts counts_;
  std::thread thread_;
};

}  // namespace

bool handleOscPacket(SignalServer& server, std::string_view packet) {
  auto* osc = dynamic_cast<OscServer*>(&server);
  if (osc == nullptr) return false;
  osc->dispatch(packet);
  return true;
}

DeviceResult<std::unique_ptr<SignalServer>> openOscServer(std::uint16_t port, const std::string& address,
                                                          SignalReceiver receiver) {
  auto server = std::make_unique<OscServer>(std::move(receiver));
  if (const int error = server->start(port, address); error != 0) {
    return DeviceTrouble{"OSC port " + address + ":" + std::to_string(port),
                         "cannot be listened on (" + std::system_category().message(error) + ")",
                         "Choose another port"};
  }
  return std::unique_ptr<SignalServer>(std::move(server));
}

}  // namespace detent::playback
