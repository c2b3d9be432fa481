// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/callouts/callouts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "importer/lexicon/stroke_words.h"
#include "importer/page/polyline.h"

namespace detent::importer {
namespace {

/// A callout's text and the box around all of its words.
struct Phrase {
  CalloutKind kind;
  Box box;
  std::string text;
};

/// Returns true if a text has a word for a place on a curve: "point", "Position".
bool namesAPlace(const std::string& text) {
  return holdsSign(text, WordKind::point) ||
         std::ranges::any_of(wordsOf(text), [](const std::string& word) { return isPointWord(word); });
}

/// The contact point that a text names; empty if it names none or both.
std::optional<CalloutKind> kindOf(const std::string& text) {
  bool closes = false, opens = false;
  const auto take = [&](const LexiconEntry& entry) {
    if (entry.value.ends_with(" at point") && !namesAPlace(text)) return;
    (entry.value.starts_with("closes") ? closes : opens) = true;
  };
  for (const std::string& word : wordsOf(text)) {
    // Misread letters do no harm: the leader to the curve is the other half of the proof.
    const auto match = matchWord(word, {WordKind::contact}, TextSource::recognised);
    if (match) take(*match->entry);
  }
  for (const LexiconEntry& entry : entriesOf(WordKind::contact))
    if (entry.form == WordForm::sign && text.find(entry.word) != std::string::npos) take(entry);
  if (closes == opens) return {};
  return closes ? CalloutKind::operatingPoint : CalloutKind::resetPoint;
}

/// A text and the words of its line that are a space apart, because the leader may start at any of them.
SeenText lineAround(const SeenText& word, const std::vector<SeenText>& texts) {
  Box line = word.box;
  for (bool grown = true; grown;) {
    grown = false;
    for (const SeenText& other : texts) {
      const double height = line.height();
      const bool sameLine = std::abs((other.box.y0 + other.box.y1) - (line.y0 + line.y1)) < height;
      const bool near = other.box.x0 < line.x1 + 0.8 * height && other.box.x1 > line.x0 - 0.8 * height;
      const Box whole = line.joined(other.box);
      if (sameLine && near && whole.width() > line.width() + 0.5) line = whole, grown = true;
    }
  }
  SeenText joined{.utf8 = {}, .box = line};
  for (const SeenText& each : texts)
    if (line.contains(each.box.middle())) joined.utf8 += (joined.utf8.empty() ? "" : " ") + each.utf8;
  return joined;
}

std::vector<Phrase> phrasesInside(const AxesFound& axes, const Box& frame) {
  std::vector<Phrase> phrases;
  for (const SeenText& text : axes.texts) {
    if (!frame.contains(text.box.middle())) continue;
    const SeenText line = lineAround(text, axes.texts);
    const auto kind = kindOf(line.utf8);
    if (kind && std::ranges::find(phrases, line.box, &Phrase::box) == phrases.end())
      phrases.push_back({*kind, line.box, line.utf8});
  }
  return phrases;
}

/// Distance of each pixel from the plot's most frequent colour: mark or paper.
class MarkTest {
 public:
  /// The strokes and the lines of the plot's frame are known: they would be there without a leader too.
  MarkTest(const Raster& raster, const PlotFrame& frame, const StrokePair& strokes)
      : raster_(raster),
        paper_(mostFrequent(raster, frame.box())),
        known_(static_cast<std::size_t>(raster.width_px) * static_cast<std::size_t>(raster.height_px), 0) {
    const Box box = frame.box();
    // A straight stretch of a document has only two points.
    for (const Point& p : densified(strokes.press.points_px, 1)) setKnown({p.x, p.y, p.x, p.y});
    if (strokes.release)
      for (const Point& p : densified(strokes.release->points_px, 1)) setKnown({p.x, p.y, p.x, p.y});
    for (const GridLine& line : frame.xLines)
      if (line.spansFrame) setKnown({line.position_px, box.y0, line.position_px, box.y1});
    for (const GridLine& line : frame.yLines)
      if (line.spansFrame) setKnown({box.x0, line.position_px, box.x1, line.position_px});
  }

  bool isKnown(Point p) const {
    const int x = static_cast<int>(std::lround(p.x)), y = static_cast<int>(std::lround(p.y));
    return x >= 0 && y >= 0 && x < raster_.width_px && y < raster_.height_px && known_[indexOf(x, y)] != 0;
  }

  /// Returns true if a marked pixel lies within one pixel of the point.
  bool near(Point p) const {
    const int x = static_cast<int>(std::lround(p.x)), y = static_cast<int>(std::lround(p.y));
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if (at(x + dx, y + dy)) return true;
      }
    }
    return false;
  }
  bool at(int x, int y) const {
    if (x < 0 || y < 0 || x >= raster_.width_px || y >= raster_.height_px) return false;
    const std::uint8_t* rgb = raster_.at(x, y);
    constexpr int markDistance = 70;  // of 255: half-covered thin lines count, paper noise does not
    return std::max({std::abs(rgb[0] - paper_.r), std::abs(rgb[1] - paper_.g), std::abs(rgb[2] - paper_.b)}) >
           markDistance;
  }

 private:
  static Rgb mostFrequent(const Raster& raster, const Box& frame) {
    std::vector<int> counts(4096, 0);  // 4 bits per channel
    const int x1 = std::min(raster.width_px, static_cast<int>(frame.x1)),
              y1 = std::min(raster.height_px, static_cast<int>(frame.y1));
    for (int y = std::max(0, static_cast<int>(frame.y0)); y < y1; y += 2) {
      for (int x = std::max(0, static_cast<int>(frame.x0)); x < x1; x += 2) {
        const std::uint8_t* rgb = raster.at(x, y);
        ++counts[static_cast<std::size_t>((rgb[0] >> 4) << 8 | (rgb[1] >> 4) << 4 | rgb[2] >> 4)];
      }
    }
    const auto best = static_cast<unsigned>(std::max_element(counts.begin(), counts.end()) - counts.begin());
    const auto channel = [](unsigned four) { return static_cast<std::uint8_t>(four * 17); };
    return {channel(best >> 8), channel(best >> 4 & 15), channel(best & 15)};
  }

  std::size_t indexOf(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(raster_.width_px) +
           static_cast<std::size_t>(x);
  }

  void setKnown(Box box) {
    constexpr double halfLine_px = 3;  // of the thickest usual lines
    box = box.grown(halfLine_px, halfLine_px);
    for (int y = std::max(0, static_cast<int>(box.y0)); y <= std::min(raster_.height_px - 1.0, box.y1); ++y)
      for (int x = std::max(0, static_cast<int>(box.x0)); x <= std::min(raster_.width_px - 1.0, box.x1); ++x)
        known_[indexOf(x, y)] = 1;
  }

  const Raster& raster_;
  Rgb paper_;
  std::vector<char> known_;
};

constexpr double leastShare = 0.8;  // share of a leader that must be a thin stroke

/// Share of the straight line between two points that is a thin stroke: marked pixels on it and none beside
/// it. 0..1. Pixels of strokes and of the plot's lines show nothing; most of a leader has to lie off them.
/// Returns 0 as soon as `leastShare` cannot be reached any more, because nearly all lines from a word to a
/// curve cross blank paper.
double leaderShare(const MarkTest& marks, Point from, Point to) {
  const double length = distance(from, to);
  const Point along{(to.x - from.x) / length, (to.y - from.y) / length};
  constexpr double arrowhead_px = 8, side_px = 4.5;
  constexpr double mostGaps = 0.1, mostKnown = 0.5;  // shares of the samples
  const double start =
      std::min(arrowhead_px, length / 3);  // dots and arrowheads stand where the leader meets the curve
  const int samples = static_cast<int>(std::floor(length - 1 - start)) + 1;
  int gaps = 0, thick = 0, known = 0;
  for (int k = 0; k < samples; ++k) {
    const double s = start + k;
    const Point p{from.x + s * along.x, from.y + s * along.y};
    const Point left{p.x - side_px * along.y, p.y + side_px * along.x};
    const Point right{p.x + side_px * along.y, p.y - side_px * along.x};
    const auto hit = [&](Point q) {
      return marks.at(static_cast<int>(std::lround(q.x)), static_cast<int>(std::lround(q.y)));
    };
    if (marks.isKnown(p)) {
      ++known;
    } else if (!marks.near(p)) {
      ++gaps;
    } else if (hit(left) && hit(right)) {
      ++thick;
    }
    if (gaps > mostGaps * samples || gaps + thick > (1 - leastShare) * samples || known > mostKnown * samples)
      return 0;
  }
  const int shown = samples - known;
  return shown > 0 ? double(shown - gaps - thick) / shown : 0;
}

constexpr double kAnchorGap = 0.25;  // heights of the text, between it and its leader

/// Points around a text from which a leader may start.
std::vector<Point> anchorsAround(const Box& box) {
  const double gap = kAnchorGap * box.height();
  const Box b = box.grown(gap, gap);
  std::vector<Point> anchors;
  const double step = std::max(2.0, 0.2 * box.height());
  for (double x = b.x0; x <= b.x1; x += step) anchors.push_back({x, b.y0}), anchors.push_back({x, b.y1});
  for (double y = b.y0; y <= b.y1; y += step) anchors.push_back({b.x0, y}), anchors.push_back({b.x1, y});
  return anchors;
}

/// Returns true for a line that goes on beside the text, from a point next to it: another text's leader.
bool passesBy(const MarkTest& marks, Point target, Point anchor, const Box& text) {
  const double length = distance(target, anchor), twice_px = 2 * kAnchorGap * text.height();
  double marked = 0, beyond = 0;
  for (double s = 1; s < twice_px; s += 1, beyond += 1) {
    const Point p = anchor + (s / length) * (anchor - target);
    if (text.contains(p)) return false;
    marked += marks.near(p) ? 1 : 0;
  }
  return marked > leastShare * beyond;
}

/// Returns true for lines along an axis: gridlines and ticks are no leaders.
bool axisParallel(Point a, Point b) {
  const double dx = std::abs(a.x - b.x), dy = std::abs(a.y - b.y);
  return std::min(dx, dy) < 0.06 * std::max(dx, dy);
}

/// Returns true where the force rises upright: at the bottom-out no contact changes any more, and a word may
/// touch it.
bool isUpright(const StrokePoints& stroke, std::size_t i) {
  constexpr std::size_t beside = 4;  // points
  constexpr double steep = 5;        // pixels up for one across
  const std::size_t last = stroke.points_px.size() - 1;
  const Point a = stroke.points_px[i - std::min(i, beside)], b = stroke.points_px[std::min(last, i + beside)];
  return (b.x - a.x) * (b.y - a.y) <= 0 && std::abs(b.y - a.y) > steep * std::abs(b.x - a.x);
}

std::optional<Callout> follow(const Phrase& phrase, const MarkTest& marks, const StrokePoints& stroke) {
  const std::vector<Point> anchors = anchorsAround(phrase.box);
  const double height = phrase.box.height();
  std::optional<Callout> best;
  double bestScore = 0;
  for (std::size_t i = 0; i < stroke.points_px.size(); i += 2) {
    const Point target = stroke.points_px[i];
    if (isUpright(stroke, i)) continue;
    for (const Point& anchor : anchors) {
      const double length = distance(anchor, target);
      if (length < 0.8 * height || length > 14 * height || axisParallel(anchor, target)) continue;
      const double share = leaderShare(marks, target, anchor);
      // of equal shares the longest line wins: the whole leader, not its end
      const double score = share + 0.002 * length / height;
      if (share < leastShare || score <= bestScore || passesBy(marks, target, anchor, phrase.box)) continue;
      bestScore = score;
      best = Callout{phrase.kind, stroke.points[i], target, share, phrase.text};
    }
  }
  return best;
}

}  // namespace

std::vector<Callout> readCallouts(const PageView& view, const PlotFrame& frame, const AxesFound& axes,
                                  const StrokePair& strokes) {
  const std::vector<Phrase> phrases = phrasesInside(axes, frame.box());
  if (phrases.empty()) return {};
  const MarkTest marks(view.raster, frame, strokes);
  std::vector<Callout> callouts;
  for (const CalloutKind kind : {CalloutKind::operatingPoint, CalloutKind::resetPoint}) {
    std::optional<Callout> surest;
    for (const Phrase& phrase : phrases) {
      if (phrase.kind != kind) continue;
      if (kind == CalloutKind::resetPoint && !strokes.release) continue;
      const auto found =
          follow(phrase, marks, kind == CalloutKind::resetPoint ? *strokes.release : strokes.press);
      if (found && (!surest || found->confidence > surest->confidence)) surest = found;
    }
    if (surest) callouts.push_back(*surest);
  }
  return callouts;
}

std::vector<CalloutKind> printedCallouts(const PlotFrame& frame, const AxesFound& axes) {
  std::vector<CalloutKind> kinds;
  for (const Phrase& phrase : phrasesInside(axes, frame.box())) {
    if (namesAPlace(phrase.text) && std::ranges::find(kinds, phrase.kind) == kinds.end())
      kinds.push_back(phrase.kind);
  }
  return kinds;
}

}  // namespace detent::importer
