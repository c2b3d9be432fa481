// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/text_boxes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <tuple>

namespace detent::importer {
namespace {

void appendUtf8(std::string& to, int codePoint) {
  const auto c = static_cast<std::uint32_t>(codePoint);
  const auto put = [&](std::uint32_t byte) { to += static_cast<char>(static_cast<unsigned char>(byte)); };
  if (c == 0 || c > 0x10ffff || (c >= 0xd800 && c <= 0xdfff)) return appendUtf8(to, 0xfffd);
  if (c < 0x80) return put(c);
  if (c < 0x800) {
    put(0xc0 | c >> 6);
  } else if (c < 0x10000) {
    put(0xe0 | c >> 12);
    put(0x80 | (c >> 6 & 0x3f));
  } else {
    put(0xf0 | c >> 18);
    put(0x80 | (c >> 12 & 0x3f));
    put(0x80 | (c >> 6 & 0x3f));
  }
  put(0x80 | (c & 0x3f));
}

bool isSpace(int c) {
  return c == ' ' || c == 0xa0 || c == '\t' || (c >= 0x2000 && c <= 0x200b) || c == 0x3000;
}

/// Gathers the letters of one box.
class BoxBuilder {
 public:
  explicit BoxBuilder(double angle_deg) { box_.angle_deg = angle_deg; }

  void add(const fz_stext_char& letter) {
    if (pendingSpace_ && !box_.utf8.empty()) box_.utf8 += ' ';
    pendingSpace_ = false;
    appendUtf8(box_.utf8, letter.c);
    for (const fz_point& p : {letter.quad.ul, letter.quad.ur, letter.quad.ll, letter.quad.lr}) {
      bounds_.x0 = std::min(bounds_.x0, static_cast<double>(p.x));
      bounds_.y0 = std::min(bounds_.y0, static_cast<double>(p.y));
      bounds_.x1 = std::max(bounds_.x1, static_cast<double>(p.x));
      bounds_.y1 = std::max(bounds_.y1, static_cast<double>(p.y));
    }
  }
  void space() { pendingSpace_ = true; }

  void flush(std::vector<TextBox>& to, const Box& page) {
    const bool onPage =
        bounds_.x1 > page.x0 && bounds_.x0 < page.x1 && bounds_.y1 > page.y0 && bounds_.y0 < page.y1;
    if (!box_.utf8.empty() && onPage) {
      box_.box = bounds_;
      to.push_back(box_);
    }
    box_.utf8.clear();
    bounds_ = nowhere;
    pendingSpace_ = false;
  }

 private:
  static constexpr double inf = std::numeric_limits<double>::infinity();
  static constexpr Box nowhere{inf, inf, -inf, -inf};
  TextBox box_;
  Box bounds_ = nowhere;
  bool pendingSpace_ = false;
};

/// Where along the baseline a letter begins and ends.
struct Extent {
  double begin = 0, end = 0;
};

Extent extentAlong(const fz_stext_char& letter, const fz_point& direction) {
  const auto along = [&](const fz_point& p) {
    return static_cast<double>(p.x) * direction.x + static_cast<double>(p.y) * direction.y;
  };
  return {along(letter.quad.ll), along(letter.quad.lr)};
}

/// Letters of a page, each once: bold made by hand, halos and glows set them again a little aside.
class LettersOnce {
 public:
  /// Returns true if the same letter stands here already.
  bool isRepeated(const fz_stext_char& letter) {
    constexpr double ofWidth = 0.5;  // the next letter of a word stands a whole width on
    const fz_point &from = letter.quad.ll, &to = letter.quad.lr;
    const double width = std::hypot(static_cast<double>(to.x - from.x), static_cast<double>(to.y - from.y));
    const double reach = std::max(1e-6, ofWidth * width);
    const auto cell = [&](float at) {
      return static_cast<long>(std::floor(static_cast<double>(at) / reach));
    };
    const long column = cell(letter.origin.x), row = cell(letter.origin.y);
    for (long x = column - 1; x <= column + 1; ++x)
      for (long y = row - 1; y <= row + 1; ++y) {
        const auto seen = places_.find({letter.c, x, y});
        if (seen != places_.end() &&
            std::hypot(static_cast<double>(seen->second.x - letter.origin.x),
                       static_cast<double>(seen->second.y - letter.origin.y)) < reach)
          return true;
      }
    places_.emplace(std::tuple(letter.c, column, row), letter.origin);
    return false;
  }

 private:
  std::map<std::tuple<int, long, long>, fz_point> places_;
};

void addLine(const fz_stext_line& line, const Box& page, LettersOnce& letters, std::vector<TextBox>& boxes) {
  constexpr double widestGap_em = 1.0;
  const double angle =
      -std::atan2(static_cast<double>(line.dir.y), static_cast<double>(line.dir.x)) * 180 / std::numbers::pi;
  BoxBuilder builder(angle == 0 ? 0 : angle);
  double lastEnd = 0;
  bool first = true;
  for (const fz_stext_char* letter = line.first_char; letter; letter = letter->next) {
    if (isSpace(letter->c)) {
      builder.space();
      continue;
    }
    if (letters.isRepeated(*letter)) continue;
    const Extent extent = extentAlong(*letter, line.dir);
    if (!first && line.wmode == 0 && extent.begin - lastEnd > widestGap_em * letter->size)
      builder.flush(boxes, page);
    builder.add(*letter);
    lastEnd = extent.end;
    first = false;
  }
  builder.flush(boxes, page);
}

}  // namespace

std::vector<TextBox> textBoxes(const fz_stext_page& text, const Box& bounds) {
  std::vector<TextBox> boxes;
  LettersOnce letters;
  for (const fz_stext_block* block = text.first_block; block; block = block->next) {
    if (block->type != FZ_STEXT_BLOCK_TEXT) continue;
    for (const fz_stext_line* line = block->u.t.first_line; line; line = line->next)
      addLine(*line, bounds, letters, boxes);
  }
  return boxes;
}

}  // namespace detent::importer
