// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Style sheets as librsvg 2.54 reads them: it skips media queries and knows no variables, nested rules and
// layers.

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

/// Rules for other media are left out, those for screens stand for themselves; other at-rules are left out.
/// Nested rules are written out, layers are put in their order, and :is() and :where() become lists.
PlainStyles plainStyles(std::string_view css);

/// Adds the variables declared in a style sheet or a style attribute.
void addVariables(std::string_view declarations, Variables& to);

/// The text with var(), light-dark(), oklch(), oklab() and lengths in rem replaced by what they stand for.
std::string withValues(std::string text, const Variables& variables);

}  // namespace detent::importer::svg
