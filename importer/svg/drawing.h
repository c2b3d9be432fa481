// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// An SVG file as XML that librsvg draws like a browser.

#include <functional>
#include <string>
#include <string_view>

namespace detent::importer::svg {

struct Drawing {
  std::string xml;          ///< UTF-8, without a document type; empty if refused
  int leftOut = 0;          ///< references to other files, and HTML: neither is drawn
  std::string withoutFont;  ///< letters that no font has, once each, UTF-8; boxes stand for them
  std::string undrawn;     ///< the first thing that browsers show otherwise: "translate", ":has", "<animate>"
  bool rasters = false;    ///< uses masks
  bool truncated = false;  ///< refused: it ends too early
  std::string problem;     ///< refused: why
};

/// Any bytes. `hasFont`: returns true if the letter can be drawn.
Drawing readDrawing(std::string_view bytes, const std::function<bool(char32_t)>& hasFont);

}  // namespace detent::importer::svg
