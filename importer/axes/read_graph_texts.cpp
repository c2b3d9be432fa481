// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <cmath>

#include <opencv2/core.hpp>

#include "importer/axes/axis_calibration.h"
#include "importer/axes/equal_digits.h"
#include "importer/axes/read_text.h"
#include "importer/axes/text_lines.h"
#include "importer/frame/darkness.h"
#include "importer/frame/glyph_marks.h"
#include "importer/page/quantile.h"
#include "importer/page/same_ink.h"

namespace detent::importer {
namespace {

constexpr std::size_t maxLines = 24;   // a plot with more writing is a page
constexpr double minConfidence = 0.5;  // dashes and arrows read as text score less
constexpr int minLetters = 3;

/// Ink of gridlines (not of the frame's own edges), so that writing across them can be told from them; 0
/// without a grid.
int gridInk(const cv::Mat& d, const PlotFrame& frame) {
  const Box box = frame.box();
  std::vector<int> inks;
  for (const auto& line : frame.yLines) {
    if (!line.spansFrame || line.position_px < box.y0 + 4 || line.position_px > box.y1 - 4) continue;
    const int y = std::clamp(static_cast<int>(std::lround(line.position_px)), 0, d.rows - 1);
    for (int x = std::max(0, static_cast<int>(box.x0) + 3);
         x < std::min<int>(d.cols, static_cast<int>(box.x1) - 3); x += 3)
      inks.push_back(d.at<std::uint8_t>(y, x));
  }
  return medianOf(std::move(inks));
}

double overlapShare(const Box& a, const Box& b) {
  const Box common = a.common(b);
  return common.empty() ? 0 : common.area() / std::max(1e-9, a.area());
}

/// The colour of a mark's ink: of its pixel that is farthest from the paper.
Rgb colorOf(const Raster& raster, const cv::Mat& darkness, const Box& mark) {
  cv::Point darkest;
  const cv::Rect whole(0, 0, darkness.cols, darkness.rows);
  const cv::Rect at = cv::Rect(cv::Point(static_cast<int>(mark.x0 + 0.5), static_cast<int>(mark.y0 + 0.5)),
                               cv::Point(static_cast<int>(mark.x1 + 1.5), static_cast<int>(mark.y1 + 1.5))) &
                      whole;
  if (at.empty()) return {};
  cv::minMaxLoc(darkness(at), nullptr, nullptr, nullptr, &darkest);
  const std::uint8_t* const p = raster.at(at.x + darkest.x, at.y + darkest.y);
  return {p[0], p[1], p[2]};
}

/// Entries of a legend that stand in one row: parted at the samples between them, dashes too long for writing or of another
/// ink than the letters.
std::vector<TextLine> entriesOf(const TextLine& line, const Raster& raster, const cv::Mat& darkness) {
  constexpr double dashHeight = 0.4, longDash = 1.8, anyDash = 0.9;  // of a letter's height
  constexpr double otherInk = 60;                                    // colour levels
  std::vector<double> heights;
  for (const auto& g : line.glyphs)
    if (g.height() > dashHeight * g.width()) heights.push_back(g.height());
  if (heights.empty()) return {line};
  const double usual = medianOf(heights);
  std::vector<TextLine> entries(1);
  for (const auto& g : line.glyphs) {
    const bool dash = g.height() < dashHeight * usual && g.width() > anyDash * usual;
    TextLine& entry = entries.back();
    if (dash && !entry.glyphs.empty() &&
        (g.width() > longDash * usual ||
         colorDistance(colorOf(raster, darkness, g), colorOf(raster, darkness, entry.glyphs.back())) >
             otherInk)) {
      entries.emplace_back();
    } else {
      entry.box = entry.glyphs.empty() ? g : entry.box.joined(g);
      entry.glyphs.push_back(g);
    }
  }
  return entries;
}

/// The line without samples of a legend, leaders and arrowheads that stand beside its letters.
TextLine lettersOnly(const TextLine& line) {
  std::vector<double> heights;
  for (const auto& g : line.glyphs)
    if (g.height() > 0.4 * g.width()) heights.push_back(g.height());
  if (heights.empty()) return {};
  const double usual = medianOf(heights);
  TextLine kept;
  for (const auto& g : line.glyphs) {
    const bool dash = g.height() < 0.4 * usual && g.width() > 0.9 * usual;
    const bool atEnd = &g == &line.glyphs.front() || &g == &line.glyphs.back();
    const bool sample = atEnd && line.glyphs.size() > 3 && g.width() > 2.2 * usual;
    if (dash || sample || g.height() > 1.8 * usual) continue;
    kept.box = kept.glyphs.empty() ? g : kept.box.joined(g);
    kept.glyphs.push_back(g);
  }
  return kept;
}

/// Letters stand in a row: several, about equally high, none a dash.
bool looksWritten(const TextLine& line) {
  if (line.glyphs.size() < 3 || line.box.height() < 5 || line.box.width() < 1.2 * line.box.height())
    return false;
  std::vector<double> heights;
  for (const auto& g : line.glyphs) heights.push_back(g.height());
  const double usual = medianOf(heights);
  const auto letters = std::count_if(heights.begin(), heights.end(),
                                     [&](double h) { return h > 0.6 * usual && h < 1.9 * usual; });
  return usual >= 0.4 * line.box.height() && 10 * letters >= 6 * static_cast<long>(heights.size());
}

int lettersIn(const std::string& text) {
  return static_cast<int>(std::count_if(
      text.begin(), text.end(), [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }));
}

/// A name of letters and digits too short for a word, read with certainty: "TS-10", "1.6 N".
bool isShortName(const SeenText& seen) {
  constexpr double sure = 0.6;  // confidence
  const auto digits = std::count_if(seen.utf8.begin(), seen.utf8.end(),
                                    [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; });
  const int letters = lettersIn(seen.utf8);
  return seen.confidence >= sure && digits > 0 && letters > 0 && letters < minLetters &&
         digits + letters >= 3;
}

/// Callouts and titles inside first, then a legend beside, then what stands above and below.
int importance(const Box& line, const Box& frame) {
  const Point middle = line.middle();
  if (frame.contains(middle)) return 0;
  if (middle.x > frame.x1) return 1;
  return 2;
}

}  // namespace

void readGraphTexts(const PageView& view, const PlotFrame& frame, AxesFound& axes, const Progress& progress) {
  const Box box = frame.box();
  const cv::Mat d = darknessOf(view.raster, frame.paper);
  const int grid = gridInk(d, frame);
  // Writing darker than its grid stands out of it; where the grid is as dark, writing has a hole cut for it.
  const cv::Mat ink = grid > 0 && grid < 150 ? inkAbove(d, grid + 30) : inkOf(d);
  const double largest = 0.12 * std::min(box.width(), box.height()) + 6;
  const Box around{box.x0 - 0.05 * box.width(), box.y0 - 0.25 * box.height(), box.x1 + 0.5 * box.width(),
                   box.y1 + 0.35 * box.height()};
  std::vector<TextLine> lines;
  for (const auto& row : groupedLines(glyphsIn(glyphBoxes(ink, 2, largest), around, largest), 1.1))
    for (const auto& entry : entriesOf(row, view.raster, d)) lines.push_back(lettersOnly(entry));
  std::erase_if(lines, [&](const TextLine& line) {
    return !looksWritten(line) || std::any_of(axes.texts.begin(), axes.texts.end(), [&](const SeenText& t) {
      return overlapShare(line.box, t.box) > 0.4;
    });
  });
  std::stable_sort(lines.begin(), lines.end(), [&](const TextLine& a, const TextLine& b) {
    return importance(a.box, box) < importance(b.box, box);
  });
  if (lines.size() > maxLines) lines.resize(maxLines);
  TextReader reader(view);
  const std::vector<LetterShape> digits = digitsOf(d, ink, axes.calibration.value);
  for (const auto& line : lines) {
    if (progress.isCancelled()) return;
    auto seen = reader.readLine(line.box, TextKind::words);
    if (!digits.empty()) seen.utf8 = withKnownDigits(seen.utf8, lettersOf(ink, line.box), digits);
    if (seen.confidence >= minConfidence && lettersIn(seen.utf8) >= minLetters) {
      axes.texts.push_back(std::move(seen));
      continue;
    }
    if (!isShortName(seen)) seen.utf8.clear();
    seen.box = line.box;
    axes.otherLines.push_back(std::move(seen));
  }
}

}  // namespace detent::importer
