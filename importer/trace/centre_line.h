// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// From a coarse path to the sub-pixel centre line. The line is drawn with its width, blur and concealment
// along the present estimate, compared with the picture, and moved sideways until both agree. This corrects
// corners, ends and half-hidden stretches; fully hidden stretches follow the line that covers them.

#include <vector>

#include "importer/trace/follow_curve.h"

namespace detent::importer::trace {

/// Drawing model of the line: a box of `width_px` blurred by a box of `blur_px`; `level` is the coverage of
/// its middle.
struct LineProfile {
  double width_px = 1;
  double blur_px = 1;

  /// Coverage at a distance from the centre line, 0..1.
  double at(double distance_px) const;
  double reach_px() const { return 0.5 * (width_px + blur_px); }
};

struct CentreLine {
  std::vector<Point> points;   ///< area pixels, in order, about one pixel apart
  std::vector<double> weight;  ///< 0..1 per point: share of the line that was visible there
  LineProfile profile;
  double seenShare = 0;  ///< mean weight
};

struct CentreLineOptions {
  int centroidRounds = 2;  ///< coarse to about half a pixel
  int matchRounds = 2;     ///< rounds of comparing the drawn line with the picture
};

CentreLine centreLine(const CurveField& field, const CoarseCurve& coarse, double thickness_px,
                      const CentreLineOptions& options = {});

}  // namespace detent::importer::trace
