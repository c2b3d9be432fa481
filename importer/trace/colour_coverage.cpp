// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/colour_coverage.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "importer/trace/colour_shades.h"

namespace detent::importer::trace {

namespace {

constexpr float kMaxColourCoverage = 1.2F;  // above 1, because a colour has darker pixels than its mean
constexpr float kResidualFloor = 5;         // colour levels: rounding and neighbouring shades
constexpr float kResidualShare = 0.045F;    // of the difference; a colour's shade is known only approximately

/// Possible composition of a pixel.
struct Mixture {
  int first = -1, second = -1;
  float a = 0, b = 0;
  float residual = 1e9F;
};

class PixelUnmixer {
 public:
  PixelUnmixer(const std::vector<PaletteColour>& colours, Color3 paper) {
    for (const PaletteColour& colour : colours) {
      full_.push_back(paper + colour.difference());
      isCurve_.push_back(colour.isCurve ? 1 : 0);
    }
  }

  Mixture explain(Color3 pixel, Color3 behind, float tolerance) const {
    const Color3 difference = pixel - behind;
    Mixture best;
    for (std::size_t k = 0; k < full_.size(); ++k) {
      const Color3 v = full_[k] - behind;
      const float a = std::clamp(dot(difference, v) / std::max(1.0F, dot(v, v)), 0.0F, kMaxColourCoverage);
      const float residual = norm(difference - a * v);
      if (residual < best.residual) best = {static_cast<int>(k), -1, a, 0, residual};
    }
    if (best.residual <= tolerance) return best;
    Mixture curves;
    for (std::size_t k = 0; k < full_.size(); ++k)
      for (std::size_t j = 0; j < k; ++j) {
        const Mixture pair = explainByTwo(difference, behind, k, j);
        // A second colour must improve the fit much, because two always explain more than one.
        if (pair.residual < 0.5F * best.residual) best = pair;
        if (isCurve_[k] && isCurve_[j] && pair.residual < curves.residual) curves = pair;
      }
    return curves.residual <= tolerance ? curves : best;
  }

 private:
  Mixture explainByTwo(Color3 difference, Color3 behind, std::size_t k, std::size_t j) const {
    const Color3 u = full_[k] - behind, v = full_[j] - behind;
    const float uu = dot(u, u), vv = dot(v, v), uv = dot(u, v);
    const float determinant = uu * vv - uv * uv;
    Mixture pair;
    // Not less than this: if a colour equals what lies behind it, both sides are 0.
    if (determinant <= 1e-3F * uu * vv) return pair;
    const float du = dot(difference, u), dv = dot(difference, v);
    float a = (du * vv - dv * uv) / determinant, b = (dv * uu - du * uv) / determinant;
    if (a < 0.03F || b < 0.03F) return pair;
    const float sum = a + b;
    if (sum > kMaxColourCoverage) {
      a *= kMaxColourCoverage / sum;
      b *= kMaxColourCoverage / sum;
    }
    const Color3 rest = difference - (a * u + b * v);
    return {static_cast<int>(k), static_cast<int>(j), a, b, norm(rest)};
  }

  std::vector<Color3> full_;
  std::vector<char> isCurve_;
};

}  // namespace

Plane pooled(const Plane& plane, int factor) {
  Plane out((plane.width + factor - 1) / factor, (plane.height + factor - 1) / factor);
  std::vector<float> rows(
      static_cast<std::size_t>(plane.width));  // per column, the largest value of the joined rows
  for (int top = 0; top < plane.height; top += factor) {
    std::fill(rows.begin(), rows.end(), 0.0F);
    for (int y = top; y < std::min(top + factor, plane.height); ++y) {
      const float* in = plane.values.data() + plane.index(0, y);
      for (std::size_t x = 0; x < rows.size(); ++x) rows[x] = std::max(rows[x], in[x]);
    }
    float* to = out.values.data() + out.index(0, top / factor);
    for (int x = 0; x < plane.width; x += factor)
      *to++ = *std::max_element(rows.begin() + x, rows.begin() + std::min(x + factor, plane.width));
  }
  return out;
}

Coverage unmix(const PlotScene& scene, const std::vector<PaletteColour>& colours) {
  const Raster& r = scene.area().raster;
  Coverage coverage;
  coverage.unknown = Plane(r.width_px, r.height_px);
  for (std::size_t k = 0; k < colours.size(); ++k) coverage.planes.emplace_back(r.width_px, r.height_px);
  const PixelUnmixer unmixer(colours, scene.paper());
  const float floor = std::max(5.0F, 3 * scene.noise());
  const float typical = colours.empty() ? 255.0F : std::max(40.0F, colours.front().strength);
  for (int y = 0; y < r.height_px; ++y)
    for (int x = 0; x < r.width_px; ++x) {
      const Color3 pixel = scene.pixel(x, y), behind = scene.behind(x, y);
      const float length = norm(pixel - behind);
      if (length < floor) continue;
      const float tolerance = kResidualFloor + 2 * scene.noise() + kResidualShare * length;
      const Mixture mixture = unmixer.explain(pixel, behind, tolerance);
      const std::size_t i = coverage.unknown.index(x, y);
      if (mixture.residual > std::max(2.5F * tolerance, 0.2F * length)) {  // none of these colours
        coverage.unknown.values[i] = std::min(1.0F, length / typical);
        continue;
      }
      if (mixture.first >= 0) coverage.planes[static_cast<std::size_t>(mixture.first)].values[i] = mixture.a;
      if (mixture.second >= 0)
        coverage.planes[static_cast<std::size_t>(mixture.second)].values[i] = mixture.b;
      if (mixture.residual > 2 * tolerance)
        coverage.unknown.values[i] = std::min(1.0F, mixture.residual / typical);
    }
  partShades(coverage.planes, colours);
  return coverage;
}

}  // namespace detent::importer::trace
