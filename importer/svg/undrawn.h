// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Detects CSS and SVG features that browsers draw and librsvg 2.54 does not. Such a drawing is refused,
// because it would be read wrongly.

#include <set>
#include <string>
#include <string_view>

namespace detent::importer::svg {

/// Names, classes and ids that the elements of a drawing have: "path", ".curve", "#press".
using ElementNames = std::set<std::string, std::less<>>;

/// The first property, function or unit of a list of declarations by which a browser would move, hide or
/// colour a part differently than librsvg; empty if none. `animates`: the drawing has keyframes.
std::string undrawnProperty(std::string_view declarations, bool animates);

/// The same for the rules of a plain style sheet that can apply to `names`. Also returns selectors that
/// cannot be interpreted.
std::string undrawnRule(std::string_view plainCss, bool animates, const ElementNames& names);

}  // namespace detent::importer::svg
