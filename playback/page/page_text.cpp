// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/page/page_text.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace detent::playback {

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t here = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (k < here ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text.push_back(k <= here ? digits[group >> (18 - 6 * k) & 63] : '=');
  }
  return text;
}

/// Little-endian, as WebAssembly and the Float64Array of browsers on all supported machines expect.
std::string base64(const std::vector<double>& numbers) {
  std::string bytes;
  for (const double number : numbers)
    for (unsigned shift = 0; shift < 64; shift += 8)
      bytes.push_back(static_cast<char>(std::bit_cast<std::uint64_t>(number) >> shift & 0xFF));
  return base64(bytes);
}

std::string insideScript(std::string_view json) {
  std::string text;
  for (const char c : json) {
    if (c == '<')
      text += "\\u003c";
    else
      text.push_back(c);
  }
  return text;
}

std::string insideElement(std::string_view text) {
  std::string escaped;
  for (const char c : text) escaped += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
  return escaped;
}

std::string filled(std::string_view html,
                   const std::vector<std::pair<std::string_view, std::string>>& parts) {
  std::string page;
  while (!html.empty()) {
    const std::size_t at = html.find('@');
    page += html.substr(0, at);
    if (at == std::string_view::npos) break;
    html.remove_prefix(at);
    const auto part =
        std::find_if(parts.begin(), parts.end(), [&](const auto& p) { return html.starts_with(p.first); });
    if (part == parts.end()) {
      page += '@';
      html.remove_prefix(1);
    } else {
      page += part->second;
      html.remove_prefix(part->first.size());
    }
  }
  return page;
}

}  // namespace detent::playback
