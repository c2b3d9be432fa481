// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/svg/plain_styles.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <utility>
#include <vector>

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

/// Index behind the bracket that closes the one at `open`; the text's size if it is never closed.
std::size_t behindBracket(std::string_view text, std::size_t open, char opens, char closes) {
  int depth = 0;
  for (std::size_t i = open; i < text.size(); ++i) {
    depth += (text[i] == opens) - (text[i] == closes);
    if (depth == 0) return i + 1;
  }
  return text.size();
}

/// The parts between commas outside brackets, trimmed.
std::vector<std::string> listed(std::string_view text) {
  std::vector<std::string> parts(1);
  int depth = 0;
  for (const char c : text) {
    depth += (c == '(' || c == '[') - (c == ')' || c == ']');
    if (c == ',' && depth == 0)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  for (std::string& part : parts) part = std::string(trimmed(part));
  return parts;
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
  if (trimmed(queries).empty()) return true;
  const auto applies = [](const std::string& query) { return !query.empty() && queryApplies(query); };
  return std::ranges::any_of(listed(lowered(queries)), applies);
}

namespace {

/// Expands :is() and :where() in one selector: one selector for each of their arguments.
std::vector<std::string> writtenOut(const std::string& selector) {
  constexpr std::size_t mostSelectors = 256;  // nested lists multiply
  std::vector<std::string> open{selector}, out;
  while (!open.empty() && open.size() + out.size() < mostSelectors) {
    const std::string one = std::move(open.back());
    open.pop_back();
    std::size_t at = std::string::npos, bracket = 0;
    for (const std::string_view call : {":is(", ":where("})
      if (const std::size_t found = one.find(call); found < at) at = found, bracket = found + call.size() - 1;
    if (at == std::string::npos) {
      out.push_back(one);
      continue;
    }
    const std::size_t end = behindBracket(one, bracket, '(', ')');
    for (const std::string& argument : listed(one.substr(bracket + 1, end - bracket - 2)))
      open.push_back(one.substr(0, at) + argument + one.substr(end));
  }
  return out;
}

class StyleWriter {
 public:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  PlainStyles take() {
    PlainStyles out;
    for (const auto& [name, css] : layers_) out.css += css;
    out.css += unlayered_;
    out.imports = imports_;
    out.animates = animates_;
    return out;
  }

  /// `parents`: the selectors that nested rules belong to. `layer`: an index into layers_, or `none`.
  void write(std::string_view css, const std::vector<std::string>& parents, std::size_t layer) {
    constexpr int mostNested = 32;
    if (++depth_ > mostNested) css = {};
    std::string declarations;
    while (!(css = trimmed(css)).empty()) {
      const std::size_t block = std::min(css.find('{'), css.size());
      const std::size_t statement = css.find(';');
      if (statement < block || block == css.size()) {
        const std::string_view one = css.substr(0, std::min(statement, css.size()));
        if (one.starts_with('@'))
          noteStatement(one);
        else
          declarations.append(one).append(";");
        css.remove_prefix(std::min(one.size() + 1, css.size()));
        continue;
      }
      const std::size_t end = behindBracket(css, block, '{', '}');
      const std::string_view prelude = trimmed(css.substr(0, block));
      const std::string_view inside = css.substr(block + 1, end - std::min(end, block + 2));
      emit(parents, std::exchange(declarations, {}), layer);
      if (prelude.starts_with('@'))
        writeAtRule(prelude, inside, parents, layer);
      else
        write(inside, selectorsOf(prelude, parents), layer);
      css.remove_prefix(end);
    }
    emit(parents, declarations, layer);
    --depth_;
  }

 private:
  void noteStatement(std::string_view statement) {
    imports_ += statement.starts_with("@import");
    if (statement.starts_with("@layer"))
      for (const std::string& name : listed(statement.substr(6))) layerCalled(name);
  }

  void writeAtRule(std::string_view prelude, std::string_view inside, const std::vector<std::string>& parents,
                   std::size_t layer) {
    animates_ = animates_ || prelude.find("keyframes") != std::string_view::npos;
    if (prelude.starts_with("@layer"))
      write(inside, parents, layerCalled(std::string(trimmed(prelude.substr(6)))));
    else if (prelude.starts_with("@media") ? mediaApply(prelude.substr(6)) : prelude.starts_with("@supports"))
      write(inside, parents, layer);
  }

  static std::vector<std::string> selectorsOf(std::string_view prelude,
                                              const std::vector<std::string>& parents) {
    std::vector<std::string> out;
    for (const std::string& one : listed(prelude)) {
      if (parents.empty()) {
        for (std::string& plain : writtenOut(one)) out.push_back(std::move(plain));
        continue;
      }
      for (const std::string& parent : parents) {
        std::string whole = one.find('&') == std::string::npos ? "& " + one : one;
        for (std::size_t at = whole.find('&'); at != std::string::npos;
             at = whole.find('&', at + parent.size()))
          whole.replace(at, 1, parent);
        for (std::string& plain : writtenOut(whole)) out.push_back(std::move(plain));
      }
    }
    return out;
  }

  std::size_t layerCalled(const std::string& name) {
    const auto known = std::ranges::find(layers_, name, [](const auto& layer) { return layer.first; });
    if (!name.empty() && known != layers_.end()) return static_cast<std::size_t>(known - layers_.begin());
    layers_.emplace_back(name, "");
    return layers_.size() - 1;
  }

  /// Writes one rule per selector, because librsvg drops a list if it does not know one of its selectors.
  void emit(const std::vector<std::string>& selectors, const std::string& declarations, std::size_t layer) {
    if (declarations.empty()) return;
    std::string& to = layer == none ? unlayered_ : layers_[layer].second;
    for (const std::string& selector : selectors)
      to.append(selector).append("{").append(declarations).append("}\n");
  }

  std::vector<std::pair<std::string, std::string>> layers_;  ///< name and rules, weakest first
  std::string unlayered_;                                    ///< stronger than any layer
  int imports_ = 0;
  bool animates_ = false;
  int depth_ = 0;
};

}  // namespace

PlainStyles plainStyles(std::string_view source) {
  const std::string text = withoutComments(source);
  std::string_view css = text;
  for (const std::string_view wrapper : {"<!--", "<![CDATA["})
    if (trimmed(css).starts_with(wrapper)) css = trimmed(css).substr(wrapper.size());
  StyleWriter writer;
  writer.write(css, {}, StyleWriter::none);
  return writer.take();
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

/// Replaces each call of a function by `valueOf` its arguments; inner calls are replaced first.
template <class ValueOf>
void replaceCalls(std::string& text, std::string_view call, const ValueOf& valueOf) {
  constexpr int mostCalls = 64;  // a variable may refer to itself
  for (int i = 0; i < mostCalls; ++i) {
    const std::size_t at = text.rfind(call);
    if (at == std::string::npos) return;
    const std::size_t end = behindBracket(text, at + call.size() - 1, '(', ')');
    const std::string inside = text.substr(at + call.size(), end - at - call.size() - 1);
    text.replace(at, end - at, valueOf(inside));
  }
}

/// The arguments up to the first comma outside brackets, and the rest.
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

/// The sRGB colour of "L C H / A" (oklch) or "L a b / A" (oklab), which librsvg does not know; empty where it
/// cannot be read. Source: B. Ottosson, A perceptual color space for image processing, 2020; CSS Color 4, 9.
std::string colourOfOklab(std::string_view arguments, bool polar) {
  constexpr double greatestChroma = 0.4;  // 100 %
  std::array<double, 4> values{0, 0, 0, 1};
  std::string text(arguments);
  std::ranges::replace(text, '/', ' ');
  const char* at = text.c_str();
  std::size_t count = 0;
  for (char* past = nullptr; count < values.size(); at = past, ++count) {
    const double value = std::strtod(at, &past);
    if (past == at) break;
    values[count] = value;
    if (*past == '%') values[count] *= (count == 1 || count == 2 ? greatestChroma : 1) / 100, ++past;
    if (std::string_view(past).starts_with("deg")) past += 3;
  }
  if (count < 3 || !std::ranges::all_of(trimmed(at), isBlank)) return {};
  const double lightness = values[0], hue = values[2] * std::numbers::pi / 180;
  const double a = polar ? values[1] * std::cos(hue) : values[1];
  const double b = polar ? values[1] * std::sin(hue) : values[2];
  const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
  const std::array linear{4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
                          -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                          -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
  std::string colour = "rgba(";
  for (const double channel : linear) {
    const double encoded =
        channel <= 0.0031308 ? 12.92 * channel : 1.055 * std::pow(channel, 1 / 2.4) - 0.055;
    colour += std::to_string(std::lround(255 * std::clamp(encoded, 0.0, 1.0))) + ",";
  }
  return colour + std::to_string(std::clamp(values[3], 0.0, 1.0)) + ")";
}

}  // namespace

std::string withValues(std::string text, const Variables& variables) {
  replaceCalls(text, "var(", [&](const std::string& inside) {
    const auto [name, otherwise] = splitAtComma(inside);
    const auto known = variables.find(name);
    return known != variables.end() ? known->second : otherwise;
  });
  for (const bool polar : {true, false}) {
    const std::string_view call = polar ? "oklch(" : "oklab(";
    replaceCalls(text, call, [&](const std::string& inside) {
      const std::string colour = colourOfOklab(inside, polar);
      return colour.empty() ? std::string(call) + inside + ")" : colour;
    });
  }
  replaceCalls(text, "light-dark(", [](const std::string& inside) { return splitAtComma(inside).first; });
  replaceRootLengths(text);
  return text;
}

}  // namespace detent::importer::svg
