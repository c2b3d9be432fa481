// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The most rewarding path over a plane: never back in x, free in y, with a price for turns. Exact, by dynamic
// programming over (pixel, direction); the direction carries a curve straight through crossings. Idea:
// orientation-lifted minimal paths (Bekkers et al., "A PDE approach to data-driven sub-Riemannian geodesics
// in SE(2)", 2015), here x-monotone, which makes it a sweep over columns and allows gains as well as costs.

#include <array>
#include <cstdint>
#include <vector>

#include "importer/trace/work_plane.h"

namespace detent::importer::trace {

struct PathLimits {
  int startFrom = 0, startTo = 0;  ///< columns in which the path may start, inclusive
  int endFrom = 0, endTo = 0;      ///< columns in which it may end, inclusive
};

struct LiftedPath {
  std::vector<Point>
      points;  ///< plane px, in order of travel (x never decreases); every step of the search, 1..5 px apart
  double gain = 0;
  bool found() const { return points.size() > 1; }
};

struct PathOptions {
  double turnCost_px = 4;  ///< price of a turn by one radian, in pixels of full reward; [0, 100]
};

/// Reuses its buffers between searches over the same pixels.
class LiftedSearch {
 public:
  /// `open`: pixels a path may use (value > 0).
  LiftedSearch(const Plane& open, const PathOptions& options);

  LiftedPath best(const Plane& reward, const PathLimits& limits);

  static constexpr int kDirections = 21;  ///< from straight down to straight up

 private:
  struct Node {
    int x = 0, y = 0;
  };
  int indexAt(int x, int y) const {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return -1;
    return index_[static_cast<std::size_t>(x) * static_cast<std::size_t>(height_) +
                  static_cast<std::size_t>(y)];
  }
  void layOutSteps();
  void arrive(const Plane& reward, const PathLimits& limits, int node);
  void runAlongColumn(const Plane& reward, int from, int to, int direction);
  LiftedPath pathBackwards(int node, int direction) const;

  int width_ = 0, height_ = 0;
  PathOptions options_;
  std::array<std::array<int, 5>, kDirections> stepPixels_{};
  std::vector<int> index_;   ///< column-major, -1 where closed
  std::vector<Node> nodes_;  ///< by column, top to bottom
  std::vector<int> columnStart_;
  std::vector<float> score_;           ///< best gain of a path that leaves (node, direction)
  std::vector<std::uint8_t> arrived_;  ///< how the state was reached from earlier columns
  std::vector<std::uint8_t> left_;     ///< how it was reached after a run along its own column
  std::vector<int> runStart_;          ///< per node: where its run down (0) and up (1) began
  std::vector<float> arrivalScore_;    ///< of the current column only
};

}  // namespace detent::importer::trace
