// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/log/zip_member.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include <zlib.h>

namespace detent::importer {
namespace {

// Records of the format (APPNOTE 6.3, sections 4.3.7, 4.3.12, 4.3.16), little-endian.
constexpr std::size_t endRecord_bytes = 22, centralHeader_bytes = 46, localHeader_bytes = 30;
constexpr std::size_t longestComment_bytes = 65535;

/// Little-endian number of `count` bytes at `at`; 0 outside the archive.
std::uint32_t number(std::string_view bytes, std::size_t at, std::size_t count) {
  if (at > bytes.size() || bytes.size() - at < count) return 0;
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i)
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  return value;
}

std::optional<std::size_t> endRecord(std::string_view bytes) {
  if (bytes.size() < endRecord_bytes) return {};
  const std::size_t last = bytes.size() - endRecord_bytes;
  for (std::size_t back = 0; back <= std::min(last, longestComment_bytes); ++back)
    if (bytes.substr(last - back, 4) == "PK\5\6") return last - back;
  return {};
}

/// Where the central directory describes the member.
std::optional<std::size_t> headerOf(std::string_view bytes, std::string_view member) {
  const auto end = endRecord(bytes);
  if (!end) return {};
  std::size_t at = number(bytes, *end + 16, 4);
  for (std::uint32_t left = number(bytes, *end + 10, 2); left > 0; --left) {
    if (at > bytes.size() || bytes.size() - at < centralHeader_bytes || bytes.substr(at, 4) != "PK\1\2")
      return {};
    const std::size_t name_bytes = number(bytes, at + 28, 2);
    if (bytes.substr(at + centralHeader_bytes, name_bytes) == member) return at;
    at += centralHeader_bytes + name_bytes + number(bytes, at + 30, 2) + number(bytes, at + 32, 2);
  }
  return {};
}

/// Raw deflate, at most `most_bytes`.
std::optional<std::string> inflated(std::string_view packed, std::size_t most_bytes) {
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) return {};
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));  // zlib reads it only
  stream.avail_in = static_cast<uInt>(packed.size());
  std::string text;
  char buffer[1 << 16];
  int state = Z_OK;
  while (state == Z_OK && text.size() <= most_bytes) {
    stream.next_out = reinterpret_cast<Bytef*>(buffer);
    stream.avail_out = sizeof buffer;
    state = inflate(&stream, Z_NO_FLUSH);
    text.append(buffer, sizeof buffer - stream.avail_out);
  }
  inflateEnd(&stream);
  if (state != Z_STREAM_END || text.size() > most_bytes) return {};
  return text;
}

}  // namespace

Result<std::string> zipMember(std::string_view bytes, std::string_view member, std::size_t most_bytes,
                              const std::string& subject) {
  const auto broken = [&](Message problem) {
    return Failure{
        FailureCode::unreadableInput, subject, {}, std::move(problem), Message("Save the spreadsheet again")};
  };
  const auto header = headerOf(bytes, member);
  if (!header) return broken(Message("it is no spreadsheet, or a damaged one"));
  if ((number(bytes, *header + 8, 2) & 1) != 0) return broken(Message("it is encrypted"));
  const std::uint32_t method = number(bytes, *header + 10, 2);
  const std::size_t packed_bytes = number(bytes, *header + 20, 4), local = number(bytes, *header + 42, 4);
  if (local > bytes.size() || bytes.size() - local < localHeader_bytes)
    return broken(Message("it is damaged"));
  const std::size_t from =
      local + localHeader_bytes + number(bytes, local + 26, 2) + number(bytes, local + 28, 2);
  if (from > bytes.size() || bytes.size() - from < packed_bytes) return broken(Message("it is cut short"));
  const std::string_view packed = bytes.substr(from, packed_bytes);
  if (method == 0 && packed.size() <= most_bytes) return std::string(packed);
  auto text = method == 8 ? inflated(packed, most_bytes) : std::nullopt;
  if (!text) return broken(Message("its content is damaged, or too large when unpacked"));
  return std::move(*text);
}

}  // namespace detent::importer
