// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/picture_header.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <set>
#include <string_view>

#include "model/text.h"

namespace detent::importer {
namespace {

/// Bounds-checked reading of integers. A read beyond the end gives 0 and is remembered.
class ByteReader {
 public:
  ByteReader(std::span<const unsigned char> bytes, bool bigEndian) : bytes_(bytes), bigEndian_(bigEndian) {}

  std::uint64_t number(std::size_t at, std::size_t size) const {
    if (at > bytes_.size() || size > bytes_.size() - at) {
      overrun_ = true;
      return 0;
    }
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i)
      value = value << 8 | bytes_[bigEndian_ ? at + i : at + size - 1 - i];
    return value;
  }
  std::uint32_t u8(std::size_t at) const { return static_cast<std::uint32_t>(number(at, 1)); }
  std::uint32_t u16(std::size_t at) const { return static_cast<std::uint32_t>(number(at, 2)); }
  std::uint32_t u32(std::size_t at) const { return static_cast<std::uint32_t>(number(at, 4)); }
  std::uint64_t u64(std::size_t at) const { return number(at, 8); }
  std::size_t size() const { return bytes_.size(); }
  bool overrun() const { return overrun_; }
  bool has(std::size_t at, std::string_view text) const {
    return at <= bytes_.size() && text.size() <= bytes_.size() - at &&
           std::memcmp(bytes_.data() + at, text.data(), text.size()) == 0;
  }
  std::span<const unsigned char> part(std::size_t at, std::size_t size) const {
    if (at >= bytes_.size()) return {};
    return bytes_.subspan(at, std::min(size, bytes_.size() - at));
  }

 private:
  std::span<const unsigned char> bytes_;
  bool bigEndian_;
  mutable bool overrun_ = false;
};

constexpr double mmPerInch = 25.4;  // exact by definition

std::optional<double> plausibleDpi(double dpi) {
  if (std::isfinite(dpi) && dpi >= 10 && dpi <= 10000) return dpi;
  return std::nullopt;
}

// ---- TIFF directories; also the form of EXIF

struct TiffDirectory {
  long long width_px = 0, height_px = 0;
  int orientation = 1;
  double resolution = 0;
  int resolutionUnit = 2;
  std::uint64_t next = 0;
  bool readable = false;
};

/// Reads TIFF directories. BigTIFF has entries and offsets of 8 bytes.
class TiffReader {
 public:
  explicit TiffReader(std::span<const unsigned char> bytes)
      : in_(bytes, bytes.size() > 1 && bytes[0] == 'M'), big_(in_.u16(2) == 43) {}

  bool isTiff() const {
    return (in_.has(0, "II") || in_.has(0, "MM")) && (in_.u16(2) == 42 || in_.u16(2) == 43);
  }
  std::uint64_t firstDirectory() const { return big_ ? in_.u64(8) : in_.u32(4); }

  TiffDirectory directory(std::uint64_t offset) const {
    TiffDirectory dir;
    if (offset < 8 || offset >= in_.size()) return dir;
    const std::size_t at = static_cast<std::size_t>(offset);
    const std::uint64_t entries = big_ ? in_.u64(at) : in_.u16(at);
    const std::size_t headSize = big_ ? 8 : 2, entrySize = big_ ? 20 : 12;
    if (entries > 4096 || at + headSize + static_cast<std::size_t>(entries) * entrySize > in_.size())
      return dir;
    for (std::size_t i = 0; i < entries; ++i) readEntry(at + headSize + i * entrySize, dir);
    const std::size_t nextAt = at + headSize + static_cast<std::size_t>(entries) * entrySize;
    // An EXIF block may end without the offset of a next directory.
    if (nextAt + (big_ ? 8 : 4) <= in_.size()) dir.next = big_ ? in_.u64(nextAt) : in_.u32(nextAt);
    dir.readable = true;
    return dir;
  }

 private:
  void readEntry(std::size_t at, TiffDirectory& dir) const {
    const std::uint32_t tag = in_.u16(at), type = in_.u16(at + 2);
    const std::size_t valueAt = at + (big_ ? 12 : 8);
    const auto integer = [&] {
      return static_cast<long long>(type == 3 ? in_.u16(valueAt) : in_.u32(valueAt));
    };
    switch (tag) {
      case 0x100:
        dir.width_px = integer();
        break;
      case 0x101:
        dir.height_px = integer();
        break;
      case 0x112:
        dir.orientation = static_cast<int>(std::clamp(integer(), 1LL, 8LL));
        break;
      case 0x128:
        dir.resolutionUnit = static_cast<int>(integer());
        break;
      case 0x11a:
        dir.resolution = rational(valueAt);
        break;
      default:
        break;
    }
  }

  double rational(std::size_t valueAt) const {
    const std::size_t at = big_ ? valueAt : static_cast<std::size_t>(in_.u32(valueAt));
    if (at + 8 > in_.size() || in_.u32(at + 4) == 0) return 0;
    return static_cast<double>(in_.u32(at)) / in_.u32(at + 4);
  }

  ByteReader in_;
  bool big_;
};

std::optional<double> dpiOf(const TiffDirectory& dir) {
  if (dir.resolutionUnit == 2) return plausibleDpi(dir.resolution);
  if (dir.resolutionUnit == 3) return plausibleDpi(dir.resolution * mmPerInch / 10);
  return std::nullopt;
}

/// EXIF is a TIFF file without pixels. Copies the entries of its first directory to `header`.
void applyExif(std::span<const unsigned char> exif, PictureHeader& header) {
  constexpr std::string_view prefix("Exif\0\0", 6);
  if (exif.size() > 6 && std::memcmp(exif.data(), prefix.data(), 6) == 0) exif = exif.subspan(6);
  const TiffReader reader(exif);
  if (!reader.isTiff()) return;
  const TiffDirectory dir = reader.directory(reader.firstDirectory());
  if (!dir.readable) return;
  header.orientation = dir.orientation;
  if (!header.dpi) header.dpi = dpiOf(dir);
}

std::vector<PictureHeader> tiffHeaders(std::span<const unsigned char> bytes, int maxPictures) {
  const TiffReader reader(bytes);
  std::vector<PictureHeader> headers;
  std::set<std::uint64_t> seen;  // ends a cyclic list of directories
  for (std::uint64_t at = reader.firstDirectory();
       at != 0 && static_cast<int>(headers.size()) < maxPictures;) {
    if (!seen.insert(at).second) break;
    const TiffDirectory dir = reader.directory(at);
    if (!dir.readable) break;
    PictureHeader header;
    header.width_px = dir.width_px;
    header.height_px = dir.height_px;
    header.orientation = dir.orientation;
    header.dpi = dpiOf(dir);
    header.directoryOffset = static_cast<std::size_t>(at);
    headers.push_back(header);
    at = dir.next;
  }
  return headers;
}

// ---- the other formats

PictureHeader pngHeader(std::span<const unsigned char> bytes) {
  const ByteReader in(bytes, true);
  PictureHeader header;
  header.complete = false;
  for (std::size_t at = 8; at + 12 <= in.size();) {
    const std::uint32_t size = in.u32(at);
    const std::size_t data = at + 8;
    if (size > in.size() - data - 4) break;
    if (in.has(at + 4, "IHDR") && size >= 13) {
      header.width_px = in.u32(data);
      header.height_px = in.u32(data + 4);
    } else if (in.has(at + 4, "pHYs") && size >= 9 && in.u8(data + 8) == 1) {
      header.dpi = plausibleDpi(in.u32(data) * mmPerInch / 1000);
    } else if (in.has(at + 4, "eXIf")) {
      applyExif(in.part(data, size), header);
    } else if (in.has(at + 4, "IEND")) {
      header.complete = true;
      break;
    }
    at = data + size + 4;
  }
  return header;
}

/// End of the compressed scan that begins at `at`: the next marker that is neither a restart nor a stuffed
/// 0xFF.
std::size_t endOfScan(const ByteReader& in, std::size_t at) {
  for (; at + 1 < in.size(); ++at) {
    if (in.u8(at) != 0xff) continue;
    const std::uint32_t marker = in.u8(at + 1);
    if (marker != 0 && marker != 0xff && !(marker >= 0xd0 && marker <= 0xd7)) return at;
  }
  return in.size();
}

PictureHeader jpegHeader(std::span<const unsigned char> bytes) {
  const ByteReader in(bytes, true);
  PictureHeader header;
  header.complete = false;
  for (std::size_t at = 2; at + 1 < in.size();) {
    if (in.u8(at) != 0xff) {  // bytes between segments are skipped, as decoders do
      ++at;
      continue;
    }
    const std::uint32_t marker = in.u8(at + 1);
    if (marker == 0xff || marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8)) {
      at += marker == 0xff ? 1 : 2;
      continue;
    }
    if (marker == 0xd9) {
      header.complete = header.width_px > 0;
      break;
    }
    const std::size_t size = in.u16(at + 2), data = at + 4;
    if (size < 2 || at + 2 + size > in.size()) break;
    const bool isFrame =
        marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
    if (isFrame) {
      header.height_px = in.u16(data + 1);
      header.width_px = in.u16(data + 3);
    } else if (marker == 0xe0 && in.has(data, std::string_view("JFIF\0", 5))) {
      const double density = in.u16(data + 8);
      if (in.u8(data + 7) == 1) header.dpi = plausibleDpi(density);
      if (in.u8(data + 7) == 2) header.dpi = plausibleDpi(density * mmPerInch / 10);
    } else if (marker == 0xe1 && in.has(data, std::string_view("Exif\0\0", 6))) {
      applyExif(in.part(data, size - 2), header);
    }
    at += 2 + size;
    if (marker == 0xda) at = endOfScan(in, at);
  }
  return header;
}

PictureHeader bmpHeader(std::span<const unsigned char> bytes) {
  const ByteReader in(bytes, false);
  PictureHeader header;
  const std::uint32_t pixelsAt = in.u32(10), infoSize = in.u32(14);
  const bool old = infoSize == 12;
  header.width_px = old ? in.u16(18) : static_cast<std::int32_t>(in.u32(18));
  header.height_px =
      old ? in.u16(20) : std::abs(static_cast<long long>(static_cast<std::int32_t>(in.u32(22))));
  const std::uint32_t bitsPerPixel = in.u16(old ? 24 : 28), compression = old ? 0 : in.u32(30);
  if (!old) header.dpi = plausibleDpi(in.u32(38) * mmPerInch / 1000);
  // for compressed pixels, completeness is known only after reading
  const bool runLengths = compression == 1 || compression == 2;
  if (!runLengths && header.width_px > 0 && header.width_px < (1LL << 31)) {
    const long long rowBytes = (header.width_px * bitsPerPixel + 31) / 32 * 4;
    const long long available = static_cast<long long>(in.size()) - static_cast<long long>(pixelsAt);
    header.complete = rowBytes == 0 || available / rowBytes >= header.height_px;
  }
  return header;
}

PictureHeader gifHeader(std::span<const unsigned char> bytes) {
  const ByteReader in(bytes, false);
  PictureHeader header;
  header.width_px = in.u16(6);
  header.height_px = in.u16(8);
  // A complete file ends with the trailer; anything after it is padding.
  std::size_t end = in.size();
  while (end > 0 && in.u8(end - 1) == 0) --end;
  header.complete = end > 0 && in.u8(end - 1) == 0x3b;
  return header;
}

PictureHeader webpHeader(std::span<const unsigned char> bytes) {
  const ByteReader in(bytes, false);
  PictureHeader header;
  header.complete = static_cast<std::uint64_t>(in.u32(4)) + 8 <= in.size();
  for (std::size_t at = 12; at + 8 <= in.size();) {
    const std::size_t size = in.u32(at + 4), data = at + 8;
    if (in.has(at, "VP8X")) {
      header.width_px = (in.u32(data + 4) & 0xffffff) + 1LL;
      header.height_px = (in.u32(data + 6) >> 8) + 1LL;
    } else if (in.has(at, "VP8L") && header.width_px == 0) {
      const std::uint32_t packed = in.u32(data + 1);
      header.width_px = (packed & 0x3fff) + 1LL;
      header.height_px = (packed >> 14 & 0x3fff) + 1LL;
    } else if (in.has(at, "VP8 ") && header.width_px == 0) {
      header.width_px = in.u16(data + 6) & 0x3fff;
      header.height_px = in.u16(data + 8) & 0x3fff;
    } else if (in.has(at, "EXIF")) {
      applyExif(in.part(data, size), header);
    }
    if (size > in.size() - data) break;
    at = data + size + size % 2;
  }
  if (in.overrun()) header.complete = false;
  return header;
}

/// The root element may have a prefix and follow an XML declaration, a comment and a document type with
/// entities.
bool isProbablySvg(std::span<const unsigned char> bytes) {
  constexpr std::size_t most = 65536;
  std::string text(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(std::min(bytes.size(), most)));
  const bool utf16 = text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff");
  if (utf16) std::erase(text, '\0');
  const std::size_t first = text.find_first_not_of("\xef\xbb\xbf\xfe\xff \t\r\n");
  if (first == std::string::npos || text[first] != '<') return false;
  for (std::size_t at = first; at != std::string::npos; at = text.find('<', at + 1)) {
    const std::size_t end = std::min(text.find_first_of(" \t\r\n/>", at + 2), text.size());
    const std::size_t prefix = text.find(':', at) < end ? text.find(':', at) : at;
    if (std::string_view(text).substr(prefix + 1, end - prefix - 1) == "svg") return true;
  }
  return false;
}

/// The kind of a known picture format that is not read.
FileKind foreignKind(const ByteReader& in) {
  constexpr std::size_t brandsBegin = 8, brandsEnd = 64;  // in the first box of an ISO base media file
  if (in.has(4, "jP  \r\n\x87\n") || in.has(0, "\xff\x4f\xff\x51")) return FileKind::jpeg2000;
  if (!in.has(4, "ftyp")) return FileKind::unknown;
  const auto hasBrand = [&](std::string_view brand) {
    for (std::size_t at = brandsBegin; at < std::min<std::size_t>(brandsEnd, in.u32(0)); at += 4)
      if (in.has(at, brand)) return true;
    return false;
  };
  if (hasBrand("avif") || hasBrand("avis")) return FileKind::avif;
  for (const char* const brand : {"heic", "heix", "heim", "heis", "hevc", "hevx", "mif1", "msf1"})
    if (hasBrand(brand)) return FileKind::heic;
  return FileKind::unknown;
}

}  // namespace

FileKind sniffFileKind(std::span<const unsigned char> bytes) {
  const ByteReader in(bytes, true);
  if (in.has(0, std::string_view("\x89PNG\r\n\x1a\n", 8))) return FileKind::png;
  if (in.has(0, "\xff\xd8\xff")) return FileKind::jpeg;
  if (TiffReader(bytes).isTiff()) return FileKind::tiff;
  if (in.has(0, "RIFF") && in.has(8, "WEBP")) return FileKind::webp;
  if (in.has(0, "GIF87a") || in.has(0, "GIF89a")) return FileKind::gif;
  if (in.has(0, "BM") && bytes.size() >= 26 && ByteReader(bytes, false).u32(14) <= 124) return FileKind::bmp;
  // PDF readers accept junk before the header within the first kilobyte (ISO 32000-1, annex H.3.4.1).
  const std::string_view head(reinterpret_cast<const char*>(bytes.data()),
                              std::min<std::size_t>(bytes.size(), 1024));
  if (head.find("%PDF-") != std::string_view::npos) return FileKind::pdf;
  if (isProbablySvg(bytes)) return FileKind::svg;
  return foreignKind(in);
}

Message kindName(FileKind kind) {
  static const Message names[] = {
      Message("file of unknown type"), Message("PNG picture"),  Message("JPEG picture"),
      Message("BMP picture"),          Message("TIFF picture"), Message("WebP picture"),
      Message("PDF document"),         Message("SVG drawing"),  Message("GIF picture"),
      Message("HEIC picture"),         Message("AVIF picture"), Message("JPEG 2000 picture")};
  return names[static_cast<std::size_t>(kind)];
}

FileKind kindOfName(const std::string& name) {
  static const std::map<std::string, FileKind> kinds{
      {"png", FileKind::png},   {"jpg", FileKind::jpeg}, {"jpeg", FileKind::jpeg}, {"jpe", FileKind::jpeg},
      {"bmp", FileKind::bmp},   {"dib", FileKind::bmp},  {"tif", FileKind::tiff},  {"tiff", FileKind::tiff},
      {"webp", FileKind::webp}, {"gif", FileKind::gif},  {"pdf", FileKind::pdf},   {"svg", FileKind::svg},
      {"svgz", FileKind::svg}};
  const auto kind = kinds.find(lowered(name.substr(name.find_last_of('.') + 1)));
  return kind == kinds.end() || name.find('.') == std::string::npos ? FileKind::unknown : kind->second;
}

bool isPicture(FileKind kind) {
  return kind == FileKind::png || kind == FileKind::jpeg || kind == FileKind::bmp || kind == FileKind::tiff ||
         kind == FileKind::webp || kind == FileKind::gif;
}

bool isForeignPicture(FileKind kind) {
  return kind == FileKind::heic || kind == FileKind::avif || kind == FileKind::jpeg2000;
}

std::vector<PictureHeader> readPictureHeaders(std::span<const unsigned char> bytes, FileKind kind,
                                              int maxPictures) {
  switch (kind) {
    case FileKind::png:
      return {pngHeader(bytes)};
    case FileKind::jpeg:
      return {jpegHeader(bytes)};
    case FileKind::bmp:
      return {bmpHeader(bytes)};
    case FileKind::gif:
      return {gifHeader(bytes)};
    case FileKind::webp:
      return {webpHeader(bytes)};
    case FileKind::tiff:
      return tiffHeaders(bytes, maxPictures);
    default:
      return {};
  }
}

}  // namespace detent::importer
