// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Prepares an SVG file as XML that librsvg draws like a browser.

#include <functional>
#include <string>
#include <string_view>

namespace detent::importer::svg {

struct Drawing {
  std::string xml;          ///< UTF-8, without a document type; empty if refused
  int leftOut = 0;          ///< number of references to other files and of HTML parts, which are not drawn
  std::string withoutFont;  ///< letters that no font has, each once, UTF-8; they are drawn as boxes
  std::string undrawn;     ///< first feature that browsers draw differently: "translate", ":has", "<animate>"
  bool rasters = false;    ///< uses masks
  bool truncated = false;  ///< refused: it ends too early
  std::string problem;     ///< refused: why
};

/// Any bytes. `hasFont`: returns true if the letter can be drawn.
Drawing readDrawing(std::string_view bytes, const std::function<bool(char32_t)>& hasFont);

}  // namespace detent::importer::svg
