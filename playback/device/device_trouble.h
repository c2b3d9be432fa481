// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How the device room reports: it may not include model, so it has its own small result; the front door turns
// it into a Failure with exit code 6.

#include <string>
#include <utility>
#include <variant>

namespace detent::playback {

/// A device that is missing, busy, lost or refuses.
struct DeviceTrouble {
  std::string device;  ///< name as asked for
  std::string problem;
  std::string remedy;
  bool wrongUsage = false;  ///< the request itself could not mean anything
};

template <class T>
class [[nodiscard]] DeviceResult {
 public:
  DeviceResult(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  DeviceResult(DeviceTrouble trouble) : state_(std::in_place_index<1>, std::move(trouble)) {}
  explicit operator bool() const { return state_.index() == 0; }
  T& operator*() { return std::get<0>(state_); }
  T* operator->() { return &std::get<0>(state_); }
  const DeviceTrouble& trouble() const { return std::get<1>(state_); }

 private:
  std::variant<T, DeviceTrouble> state_;
};

}  // namespace detent::playback
