// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/file/base64.h"

#include <cstdint>

namespace detent {
namespace {

constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

}  // namespace

std::string base64From(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::string_view three = bytes.substr(i, 3);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (k < three.size() ? static_cast<unsigned char>(three[k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= three.size() ? alphabet[bits >> (18 - 6 * k) & 63u] : '=';
  }
  return text;
}

std::optional<std::string> bytesFromBase64(std::string_view text) {
  if (text.size() % 4 != 0) return {};
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t bits = 0;
  int held = 0;  // number of pending bits
  const std::size_t letters = text.find_last_not_of('=') + 1;
  if (text.size() - letters > 2) return {};
  for (const char letter : text.substr(0, letters)) {
    const std::size_t six = alphabet.find(letter);
    if (six == std::string_view::npos) return {};
    bits = bits << 6 | static_cast<std::uint32_t>(six);
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes += static_cast<char>(bits >> held & 255u);
  }
  const bool leftOver = (bits & ((1u << held) - 1)) != 0;
  return leftOver ? std::nullopt : std::optional(std::move(bytes));
}

}  // namespace detent
