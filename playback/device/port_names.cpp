// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/port_names.h"

#include <fstream>
#include <system_error>
#include <tuple>
#include <utility>

#include <unistd.h>

namespace detent::playback {

namespace {

namespace fs = std::filesystem;

std::string firstLineOf(const fs::path& file) {
  std::string line;
  std::getline(std::ifstream(file), line);
  return line;
}

/// Identity of the USB device of a port: maker, product, serial number, interface.
using UsbIdentity = std::tuple<std::string, std::string, std::string, std::string>;

/// Identity of the port with this name; the serial number is empty if there is none.
UsbIdentity identityOf(const fs::path& ttys, const fs::path& name) {
  std::error_code error;
  std::string interface;
  const fs::path device = fs::canonical(ttys / name / "device", error);
  for (fs::path at = device; !error && at.has_relative_path(); at = at.parent_path()) {
    if (interface.empty()) interface = firstLineOf(at / "bInterfaceNumber");
    std::string vendor = firstLineOf(at / "idVendor");
    if (!vendor.empty())
      return {std::move(vendor), firstLineOf(at / "idProduct"), firstLineOf(at / "serial"), interface};
  }
  return {};
}

}  // namespace

std::string holderOf(const std::string& port) {
  std::error_code error;
  const fs::path device = fs::canonical(port, error);
  for (fs::directory_iterator process("/proc", error), end; !error && process != end;
       process.increment(error)) {
    const std::string number = process->path().filename().string();
    if (number.find_first_not_of("0123456789") != std::string::npos || std::stol(number) == ::getpid())
      continue;
    std::error_code hidden;  // owned by another user, or ended meanwhile
    for (fs::directory_iterator open(process->path() / "fd", hidden); !hidden && open != end;
         open.increment(hidden)) {
      std::error_code closed;
      if (fs::read_symlink(open->path(), closed) != device) continue;
      std::string name;
      std::getline(std::ifstream(process->path() / "comm"), name);
      return name.append(" (process ").append(number).append(")");
    }
  }
  return {};
}

std::string sameSerialNumber(const fs::path& port, const fs::path& ttys) {
  std::error_code error;
  if (port.parent_path().filename() != "by-id") return {};
  const fs::path name = fs::canonical(port, error).filename();
  const UsbIdentity own = identityOf(ttys, name);
  if (std::get<2>(own).empty()) return {};
  for (fs::directory_iterator other(ttys, error), end; !error && other != end; other.increment(error)) {
    const fs::path otherName = other->path().filename();
    if (otherName != name && identityOf(ttys, otherName) == own) return "/dev/" + otherName.string();
  }
  return {};
}

}  // namespace detent::playback
