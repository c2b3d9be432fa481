// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Data shared by the steps of reading one graph: the view, its dark pixels, and the results so far.

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
  Box box;           ///< box of the frame
  cv::Mat darkness;  ///< of the view
  cv::Mat darkMask;  ///< dark pixels of the view, frame and ticks included: 255, else 0
  std::vector<Box>
      glyphs;  ///< blobs outside the frame, up to the size of large letters; ticks are no part of them
  TextReader reader;
  std::vector<SeenText> texts;  ///< lines read from pixels, certain enough to be of use to others

  double largestGlyph_px() const;

  /// Lines of writing in a region, read from pixels, nearest to `towards` first. `angle_deg` 0, 90 or -90.
  std::vector<SeenText> readLines(const Box& region, double angle_deg, Point towards, std::size_t atMost);

  /// The same for words inside the plot that touch no other mark.
  std::vector<SeenText> readLinesInside(const Box& region, double angle_deg, Point towards,
                                        std::size_t atMost);

  /// The same for scripts whose letters consist of parts above one another: what readLines took for two lines
  /// is read as one. Empty if no two lines lie that way.
  std::vector<SeenText> readLinesOfParts(const Box& region, double angle_deg, Point towards,
                                         std::size_t atMost);

  /// Leaves labels that were already read out of all further lines of writing.
  void setAside(const std::vector<Box>& words);

  /// The document's own texts whose middle lies in the region.
  std::vector<SeenText> ownTexts(const Box& region) const;

 private:
  std::vector<SeenText> read(std::vector<Box> lines, const std::vector<Box>& letters, double angle_deg,
                             Point towards, std::size_t atMost);
};

}  // namespace detent::importer
