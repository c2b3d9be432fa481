// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/legend_words.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>

#include "importer/lexicon/stroke_words.h"
#include "importer/page/mirrored.h"

namespace detent::importer::trace {
namespace {

/// Coverage of each trace's colour in a box of the view.
struct ColourSeen {
  double inside_px = 0;               ///< full pixels within the middle band
  double outside_px = 0;              ///< above and below it
  bool runsOut = false;               ///< touches the far end of the box
  bool runsOver = false;              ///< touches its upper or lower edge
  int bulgeLeft = 0, bulgeRight = 0;  ///< columns where it lies above and below the band; 0 and 0 without any
  int pixels = 0, left = 0, right = 0, top = 0,
      bottom = 0;  ///< number of pixels and their extent; tints count fully

  void add(int x, int y) {
    left = pixels > 0 ? std::min(left, x) : x, right = pixels > 0 ? std::max(right, x) : x;
    top = pixels > 0 ? std::min(top, y) : y, bottom = pixels > 0 ? std::max(bottom, y) : y;
    ++pixels;
  }
  void addOutside(int x, double full) {
    bulgeLeft = outside_px > 0 ? std::min(bulgeLeft, x) : x,
    bulgeRight = outside_px > 0 ? std::max(bulgeRight, x) : x;
    outside_px += full;
  }
  /// Returns true for a line with a curve's marker in its middle.
  bool isMarkedLine() const {
    constexpr double end = 0.2;  // share of the line's length, on both sides of its marker
    const int length = right - left + 1;
    return !runsOver && bulgeLeft - left > end * length && right - bulgeRight > end * length;
  }
  /// Returns true for a square, bar or disc, filled or outlined around another tint.
  bool isSwatch() const {
    constexpr double filled = 0.75, outlined = 0.8;  // share of the bounding box; share of its outline
    const int width = right - left + 1, height = bottom - top + 1;
    return !runsOver && (pixels >= filled * width * height || pixels >= outlined * 2 * (width + height));
  }
};

// A strip beside a word, in letter heights.
constexpr double kGap = 0.15, kLength = 6, kBand = 0.4, kAround = 0.9, kHighest = 1.25;

/// Distance from a word, in its heights, at which the first thing beside it ends: a legend key is closer than
/// the legend's box.
double lengthOfFirstBeside(const Box& word, int direction, const Raster& raster, Color3 paper) {
  constexpr double kApart = 0.4, beyond_px = 2.5;  // between a key and other marks; distance looked beyond it
  const double height = word.height(), middle = word.middle().y;
  const double near = direction < 0 ? word.x0 - kGap * height : word.x1 + kGap * height;
  const auto isInked = [&](int x) {
    for (int y = static_cast<int>(middle - kBand * height); y <= static_cast<int>(middle + kBand * height);
         ++y)
      if (x >= 0 && y >= 0 && x < raster.width_px && y < raster.height_px &&
          norm(colorAt(raster, x, y) - paper) >= 24)
        return true;
    return false;
  };
  double first = -1, last = 0;
  // The minus of "-20" belongs to the text.
  const auto isASign = [&] { return first < kApart * height && last - first < 0.6 * height; };
  for (int by = 0; by < kLength * height; ++by)
    if (isInked(static_cast<int>(near) + direction * by)) {
      if (first < 0 || by - last > kApart * height) first = by;
      last = by;
    } else if (last > 0 && by - last > kApart * height && !isASign()) {
      return (last + beyond_px) / height;
    }
  return kLength;
}

/// Examines a strip beside a word as long as a legend key may be; `direction` -1: left of it, +1: right.
std::vector<ColourSeen> examineBeside(const Box& word, int direction,
                                      const std::vector<PaletteColour>& colours, const Raster& raster,
                                      Color3 paper, double heights) {
  const double height = word.height(), middle = word.middle().y;
  const double near = direction < 0 ? word.x0 - kGap * height : word.x1 + kGap * height;
  const double far = near + direction * heights * height;
  const int x0 = std::max(0, static_cast<int>(std::min(near, far)));
  const int x1 = std::min(raster.width_px - 1, static_cast<int>(std::max(near, far)));
  const int y0 = std::max(0, static_cast<int>(middle - kHighest * height));
  const int y1 = std::min(raster.height_px - 1, static_cast<int>(middle + kHighest * height));
  std::vector<ColourSeen> seen(colours.size());
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x) {
      const Color3 difference = colorAt(raster, x, y) - paper;
      const float length = norm(difference);
      if (length < 24) continue;
      for (std::size_t k = 0; k < colours.size(); ++k) {
        if (dot(difference, colours[k].direction) <= static_cast<float>(kSameColourAngle) * length) continue;
        const double full = static_cast<double>(length / colours[k].strength);
        const double off = std::abs(y - middle);
        if (off <= kBand * height)
          seen[k].inside_px += full;
        else if (off <= kAround * height)
          seen[k].addOutside(x, full);
        if (std::abs(x - far) < 1.5 && off <= kAround * height) seen[k].runsOut = true;
        if (y == y0 || y == y1) seen[k].runsOver = true;
        seen[k].add(x, y);
      }
    }
  return seen;
}

/// Search distance for a key beside a word, in its heights; direction as in examineBeside.
using StripLength = std::function<double(const Box& word, int direction)>;

/// The trace whose key stands beside a word: horizontal, ended, of one colour only.
std::optional<std::size_t> sampledTrace(const Box& word, const std::vector<PaletteColour>& colours,
                                        const PageView& view, Color3 paper, const StripLength& lengthOf) {
  const int before = mirroredBy(view.viewToPage).across ? 1 : -1;  // keys normally stand before their names
  for (int direction : {before, -before}) {
    const std::vector<ColourSeen> seen =
        examineBeside(word, direction, colours, view.raster, paper, lengthOf(word, direction));
    std::optional<std::size_t> found;
    bool several = false;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      if (seen[k].runsOut || seen[k].inside_px < 0.8 * word.height()) continue;
      // Behind a name stands the next name's square.
      const bool swatch = direction == before && seen[k].isSwatch();
      if (seen[k].outside_px > 0.3 * seen[k].inside_px && !swatch && !seen[k].isMarkedLine()) continue;
      several = several || found.has_value();
      found = k;
    }
    if (found && !several) return found;
  }
  return {};
}

using LegendTexts = std::vector<std::vector<SeenText>>;  // per trace

/// Returns the texts beside a colour. Of several, only those in line with another colour's text, if any: an
/// edge of a letter elsewhere on the page may have the colour by chance.
std::vector<SeenText> inLegend(const LegendTexts& all, std::size_t of) {
  if (all[of].size() < 2) return all[of];
  std::vector<SeenText> inLine;
  for (const SeenText& text : all[of])
    for (std::size_t k = 0; k < all.size(); ++k)
      if (k != of && std::any_of(all[k].begin(), all[k].end(),
                                 [&](const SeenText& t) { return t.box.inLineWith(text.box); })) {
        inLine.push_back(text);
        break;
      }
  return inLine.empty() ? all[of] : inLine;
}

bool isTickLabel(const SeenText& text, const AxesFound& axes) {
  const AxisCalibration& cal = axes.calibration.value;
  const auto isIn = [&](const AxisReading& axis) {
    return std::ranges::find(axis.ticks, text.box, &TickLabel::box) != axis.ticks.end();
  };
  return isIn(cal.x) || isIn(cal.y);
}

/// The texts beside each trace's legend key.
LegendTexts textsBeside(const std::vector<SeenText>& texts, const std::vector<PaletteColour>& colours,
                        const PageView& view, Color3 paper, const StripLength& lengthOf) {
  LegendTexts beside(colours.size());
  for (const SeenText& text : texts) {
    if (std::abs(text.angle_deg) > 20 || text.box.empty()) continue;
    if (const auto trace = sampledTrace(text.box, colours, view, paper, lengthOf))
      beside[*trace].push_back(text);
  }
  return beside;
}

/// Adds texts in line with one that has a key, if something behind their key (a box) hid it.
void addInLine(LegendTexts& beside, const std::vector<SeenText>& texts,
               const std::vector<PaletteColour>& colours, const PageView& view, Color3 paper,
               const StripLength& lengthOf) {
  const LegendTexts seen = beside;
  const auto isAny = [&](const auto& holds) {
    return std::ranges::any_of(seen,
                               [&](const auto& ownTexts) { return std::ranges::any_of(ownTexts, holds); });
  };
  for (const SeenText& text : texts) {
    if (text.utf8.empty() || text.box.empty()) continue;
    if (isAny([&](const SeenText& other) { return other.box == text.box; })) continue;
    if (!isAny([&](const SeenText& other) { return other.box.inLineWith(text.box); })) continue;
    if (const auto trace = sampledTrace(text.box, colours, view, paper, lengthOf))
      beside[*trace].push_back(text);
  }
}

/// Gives unnamed traces the legend's short name, or the place of one that was not read, if all such traces
/// have one. If one was not read, the others count if all stand in line, unlike callouts.
void labelByOtherLines(std::vector<CurveTrace>& traces, const LegendTexts& beside) {
  const auto isNameless = [](const CurveTrace& trace) { return trace.label.empty(); };
  if (traces.size() < 2) return;
  std::vector<SeenText> names(traces.size());
  for (std::size_t i = 0; i < traces.size(); ++i) {
    if (!isNameless(traces[i])) continue;
    const std::vector<SeenText> ownTexts = inLegend(beside, i);
    if (ownTexts.size() != 1) return;
    names[i] = ownTexts.front();
  }
  std::vector<Box> positions;
  for (const SeenText& name : names)
    if (!name.box.empty()) positions.push_back(name.box);
  const bool allRead = std::ranges::none_of(names, [&](const SeenText& name) {
    return isNameless(traces[static_cast<std::size_t>(&name - names.data())]) && name.utf8.empty();
  });
  const bool inLine =
      positions.size() > 2 && std::ranges::all_of(positions, [&](const Box& place) {
        return place.inLineWith(&place == &positions.front() ? positions.back() : positions.front());
      });
  for (std::size_t i = 0; i < traces.size(); ++i) {
    if (!isNameless(traces[i])) continue;
    traces[i].labelBox_px = names[i].box;
    if (allRead || inLine) traces[i].label = names[i].utf8;
  }
}

/// The trace in whose colour alone a text is written.
std::optional<std::size_t> traceOfLetters(const Box& word, const std::vector<PaletteColour>& colours,
                                          const Raster& raster, Color3 paper) {
  // share of a text's pixels; share of the colour's strength, at its darkest
  constexpr double nearlyAll = 0.8, full = 0.5;
  std::vector<double> ownSizes(colours.size(), 0);
  std::vector<float> darkest(colours.size(), 0);
  double all = 0;
  for (int y = std::max(0, static_cast<int>(word.y0));
       y <= std::min<int>(raster.height_px - 1, static_cast<int>(word.y1)); ++y)
    for (int x = std::max(0, static_cast<int>(word.x0));
         x <= std::min<int>(raster.width_px - 1, static_cast<int>(word.x1)); ++x) {
      const Color3 difference = colorAt(raster, x, y) - paper;
      const float length = norm(difference);
      if (length < 24) continue;
      all += static_cast<double>(length);
      for (std::size_t k = 0; k < colours.size(); ++k)
        if (dot(difference, colours[k].direction) > static_cast<float>(kSameColourAngle) * length)
          ownSizes[k] += static_cast<double>(length), darkest[k] = std::max(darkest[k], length);
    }
  std::optional<std::size_t> found;
  for (std::size_t k = 0; k < colours.size(); ++k) {
    if (ownSizes[k] < nearlyAll * all || darkest[k] < static_cast<float>(full) * colours[k].strength)
      continue;
    if (found) return {};
    found = k;
  }
  return found;
}

/// Horizontal words and short names that may name curves, without axis titles.
std::vector<SeenText> namesOn(const AxesFound& axes) {
  constexpr double level_deg = 20;
  const auto isLetter = [](unsigned char c) { return c >= 0x80 || std::isalpha(c) != 0; };
  const AxisCalibration& cal = axes.calibration.value;
  std::vector<SeenText> names;
  for (const auto* texts : {&axes.texts, &axes.otherLines})
    std::ranges::copy_if(*texts, std::back_inserter(names), [&](const SeenText& text) {
      return std::ranges::any_of(text.utf8, isLetter) && !text.box.empty() &&
             std::abs(text.angle_deg) < level_deg && text.utf8 != cal.x.title && text.utf8 != cal.y.title;
    });
  return names;
}

/// The single text of each trace; nullopt if one has none or several, or two share one.
std::optional<std::vector<SeenText>> oneEach(const LegendTexts& all) {
  std::vector<SeenText> each;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::vector<SeenText> ownTexts = inLegend(all, i);
    if (ownTexts.size() != 1) return {};
    if (std::ranges::find(each, ownTexts.front().box, &SeenText::box) != each.end()) return {};
    each.push_back(ownTexts.front());
  }
  return each;
}

/// Names in line like a legend's, each in its curve's colour.
std::optional<std::vector<SeenText>> lettersInColours(const std::vector<SeenText>& names,
                                                      const std::vector<std::optional<std::size_t>>& colourOf,
                                                      std::size_t traces) {
  LegendTexts all(traces);
  for (std::size_t n = 0; n < names.size(); ++n)
    if (colourOf[n]) all[*colourOf[n]].push_back(names[n]);
  auto each = oneEach(all);
  const auto isInLine = [&](const SeenText& text) {
    return std::ranges::any_of(
        *each, [&](const SeenText& other) { return &other != &text && other.box.inLineWith(text.box); });
  };
  // Each of three or more curves has one text in its colour alone; callouts of one switch would not.
  constexpr std::size_t several = 3;
  return each && (traces >= several || std::ranges::all_of(*each, isInLine)) ? each : std::nullopt;
}

/// Of two curves one has the word for the press in its colour and the other that for the release, wherever
/// these stand.
std::optional<std::vector<SeenText>> strokesInColours(const std::vector<SeenText>& names,
                                                      const std::vector<std::optional<std::size_t>>& colourOf,
                                                      std::size_t traces) {
  if (traces != 2) return {};
  LegendTexts all(traces);
  for (std::size_t n = 0; n < names.size(); ++n)
    if (colourOf[n] && strokeOfWord(folded(names[n].utf8))) all[*colourOf[n]].push_back(names[n]);
  auto each = oneEach(all);
  if (!each) return {};
  const auto strokeOf = [&](std::size_t i) { return strokeOfWord(folded((*each)[i].utf8)); };
  return strokeOf(0) != strokeOf(1) ? each : std::nullopt;
}

/// Names at the right ends of curves, in the curve's colour or in no curve's.
std::optional<std::vector<SeenText>> namesAtEnds(const std::vector<SeenText>& names,
                                                 const std::vector<std::optional<std::size_t>>& colourOf,
                                                 const std::vector<CurveTrace>& traces) {
  // In heights of the word: gap behind the curve's end, overlap with the end, distance above or below.
  constexpr double beside = 3, over = 0.5, level = 0.9;
  LegendTexts all(traces.size());
  for (std::size_t i = 0; i < traces.size(); ++i) {
    if (traces[i].points_px.empty()) return {};
    const Point end = *std::ranges::max_element(traces[i].points_px, {}, &Point::x);
    for (std::size_t n = 0; n < names.size(); ++n) {
      const Box& word = names[n].box;
      const double height = word.height();
      if (colourOf[n].value_or(i) == i && word.x0 > end.x - over * height &&
          word.x0 < end.x + beside * height && std::abs(word.middle().y - end.y) < level * height)
        all[i].push_back(names[n]);
    }
  }
  return oneEach(all);
}

/// Names traces without keys by letters in the curves' colours, or by names at the curves' ends; all of them
/// or none.
void labelWithoutSamples(std::vector<CurveTrace>& traces, const AxesFound& axes,
                         const std::vector<PaletteColour>& colours, const PageView& view, Color3 paper) {
  const auto hasNone = [](const CurveTrace& trace) {
    return trace.label.empty() && trace.labelBox_px.empty();
  };
  if (traces.size() < 2 || !std::ranges::all_of(traces, hasNone)) return;
  const std::vector<SeenText> names = namesOn(axes);
  std::vector<std::optional<std::size_t>> colourOf;
  for (const SeenText& name : names)
    colourOf.push_back(traceOfLetters(name.box, colours, view.raster, paper));
  auto each = lettersInColours(names, colourOf, traces.size());
  if (!each) each = strokesInColours(names, colourOf, traces.size());
  if (!each) each = namesAtEnds(names, colourOf, traces);
  for (std::size_t i = 0; each && i < traces.size(); ++i)
    traces[i].label = (*each)[i].utf8, traces[i].labelBox_px = (*each)[i].box;
}

/// Share of a key's columns with its colour, from the first to the last; 0 without a key beside the word.
double drawnShareBeside(const Box& word, const PaletteColour& colour, const Raster& raster, Color3 paper) {
  constexpr double least = 0.8;    // share of the word's height, in dark pixels
  constexpr float strong = 0.35F;  // of the colour
  double share = 0;
  for (const int direction : {-1, 1}) {
    const double height = word.height(), middle = word.middle().y;
    const double near = direction < 0 ? word.x0 - kGap * height : word.x1 + kGap * height;
    int columns = 0, last = 0, first = -1;
    for (int by = 0; by < kLength * height; ++by) {
      const int x = static_cast<int>(near) + direction * by;
      bool inked = false;
      for (int y = static_cast<int>(middle - kBand * height); y <= static_cast<int>(middle + kBand * height);
           ++y) {
        if (x < 0 || y < 0 || x >= raster.width_px || y >= raster.height_px) continue;
        const Color3 difference = colorAt(raster, x, y) - paper;
        const float length = norm(difference);
        inked = inked || (length > strong * colour.strength &&
                          dot(difference, colour.direction) > static_cast<float>(kSameColourAngle) * length);
      }
      if (!inked) continue;
      if (first < 0) first = by;
      ++columns, last = by;
    }
    if (columns >= least * height) share = std::max(share, columns / static_cast<double>(last - first + 1));
  }
  return share;
}

/// Share of a stroke's points away from the other one where its colour is present.
double drawnShareOf(const CurveTrace& trace, const CurveTrace& other, const PaletteColour& colour,
                    const Raster& raster, Color3 paper) {
  constexpr double apart_px = 3;
  constexpr float strong = 0.35F;  // of the colour
  int inked = 0, all = 0;
  for (const Point& p : trace.points_px) {
    if (std::ranges::any_of(other.points_px, [&](Point q) { return distance(p, q) < apart_px; })) continue;
    const int x = static_cast<int>(std::lround(p.x)), y = static_cast<int>(std::lround(p.y));
    if (x < 0 || y < 0 || x >= raster.width_px || y >= raster.height_px) continue;
    ++all;
    inked += dot(colorAt(raster, x, y) - paper, colour.direction) > strong * colour.strength ? 1 : 0;
  }
  return inked / static_cast<double>(std::max(1, all));
}

}  // namespace

void nameByDashes(CurveTrace& first, CurveTrace& second, const AxesFound& axes, const PageView& view,
                  const PlotScene& scene) {
  constexpr double through = 0.95, dashed = 0.88;  // shares that are drawn
  const Color3 paper = scene.paper();
  const PaletteColour colour = paletteColourOf(first.color, paper);
  std::vector<SeenText> names;
  for (const SeenText& text : axes.texts)
    if (!text.utf8.empty() && !text.box.empty() && first.label.find(text.utf8) != std::string::npos &&
        first.labelBox_px.joined(text.box) == first.labelBox_px)
      names.push_back(text);
  // Texts are assigned in reading order, not by position.
  const auto isBoth = [&](const SeenText& one, const SeenText& other) {
    return first.label == one.utf8 + std::string(kLabelParting) + other.utf8;
  };
  if (names.size() != 2 || !(isBoth(names[0], names[1]) || isBoth(names[1], names[0]))) return;
  const double a = drawnShareBeside(names[0].box, colour, view.raster, paper),
               b = drawnShareBeside(names[1].box, colour, view.raster, paper);
  if (std::max(a, b) < through || std::min(a, b) > dashed || std::min(a, b) <= 0) return;
  const double ofFirst = drawnShareOf(first, second, colour, view.raster, paper),
               ofSecond = drawnShareOf(second, first, colour, view.raster, paper);
  if (std::max(ofFirst, ofSecond) < through || std::min(ofFirst, ofSecond) > dashed) return;
  const bool inOrder = (a > b) == (ofFirst > ofSecond);
  first.label = names[inOrder ? 0 : 1].utf8, first.labelBox_px = names[inOrder ? 0 : 1].box;
  second.label = names[inOrder ? 1 : 0].utf8, second.labelBox_px = names[inOrder ? 1 : 0].box;
}

void labelTraces(std::vector<CurveTrace>& traces, const AxesFound& axes, const PageView& view,
                 const PlotScene& scene) {
  const Color3 paper = scene.paper();
  std::vector<PaletteColour> colours;
  for (const CurveTrace& trace : traces) colours.push_back(paletteColourOf(trace.color, paper));
  std::vector<SeenText> texts = axes.texts;
  std::erase_if(texts, [&](const SeenText& text) { return isTickLabel(text, axes); });
  LegendTexts beside = textsBeside(texts, colours, view, paper, [](const Box&, int) { return kLength; });
  for (std::vector<SeenText>& ownTexts : beside)
    std::erase_if(ownTexts, [](const SeenText& text) { return text.utf8.empty(); });
  const auto firstBeside = [&](const Box& word, int direction) {
    return lengthOfFirstBeside(word, direction, view.raster, paper);
  };
  addInLine(beside, texts, colours, view, paper, firstBeside);
  for (std::size_t i = 0; i < traces.size(); ++i) {
    CurveTrace& named = traces[i];
    for (const SeenText& text : inLegend(beside, i)) {
      named.labelBox_px = named.label.empty() ? text.box : named.labelBox_px.joined(text.box);
      named.label += std::string(named.label.empty() ? "" : kLabelParting) + text.utf8;
    }
  }
  // The colour of frame and labels may end beside a word in more than its key.
  std::vector<SeenText> lines = axes.otherLines;
  std::ranges::copy_if(axes.texts, std::back_inserter(lines), [&](const SeenText& text) {
    return std::ranges::any_of(traces, [&](const CurveTrace& trace) {
      return !trace.labelBox_px.empty() && text.box.inLineWith(trace.labelBox_px) &&
             trace.label.find(text.utf8) == std::string::npos;
    });
  });
  labelByOtherLines(traces, textsBeside(lines, colours, view, paper, firstBeside));
  labelWithoutSamples(traces, axes, colours, view, paper);
}

}  // namespace detent::importer::trace
