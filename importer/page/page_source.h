// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Interface to the two kinds of files behind a Document: pictures, and PDF or SVG. Private to importer/page.

#include <memory>
#include <string>
#include <vector>

#include "importer/page/page.h"
#include "importer/page/progress.h"

namespace detent::importer {

using Bytes = std::vector<unsigned char>;

/// One opened file. Shares the bytes with its Document; answers as the functions of Document of the same
/// name, which have already checked page numbers and regions (number in 1..pageCount(), region finite, turns
/// 0..3).
class PageSource {
 public:
  virtual ~PageSource() = default;
  virtual int pageCount() const = 0;
  virtual Result<Page> page(int number, const Progress& progress) = 0;
  virtual Result<PageView> view(const Page& page, const Box& region, int quarterTurns,
                                const ViewOptions& options, const Homography& levelToPage,
                                const Progress& progress) = 0;
};

/// The file that an opener receives.
struct SourceFile {
  std::shared_ptr<const Bytes> bytes;
  std::string name;
  PageLimits limits;
  double pdfUnits =
      0;  ///< for an SVG that was converted to PDF: PDF units per page unit; 0 for any other file
};

using OpenedSource = Result<std::unique_ptr<PageSource>>;

/// png, jpg, bmp, tiff, webp, gif. In builds with MuPDF also bmp.
OpenedSource openPictureSource(const SourceFile& file);
/// bmp.
OpenedSource openBmpSource(const SourceFile& file);
/// pdf.
OpenedSource openPdfSource(const SourceFile& file);
/// svg.
OpenedSource openSvgSource(const SourceFile& file);

/// unreadableInput about this file.
Failure unreadable(const std::string& name, Message place, Message problem, Remedies remedies);

}  // namespace detent::importer
