// SPDX-License-Identifier: GPL-3.0-or-later
// Linked into a program by line_pages.py: keeps clang's counters of a run
// (-fsanitize-coverage=inline-8bit-counters,pc-table) and writes them to the folder in DETENT_LINE_PAGES when
// the process ends.

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

namespace {

/// One for each object file of the program, in the order of linking.
template <class T>
using Parts = std::vector<std::pair<const T*, const T*>>;

// Never destroyed: objects register before main, and the counters are written after the last static object
// is gone.
Parts<std::uint8_t>& counters() {
  static auto* const parts = new Parts<std::uint8_t>;
  return *parts;
}
Parts<std::uintptr_t>& addresses() {
  static auto* const parts = new Parts<std::uintptr_t>;
  return *parts;
}

template <class T>
void write(const Parts<T>& parts, const std::string& path) {
  std::ofstream file(path, std::ios::binary);
  for (const auto& [first, last] : parts)
    file.write(reinterpret_cast<const char*>(first),
               reinterpret_cast<const char*>(last) - reinterpret_cast<const char*>(first));
}

void writeAll() {
  const char* const folder = std::getenv("DETENT_LINE_PAGES");
  if (folder == nullptr) return;
  write(counters(), std::string(folder) + "/" + std::to_string(getpid()) + ".counters");
  write(addresses(), std::string(folder) + "/addresses");
}

}  // namespace

extern "C" void __sanitizer_cov_8bit_counters_init(const std::uint8_t* first, const std::uint8_t* last) {
  if (counters().empty()) std::atexit(writeAll);
  counters().emplace_back(first, last);
}

extern "C" void __sanitizer_cov_pcs_init(const std::uintptr_t* first, const std::uintptr_t* last) {
  addresses().emplace_back(first, last);
}
