// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/strokes/legend.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "importer/lexicon/stroke_words.h"
#include "importer/trace/curve_trace.h"

namespace detent::importer {

namespace {

/// Words of a label, without those of phrases that name other things ("load cell").
std::vector<std::string> ownNamesOf(std::string_view utf8) {
  std::string text;
  for (const std::string& word : wordsOf(utf8)) text += (text.empty() ? "" : " ") + word;
  return wordsOf(withoutOtherNames(text));
}

bool namesPoint(std::string_view utf8, const std::vector<std::string>& words, TextSource source) {
  return std::ranges::any_of(words, [&](const std::string& word) { return isPointWord(word, source); }) ||
         holdsSign(utf8, WordKind::point);
}

/// The stroke that a text of a single word names by itself.
std::optional<Stroke> loneStroke(std::string_view utf8) {
  const std::vector<std::string> words = wordsOf(utf8);
  return words.size() == 1 ? strokeOfLoneWord(words.front()) : std::nullopt;
}

/// Returns true if a word is an attribute of a following noun that the lexicon does not know: "Pressing
/// plate", "Return loss". A name in capitals is a switch's: "Press Boba".
bool isAttribute(std::string_view label, const std::string& word, TextSource source) {
  constexpr std::size_t fewest = 4;  // least letters of a noun; shorter words number switches
  for (std::size_t from = 0; from < label.size();) {
    const std::size_t to = std::min(label.find(' ', from), label.size());
    if (folded(label.substr(from, to - from)) == word && to + 1 < label.size()) {
      const std::string_view rest = label.substr(to + 1);
      const std::vector<std::string> next = wordsOf(rest.substr(0, rest.find(' ')));
      const bool isSmall = rest.front() >= 'a' && rest.front() <= 'z';
      return isSmall && next.size() == 1 && letterCount(next.front()) >= fewest &&
             !matchWord(next.front(),
                        {WordKind::press, WordKind::release, WordKind::curve, WordKind::variant,
                         WordKind::quantity, WordKind::wear},
                        source);
    }
    from = to + 1;
  }
  return false;
}

/// Strokes for which a text has words or signs.
SignedStrokes strokesIn(std::string_view utf8, TextSource source) {
  SignedStrokes named = strokesSignedIn(utf8);
  if (const auto lone = loneStroke(utf8)) (*lone == Stroke::press ? named.press : named.release) = true;
  for (const std::string& word : ownNamesOf(utf8)) {
    if (isAttribute(utf8, word, source)) continue;
    const auto stroke = strokeOfWord(word, source);
    named.press = named.press || stroke == Stroke::press;
    named.release = named.release || stroke == Stroke::release;
  }
  return named;
}

/// Returns true if a word, without its signs for strokes, is empty or a stroke's word.
bool isStrokeWord(const std::string& word, TextSource source) {
  return word.empty() || strokeOfWord(word, source) || strokeOfPart(word);
}

/// Words that are neither for a stroke nor for a curve.
std::vector<std::string> wordsBesideStroke(std::string_view utf8, TextSource source) {
  if (loneStroke(utf8)) return {};
  std::vector<std::string> words = wordsOf(utf8);
  for (std::string& word : words) word = withoutStrokeSigns(word);
  std::erase_if(words, [&](const std::string& word) {
    return isStrokeWord(word, source) || isCurveWord(word, source);
  });
  return words;
}

/// Words that belong to a switch's own name: neither for strokes nor common to legends.
std::vector<std::string> ownWords(std::string_view utf8, TextSource source) {
  constexpr std::size_t fewestOfFragment = 3;  // letters
  std::vector<std::string> own = wordsBesideStroke(utf8, source);
  std::erase_if(own, [&](const std::string& word) {
    const auto isOwn = [](const LexiconEntry& entry) {
      return entry.value == "force" || entry.value == "travel";
    };
    const auto quantity = matchWord(word, {WordKind::quantity}, source);
    if (quantity) return isOwn(*quantity->entry);
    // "rce curve": a legend key covers the beginning.
    return source == TextSource::recognised && letterCount(word) >= fewestOfFragment &&
           std::ranges::any_of(entriesOf(WordKind::quantity), [&](const LexiconEntry& entry) {
             return isOwn(entry) && entry.form == WordForm::whole && entry.word.ends_with(word);
           });
  });
  return own;
}

/// Returns true if a text states how worn a switch is, and names no stroke: "after 1 million strokes".
bool namesWear(std::string_view utf8, TextSource source) {
  const auto saysSo = [](const std::string& word) {
    return matchWord(word, {WordKind::wear}, TextSource::exact).has_value();
  };
  return !strokeNamedBy(utf8, source) &&
         (std::ranges::any_of(wordsOf(utf8), saysSo) || holdsSign(utf8, WordKind::wear));
}

/// Returns true if a word is the beginning or the end of a word of this kind, with the rest covered by a
/// legend key or a frame.
bool isFragmentOf(const std::string& word, WordKind kind) {
  return std::ranges::any_of(entriesOf(kind), [&](const LexiconEntry& entry) {
    return entry.form == WordForm::whole && (entry.word.starts_with(word) || entry.word.ends_with(word));
  });
}

/// Returns true if a recognised text may be the misread name of a stroke: one word with too many wrong
/// letters to be certain, a fragment of one, or one or two letters.
bool mayBeMisread(std::string_view utf8, Stroke stroke, TextSource source) {
  constexpr std::size_t fewest = 3;  // letters of a name
  const std::vector<std::string> words = wordsOf(utf8);
  if (source == TextSource::exact || words.size() != 1) return false;
  const std::string& word = words.front();
  return letterCount(word) < fewest || strokeLike(word) == stroke ||
         isFragmentOf(word, stroke == Stroke::press ? WordKind::press : WordKind::release);
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

/// Returns true for a separator, which is removed together with the word beside it.
bool isJoint(char c) { return std::string_view(" _-/:,;()[]").find(c) != std::string_view::npos; }

/// Removes the words for strokes from one text.
std::string withoutStrokeWords(std::string_view utf8, TextSource source) {
  if (loneStroke(utf8)) return {};
  std::string name;
  bool shortened = false;
  for (std::size_t i = 0; i < utf8.size();) {
    std::size_t to = i;
    while (to < utf8.size() && isJoint(utf8[to]) == isJoint(utf8[i])) ++to;
    const std::string_view part = utf8.substr(i, to - i);
    const std::vector<std::string> words = wordsOf(part);
    const bool namesStroke = words.size() == 1 && isStrokeWord(withoutStrokeSigns(words.front()), source);
    shortened = shortened || namesStroke;
    if (!namesStroke) name += part;
    i = to;
  }
  if (!shortened) return name;
  for (const std::string_view emptied : {"()", "[]"})
    if (const auto at = name.find(emptied); at != std::string::npos) name.erase(at, emptied.size());
  // brackets around the stroke's word are removed with it; brackets of the name stay
  const auto isRest = [&](char c) {
    const bool opened = name.find('(') != std::string::npos || name.find('[') != std::string::npos;
    return isJoint(c) && !(opened && (c == ')' || c == ']'));
  };
  while (!name.empty() && isRest(name.back())) name.pop_back();
  name.erase(name.begin(), std::find_if_not(name.begin(), name.end(), isJoint));
  return name;
}

}  // namespace

bool namesACurve(std::string_view utf8, TextSource source) {  // a callout beside its leader names a point
  const std::vector<std::string> words = wordsOf(utf8);
  const auto isYearOrSize = [](const std::string& number) { return number.size() > 1; };  // "2019", "55"
  return words.empty() ? std::ranges::any_of(numbersOf(utf8), isYearOrSize)
                       : !namesPoint(utf8, words, source);
}

bool mayNameAPoint(std::string_view utf8) { return std::ranges::any_of(wordsOf(utf8), mayBePointWord); }

bool namesOnePair(std::string_view a, std::string_view b, TextSource source) {
  if (!namesACurve(a, source) || !namesACurve(b, source) ||
      strokeNamedBy(a, source) == strokeNamedBy(b, source))
    return false;
  return ownWords(a, source) == ownWords(b, source) && numbersOf(a) == numbersOf(b);
}

bool namesBothStrokes(std::string_view label, TextSource source) {
  const SignedStrokes named = strokesIn(label, source);
  return named.press && named.release;
}

bool namesNothingButRelease(std::string_view utf8, TextSource source) {
  return (strokeNamedBy(utf8, source) == Stroke::release ||
          (namesBothStrokes(utf8, source) && namesACurve(utf8, source))) &&
         wordsBesideStroke(utf8, source).empty() && numbersOf(utf8).empty();
}

bool isDefaultName(std::string_view utf8) {
  std::string name = folded(utf8);
  std::erase(name, ' ');
  // "'a.txt' using 1:2"
  if (name.find("using") != std::string::npos && name.find(':') != std::string::npos) return true;
  return std::ranges::any_of(entriesOf(WordKind::series), [&](const LexiconEntry& entry) {
    if (!name.starts_with(entry.word)) return false;
    const std::string_view rest = std::string_view(name).substr(entry.word.size());
    if (entry.value == "letter") return rest.size() == 1;
    // "l" is a misread one
    return rest == "l" || (!rest.empty() && rest.find_first_not_of("0123456789") == std::string_view::npos);
  });
}

bool namesNoStroke(std::string_view utf8, TextSource source) {
  return namesACurve(utf8, source) && !strokeNamedBy(utf8, source) && !namesBothStrokes(utf8, source) &&
         !isDefaultName(utf8) && !ownWords(utf8, source).empty();
}

bool mayNameAStroke(std::string_view utf8, TextSource source) {
  constexpr std::size_t fewest = 3;  // least letters; shorter words number switches
  const std::vector<std::string> words = wordsOf(utf8);
  return namesNoStroke(utf8, source) && words.size() == 1 && words.front().size() >= fewest &&
         numbersOf(utf8).empty() && !matchWord(words.front(), {WordKind::variant}, TextSource::exact);
}

std::string switchNamedBy(std::string_view utf8, TextSource source) {
  std::vector<std::string> names;
  for (std::size_t from = 0; from <= utf8.size();) {
    const std::size_t to = std::min(utf8.find(kLabelParting, from), utf8.size());
    std::string name = withoutStrokeWords(utf8.substr(from, to - from), source);
    if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(std::move(name));
    from = to + kLabelParting.size();
  }
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : std::string(kLabelParting)) + name;
  return all;
}

bool mayBeOnePair(std::string_view a, std::string_view b, TextSource source) {
  if (namesWear(a, source) != namesWear(b, source)) return false;
  if (!namesACurve(a, source) || !namesACurve(b, source)) return true;
  const std::optional<Stroke> ofA = strokeNamedBy(a, source), ofB = strokeNamedBy(b, source);
  if (ofA == ofB) return false;
  const std::vector<std::string> ownOfA = ownWords(a, source), ownOfB = ownWords(b, source);
  if (ofA && ofB) return ownOfA == ownOfB || ownOfA.empty() || ownOfB.empty();
  // If only one name contains a stroke's word, the other is the name of the switch itself ("Switch A",
  // "Switch A release"), or was misread.
  const Stroke other =
      ofA.value_or(ofB.value_or(Stroke::press)) == Stroke::press ? Stroke::release : Stroke::press;
  return ownOfA == ownOfB || mayBeMisread(ofA ? b : a, other, source);
}

std::optional<Stroke> strokeNamedBy(std::string_view utf8, TextSource source) {
  const std::vector<std::string> words = wordsOf(utf8);
  if (namesPoint(utf8, words, source)) return {};
  const SignedStrokes named = strokesIn(utf8, source);
  if (named.press == named.release)
    return named.press || words.size() != 1 || source == TextSource::exact ? std::nullopt
                                                                           : strokeOfPart(words.front());
  return named.press ? Stroke::press : Stroke::release;
}

}  // namespace detent::importer
