// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <string_view>

#include "importer/program/library_program.h"

namespace detent::importer {

bool isLibraryCommand(int argc, const char* const* argv) {
  constexpr std::array<std::string_view, 5> commands{"index", "find", "report", "--help", "-h"};
  if (argc < 3 || std::string_view(argv[1]) != "library") return false;
  return std::ranges::find(commands, std::string_view(argv[2])) != commands.end();
}

}  // namespace detent::importer
