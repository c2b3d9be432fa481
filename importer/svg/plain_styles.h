// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Rewrites style sheets for librsvg 2.54, which skips media queries and does not support variables, nested
// rules and layers.

#include <algorithm>
#include <map>
#include <string>
#include <string_view>

#include "model/text.h"

namespace detent::importer::svg {

/// Passes name and value of each declaration of a list ("stroke:red; opacity:0"), trimmed, to `take` until it
/// returns true.
template <class Take>
void forEachDeclaration(std::string_view list, const Take& take) {
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(';'), list.size());
    const std::string_view one = list.substr(0, end);
    list.remove_prefix(std::min(end + 1, list.size()));
    const std::size_t colon = one.find(':');
    if (colon != std::string_view::npos &&
        take(trimmed(one.substr(0, colon)), trimmed(one.substr(colon + 1))))
      return;
  }
}

/// Values of the custom properties of a drawing, by name ("--name").
/// The first value of a name counts; later ones are for dark screens.
using Variables = std::map<std::string, std::string, std::less<>>;

struct PlainStyles {
  std::string css;
  int imports = 0;        ///< style sheets outside the file, which are not loaded
  bool animates = false;  ///< has @keyframes
};

/// Returns true if a media query list applies to a light screen of any width.
bool mediaApply(std::string_view queries);

/// Applies media rules: rules for other media are removed, those for screens are unwrapped. Other at-rules
/// are removed. Nested rules are expanded, layers are put in their order, and :is() and :where() become
/// selector lists.
PlainStyles plainStyles(std::string_view css);

/// Adds the variables declared in a style sheet or a style attribute.
void addVariables(std::string_view declarations, Variables& to);

/// The text with var(), light-dark(), oklch(), oklab() and lengths in rem replaced by their values.
std::string withValues(std::string text, const Variables& variables);

}  // namespace detent::importer::svg
