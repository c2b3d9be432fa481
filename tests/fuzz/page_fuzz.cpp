// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes, as if they were a file: open, read the first page, view a part of it. Nothing may crash, hang or
// leak.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "importer/page/document.h"

using namespace detent::importer;

namespace {

/// Small, so that a run tries many inputs; the limits themselves are thereby tried too.
PageLimits fuzzLimits() {
  PageLimits limits;
  limits.maxMegapixels = 2;
  limits.maxPages = 50;
  limits.maxFileMegabytes = 1;
  limits.maxPathPoints = 20000;
  limits.maxPageSeconds = 2;
  limits.maxDocumentMegabytes = 128;
  return limits;
}

void readPartsOf(const Document& document, const Page& page) {
  const Box whole{0, 0, page.width, page.height};
  const Box part{page.width * 0.2, page.height * 0.3, page.width * 0.9, page.height * 0.8};
  ViewOptions options;
  options.minFrameWidth_px = 200;
  static_cast<void>(document.view(page, part, 1, options));
  static_cast<void>(document.view(page, whole, 2, options));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto document =
      Document::fromBytes(std::vector<unsigned char>(data, data + size), "fuzz", fuzzLimits());
  if (!document) return 0;
  for (const int number : {1, document->pageCount()}) {
    const auto page = document->page(number);
    if (page) readPartsOf(*document, *page);
  }
  return 0;
}
