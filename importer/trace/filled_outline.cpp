// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/filled_outline.h"

#include <algorithm>
#include <cmath>

namespace detent::importer {
namespace {

constexpr double leastSlenderness = 2.5;  // length over width

/// Removes spikes of the outline. On the inner side of a bend sharper than the line's width, offset edges
/// overlap, and some programs go to the line's middle between them.
Polyline withoutSpikes(Polyline ring, double longest_px) {
  constexpr double turnedBack = -0.42;  // cosine of 115 degrees
  for (std::size_t i = 0, kept = 0; kept < ring.size() && ring.size() > 4;) {
    const std::size_t n = ring.size();
    const std::size_t at = i % n;
    const Point in = ring[at] - ring[(at + n - 1) % n], out = ring[(at + 1) % n] - ring[at];
    const bool spike =
        std::min(norm(in), norm(out)) <= longest_px && dot(in, out) < turnedBack * norm(in) * norm(out);
    if (!spike) {
      i = at + 1, ++kept;
      continue;
    }
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(at));
    i = (at + ring.size() - 1) % ring.size(), kept = 0;  // the previous vertex may be a spike now
  }
  return ring;
}

/// Finds the two caps: the edges where the outline turns back. An end of a line of width w has two corners
/// (or an arc) within about w along the ring, over which the direction turns by half a turn.
std::optional<std::pair<std::size_t, std::size_t>> capEdges(const Polyline& ring, double width) {
  const std::size_t n = ring.size();
  struct Cap {
    std::size_t edge;
    double turn;
  };
  std::vector<Cap> caps;
  const auto direction = [&](std::size_t i) {
    const Point &a = ring[i % n], &b = ring[(i + 1) % n];
    return std::atan2(b.y - a.y, b.x - a.x);
  };
  for (std::size_t start = 0; start < n; ++start) {
    // Edges from `start` with a total length of at most the cap's size.
    double along = 0, turned = 0;
    for (std::size_t k = 1; k < n; ++k) {
      turned += std::remainder(direction(start + k) - direction(start + k - 1), 2 * M_PI);
      if (std::abs(turned) > 0.85 * M_PI) {
        caps.push_back({(start + (k + 1) / 2) % n, std::abs(turned)});
        break;
      }
      along += distance(ring[(start + k) % n], ring[(start + k + 1) % n]);
      if (along > 1.8 * width) break;
    }
  }
  if (caps.empty()) return std::nullopt;
  // The pair of caps that halves the outline best.
  const double whole = lengthOf(ring) + distance(ring.back(), ring.front());
  const std::vector<double> at = arcOf(ring);
  std::optional<std::pair<std::size_t, std::size_t>> best;
  double bestSkew = 0.1;
  for (std::size_t i = 0; i < caps.size(); ++i)
    for (std::size_t j = i + 1; j < caps.size() && caps.size() < 200; ++j) {
      const double share = std::abs(at[caps[i].edge] - at[caps[j].edge]) / whole;
      const double skew = std::abs(share - 0.5);
      if (skew < bestSkew) {
        bestSkew = skew;
        best = std::minmax(caps[i].edge, caps[j].edge);
      }
    }
  return best;
}

}  // namespace

std::optional<OutlineCentre> centreOfOutline(const Polyline& outline, double maxWidth_px) {
  Polyline ring = withoutRepeats(outline);
  while (ring.size() > 1 && distance(ring.front(), ring.back()) < 1e-9) ring.pop_back();
  constexpr std::size_t mostVertices = 20000;  // the pairing below is quadratic
  if (ring.size() < 4 || ring.size() > mostVertices) return std::nullopt;
  const auto aroundOf = [](const Polyline& line) {
    return lengthOf(line) + distance(line.back(), line.front());
  };
  const double area = std::abs(twiceAreaOf(ring)), outlined = aroundOf(ring);
  if (area > maxWidth_px * outlined) return std::nullopt;
  ring = withoutSpikes(std::move(ring), area / outlined);
  const double around = aroundOf(ring);
  const double width = std::abs(twiceAreaOf(ring)) / around;
  const double length = around / 2;
  if (!(width > 0) || width > maxWidth_px || length < leastSlenderness * width) return std::nullopt;
  const auto caps = capEdges(ring, width);
  if (!caps) return std::nullopt;
  // Edge i runs from vertex i to the next one; one side begins behind the first cap's edge and ends before
  // the second's.
  const auto vertex = [&](std::size_t i) { return ring.begin() + static_cast<std::ptrdiff_t>(i); };
  const Polyline one(vertex(caps->first + 1), vertex(caps->second + 1));
  Polyline other(vertex(caps->second + 1), ring.end());
  other.insert(other.end(), ring.begin(), vertex(caps->first + 1));
  if (one.size() < 2 || other.size() < 2) return std::nullopt;
  OutlineCentre centre;
  centre.width_px = width;
  for (const Point& p : one) {
    const Point q = nearestOn(other, p);
    if (distance(p, q) > 2 * width) continue;
    centre.points.push_back({(p.x + q.x) / 2, (p.y + q.y) / 2});
  }
  if (centre.points.size() < 2) return std::nullopt;
  if (lengthOf(centre.points) < leastSlenderness * width) return std::nullopt;
  return centre;
}

}  // namespace detent::importer
