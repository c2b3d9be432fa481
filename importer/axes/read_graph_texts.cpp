// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include <opencv2/core.hpp>

#include "importer/axes/axis_calibration.h"
#include "importer/axes/cyrillic_look.h"
#include "importer/axes/equal_digits.h"
#include "importer/axes/read_text.h"
#include "importer/axes/text_lines.h"
#include "importer/frame/darkness.h"
#include "importer/frame/glyph_marks.h"
#include "importer/lexicon/stroke_words.h"
#include "importer/page/quantile.h"
#include "importer/page/same_colour.h"

namespace detent::importer {
namespace {

constexpr std::size_t maxLines = 24;   // a view with more text is a page, not a plot
constexpr double minConfidence = 0.5;  // dashes and arrows that were read as text have less
constexpr int minLetters = 3;

int pixelAt(double at_px) { return static_cast<int>(std::lround(at_px)); }

/// Median darkness of the gridlines, without the frame's own edges; 0 without a grid. Marks that are darker
/// are letters, even where gridlines cross them.
int gridDarkness(const cv::Mat& d, const PlotFrame& frame) {
  const Box box = frame.box();
  std::vector<int> colours;
  for (const auto& line : frame.yLines) {
    if (!line.spansFrame || line.position_px < box.y0 + 4 || line.position_px > box.y1 - 4) continue;
    const int y = std::clamp(static_cast<int>(std::lround(line.position_px)), 0, d.rows - 1);
    for (int x = std::max(0, static_cast<int>(box.x0) + 3);
         x < std::min<int>(d.cols, static_cast<int>(box.x1) - 3); x += 3)
      colours.push_back(d.at<std::uint8_t>(y, x));
  }
  return medianOf(std::move(colours));
}

/// Fills a gridline between `from_px` and `to_px` of its length from both its sides: letters across it stay.
/// `isColumn`: the line runs down the page.
void clearLine(Raster& raster, cv::Mat& darkness, const GridLine& line, double from_px, double to_px,
               bool isColumn) {
  constexpr double edge_px = 1;  // a line is softened so far beyond its width
  const double reach_px = 0.5 * line.width_px + edge_px;
  const int before = pixelAt(line.position_px - reach_px) - 1,
            behind = pixelAt(line.position_px + reach_px) + 1,
            across = isColumn ? darkness.cols : darkness.rows,
            along = isColumn ? darkness.rows : darkness.cols;
  if (before < 0 || behind >= across) return;
  const auto placeOf = [&](int at, int i) { return isColumn ? cv::Point(at, i) : cv::Point(i, at); };
  const auto byteOf = [&](cv::Point p, int channel) -> std::uint8_t& {
    return raster.rgb[static_cast<std::size_t>(raster.at(p.x, p.y) - raster.rgb.data() + channel)];
  };
  for (int i = std::max(0, pixelAt(from_px)); i <= std::min(along - 1, pixelAt(to_px)); ++i) {
    const cv::Point low = placeOf(before, i), high = placeOf(behind, i);
    for (int at = before + 1; at < behind; ++at) {
      const double share = static_cast<double>(at - before) / (behind - before);
      const auto between = [share](std::uint8_t a, std::uint8_t b) {
        return static_cast<std::uint8_t>(std::lround(std::lerp(double(a), double(b), share)));
      };
      const cv::Point p = placeOf(at, i);
      for (int channel = 0; channel < 3; ++channel)
        byteOf(p, channel) = between(byteOf(low, channel), byteOf(high, channel));
      darkness.at<std::uint8_t>(p) = between(darkness.at<std::uint8_t>(low), darkness.at<std::uint8_t>(high));
    }
  }
}

/// Clears the gridlines inside a plot, for words as dark as they are.
void clearGrid(Raster& raster, cv::Mat& darkness, const PlotFrame& frame) {
  const Box box = frame.box();
  for (const GridLine& line : frame.xLines)
    if (line.spansFrame) clearLine(raster, darkness, line, box.y0, box.y1, true);
  for (const GridLine& line : frame.yLines)
    if (line.spansFrame) clearLine(raster, darkness, line, box.x0, box.x1, false);
}

double overlapShare(const Box& a, const Box& b) {
  const Box common = a.common(b);
  return common.empty() ? 0 : common.area() / std::max(1e-9, a.area());
}

/// Colour of a mark's darkest pixel; {} outside the page.
Rgb colorOf(const Raster& raster, const cv::Mat& darkness, const Box& mark) {
  cv::Point darkest;
  const cv::Rect whole(0, 0, darkness.cols, darkness.rows);
  const cv::Rect at = cv::Rect(cv::Point(pixelAt(mark.x0), pixelAt(mark.y0)),
                               cv::Point(static_cast<int>(mark.x1 + 1.5), static_cast<int>(mark.y1 + 1.5))) &
                      whole;
  if (at.empty()) return {};
  cv::minMaxLoc(darkness(at), nullptr, nullptr, nullptr, &darkest);
  const std::uint8_t* const p = raster.at(at.x + darkest.x, at.y + darkest.y);
  return {p[0], p[1], p[2]};
}

/// Share of a mark's box that is dark; 0 for an empty box.
double filledShare(const cv::Mat& marks, const Box& mark) {
  const cv::Rect whole(0, 0, marks.cols, marks.rows);
  const cv::Rect at =
      cv::Rect(cv::Point(pixelAt(mark.x0), pixelAt(mark.y0)), cv::Point(pixelAt(mark.x1), pixelAt(mark.y1))) &
      whole;
  return at.empty() ? 0 : static_cast<double>(cv::countNonZero(marks(at))) / at.area();
}

/// The page as pixels, as darkness, and as a mask of dark marks.
struct Inked {
  const Raster& raster;
  const cv::Mat& darkness;
  const cv::Mat& darkMask;
};

/// Returns true if a mark beside a letter is a legend key: a dash too long for a letter or, in a colour other
/// than the letter's, a shorter dash, a filled square or disc, or a line with its marker. `usual_px`: height
/// of the letters.
bool isSample(const Box& mark, const Box& letter, double usual_px, const Inked& on) {
  constexpr double dashHeight = 0.4, longDash = 1.8, anyDash = 0.9, wideDash = 0.6,
                   highest = 3.2;         // factor of a letter's height
  constexpr double differentColour = 60;  // colour levels
  constexpr double filled = 0.7;          // share of its box
  const bool dash = mark.height() < dashHeight * usual_px;
  if (dash && mark.width() > longDash * usual_px) return true;
  if (mark.width() < (dash ? anyDash : wideDash) * usual_px || mark.height() > highest * usual_px)
    return false;
  if (colorDistance(colorOf(on.raster, on.darkness, mark), colorOf(on.raster, on.darkness, letter)) <=
      differentColour)
    return false;
  return dash || mark.width() > longDash * usual_px || filledShare(on.darkMask, mark) >= filled;
}

/// One row of a legend, divided at its keys: the entries without the keys, and the keys.
struct LegendRow {
  std::vector<TextLine> entries;
  std::vector<Box> samples;
};

LegendRow partedAtSamples(const TextLine& line, const Inked& on) {
  constexpr double notFlat = 0.4;  // height relative to its width
  std::vector<double> heights;
  for (const auto& g : line.glyphs)
    if (g.height() > notFlat * g.width()) heights.push_back(g.height());
  if (heights.empty()) return {{line}, {}};
  const double usual = medianOf(heights);
  LegendRow row{{{}}, {}};
  auto& entries = row.entries;
  for (std::size_t i = 0; i < line.glyphs.size(); ++i) {
    const Box& g = line.glyphs[i];
    TextLine& entry = entries.back();
    const Box* const beside = !entry.glyphs.empty()        ? &entry.glyphs.back()
                              : i + 1 < line.glyphs.size() ? &line.glyphs[i + 1]
                                                           : nullptr;
    if (beside != nullptr && isSample(g, *beside, usual, on)) {
      row.samples.push_back(g);
      if (!entry.glyphs.empty()) entries.emplace_back();
    } else {
      entry.box = entry.glyphs.empty() ? g : entry.box.joined(g);
      entry.glyphs.push_back(g);
    }
  }
  if (entries.back().glyphs.empty()) entries.pop_back();
  return row;
}

/// Returns true if a horizontal line runs through the whole mark: a legend key with its marker, or a leader
/// with its arrowhead. In letters that touch each other there is no such line.
bool isLineLike(const Box& mark, const cv::Mat& marks) {
  constexpr double nearlyAll = 0.9;  // share of the columns
  const int left = std::max(0, static_cast<int>(std::ceil(mark.x0))),
            right = std::min(marks.cols - 1, static_cast<int>(mark.x1));
  for (int y = std::max(0, static_cast<int>(mark.y0));
       y <= std::min(marks.rows - 1, static_cast<int>(mark.y1)); ++y) {
    int inked = 0;
    for (int x = left; x <= right; ++x) inked += marks.at<std::uint8_t>(y, x) != 0;
    if (inked >= nearlyAll * (right - left + 1)) return true;
  }
  return false;
}

/// The line of text without legend keys, leaders and arrowheads beside its letters.
TextLine lettersOnly(const TextLine& line, const cv::Mat& marks) {
  std::vector<double> heights, middles_px;
  for (const auto& g : line.glyphs) {
    if (!(g.height() > 0.4 * g.width())) continue;
    heights.push_back(g.height());
    middles_px.push_back(g.middle().y);
  }
  if (heights.empty()) return {};
  const double usual = medianOf(heights), middle_px = medianOf(middles_px);
  TextLine kept;
  for (const auto& g : line.glyphs) {
    const bool dash = g.height() < 0.4 * usual && g.width() > 0.9 * usual;
    const bool atEnd = &g == &line.glyphs.front() || &g == &line.glyphs.back();
    const bool sample = atEnd && line.glyphs.size() > 3 && g.width() > 2.2 * usual && isLineLike(g, marks);
    // at the far end of a leader; parts of one Korean letter stand closer
    const bool elsewhere = std::abs(g.middle().y - middle_px) > 2 * usual;
    if (dash || sample || elsewhere || g.height() > 1.8 * usual) continue;
    kept.box = kept.glyphs.empty() ? g : kept.box.joined(g);
    kept.glyphs.push_back(g);
  }
  return kept;
}

/// Returns true for a row of letters: several, about equally high, none of them a dash.
bool isWordRow(const TextLine& line) {
  if (line.glyphs.size() < 3 || line.box.height() < 5 || line.box.width() < 1.2 * line.box.height())
    return false;
  std::vector<double> heights;
  for (const auto& g : line.glyphs) heights.push_back(g.height());
  const double usual = medianOf(heights);
  const auto letters = std::count_if(heights.begin(), heights.end(),
                                     [&](double h) { return h > 0.6 * usual && h < 1.9 * usual; });
  return usual >= 0.4 * line.box.height() && 10 * letters >= 6 * static_cast<long>(heights.size());
}

/// Returns true if letters stand beside a legend key. A name of one or two letters counts ("A", "V2").
bool isBesideSample(const TextLine& line, const std::vector<Box>& marks, const Inked& on) {
  constexpr double least_px = 5, apart = 2.2, level = 0.4;  // apart, level: factors of the letters' height
  const double height = line.box.height();
  if (line.glyphs.empty() || height < least_px) return false;
  return std::ranges::any_of(marks, [&](const Box& mark) {
    const double gap = std::max(mark.x0 - line.box.x1, line.box.x0 - mark.x1);
    return gap > 0 && gap < apart * height &&
           std::abs(mark.middle().y - line.box.middle().y) < level * height &&
           isSample(mark, line.glyphs.front(), height, on);
  });
}

int letterCountOfText(const std::string& text) {
  return static_cast<int>(std::count_if(
      text.begin(), text.end(), [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }));
}

/// Returns true for a name of letters and digits that is too short for a word but was read with certainty:
/// "TS-10", "1.6 N"; beside a legend key also "A" and "2019".
bool isShortName(const SeenText& seen, bool besideSample) {
  constexpr double sure = 0.6;  // confidence
  const auto digits = std::count_if(seen.utf8.begin(), seen.utf8.end(),
                                    [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; });
  const int letters = letterCountOfText(seen.utf8);
  if (seen.confidence < sure) return false;
  if (letters == 0) return besideSample && digits >= 2;  // a year or a size
  return letters < minLetters && (besideSample || (digits > 0 && digits + letters >= 3));
}

/// A name's pattern: without blanks, and with every digit replaced by 0. "3.5 N" gives "0.0N".
std::string shapeOf(const std::string& name) {
  std::string shape;
  for (const char c : name)
    if (c != ' ') shape += std::isdigit(static_cast<unsigned char>(c)) != 0 ? '0' : c;
  return shape;
}

/// Accepts short names that were read with doubt if names of the same pattern stand in line with them, as in
/// a legend.
void keepAlike(std::vector<SeenText>& lines, const std::vector<SeenText>& doubted) {
  for (const SeenText& name : doubted) {
    const auto own = std::ranges::find(lines, name.box, &SeenText::box);
    const bool hasLike = std::ranges::any_of(lines, [&](const SeenText& other) {
      return !other.utf8.empty() && other.box.inLineWith(name.box) &&
             shapeOf(other.utf8) == shapeOf(name.utf8);
    });
    if (own != lines.end() && hasLike) own->utf8 = name.utf8;
  }
}

/// Two panels of one button, the press in one and the release in the other: this plot's heading is the word
/// for the press, and in line with it, above a plot at the right, stands the word for the release. Adds that
/// word to the texts.
void addHeadingBeside(AxesFound& axes, const Box& frame, const cv::Mat& marks, double largest_px,
                      TextReader& reader) {
  // share of the plot's height, beyond its last number; share of the plot's width
  constexpr double above = 0.6, beside = 1.6;
  const Box headings{frame.x0, frame.y0 - above * frame.height(), frame.x1 + beside * frame.width(),
                     frame.y0};
  const auto strokeAt = [&](const TextLine& line) {
    SeenText seen = reader.readLine(line.box, TextKind::words);
    return std::pair(strokeOfWord(folded(seen.utf8)), std::move(seen));
  };
  const auto lines = groupedLines(glyphsIn(glyphBoxes(marks, 2, largest_px), headings, largest_px), 1.1);
  for (const TextLine& own : lines) {
    if (own.box.middle().x > frame.x1 || !isWordRow(own)) continue;
    std::vector<TextLine> others = lines;
    std::erase_if(others, [&](const TextLine& other) {
      return other.box.x0 < frame.x1 || !isWordRow(other) ||
             std::abs(own.box.middle().y - other.box.middle().y) >= 0.5 * own.box.height();
    });
    if (others.empty() || strokeAt(own).first != Stroke::press) continue;
    for (const TextLine& other : others)
      if (auto [stroke, seen] = strokeAt(other); stroke == Stroke::release)
        axes.texts.push_back(std::move(seen));
  }
}

/// Order in which lines are read: callouts and titles inside the plot, then a legend beside it, then lines
/// above and below.
int importance(const Box& line, const Box& frame) {
  const Point middle = line.middle();
  if (frame.contains(middle)) return 0;
  if (middle.x > frame.x1) return 1;
  return 2;
}

}  // namespace

void readGraphTexts(const PageView& seenView, const PlotFrame& frame, AxesFound& axes,
                    const Progress& progress) {
  const Box box = frame.box();
  cv::Mat d = darknessOf(seenView.raster, frame.paper);
  const int grid = gridDarkness(d, frame);
  // Text darker than the grid is separated by its darkness.
  std::optional<PageView> cleared;  // its pixels alone: paths and texts of a page may be many
  if (grid >= 150) {
    cleared.emplace().raster = seenView.raster;
    clearGrid(cleared->raster, d, frame);
  }
  const PageView& view = cleared ? *cleared : seenView;
  const cv::Mat darkMarks = grid > 0 && grid < 150 ? marksAbove(d, grid + 30) : darkMaskOf(d);
  const double largest = 0.12 * std::min(box.width(), box.height()) + 6;
  const Box around{box.x0 - 0.05 * box.width(), box.y0 - 0.25 * box.height(), box.x1 + 0.5 * box.width(),
                   box.y1 + 0.35 * box.height()};
  const Inked on{view.raster, d, darkMarks};
  const std::vector<Box> marks = glyphsIn(glyphBoxes(darkMarks, 2, largest), around, largest);
  // most letters of a name that is too short for a word and stands beside a key; most letters of a name
  // beside a key in general
  constexpr std::size_t mostLetters = 2, mostOfAName = 5;
  std::vector<TextLine> lines;
  for (const auto& row : groupedLines(marks, 1.1)) {
    const LegendRow parted = partedAtSamples(row, on);
    // A legend row may have been read as one line, or together with its key, when titles were searched.
    std::erase_if(axes.texts, [&](const SeenText& seen) {
      const auto isIn = [&](const Box& sample) { return seen.box.contains(sample); };
      if (seen.confidence < 1 && std::ranges::any_of(parted.samples, isIn)) return true;
      return std::ranges::count_if(parted.entries, [&](const TextLine& entry) {
               return static_cast<int>(entry.glyphs.size()) >= minLetters &&
                      overlapShare(entry.box, seen.box) > 0.4;
             }) > 1;
    });
    for (const TextLine& entry : parted.entries) lines.push_back(lettersOnly(entry, darkMarks));
  }
  std::erase_if(lines, [&](const TextLine& line) {
    const bool isName = line.glyphs.size() <= mostLetters && isBesideSample(line, marks, on);
    return (!isWordRow(line) && !isName) ||
           std::any_of(axes.texts.begin(), axes.texts.end(),
                       [&](const SeenText& t) { return overlapShare(line.box, t.box) > 0.4; });
  });
  std::stable_sort(lines.begin(), lines.end(), [&](const TextLine& a, const TextLine& b) {
    return importance(a.box, box) < importance(b.box, box);
  });
  if (lines.size() > maxLines) lines.resize(maxLines);
  TextReader reader(view);
  std::vector<SeenText> doubted;
  const std::vector<LetterShape> digits = digitsOf(d, darkMarks, axes.calibration.value);
  for (const auto& line : lines) {
    if (progress.isCancelled()) return;
    const bool besideSample = isBesideSample(line, marks, on);
    auto seen =
        (cleared && box.contains(line.box.middle())) || (besideSample && line.glyphs.size() <= mostOfAName)
            ? reader.readLineCarefully(line.box, TextKind::words)
            : reader.readLine(line.box, TextKind::words);
    if (!digits.empty()) seen.utf8 = withKnownDigits(seen.utf8, lettersOf(darkMarks, line.box), digits);
    if (seen.confidence >= minConfidence && letterCountOfText(seen.utf8) >= minLetters) {
      seen.utf8 = withCyrillicWords(seen.utf8);
      axes.texts.push_back(std::move(seen));
      continue;
    }
    seen.box = line.box;
    if (!isShortName(seen, besideSample)) {
      if (besideSample && !seen.utf8.empty()) doubted.push_back(seen);
      seen.utf8.clear();
    }
    axes.otherLines.push_back(std::move(seen));
  }
  keepAlike(axes.otherLines, doubted);
  addHeadingBeside(axes, box, darkMarks, largest, reader);
}

}  // namespace detent::importer
