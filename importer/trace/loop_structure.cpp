// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/loop_structure.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "importer/page/quantile.h"
#include "importer/trace/scatter.h"

namespace detent::importer::trace {

namespace {

/// View of the plane along one direction, so that rows and columns share code: `along` runs on the line.
class Lanes {
 public:
  Lanes(const WorkPlane& plane, bool vertical) : grid_(&plane.coverage), vertical_(vertical) {
    const Box& f = plane.frame;
    const auto whole = [](double v, int limit) {
      return std::clamp(static_cast<int>(std::lround(v)), 0, limit - 1);
    };
    first_ = vertical ? whole(f.y0, grid_->height) : whole(f.x0, grid_->width);
    last_ = vertical ? whole(f.y1, grid_->height) : whole(f.x1, grid_->width);
    edge0_ = vertical ? whole(f.x0, grid_->width) : whole(f.y0, grid_->height);
    edge1_ = vertical ? whole(f.x1, grid_->width) : whole(f.y1, grid_->height);
  }
  int lanes() const { return vertical_ ? grid_->width : grid_->height; }
  int first() const { return first_; }
  int last() const { return last_; }
  int edge0() const { return edge0_; }
  int edge1() const { return edge1_; }
  bool vertical() const { return vertical_; }
  float at(int lane, int along) const {
    lane = std::clamp(lane, 0, lanes() - 1);
    return vertical_ ? grid_->at(lane, along) : grid_->at(along, lane);
  }

 private:
  const Plane* grid_;
  bool vertical_;
  int first_ = 0, last_ = 0, edge0_ = 0, edge1_ = 0;
};

constexpr int kBins = 16;

/// Mean coverage of a lane in each of kBins stretches.
std::vector<std::array<float, kBins>> binMeans(const Lanes& lanes) {
  std::vector<std::array<float, kBins>> means(static_cast<std::size_t>(lanes.lanes()));
  const int length = lanes.last() - lanes.first() + 1;
  for (int lane = 0; lane < lanes.lanes(); ++lane) {
    for (int b = 0; b < kBins; ++b) {
      const int from = lanes.first() + length * b / kBins, to = lanes.first() + length * (b + 1) / kBins;
      float sum = 0;
      for (int i = from; i < to; ++i) sum += lanes.at(lane, i);
      means[static_cast<std::size_t>(lane)][static_cast<std::size_t>(b)] =
          sum / static_cast<float>(std::max(1, to - from));
    }
  }
  return means;
}

/// Stretches in which a lane differs from both its neighbours.
struct Evidence {
  double share = 0;             ///< of the stretches
  bool fromEdgeToEdge = false;  ///< visible at both ends of the frame
};

Evidence evidenceFor(const std::vector<std::array<float, kBins>>& means, int lane, int distance) {
  constexpr float kStandsOut = 0.045F;  // coverage
  const auto n = static_cast<int>(means.size());
  const auto& here = means[static_cast<std::size_t>(lane)];
  std::array<bool, kBins> seen{};
  Evidence e;
  for (std::size_t b = 0; b < kBins; ++b) {
    float beside = 0;
    if (lane - distance >= 0) beside = std::max(beside, means[static_cast<std::size_t>(lane - distance)][b]);
    if (lane + distance < n) beside = std::max(beside, means[static_cast<std::size_t>(lane + distance)][b]);
    seen[b] = here[b] - beside > kStandsOut;
    if (seen[b]) e.share += 1.0 / kBins;
  }
  e.fromEdgeToEdge = (seen[0] || seen[1]) && (seen[kBins - 1] || seen[kBins - 2]);
  return e;
}

/// Positions that continue an even progression of known lanes.
std::vector<double> evenPositions(const std::vector<int>& lanes, int from, int to) {
  std::vector<double> gaps;
  for (std::size_t i = 1; i < lanes.size(); ++i) gaps.push_back(lanes[i] - lanes[i - 1]);
  if (gaps.size() < 2) return {};
  const double pitch = quantileOf(gaps, 0.25);
  if (pitch < 8) return {};
  std::vector<double> out;
  for (int lane : lanes) {
    for (double p : {lane - pitch, lane + pitch}) {
      if (p >= from && p <= to) out.push_back(p);
    }
  }
  return out;
}

StraightLine measureLine(const Lanes& lanes, int lane) {
  constexpr int kReach = 9;
  std::vector<float> middle;
  for (int i = lanes.first(); i <= lanes.last(); ++i) middle.push_back(lanes.at(lane, i));
  const float level = quantileOf(middle, 0.7);
  std::array<std::vector<float>, 2 * kReach + 1> across;
  for (int i = lanes.first(); i <= lanes.last(); ++i) {
    if (lanes.at(lane, i) < 0.6F * level) continue;
    for (int o = -kReach; o <= kReach; ++o) {
      const int other = lane + o;
      if (other >= 0 && other < lanes.lanes())
        across[static_cast<std::size_t>(o + kReach)].push_back(lanes.at(other, i));
    }
  }
  StraightLine line;
  line.vertical = lanes.vertical();
  line.position = lane;
  line.level = level;
  // The lower median, so that crossing or parallel marks do not become part of the line.
  std::array<float, 2 * kReach + 1> profile{};
  for (std::size_t k = 0; k < profile.size(); ++k) profile[k] = quantileOf(across[k], 0.4);
  const auto sideReach = [&](int step) {
    int o = 0;
    while (std::abs(o + step) <= kReach &&
           profile[static_cast<std::size_t>(o + step + kReach)] > 0.04F + 0.05F * level)
      o += step;
    return std::abs(o);
  };
  line.reach = std::max(sideReach(1), sideReach(-1));
  for (int o = -line.reach; o <= line.reach; ++o) {
    const bool inside = o >= -sideReach(-1) && o <= sideReach(1);
    line.profile.push_back(inside ? profile[static_cast<std::size_t>(o + kReach)] : 0.0F);
  }
  return line;
}

void findAlong(const WorkPlane& plane, bool vertical, const std::vector<double>& expected,
               std::vector<StraightLine>& out) {
  const Lanes lanes(plane, vertical);
  if (lanes.last() - lanes.first() < 2 * kBins) return;
  const auto means = binMeans(lanes);
  std::vector<Evidence> evidence(means.size());
  std::vector<double> total(means.size());
  for (int lane = 0; lane < lanes.lanes(); ++lane) {
    const auto k = static_cast<std::size_t>(lane);
    const Evidence near = evidenceFor(means, lane, 3), far = evidenceFor(means, lane, 5);
    evidence[k] = near.share > far.share ? near : far;
    evidence[k].fromEdgeToEdge = near.fromEdgeToEdge || far.fromEdgeToEdge;
    for (float m : means[k]) total[k] += std::min(m, 0.9F);
  }
  const auto isPeak = [&](int lane) {
    const auto k = static_cast<std::size_t>(lane);
    for (int o = -4; o <= 4; ++o) {
      const int other = lane + o;
      if (o == 0 || other < 0 || other >= lanes.lanes()) continue;
      const double t = total[static_cast<std::size_t>(other)];
      if (t > total[k] || (t == total[k] && o < 0)) return false;
    }
    return true;
  };
  std::vector<double> announced = expected;
  announced.push_back(lanes.edge0());
  announced.push_back(lanes.edge1());
  std::vector<int> found;
  // A steep stretch of a curve is straight too, but only at one end of the frame; a flat curve may span it.
  // So an unexpected line must be visible at both ends, and a row nearly all the way. The second pass uses
  // the pitch of the first.
  for (int pass = 0; pass < 2; ++pass) {
    std::vector<int> now;
    for (int lane = 0; lane < lanes.lanes(); ++lane) {
      const Evidence& e = evidence[static_cast<std::size_t>(lane)];
      const bool isAnnounced = isAtOneOf(announced, lane, 2);
      const bool plain = e.fromEdgeToEdge && e.share >= (vertical ? 0.45 : 0.7);
      if (plain || (isAnnounced && e.share >= 0.3)) {
        if (isPeak(lane)) now.push_back(lane);
      }
    }
    found = now;
    for (double p : evenPositions(found, lanes.edge0(), lanes.edge1())) announced.push_back(p);
  }
  for (int lane : found) out.push_back(measureLine(lanes, lane));
}

/// Share of each stretch in which the line is drawn.
std::array<float, kBins> dutiesOf(const Lanes& lanes, const StraightLine& line) {
  const int length = lanes.last() - lanes.first() + 1;
  std::array<float, kBins> duty{};
  for (int b = 0; b < kBins; ++b) {
    const int from = lanes.first() + length * b / kBins, to = lanes.first() + length * (b + 1) / kBins;
    int inked = 0;
    for (int i = from; i < to; ++i) inked += lanes.at(line.position, i) >= 0.45F * line.level ? 1 : 0;
    duty[static_cast<std::size_t>(b)] =
        static_cast<float>(inked) / static_cast<float>(std::max(1, to - from));
  }
  return duty;
}

/// Stretches in which the line may explain coverage. Where a dashed line seems solid, a curve runs along it.
/// Beside a gap for text a solid line is drawn over half a stretch, which does not make it dashed.
std::array<bool, kBins> explainableBins(const WorkPlane& plane, const StraightLine& line) {
  const std::array<float, kBins> duty = dutiesOf(Lanes(plane, line.vertical), line);
  std::vector<float> drawn, besideNoHole;
  for (std::size_t b = 0; b < kBins; ++b) {
    if (duty[b] <= 0) continue;
    drawn.push_back(duty[b]);
    const bool hole = (b > 0 && duty[b - 1] <= 0) || (b + 1 < kBins && duty[b + 1] <= 0);
    if (!hole) besideNoHole.push_back(duty[b]);
  }
  const float usual = quantileOf(besideNoHole.size() >= 4 ? besideNoHole : drawn, 0.35);
  std::array<bool, kBins> may{};
  for (std::size_t b = 0; b < kBins; ++b)
    may[b] = usual > 0.8F || duty[b] < std::max(1.5F * usual, usual + 0.25F);
  return may;
}

void explainLine(const WorkPlane& plane, const StraightLine& line, Plane& explained) {
  const Lanes lanes(plane, line.vertical);
  const std::array<bool, kBins> may = explainableBins(plane, line);
  const int length = line.vertical ? plane.coverage.height : plane.coverage.width;
  const int span = lanes.last() - lanes.first() + 1;
  for (int i = 0; i < length; ++i) {
    const int bin = std::clamp((i - lanes.first()) * kBins / span, 0, kBins - 1);
    if (!may[static_cast<std::size_t>(bin)] || lanes.at(line.position, i) < 0.45F * line.level) continue;
    for (int o = -line.reach; o <= line.reach; ++o) {
      const int lane = line.position + o;
      if (lane < 0 || lane >= lanes.lanes()) continue;
      float& e = line.vertical ? explained.at(lane, i) : explained.at(i, lane);
      e = std::max(e, line.at(o));
    }
  }
}

/// Allowed deviation of a straight line from its profile, because lines are not equally dark everywhere.
Plane doubtOf(const Plane& explained) {
  constexpr float kUneven = 0.2F;  // of an explained line's coverage
  Plane doubt(explained.width, explained.height);
  for (int y = 0; y < doubt.height; ++y) {
    for (int x = 0; x < doubt.width; ++x) {
      float most = 0;
      for (int v = std::max(0, y - 1); v <= std::min(doubt.height - 1, y + 1); ++v) {
        for (int u = std::max(0, x - 1); u <= std::min(doubt.width - 1, x + 1); ++u)
          most = std::max(most, explained.at(u, v));
      }
      doubt.at(x, y) = kUneven * most;
    }
  }
  return doubt;
}

struct Components {
  cv::Mat labels, stats;
  int count = 0;
};

Components componentsOf(Plane& coverage, float above) {
  Components c;
  const cv::Mat binary = matOf(coverage) > above;
  cv::Mat centroids;
  c.count = cv::connectedComponentsWithStats(binary, c.labels, c.stats, centroids, 8, CV_32S);
  return c;
}

/// Coverage on the ridge of the widest remaining line: the curves' own darkness.
float curveLevelOf(Plane& left, const WorkPlane& plane) {
  const Components c = componentsOf(left, 0.08F);
  int widest = 0, width = 0;
  for (int i = 1; i < c.count; ++i) {
    const int w = c.stats.at<int>(i, cv::CC_STAT_WIDTH);
    const int h = c.stats.at<int>(i, cv::CC_STAT_HEIGHT), area = c.stats.at<int>(i, cv::CC_STAT_AREA);
    const bool isPatch = area > 0.2 * w * h && std::min(w, h) > 12;  // uneven paper, no line
    if (w <= width || area < w || isPatch) continue;
    widest = i;
    width = w;
  }
  if (width < 0.15 * plane.frame.width()) widest = 0;
  std::vector<float> ridge;
  for (int y = 1; y + 1 < left.height; ++y) {
    for (int x = 1; x + 1 < left.width; ++x) {
      const int label = c.labels.at<int>(y, x);
      if (label == 0 || (widest > 0 && label != widest)) continue;
      const float v = left.at(x, y), above = left.at(x, y - 1), below = left.at(x, y + 1);
      const float before = left.at(x - 1, y), after = left.at(x + 1, y);
      const bool overRow = v >= above && v >= below && (v > above || v > below);
      const bool overColumn = v >= before && v >= after && (v > before || v > after);
      if (overRow || overColumn) ridge.push_back(v);
    }
  }
  return ridge.size() < 20 ? 1.0F : std::clamp(quantileOf(ridge, 0.5), 0.1F, 1.0F);
}

/// Line width: the median over pixels of the shorter run through them, summing coverage.
double strokeWidthOf(const Plane& coverage) {
  Plane across(coverage.width, coverage.height, 0), down(coverage.width, coverage.height, 0);
  constexpr float kCovered = 0.3F;  // coverage
  for (int y = 0; y < coverage.height; ++y) {
    for (int x = 0; x < coverage.width;) {
      int end = x;
      float sum = 0;
      while (end < coverage.width && coverage.at(end, y) > kCovered) sum += coverage.at(end++, y);
      for (int i = x; i < end; ++i) across.at(i, y) = sum;
      x = end + 1;
    }
  }
  for (int x = 0; x < coverage.width; ++x) {
    for (int y = 0; y < coverage.height;) {
      int end = y;
      float sum = 0;
      while (end < coverage.height && coverage.at(x, end) > kCovered) sum += coverage.at(x, end++);
      for (int i = y; i < end; ++i) down.at(x, i) = sum;
      y = end + 1;
    }
  }
  std::vector<float> widths;
  for (std::size_t i = 0; i < coverage.values.size(); ++i) {
    if (coverage.values[i] > 0.5F) widths.push_back(std::min(across.values[i], down.values[i]));
  }
  return widths.empty() ? 1.0 : std::max(1.0, double(quantileOf(widths, 0.5)));
}

struct Blob {
  int x = 0, y = 0, width = 0, height = 0;
};

/// Returns true for glyph size, unless flat like a dash or a piece of curve between two gridlines.
bool couldBeGlyph(const Blob& b, double strokeWidth, double tallest) {
  return b.height >= 2.2 * strokeWidth && b.height >= 5 && b.height <= tallest && b.width <= 3 * b.height;
}

/// Returns true if both stand side by side on one text line.
bool areNeighbours(const Blob& a, const Blob& b) {
  const int gap = std::max(a.x, b.x) - std::min(a.x + a.width, b.x + b.width);
  const int overlap = std::min(a.y + a.height, b.y + b.height) - std::max(a.y, b.y);
  const int smaller = std::min(a.height, b.height), taller = std::max(a.height, b.height);
  return gap <= 1.2 * taller && overlap >= 0.6 * smaller && taller <= 2.2 * smaller;
}

Blob turned(const Blob& b) { return {b.y, b.x, b.height, b.width}; }

/// Marks blobs in a row of at least four glyphs, upright or rotated by a quarter turn.
std::vector<char> glyphsInRows(const std::vector<Blob>& blobs, double strokeWidth, double tallest) {
  std::vector<char> isText(blobs.size(), 0);
  for (bool vertical : {false, true}) {
    std::vector<std::size_t> glyphs;
    const auto upright = [&](std::size_t i) { return vertical ? turned(blobs[i]) : blobs[i]; };
    for (std::size_t i = 0; i < blobs.size(); ++i) {
      if (couldBeGlyph(upright(i), strokeWidth, tallest)) glyphs.push_back(i);
    }
    std::vector<int> group(blobs.size(), -1);
    for (std::size_t seed : glyphs) {
      if (group[seed] >= 0) continue;
      std::vector<std::size_t> row{seed};
      group[seed] = static_cast<int>(seed);
      for (std::size_t k = 0; k < row.size(); ++k) {
        for (std::size_t other : glyphs) {
          if (group[other] >= 0 || !areNeighbours(upright(row[k]), upright(other))) continue;
          group[other] = static_cast<int>(seed);
          row.push_back(other);
        }
      }
      if (row.size() < 4) continue;
      for (std::size_t i : row) isText[i] = 1;
    }
  }
  return isText;
}

/// Words of touching glyphs: flat and wide blobs that a row of pixels enters many times.
std::vector<char> wordsRunTogether(const Components& c, const std::vector<Blob>& blobs, double strokeWidth,
                                   double tallest) {
  std::vector<char> isText(blobs.size(), 0);
  for (std::size_t i = 1; i < blobs.size(); ++i) {
    const Blob& b = blobs[i];
    if (b.height < 2.2 * strokeWidth || b.height < 5 || b.height > tallest || b.width < 2 * b.height)
      continue;
    int entries = 0;
    for (int y = b.y; y < b.y + b.height; ++y) {
      const int* row = c.labels.ptr<int>(y);
      for (int x = b.x; x < b.x + b.width; ++x) {
        const bool here = row[x] == static_cast<int>(i);
        const bool before = x > b.x && row[x - 1] == static_cast<int>(i);
        if (here && !before) ++entries;
      }
    }
    isText[i] = entries >= 3 * b.height ? 1 : 0;
  }
  return isText;
}

/// Blobs that straight lines of the plot cut on two sides are pieces of a curve, whatever their size.
std::vector<char> piecesBetweenLines(const Components& c, const std::vector<Blob>& blobs,
                                     const Plane& explained, float level) {
  std::vector<char> isPiece(blobs.size(), 0);
  constexpr int kReach = 3;
  for (std::size_t i = 1; i < blobs.size(); ++i) {
    const Blob& b = blobs[i];
    const auto cutAt = [&](bool alongRow, int edge, int direction) {
      const int from = alongRow ? b.y : b.x, to = alongRow ? b.y + b.height : b.x + b.width;
      for (int k = from; k < to; ++k) {
        const int x = alongRow ? edge : k, y = alongRow ? k : edge;
        if (c.labels.at<int>(y, x) != static_cast<int>(i)) continue;
        for (int r = 1; r <= kReach; ++r) {
          const int u = alongRow ? x + direction * r : x, v = alongRow ? y : y + direction * r;
          if (explained.inside(u, v) && explained.at(u, v) > 0.5F * level) return true;
        }
      }
      return false;
    };
    const int sides = int(cutAt(true, b.x, -1)) + int(cutAt(true, b.x + b.width - 1, 1)) +
                      int(cutAt(false, b.y, -1)) + int(cutAt(false, b.y + b.height - 1, 1));
    isPiece[i] = sides >= 2 ? 1 : 0;
  }
  return isPiece;
}

/// Weakens marker lines from an axis to the curve: exactly straight, isolated, starting at the frame's left
/// or lower edge. They can still be followed (a curve may begin flat), but lose against a curve beside them.
void weakenGuides(Plane& curveCoverage, const Box& frame, double strokeWidth) {
  constexpr float kWeak = 0.62F;  // share of the curves' coverage; a curve beside a marker line is worth more
  const int clear = static_cast<int>(std::ceil(strokeWidth / 2)) + 2;
  const auto along = [&](bool row, int lane, int start, int end, int step, int shortest) {
    const auto at = [&](int l, int i) {
      const int x = row ? i : l, y = row ? l : i;
      return curveCoverage.inside(x, y) ? curveCoverage.at(x, y) : 0.0F;
    };
    int inked = 0, alone = 0, gap = 0, last = start;
    for (int i = start; i != end && gap <= 12; i += step) {
      if (at(lane, i) < 0.4F) {
        ++gap;
        continue;
      }
      gap = 0;
      ++inked;
      const bool isAlone = at(lane - clear, i) < 0.3F && at(lane + clear, i) < 0.3F;
      if (isAlone) {
        ++alone;
        last = i;
      }
    }
    if (std::abs(last - start) < shortest || inked * 3 < std::abs(last - start) || alone * 10 < inked * 8)
      return;
    for (int i = start; i != last; i += step) {
      for (int l = lane - clear + 1; l < lane + clear; ++l) {
        const int x = row ? i : l, y = row ? l : i;
        if (curveCoverage.inside(x, y))
          curveCoverage.at(x, y) = std::min(curveCoverage.at(x, y), kWeak * 0.65F);
      }
    }
  };
  const int x0 = static_cast<int>(std::lround(frame.x0)) + clear,
            x1 = static_cast<int>(std::lround(frame.x1));
  const int y0 = static_cast<int>(std::lround(frame.y0)),
            y1 = static_cast<int>(std::lround(frame.y1)) - clear;
  for (int y = y0 + 4; y < y1 - 2; ++y) along(true, y, x0, x1, 1, static_cast<int>(0.12 * frame.width()));
  for (int x = x0 + 8; x < x1 - 2; ++x) along(false, x, y1, y0, -1, static_cast<int>(0.12 * frame.height()));
}

/// Returns true for an isolated arrow: a straight shaft as thin as a line, and a head that widens at one end.
bool isArrow(const std::vector<Point>& pixels, double strokeWidth, const Box& frame) {
  constexpr double shortest = 4, longest = 0.2;  // stroke widths; of the frame's width
  constexpr double headShare = 0.35;             // share of its length, at most
  constexpr double headTimes = 1.8;              // of the shaft's thickness, at least
  const Scatter scatter(pixels);
  const Point along = scatter.along(), middle = scatter.middle();
  const auto [first, last] = std::ranges::minmax(pixels, {}, [&](Point p) { return dot(p - middle, along); });
  const double from = dot(first - middle, along), length = dot(last - middle, along) - from;
  if (length < shortest * strokeWidth || length > longest * frame.width()) return false;
  // thickness at each pixel along the arrow
  std::vector<double> across(static_cast<std::size_t>(length) + 1, 0);
  for (const Point& p : pixels) {
    double& most = across[static_cast<std::size_t>(std::max(0.0, dot(p - middle, along) - from))];
    most = std::max(most, 2 * std::abs(cross(along, p - middle)) + 1);
  }
  const auto thickest = [&](double a, double b) {
    const auto at = [&](double share) {
      return across.begin() + static_cast<std::ptrdiff_t>(share * length);
    };
    return *std::max_element(at(a), at(b) + 1);
  };
  const double shaft = thickest(headShare, 1 - headShare), left = thickest(0, headShare),
               right = thickest(1 - headShare, 1);
  return shaft <= strokeWidth + 1.5 && std::min(left, right) <= shaft + 1 &&
         std::max(left, right) >= headTimes * shaft;
}

/// Removes arrows that touch nothing. An arrow that touches the plot's lines is kept, because it may be a
/// piece of a curve that they cut.
void fadeArrows(Plane& curveCoverage, Plane& explained, float level, double strokeWidth, const Box& frame) {
  const Components c = componentsOf(curveCoverage, 0.3F);
  cv::Mat lines = matOf(explained) > Structure::leastOfLine * level;
  cv::dilate(lines, lines, cv::getStructuringElement(cv::MORPH_RECT, {5, 5}));
  const auto touchesLine = [&](Point p) {
    return lines.at<std::uint8_t>(static_cast<int>(p.y), static_cast<int>(p.x)) != 0;
  };
  std::vector<std::vector<Point>> pieces(static_cast<std::size_t>(c.count));
  for (int y = 0; y < curveCoverage.height; ++y)
    for (int x = 0; x < curveCoverage.width; ++x)
      if (const int label = c.labels.at<int>(y, x); label > 0)
        pieces[static_cast<std::size_t>(label)].push_back({static_cast<double>(x), static_cast<double>(y)});
  for (const std::vector<Point>& piece : pieces)
    if (piece.size() > 1 && isArrow(piece, strokeWidth, frame) && std::ranges::none_of(piece, touchesLine))
      for (const Point& p : piece) curveCoverage.at(static_cast<int>(p.x), static_cast<int>(p.y)) = 0;
}

/// Removes text: marks completely inside a box of read text, and rows of glyph-sized blobs.
void fadeLettering(Plane& curveCoverage, const Plane& explained, float level,
                   const std::vector<Box>& lettering, double strokeWidth, const Box& frame) {
  const Components c = componentsOf(curveCoverage, 0.3F);
  std::vector<Blob> blobs(static_cast<std::size_t>(c.count));
  for (int i = 1; i < c.count; ++i) {
    blobs[static_cast<std::size_t>(i)] = {
        c.stats.at<int>(i, cv::CC_STAT_LEFT), c.stats.at<int>(i, cv::CC_STAT_TOP),
        c.stats.at<int>(i, cv::CC_STAT_WIDTH), c.stats.at<int>(i, cv::CC_STAT_HEIGHT)};
  }
  if (blobs.empty()) return;
  const double tallest = 0.075 * std::min(frame.height(), frame.width());
  const std::vector<char> isPiece = piecesBetweenLines(c, blobs, explained, level);
  std::vector<char> isText = wordsRunTogether(c, blobs, strokeWidth, tallest);
  const std::vector<char> inRows = glyphsInRows(blobs, strokeWidth, tallest);
  for (std::size_t i = 1; i < blobs.size(); ++i) {
    const Blob& o = blobs[i];
    isText[i] |= inRows[i];
    if (isPiece[i]) isText[i] = 0;
    isText[i] |= std::any_of(lettering.begin(), lettering.end(), [&](const Box& b) {
      return o.x >= b.x0 - 1.5 && o.y >= b.y0 - 1.5 && o.x + o.width - 1 <= b.x1 + 1.5 &&
             o.y + o.height - 1 <= b.y1 + 1.5;
    });
  }
  for (int y = 0; y < curveCoverage.height; ++y) {
    for (int x = 0; x < curveCoverage.width; ++x) {
      const auto label = static_cast<std::size_t>(c.labels.at<int>(y, x));
      if (label > 0 && isText[label]) curveCoverage.at(x, y) = 0;
    }
  }
}

}  // namespace

std::vector<StraightLine> findStraightLines(const WorkPlane& plane,
                                            const std::vector<double>& expectedColumns,
                                            const std::vector<double>& expectedRows) {
  std::vector<StraightLine> lines;
  findAlong(plane, true, expectedColumns, lines);
  findAlong(plane, false, expectedRows, lines);
  return lines;
}

Structure explainStructure(const WorkPlane& plane, const std::vector<StraightLine>& lines,
                           const std::vector<Box>& lettering) {
  Structure s;
  s.explained = Plane(plane.coverage.width, plane.coverage.height);
  s.upright = Plane(plane.coverage.width, plane.coverage.height);
  for (const StraightLine& line : lines) {
    explainLine(plane, line, s.explained);
    const double edge = line.reach + 2.0;
    const bool inside = line.position > plane.frame.x0 + edge && line.position < plane.frame.x1 - edge;
    if (line.vertical && inside) explainLine(plane, line, s.upright);
  }
  s.remainingCoverage = Plane(plane.coverage.width, plane.coverage.height);
  const Plane doubt = doubtOf(s.explained);
  for (std::size_t i = 0; i < s.remainingCoverage.values.size(); ++i) {
    s.remainingCoverage.values[i] =
        std::max(0.0F, plane.coverage.values[i] - s.explained.values[i] - doubt.values[i]);
  }
  s.curveLevel = curveLevelOf(s.remainingCoverage, plane);
  for (std::size_t i = 0; i < s.remainingCoverage.values.size(); ++i) {
    const float room = std::min(s.curveLevel, std::max(0.35F * s.curveLevel, 1.0F - s.explained.values[i]));
    s.remainingCoverage.values[i] = std::min(1.0F, s.remainingCoverage.values[i] / room);
  }
  s.strokeWidth_px = strokeWidthOf(s.remainingCoverage);
  fadeLettering(s.remainingCoverage, s.explained, s.curveLevel, lettering, s.strokeWidth_px, plane.frame);
  fadeArrows(s.remainingCoverage, s.explained, s.curveLevel, s.strokeWidth_px, plane.frame);
  weakenGuides(s.remainingCoverage, plane.frame, s.strokeWidth_px);
  cv::Mat paper = matOf(s.remainingCoverage) < 0.35F;
  cv::Mat distance;
  cv::distanceTransform(paper, distance, cv::DIST_L2, 3);
  s.gapDistance = Plane(plane.coverage.width, plane.coverage.height);
  for (int y = 0; y < plane.coverage.height; ++y) {
    const float* row = distance.ptr<float>(y);
    std::copy(row, row + plane.coverage.width, &s.gapDistance.at(0, y));
  }
  return s;
}

Plane rewardOf(const Structure& s, const WorkPlane& plane, const GapPrice& price) {
  // Curves run along horizontal gridlines (plateaus), but hardly ever up a vertical one, where leaders run.
  constexpr float kOnLevelLine = -0.5F, kOnUprightLine = -1.2F;
  Plane reward(s.remainingCoverage.width, s.remainingCoverage.height);
  for (int y = 0; y < reward.height; ++y) {
    for (int x = 0; x < reward.width; ++x) {
      const float d = std::min(s.gapDistance.at(x, y), 20.0F);
      const float gap = -(price.perPixel + price.perPixelOfDistance * d);
      const float n = std::clamp((s.remainingCoverage.at(x, y) - 0.15F) / 0.5F, 0.0F, 1.0F);
      const float open = gap + (1.0F - gap) * n;
      const float e = std::clamp((s.explained.at(x, y) / s.curveLevel - 0.3F) / 0.4F, 0.0F, 1.0F);
      const bool drawn = plane.coverage.at(x, y) > 0.4F * s.explained.at(x, y);
      const float onLine = s.upright.at(x, y) > 0.3F * s.curveLevel ? kOnUprightLine : kOnLevelLine;
      reward.at(x, y) =
          e > 0 && drawn ? (1 - e) * open + e * std::max(onLine, n > 0.6F ? open : onLine) : open;
    }
  }
  return reward;
}

}  // namespace detent::importer::trace
