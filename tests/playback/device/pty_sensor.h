// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A pseudo-terminal as the serial force sensor, behind a link with a stable name so that it can be unplugged.

#include <string>
#include <string_view>

namespace detent::test {

class PtySensor {
 public:
  PtySensor();
  ~PtySensor();
  PtySensor(const PtySensor&) = delete;
  PtySensor& operator=(const PtySensor&) = delete;
  bool ready() const { return master_ >= 0; }
  const std::string& port() const { return link_; }
  /// False when nothing could be written (buffer full: nobody reads).
  bool send(std::string_view bytes);
  void unplug();
  void plugIn();

 private:
  int master_ = -1;
  std::string link_;
};

}  // namespace detent::test
