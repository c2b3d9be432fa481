// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/text_output.h"

#include <array>
#include <charconv>
#include <cstdio>
#include <fstream>
#include <random>

namespace detent::playback {

Result<Done> writeWholeFile(const std::filesystem::path& file, const std::string& text) {
  std::random_device random;
  char suffix[32];
  std::snprintf(suffix, sizeof suffix, ".%08x%08x.part", random(), random());
  std::filesystem::path draft = file;
  draft += suffix;
  std::error_code error, ignored;
  {
    std::ofstream out(draft, std::ios::binary);
    out << text;
    out.flush();
    if (!out) error = std::make_error_code(std::errc::io_error);
  }
  if (!error) std::filesystem::rename(draft, file, error);
  if (!error) return Done{};
  std::filesystem::remove(draft, ignored);
  return Failure{FailureCode::unreadableInput, file.string(), "",
                 "cannot be written (" + error.message() + ")",
                 "Check the folder, its rights and the free space"};
}

std::string exact(double value) {
  std::array<char, 32> digits;
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  return error == std::errc() ? std::string(digits.data(), end) : "0";
}

}  // namespace detent::playback
