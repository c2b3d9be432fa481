// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/svg/drawing.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <set>
#include <vector>

#include <libxml/parser.h>
#include <libxml/parserInternals.h>
#include <libxml/tree.h>

#include "importer/svg/plain_styles.h"
#include "importer/svg/undrawn.h"
#include "model/text.h"

namespace detent::importer::svg {
namespace {

constexpr const char* svgNamespace = "http://www.w3.org/2000/svg";
constexpr const char* replacementCharacter = "\xef\xbf\xbd";  // U+FFFD

struct ParserEnd {
  void operator()(xmlParserCtxt* parser) const { xmlFreeParserCtxt(parser); }
};
struct DocumentEnd {
  void operator()(xmlDoc* document) const { xmlFreeDoc(document); }
};
using Document = std::unique_ptr<xmlDoc, DocumentEnd>;

std::string_view viewOf(const xmlChar* text) {
  return text == nullptr ? std::string_view() : std::string_view(reinterpret_cast<const char*>(text));
}
const xmlChar* xmlText(const std::string& text) { return reinterpret_cast<const xmlChar*>(text.c_str()); }

std::string takeText(xmlChar* text) {
  std::string copy(viewOf(text));
  xmlFree(text);
  return copy;
}

bool isElement(const xmlNode* node) { return node->type == XML_ELEMENT_NODE; }
bool isNamed(const xmlNode* node, std::string_view name) {
  return isElement(node) && viewOf(node->name) == name;
}

/// Visits nodes in document order; does not descend into a node for which `enter` returns false.
template <class Enter>
void forEachNode(xmlNode* root, const Enter& enter) {
  for (xmlNode* node = root; node != nullptr;) {
    const bool below = enter(node) && isElement(node) && node->children != nullptr;
    xmlNode* next = below ? node->children : nullptr;
    while (next == nullptr && node != root && node != nullptr) {
      next = node->next;
      if (next == nullptr) node = node->parent;
    }
    if (node == root && !below) return;
    node = next;
  }
}

/// Returns true if this parser error may mean that the end of the file is missing.
bool isOfMissingEnd(int code) {
  constexpr std::array codes{
      XML_ERR_DOCUMENT_END,         XML_ERR_TAG_NOT_FINISHED,       XML_ERR_GT_REQUIRED,
      XML_ERR_LTSLASH_REQUIRED,     XML_ERR_ATTRIBUTE_NOT_FINISHED, XML_ERR_ATTRIBUTE_WITHOUT_VALUE,
      XML_ERR_COMMENT_NOT_FINISHED, XML_ERR_CDATA_NOT_FINISHED,     XML_ERR_NAME_REQUIRED,
      XML_ERR_TAG_NAME_MISMATCH};
  return std::ranges::find(codes, code) != codes.end();
}

/// Returns true if the file ends by closing an element called svg.
bool endsDrawing(std::string_view bytes) {
  constexpr std::size_t tail = 256;
  std::string end(bytes.substr(bytes.size() - std::min(bytes.size(), tail)));
  std::erase(end, '\0');  // for UTF-16
  return trimmed(end).ends_with("svg>");
}

Document parse(std::string_view bytes, Drawing& drawing) {
  xmlSetExternalEntityLoader(
      [](const char*, const char*, xmlParserCtxt*) -> xmlParserInput* { return nullptr; });
  const std::unique_ptr<xmlParserCtxt, ParserEnd> parser(xmlNewParserCtxt());
  if (!parser || bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    drawing.problem = "it is too large";
    return {};
  }
  constexpr int options =
      XML_PARSE_NOENT | XML_PARSE_DTDATTR | XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING;
  Document document(xmlCtxtReadMemory(parser.get(), bytes.data(), static_cast<int>(bytes.size()), nullptr,
                                      nullptr, options));
  if (document) return document;
  const xmlError* const error = xmlCtxtGetLastError(parser.get());
  drawing.truncated = error != nullptr && isOfMissingEnd(error->code) && !endsDrawing(bytes);
  drawing.problem = error != nullptr && error->message != nullptr ? trimmed(error->message) : "it is no XML";
  if (error != nullptr && error->code == XML_ERR_INTERNAL_ERROR &&
      error->int1 == static_cast<int>(xmlParserMaxDepth))
    drawing.problem = "it nests elements more than " + std::to_string(xmlParserMaxDepth) + " deep";
  return {};
}

/// A list of points up to its first error, where browsers stop; librsvg would leave out the element.
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

/// The mean factor by which a transform list scales lengths; 1 if it cannot be read.
double scaleOf(std::string_view transform) {
  double area = 1;
  for (std::size_t open = transform.find('('); open != std::string_view::npos;
       open = transform.find('(', open + 1)) {
    const std::string_view name = trimmed(transform.substr(0, open));
    std::array<double, 6> values{};
    std::size_t count = 0;
    std::string list(transform.substr(open + 1, transform.find(')', open) - open - 1));
    std::ranges::replace(list, ',', ' ');
    const char* at = list.c_str();
    for (char* past = nullptr; count < values.size(); at = past) {
      values[count] = std::strtod(at, &past);
      if (past == at) break;
      ++count;
    }
    if (name.ends_with("matrix") && count == values.size())
      area *= values[0] * values[3] - values[1] * values[2];
    else if (name.ends_with("scale") && count > 0)
      area *= values[0] * (count > 1 ? values[1] : values[0]);
  }
  const double scale = std::sqrt(std::abs(area));
  return scale > 0 && std::isfinite(scale) ? scale : 1;
}

/// Declarations that fill an element with the colour of a background, or not at all if it states none.
/// The renderer keeps the last value that it can read; a background also states positions ("0 0").
std::string backgroundFill(std::string_view background) {
  constexpr std::array<std::string_view, 5> colourless{"none", "inherit", "initial", "unset", "revert"};
  std::string fill = "fill:none", word;
  int depth = 0;
  for (const char c : std::string(background) + " ") {
    depth += (c == '(') - (c == ')');
    if (depth > 0 || !(isBlank(c) || c == ',')) {
      word += c;
      continue;
    }
    if (std::ranges::find(colourless, word) == colourless.end()) fill += ";fill:" + word;
    word.clear();
  }
  return fill;
}

class Reader {
 public:
  Reader(xmlDoc* document, Drawing& drawing, const std::function<bool(char32_t)>& hasFont)
      : document_(document), drawing_(drawing), hasFont_(hasFont) {}

  void run() {
    xmlNode* const root = xmlDocGetRootElement(document_);
    nameSpaces(root);
    for (const xmlNode* node = document_->children; node != nullptr; node = node->next)
      drawing_.leftOut += node->type == XML_PI_NODE && viewOf(node->name) == "xml-stylesheet";
    forEachNode(root, [&](xmlNode* node) { return collect(node); });
    forEachNode(root, [&](xmlNode* node) { return rewrite(node); });
    paintBackground(root);
    if (xmlDtd* const type = xmlGetIntSubset(document_)) {
      xmlUnlinkNode(reinterpret_cast<xmlNode*>(type));
      xmlFreeDtd(type);
    }
  }

 private:
  /// Adds the SVG name space, which drawings cut out of a web page lack.
  static void nameSpaces(xmlNode* root) {
    if (root->ns != nullptr) return;
    xmlNs* const own = xmlNewNs(root, reinterpret_cast<const xmlChar*>(svgNamespace), nullptr);
    forEachNode(root, [&](xmlNode* node) {
      if (isElement(node) && node->ns == nullptr) xmlSetNs(node, own);
      return true;
    });
  }

  /// Browsers fill the page with the root's background colour; librsvg does not.
  static void paintBackground(xmlNode* root) {
    std::string color = propertyOf(root, "background-color");
    if (color.empty()) color = propertyOf(root, "background");
    if (color.empty() || color.find("url(") != std::string::npos) return;
    xmlNode* const page = xmlNewNode(root->ns, xmlText("rect"));
    std::string_view box = "0 0";
    const std::string stated = takeText(xmlGetNoNsProp(root, xmlText("viewBox")));
    if (!stated.empty()) box = trimmed(stated);
    char* past = nullptr;
    const std::string corner(box);
    const double x = std::strtod(corner.c_str(), &past), y = std::strtod(past + (*past == ','), nullptr);
    for (const auto& [name, value] : {std::pair<std::string, std::string>("x", std::to_string(x)),
                                      {"y", std::to_string(y)},
                                      {"width", "100%"},
                                      {"height", "100%"},
                                      {"stroke", "none"},
                                      {"style", backgroundFill(color)}})
      xmlNewProp(page, xmlText(name), xmlText(value));
    if (root->children != nullptr)
      xmlAddPrevSibling(root->children, page);
    else
      xmlAddChild(root, page);
  }

  /// Simplifies style sheets and collects variables.
  bool collect(xmlNode* node) {
    if (isNamed(node, "style")) {
      const std::string media = takeText(xmlGetNoNsProp(node, xmlText("media")));
      PlainStyles plain;
      if (mediaApply(media)) plain = plainStyles(takeText(xmlNodeGetContent(node)));
      drawing_.leftOut += plain.imports;
      animates_ = animates_ || plain.animates;
      addVariables(plain.css, variables_);
      noteRasters(plain.css);
      setContent(node, plain.css);
      return false;
    }
    if (!isElement(node)) return false;
    if (const std::string style = takeText(xmlGetNoNsProp(node, xmlText("style"))); !style.empty())
      addVariables(style, variables_);
    names_.emplace(viewOf(node->name));
    names_.insert("#" + takeText(xmlGetNoNsProp(node, xmlText("id"))));
    const std::string classes = takeText(xmlGetNoNsProp(node, xmlText("class")));
    for (std::string_view rest = trimmed(classes); !rest.empty();) {
      const auto end = static_cast<std::size_t>(std::ranges::find_if(rest, isBlank) - rest.begin());
      names_.insert("." + std::string(rest.substr(0, end)));
      rest = trimmed(rest.substr(end));
    }
    return true;
  }

  bool rewrite(xmlNode* node) {
    if (node->type == XML_TEXT_NODE || node->type == XML_CDATA_SECTION_NODE) {
      markMissingLetters(node);
      return false;
    }
    if (!isElement(node)) return false;
    const std::string_view name = viewOf(node->name);
    if (name == "style") {
      const std::string css = withValues(takeText(xmlNodeGetContent(node)), variables_);
      noteUndrawn(undrawnRule(css, animates_, names_));
      setContent(node, withoutFilters(css));
      return false;
    }
    noteAnimation(node);
    if (name == "foreignObject" && !isNamed(node->parent, "switch")) ++drawing_.leftOut;
    if (name == "a") dropAttributes(node, "href");
    dropAttributes(node, "filter");
    for (xmlAttr* attribute = node->properties; attribute != nullptr; attribute = attribute->next)
      rewriteAttribute(node, attribute);
    keepWidth(node);
    aroundOrigin(node);
    if (name == "text") onBaseline(node);
    return name != "foreignObject" && name != "script" && name != "metadata" && name != "title" &&
           name != "desc";
  }

  /// Removes links, some of which make cairo refuse the page, and filters, which turn lines into pixels.
  static void dropAttributes(xmlNode* node, std::string_view name) {
    for (xmlAttr* attribute = node->properties; attribute != nullptr;) {
      xmlAttr* const next = attribute->next;
      if (viewOf(attribute->name) == name) xmlRemoveProp(attribute);
      attribute = next;
    }
  }

  void noteRasters(std::string_view css) {
    drawing_.rasters = drawing_.rasters || css.find("mask:") != std::string_view::npos;
  }

  /// Disables shadows and glows, which would turn lines into pixels, by renaming the property.
  static std::string withoutFilters(std::string css) {
    constexpr std::string_view property = "filter:";
    for (std::size_t at = css.find(property); at != std::string::npos;
         at = css.find(property, at + property.size() + 2))
      css.insert(at, "x-");
    return css;
  }

  void noteUndrawn(const std::string& what) {
    if (drawing_.undrawn.empty()) drawing_.undrawn = what;
  }

  /// Notes animations that start by themselves. One that waits for a click does not change the drawing.
  void noteAnimation(xmlNode* node) {
    const std::string_view name = viewOf(node->name);
    if (name != "set" && !name.starts_with("animate")) return;
    const std::string begin = takeText(xmlGetNoNsProp(node, xmlText("begin")));
    const bool byItself =
        begin.empty() || std::string_view("0123456789+.").find(begin.front()) != std::string_view::npos;
    if (byItself) noteUndrawn("<" + std::string(name) + ">");
  }

  void rewriteAttribute(xmlNode* node, xmlAttr* attribute) {
    const std::string value = takeText(xmlNodeListGetString(document_, attribute->children, 1));
    if (viewOf(attribute->name) == "href") {
      const std::string_view target = trimmed(value);
      if (!target.empty() && target.front() != '#' && !target.starts_with("data:")) ++drawing_.leftOut;
    }
    if (viewOf(attribute->name) == "points") {
      setAttribute(node, attribute, soundPoints(value));
      return;
    }
    if (viewOf(attribute->name) == "mask")
      drawing_.rasters = drawing_.rasters || value.find("url(") != std::string::npos;
    if (viewOf(attribute->name) == "style") noteRasters(value);
    const std::string known = withValues(value, variables_);
    if (viewOf(attribute->name) == "style") noteUndrawn(undrawnProperty(known, animates_));
    if (viewOf(attribute->name) == "pathLength" && !propertyOf(node, "stroke-dasharray").empty())
      noteUndrawn("pathLength");
    const std::string plain = withoutFilters(known);
    if (plain != value) setAttribute(node, attribute, plain);
  }

  /// Keeps the stated width of a line whose width must not follow transforms; librsvg 2.54 scales it.
  void keepWidth(xmlNode* node) {
    if (propertyOf(node, "vector-effect") != "non-scaling-stroke") return;
    double scale = 1;
    std::string width;
    for (xmlNode* each = node; each != nullptr && isElement(each); each = each->parent) {
      scale *= scaleOf(propertyOf(each, "transform"));
      if (width.empty()) width = propertyOf(each, "stroke-width");
    }
    const double own = width.empty() ? 1 : std::strtod(width.c_str(), nullptr);
    const std::string style = takeText(xmlGetNoNsProp(node, xmlText("style")));
    xmlSetNsProp(node, nullptr, xmlText("style"),
                 xmlText(style + ";stroke-width:" + std::to_string(own / scale)));
  }

  /// Shifts text to its requested baseline, because librsvg 2.54 knows only the alphabetic one.
  static void onBaseline(xmlNode* node) {
    std::string baseline;
    for (xmlNode* each = node; baseline.empty() && each != nullptr && isElement(each); each = each->parent)
      baseline = propertyOf(each, "dominant-baseline");
    const char* down = nullptr;  // distance that Arial's letters reach above that baseline
    if (baseline == "central" || baseline == "middle") down = "0.35em";
    if (baseline == "hanging") down = "0.73em";
    if (baseline == "text-before-edge" || baseline == "text-top") down = "0.9em";
    if (down != nullptr && takeText(xmlGetNoNsProp(node, xmlText("dy"))).empty())
      xmlSetNsProp(node, nullptr, xmlText("dy"), xmlText(down));
  }

  /// Moves a transform to its origin, because librsvg 2.54 always transforms about the corner.
  void aroundOrigin(xmlNode* node) {
    const std::string origin = propertyOf(node, "transform-origin"), turn = propertyOf(node, "transform");
    if (origin.empty() || turn.empty()) return;
    char* end = nullptr;
    const double x = std::strtod(origin.c_str(), &end);
    if (end == origin.c_str()) return;
    if (std::string_view(end).starts_with("px")) end += 2;
    char* last = nullptr;
    const double y = std::strtod(end, &last);
    if (last == end) return;
    const auto shift = [](double dx, double dy) {
      return "translate(" + std::to_string(dx) + "," + std::to_string(dy) + ")";
    };
    xmlSetNsProp(node, nullptr, xmlText("transform"),
                 xmlText(shift(x, y) + " " + turn + " " + shift(-x, -y)));
  }

  /// Value of the property in the style attribute, else the attribute of that name.
  static std::string propertyOf(xmlNode* node, const std::string& name) {
    std::string stated;
    bool found = false;
    forEachDeclaration(takeText(xmlGetNoNsProp(node, xmlText("style"))),
                       [&](std::string_view property, std::string_view value) {
                         found = property == name;
                         if (found) stated = value;
                         return found;
                       });
    return found ? stated : takeText(xmlGetNoNsProp(node, xmlText(name)));
  }

  void markMissingLetters(xmlNode* node) {
    const std::string_view text = viewOf(node->content);
    std::string shown;
    bool missing = false;
    for (std::size_t at = 0; at < text.size();) {
      int length = static_cast<int>(text.size() - at);
      const int letter = xmlGetUTF8Char(node->content + at, &length);
      if (letter < 0 || length <= 0) return;
      const std::string own(text.substr(at, static_cast<std::size_t>(length)));
      at += static_cast<std::size_t>(length);
      const bool ascii = letter < 0x80;
      if (ascii || hasFont_(static_cast<char32_t>(letter))) {
        shown += own;
        continue;
      }
      missing = true;
      shown += replacementCharacter;
      constexpr std::size_t mostNamed = 8;
      if (named_.size() < mostNamed && named_.insert(letter).second) drawing_.withoutFont += own;
    }
    if (missing) setContent(node, shown);
  }

  static void setContent(xmlNode* node, const std::string& text) {
    if (isElement(node)) {
      xmlNodeSetContent(node, nullptr);
      xmlNodeAddContent(node, xmlText(text));
    } else {
      xmlNodeSetContent(node, nullptr);
      xmlNodeAddContentLen(node, xmlText(text), static_cast<int>(text.size()));
    }
  }

  static void setAttribute(xmlNode* node, xmlAttr* attribute, const std::string& value) {
    xmlSetNsProp(node, attribute->ns, attribute->name, xmlText(value));
  }

  xmlDoc* document_;
  Drawing& drawing_;
  const std::function<bool(char32_t)>& hasFont_;
  Variables variables_;
  ElementNames names_;
  bool animates_ = false;
  std::set<int> named_;
};

}  // namespace

Drawing readDrawing(std::string_view bytes, const std::function<bool(char32_t)>& hasFont) {
  Drawing drawing;
  const Document document = parse(bytes, drawing);
  if (!document) return drawing;
  const xmlNode* const root = xmlDocGetRootElement(document.get());
  if (!isNamed(root, "svg")) {
    drawing.problem = "its root is <" + std::string(viewOf(root->name)) + ">, not <svg>";
    return drawing;
  }
  Reader(document.get(), drawing, hasFont).run();
  xmlChar* text = nullptr;
  int size = 0;
  xmlDocDumpMemoryEnc(document.get(), &text, &size, "UTF-8");
  drawing.xml.assign(reinterpret_cast<const char*>(text), static_cast<std::size_t>(std::max(size, 0)));
  xmlFree(text);
  return drawing;
}

}  // namespace detent::importer::svg
