// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/playback/device/falcon_rig.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstring>
#include <deque>
#include <list>
#include <mutex>
#include <stdexcept>

#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>
#include <umockdev.h>

#include "playback/device/falcon_protocol.h"

namespace detent::test {

namespace {

using Clock = std::chrono::steady_clock;
using Bytes = std::vector<std::uint8_t>;

constexpr const char* node = "/dev/bus/usb/001/001";
constexpr std::uint8_t requestModem = 1, requestBaud = 3, requestLatency = 9;
constexpr std::uint16_t baud9600 = 0x4138, baud140000 = 0x15, baud1500000 = 2, dtrHigh = 0x0101;
constexpr std::size_t chipPacket = 64, chipStatus = 2;

// FTDI full-speed device 0403:cb48, one interface, bulk in 0x81, bulk out 0x02, 64 bytes.
constexpr const char* description =
    "P: /devices/usb1\n"
    "N: bus/usb/001/001\n"
    "E: SUBSYSTEM=usb\nE: DRIVER=usb\nE: BUSNUM=001\nE: DEVNUM=001\n"
    "E: DEVNAME=/dev/bus/usb/001/001\nE: DEVTYPE=usb_device\n"
    "A: bConfigurationValue=1\\n\nA: busnum=1\\n\nA: devnum=1\\n\nA: speed=12\\n\n"
    "H: descriptors=1201000200000008030448cb000400000001"
    "0902200001010080320904000002ffffff000705810240000007050202400000\n";

/// The processor: boot loader until it has a firmware, then packets.
class Processor {
 public:
  explicit Processor(FalconRig& rig) : rig_(rig) {}

  void control(std::uint8_t request, std::uint16_t value) {
    if (request == requestBaud) baud_ = value, heard_.clear();
    if (request == requestLatency) latency_ms_ = value;
    if (request == requestModem && value == dtrHigh && baud_ == baud9600) reset();
  }
  void reset() { image_.clear(), heard_.clear(), running_ = synchronised_ = false, spoilt_ = false; }

  void write(const std::uint8_t* bytes, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) write(bytes[i]);
  }
  /// The next bytes from the chip, at most `most`.
  Bytes take(std::size_t most) {
    const std::size_t count = std::min(most, replies_.size());
    Bytes bytes(replies_.begin(), replies_.begin() + static_cast<std::ptrdiff_t>(count));
    replies_.erase(replies_.begin(), replies_.begin() + static_cast<std::ptrdiff_t>(count));
    return bytes;
  }
  bool waiting() const { return !replies_.empty(); }
  int latency_ms() const { return latency_ms_; }
  const Bytes& image() const { return image_; }

 private:
  void write(std::uint8_t byte) {
    if (running_) {
      if (baud_ == baud1500000) packet(byte);
    } else if (baud_ == baud9600) {
      heard_.push_back(byte);
      const Bytes hello{0x0a, 0x43, 0x0d};
      if (heard_.size() >= 3 && std::equal(hello.rbegin(), hello.rend(), heard_.rbegin()))
        say({0x0a, 0x44, 0x2c, 0x0d});
    } else if (baud_ == baud140000) {
      load(byte);
    }
  }

  void load(std::uint8_t byte) {
    if (!synchronised_) {
      synchronised_ = byte == 0x41;
      if (synchronised_) say({byte});
      return;
    }
    image_.push_back(byte);
    const bool spoil = !spoilt_ && image_.size() == 100 && rig_.badEchoes > 0;
    if (spoil) spoilt_ = true, --rig_.badEchoes;
    say({static_cast<std::uint8_t>(spoil ? byte ^ 1 : byte)});
    running_ = !spoilt_ && playback::isFalconFirmware(image_);
  }

  void packet(std::uint8_t byte) {
    if (byte == '<') heard_.clear();
    heard_.push_back(byte);
    if (byte != '>' || heard_.size() != 16) return;
    ++rig_.packets;
    for (std::size_t i = 0; i < 3; ++i) {
      std::uint16_t value = 0;
      for (std::size_t d = 0; d < 4; ++d)
        value = static_cast<std::uint16_t>(value | (heard_[1 + 4 * i + d] - 'A') << (4 * d));
      rig_.motors[i] = static_cast<std::int16_t>(value);
    }
    rig_.light = (heard_[13] - 'A') & 14;
    playback::FalconCommand asIf;
    for (std::size_t i = 0; i < 3; ++i) asIf.motors[i] = rig_.counts[i];
    const playback::FalconPacket answer = playback::falconPacket(asIf);
    Bytes bytes(answer.begin(), answer.end());
    bytes[13] = static_cast<std::uint8_t>('A' + (rig_.homed ? 0x70 : 0x30));
    switch (rig_.answer) {
      case FalconRig::Answer::good:
        return say(bytes);
      case FalconRig::Answer::none:
        return;
      case FalconRig::Answer::half:
        return say(Bytes(bytes.begin(), bytes.begin() + 8));
      case FalconRig::Answer::twice:
        say(bytes);
        return say(bytes);
      case FalconRig::Answer::nonsense:
        bytes[3] = 'z';
        return say(bytes);
    }
  }

  void say(const Bytes& bytes) { replies_.insert(replies_.end(), bytes.begin(), bytes.end()); }

  FalconRig& rig_;
  std::uint16_t baud_ = baud1500000;
  int latency_ms_ = 16;
  bool running_ = false, synchronised_ = false, spoilt_ = false;
  Bytes image_, heard_;
  std::deque<std::uint8_t> replies_;
};

struct Urb {
  UMockdevIoctlData* data;
  usbdevfs_urb* urb() const { return reinterpret_cast<usbdevfs_urb*>(data->data); }
};

}  // namespace

struct FalconRig::Bus {
  explicit Bus(FalconRig& rig) : processor(rig) {
    testbed = umockdev_testbed_new();
    handler = umockdev_ioctl_base_new();
    g_signal_connect_after(handler, "handle-ioctl", G_CALLBACK(handle), this);
    if (umockdev_testbed_attach_ioctl(testbed, node, handler, nullptr) != 1)
      throw std::runtime_error("umockdev: no ioctl");
    add();
  }
  ~Bus() {
    g_object_unref(handler);
    g_object_unref(testbed);
  }

  void add() {
    if (umockdev_testbed_add_from_string(testbed, description, nullptr) != 1)
      throw std::runtime_error("umockdev: no device");
  }

  static gboolean handle(UMockdevIoctlBase*, UMockdevIoctlClient* client, Bus* bus) {
    const std::lock_guard lock(bus->mutex);
    const auto [result, error] =
        bus->answered(umockdev_ioctl_client_get_request(client), umockdev_ioctl_client_get_arg(client));
    umockdev_ioctl_client_complete(client, result, error);
    return TRUE;
  }

  struct Outcome {
    long result;
    int error;
  };

  Outcome answered(unsigned long request, UMockdevIoctlData* argument) {
    if (request == USBDEVFS_REAPURB || request == USBDEVFS_REAPURBNDELAY) return reap(argument);
    if (unplugged) return {-1, ENODEV};
    switch (request) {
      case USBDEVFS_GET_CAPABILITIES: {
        UMockdevIoctlData* d = umockdev_ioctl_data_resolve(argument, 0, sizeof(std::uint32_t), nullptr);
        const std::uint32_t can = USBDEVFS_CAP_BULK_CONTINUATION | USBDEVFS_CAP_NO_PACKET_SIZE_LIM |
                                  USBDEVFS_CAP_REAP_AFTER_DISCONNECT;
        std::memcpy(d->data, &can, sizeof can);
        umockdev_ioctl_data_unref(d);
        return {0, 0};
      }
      case USBDEVFS_CLAIMINTERFACE:
      case USBDEVFS_RELEASEINTERFACE:
        return {0, 0};
      case USBDEVFS_GETDRIVER:  // no kernel driver has claimed the device
      case USBDEVFS_IOCTL:
        return {-1, ENODATA};
      case USBDEVFS_SUBMITURB:
        return submit(argument);
      case USBDEVFS_DISCARDURB:
        return discard(argument);
      default:
        return {-1, ENOTTY};
    }
  }

  Outcome submit(UMockdevIoctlData* argument) {
    UMockdevIoctlData* data = umockdev_ioctl_data_resolve(argument, 0, sizeof(usbdevfs_urb), nullptr);
    auto* urb = reinterpret_cast<usbdevfs_urb*>(data->data);
    UMockdevIoctlData* buffer = umockdev_ioctl_data_resolve(data, offsetof(usbdevfs_urb, buffer),
                                                            static_cast<gsize>(urb->buffer_length), nullptr);
    if (urb->type == USBDEVFS_URB_TYPE_CONTROL) {
      processor.control(buffer->data[1], static_cast<std::uint16_t>(buffer->data[2] | buffer->data[3] << 8));
      urb->actual_length = 0;
      done.push_back({data});
    } else if ((urb->endpoint & 0x80) == 0) {
      processor.write(buffer->data, static_cast<std::size_t>(urb->buffer_length));
      urb->actual_length = urb->buffer_length;
      done.push_back({data});
    } else {
      pending.push_back({data});
      pendingSince = Clock::now();
    }
    umockdev_ioctl_data_unref(buffer);
    return {0, 0};
  }

  /// The chip answers as soon as it has something, or with its status alone when its latency is over.
  void fillPending() {
    if (pending.empty()) return;
    const bool timeUp = Clock::now() - pendingSince >= std::chrono::milliseconds(processor.latency_ms());
    if (!processor.waiting() && !timeUp) return;
    usbdevfs_urb* urb = pending.front().urb();
    const Bytes bytes =
        processor.take(std::min(chipPacket, static_cast<std::size_t>(urb->buffer_length)) - chipStatus);
    auto* to = static_cast<std::uint8_t*>(urb->buffer);
    to[0] = 0x01, to[1] = 0x60;
    std::copy(bytes.begin(), bytes.end(), to + chipStatus);
    urb->actual_length = static_cast<int>(bytes.size() + chipStatus);
    done.splice(done.end(), pending, pending.begin());
  }

  Outcome reap(UMockdevIoctlData* argument) {
    if (unplugged) {
      for (Urb& u : pending) u.urb()->status = -ENODEV;
      done.splice(done.end(), pending);
    }
    fillPending();
    if (done.empty()) return {-1, unplugged ? ENODEV : EAGAIN};
    UMockdevIoctlData* pointer = umockdev_ioctl_data_resolve(argument, 0, sizeof(gpointer), nullptr);
    umockdev_ioctl_data_set_ptr(pointer, 0, done.front().data);
    umockdev_ioctl_data_unref(pointer);
    umockdev_ioctl_data_unref(done.front().data);
    done.pop_front();
    return {0, 0};
  }

  Outcome discard(UMockdevIoctlData* argument) {
    const gulong address = *reinterpret_cast<gulong*>(argument->data);
    const auto found = std::find_if(pending.begin(), pending.end(),
                                    [&](const Urb& u) { return u.data->client_addr == address; });
    if (found == pending.end()) return {-1, EINVAL};
    found->urb()->status = -ENOENT;
    done.splice(done.end(), pending, found);
    return {0, 0};
  }

  mutable std::mutex mutex;
  Processor processor;
  UMockdevTestbed* testbed = nullptr;
  UMockdevIoctlBase* handler = nullptr;
  std::list<Urb> pending, done;
  Clock::time_point pendingSince;
  bool unplugged = false;
};

FalconRig::FalconRig() : bus_(std::make_unique<Bus>(*this)) {}
FalconRig::~FalconRig() = default;

void FalconRig::unplug() {
  {
    const std::lock_guard lock(bus_->mutex);
    bus_->unplugged = true;
  }
  umockdev_testbed_uevent(bus_->testbed, "/sys/devices/usb1", "remove");
  umockdev_testbed_remove_device(bus_->testbed, "/sys/devices/usb1");
}

void FalconRig::plugIn() {
  {
    const std::lock_guard lock(bus_->mutex);
    bus_->unplugged = false;
    bus_->done.clear();
  }
  bus_->add();
  umockdev_testbed_uevent(bus_->testbed, "/sys/devices/usb1", "add");
}

void FalconRig::powerCycle() {
  const std::lock_guard lock(bus_->mutex);
  bus_->processor.reset();
}

std::vector<std::uint8_t> FalconRig::firmware() const {
  const std::lock_guard lock(bus_->mutex);
  return bus_->processor.image();
}

std::vector<std::uint8_t> anyFalconFirmware() {
  constexpr std::size_t words = 3000;
  std::vector<std::uint8_t> image{0xaa, 0x08};
  image.resize(22, 0);
  const auto addWord = [&](std::size_t word) {
    image.push_back(static_cast<std::uint8_t>(word & 255));
    image.push_back(static_cast<std::uint8_t>(word >> 8 & 255));
  };
  addWord(words);
  addWord(0x3f);
  addWord(0x8002);
  for (std::size_t i = 0; i < words; ++i) addWord(7 * i);
  addWord(0);
  return image;
}

}  // namespace detent::test
