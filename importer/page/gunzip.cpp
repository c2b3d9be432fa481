// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/gunzip.h"

#include <limits>
#include <memory>

#include <zlib.h>

namespace detent::importer {
bool isGzip(std::span<const unsigned char> bytes) {
  return bytes.size() > 2 && bytes[0] == 0x1f && bytes[1] == 0x8b && bytes[2] == Z_DEFLATED;
}

std::optional<std::vector<unsigned char>> gunzip(std::span<const unsigned char> bytes,
                                                 std::size_t most_bytes) {
  constexpr int gzipOnly = 16;  // added to the window bits: makes zlib expect a gzip header
  z_stream stream{};
  if (bytes.size() > std::numeric_limits<uInt>::max() || inflateInit2(&stream, MAX_WBITS + gzipOnly) != Z_OK)
    return {};
  const std::unique_ptr<z_stream, int (*)(z_stream*)> owner(&stream, inflateEnd);
  stream.next_in = const_cast<Bytef*>(bytes.data());  // zlib reads it only
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::vector<unsigned char> content;
  std::vector<unsigned char> part(std::size_t{1} << 16);
  int state = Z_OK;
  while (state == Z_OK && content.size() <= most_bytes) {
    stream.next_out = part.data();
    stream.avail_out = static_cast<uInt>(part.size());
    state = inflate(&stream, Z_NO_FLUSH);
    content.insert(content.end(), part.data(), part.data() + (part.size() - stream.avail_out));
  }
  if (state != Z_STREAM_END || content.size() > most_bytes) return {};
  return content;
}

}  // namespace detent::importer
