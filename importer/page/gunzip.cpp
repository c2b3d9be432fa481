// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/gunzip.h"

#include <algorithm>
#include <limits>

#include <zlib.h>

namespace detent::importer {
namespace {

constexpr int kGzipOnly = 16;  // added to the window's bits: zlib's way to ask for a gzip header

/// Owns zlib's state.
class Inflater {
 public:
  Inflater() : ready_(inflateInit2(&stream_, MAX_WBITS + kGzipOnly) == Z_OK) {}
  ~Inflater() {
    if (ready_) inflateEnd(&stream_);
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  bool ready() const { return ready_; }
  z_stream& stream() { return stream_; }

 private:
  z_stream stream_{};
  bool ready_;
};

}  // namespace

bool isGzip(std::span<const unsigned char> bytes) {
  return bytes.size() > 2 && bytes[0] == 0x1f && bytes[1] == 0x8b && bytes[2] == Z_DEFLATED;
}

std::optional<std::vector<unsigned char>> gunzip(std::span<const unsigned char> bytes,
                                                 std::size_t most_bytes) {
  Inflater inflater;
  if (!inflater.ready() || bytes.size() > std::numeric_limits<uInt>::max()) return {};
  z_stream& stream = inflater.stream();
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
