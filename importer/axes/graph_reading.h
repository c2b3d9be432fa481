// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the steps of reading one graph share: the view, where its ink is, and what was read so far.

#include <vector>

#include <opencv2/core/mat.hpp>

#include "importer/axes/axis_calibration.h"
#include "importer/axes/read_text.h"

namespace detent::importer {

class GraphReading {
 public:
  /// View and frame must outlive it.
  GraphReading(const PageView& view, const PlotFrame& frame);

  const PageView& view;
  const PlotFrame& frame;
  Box box;           ///< of the frame
  cv::Mat darkness;  ///< of the view
  std::vector<Box>
      glyphs;  ///< blobs outside the frame, up to the size of large letters; ticks are no part of them
  TextReader reader;
  std::vector<SeenText> texts;  ///< lines read from pixels, certain enough to be of use to others

  double largestGlyph_px() const;

  /// Lines of writing in a region, read from pixels, nearest to `towards` first. `angle_deg` 0 or 90.
  std::vector<SeenText> readLines(const Box& region, double angle_deg, Point towards, std::size_t atMost);

  /// Labels that were read take part in no other line of writing.
  void setAside(const std::vector<Box>& words);

  /// The document's own texts whose middle lies in the region.
  std::vector<SeenText> ownTexts(const Box& region) const;
};

}  // namespace detent::importer
