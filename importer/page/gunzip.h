// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Unpacks .svgz: an SVG in a gzip file. Private to importer/page.

#include <optional>
#include <span>
#include <vector>

namespace detent::importer {

/// Any bytes.
bool isGzip(std::span<const unsigned char> bytes);

/// The content of a gzip file; nothing where it is damaged, cut off, or larger than `most_bytes` when
/// unpacked.
std::optional<std::vector<unsigned char>> gunzip(std::span<const unsigned char> bytes,
                                                 std::size_t most_bytes);

}  // namespace detent::importer
