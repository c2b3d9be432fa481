// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/equal_digits.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "importer/axes/label_scales.h"
#include "importer/page/quantile.h"

namespace detent::importer {
namespace {

/// Assigns the letters of all words to shapes: the index of each letter's shape.
std::vector<std::vector<std::size_t>> numbered(const std::vector<std::vector<LetterShape>>& words) {
  std::vector<const LetterShape*> shapes;
  std::vector<std::vector<std::size_t>> numbers;
  for (const std::vector<LetterShape>& word : words) {
    numbers.emplace_back();
    for (const LetterShape& letter : word) {
      const auto same =
          std::ranges::find_if(shapes, [&](const LetterShape* s) { return s->resembles(letter); });
      numbers.back().push_back(static_cast<std::size_t>(same - shapes.begin()));
      if (same == shapes.end()) shapes.push_back(&letter);
    }
  }
  return numbers;
}

/// Returns true if shapes and digits correspond one to one in all labels.
bool fits(const std::vector<std::string>& texts, const std::vector<std::vector<std::size_t>>& shapes) {
  constexpr std::size_t none = ~std::size_t{0};
  std::array<std::size_t, 128> shapeOf;
  shapeOf.fill(none);
  std::vector<char> signOf;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (texts[i].size() != shapes[i].size()) return false;
    for (std::size_t k = 0; k < texts[i].size(); ++k) {
      const std::size_t shape = shapes[i][k];
      signOf.resize(std::max(signOf.size(), shape + 1), 0);
      std::size_t& ownShape = shapeOf[static_cast<unsigned char>(texts[i][k])];
      if (ownShape == none && signOf[shape] == 0) ownShape = shape, signOf[shape] = texts[i][k];
      if (ownShape != shape || signOf[shape] != texts[i][k]) return false;
    }
  }
  return true;
}

/// Number of characters that agree with what the engine read.
std::size_t agreeingTexts(const std::vector<std::string>& texts, const std::vector<std::string>& engine) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < texts.size(); ++i)
    for (std::size_t k = 0; k < texts[i].size() && texts[i].size() == engine[i].size(); ++k)
      count += texts[i][k] == engine[i][k] || (texts[i][k] == '.' && engine[i][k] == ',');
  return count;
}

/// Returns true if a shape is wider than a digit, because several digits touch.
bool anyTouch(const std::vector<std::vector<LetterShape>>& words) {
  constexpr double widest = 1.6;  // times the usual width
  std::vector<int> widths;
  for (const auto& word : words)
    for (const LetterShape& letter : word) widths.push_back(letter.width);
  const int usual = medianOf(widths);
  return std::ranges::any_of(widths, [&](int width) { return width > widest * usual; });
}

}  // namespace

bool LetterShape::resembles(const LetterShape& other) const {
  constexpr std::size_t pixelsPerOther = 50;
  if (width != other.width || height != other.height) return false;
  std::size_t others = 0;
  for (std::size_t i = 0; i < isDark.size(); ++i) others += isDark[i] != other.isDark[i];
  return others * pixelsPerOther <= isDark.size();
}

std::vector<LetterShape> digitsOf(const cv::Mat& darkness, const cv::Mat& marks,
                                  const AxisCalibration& axes) {
  std::vector<LetterShape> digits;
  std::vector<Box> labels;
  for (const AxisReading* axis : {&axes.x, &axes.y})
    for (const TickLabel& tick : axis->ticks)
      if (tick.used) labels.push_back(tick.box);
  if (!isUnsmoothed(darkness, labels)) return {};
  for (const AxisReading* axis : {&axes.x, &axes.y})
    for (const TickLabel& tick : axis->ticks) {
      if (!tick.used) continue;
      std::vector<LetterShape> letters = lettersOf(marks, tick.box);
      if (letters.size() != tick.text.size()) continue;
      for (std::size_t k = 0; k < letters.size(); ++k) {
        if (tick.text[k] < '0' || tick.text[k] > '9') continue;
        letters[k].sign = tick.text[k];
        const auto isSame = [&](const LetterShape& d) { return d.sign == letters[k].sign; };
        const auto same = std::ranges::find_if(digits, isSame);
        if (same == digits.end())
          digits.push_back(letters[k]);
        else if (!same->resembles(letters[k]))
          return {};
      }
    }
  return digits;
}

bool isUnsmoothed(const cv::Mat& darkness, const std::vector<Box>& words) {
  constexpr double paper = 0.25, full = 0.75,
                   mostBetween = 0.05;  // shares of the greatest darkness; share of the fully dark pixels
  cv::Mat all;
  for (const Box& word : words) {
    const cv::Rect at = cv::Rect(0, 0, darkness.cols, darkness.rows) &
                        cv::Rect(static_cast<int>(std::lround(word.x0 + 0.5)) - 1,
                                 static_cast<int>(std::lround(word.y0 + 0.5)) - 1,
                                 static_cast<int>(std::lround(word.width())) + 2,
                                 static_cast<int>(std::lround(word.height())) + 2);
    if (!at.empty()) all.push_back(darkness(at).clone().reshape(1, 1).t());
  }
  if (all.empty()) return false;
  double darkest = 0;
  cv::minMaxLoc(all, nullptr, &darkest);
  const int inked = cv::countNonZero(all > full * darkest),
            between = cv::countNonZero(all > paper * darkest) - inked;
  return between <= mostBetween * inked;
}

std::vector<LetterShape> lettersOf(const cv::Mat& marks, const Box& word) {
  const cv::Rect all(0, 0, marks.cols, marks.rows);
  const cv::Rect at =
      all &
      cv::Rect(static_cast<int>(std::lround(word.x0 + 0.5)), static_cast<int>(std::lround(word.y0 + 0.5)),
               static_cast<int>(std::lround(word.width())), static_cast<int>(std::lround(word.height())));
  std::vector<LetterShape> letters;
  const auto isInked = [&](int x) { return cv::countNonZero(marks(cv::Rect(x, at.y, 1, at.height))) > 0; };
  for (int x = at.x; !at.empty() && x < at.x + at.width; ++x) {
    if (!isInked(x)) continue;
    int end = x + 1;
    while (end < at.x + at.width && isInked(end)) ++end;
    const cv::Rect columns(x, at.y, end - x, at.height);
    const cv::Rect own = cv::boundingRect(marks(columns)) + columns.tl();
    LetterShape letter{own.width, own.height, {}, 0};
    for (int v = own.y; v < own.y + own.height; ++v)
      for (int u = own.x; u < own.x + own.width; ++u)
        letter.isDark.push_back(marks.at<std::uint8_t>(v, u) != 0 ? 1 : 0);
    letters.push_back(std::move(letter));
    x = end;
  }
  return letters;
}

std::optional<std::vector<std::string>> readEqualDigits(const std::vector<std::vector<LetterShape>>& words,
                                                        const std::vector<double>& centers_px, bool rising,
                                                        const std::vector<std::string>& engine) {
  constexpr double leastAgreed = 0.35;  // share of the characters
  constexpr std::size_t ahead = 2;      // signs
  if (words.size() < fewestLabels || words.size() > mostLabels) return {};
  const std::vector<int> steps = evenSteps(centers_px);
  if (steps.empty()) return {};
  const std::vector<std::vector<std::size_t>> shapes = numbered(words);
  std::size_t signs = 0;
  for (const auto& word : shapes) signs += word.size();
  if (anyTouch(words)) return {};
  std::optional<LabelScale> best;
  std::size_t most = 0, next = 0;
  for (LabelScale& scale : scalesOf(steps, rising)) {
    if (!fits(scale.texts, shapes)) continue;
    const std::size_t agreed = agreeingTexts(scale.texts, engine);
    if (best && !scale.sameValues(*best)) next = std::max(next, std::min(agreed, most));
    if (best && agreed <= most) continue;
    if (best && !scale.sameValues(*best)) next = std::max(next, most);
    best = std::move(scale), most = agreed;
  }
  if (!best || static_cast<double>(most) < leastAgreed * static_cast<double>(signs) || most < next + ahead)
    return {};
  return best->texts;
}

std::string withKnownDigits(const std::string& utf8, const std::vector<LetterShape>& letters,
                            const std::vector<LetterShape>& known) {
  const auto isPartOfSign = [](char c) { return static_cast<unsigned char>(c) >= 0x80; };
  if (std::ranges::any_of(utf8, isPartOfSign)) return utf8;  // a letter outside ASCII has several bytes
  if (utf8.size() - static_cast<std::size_t>(std::ranges::count(utf8, ' ')) != letters.size()) return utf8;
  std::string text = utf8;
  std::size_t at = 0;
  for (char& sign : text) {
    if (sign == ' ') continue;
    const LetterShape& letter = letters[at++];
    const auto same = std::ranges::find_if(known, [&](const LetterShape& k) { return k.resembles(letter); });
    if (same != known.end()) sign = same->sign;
  }
  return text;
}

}  // namespace detent::importer
