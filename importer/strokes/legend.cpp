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

// Latin and Cyrillic words as `folded` writes them.
constexpr std::array kPressWords = {
    "press",      "pressing", "pressed",   "downstroke",  "down",      "push",        "pushing",
    "forward",    "loading",  "load",      "depress",     "actuate",   "actuation",   "in",
    "make",       "compress", "hinweg",    "hin",         "vorlauf",   "drucken",     "betatigen",
    "betatigung", "belasten", "belastung", "hinhub",      "appui",     "enfoncer",    "enfoncement",
    "aller",      "descente", "charge",    "compression", "ida",       "pulsar",      "pulsado",
    "bajada",     "carga",    "andata",    "pressione",   "presion",   "indrukken",   "heen",
    "wcisniecie", "avance",   "premuto",   "pressao",     "pulsacion", "acionamento", "vorhub",
    "abwarts",    "tryk",     "trykk",     "nacisk",      "stisk",     "tryck",       "basma",
    "нажатие",    "нажим",    "нагрузка",  "нагружение",  "прямой"};
constexpr std::array kReleaseWords = {
    "release",       "releasing",  "released",     "upstroke",    "up",          "return",     "returning",
    "back",          "backward",   "reverse",      "unloading",   "unload",      "reset",      "out",
    "break",         "decompress", "ruckweg",      "zuruck",      "rucklauf",    "ruckhub",    "loslassen",
    "entlasten",     "entlastung", "ruckstellung", "relachement", "relacher",    "remontee",   "decharge",
    "retour",        "vuelta",     "soltar",       "liberacion",  "liberacao",   "subida",     "descarga",
    "decompression", "ritorno",    "rilascio",     "volta",       "loslaten",    "terug",      "zwolnienie",
    "powrot",        "uvolneni",   "slapp",        "birakma",     "retorno",     "retroceso",  "rilasciato",
    "retur",         "tillbaka",   "aufwarts",     "relache",     "losgelassen", "отпускание", "возврат",
    "разгрузка",     "обратный"};
constexpr std::array kPressSigns = {"按压", "按下", "下压", "压下", "去程", "加载",   "正程", "下行",
                                    "押下", "押す", "押し", "押込", "往路", "プレス", "누름", "가압"};
constexpr std::array kReleaseSigns = {"释放",     "松开", "抬起", "回弹", "回程", "弹起",
                                      "复位",     "卸载", "反程", "上行", "解放", "戻り",
                                      "リリース", "戻し", "離す", "復路", "복귀", "해제"};
/// A text with one of these names a point on a curve, not the curve.
constexpr std::array kPointWords = {"point",           "position",   "punkt", "schaltpunkt",
                                    "ruckschaltpunkt", "druckpunkt", "pos"};
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

/// "rn" as readers of pixels take it: "retomo".
std::string withPairsJoined(std::string_view word) {
  std::string joined(word);
  for (auto at = joined.find("rn"); at != std::string::npos; at = joined.find("rn", at))
    joined.replace(at, 2, "m");
  return joined;
}

template <class List>
bool anyWord(const std::vector<std::string>& words, const List& list) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::any_of(list.begin(), list.end(), [&](std::string_view known) {
      return word == known || (known.size() >= 6 && word.size() >= 6 &&
                               (differByOneAtMost(word, known) || word == withPairsJoined(known)));
    });
  });
}

template <class List>
bool anySign(std::string_view text, const List& list) {
  return std::any_of(list.begin(), list.end(),
                     [&](std::string_view sign) { return text.find(sign) != std::string_view::npos; });
}

/// The stroke of a word whose beginning the legend's sample hid, by its end: "leasing". Nothing where both have such words.
std::optional<Stroke> endOfStrokeWord(const std::string& word) {
  constexpr std::size_t fewest = 5;
  const auto isEnd = [&](std::string_view known) { return known.ends_with(word); };
  const bool press = std::ranges::any_of(kPressWords, isEnd),
             release = std::ranges::any_of(kReleaseWords, isEnd);
  if (word.size() < fewest || press == release) return {};
  return press ? Stroke::press : Stroke::release;
}

bool isStrokeWord(const std::string& word) {
  const std::vector<std::string> one{word};
  const auto isOne = [&](std::string_view sign) { return word == sign; };
  return anyWord(one, kPressWords) || anyWord(one, kReleaseWords) || endOfStrokeWord(word) ||
         std::ranges::any_of(kPressSigns, isOne) || std::ranges::any_of(kReleaseSigns, isOne);
}

// What every legend names: a curve, or what it is a curve of.
constexpr std::array kCurveWords = {"stroke", "curve", "key", "switch", "going", "coming", "run", "the",
                                    "of",     "on",    "hub", "csv",    "txt",   "dat",    "ход", "phase"};
constexpr std::array kQuantityWords = {"force", "travel", "kraft", "mesure", "messung"};

/// Words that name neither a stroke nor a curve.
std::vector<std::string> wordsBesideStroke(std::string_view utf8) {
  std::vector<std::string> words = wordsOf(utf8);
  std::erase_if(words, [](const std::string& word) {
    return isStrokeWord(word) || anyWord(std::vector{word}, kCurveWords);
  });
  return words;
}

/// Words that name neither a stroke nor what every legend names: a switch's own name.
std::vector<std::string> ownWords(std::string_view utf8) {
  std::vector<std::string> own = wordsBesideStroke(utf8);
  std::erase_if(own, [](const std::string& word) { return anyWord(std::vector{word}, kQuantityWords); });
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

std::string folded(std::string_view utf8) {
  // U+00C0 to U+017F, 64 to a lead byte; a sign that is no letter stays itself.
  constexpr std::array<std::string_view, 3> base{
      "aaaaaaaceeeeiiiidnooooo ouuuuypsaaaaaaaceeeeiiiidnooooo ouuuuypy",
      "aaaaaaccccccccddddeeeeeeeeeegggggggghhhhiiiiiiiiiiiijjkkklllllll",
      "lllnnnnnnnnnoooooooorrrrrrssssssssttttttuuuuuuuuuuuuwwyyyzzzzzzs"};
  std::string out;
  for (std::size_t i = 0; i < utf8.size(); ++i) {
    const auto byte = [&](std::size_t k) {
      return k < utf8.size() ? static_cast<unsigned char>(utf8[k]) : 0U;
    };
    const unsigned lead = byte(i), next = byte(i + 1);
    const bool two = (next & 0xC0U) == 0x80U;
    if (two && lead >= 0xC3 && lead <= 0xC5 && base[lead - 0xC3][next - 0x80] != ' ') {
      out += base[lead - 0xC3][next - 0x80], ++i;
    } else if (two && lead == 0xD0 && next >= 0x90 && next <= 0xAF) {  // Cyrillic capitals
      const bool first = next < 0xA0;
      out += static_cast<char>(first ? 0xD0 : 0xD1);
      out += static_cast<char>(first ? next + 0x20 : next - 0x20), ++i;
    } else {
      out += lead >= 'A' && lead <= 'Z' ? static_cast<char>(lead - 'A' + 'a') : utf8[i];
    }
  }
  return out;
}

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
  if (press == release) return press || words.size() != 1 ? std::nullopt : endOfStrokeWord(words.front());
  return press ? Stroke::press : Stroke::release;
}

}  // namespace detent::importer
