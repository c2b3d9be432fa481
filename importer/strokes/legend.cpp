// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/strokes/legend.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "importer/axes/word_match.h"

namespace detent::importer {

namespace {

constexpr std::array kPressWords = {
    "press",       "pressing", "pressed",   "downstroke", "down",      "push",        "pushing",
    "forward",     "loading",  "load",      "depress",    "actuate",   "actuation",   "in",
    "hinweg",      "vorlauf",  "druecken",  "drücken",    "betätigen", "betaetigen",  "betätigung",
    "betaetigung", "belasten", "belastung", "hinhub",     "appui",     "enfoncement", "aller",
    "compression", "ida",      "andata",    "нажатие",    "Нажатие",   "нажим",       "Нажим"};
constexpr std::array kReleaseWords = {
    "release",    "releasing",    "released",      "upstroke",    "up",       "return",        "returning",
    "backward",   "reverse",      "unloading",     "unload",      "reset",    "out",           "rückweg",
    "rueckweg",   "rücklauf",     "ruecklauf",     "rückhub",     "rueckhub", "loslassen",     "entlasten",
    "entlastung", "rückstellung", "rueckstellung", "relâchement", "retour",   "decompression", "vuelta",
    "ritorno",    "отпускание",   "Отпускание",    "возврат",     "Возврат"};
constexpr std::array kPressSigns = {"按压", "按下", "下压", "压下", "去程",
                                    "加载", "押下", "押す", "押し", "往路"};
constexpr std::array kReleaseSigns = {"释放", "松开", "抬起", "回弹", "回程", "弹起",
                                      "复位", "卸载", "解放", "戻り", "離す", "復路"};
/// A text with one of these names a point on a curve, not the curve.
constexpr std::array kPointWords = {"point",           "position",   "punkt", "schaltpunkt",
                                    "rückschaltpunkt", "druckpunkt", "pos"};
constexpr std::array kPointSigns = {"点", "點", "位置"};

bool isLatinLetter(unsigned char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c >= 0x80; }

/// Lower-case words; bytes above ASCII count as letters, "Ä Ö Ü" become small.
std::vector<std::string> wordsOf(std::string_view utf8) {
  std::vector<std::string> words;
  std::string word;
  for (std::size_t i = 0; i <= utf8.size(); ++i) {
    const unsigned char c = i < utf8.size() ? static_cast<unsigned char>(utf8[i]) : 0;
    if (i < utf8.size() && isLatinLetter(c)) {
      const bool afterC3 = !word.empty() && static_cast<unsigned char>(word.back()) == 0xC3;
      if (afterC3 && (c == 0x84 || c == 0x96 || c == 0x9C)) {
        word += static_cast<char>(c + 0x20);
      } else {
        word += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : static_cast<char>(c);
      }
    } else if (!word.empty()) {
      words.push_back(std::move(word));
      word.clear();
    }
  }
  return words;
}

template <class List>
bool anyWord(const std::vector<std::string>& words, const List& list) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::any_of(list.begin(), list.end(), [&](std::string_view known) {
      return word == known || (known.size() >= 6 && word.size() >= 6 && differByOneAtMost(word, known));
    });
  });
}

template <class List>
bool anySign(std::string_view text, const List& list) {
  return std::any_of(list.begin(), list.end(),
                     [&](std::string_view sign) { return text.find(sign) != std::string_view::npos; });
}

bool isStrokeWord(const std::string& word) {
  const std::vector<std::string> one{word};
  const auto isOne = [&](std::string_view sign) { return word == sign; };
  return anyWord(one, kPressWords) || anyWord(one, kReleaseWords) ||
         std::ranges::any_of(kPressSigns, isOne) || std::ranges::any_of(kReleaseSigns, isOne);
}

/// Words that name neither a stroke nor what every legend names: a switch's own name.
std::vector<std::string> ownWords(std::string_view utf8) {
  constexpr std::array kCommonWords = {"stroke", "curve",  "force", "travel", "key",     "switch",
                                       "going",  "coming", "run",   "mesure", "messung", "the",
                                       "of",     "on",     "hub",   "kraft"};
  std::vector<std::string> own;
  for (std::string& word : wordsOf(utf8)) {
    if (!isStrokeWord(word) && !anyWord(std::vector{word}, kCommonWords)) own.push_back(std::move(word));
  }
  return own;
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
  std::string name;
  bool shortened = false;
  for (std::size_t i = 0; i < utf8.size();) {
    std::size_t to = i;
    while (to < utf8.size() && isJoint(utf8[to]) == isJoint(utf8[i])) ++to;
    const std::string_view part = utf8.substr(i, to - i);
    const std::vector<std::string> words = wordsOf(part);
    const bool namesStroke = words.size() == 1 && isStrokeWord(words.front());
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
  return !words.empty() && !anyWord(words, kPointWords) && !anySign(utf8, kPointSigns);
}

bool namesOnePair(std::string_view a, std::string_view b) {
  if (!namesACurve(a) || !namesACurve(b) || strokeNamedBy(a) == strokeNamedBy(b)) return false;
  return ownWords(a) == ownWords(b) && numbersOf(a) == numbersOf(b);
}

bool namesBothStrokes(std::string_view label) {
  const std::vector<std::string> words = wordsOf(label);
  const bool press = anyWord(words, kPressWords) || anySign(label, kPressSigns);
  return press && (anyWord(words, kReleaseWords) || anySign(label, kReleaseSigns));
}

std::string switchNamedBy(std::string_view utf8) {
  constexpr std::string_view kParting = " / ";
  std::vector<std::string> names;
  for (std::size_t from = 0; from <= utf8.size();) {
    const std::size_t to = std::min(utf8.find(kParting, from), utf8.size());
    std::string name = withoutStrokeWords(utf8.substr(from, to - from));
    if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(std::move(name));
    from = to + kParting.size();
  }
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : std::string(kParting)) + name;
  return all;
}

bool mayBeOnePair(std::string_view a, std::string_view b) {
  if (!namesACurve(a) || !namesACurve(b)) return true;
  const std::optional<Stroke> ofA = strokeNamedBy(a), ofB = strokeNamedBy(b);
  if (!ofA && !ofB) return false;
  if (ofA == ofB) return false;
  return ownWords(a) == ownWords(b) || ownWords(a).empty() || ownWords(b).empty();
}

std::optional<Stroke> strokeNamedBy(std::string_view utf8) {
  const std::vector<std::string> words = wordsOf(utf8);
  if (anyWord(words, kPointWords) || anySign(utf8, kPointSigns)) return {};
  const bool press = anyWord(words, kPressWords) || anySign(utf8, kPressSigns);
  const bool release = anyWord(words, kReleaseWords) || anySign(utf8, kReleaseSigns);
  if (press == release) return {};
  return press ? Stroke::press : Stroke::release;
}

}  // namespace detent::importer
