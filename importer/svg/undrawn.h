// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// CSS and SVG that browsers show and librsvg 2.54 does not: such a drawing is refused instead of read
// wrongly.

#include <set>
#include <string>
#include <string_view>

namespace detent::importer::svg {

/// Names, classes and ids that the elements of a drawing have: "path", ".curve", "#press".
using ElementNames = std::set<std::string, std::less<>>;

/// The first property, function or unit of a list of declarations that moves, hides or colours a part in a
/// browser but not here; empty if none. `animates`: the drawing has keyframes.
std::string undrawnProperty(std::string_view declarations, bool animates);

/// The same of a plain style sheet: of rules that can apply to `names`; also selectors that are not
/// understood here.
std::string undrawnRule(std::string_view plainCss, bool animates, const ElementNames& names);

}  // namespace detent::importer::svg
