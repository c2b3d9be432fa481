// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Step 1: from a file to pages. In: png, jpg, bmp, tiff, webp, gif, pdf, svg. Out: an upright `Page` (vector
// paths, text boxes, overview raster) and, for any region of it, a `PageView`: the same things at the best
// resolution the page has.
//
// Two planes:
//  - *page units*: pixels of the picture as shown (after EXIF rotation), or PDF points; origin top left,
//    y down. For pictures page units are pixel centres: the centre of the top left pixel is (0,0).
//  - *view pixels*: pixels of a PageView's raster; (0,0) is the centre of its top left pixel. All later steps
//    work there.

#include <optional>
#include <string>
#include <vector>

#include "importer/page/findings.h"
#include "importer/page/raster.h"

namespace detent::importer {

enum class PageUnit { pixel, point };

/// A piece of text as the document itself states it (never OCR).
struct TextBox {
  std::string utf8;
  Box box;
  double angle_deg = 0;  ///< angle of the baseline, counter-clockwise; 90 = reads upwards
};

/// One stroked and/or filled path, flattened to polylines within 0.005 page units; clipped invisible ones are
/// left out.
struct VectorPath {
  std::vector<std::vector<Point>> polylines;
  std::vector<bool> closed;   ///< per polyline
  std::optional<Rgb> stroke;  ///< colour if stroked and visible
  std::optional<Rgb> fill;    ///< colour if filled and visible
  double strokeWidth = 0;     ///< in the plane's units, 0 if not stroked
  bool dashed = false;
  Box box;
  std::optional<Box> clip;  ///< bounding box of the clip in force, if it cuts the path
};

/// An image placed on the page.
struct PlacedImage {
  Box box;                          ///< on the page
  int width_px = 0, height_px = 0;  ///< size in the image's own pixels
};

/// Content of one page. Coordinates in page units.
struct Page {
  std::string source;  ///< file name without folder, for messages
  int number = 1, count = 1;
  PageUnit unit = PageUnit::pixel;
  double width = 0, height = 0;
  std::optional<double> dpi;  ///< resolution of a picture, if its file states it
  std::vector<TextBox> texts;
  std::vector<VectorPath> paths;
  std::vector<PlacedImage> images;
  std::vector<Remark> remarks;  ///< parts of the page that could not be read
  Raster overview;  ///< the whole page; pictures: the picture itself, documents: a render for finding graphs
  Affine overviewToPage;
};

/// A region of the page, turned upright, at the best resolution available: the native pixels of the picture
/// or of the one embedded image that fills the region, else a render. Coordinates of texts and paths in view
/// pixels.
struct PageView {
  Raster raster;
  Homography viewToPage;  ///< affine but for photographs
  std::vector<TextBox> texts;
  std::vector<VectorPath> paths;
  bool nativePixels = false;  ///< raster is what the document stores, not a render
};

/// Limits against hostile input; all are options of `detent-import`.
struct PageLimits {
  double maxMegapixels = 300;  ///< limit of a decoded picture or a render
  int maxPages = 2000;         ///< most pages of a document
  double maxFileMegabytes = 512;
  int maxPathPoints = 4000000;  ///< points of one page; also bounds how many things it may draw
  /// limit of processor time for interpreting one document page, and for drawing it
  double maxPageSeconds = 20;
  double maxDocumentMegabytes = 1024;  ///< memory that reading a document may take, > 16
};

struct ViewOptions {
  double minFrameWidth_px = 1000;  ///< a rendered region is drawn so that it is about this wide; (0, 16384]
  double maxScale_px_per_unit = 16;

  bool operator==(const ViewOptions&) const = default;
};

}  // namespace detent::importer
