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
  static const std::map<int, const char*> ligatures{{0xfb00, "ff"},  {0xfb01, "fi"},  {0xfb02, "fl"},
                                                    {0xfb03, "ffi"}, {0xfb04, "ffl"}, {0xfb05, "ft"},
                                                    {0xfb06, "st"}};
  if (const auto known = ligatures.find(codePoint); known != ligatures.end()) {
    to += known->second;
    return;
  }
  const bool surrogate = codePoint >= 0xd800 && codePoint <= 0xdfff;
  char bytes[FZ_UTFMAX];
  to.append(bytes, static_cast<std::size_t>(fz_runetochar(bytes, surrogate ? 0xfffd : codePoint)));
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
    for (const fz_point& p : {letter.quad.ul, letter.quad.ur, letter.quad.ll, letter.quad.lr})
      bounds_ = bounds_.joined({p.x, p.y, p.x, p.y});
  }
  void space() { pendingSpace_ = true; }

  void flush(std::vector<TextBox>& to, const Box& page) {
    const bool onPage =
        bounds_.x1 > page.x0 && bounds_.x0 < page.x1 && bounds_.y1 > page.y0 && bounds_.y0 < page.y1;
    if (!box_.utf8.empty() && onPage) {
      // limited, because a page may state letters of any size
      box_.box = bounds_.common(page.grown(page.width(), page.height()));
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

/// Start and end of a letter along the baseline.
struct Extent {
  double begin = 0, end = 0;
};

Extent extentAlong(const fz_stext_char& letter, const fz_point& direction) {
  const auto along = [&](const fz_point& p) {
    return static_cast<double>(p.x) * direction.x + static_cast<double>(p.y) * direction.y;
  };
  return {along(letter.quad.ll), along(letter.quad.lr)};
}

std::tuple<int, float, float> keyOf(const fz_stext_char& letter) {
  return {letter.c, letter.origin.x, letter.origin.y};
}

void addLine(const fz_stext_line& line, const Box& page, LetterKeys& seen, std::vector<TextBox>& boxes) {
  constexpr double widestGap_em = 1.0;
  const double angle =
      -std::atan2(static_cast<double>(line.dir.y), static_cast<double>(line.dir.x)) * 180 / std::numbers::pi;
  BoxBuilder builder(angle == 0 ? 0 : angle);
  double lastEnd = 0;
  bool first = true, kept = false;
  for (const fz_stext_char* letter = line.first_char; letter; letter = letter->next) {
    if (isSpace(letter->c)) {
      builder.space();
      continue;
    }
    const Extent extent = extentAlong(*letter, line.dir);
    const bool isPart =
        kept && extent.begin == extent.end;  // one glyph of the font stands for several letters
    const auto known = seen.find(keyOf(*letter));
    kept = isPart || (known != seen.end() && known->second-- == 0);
    if (!kept) continue;
    if (!first && line.wmode == 0 && extent.begin - lastEnd > widestGap_em * letter->size)
      builder.flush(boxes, page);
    builder.add(*letter);
    lastEnd = extent.end;
    first = false;
  }
  builder.flush(boxes, page);
}

}  // namespace

std::vector<TextBox> textBoxes(const fz_stext_page& text, const Box& bounds, LetterKeys seen) {
  const auto forLines = [&](const auto& visit) {
    for (const fz_stext_block* block = text.first_block; block; block = block->next)
      if (block->type == FZ_STEXT_BLOCK_TEXT)
        for (const fz_stext_line* line = block->u.t.first_line; line; line = line->next) visit(*line);
  };
  LetterKeys present;
  forLines([&](const fz_stext_line& line) {
    for (const fz_stext_char* letter = line.first_char; letter; letter = letter->next)
      ++present[keyOf(*letter)];
  });
  // MuPDF itself leaves out some letters that stand twice in one place.
  for (auto& [key, earlier] : seen) earlier = std::min(earlier, present[key] - 1);
  std::vector<TextBox> boxes;
  forLines([&](const fz_stext_line& line) { addLine(line, bounds, seen, boxes); });
  return boxes;
}

}  // namespace detent::importer
