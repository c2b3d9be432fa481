// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/library/feel_map.h"

#include <cmath>
#include <cstddef>
#include <numeric>

#include "importer/library/feel_distance.h"
#include "model/units.h"

namespace detent::importer {
namespace {

constexpr std::size_t positions = 24;  // samples of a stroke, about half a click's width apart
constexpr std::size_t dimensions = 2 * positions + 1;
constexpr std::size_t travelAt = dimensions - 1;
using Vector = std::array<double, dimensions>;

/// Coordinates made of press, release and travel, scaled so that the distance of two switches is in lab
/// noises.
Vector featuresOf(const FeltShape& shape) {
  const double gf = newtonsPer(ForceUnit::gramForce);
  const double perPlace = 1 / (gf * std::sqrt(double(positions)) * labNoise_gf);
  const std::vector<float>& release = shape.release_N.empty() ? shape.press_N : shape.release_N;
  Vector features{};
  for (std::size_t i = 0; i < positions; ++i) {
    // The middle 90 % of the travel, as for the felt distance.
    const double share = 0.05 + 0.9 * (double(i) + 0.5) / double(positions);
    const auto at = static_cast<std::size_t>(share * double(FeltShape::samples - 1));
    features[i] = perPlace * double{shape.press_N[at]};
    features[positions + i] = perPlace * double{release[at]};
  }
  features[travelAt] = FeelWeights{}.travel_gf_per_mm * shape.travel_mm / labNoise_gf;
  return features;
}

double product(const Vector& a, const Vector& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// Scales a vector to length 1; a zero vector stays unchanged.
double normalize(Vector& vector) {
  const double length = std::sqrt(product(vector, vector));
  if (length > 0)
    for (double& each : vector) each /= length;
  return length;
}

using Matrix = std::array<Vector, dimensions>;

Matrix covarianceOf(const std::vector<Vector>& centred) {
  Matrix covariance{};
  for (const Vector& each : centred)
    for (std::size_t i = 0; i < dimensions; ++i)
      for (std::size_t j = i; j < dimensions; ++j) covariance[i][j] += each[i] * each[j];
  for (std::size_t i = 0; i < dimensions; ++i)
    for (std::size_t j = 0; j < dimensions; ++j)
      covariance[i][j] = (j < i ? covariance[j][i] : covariance[i][j] / double(centred.size()));
  return covariance;
}

struct Axis {
  Vector direction{};
  double variance = 0;
};

/// The axis of the largest variance, by power iteration from `start`.
Axis largestOf(const Matrix& matrix, Vector start) {
  constexpr int most = 500;
  constexpr double settled = 1e-12;  // share: 1 - cosine of a turn
  Axis axis{start, 0};
  normalize(axis.direction);
  for (int i = 0; i < most; ++i) {
    Vector next{};
    for (std::size_t row = 0; row < dimensions; ++row) next[row] = product(matrix[row], axis.direction);
    const double variance = normalize(next);
    const double turned = 1 - std::abs(product(next, axis.direction));
    axis = {next, variance};
    if (turned < settled) break;
  }
  return axis;
}

void takeOut(Matrix& matrix, const Axis& axis) {
  for (std::size_t i = 0; i < dimensions; ++i)
    for (std::size_t j = 0; j < dimensions; ++j)
      matrix[i][j] -= axis.variance * axis.direction[i] * axis.direction[j];
}

double correlationOf(const std::vector<std::pair<double, double>>& pairs) {
  double x = 0, y = 0, xx = 0, yy = 0, xy = 0;
  const auto n = double(pairs.size());
  for (const auto& [a, b] : pairs) x += a, y += b, xx += a * a, yy += b * b, xy += a * b;
  const double across = (xx - x * x / n) * (yy - y * y / n);
  return across > 0 ? (xy - x * y / n) / std::sqrt(across) : 0;
}

/// Finds the key figure with the largest correlation to an axis.
void nameAxis(FeelAxis& axis, std::size_t which, const FeelMap& map,
              const std::vector<LibrarySwitch>& switches) {
  for (const KeyFigureName& name : keyFigureNames()) {
    std::vector<std::pair<double, double>> pairs;
    for (std::size_t i = 0; i < switches.size(); ++i)
      if (const auto& value = switches[i].figures[name.figure])
        pairs.emplace_back(map.positions[i][which], *value);
    // A figure that few switches have would correlate with anything.
    if (2 * pairs.size() < switches.size() || pairs.size() < 3) continue;
    const double correlation = correlationOf(pairs);
    if (std::abs(correlation) > std::abs(axis.correlation))
      axis.likest = name.figure, axis.correlation = correlation;
  }
}

}  // namespace

FeelMap feelMapOf(const std::vector<LibrarySwitch>& switches) {
  FeelMap map;
  if (switches.empty()) return map;
  std::vector<Vector> centred;
  Vector mean{};
  for (const LibrarySwitch& each : switches) {
    centred.push_back(featuresOf(each.shape));
    for (std::size_t i = 0; i < dimensions; ++i) mean[i] += centred.back()[i] / double(switches.size());
  }
  for (Vector& each : centred)
    for (std::size_t i = 0; i < dimensions; ++i) each[i] -= mean[i];

  Matrix covariance = covarianceOf(centred);
  double variance = 0;
  for (std::size_t i = 0; i < dimensions; ++i) variance += covariance[i][i];
  map.positions.resize(switches.size());
  for (std::size_t which = 0; which < 2; ++which) {
    Vector start{};  // the first axis starts along the forces, the second along the travel
    start.fill(which == 0 ? 1.0 : 0.1);
    start[travelAt] = 1;
    Axis axis = largestOf(covariance, start);
    takeOut(covariance, axis);
    const double sign = which == 0
                            ? std::accumulate(axis.direction.begin(), axis.direction.begin() + positions, 0.0)
                            : axis.direction[travelAt];
    if (sign < 0)
      for (double& each : axis.direction) each = -each;
    for (std::size_t i = 0; i < switches.size(); ++i)
      map.positions[i][which] = product(centred[i], axis.direction);
    map.axes[which].share = variance > 0 ? axis.variance / variance : 0;
    nameAxis(map.axes[which], which, map, switches);
  }
  return map;
}

}  // namespace detent::importer
