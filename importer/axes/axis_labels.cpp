// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/axis_labels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "importer/axes/equal_digits.h"
#include "importer/axes/small_labels.h"
#include "importer/axes/text_lines.h"
#include "importer/frame/glyph_marks.h"
#include "importer/frame/label_rows.h"
#include "importer/page/quantile.h"

namespace detent::importer {
namespace {

constexpr int rowAttempts = 3;
// confidence of the text engine from which a label counts as certain
constexpr double sureLabelReading = 0.9;

/// Returns true if the text is one number without blanks. In a line of several numbers their positions are
/// unknown.
bool isNumberText(const TextBox& t, double angle_deg) {
  return std::abs(t.angle_deg - angle_deg) < 20 && t.utf8.find(' ') == std::string::npos &&
         printedNumber(t.utf8).has_value();
}

/// Words of the document's own text that are numbers.
std::vector<Box> ownLabelWords(const GraphReading& r, const Box& band, double angle_deg) {
  std::vector<Box> words;
  for (const auto& t : r.view.texts)
    if (isNumberText(t, angle_deg) && t.box.touches(band)) words.push_back(t.box);
  return words;
}

std::vector<Box> labelGlyphs(const GraphReading& r, const Box& band) {
  const double largest = 0.12 * std::min(r.box.width(), r.box.height()) + 10;
  return glyphsIn(r.glyphs, band, largest);
}

/// Boxes of dark pixels that may be numbers.
std::vector<Box> inkedLabelWords(const GraphReading& r, const Box& band, Axis axis) {
  const auto glyphs = labelGlyphs(r, band);
  auto words = numberBoxes(glyphs);
  if (axis == Axis::y)
    for (Box& word : words) word = withoutTitleLetter(word, glyphs);
  return words;
}

/// Cuts a word left of the axis behind its last digit. A digit that touches the axis was partly taken for a
/// tick, so that "120" would be read as 12. A tick is lower than a digit.
Box untilAxis(const GraphReading& r, const Box& word) {
  constexpr double apart = 0.45, digit = 0.5;  // shares of the word's height
  const int top = std::max(0, static_cast<int>(std::ceil(word.y0))),
            bottom = std::min(r.darkMask.rows - 1, static_cast<int>(std::floor(word.y1)));
  const int margin = bottom - top;
  const auto isMark = [&](int y, int x) {
    return y >= 0 && y < r.darkMask.rows && r.darkMask.at<std::uint8_t>(y, x) != 0;
  };
  Box whole = word;
  const double end = std::min(r.box.x0, r.darkMask.cols - 1.0);
  for (int x = static_cast<int>(std::ceil(word.x1)); x < std::min(end, whole.x1 + apart * word.height());
       ++x) {
    if (isMark(top - margin / 2, x) || isMark(bottom + margin / 2, x)) break;  // the axis is reached
    int first = bottom, last = top;
    for (int y = top; y <= bottom; ++y)
      if (isMark(y, x)) first = std::min(first, y), last = std::max(last, y);
    if (last - first >= digit * word.height()) whole.x1 = x + 0.5;
  }
  return whole;
}

SeenText readLabel(GraphReading& r, const Box& word, TextKind kind, double angle_deg) {
  for (const auto& t : r.view.texts) {
    if (word.contains(t.box.middle()) && isNumberText(t, angle_deg)) return {t.utf8, word, 1.0, angle_deg};
  }
  return r.reader.readLineCarefully(word, kind, angle_deg);
}

/// Extents of a word along its line and across it.
double widthOf(const Box& word, double angle_deg) { return angle_deg == 0 ? word.width() : word.height(); }
double heightOf(const Box& word, double angle_deg) { return angle_deg == 0 ? word.height() : word.width(); }

/// Width of a number's characters in digits; points and ones are narrower.
double digitsWide(const std::string& text) {
  double n = 0;
  for (const char c : text) n += c == '.' || c == ',' ? 0.4 : c == '1' ? 0.6 : c == ' ' ? 0 : 1;
  return n;
}

/// Withdraws readings that leave room for more digits than were read: the "2" of "20" fits an even scale as
/// well, which would then be ten times too small.
void dropIncomplete(AxisLabels& found, std::vector<LabelPlace>& positions, double angle_deg) {
  constexpr double roomForMore = 1.7;  // times the usual width of a digit
  std::vector<double> perDigit(found.words.size(), 0), known;
  for (std::size_t i = 0; i < found.words.size(); ++i) {
    const double n = digitsWide(found.words[i].utf8);
    if (found.readings[i].empty() || n < 0.6) continue;
    perDigit[i] = widthOf(found.words[i].box, angle_deg) / n;
    known.push_back(perDigit[i]);
  }
  if (known.size() < 2) return;
  const double most = roomForMore * medianOf(std::move(known));
  for (std::size_t i = 0; i < found.words.size(); ++i) {
    if (perDigit[i] <= most) continue;
    found.readings[i].clear();
    positions[i].readings.clear();
  }
}

/// Box of a number with the letters that follow it on its line, up to the next of the `numbers`. `glyphs`
/// from the left.
Box withLettersBehind(const std::vector<Box>& glyphs, const Box& number, const std::vector<Box>& numbers) {
  // share of the number's height; share of the lower one's height
  constexpr double blank = 0.9, level = 0.4;
  Box whole = number;
  for (const Box& g : glyphs) {
    const double shared = std::min(g.y1, number.y1) - std::max(g.y0, number.y0);
    if (g.x1 <= whole.x1 || shared < level * std::min(g.height(), number.height())) continue;
    const bool ofNext = std::ranges::any_of(
        numbers, [&](const Box& next) { return next.x0 > number.x0 && next.contains(g.middle()); });
    if (ofNext || g.x0 - whole.x1 > blank * number.height()) break;
    whole = whole.joined(g);
  }
  return whole;
}

/// Moves labels of an x axis to the centre of number and unit ("0.5 mm"), because a program centres both at
/// the tick. A single label with letters is left alone: the letters may be a title beside the last number.
void centreWithUnits(const GraphReading& r, const AxisLabels& found, std::vector<LabelPlace>& positions) {
  constexpr int fewest = 2;
  const std::vector<Box> wholes = withLettersBehind(r.glyphs, found);
  int lettered = 0;
  for (std::size_t i = 0; i < wholes.size(); ++i) lettered += wholes[i] != found.words[i].box;
  if (lettered < fewest) return;
  for (std::size_t i = 0; i < wholes.size(); ++i) positions[i].center_px = wholes[i].middle().x;
}

int agreed(const AxisLabels& a) { return a.progression ? a.progression->labels : 0; }

/// Reads small labels together if the engine read them with doubt; the result replaces what it read.
void readTogether(const GraphReading& r, AxisLabels& found, std::vector<LabelPlace>& positions,
                  const std::vector<GridLine>& ticks, Axis axis) {
  std::vector<Box> words;
  std::vector<double> centers;
  for (std::size_t i = 0; i < found.words.size(); ++i) {
    words.push_back(found.words[i].box);
    centers.push_back(positions[i].center_px);
  }
  const auto read = readSmallLabels(r.darkness, words, centers, axis == Axis::x);
  if (!read) return;
  // The engine loses points and digits of small print, but a label that it read completely and with certainty
  // is kept.
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string engine = digitsOf(found.words[i].utf8), together = digitsOf(read->texts[i]);
    if (found.words[i].confidence >= sureLabelReading && engine.size() == together.size() &&
        engine != together)
      return;
  }
  for (std::size_t i = 0; i < words.size(); ++i) {
    found.words[i].utf8 = read->texts[i];
    found.words[i].confidence = read->likeness;
    found.readings[i] = positions[i].readings = numberReadings(read->texts[i], 1);
  }
  found.progression = fitProgression(positions, ticks, axis == Axis::x);
}

/// If equal digits have equal pixels, reads each shape as the same digit everywhere.
void readAlike(const GraphReading& r, AxisLabels& found, const std::vector<LabelPlace>& positions,
               std::vector<std::string>& texts, Axis axis) {
  // text of the document itself
  const auto isText = [](const SeenText& word) { return word.confidence >= 1; };
  if (std::ranges::any_of(found.words, isText)) return;
  std::vector<std::vector<LetterShape>> letters;
  std::vector<double> centers;
  std::vector<Box> boxes;
  for (const SeenText& word : found.words) boxes.push_back(word.box);
  if (!isUnsmoothed(r.darkness, boxes)) return;
  for (std::size_t i = 0; i < found.words.size(); ++i) {
    letters.push_back(lettersOf(r.darkMask, found.words[i].box));
    centers.push_back(positions[i].center_px);
  }
  const auto read = readEqualDigits(letters, centers, axis == Axis::x, texts);
  if (!read) return;
  for (std::size_t i = 0; i < read->size(); ++i) {
    texts[i] = found.words[i].utf8 = (*read)[i];
    found.words[i].confidence = std::max(found.words[i].confidence, sureLabelReading);
    found.readings[i] = numberReadings(texts[i], found.words[i].confidence);
  }
}

/// Restores lost decimal points. "00" as wide as two digits at the zero of the scale is a "0.0" that lost its
/// point; then the other two-digit numbers of this print have lost theirs too. Small print reads 0.0, 0.5,
/// 1.0 as 00, 5, 10.
void putPointsBack(AxisLabels& found, std::vector<LabelPlace>& positions, const std::vector<GridLine>& ticks,
                   Axis axis, double angle_deg) {
  constexpr double asWide = 0.8;  // share of the usual width of a digit
  if (!found.progression) return;
  const auto isBare = [&](std::size_t i) {
    const std::string& text = found.words[i].utf8;
    return text.size() > 1 && digitsOf(text) == text;
  };
  const auto isZero = [&](std::size_t i) {
    return found.words[i].utf8.find_first_not_of('0') == std::string::npos;
  };
  std::vector<double> perDigit;
  for (const SeenText& word : found.words)
    perDigit.push_back(widthOf(word.box, angle_deg) / std::max(0.6, digitsWide(word.utf8)));
  const double least = asWide * medianOf(perDigit);
  bool lost = false;
  for (std::size_t i = 0; i < found.words.size(); ++i)
    lost |= isBare(i) && isZero(i) && found.progression->reading[i] >= 0 && perDigit[i] >= least;
  if (!lost) return;
  for (std::size_t i = 0; i < found.words.size(); ++i) {
    auto& readings = found.readings[i];
    if (!isBare(i) || isZero(i)) continue;
    const auto whole = printedNumber(found.words[i].utf8);
    std::erase_if(readings, [&](const NumberReading& reading) { return reading.value == whole; });
    for (NumberReading& reading : readings) reading.weight = 1;
    positions[i].readings = readings;
  }
  found.progression = fitProgression(positions, ticks, axis == Axis::x);
}

/// Accepts numbers that fall to the right or upwards only if all numbers of a row agree, at least four, each
/// at its tick. The other axis' zero in the corner beside them belongs to no scale that falls, and is
/// dropped.
std::optional<Progression> fallingProgression(std::vector<LabelPlace>& positions,
                                              const std::vector<GridLine>& ticks, Axis axis) {
  constexpr int fewest = 4;
  auto falling = fitProgression(positions, ticks, axis != Axis::x);
  if (!falling || !falling->fromTicks || falling->labels < fewest) return {};
  const auto numbers =
      std::ranges::count_if(positions, [](const LabelPlace& p) { return !p.readings.empty(); });
  const std::size_t corner = axis == Axis::x ? 0 : positions.size() - 1;
  std::vector<NumberReading>& atCorner = positions[corner].readings;
  const bool ofOtherAxis = falling->reading[corner] < 0 && !atCorner.empty() && atCorner.front().value == 0;
  if (falling->labels + (ofOtherAxis ? 1 : 0) < numbers) return {};
  if (ofOtherAxis) atCorner.clear();
  return falling;
}

/// `angle_deg` of the numbers' baselines: 0, or 90 where they read upwards.
AxisLabels fitRow(GraphReading& r, const LabelRow& row, const std::vector<GridLine>& ticks, Axis axis,
                  TextKind kind, double angle_deg) {
  AxisLabels found;
  std::vector<LabelPlace> positions;
  std::vector<std::string> texts;
  double height = 0;
  const bool upright = angle_deg == 0;
  for (const auto& w : row.words) height = std::max(height, heightOf(w, angle_deg));
  for (const auto& found_px : row.words) {
    if (heightOf(found_px, angle_deg) < 0.5 * height) continue;
    const bool beforeAxis = upright && axis == Axis::y && found_px.x1 < r.box.x0;
    const Box w = beforeAxis ? untilAxis(r, found_px) : found_px;
    auto seen = readLabel(r, w, kind, angle_deg);
    const auto [number, suffix] = numberAndSuffix(seen.utf8);
    if (kind == TextKind::words && found.suffix.empty()) found.suffix = suffix;
    LabelPlace place;
    place.center_px = axis == Axis::x ? w.middle().x : w.middle().y;
    place.reach_px = 0.45 * height + 1.5;
    texts.push_back(kind == TextKind::words ? number : seen.utf8);
    found.readings.push_back(numberReadings(texts.back(), seen.confidence));
    found.extent = found.words.empty() ? w : found.extent.joined(w);
    found.words.push_back(std::move(seen));
    positions.push_back(std::move(place));
  }
  if (kind == TextKind::number && upright) readAlike(r, found, positions, texts, axis);
  expectLostPoints(texts, found.readings);
  found.thousands = expectThousands(texts, found.readings);
  for (std::size_t i = 0; i < positions.size(); ++i) positions[i].readings = found.readings[i];
  if (axis == Axis::x && upright) centreWithUnits(r, found, positions);
  if (kind == TextKind::number || found.suffix.empty()) dropIncomplete(found, positions, angle_deg);
  found.progression = fitProgression(positions, ticks, axis == Axis::x);
  if (kind == TextKind::number) putPointsBack(found, positions, ticks, axis, angle_deg);
  if (!found.progression || found.progression->labels < 3)
    if (auto falling = fallingProgression(positions, ticks, axis)) {
      found.progression = std::move(falling);
      for (std::size_t i = 0; i < positions.size(); ++i) found.readings[i] = positions[i].readings;
    }
  const bool settled = agreed(found) == static_cast<int>(found.words.size());
  if (kind == TextKind::number && height <= smallDigits_px && !settled && upright)
    readTogether(r, found, positions, ticks, axis);
  return found;
}

/// Returns true if no better row can be expected. Letters of a title that runs upwards may also be read as
/// evenly increasing numbers, but they do not stand at the axis' ticks or gridlines.
bool settles(const AxisLabels& a, const std::vector<GridLine>& lines) {
  constexpr std::size_t fewestLines = 3;
  return agreed(a) >= 3 && 2 * agreed(a) > static_cast<int>(a.words.size()) &&
         (a.progression->fromTicks || lines.size() < fewestLines);
}

std::optional<AxisLabels> tryRows(GraphReading& r, Axis axis, std::vector<Box> words,
                                  const std::vector<GridLine>& lines, TextKind kind) {
  std::vector<double> ticks;
  for (const auto& line : lines) ticks.push_back(line.position_px);
  std::optional<AxisLabels> best;
  for (int n = 0; n < rowAttempts; ++n) {
    const auto row = axis == Axis::x ? labelsBelow(words, r.box, ticks) : labelsLeft(words, r.box, ticks);
    if (row.words.size() < 2) break;
    auto fit = fitRow(r, row, lines, axis, kind, 0);
    if (!best || agreed(fit) > agreed(*best)) best = std::move(fit);
    if (settles(*best, lines)) break;
    std::erase_if(words, [&](const Box& w) {
      return std::find(row.words.begin(), row.words.end(), w) != row.words.end();
    });
  }
  return best;
}

/// The column of numbers left of the frame that read upwards, as some programs write them (R by default). The
/// page is turned for reading: the numbers then form a row above the plot, or below it after mirroring.
std::optional<AxisLabels> readUpwardLabels(GraphReading& r, const Box& band,
                                           const std::vector<GridLine>& lines) {
  constexpr double upwards_deg = 90;
  constexpr int fewestRegular = 3;
  std::vector<Box> words = ownLabelWords(r, band, upwards_deg);
  if (words.size() < fewestRegular) words = labelGlyphs(r, band);
  for (Box& word : words) word = turned(word, 1);
  words = numberBoxes(words);
  for (Box& word : words) word = upsideDown(word);
  std::vector<double> ticks;
  for (const auto& line : lines) ticks.push_back(-line.position_px);
  LabelRow row = labelsBelow(words, upsideDown(turned(r.box, 1)), ticks);
  if (row.regular < fewestRegular) return {};
  for (Box& word : row.words) word = turned(upsideDown(word), 3);
  std::reverse(row.words.begin(), row.words.end());  // from top to bottom, like upright labels
  return fitRow(r, row, lines, Axis::y, TextKind::number, upwards_deg);
}

/// Returns true if most labels were read with low confidence because they contain letters: the digit reader
/// turns "20gf" into 209 or nothing.
bool holdsLetters(const AxisLabels& labels) {
  constexpr double doubted = 0.2;  // confidence of the engine below which a word counts as doubted
  const auto isDoubted = [](const SeenText& word) { return word.confidence < doubted; };
  return 2 * std::ranges::count_if(labels.words, isDoubted) > std::ssize(labels.words);
}

/// Returns true if all numbers of a scale end in the same digit and no scale has such an end: 9, 509 and 1009
/// are "0g", "50g" and "100g".
bool endsAlike(const AxisLabels& labels) {
  if (!labels.progression) return false;
  std::string ends;
  for (std::size_t i = 0; i < labels.words.size(); ++i)
    if (const std::string digits = digitsOf(labels.words[i].utf8);
        labels.progression->reading[i] >= 0 && !digits.empty())
      ends += digits.back();
  return ends.size() > 2 && ends.front() != '0' && ends.front() != '5' &&
         ends.find_first_not_of(ends.front()) == std::string::npos;
}

/// Returns true if a column's words are as close as the letters of a title that runs upwards. Between numbers
/// there is more room.
bool isWriting(const AxisLabels& column) {
  constexpr double closest = 0.45;  // share of the lower one's height
  int close = 0;
  for (std::size_t i = 1; i < column.words.size(); ++i) {
    const Box &upper = column.words[i - 1].box, &lower = column.words[i].box;
    close += lower.y0 - upper.y1 < closest * std::min(upper.height(), lower.height());
  }
  return 2 * close >= static_cast<int>(column.words.size()) - 1;
}

}  // namespace

int AxisLabels::numbers() const {
  return static_cast<int>(
      std::count_if(readings.begin(), readings.end(), [](const auto& r) { return !r.empty(); }));
}

std::pair<std::string, std::string> numberAndSuffix(const std::string& label) {
  const std::string text = withoutGroupSigns(label);
  const auto end = text.find_first_not_of("0123456789.,- ");
  if (end == std::string::npos || end == 0) return {text, ""};
  return {text.substr(0, end), text.substr(end)};
}

std::vector<Box> withLettersBehind(const std::vector<Box>& glyphs, const AxisLabels& labels) {
  std::vector<Box> fromLeft = glyphs, numbers, wholes;
  std::sort(fromLeft.begin(), fromLeft.end(), [](const Box& a, const Box& b) { return a.x0 < b.x0; });
  for (std::size_t i = 0; i < labels.words.size(); ++i)
    if (!labels.readings[i].empty()) numbers.push_back(labels.words[i].box);
  for (std::size_t i = 0; i < labels.words.size(); ++i) {
    const Box& word = labels.words[i].box;
    wholes.push_back(labels.readings[i].empty() ? word : withLettersBehind(fromLeft, word, numbers));
  }
  return wholes;
}

namespace {

/// The row of numbers above the frame, for a displacement axis at the top.
std::optional<AxisLabels> readTopLabels(GraphReading& r, const std::vector<GridLine>& lines) {
  constexpr int fewestRegular = 3;
  const Box &b = r.box,
            band{b.x0 - 0.12 * b.width(), b.y0 - 0.3 * b.height(), b.x1 + 0.12 * b.width(), b.y0 - 1};
  std::vector<double> ticks;
  for (const auto& line : lines) ticks.push_back(line.position_px);
  for (const auto& words : {ownLabelWords(r, band, 0), inkedLabelWords(r, band, Axis::x)}) {
    const LabelRow row = labelsAbove(words, b, ticks);
    if (row.regular >= fewestRegular) return fitRow(r, row, lines, Axis::x, TextKind::number, 0);
  }
  return {};
}

/// Words right of the frame that may be numbers.
std::vector<Box> rightLabelWords(const std::vector<Box>& glyphs) {
  std::vector<Box> sided;
  for (const Box& glyph : glyphs) sided.push_back(leftForRight(glyph));
  std::vector<Box> words = numberBoxes(glyphs);
  for (Box& word : words) word = leftForRight(withoutTitleLetter(leftForRight(word), sided));
  return words;
}

/// Removes the small flat marks of one size in front of every number of a column: ends of ticks, shorter than
/// a minus sign.
std::vector<Box> withoutTicksBefore(std::vector<Box> glyphs, const LabelRow& column) {
  constexpr std::size_t fewest = 3;
  constexpr double same_px = 1.5, low = 0.3, shorter = 0.4;  // px; shares of a number's height
  std::vector<Box> firsts;
  for (const Box& word : column.words) {
    const auto first =
        std::ranges::find_if(glyphs, [&](const Box& g) { return g.x0 == word.x0 && word.contains(g); });
    if (first != glyphs.end()) firsts.push_back(*first);
  }
  const auto isTick = [&](const Box& g) {
    return g.height() <= low * column.height_px && g.width() <= shorter * column.height_px &&
           std::abs(g.x0 - firsts.front().x0) < same_px &&
           std::abs(g.width() - firsts.front().width()) < same_px;
  };
  if (firsts.size() >= fewest && std::ranges::all_of(firsts, isTick)) std::erase_if(glyphs, isTick);
  return glyphs;
}

}  // namespace

std::optional<AxisLabels> readRightLabels(GraphReading& r, const std::vector<GridLine>& lines) {
  constexpr int fewestRegular = 4;  // fewer may belong to a legend
  const Box& b = r.box;
  constexpr double besideEdge_px = 3;
  const Box band{b.x1 + besideEdge_px, b.y0 - 0.1 * b.height(), b.x1 + 0.25 * b.width(),
                 b.y1 + 0.08 * b.height()};
  // A tick begins at the frame's edge, a label with a minus sign does not. Without this distance "-0.8" would
  // be read from a tick.
  const double besideTicks_px = besideEdge_px + 0.004 * b.width();
  std::vector<Box> glyphs = labelGlyphs(r, band);
  std::erase_if(glyphs,
                [&](const Box& g) { return g.x0 < b.x1 + besideTicks_px && g.width() >= 1.5 * g.height(); });
  std::vector<double> ticks;
  for (const auto& line : r.frame.yLines) ticks.push_back(line.position_px);
  LabelRow row = labelsRight(rightLabelWords(glyphs), b, ticks);
  row = labelsRight(rightLabelWords(withoutTicksBefore(std::move(glyphs), row)), b, ticks);
  if (row.regular < fewestRegular) return {};
  return fitRow(r, row, lines, Axis::y, TextKind::number, 0);
}

bool reachesFar(const AxisLabels& labels, const Box& frame) {
  constexpr double leastReach = 0.4;  // share of the frame's height
  return labels.numbers() >= 3 && labels.extent.height() >= leastReach * frame.height();
}

std::optional<AxisLabels> readAxisLabels(GraphReading& r, Axis axis) {
  const Box& b = r.box;
  const double w = b.width(), h = b.height();
  const bool x = axis == Axis::x;
  const Box band = x ? Box{b.x0 - 0.12 * w, b.y1 + 1, b.x1 + 0.12 * w, b.y1 + 0.3 * h}
                     : Box{b.x0 - 0.36 * w, b.y0 - 0.1 * h, b.x0 - 1, b.y1 + 0.08 * h};
  auto lines = x ? r.frame.xLines : r.frame.yLines;
  for (auto& line : lines) line.position_px -= x ? r.frame.drawnOffset_px.x : r.frame.drawnOffset_px.y;
  // Tries the document's own text and the pixels, because a plot with drawn labels may have other numbers of
  // the text beside it.
  std::optional<AxisLabels> best;
  if (const auto own = ownLabelWords(r, band, 0); own.size() >= 2) {
    best = tryRows(r, axis, own, lines, TextKind::number);
    if (best && agreed(*best) >= 3) return best;
  }
  const auto words = inkedLabelWords(r, band, axis);
  auto inked = tryRows(r, axis, words, lines, TextKind::number);
  if (inked && holdsLetters(*inked)) {
    auto lettered = tryRows(r, axis, words, lines, TextKind::words);
    if (lettered && agreed(*lettered) >= agreed(*inked) && !lettered->suffix.empty() &&
        !holdsLetters(*lettered))
      return lettered;
    if (endsAlike(*inked)) inked->progression.reset();
  }
  if (inked && (!best || agreed(*inked) > agreed(*best))) best = std::move(inked);
  if (best && agreed(*best) >= 3) return best;
  if (!x) {  // digits of numbers that read upwards resemble a scale with step 2
    auto upwards = readUpwardLabels(r, band, lines);
    if (upwards && agreed(*upwards) >= 3) return upwards;
    // No numbers were found on the left, so the right side is tried.
    if (!best || best->numbers() < 2 || isWriting(*best))
      if (auto right = readRightLabels(r, lines); right && agreed(*right) >= 3 && reachesFar(*right, b))
        return right;
  }
  if (x && (!best || best->numbers() < 2))
    if (auto top = readTopLabels(r, lines); top && agreed(*top) >= 3) return top;
  if (best && agreed(*best) >= 2) return best;
  // "20gf" read as digits alone is meaningless, so the labels are read once more with letters.
  auto lettered = tryRows(r, axis, words, lines, TextKind::words);
  return lettered && (!best || agreed(*lettered) > agreed(*best)) ? lettered : best;
}

}  // namespace detent::importer
