// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What MuPDF's SVG interpreter leaves out, written into the drawing before it sees it: style sheets, text
// anchors inherited from groups. And what would keep it busy for ever.
// docs/develop/decisions/0302-svg-is-prepared-for-mupdf.md. Private to importer/page.

#include <optional>
#include <string>
#include <string_view>

namespace detent::importer {

struct PreparedSvg {
  std::string text;        ///< the drawing, ready for MuPDF; empty if refused
  bool truncated = false;  ///< it ends inside a tag, or before the drawing is closed; refused
  std::string problem;     ///< why it is refused: "it nests elements 100000 deep"
};

/// `maxElements`: bound on the elements drawn after all references are followed (SVG bombs). Any bytes.
/// Style sheet selectors: *, type, .class, #id, type.class; of a chain ("g .c") only the last part is
/// compared.
PreparedSvg prepareSvg(std::string_view svg, double maxElements);

}  // namespace detent::importer
