// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Style sheets as librsvg 2.54 reads them: it skips media queries and knows no variables, nested rules and
// layers.

#include <map>
#include <string>
#include <string_view>

namespace detent::importer::svg {

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
