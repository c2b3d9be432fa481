// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/svg/undrawn.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "importer/svg/plain_styles.h"
#include "model/text.h"

namespace detent::importer::svg {
namespace {

constexpr std::array drawnFunctions{"matrix", "translate", "translatex", "translatey", "scale", "scalex",
                                    "scaley", "rotate",    "skewx",      "skewy",      "skew"};
// Properties that move a curve or replace it.
constexpr std::array movingProperties{"translate", "rotate", "scale",      "offset-path",
                                      "offset",    "d",      "perspective"};
constexpr std::array colourFunctions{"oklch(", "lch(", "oklab(", "lab(", "color(", "color-mix("};
constexpr std::array drawnPseudoClasses{
    "first-child", "last-child",  "only-child", "first-of-type", "last-of-type",     "only-of-type",
    "nth-child",   "nth-of-type", "root",       "empty",         "nth-last-of-type", "nth-last-child",
    "not",         "link",        "lang",       "visited",       "any-link"};
/// Pseudo-classes that apply only to a drawing with which somebody interacts.
constexpr std::array touchedPseudoClasses{"hover",         "active", "focus",   "focus-within",
                                          "focus-visible", "target", "checked", "disabled"};

bool isOneOf(const auto& list, std::string_view word) { return std::ranges::find(list, word) != list.end(); }

bool isWordLetter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

std::string_view wordAt(std::string_view text, std::size_t begin) {
  std::size_t end = begin;
  while (end < text.size() && isWordLetter(text[end])) ++end;
  return text.substr(begin, end - begin);
}

bool isNone(std::string_view value) { return value.empty() || value == "none" || value == "initial"; }

/// A function or unit that librsvg does not know; it then ignores the whole list.
std::string undrawnTransform(std::string_view value) {
  if (value.find('%') != std::string_view::npos) return "transform: %";
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (!isWordLetter(value[i]) || value[i] == '-') continue;
    const std::string_view word = wordAt(value, i);
    const std::size_t end = i + word.size();
    if (end < value.size() && value[end] == '(') {
      if (!isOneOf(drawnFunctions, word)) return "transform: " + std::string(word) + "()";
    } else if (word.ends_with("turn")) {
      return "transform: turn";
    }
    i = end;
  }
  return {};
}

/// Empty if librsvg draws the declaration; else the name to report.
std::string undrawnPart(std::string_view name, std::string_view value, bool animates) {
  const auto calls = [&](std::string_view call) { return value.find(call) != std::string_view::npos; };
  const auto named = [&](bool undrawn) { return undrawn ? std::string(name) : std::string(); };
  if (name == "transform") return undrawnTransform(value);
  if (isOneOf(movingProperties, name)) return named(!isNone(value));
  if (name == "content-visibility") return named(value == "hidden");
  if (name == "clip-path") return named(calls("(") && !value.starts_with("url("));
  if (name == "mask") return named(calls("gradient("));
  if (name == "mask-image" || name.starts_with("-webkit-mask")) return named(!isNone(value));
  if (name == "filter") return named(calls("opacity("));
  if (name == "animation" || name == "animation-name") return named(animates && !isNone(value));
  if (name.ends_with("opacity") || name == "display" || name == "visibility") return named(calls("("));
  if (name == "stroke" || name == "fill" || name == "color")
    for (const std::string_view call : colourFunctions)
      if (calls(call)) return std::string(name) + ": " + std::string(call) + ")";
  return {};
}

bool decidesWhatIsSeen(std::string_view declarations) {
  for (const std::string_view word :
       {"display", "visibility", "opacity", "stroke", "fill", "transform", "clip"})
    if (declarations.find(word) != std::string_view::npos) return true;
  return false;
}

/// Returns true if every class, id and element that a selector names is in the drawing.
bool canApply(std::string_view selector, const ElementNames& names) {
  for (std::size_t i = 0; i < selector.size();) {
    const char c = selector[i];
    if (c == '[' || c == '(') {
      i = std::min(selector.find(c == '[' ? ']' : ')', i), selector.size());
    } else if (c == ':') {
      i += 1 + wordAt(selector, i + 1).size();
    } else if (c == '.' || c == '#') {
      const std::string_view word = wordAt(selector, i + 1);
      if (!names.contains(c + std::string(word))) return false;
      i += 1 + word.size();
    } else if (isWordLetter(c)) {
      const std::string_view word = wordAt(selector, i);
      if (!names.contains(word)) return false;
      i += word.size();
    } else {
      ++i;
    }
  }
  return true;
}

enum class Understanding { known, neverApplies, unknown };

Understanding understandingOf(std::string_view selector, std::string& pseudoClass) {
  for (std::size_t at = selector.find(':'); at != std::string_view::npos; at = selector.find(':', at + 1)) {
    if (at > 0 && selector[at - 1] == '\\') continue;
    if (at + 1 < selector.size() && selector[at + 1] == ':') return Understanding::neverApplies;
    const std::string word = lowered(wordAt(selector, at + 1));
    if (isOneOf(touchedPseudoClasses, word)) return Understanding::neverApplies;
    const std::size_t end = at + 1 + word.size();
    const bool ofKind = word.starts_with("nth-") && selector.find(" of ", end) < selector.find(')', end);
    if (isOneOf(drawnPseudoClasses, word) && !ofKind) continue;
    pseudoClass = ":" + word;
    return Understanding::unknown;
  }
  return Understanding::known;
}

}  // namespace

std::string undrawnProperty(std::string_view declarations, bool animates) {
  std::string part;
  forEachDeclaration(declarations, [&](std::string_view name, std::string_view value) {
    part = undrawnPart(lowered(name), lowered(value), animates);
    return !part.empty();
  });
  return part;
}

std::string undrawnRule(std::string_view css, bool animates, const ElementNames& names) {
  while (!css.empty()) {
    const std::size_t open = std::min(css.find('{'), css.size());
    const std::size_t close = std::min(css.find('}', open), css.size());
    const std::string_view selector = trimmed(css.substr(0, open));
    const std::string_view declarations =
        css.substr(std::min(open + 1, close), close - std::min(open + 1, close));
    css.remove_prefix(std::min(close + 1, css.size()));
    std::string pseudoClass;
    const Understanding understanding = understandingOf(selector, pseudoClass);
    if (understanding == Understanding::neverApplies || !canApply(selector, names)) continue;
    if (std::string name = undrawnProperty(declarations, animates); !name.empty()) return name;
    if (understanding == Understanding::unknown && decidesWhatIsSeen(declarations)) return pseudoClass;
  }
  return {};
}

}  // namespace detent::importer::svg
