// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/svg/plain_styles.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>

#include "model/text.h"

namespace detent::importer::svg {
namespace {

std::string withoutComments(std::string_view css) {
  std::string out;
  while (!css.empty()) {
    const std::size_t begin = css.find("/*");
    out += css.substr(0, begin);
    if (begin == std::string_view::npos) break;
    const std::size_t end = css.find("*/", begin + 2);
    if (end == std::string_view::npos) break;
    css.remove_prefix(end + 2);
  }
  return out;
}

/// Index behind the bracket that closes the one at `open`; the text's size if none does.
std::size_t behindBracket(std::string_view text, std::size_t open, char opens, char closes) {
  int depth = 0;
  for (std::size_t i = open; i < text.size(); ++i) {
    depth += (text[i] == opens) - (text[i] == closes);
    if (depth == 0) return i + 1;
  }
  return text.size();
}

std::string lowerCase(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

bool featureApplies(std::string_view feature) {
  const std::size_t colon = std::min(feature.find(':'), feature.size());
  const std::string_view name = trimmed(feature.substr(0, colon));
  const std::string_view value = trimmed(feature.substr(std::min(colon + 1, feature.size())));
  if (name == "prefers-color-scheme") return value == "light";
  return name.starts_with("min-") || name == "width" || name == "height" || name == "color";
}

bool queryApplies(std::string_view query) {
  bool applies = true, negated = false;
  while (!(query = trimmed(query)).empty()) {
    if (query.front() == '(') {
      const std::size_t end = behindBracket(query, 0, '(', ')');
      applies = applies && end > 1 && featureApplies(query.substr(1, end - 2));
      query.remove_prefix(end);
      continue;
    }
    const std::size_t end = std::min(query.find_first_of(" \t\r\n("), query.size());
    const std::string_view word = query.substr(0, end);
    query.remove_prefix(end);
    if (word == "not")
      negated = true;
    else if (word != "only" && word != "and")
      applies = applies && (word == "all" || word == "screen");
  }
  return applies != negated;
}

}  // namespace

bool mediaApply(std::string_view queries) {
  const std::string lower = lowerCase(queries);
  std::string_view rest = trimmed(lower);
  if (rest.empty()) return true;
  while (!rest.empty()) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    if (queryApplies(rest.substr(0, comma))) return true;
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  return false;
}

PlainStyles plainStyles(std::string_view source) {
  PlainStyles plain;
  const std::string text = withoutComments(source);
  std::string_view css = text;
  for (const std::string_view wrapper : {"<!--", "<![CDATA["})
    if (trimmed(css).starts_with(wrapper)) css = trimmed(css).substr(wrapper.size());
  while (!(css = trimmed(css)).empty()) {
    const std::size_t block = std::min(css.find('{'), css.size());
    if (css.front() != '@') {
      const std::size_t end = behindBracket(css, block, '{', '}');
      plain.css.append(css.substr(0, end)).append("\n");
      css.remove_prefix(end);
      continue;
    }
    if (const std::size_t statement = css.find(';'); statement < block) {
      plain.imports += css.starts_with("@import");
      css.remove_prefix(statement + 1);
      continue;
    }
    const std::size_t end = behindBracket(css, block, '{', '}');
    const std::string_view prelude = css.substr(0, block);
    const bool applies = prelude.starts_with("@media")
                             ? mediaApply(prelude.substr(6))
                             : prelude.starts_with("@supports") || prelude.starts_with("@layer");
    if (applies && end > block + 1) {
      PlainStyles inner = plainStyles(css.substr(block + 1, end - block - 2));
      plain.css += inner.css;
      plain.imports += inner.imports;
    }
    css.remove_prefix(end);
  }
  return plain;
}

void addVariables(std::string_view text, Variables& to) {
  for (std::size_t at = text.find("--"); at != std::string_view::npos; at = text.find("--", at + 2)) {
    const bool begins = at == 0 || text[at - 1] == ';' || text[at - 1] == '{' || isBlank(text[at - 1]);
    const std::size_t colon = text.find_first_of(":;{}()", at);
    if (!begins || colon == std::string_view::npos || text[colon] != ':') continue;
    const std::size_t end = std::min(text.find_first_of(";}", colon), text.size());
    to.emplace(trimmed(text.substr(at, colon - at)), trimmed(text.substr(colon + 1, end - colon - 1)));
    at = colon;
  }
}

namespace {

/// Replaces each call of a function by what `valueOf` makes of its arguments; inner calls come first.
template <class ValueOf>
void replaceCalls(std::string& text, std::string_view call, const ValueOf& valueOf) {
  constexpr int mostCalls = 64;  // a variable may name itself
  for (int i = 0; i < mostCalls; ++i) {
    const std::size_t at = text.rfind(call);
    if (at == std::string::npos) return;
    const std::size_t end = behindBracket(text, at + call.size() - 1, '(', ')');
    const std::string inside = text.substr(at + call.size(), end - at - call.size() - 1);
    text.replace(at, end - at, valueOf(inside));
  }
}

/// The arguments up to the first comma outside brackets, and what follows it.
std::pair<std::string, std::string> splitAtComma(std::string_view arguments) {
  int depth = 0;
  const auto comma = std::ranges::find_if(arguments, [&](char c) {
    depth += (c == '(') - (c == ')');
    return depth == 0 && c == ',';
  });
  const auto length = static_cast<std::size_t>(comma - arguments.begin());
  return {std::string(trimmed(arguments.substr(0, length))),
          std::string(trimmed(arguments.substr(std::min(length + 1, arguments.size()))))};
}

void replaceRootLengths(std::string& text) {
  constexpr double root_px = 16;
  for (std::size_t unit = text.find("rem"); unit != std::string::npos; unit = text.find("rem", unit + 1)) {
    std::size_t begin = unit;
    while (begin > 0 && (std::isdigit(static_cast<unsigned char>(text[begin - 1])) || text[begin - 1] == '.'))
      --begin;
    if (begin == unit || (unit + 3 < text.size() && std::isalnum(static_cast<unsigned char>(text[unit + 3]))))
      continue;
    char pixels[32];
    std::snprintf(pixels, sizeof pixels, "%.6gpx", root_px * std::strtod(text.c_str() + begin, nullptr));
    text.replace(begin, unit + 3 - begin, pixels);
  }
}

}  // namespace

std::string withValues(std::string text, const Variables& variables) {
  replaceCalls(text, "var(", [&](const std::string& inside) {
    const auto [name, otherwise] = splitAtComma(inside);
    const auto known = variables.find(name);
    return known != variables.end() ? known->second : otherwise;
  });
  replaceCalls(text, "light-dark(", [](const std::string& inside) { return splitAtComma(inside).first; });
  replaceRootLengths(text);
  return text;
}

}  // namespace detent::importer::svg
