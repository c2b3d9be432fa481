// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/strokes/legend.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "importer/axes/stroke_words.h"
#include "importer/trace/curve_trace.h"

namespace detent::importer {

namespace {

constexpr std::array kPointSigns = {"点", "點", "位置"};

bool isLetter(unsigned char c) { return (c >= 'a' && c <= 'z') || c >= 0x80; }

/// Words as `folded` writes them; bytes above ASCII count as letters.
std::vector<std::string> wordsOf(std::string_view utf8) {
  std::vector<std::string> words(1);
  for (const char c : folded(utf8)) {
    if (isLetter(static_cast<unsigned char>(c)))
      words.back() += c;
    else if (!words.back().empty())
      words.emplace_back();
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

bool namesPoint(std::string_view utf8, const std::vector<std::string>& words) {
  return std::ranges::any_of(words, isPointWord) ||
         std::ranges::any_of(
             kPointSigns, [&](std::string_view sign) { return utf8.find(sign) != std::string_view::npos; });
}

/// The stroke of a text of one word that says so alone.
std::optional<Stroke> loneStroke(std::string_view utf8) {
  const std::vector<std::string> words = wordsOf(utf8);
  return words.size() == 1 ? strokeOfLoneWord(words.front()) : std::nullopt;
}

/// Which strokes a text has words or signs for.
SignedStrokes strokesIn(std::string_view utf8) {
  SignedStrokes named = strokesSignedIn(utf8);
  if (const auto lone = loneStroke(utf8)) (*lone == Stroke::press ? named.press : named.release) = true;
  for (const std::string& word : wordsOf(utf8)) {
    const auto stroke = strokeOfWord(word);
    named.press = named.press || stroke == Stroke::press;
    named.release = named.release || stroke == Stroke::release;
  }
  return named;
}

/// Of a word without its signs for strokes; empty if it had nothing else.
bool isStrokeWord(const std::string& word) {
  return word.empty() || strokeOfWord(word) || strokeOfPart(word);
}

// A curve of a worn switch is called by its age.
constexpr std::array kWearWords = {
    "cycles",    "million",     "millions",   "worn",         "aged",          "used",     "zyklen",
    "millionen", "lastwechsel", "lastspiele", "schaltspiele", "schaltspielen", "gealtert", "gebraucht",
    "abgenutzt", "usure",       "ciclos",     "cicli",        "usado",         "usato",    "cykli",
    "cykler",    "cykly",       "циклов",     "циклы",        "износ"};
constexpr std::array kWearSigns = {"万次", "万回", "磨损", "摩耗", "만회"};

/// By colour, kind or state switches are told apart, not strokes.
constexpr std::array kSwitchWords = {
    "red",     "blue",   "brown",  "black",  "white",   "green", "yellow", "orange",  "pink",    "purple",
    "grey",    "gray",   "silver", "clear",  "rot",     "blau",  "braun",  "schwarz", "weiss",   "grun",
    "gelb",    "rouge",  "bleu",   "brun",   "marron",  "noir",  "blanc",  "vert",    "jaune",   "rojo",
    "azul",    "negro",  "blanco", "verde",  "rosso",   "blu",   "nero",   "bianco",  "giallo",  "rood",
    "blauw",   "bruin",  "zwart",  "wit",    "groen",   "geel",  "linear", "tactile", "clicky",  "silent",
    "soft",    "hard",   "light",  "heavy",  "medium",  "new",   "old",    "used",    "worn",    "fresh",
    "before",  "after",  "cold",   "hot",    "dry",     "lubed", "stock",  "neu",     "alt",     "vorher",
    "nachher", "weich",  "hart",   "leicht", "schwer",  "kalt",  "warm",   "ideal",   "nominal", "measured",
    "theory",  "model",  "min",    "max",    "typ",     "upper", "lower",  "left",    "right",   "links",
    "rechts",  "sample", "probe",  "muster", "average", "mean"};

constexpr std::array kQuantityWords = {"force", "travel", "kraft", "mesure", "messung"};

/// Words that name neither a stroke nor a curve.
std::vector<std::string> wordsBesideStroke(std::string_view utf8) {
  if (loneStroke(utf8)) return {};
  std::vector<std::string> words = wordsOf(utf8);
  for (std::string& word : words) word = withoutStrokeSigns(word);
  std::erase_if(words, [](const std::string& word) { return isStrokeWord(word) || isCurveWord(word); });
  return words;
}

/// Words that name neither a stroke nor what every legend names: a switch's own name.
std::vector<std::string> ownWords(std::string_view utf8) {
  std::vector<std::string> own = wordsBesideStroke(utf8);
  std::erase_if(own, [](const std::string& word) {
    return std::ranges::find(kQuantityWords, word) != kQuantityWords.end();
  });
  return own;
}

/// Whether a text says how far a switch is worn, and nothing of a stroke: "after 1 million strokes".
bool namesWear(std::string_view utf8) {
  const std::vector<std::string> words = wordsOf(utf8);
  const auto saysSo = [&](std::string_view word) {
    return std::ranges::find(kWearWords, word) != kWearWords.end();
  };
  const auto holds = [&](std::string_view sign) { return utf8.find(sign) != std::string_view::npos; };
  return !strokeNamedBy(utf8) &&
         (std::ranges::any_of(words, saysSo) || std::ranges::any_of(kWearSigns, holds));
}

std::vector<std::string> numbersOf(std::string_view utf8) {
  constexpr std::string_view kDigits = "0123456789";
  std::vector<std::string> numbers;
  for (auto at = utf8.find_first_of(kDigits); at < utf8.size();) {
    const auto end = std::min(utf8.find_first_not_of(kDigits, at), utf8.size());
    numbers.emplace_back(utf8.substr(at, end - at));
    at = utf8.find_first_of(kDigits, end);
  }
  return numbers;
}

/// Nothing but what parts words: it goes where the word beside it goes.
bool isJoint(char c) { return std::string_view(" _-/:,;()[]").find(c) != std::string_view::npos; }

/// Of one text.
std::string withoutStrokeWords(std::string_view utf8) {
  if (loneStroke(utf8)) return {};
  std::string name;
  bool shortened = false;
  for (std::size_t i = 0; i < utf8.size();) {
    std::size_t to = i;
    while (to < utf8.size() && isJoint(utf8[to]) == isJoint(utf8[i])) ++to;
    const std::string_view part = utf8.substr(i, to - i);
    const std::vector<std::string> words = wordsOf(part);
    const bool namesStroke = words.size() == 1 && isStrokeWord(withoutStrokeSigns(words.front()));
    shortened = shortened || namesStroke;
    if (!namesStroke) name += part;
    i = to;
  }
  if (!shortened) return name;
  for (const std::string_view emptied : {"()", "[]"})
    if (const auto at = name.find(emptied); at != std::string::npos) name.erase(at, emptied.size());
  const auto isRest = [&](char c) {  // brackets around the stroke's word go with it, those of the name stay
    const bool opened = name.find('(') != std::string::npos || name.find('[') != std::string::npos;
    return isJoint(c) && !(opened && (c == ')' || c == ']'));
  };
  while (!name.empty() && isRest(name.back())) name.pop_back();
  name.erase(name.begin(), std::find_if_not(name.begin(), name.end(), isJoint));
  return name;
}

}  // namespace

bool namesACurve(std::string_view utf8) {  // a callout beside its leader names a point, not a curve
  const std::vector<std::string> words = wordsOf(utf8);
  return !words.empty() && !namesPoint(utf8, words);
}

bool namesOnePair(std::string_view a, std::string_view b) {
  if (!namesACurve(a) || !namesACurve(b) || strokeNamedBy(a) == strokeNamedBy(b)) return false;
  return ownWords(a) == ownWords(b) && numbersOf(a) == numbersOf(b);
}

bool namesBothStrokes(std::string_view label) {
  const SignedStrokes named = strokesIn(label);
  return named.press && named.release;
}

bool namesNothingButRelease(std::string_view utf8) {
  return (strokeNamedBy(utf8) == Stroke::release || (namesBothStrokes(utf8) && namesACurve(utf8))) &&
         wordsBesideStroke(utf8).empty() && numbersOf(utf8).empty();
}

bool isDefaultName(std::string_view utf8) {
  constexpr std::array kSeries = {"data", "series", "serie",   "seria", "datenreihe", "datenreihen", "reihe",
                                  "plot", "trace",  "dataset", "wave",  "ряд",        "系列",        "계열"};
  constexpr std::array kColumns = {"column", "spalte", "colonne", "columna", "coluna"};
  std::string name = folded(utf8);
  std::erase(name, ' ');
  // "'a.txt' using 1:2"
  if (name.find("using") != std::string::npos && name.find(':') != std::string::npos) return true;
  const auto isOf = [&](const auto& words, const auto& isRest) {
    return std::ranges::any_of(words, [&](std::string_view word) {
      return name.starts_with(word) && isRest(std::string_view(name).substr(word.size()));
    });
  };
  const auto isNumber = [](std::string_view rest) {  // "l": a one in pixels
    return rest == "l" || (!rest.empty() && rest.find_first_not_of("0123456789") == std::string_view::npos);
  };
  const auto isColumn = [](std::string_view rest) { return rest.size() == 1; };
  return isOf(kSeries, isNumber) || isOf(kColumns, isColumn);
}

bool namesNoStroke(std::string_view utf8) {
  return namesACurve(utf8) && !strokeNamedBy(utf8) && !namesBothStrokes(utf8) && !isDefaultName(utf8) &&
         !ownWords(utf8).empty();
}

bool mayNameAStroke(std::string_view utf8) {
  constexpr std::size_t fewest = 3;  // letters: shorter ones count switches
  const std::vector<std::string> words = wordsOf(utf8);
  return namesNoStroke(utf8) && words.size() == 1 && words.front().size() >= fewest &&
         numbersOf(utf8).empty() && std::ranges::find(kSwitchWords, words.front()) == kSwitchWords.end();
}

std::string switchNamedBy(std::string_view utf8) {
  std::vector<std::string> names;
  for (std::size_t from = 0; from <= utf8.size();) {
    const std::size_t to = std::min(utf8.find(kLabelParting, from), utf8.size());
    std::string name = withoutStrokeWords(utf8.substr(from, to - from));
    if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(std::move(name));
    from = to + kLabelParting.size();
  }
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : std::string(kLabelParting)) + name;
  return all;
}

bool mayBeOnePair(std::string_view a, std::string_view b) {
  if (namesWear(a) != namesWear(b)) return false;
  if (!namesACurve(a) || !namesACurve(b)) return true;
  const std::optional<Stroke> ofA = strokeNamedBy(a), ofB = strokeNamedBy(b);
  if (!ofA && !ofB) return false;
  if (ofA == ofB) return false;
  return ownWords(a) == ownWords(b) || ownWords(a).empty() || ownWords(b).empty();
}

std::optional<Stroke> strokeNamedBy(std::string_view utf8) {
  const std::vector<std::string> words = wordsOf(utf8);
  if (namesPoint(utf8, words)) return {};
  const SignedStrokes named = strokesIn(utf8);
  if (named.press == named.release)
    return named.press || words.size() != 1 ? std::nullopt : strokeOfPart(words.front());
  return named.press ? Stroke::press : Stroke::release;
}

}  // namespace detent::importer
