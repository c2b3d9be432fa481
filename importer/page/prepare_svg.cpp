// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/prepare_svg.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <map>
#include <vector>

#include "importer/page/clip_line.h"
#include "importer/page/polyline.h"
#include "importer/page/svg_geometry.h"
#include "model/text.h"

namespace detent::importer {
namespace {

constexpr std::size_t deepestNesting = 256;  // MuPDF recurses once per level

std::string_view withoutPrefix(std::string_view name) {
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

// ---- style sheets

using Declarations = std::map<std::string, std::string, std::less<>>;

void addDeclarations(std::string_view block, Declarations& to) {
  while (!block.empty()) {
    const std::size_t end = std::min(block.find(';'), block.size());
    const std::string_view one = block.substr(0, end);
    block.remove_prefix(std::min(block.size(), end + 1));
    const std::size_t colon = one.find(':');
    if (colon == std::string_view::npos) continue;
    std::string_view value = trimmed(one.substr(colon + 1));
    if (const std::size_t mark = value.find('!'); mark != std::string_view::npos)
      value = trimmed(value.substr(0, mark));
    const std::string_view name = trimmed(one.substr(0, colon));
    if (!name.empty() && !value.empty()) to[std::string(name)] = std::string(value);
  }
}

/// What one element is asked for: "text.major"; empty: any.
struct Compound {
  std::string type;
  std::vector<std::string> ids, classes;
  bool isChild = false;  ///< stands in the element before it, nothing between

  bool fits(std::string_view name, std::string_view id, std::string_view itsClasses) const {
    const auto has = [&](const std::string& wanted) {
      for (std::string_view rest = itsClasses; !(rest = trimmed(rest)).empty();) {
        const std::size_t end = std::min(rest.find_first_of(" \t\r\n"), rest.size());
        if (rest.substr(0, end) == wanted) return true;
        rest.remove_prefix(end);
      }
      return false;
    };
    return (type.empty() || type == name) && std::ranges::all_of(classes, has) &&
           std::ranges::all_of(ids, [&](const std::string& wanted) { return wanted == id; });
  }
};

struct Rule {
  std::vector<Compound> path;  ///< outermost first; the last is the element itself
  int specificity = 0;
  Declarations declarations;
};

std::optional<Compound> compoundOf(std::string_view selector) {
  if (selector.empty() || selector.find_first_of("[:") != std::string_view::npos) return {};
  Compound compound;
  std::size_t mark = std::min(selector.find_first_of(".#"), selector.size());
  compound.type = std::string(selector.substr(0, mark));
  if (compound.type == "*") compound.type.clear();
  while (mark < selector.size()) {
    const std::size_t next = std::min(selector.find_first_of(".#", mark + 1), selector.size());
    (selector[mark] == '.' ? compound.classes : compound.ids)
        .emplace_back(selector.substr(mark + 1, next - mark - 1));
    mark = next;
  }
  return compound;
}

/// Of elements beside another (+, ~) only what stands last is known.
std::optional<Rule> ruleOf(std::string_view selector) {
  constexpr int ofId = 10000, ofClass = 100;  // types; no selector of a chart has so many
  Rule rule;
  bool isChild = false;
  while (!(selector = trimmed(selector)).empty()) {
    if (const char joint = selector.front(); joint == '>' || joint == '+' || joint == '~') {
      isChild = joint == '>';
      if (!isChild) rule.path.clear();
      selector.remove_prefix(1);
      continue;
    }
    const std::size_t end = std::min(selector.find_first_of(" \t\r\n>+~"), selector.size());
    auto compound = compoundOf(selector.substr(0, end));
    if (!compound) return {};
    compound->isChild = isChild;
    isChild = false;
    rule.specificity += ofId * static_cast<int>(compound->ids.size()) +
                        ofClass * static_cast<int>(compound->classes.size()) +
                        (compound->type.empty() ? 0 : 1);
    rule.path.push_back(std::move(*compound));
    selector.remove_prefix(end);
  }
  return rule.path.empty() ? std::nullopt : std::optional(std::move(rule));
}

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

/// Properties that a document names itself ("--ink: #333") are put aside; the first of a name counts: later ones are of dark screens.
void takeVariables(Declarations& from, Declarations& variables) {
  for (auto each = from.lower_bound("--"); each != from.end() && each->first.starts_with("--");) {
    std::string_view value = each->second;
    constexpr std::string_view either = "light-dark(";
    if (value.starts_with(either)) {
      int depth = 0;
      const auto ends = [&](char c) { return (depth += (c == '(') - (c == ')')) == 0 && c == ','; };
      value.remove_prefix(either.size());
      value = value.substr(0, static_cast<std::size_t>(std::ranges::find_if(value, ends) - value.begin()));
    }
    variables.emplace(each->first, value);
    each = from.erase(each);
  }
}

/// "var(--ink, black)" as what the document says it is.
std::string withVariables(std::string text, const Declarations& variables) {
  constexpr std::string_view call = "var(";
  constexpr int mostCalls = 16;  // one may name another, and itself
  for (int i = 0; i < mostCalls; ++i) {
    const std::size_t at = text.rfind(call), end = at == std::string::npos ? at : text.find(')', at);
    if (end == std::string::npos) break;
    const std::string inside = text.substr(at + call.size(), end - at - call.size());
    const std::size_t comma = std::min(inside.find(','), inside.size());
    const auto known = variables.find(trimmed(std::string_view(inside).substr(0, comma)));
    const std::string_view other =
        trimmed(std::string_view(inside).substr(std::min(comma + 1, inside.size())));
    text.replace(at, end + 1 - at, known != variables.end() ? known->second : std::string(other));
  }
  return text;
}

/// A size of letters in pixels: MuPDF knows parts of another size nowhere but in attributes. Empty for words ("larger").
std::optional<double> pixelsOf(const std::string& length, double outer_px) {
  constexpr double root_px = 16;
  const char* end = length.c_str();
  const double value = std::strtod(length.c_str(), const_cast<char**>(&end));
  const std::string_view unit = end;
  if (end == length.c_str() || !std::isfinite(value)) return {};
  if (unit == "rem") return root_px * value;
  if (unit == "em") return outer_px * value;
  if (unit == "%") return outer_px * value / 100;
  if (unit.empty() || unit == "px") return value;
  return {};
}

/// A colour that says how much of it covers: MuPDF draws such a one black. Without the last number, which is given back.
std::optional<std::string> takeAlpha(std::string& color) {
  if (color == "transparent") color = "rgba(0,0,0,0)";
  const std::size_t last = color.rfind(',');
  if (!color.starts_with("rgba(") || last == std::string::npos || color.back() != ')') return {};
  std::string alpha = color.substr(last + 1, color.size() - last - 2);
  color = "rgb(" + color.substr(5, last - 5) + ")";
  return alpha;
}

void addStyleSheet(std::string_view source, std::vector<Rule>& rules, Declarations& variables) {
  std::string text = withoutComments(source);
  for (std::size_t at = text.find("&gt;"); at != std::string::npos; at = text.find("&gt;", at))
    text.replace(at, 4, ">");
  std::string_view css = text;
  for (const std::string_view wrapper : {"<![CDATA[", "<!--"})
    if (trimmed(css).substr(0, wrapper.size()) == wrapper) css = trimmed(css).substr(wrapper.size());
  while (true) {
    const std::size_t open = css.find('{');
    if (open == std::string_view::npos) return;
    const std::size_t close = std::min(css.find('}', open), css.size());
    std::string_view selectors = trimmed(css.substr(0, open));
    Declarations declarations;
    addDeclarations(css.substr(open + 1, close - open - 1), declarations);
    takeVariables(declarations, variables);
    css.remove_prefix(std::min(css.size(), close + 1));
    if (!selectors.empty() && selectors.front() == '@') continue;
    while (!selectors.empty()) {
      const std::size_t comma = std::min(selectors.find(','), selectors.size());
      if (auto rule = ruleOf(selectors.substr(0, comma))) {
        rule->declarations = declarations;
        rules.push_back(std::move(*rule));
      }
      selectors.remove_prefix(std::min(selectors.size(), comma + 1));
    }
  }
}

// ---- tags

struct Attribute {
  std::string name, value;
  char quote = '"';

  /// A value from a style sheet may hold what would end it or its tag.
  std::string text() const {
    std::string out = name + "=" + quote;
    for (const char c : value) {
      if (c == quote)
        out += c == '"' ? "&quot;" : "&apos;";
      else if (c == '<')
        out += "&lt;";
      else
        out += c;
    }
    return out + quote;
  }
};

struct Tag {
  std::string name;
  std::vector<Attribute> attributes;
  bool closes = false, selfClosing = false;

  const std::string* find(std::string_view attribute) const {
    for (const Attribute& a : attributes)
      if (a.name == attribute) return &a.value;
    return nullptr;
  }
  void set(const std::string& attribute, const std::string& value) {
    for (Attribute& a : attributes)
      if (a.name == attribute) {
        a.value = value;
        return;
      }
    attributes.push_back({attribute, value});
  }
  std::string text() const {
    std::string out = closes ? "</" + name : "<" + name;
    for (const Attribute& a : attributes) out += " " + a.text();
    return out + (selfClosing ? "/>" : ">");
  }
};

/// `at` stands behind '<'; ends behind '>'. Nothing if the tag never ends.
std::optional<Tag> readTag(std::string_view svg, std::size_t& at) {
  Tag tag;
  const auto skipSpace = [&] {
    while (at < svg.size() && isBlank(svg[at])) ++at;
  };
  const auto readName = [&] {
    const std::size_t begin = at;
    while (at < svg.size() && !isBlank(svg[at]) && svg[at] != '=' && svg[at] != '>' && svg[at] != '/') ++at;
    return std::string(svg.substr(begin, at - begin));
  };
  if (at < svg.size() && svg[at] == '/') {
    tag.closes = true;
    ++at;
  }
  tag.name = readName();
  while (true) {
    skipSpace();
    if (at >= svg.size()) return std::nullopt;
    if (svg[at] == '>') {
      ++at;
      return tag;
    }
    if (svg[at] == '/') {
      tag.selfClosing = true;
      ++at;
      continue;
    }
    Attribute attribute;
    attribute.name = readName();
    skipSpace();
    if (attribute.name.empty()) {
      ++at;  // a stray '='
      continue;
    }
    if (at < svg.size() && svg[at] == '=') {
      ++at;
      skipSpace();
      if (at >= svg.size()) return std::nullopt;
      attribute.quote = svg[at];
      if (attribute.quote != '"' && attribute.quote != '\'') return std::nullopt;
      const std::size_t end = svg.find(attribute.quote, at + 1);
      if (end == std::string_view::npos) return std::nullopt;
      attribute.value = std::string(svg.substr(at + 1, end - at - 1));
      at = end + 1;
    }
    tag.attributes.push_back(std::move(attribute));
  }
}

/// A list of points up to its first error, where it ends (SVG 1.1, F.2). MuPDF would stay there for ever: it skips what separates
/// numbers and reads numbers, but goes past nothing else.
std::string soundPoints(std::string_view points) {
  std::string sound;
  const char *at = points.data(), *const end = at + points.size();
  while (true) {
    while (at != end && (isBlank(*at) || *at == ',')) ++at;
    if (at != end && *at == '+') ++at;
    double number = 0;
    const auto [past, error] = std::from_chars(at, end, number);
    if (error != std::errc() || !std::isfinite(number)) return sound;
    sound.append(at, past).append(1, ' ');
    at = past;
  }
}

/// Numbers and commands as MuPDF sees them: with character references taken for what they stand for (line ends are written so).
/// One of a sign that neither holds ends them.
std::string withoutReferences(std::string_view data) {
  std::string plain;
  for (std::size_t at = 0; at < data.size(); ++at) {
    if (data[at] != '&') {
      plain += data[at];
      continue;
    }
    const std::size_t end = data.find(';', at);
    if (end == std::string_view::npos || end < at + 3 || data[at + 1] != '#') return plain;
    const bool hexadecimal = data[at + 2] == 'x';
    const char *const first = data.data() + at + (hexadecimal ? 3 : 2), *const last = data.data() + end;
    int code = 0;
    const auto [past, error] = std::from_chars(first, last, code, hexadecimal ? 16 : 10);
    const bool ofNumbers = error == std::errc() && past == last && code > 0 && code <= 'z' && code != '<' &&
                           (code >= '(' || isBlank(static_cast<char>(code)));
    if (!ofNumbers) return plain;
    plain += static_cast<char>(code);
    at = end;
  }
  return plain;
}

/// Path data without plus signs, up to its first one without a number, where it ends (SVG 1.1, F.2). MuPDF takes the sign for the
/// begin of a number, reads none, and would stay there for ever.
std::string withoutPlus(std::string_view data) {
  std::string plain(data);
  for (std::size_t i = 0; i < plain.size(); ++i) {
    if (plain[i] != '+') continue;
    const bool ofExponent = i > 0 && (plain[i - 1] == 'e' || plain[i - 1] == 'E');
    if (ofExponent) continue;
    const char next = i + 1 < plain.size() ? plain[i + 1] : '\0';
    if (next != '.' && !(next >= '0' && next <= '9')) return plain.substr(0, i);
    plain[i] = ' ';
  }
  return plain;
}

// ---- clips

std::optional<Box> boxOfRect(const Tag& tag) {
  double v[4] = {0, 0, 0, 0};
  const char* const names[4] = {"x", "y", "width", "height"};
  for (int i = 0; i < 4; ++i) {
    const std::string* text = tag.find(names[i]);
    if (!text) continue;
    const auto number = svgNumber(*text);
    if (!number || text->find('%') != std::string::npos) return std::nullopt;
    v[i] = *number;
  }
  return Box{v[0], v[1], v[0] + v[2], v[1] + v[3]};
}

/// The box that a clip path's first child describes; nothing if it is not an upright rectangle.
std::optional<Box> boxOf(const Tag& tag) {
  const std::string name(withoutPrefix(tag.name));
  if (tag.find("transform")) return std::nullopt;
  if (name == "rect") return boxOfRect(tag);
  if (name != "path" || !tag.find("d")) return std::nullopt;
  const auto lines = svgStraightLines(*tag.find("d"));
  if (!lines || lines->empty()) return std::nullopt;
  const std::vector<Point>& ring = lines->front();
  for (std::size_t i = 1; i < ring.size(); ++i)
    if (ring[i].x != ring[i - 1].x && ring[i].y != ring[i - 1].y) return std::nullopt;
  return boundsOf(ring);
}

/// The id in "url(#id)"; empty if there is none.
std::string urlTarget(std::string_view value) {
  const std::size_t hash = value.find('#'), end = value.find(')');
  if (value.substr(0, 4) != "url(" || hash >= end || end == std::string_view::npos) return {};
  std::string_view id = trimmed(value.substr(hash + 1, end - hash - 1));
  while (!id.empty() && (id.back() == '"' || id.back() == '\'')) id.remove_suffix(1);
  return std::string(id);
}

// ---- references

/// How much an element draws, for itself and through references.
struct Weight {
  double elements = 0;
  std::vector<std::string> references;
};

/// Elements drawn when all references are followed; infinite for references that run in a circle.
class Expansion {
 public:
  explicit Expansion(const std::map<std::string, Weight>& named) : named_(named) {}

  double of(const Weight& weight) {
    double sum = weight.elements;
    for (const std::string& id : weight.references) {
      const auto target = named_.find(id);
      if (target == named_.end()) continue;
      sum += ofNamed(id, target->second);
    }
    return sum;
  }
  bool circular() const { return circular_; }

 private:
  double ofNamed(const std::string& id, const Weight& weight) {
    const auto known = counted_.find(id);
    if (known != counted_.end()) {
      if (known->second < 0) circular_ = true;
      return std::max(0.0, known->second);
    }
    counted_[id] = -1;  // under way
    const double sum = depth_++ < maxDepth ? of(weight) : 0;
    --depth_;
    counted_[id] = sum;
    return sum;
  }

  static constexpr int maxDepth = 1000;
  const std::map<std::string, Weight>& named_;
  std::map<std::string, double> counted_;
  int depth_ = 0;
  bool circular_ = false;
};

// ---- the pass over the drawing

class Preparer {
 public:
  Preparer(std::string_view svg, double maxElements) : svg_(svg), maxElements_(maxElements) {}

  PreparedSvg run() {
    readStyleSheets();
    readClipPaths();
    readGradients();
    PreparedSvg out;
    if (!rewrite(out)) out.text.clear();
    if (out.truncated || !out.problem.empty()) return out;
    Expansion expansion(named_);
    if (expansion.of(whole_) > maxElements_ || expansion.circular()) {
      out.text.clear();
      out.problem = expansion.circular() ? "its references run in a circle"
                                         : "its references draw more elements than any real drawing has";
    }
    return out;
  }

 private:
  struct Open {
    std::string name, anchor, id, classes, fill, strokeWidth;
    Weight weight;
    std::optional<Affine> toRoot = Affine{};  ///< nothing where the way is turned or unknown
    std::optional<Box> clip;                  ///< of this and the outer elements, in the root's plane
    double fontSize_px = 16;
  };

  struct Gradient {
    std::string color = "black", other;  ///< of what covers most; the gradient whose colours it has
    int stops = 0;

    void add(const Tag& stop) {
      const std::string its = property(stop, "stop-opacity"), ink = property(stop, "stop-color");
      const double covers = its.empty() ? 1 : std::clamp(std::strtod(its.c_str(), nullptr), 0.0, 1.0);
      if (stops == 0 || covers > most_) most_ = covers, color = ink.empty() ? "black" : ink;
      covered_ += covers, ++stops;
    }
    double opacity() const { return covered_ / std::max(1, stops); }

   private:
    double most_ = 0, covered_ = 0;
  };

  void readClipPaths() {
    for (std::size_t at = svg_.find("<clipPath"); at != std::string_view::npos;
         at = svg_.find("<clipPath", at)) {
      const auto tag = readTag(svg_, ++at);
      const std::size_t end = svg_.find("</clipPath", at);
      if (!tag || end == std::string_view::npos) return;
      const std::string* id = tag->find("id");
      const std::string* units = tag->find("clipPathUnits");
      std::size_t child = svg_.find('<', at);
      if (!id || (units && *units != "userSpaceOnUse") || tag->find("transform") || child >= end) continue;
      const auto shape = readTag(svg_, ++child);
      if (const auto box = shape ? boxOf(*shape) : std::nullopt) clips_[*id] = *box;
    }
  }

  /// Every gradient as one colour that covers as it does on the average: MuPDF knows none and draws black.
  void readGradients() {
    for (const std::string_view kind : {"linearGradient", "radialGradient"})
      for (std::size_t at = svg_.find("<" + std::string(kind)); at != std::string_view::npos;
           at = svg_.find("<" + std::string(kind), at)) {
        const auto tag = readTag(svg_, ++at);
        if (!tag) return;
        const std::string* id = tag->find("id");
        if (!id) continue;
        Gradient& gradient = gradients_[*id];
        for (const char* link : {"href", "xlink:href"})
          if (const std::string* other = tag->find(link); other && other->starts_with('#'))
            gradient.other = other->substr(1);
        const std::size_t end =
            tag->selfClosing ? at : std::min(svg_.find("</" + std::string(kind), at), svg_.size());
        for (std::size_t child = svg_.find("<stop", at); child < end; child = svg_.find("<stop", child))
          if (const auto stop = readTag(svg_, ++child)) gradient.add(*stop);
      }
  }

  /// Nothing where it is none, or has no colours.
  const Gradient* gradientOf(const std::string& paint) const {
    constexpr int mostOthers = 8;  // one may have another's colours, and its own
    auto found = gradients_.find(urlTarget(paint));
    for (int i = 0; i < mostOthers && found != gradients_.end(); ++i) {
      if (found->second.stops > 0) return &found->second;
      found = gradients_.find(found->second.other);
    }
    return nullptr;
  }

  static void setProperties(Tag& tag, const Declarations& plain) {
    Declarations style;
    if (const std::string* own = tag.find("style")) addDeclarations(*own, style);
    for (const auto& [name, value] : plain) {
      style[name] = value;
      tag.set(name, value);
    }
    std::string text;
    for (const auto& [name, value] : style) text += (text.empty() ? "" : ";") + name + ":" + value;
    tag.set("style", text);
  }

  /// A line that is as wide as it says however its plane is scaled: MuPDF scales it.
  static void keepWidth(Tag& tag, const Open& opened) {
    if (!opened.toRoot || property(tag, "vector-effect") != "non-scaling-stroke") return;
    const Affine& to = *opened.toRoot;
    const double scale = std::sqrt(std::abs(to.a * to.d - to.b * to.c));
    const char* const text = opened.strokeWidth.c_str();
    const double width = opened.strokeWidth.empty() ? 1 : std::strtod(text, nullptr);
    if (!(scale > 0) || !std::isfinite(width / scale)) return;
    char plain[32];
    std::snprintf(plain, sizeof plain, "%.6g", width / scale);
    setProperties(tag, {{"stroke-width", plain}});
  }

  /// A property as the attribute or the (already merged) style states it.
  static std::string property(const Tag& tag, const std::string& name) {
    Declarations style;
    if (const std::string* own = tag.find("style")) addDeclarations(*own, style);
    if (const auto found = style.find(name); found != style.end()) return found->second;
    const std::string* attribute = tag.find(name);
    return attribute ? *attribute : std::string();
  }

  void applyTransform(const Tag& tag, Open& opened) const {
    if (opened.name == "svg" && !open_.empty()) opened.toRoot.reset();  // a nested viewport
    const std::string* text = tag.find("transform");
    if (!opened.toRoot || !text) return;
    const auto own = svgUprightTransform(*text);
    if (!own) {
      opened.toRoot.reset();
    } else {
      opened.toRoot = opened.toRoot->after(*own);
    }
  }

  void applyClip(const Tag& tag, Open& opened) const {
    const auto found = clips_.find(urlTarget(property(tag, "clip-path")));
    if (found == clips_.end() || !opened.toRoot) return;
    const Box box = opened.toRoot->boxOf(found->second);
    opened.clip = opened.clip ? box.common(*opened.clip) : box;
  }

  /// Lines without filling are cut here; MuPDF knows no clips in SVG.
  static void cutLines(Tag& tag, const Open& opened) {
    if (!opened.clip || !opened.toRoot || opened.clip->empty() || opened.fill != "none") return;
    const Box box = opened.toRoot->inverse().boxOf(*opened.clip);
    const char* const attribute = opened.name == "path" ? "d" : "points";
    const std::string* data = tag.find(attribute);
    if (!data) return;
    const auto lines = svgStraightLines(opened.name == "path" ? *data : "M" + *data);
    if (!lines) return;
    std::string cut;
    for (const auto& line : *lines)
      for (const auto& part : clippedLine(line, box))
        for (std::size_t i = 0; i < part.size(); ++i) {
          char text[80];
          std::snprintf(text, sizeof text, "%c%.9g %.9g", i == 0 ? 'M' : 'L', part[i].x, part[i].y);
          cut += text;
        }
    tag.name = "path";
    std::erase_if(tag.attributes, [&](const Attribute& a) { return a.name == attribute; });
    tag.attributes.push_back({"d", cut});
  }

  void readStyleSheets() {
    for (std::size_t at = svg_.find("<style"); at != std::string_view::npos;
         at = svg_.find("<style", at + 1)) {
      const std::size_t begin = svg_.find('>', at), end = svg_.find("</style", at);
      if (begin == std::string_view::npos || end == std::string_view::npos || end < begin) continue;
      addStyleSheet(svg_.substr(begin + 1, end - begin - 1), rules_, variables_);
    }
    std::stable_sort(rules_.begin(), rules_.end(),
                     [](const Rule& a, const Rule& b) { return a.specificity < b.specificity; });
  }

  /// Copies everything but start tags, which are restyled.
  bool rewrite(PreparedSvg& out) {
    std::size_t at = 0;
    while (at < svg_.size()) {
      const std::size_t open = std::min(svg_.find('<', at), svg_.size());
      copyText(svg_.substr(at, open - at), out.text);
      if (open == svg_.size()) break;
      at = open;
      if (copyVerbatim(at, out.text)) continue;
      ++at;
      auto tag = readTag(svg_, at);
      rootClosed_ = tag && endsDrawing(*tag);
      if (!tag) break;
      if (tag->closes) {
        close(tag->name);
      } else if (!enter(*tag)) {
        out.problem = "it nests elements more than " + std::to_string(deepestNesting) + " deep";
        return false;
      }
      out.text += tag->text();
    }
    while (!open_.empty()) close(open_.back().name);
    out.truncated = !rootClosed_;
    return rootClosed_;
  }

  /// Whether nothing of the drawing can follow a tag: MuPDF would draw what it has of a file that was cut off.
  bool endsDrawing(const Tag& tag) const {
    return withoutPrefix(tag.name) == "svg" && (tag.closes || (tag.selfClosing && open_.empty()));
  }

  /// Inside <text>, leading blanks do not show but would shift the words.
  void copyText(std::string_view text, std::string& out) const {
    const bool words = !open_.empty() && (open_.back().name == "text" || open_.back().name == "tspan");
    out += words ? trimmed(text) : text;
  }

  /// Comments, declarations, character data.
  bool copyVerbatim(std::size_t& at, std::string& out) const {
    static constexpr std::pair<std::string_view, std::string_view> kinds[] = {
        {"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}};
    for (const auto& [begin, finish] : kinds) {
      if (svg_.substr(at, begin.size()) != begin) continue;
      const std::size_t found = svg_.find(finish, at + begin.size());
      const std::size_t end = found == std::string_view::npos ? svg_.size() : found + finish.size();
      out += svg_.substr(at, end - at);
      at = end;
      return true;
    }
    if (svg_.substr(at, 2) != "<!") return false;
    std::size_t end = at, brackets = 0;  // <!DOCTYPE ... [ entities ] >
    for (; end < svg_.size(); ++end) {
      if (svg_[end] == '[') ++brackets;
      if (svg_[end] == ']' && brackets > 0) --brackets;
      if (svg_[end] == '>' && brackets == 0) break;
    }
    end = std::min(svg_.size(), end + 1);
    out += svg_.substr(at, end - at);
    at = end;
    return true;
  }

  bool enter(Tag& tag) {
    const std::string name(withoutPrefix(tag.name));
    restyle(tag, name);
    Open opened;
    if (!open_.empty()) opened.fontSize_px = open_.back().fontSize_px;
    makePlain(tag, opened);
    for (Attribute& attribute : tag.attributes) {
      if (attribute.name == "points") attribute.value = soundPoints(withoutReferences(attribute.value));
      if (attribute.name == "d" || attribute.name == "transform")
        attribute.value = withoutPlus(withoutReferences(attribute.value));
    }
    const std::string* anchor = tag.find("text-anchor");
    opened.name = name;
    opened.anchor = anchor ? *anchor : open_.empty() ? std::string() : open_.back().anchor;
    if (name == "text" && !anchor && !opened.anchor.empty()) tag.set("text-anchor", opened.anchor);
    if (const std::string* id = tag.find("id")) opened.id = *id;
    if (const std::string* classes = tag.find("class")) opened.classes = *classes;
    if (!open_.empty()) {
      opened.toRoot = open_.back().toRoot;
      opened.clip = open_.back().clip;
      opened.fill = open_.back().fill;
      opened.strokeWidth = open_.back().strokeWidth;
    }
    if (const std::string width = property(tag, "stroke-width"); !width.empty()) opened.strokeWidth = width;
    if (const std::string fill = property(tag, "fill"); !fill.empty()) opened.fill = fill;
    applyTransform(tag, opened);
    keepWidth(tag, opened);
    applyClip(tag, opened);
    if ((name == "path" || name == "polyline") && tag.selfClosing) cutLines(tag, opened);
    opened.weight.elements = 1;
    if (name == "use")
      for (const char* link : {"xlink:href", "href"})
        if (const std::string* target = tag.find(link); target && !target->empty() && (*target)[0] == '#') {
          opened.weight.references.push_back(target->substr(1));
          break;
        }
    open_.push_back(std::move(opened));
    const bool deep = open_.size() > deepestNesting;
    if (tag.selfClosing) close(name);
    return !deep;
  }

  void close(std::string_view name) {
    if (open_.empty() || (open_.back().name != withoutPrefix(name) && open_.size() > deepestNesting)) return;
    Open done = std::move(open_.back());
    open_.pop_back();
    Weight& outer = open_.empty() ? whole_ : open_.back().weight;
    // What stands in <defs> is drawn by reference only; counting it once more does no harm.
    outer.elements += done.weight.elements;
    outer.references.insert(outer.references.end(), done.weight.references.begin(),
                            done.weight.references.end());
    if (!done.id.empty()) named_[done.id] = std::move(done.weight);
  }

  /// Each outer part of a rule is looked for at the nearest element that fits.
  bool matches(const Rule& rule, const Tag& tag, const std::string& name) const {
    const auto valueOf = [&](const char* attribute) {
      const std::string* value = tag.find(attribute);
      return value ? std::string_view(*value) : std::string_view();
    };
    if (!rule.path.back().fits(name, valueOf("id"), valueOf("class"))) return false;
    auto outer = open_.rbegin();
    for (std::size_t k = rule.path.size() - 1; k > 0; --k) {
      const auto fits = [&](const Open& each) {
        return rule.path[k - 1].fits(each.name, each.id, each.classes);
      };
      const auto last = rule.path[k].isChild && outer != open_.rend() ? outer + 1 : open_.rend();
      outer = std::find_if(outer, last, fits);
      if (outer == last) return false;
      ++outer;
    }
    return true;
  }

  /// Cascade: presentation attributes, then rules by specificity, then the style attribute.
  void restyle(Tag& tag, const std::string& name) {
    Declarations merged;
    for (const Rule& rule : rules_)
      if (matches(rule, tag, name))
        for (const auto& [property, value] : rule.declarations) merged[property] = value;
    const std::string* own = tag.find("style");
    if (merged.empty() && !own) return;
    if (own) addDeclarations(*own, merged);
    takeVariables(merged, variables_);
    std::string style;
    for (const auto& [property, value] : merged) {
      if (!style.empty()) style += ';';
      style.append(property).append(":").append(value);
      if (property == "text-anchor" || tag.find(property)) tag.set(property, value);
    }
    std::replace(style.begin(), style.end(), '"', '\'');
    std::erase_if(tag.attributes, [](const Attribute& a) { return a.name == "style"; });
    if (!style.empty()) tag.attributes.push_back({"style", style});
  }

  /// What MuPDF does not know of a style is said in its words: variables, sizes of other sizes, colours that cover in part.
  void makePlain(Tag& tag, Open& opened) const {
    Declarations plain;
    for (Attribute& attribute : tag.attributes)
      if (attribute.value.find("var(") != std::string::npos)
        attribute.value = withVariables(std::move(attribute.value), variables_);
    for (const char* name : {"fill", "stroke", "font-size"}) {
      const std::string before = property(tag, name);
      std::string value = before;
      if (std::string_view(name) == "font-size") {
        if (const auto size_px = pixelsOf(value, opened.fontSize_px)) {
          opened.fontSize_px = *size_px;
          char text[32];
          std::snprintf(text, sizeof text, "%.6gpx", *size_px);
          value = text;
        }
      } else if (const Gradient* gradient = gradientOf(value)) {
        const std::string opacity = std::string(name) + "-opacity", own = property(tag, opacity);
        value = gradient->color;
        plain[opacity] =
            std::to_string((own.empty() ? 1 : std::strtod(own.c_str(), nullptr)) * gradient->opacity());
      } else if (const auto alpha = takeAlpha(value)) {
        plain[std::string(name) + "-opacity"] = *alpha;
      }
      if (value != before) plain[name] = value;
    }
    if (!plain.empty()) setProperties(tag, plain);
  }

  std::string_view svg_;
  double maxElements_;
  std::vector<Rule> rules_;
  Declarations variables_;
  std::map<std::string, Box> clips_;  ///< upright boxes, in the plane of the element that uses them
  std::map<std::string, Gradient, std::less<>> gradients_;
  std::vector<Open> open_;
  std::map<std::string, Weight> named_;
  Weight whole_;
  bool rootClosed_ = false;  ///< by the last tag read
};

}  // namespace

PreparedSvg prepareSvg(std::string_view svg, double maxElements) { return Preparer(svg, maxElements).run(); }

}  // namespace detent::importer
