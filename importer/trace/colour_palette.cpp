// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/colour_palette.h"

#include <algorithm>
#include <cmath>

#include "importer/page/quantile.h"

namespace detent::importer::trace {

namespace {

constexpr int kCells = 40;        // per axis of the direction cube, [-1, 1]
constexpr float kDarkest = 1.5F;  // of a colour's strength; letters of it may have this much

struct Sample {
  Color3 direction;
  float length = 0;
};

std::size_t cellOf(Color3 d) {
  const auto cell = [](float v) {
    return static_cast<std::size_t>(std::clamp(static_cast<int>((v + 1) * 0.5F * kCells), 0, kCells - 1));
  };
  return (cell(d.r) * kCells + cell(d.g)) * kCells + cell(d.b);
}

std::vector<Sample> colourSamples(const PlotScene& scene, const Mask& excluded) {
  const PlotArea& area = scene.area();
  const float threshold = std::max(24.0F, scene.coverageThreshold());
  std::vector<Sample> samples;
  const Raster& r = area.raster;
  // Half a pixel inside the frame, to exclude a frame line thicker than measured.
  const int x0 = std::max(0, static_cast<int>(std::ceil(area.frame.x0 + 0.5)));
  const int y0 = std::max(0, static_cast<int>(std::ceil(area.frame.y0 + 0.5)));
  const int x1 = std::min(r.width_px - 1, static_cast<int>(std::floor(area.frame.x1 - 0.5)));
  const int y1 = std::min(r.height_px - 1, static_cast<int>(std::floor(area.frame.y1 - 0.5)));
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x) {
      const std::size_t i =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(r.width_px) + static_cast<std::size_t>(x);
      if (!excluded.empty() && excluded[i]) continue;
      // Over a gridline the difference to the background has another direction than over paper.
      if (scene.onLine(x, y)) continue;
      const Color3 difference = scene.pixel(x, y) - scene.behind(x, y);
      const float length = norm(difference);
      if (length >= threshold) samples.push_back({(1 / length) * difference, length});
    }
  return samples;
}

/// Centre of the densest neighbourhood, refined by averaging what lies within `cosine` of it.
Color3 densestDirection(const std::vector<Sample>& samples, const std::vector<char>& taken, float cosine) {
  std::vector<float> cells(static_cast<std::size_t>(kCells * kCells * kCells), 0);
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (!taken[i]) cells[cellOf(samples[i].direction)] += samples[i].length;
  const std::size_t best =
      static_cast<std::size_t>(std::max_element(cells.begin(), cells.end()) - cells.begin());
  const auto coordinate = [](std::size_t c) { return (static_cast<float>(c) + 0.5F) * 2 / kCells - 1; };
  Color3 centre{coordinate(best / (kCells * kCells)), coordinate(best / kCells % kCells),
                coordinate(best % kCells)};
  centre = (1 / std::max(1e-6F, norm(centre))) * centre;
  for (int round = 0; round < 4; ++round) {
    Color3 sum;
    for (std::size_t i = 0; i < samples.size(); ++i)
      if (!taken[i] && dot(samples[i].direction, centre) >= cosine)
        sum = sum + samples[i].length * samples[i].direction;
    if (norm(sum) < 1e-3F) break;
    centre = (1 / norm(sum)) * sum;
  }
  return centre;
}

/// Returns true if p lies between the differences of two colours, like pixels where one line's edge runs over
/// another line.
bool isBlend(const PaletteColour& p, const PaletteColour& a, const PaletteColour& b) {
  const Color3 u = a.difference(), v = b.difference(), w = p.difference();
  const Color3 along = v - u;
  const float t = dot(w - u, along) / std::max(1e-3F, dot(along, along));
  if (t < 0.08F || t > 0.92F) return false;
  return norm(w - u - t * along) < 14;
}

}  // namespace

std::vector<PaletteColour> findColours(const PlotScene& scene, const Mask& excluded,
                                       const PaletteLimits& limits) {
  const std::vector<Sample> samples = colourSamples(scene, excluded);
  std::vector<char> taken(samples.size(), 0);
  const float cosine = static_cast<float>(std::cos(limits.mergeAngle_deg * M_PI / 180));
  std::vector<PaletteColour> colours;
  std::vector<float> lengths;
  for (int round = 0; round < 3 * limits.maxColours && static_cast<int>(colours.size()) < limits.maxColours;
       ++round) {
    const Color3 direction = densestDirection(samples, taken, cosine);
    lengths.clear();
    for (std::size_t i = 0; i < samples.size(); ++i)
      if (!taken[i] && dot(samples[i].direction, direction) >= cosine) {
        taken[i] = 1;
        lengths.push_back(samples[i].length);
      }
    if (lengths.empty()) break;
    PaletteColour colour;
    colour.direction = direction;
    double sum = 0;
    for (float l : lengths) sum += static_cast<double>(l);
    colour.strength = quantileOf(lengths, 0.95);
    colour.mass_px = sum / static_cast<double>(std::max(1.0F, colour.strength));
    if (colour.mass_px < limits.minMass_px) {
      if (sum < 24 * limits.minMass_px) break;
      continue;
    }
    bool blend = false;
    for (std::size_t i = 0; i < colours.size() && !blend; ++i)
      for (std::size_t j = 0; j < i && !blend; ++j)
        blend = std::min(colours[i].mass_px, colours[j].mass_px) > 1.5 * colour.mass_px &&
                isBlend(colour, colours[i], colours[j]);
    if (!blend) colours.push_back(colour);
  }
  std::sort(colours.begin(), colours.end(),
            [](const PaletteColour& a, const PaletteColour& b) { return a.mass_px > b.mass_px; });
  return colours;
}

void addLetterColour(std::vector<PaletteColour>& colours, const PlotScene& scene) {
  const Mask& letters = scene.lettering().mask;
  Mask others(letters.size());
  std::transform(letters.begin(), letters.end(), others.begin(), [](std::uint8_t l) { return l ? 0 : 1; });
  PaletteLimits one;
  one.maxColours = 1;
  for (const PaletteColour& letter : findColours(scene, others, one)) {
    // The pale rim of a grey line does not show the colour of black letters. Pixels darker than any colour
    // allows are explained by other colours, and two opposite colours make black.
    const bool known = std::any_of(colours.begin(), colours.end(), [&](const PaletteColour& colour) {
      return dot(colour.direction, letter.direction) > 0.99F && letter.strength <= kDarkest * colour.strength;
    });
    if (!known) colours.push_back(letter);
  }
}

}  // namespace detent::importer::trace
