// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/falcon_usb.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <libusb-1.0/libusb.h>
#include <poll.h>
#include <time.h>

#include "playback/device/steady_clock.h"

namespace detent::playback {

namespace {

constexpr std::uint16_t vendor = 0x0403, product = 0xcb48;
constexpr unsigned char endpointIn = 0x81, endpointOut = 0x02;
constexpr std::size_t packetBytes = 64, statusBytes = 2;  // the chip's own status bytes, in front of all data
constexpr unsigned control_ms = 300;
constexpr double usbFarewell_s = 0.2;

// FTDI's vendor requests (libftdi, ftdi.h).
constexpr std::uint8_t vendorOut = 0x40;
enum class Request : std::uint8_t { reset = 0, modem = 1, flow = 2, baud = 3, format = 4, latency = 9 };
constexpr std::uint16_t purgeReceived = 1, purgeSent = 2, rtsLow = 0x0200, dtrLow = 0x0100, dtrHigh = 0x0101;
constexpr std::uint16_t eightBits = 8, noFlow = 0, baud9600 = 0x4138, baud140000 = 0x15, baud1500000 = 2;

struct Setting {
  Request request;
  std::uint16_t value;
};
constexpr Setting helloLine[] = {
    {Request::reset, purgeReceived}, {Request::reset, purgeSent},  {Request::latency, 16},
    {Request::baud, baud9600},       {Request::format, eightBits}, {Request::flow, noFlow},
    {Request::modem, rtsLow},        {Request::modem, dtrLow},     {Request::modem, dtrHigh}};
constexpr Setting uploadLine[] = {{Request::modem, dtrLow}, {Request::baud, baud140000}};
constexpr Setting runLine[] = {{Request::latency, 1},
                               {Request::baud, baud1500000},
                               {Request::reset, purgeReceived},
                               {Request::reset, purgeSent}};

std::span<const Setting> settingsOf(FalconLine line) {
  switch (line) {
    case FalconLine::hello:
      return helloLine;
    case FalconLine::upload:
      return uploadLine;
    case FalconLine::run:
      break;
  }
  return runLine;
}

std::string falconName(unsigned number) { return "Novint Falcon " + std::to_string(number); }

Failure usbTrouble(unsigned number, int error) {
  if (error == LIBUSB_ERROR_ACCESS) {
    return {FailureCode::deviceTrouble, falconName(number), "",
            Message("you have no permission to use the device"),
            Message("Give yourself the permission with a udev rule (docs/guide/force-feedback.md), then plug "
                    "the device in again")};
  }
  if (error == LIBUSB_ERROR_BUSY) {
    return {FailureCode::deviceTrouble, falconName(number), "",
            Message("the device is in use by another program"), Message("End the other program")};
  }
  return {FailureCode::deviceTrouble, falconName(number), "",
          Message("the device cannot be opened (%1)", libusb_strerror(static_cast<libusb_error>(error))),
          Message("Unplug the device, switch its power off and on, plug it in again")};
}

}  // namespace

// Both transfers call back inside libusb_handle_events, on the thread that uses the device.
struct FalconUsb::Link {
  libusb_context* context = nullptr;
  libusb_device_handle* handle = nullptr;
  libusb_transfer *in = nullptr, *out = nullptr;
  const libusb_pollfd** descriptors = nullptr;
  std::vector<pollfd> polled;
  std::array<std::uint8_t, packetBytes> incoming{}, outgoing{};
  std::array<std::uint8_t, 4 * packetBytes> inbox{}, handed{};
  std::size_t inboxBytes = 0;
  bool listening = false, sending = false, gone = false;

  ~Link() {
    if (handle != nullptr) {
      if (listening) libusb_cancel_transfer(in);
      if (sending) libusb_cancel_transfer(out);
      for (const double end_s = now_s() + usbFarewell_s; (listening || sending) && now_s() < end_s;)
        wait(end_s);
      libusb_release_interface(handle, 0);
      libusb_close(handle);
    }
    // A transfer that the bus has not returned must not be freed, so it leaks.
    if (!listening) libusb_free_transfer(in);
    if (!sending) libusb_free_transfer(out);
    if (descriptors != nullptr) libusb_free_pollfds(descriptors);
    if (context != nullptr) libusb_exit(context);
  }

  int start(unsigned number) {
    if (const int error = libusb_init(&context); error != 0) return error;
    if (const int error = openDevice(number); error != 0) return error;
    libusb_set_auto_detach_kernel_driver(handle, 1);
    if (const int error = libusb_claim_interface(handle, 0); error != 0) return error;
    in = libusb_alloc_transfer(0);
    out = libusb_alloc_transfer(0);
    descriptors = libusb_get_pollfds(context);
    if (in == nullptr || out == nullptr || descriptors == nullptr) return LIBUSB_ERROR_NO_MEM;
    for (const libusb_pollfd* const* d = descriptors; *d != nullptr; ++d)
      polled.push_back({(*d)->fd, (*d)->events, 0});
    libusb_fill_bulk_transfer(in, handle, endpointIn, incoming.data(), static_cast<int>(incoming.size()),
                              received, this, 0);
    listen();
    return gone ? LIBUSB_ERROR_IO : 0;
  }

  int openDevice(unsigned number) {
    libusb_device** devices = nullptr;
    const ssize_t count = libusb_get_device_list(context, &devices);
    if (count < 0) return static_cast<int>(count);
    int error = LIBUSB_ERROR_NOT_FOUND;
    for (ssize_t i = 0; i < count; ++i) {
      libusb_device_descriptor about{};
      if (libusb_get_device_descriptor(devices[i], &about) != 0 || about.idVendor != vendor ||
          about.idProduct != product)
        continue;
      if (number-- > 0) continue;
      error = libusb_open(devices[i], &handle);
      break;
    }
    libusb_free_device_list(devices, 1);
    return error;
  }

  void listen() {
    listening = !gone && libusb_submit_transfer(in) == 0;
    gone = gone || !listening;
  }

  static void LIBUSB_CALL received(libusb_transfer* transfer) {
    Link& link = *static_cast<Link*>(transfer->user_data);
    link.listening = false;
    if (transfer->status == LIBUSB_TRANSFER_CANCELLED) return;
    link.gone = link.gone || transfer->status != LIBUSB_TRANSFER_COMPLETED;
    const auto bytes = static_cast<std::size_t>(std::max(0, transfer->actual_length));
    if (bytes > statusBytes) {
      // Bytes that nobody took are outdated, so they make room for the newest.
      if (link.inboxBytes + bytes > link.inbox.size()) link.inboxBytes = 0;
      std::copy_n(transfer->buffer + statusBytes, bytes - statusBytes, link.inbox.data() + link.inboxBytes);
      link.inboxBytes += bytes - statusBytes;
    }
    link.listen();
  }

  static void LIBUSB_CALL delivered(libusb_transfer* transfer) {
    Link& link = *static_cast<Link*>(transfer->user_data);
    link.sending = false;
    link.gone = link.gone || (transfer->status != LIBUSB_TRANSFER_COMPLETED &&
                              transfer->status != LIBUSB_TRANSFER_CANCELLED);
  }

  // libusb can wait only in whole milliseconds, and one millisecond is a period.
  void wait(double deadline_s) {
    const double left_s = std::max(0.0, deadline_s - now_s());
    timespec time{};
    time.tv_sec = static_cast<time_t>(left_s);
    time.tv_nsec = static_cast<long>((left_s - static_cast<double>(time.tv_sec)) * 1e9);
    ::ppoll(polled.data(), polled.size(), &time, nullptr);
    timeval none{};
    libusb_handle_events_timeout_completed(context, &none, nullptr);
  }
};

FalconUsb::FalconUsb(std::unique_ptr<Link> link) : link_(std::move(link)) {}
FalconUsb::~FalconUsb() = default;

Result<std::unique_ptr<FalconUsb>> FalconUsb::open(unsigned number) {
  auto link = std::make_unique<Link>();
  const int error = link->start(number);
  if (error == LIBUSB_ERROR_NOT_FOUND || error == LIBUSB_ERROR_NO_DEVICE) {
    return Failure{
        FailureCode::deviceTrouble,
        falconName(number),
        "",
        Message("the Falcon is not connected"),
        {{RemedyKind::advice, Message("Check its cable and its power supply, or try the simulated Falcon")},
         {RemedyKind::advice, Message("On the command line: --device sim:falcon")}}};
  }
  if (error != 0) return usbTrouble(number, error);
  return std::unique_ptr<FalconUsb>(new FalconUsb(std::move(link)));
}

bool FalconUsb::alive() const { return !link_->gone; }

bool FalconUsb::set(FalconLine line) {
  for (const Setting& s : settingsOf(line)) {
    const int error = libusb_control_transfer(link_->handle, vendorOut, static_cast<std::uint8_t>(s.request),
                                              s.value, 0, nullptr, 0, control_ms);
    if (error == LIBUSB_ERROR_NO_DEVICE) link_->gone = true;
    if (error != 0) return false;
  }
  link_->inboxBytes = 0;
  return true;
}

bool FalconUsb::send(std::span<const std::uint8_t> bytes) {
  if (link_->gone || link_->sending || bytes.size() > link_->outgoing.size()) return false;
  std::copy(bytes.begin(), bytes.end(), link_->outgoing.begin());
  libusb_fill_bulk_transfer(link_->out, link_->handle, endpointOut, link_->outgoing.data(),
                            static_cast<int>(bytes.size()), Link::delivered, link_.get(), 0);
  link_->sending = libusb_submit_transfer(link_->out) == 0;
  link_->gone = link_->gone || !link_->sending;
  return link_->sending;
}

bool FalconUsb::sent(double deadline_s) {
  do {
    link_->wait(deadline_s);
  } while (link_->sending && !link_->gone && now_s() < deadline_s);
  return !link_->sending && !link_->gone;
}

std::span<const std::uint8_t> FalconUsb::receive(double deadline_s) {
  do {
    link_->wait(deadline_s);
  } while (link_->inboxBytes == 0 && !link_->gone && now_s() < deadline_s);
  std::copy_n(link_->inbox.begin(), link_->inboxBytes, link_->handed.begin());
  return {link_->handed.data(), std::exchange(link_->inboxBytes, 0)};
}

}  // namespace detent::playback
