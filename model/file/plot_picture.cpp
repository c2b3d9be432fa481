// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/file/plot_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string_view>
#include <vector>

#include "model/sampling.h"

namespace detent {

namespace {

/// Indices of the palette.
enum Shade : std::uint8_t { paper, grid, black, press, release };
constexpr std::array<std::uint8_t, 15> palette{255, 255, 255, 205, 205, 205, 0, 0, 0, 200, 0, 0, 0, 80, 200};

struct Raster {
  int width_px, height_px;
  std::vector<std::uint8_t> colourIndices;

  Raster(int width, int height)
      : width_px(width),
        height_px(height),
        colourIndices(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), paper) {}
  void dot(int x, int y, Shade colour) {
    if (x < 0 || y < 0 || x >= width_px || y >= height_px) return;
    colourIndices[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) +
                  static_cast<std::size_t>(x)] = colour;
  }
  void block(double x, double y, int size_px, Shade colour) {
    const int left = static_cast<int>(std::lround(x - size_px / 2.0)),
              top = static_cast<int>(std::lround(y - size_px / 2.0));
    for (int row = 0; row < size_px; ++row)
      for (int column = 0; column < size_px; ++column) dot(left + column, top + row, colour);
  }
  void line(double x0, double y0, double x1, double y1, int size_px, Shade colour) {
    const int steps = 1 + static_cast<int>(std::fmin(1e5, std::ceil(2 * std::hypot(x1 - x0, y1 - y0))));
    for (int i = 0; i <= steps; ++i) {
      const double share = static_cast<double>(i) / steps;
      block(x0 + share * (x1 - x0), y0 + share * (y1 - y0), size_px, colour);
    }
  }
};

// ---- tick numbers: glyphs of 3 by 5 dots, rows from the top, three bits each

constexpr int glyphDot_px = 2, glyphAdvance_px = 4 * glyphDot_px, glyphHeight_px = 5 * glyphDot_px;

unsigned glyphOf(char c) {
  constexpr std::array<unsigned, 10> digits{075557, 026227, 071747, 071717, 055711,
                                            074717, 074757, 071122, 075757, 075717};
  if (c >= '0' && c <= '9') return digits[static_cast<std::size_t>(c - '0')];
  return c == '-' ? 000700U : 000002U;  // or a decimal point
}

void write(Raster& raster, int left, int top, std::string_view text) {
  for (const char c : text) {
    const unsigned glyph = glyphOf(c);
    for (int bit = 0; bit < 15; ++bit) {
      const int row = bit / 3, column = bit % 3;
      if ((glyph >> (14 - bit) & 1U) != 0)
        raster.block(left + column * glyphDot_px + 1, top + row * glyphDot_px + 1, glyphDot_px, black);
    }
    left += glyphAdvance_px;
  }
}

std::string numberOf(const Ticks& ticks, int i) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", ticks.decimals, ticks.at(i));
  return text;
}

void drawScale(Raster& raster, const PlotFrame& frame) {
  for (int i = 0; i < frame.x.count; ++i) {
    const double x = frame.xPx(frame.x.at(i));
    raster.line(x, frame.top_px, x, frame.bottom_px, 1, grid);
    const std::string text = numberOf(frame.x, i);
    write(raster, static_cast<int>(x) - glyphAdvance_px * static_cast<int>(text.size()) / 2,
          static_cast<int>(frame.bottom_px) + 7, text);
  }
  for (int i = 0; i < frame.y.count; ++i) {
    const double y = frame.yPx(frame.y.at(i));
    raster.line(frame.left_px, y, frame.right_px, y, 1, grid);
    const std::string text = numberOf(frame.y, i);
    write(raster, static_cast<int>(frame.left_px) - 7 - glyphAdvance_px * static_cast<int>(text.size()),
          static_cast<int>(y) - glyphHeight_px / 2, text);
  }
  raster.line(frame.left_px, frame.top_px, frame.right_px, frame.top_px, 1, black);
  raster.line(frame.right_px, frame.top_px, frame.right_px, frame.bottom_px, 1, black);
  raster.line(frame.right_px, frame.bottom_px, frame.left_px, frame.bottom_px, 1, black);
  raster.line(frame.left_px, frame.bottom_px, frame.left_px, frame.top_px, 1, black);
}

void drawStroke(Raster& raster, const PlotFrame& frame, const ForceGraph& graph, Stroke stroke,
                const SvgPlotStyle& style) {
  const int width_px = std::max(1, static_cast<int>(std::lround(style.lineWidth_px)));
  double lastX = 0, lastY = 0;
  bool first = true;
  for (const CurvePoint& p : travelledSamples(graph, stroke)) {
    const double x = frame.xPx(p.displacement_mm / millimetresPer(style.lengthUnit));
    const double y = frame.yPx(p.force_N / newtonsPer(style.forceUnit));
    if (!first) raster.line(lastX, lastY, x, y, width_px, stroke == Stroke::press ? press : release);
    lastX = x;
    lastY = y;
    first = false;
  }
}

// ---- PNG: four bits a pixel, stored, not compressed

void putBig(std::string& out, std::uint32_t value) {
  for (const unsigned shift : {24U, 16U, 8U, 0U}) out += static_cast<char>(value >> shift & 0xFFU);
}

std::uint32_t crcOf(std::string_view bytes) {
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const char c : bytes) {
    crc ^= static_cast<std::uint8_t>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1U) != 0 ? 0xEDB88320U ^ crc >> 1U : crc >> 1U;
  }
  return ~crc;
}

void putChunk(std::string& png, std::string_view kind, const std::string& content) {
  putBig(png, static_cast<std::uint32_t>(content.size()));
  const std::string body = std::string(kind) + content;
  png += body;
  putBig(png, crcOf(body));
}

/// zlib with stored blocks.
std::string stored(const std::string& bytes) {
  constexpr std::size_t most = 65535;
  std::string out("\x78\x01", 2);
  for (std::size_t at = 0; at < bytes.size(); at += most) {
    const std::size_t size = std::min(most, bytes.size() - at);
    out += static_cast<char>(at + size == bytes.size());
    for (const std::size_t value : {size, most - size}) {
      out += static_cast<char>(value & 0xFFU);
      out += static_cast<char>(value >> 8U);
    }
    out += bytes.substr(at, size);
  }
  std::uint32_t a = 1, b = 0;
  for (const char c : bytes) {
    a = (a + static_cast<std::uint8_t>(c)) % 65521;
    b = (b + a) % 65521;
  }
  putBig(out, b << 16U | a);
  return out;
}

std::string pngOf(const Raster& raster) {
  std::string rows;
  for (int y = 0; y < raster.height_px; ++y) {
    rows += '\0';  // no filter
    const std::size_t from = static_cast<std::size_t>(y) * static_cast<std::size_t>(raster.width_px);
    for (int x = 0; x < raster.width_px; x += 2) {
      const unsigned high = raster.colourIndices[from + static_cast<std::size_t>(x)];
      const unsigned low =
          x + 1 < raster.width_px ? raster.colourIndices[from + static_cast<std::size_t>(x) + 1] : 0;
      rows += static_cast<char>(high << 4U | low);
    }
  }
  std::string png("\x89PNG\r\n\x1A\n", 8), header;
  putBig(header, static_cast<std::uint32_t>(raster.width_px));
  putBig(header, static_cast<std::uint32_t>(raster.height_px));
  header += std::string("\x04\x03\x00\x00\x00", 5);  // four bits, palette
  putChunk(png, "IHDR", header);
  putChunk(png, "PLTE", std::string(palette.begin(), palette.end()));
  putChunk(png, "IDAT", stored(rows));
  putChunk(png, "IEND", {});
  return png;
}

}  // namespace

std::string pngFrom(const ButtonState& state, const SvgPlotStyle& style) {
  const PlotFrame frame = frameOfPlot(state, style);
  Raster raster(static_cast<int>(std::lround(style.width_px)),
                static_cast<int>(std::lround(style.height_px)));
  drawScale(raster, frame);
  if (state.graph.release()) drawStroke(raster, frame, state.graph, Stroke::release, style);
  drawStroke(raster, frame, state.graph, Stroke::press, style);
  return pngOf(raster);
}

}  // namespace detent
