// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/plot_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "importer/trace/tinted_areas.h"

namespace detent::importer::trace {

namespace {

constexpr int kMaxSamplesPerLine = 800;
constexpr float kLineContrast = 5;     // of a gridline against paper, colour levels
constexpr float kAsPaper = 2;          // colour levels; smaller differences are paper
constexpr double kLineSupport = 0.3;   // share of a gridline's length must have its colour
constexpr double kKnownLine_px = 2.5;  // distance within which a row counts as a known line
constexpr float kUnevenPaper = 8;      // difference of a tile's paper that makes the paper uneven

/// Most frequent colour of added pixels: the fullest 16-level cell, then the mean near its centre of mass.
class ModeOfColors {
 public:
  ModeOfColors() : cells_(4096) {}

  void add(Color3 c) {
    cells_[cellOf(c)].add(c);
    ++total_;
  }
  /// The fullest cell joined with its neighbours, so that a colour on a cell's border is not split.
  Color3 mode(double* share = nullptr) const {
    const auto fullest = std::ranges::max_element(cells_, {}, &Sum::count);
    const int best = static_cast<int>(fullest - cells_.begin());
    const int r = best >> 8, g = (best >> 4) & 15, b = best & 15;
    const Color3 centre = fullest->mean();
    Sum near;
    for (int i = std::max(0, r - 1); i <= std::min(15, r + 1); ++i)
      for (int j = std::max(0, g - 1); j <= std::min(15, g + 1); ++j)
        for (int k = std::max(0, b - 1); k <= std::min(15, b + 1); ++k)
          if (const Sum& cell = cells_[static_cast<std::size_t>((i << 8) | (j << 4) | k)];
              norm(cell.mean() - centre) <= 10)
            near.add(cell);
    if (share) *share = total_ > 0 ? near.count / total_ : 0;
    return near.mean();
  }

 private:
  /// Sum of colours in double precision; single precision is too coarse for a million pixels.
  struct Sum {
    double count = 0, r = 0, g = 0, b = 0;

    void add(Color3 c) {
      ++count;
      r += static_cast<double>(c.r), g += static_cast<double>(c.g), b += static_cast<double>(c.b);
    }
    void add(const Sum& other) { count += other.count, r += other.r, g += other.g, b += other.b; }
    Color3 mean() const {
      if (count <= 0) return {};
      return {static_cast<float>(r / count), static_cast<float>(g / count), static_cast<float>(b / count)};
    }
  };
  static std::size_t cellOf(Color3 c) {
    const auto level = [](float v) { return static_cast<std::size_t>(std::clamp(v, 0.0F, 255.0F)) >> 4; };
    return (level(c.r) << 8) | (level(c.g) << 4) | level(c.b);
  }
  std::vector<Sum> cells_;
  double total_ = 0;
};

/// The most frequent difference to the paper along one row or column.
class LineColor {
 public:
  explicit LineColor(float tolerance) : tolerance_(tolerance) {}

  void clear() {
    paper_ = 0, pale_ = 0;
    samples_.clear();
  }
  void add(Color3 difference) {
    const float contrast = norm(difference);
    if (contrast < kAsPaper)
      ++paper_;
    else if (contrast <= kAsPaper + widestOfOneColor())
      pale_ += contrast;
    samples_.push_back(difference);
  }
  /// nullopt if fewer than kLineSupport of the line have it, because text is dark too, but in many shades;
  /// and if it cannot have kLineContrast, which excludes most lines early.
  Color3 commonest() const {
    const double all = static_cast<double>(samples_.size()), least = kLineSupport * all;
    const bool mostlyPaper =
        static_cast<double>(paper_) > all - least;  // then the most frequent colour contains paper
    if (mostlyPaper && static_cast<double>(pale_) < static_cast<double>(kLineContrast - kAsPaper) * least)
      return {};
    std::array<std::array<int, 512>, 3> bins{};
    for (Color3 s : samples_) {
      ++bins[0][binOf(s.r)];
      ++bins[1][binOf(s.g)];
      ++bins[2][binOf(s.b)];
    }
    const Color3 peak{peakOf(bins[0]), peakOf(bins[1]), peakOf(bins[2])};
    Color3 sum;
    int n = 0;
    for (Color3 s : samples_) {
      const Color3 d = s - peak;
      if (std::abs(d.r) > tolerance_ || std::abs(d.g) > tolerance_ || std::abs(d.b) > tolerance_) continue;
      sum = sum + s;
      ++n;
    }
    return n >= 1 && n >= least ? (1 / static_cast<float>(n)) * sum : Color3{};
  }

 private:
  /// The largest distance between two samples that count as one colour.
  float widestOfOneColor() const { return 2 * std::sqrt(3.0F) * tolerance_; }
  static std::size_t binOf(float v) { return static_cast<std::size_t>(std::clamp(v + 256.5F, 0.0F, 511.0F)); }
  /// Middle of the fullest window of the tolerance's width.
  float peakOf(const std::array<int, 512>& bins) const {
    const int half = std::max(1, static_cast<int>(0.5F * tolerance_));
    int inWindow = 0, best = -1, at = 0;
    for (int i = 0; i < 512 + half; ++i) {
      if (i < 512) inWindow += bins[static_cast<std::size_t>(i)];
      if (i > 2 * half) inWindow -= bins[static_cast<std::size_t>(i - 2 * half - 1)];
      if (inWindow > best) {
        best = inWindow;
        at = i - half;
      }
    }
    return static_cast<float>(at) - 256;
  }
  float tolerance_;
  std::size_t paper_ = 0;  ///< samples equal to paper
  float pale_ = 0;         ///< summed contrast of others that may count as one colour with paper
  std::vector<Color3> samples_;
};

/// One row or column that differs from the paper along most of its length.
struct LineCandidate {
  Color3 difference;
  bool known = false;
  std::size_t position = 0;
  bool isRow = false;
};

/// Returns true for a gridline. A single row or column that differs from the paper may be a flat or steep
/// stretch of a curve; it is a gridline only if others of its colour exist, or if it is a known line and
/// nothing of another colour contradicts.
bool isGridline(const LineCandidate& line, const std::vector<LineCandidate>& all) {
  int peers = 0, strangers = 0;
  for (const LineCandidate& other : all) {
    const bool same = other.isRow == line.isRow;
    if (same && other.position <= line.position + 4 && line.position <= other.position + 4) continue;
    const bool similar =
        dot(line.difference, other.difference) > 0.97F * norm(line.difference) * norm(other.difference);
    ++(similar ? peers : strangers);
  }
  return peers >= 2 || (line.known && (peers >= 1 || strangers == 0));
}

Color3 paperOf(const Raster& r) {
  const int step = std::max(1, std::min(r.width_px, r.height_px) / kMaxSamplesPerLine);
  ModeOfColors mode;
  for (int y = 0; y < r.height_px; y += step)
    for (int x = 0; x < r.width_px; x += step) mode.add(colorAt(r, x, y));
  return mode.mode();
}

}  // namespace

PlotScene::PlotScene(const Raster& view, const PlotFrame& frame, const std::vector<SeenText>& words,
                     const std::vector<Box>& masks_px)
    : frame_(frame), area_(makePlotArea(view, frame, words, masks_px)) {
  if (empty()) return;
  paper_ = paperOf(area_.raster);
  const auto lines = [this] {
    measureLines();
    return lineDirection_;
  };
  if (liftTintedAreas(area_.raster, paper_, lines)) paper_ = paperOf(area_.raster);
  measureShading();
  measureNoise();
  measureLines();
}

const Lettering& PlotScene::lettering() const {
  if (lettering_) return *lettering_;
  Mask contrast;
  contrast.reserve(area_.pixels());
  for (int y = 0; y < area_.raster.height_px; ++y)
    for (int x = 0; x < area_.raster.width_px; ++x)
      contrast.push_back(
          static_cast<std::uint8_t>(std::min(255.0F, 0.577F * norm(pixel(x, y) - behind(x, y)))));
  return lettering_.emplace(findLettering(area_, contrast, coverageThreshold()));
}

const ColourOnArea& PlotScene::coverageOf(Rgb color) const {
  const auto known = std::ranges::find(coloursOnArea_, color, &std::pair<Rgb, ColourOnArea>::first);
  if (known != coloursOnArea_.end()) return known->second;
  constexpr float sameHue = 0.93F;  // cosine; other colours have a share of this one
  const PaletteColour colour = paletteColourOf(color, paper_);
  Plane coverage(area_.raster.width_px, area_.raster.height_px);
  for (int y = 0; y < coverage.height; ++y)
    for (int x = 0; x < coverage.width; ++x) {
      const Color3 difference = pixel(x, y) - paperAt(x, y);
      const float own = dot(difference, colour.direction);
      if (own >= sameHue * norm(difference)) coverage.at(x, y) = std::min(own / colour.strength, 1.0F);
    }
  return coloursOnArea_.emplace_back(color, ColourOnArea(std::move(coverage), colour.strength)).second;
}

void PlotScene::measureShading() {
  const Raster& r = area_.raster;
  tilesAcross_ = std::clamp(r.width_px / 48, 1, 12);
  tilesDown_ = std::clamp(r.height_px / 48, 1, 12);
  tileWidth_ = static_cast<double>(r.width_px) / tilesAcross_;
  tileHeight_ = static_cast<double>(r.height_px) / tilesDown_;
  std::vector<Color3> tiles(static_cast<std::size_t>(tilesAcross_) * static_cast<std::size_t>(tilesDown_),
                            paper_);
  int uneven = 0, sure = 0;
  for (int j = 0; j < tilesDown_; ++j)
    for (int i = 0; i < tilesAcross_; ++i) {
      const int x0 = static_cast<int>(i * tileWidth_), x1 = static_cast<int>((i + 1) * tileWidth_);
      const int y0 = static_cast<int>(j * tileHeight_), y1 = static_cast<int>((j + 1) * tileHeight_);
      const int step = std::max(1, std::min(x1 - x0, y1 - y0) / 40);
      ModeOfColors mode;
      for (int y = y0; y < y1; y += step)
        for (int x = x0; x < x1; x += step) mode.add(pixel(x, y));
      double share = 0;
      const Color3 local = mode.mode(&share);
      if (share < 0.4) continue;
      ++sure;
      if (norm(local - paper_) > kUnevenPaper) ++uneven;
      tiles[static_cast<std::size_t>(j * tilesAcross_ + i)] = local;
    }
  if (5 * uneven > sure) shading_ = std::move(tiles);
}

Color3 PlotScene::shadedPaper(int x, int y) const {
  const double tx = std::clamp(x / tileWidth_ - 0.5, 0.0, tilesAcross_ - 1.0);
  const double ty = std::clamp(y / tileHeight_ - 0.5, 0.0, tilesDown_ - 1.0);
  const int i = std::min(static_cast<int>(tx), std::max(0, tilesAcross_ - 2));
  const int j = std::min(static_cast<int>(ty), std::max(0, tilesDown_ - 2));
  const float fx = static_cast<float>(tx - i), fy = static_cast<float>(ty - j);
  const auto tile = [this](int a, int b) {
    return shading_[static_cast<std::size_t>(std::min(b, tilesDown_ - 1) * tilesAcross_ +
                                             std::min(a, tilesAcross_ - 1))];
  };
  const Color3 top = (1 - fx) * tile(i, j) + fx * tile(i + 1, j);
  const Color3 bottom = (1 - fx) * tile(i, j + 1) + fx * tile(i + 1, j + 1);
  return (1 - fy) * top + fy * bottom;
}

void PlotScene::measureLines() {
  const Raster& r = area_.raster;
  const int x0 = std::max(0, static_cast<int>(area_.frame.x0)),
            y0 = std::max(0, static_cast<int>(area_.frame.y0));
  const int x1 = std::min(r.width_px - 1, static_cast<int>(std::ceil(area_.frame.x1)));
  const int y1 = std::min(r.height_px - 1, static_cast<int>(std::ceil(area_.frame.y1)));
  rows_.assign(static_cast<std::size_t>(r.height_px), {});
  columns_.assign(static_cast<std::size_t>(r.width_px), {});
  lineDirection_ = {};
  const int stepX = std::max(1, (x1 - x0) / kMaxSamplesPerLine),
            stepY = std::max(1, (y1 - y0) / kMaxSamplesPerLine);
  LineColor line(8 + 2 * noise_);
  std::vector<LineCandidate> candidates;
  const auto collect = [&](int position, bool isRow) {
    const Color3 difference = line.commonest();
    if (norm(difference) < kLineContrast) return;
    const std::vector<double>& known = isRow ? area_.rows_px : area_.columns_px;
    candidates.push_back(
        {difference, isAtOneOf(known, position, kKnownLine_px), static_cast<std::size_t>(position), isRow});
  };
  for (int y = 0; y < r.height_px; ++y) {
    line.clear();
    for (int x = x0; x <= x1; x += stepX) line.add(pixel(x, y) - paperAt(x, y));
    collect(y, true);
  }
  for (int x = 0; x < r.width_px; ++x) {
    line.clear();
    for (int y = y0; y <= y1; y += stepY) line.add(pixel(x, y) - paperAt(x, y));
    collect(x, false);
  }
  for (const LineCandidate& candidate : candidates) {
    if (!isGridline(candidate, candidates)) continue;
    (candidate.isRow ? rows_ : columns_)[candidate.position] = {
        candidate.difference, dot(candidate.difference, candidate.difference)};
    lineDirection_ = lineDirection_ + candidate.difference;
  }
  if (norm(lineDirection_) > 0) lineDirection_ = (1 / norm(lineDirection_)) * lineDirection_;
}

void PlotScene::measureNoise() {
  const Raster& r = area_.raster;
  const int step = std::max(1, std::min(r.width_px, r.height_px) / kMaxSamplesPerLine);
  std::vector<int> bins(64, 0);
  int n = 0;
  for (int y = 0; y < r.height_px; y += step)
    for (int x = 0; x < r.width_px; x += step) {
      ++bins[static_cast<std::size_t>(std::min(63.0F, norm(pixel(x, y) - paperAt(x, y))))];
      ++n;
    }
  int below = 0;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    below += bins[i];
    if (2 * below >= n) {
      noise_ = static_cast<float>(i);  // whole levels; a clean rendering stays at 0
      return;
    }
  }
}

}  // namespace detent::importer::trace
