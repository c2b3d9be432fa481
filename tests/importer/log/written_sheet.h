// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Writes spreadsheets and other measurements as people's curve meters leave them, for tests: layouts of the
// Open-Switch curve meter (strokes in columns under one line of headings or two, raw columns beside),
// deflated in a ZIP archive.

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <zlib.h>

namespace detent::test {

inline void littleEndian(std::string& bytes, std::uint32_t value, int count) {
  for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * i) & 255);
}

inline std::string deflated(const std::string& text) {
  z_stream stream{};
  deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
  std::string packed(deflateBound(&stream, static_cast<uLong>(text.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(packed.size() - stream.avail_out);
  deflateEnd(&stream);
  return packed;
}

/// An archive of one deflated member.
inline std::string zipOf(const std::string& member, const std::string& text) {
  const std::string packed = deflated(text);
  const auto sizes = [&](std::string& bytes) {
    littleEndian(bytes, 0, 4);  // time: nobody asks
    littleEndian(bytes,
                 static_cast<std::uint32_t>(
                     crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size()))),
                 4);
    littleEndian(bytes, static_cast<std::uint32_t>(packed.size()), 4);
    littleEndian(bytes, static_cast<std::uint32_t>(text.size()), 4);
    littleEndian(bytes, static_cast<std::uint32_t>(member.size()), 2), littleEndian(bytes, 0, 2);
  };
  std::string bytes = "PK\3\4";
  littleEndian(bytes, 20, 2), littleEndian(bytes, 0, 2), littleEndian(bytes, 8, 2);
  sizes(bytes);
  bytes += member + packed;
  const auto directory = static_cast<std::uint32_t>(bytes.size());
  bytes += "PK\1\2";
  littleEndian(bytes, 20, 2), littleEndian(bytes, 20, 2), littleEndian(bytes, 0, 2),
      littleEndian(bytes, 8, 2);
  sizes(bytes);
  for (const int count : {2, 2, 2, 4, 4}) littleEndian(bytes, 0, count);  // comment, disk, attributes, place
  bytes += member;
  const auto end = static_cast<std::uint32_t>(bytes.size());
  bytes += "PK\5\6";
  littleEndian(bytes, 0, 4), littleEndian(bytes, 1, 2), littleEndian(bytes, 1, 2);
  littleEndian(bytes, end - directory, 4), littleEndian(bytes, directory, 4), littleEndian(bytes, 0, 2);
  return bytes;
}

inline std::string cellOf(const std::string& text) {
  if (text.empty()) return "<table:table-cell/>";
  return "<table:table-cell office:value-type=\"string\"><text:p>" + text + "</text:p></table:table-cell>";
}
inline std::string cellOf(double value) {
  if (std::isnan(value)) return "<table:table-cell/>";
  char text[160];
  std::snprintf(text, sizeof text,
                "<table:table-cell office:value-type=\"float\" "
                "office:value=\"%.10g\"><text:p>%.10g</text:p></table:table-cell>",
                value, value);
  return text;
}

/// content.xml with lines of headings, rows of numbers, and the empty rest of the sheet as LibreOffice
/// writes it.
inline std::string sheetXml(const std::vector<std::vector<std::string>>& headings,
                            const std::vector<std::vector<double>>& rows) {
  std::string xml =
      "<?xml version=\"1.0\"?><office:spreadsheet><table:table table:name=\"Sheet1\" "
      "table:style-name=\"ta1\">";
  const auto row = [&](const auto& cells) {
    xml += "<table:table-row table:style-name=\"ro1\">";
    for (const auto& cell : cells) xml += cellOf(cell);
    xml += "</table:table-row>";
  };
  for (const auto& cells : headings) row(cells);
  for (const auto& cells : rows) row(cells);
  return xml +
         "<table:table-row table:number-rows-repeated=\"1046857\"><table:table-cell "
         "table:number-columns-repeated=\"64\"/></table:table-row></table:table></office:spreadsheet>";
}

/// A tactile switch as a meter with steps of 5 µm sees it, gf over mm: `scale` makes others of it.
inline double forceOf_gf(double travel_mm, double scale, bool press) {
  const double spring = 30 + 10 * travel_mm + (travel_mm > 3.6 ? 300 * (travel_mm - 3.6) : 0);
  const double bump = 25 * std::exp(-std::pow((travel_mm - 0.8) / 0.25, 2)) -
                      8 * std::exp(-std::pow((travel_mm - 1.6) / 0.3, 2));
  return scale * (spring + (press ? bump : 0.5 * bump - 5));
}

enum class SheetLayout { oneLine, twoLines, rawOnly };

/// A switch of 4 mm, contact closing at 2 mm and opening at 1.8 mm.
inline std::string switchSheet(SheetLayout layout, double scale) {
  constexpr int steps = 800;
  std::vector<std::vector<double>> rows;
  for (int i = 0; i <= steps; ++i) {
    const double down = 0.005 * i, up = 4 - down;
    const double press = forceOf_gf(down, scale, true), release = forceOf_gf(up, scale, false);
    if (layout == SheetLayout::oneLine)
      rows.push_back({double(i), down * 1000, press, double(down >= 2), press, down, press, double(down >= 2),
                      up, release, double(up > 1.8)});
    else if (layout == SheetLayout::twoLines)
      rows.push_back({down * 1000, press, double(down >= 2), NAN, down, press, up, release});
    else
      rows.push_back({down * 1000, press, double(down >= 2), NAN});
  }
  if (layout == SheetLayout::rawOnly)
    for (int i = 0; i <= steps; ++i) {
      const double up = 4 - 0.005 * i;
      rows.push_back({up * 1000, forceOf_gf(up, scale, false), double(up > 1.8), NAN});
    }
  if (layout == SheetLayout::oneLine)
    return zipOf("content.xml",
                 sheetXml({{"", "Raw X (microns)", "Raw Force (gf)", "Actuated?", "Force - Tared (gf)",
                            "Corrected downstroke X (mm)", "Corrected downstroke force (gf)",
                            "Corrected downstroke actuated?", "Corrected upstroke X (mm)",
                            "Corrected upstroke force (gf)", "Corrected upstroke actuated?"}},
                          rows));
  return zipOf("content.xml",
               sheetXml({{"Raw data", "", "", "", "Corrected Downstroke", "", "Corrected Upstroke", ""},
                         {"X (microns)", "Force (gf)", "Actuated? ", "", "X (mm)", "Force (gf)", "X (mm)",
                          "Force (gf)"}},
                        rows));
}

}  // namespace detent::test
