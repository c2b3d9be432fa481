// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/lexicon/stroke_words.h"

#include <algorithm>
#include <cstddef>

namespace detent::importer {
namespace {

std::optional<Stroke> onlyOne(bool press, bool release) {
  if (press == release) return {};
  return press ? Stroke::press : Stroke::release;
}

/// A German compound of a stroke and a word for a curve: "Rückstellkurve", "Entlastungsvorgang".
bool isCompoundOf(std::string_view word, WordKind kind) {
  const auto isEnd = [&](std::string_view rest) {
    return std::ranges::any_of(entriesOf(WordKind::curve), [&](const LexiconEntry& entry) {
      return entry.form == WordForm::end && entry.word == rest;
    });
  };
  return std::ranges::any_of(entriesOf(kind), [&](const LexiconEntry& entry) {
    return entry.form == WordForm::beginning && word.starts_with(entry.word) &&
           isEnd(word.substr(entry.word.size()));
  });
}

bool isArrow(const LexiconEntry& entry) { return entry.value == "arrow"; }
bool isLone(const LexiconEntry& entry) { return entry.value == "alone"; }

/// The stroke of the nearest word; empty if a rival is as near.
struct Nearest {
  std::optional<Stroke> stroke;
  bool explained = true;
};
Nearest nearestStroke(std::string_view word, TextSource source) {
  auto press = matchWord(word, {WordKind::press}, source),
       release = matchWord(word, {WordKind::release}, source);
  if (press && isLone(*press->entry)) press.reset();
  if (release && isLone(*release->entry)) release.reset();
  if (!press && !release) return {};
  const bool isPress = press && (!release || press->cost < release->cost);
  const WordMatch& best = isPress ? *press : *release;
  if (press && release && press->cost == release->cost) return {};
  const auto rival = matchWord(word, {WordKind::variant}, source);
  if (rival && rival->cost < best.cost) return {};
  return {isPress ? Stroke::press : Stroke::release, best.explained};
}

}  // namespace

std::optional<Stroke> strokeOfWord(std::string_view word, TextSource source) {
  const Nearest nearest = nearestStroke(word, source);
  if (nearest.stroke && nearest.explained) return nearest.stroke;
  return onlyOne(isCompoundOf(word, WordKind::press), isCompoundOf(word, WordKind::release));
}

std::optional<Stroke> strokeLike(std::string_view word) {
  return nearestStroke(word, TextSource::recognised).stroke;
}

std::optional<Stroke> strokeOfLoneWord(std::string_view word) {
  const auto isIn = [&](WordKind kind) {
    return std::ranges::any_of(entriesOf(kind),
                               [&](const LexiconEntry& e) { return isLone(e) && e.word == word; });
  };
  return onlyOne(isIn(WordKind::press), isIn(WordKind::release));
}

std::optional<Stroke> strokeOfPart(std::string_view word) {
  constexpr std::size_t fewest = 5;   // letters
  constexpr double leastShare = 0.6;  // share of the word that is visible beside the hidden end
  if (letterCount(word) < fewest) return {};
  const auto isPart = [&](const LexiconEntry& entry) {
    return entry.form == WordForm::whole &&
           (entry.word.ends_with(word) ||
            (entry.word.starts_with(word) &&
             static_cast<double>(word.size()) >= leastShare * static_cast<double>(entry.word.size())));
  };
  if (matchWord(word, {WordKind::variant}, TextSource::exact)) return {};
  return onlyOne(std::ranges::any_of(entriesOf(WordKind::press), isPart),
                 std::ranges::any_of(entriesOf(WordKind::release), isPart));
}

bool isPointWord(std::string_view word, TextSource source) {
  const auto match = matchWord(word, {WordKind::point}, source);
  return match && match->explained;
}

bool mayBePointWord(std::string_view word) {
  const auto match = matchWord(word, {WordKind::press, WordKind::release}, TextSource::recognised);
  return match && match->entry->value == "or point";
}

bool isCurveWord(std::string_view word, TextSource source) {
  const auto match = matchWord(word, {WordKind::curve}, source);
  return match && match->explained && match->entry->form == WordForm::whole;
}

bool holdsSign(std::string_view utf8, WordKind kind) {
  return std::ranges::any_of(entriesOf(kind), [&](const LexiconEntry& entry) {
    return entry.form == WordForm::sign && !isArrow(entry) && utf8.find(entry.word) != std::string_view::npos;
  });
}

SignedStrokes strokesSignedIn(std::string_view utf8) {
  const auto hasArrow = [&](WordKind kind) {
    return std::ranges::any_of(entriesOf(kind), [&](const LexiconEntry& entry) {
      return isArrow(entry) && (utf8.starts_with(entry.word) || utf8.ends_with(entry.word));
    });
  };
  return {holdsSign(utf8, WordKind::press) || hasArrow(WordKind::press),
          holdsSign(utf8, WordKind::release) || hasArrow(WordKind::release)};
}

std::string withoutStrokeSigns(std::string_view word) {
  std::string rest(word);
  const auto take = [&](WordKind kind) {
    for (const LexiconEntry& entry : entriesOf(kind)) {
      if (entry.form != WordForm::sign) continue;
      if (!isArrow(entry)) {
        if (const auto at = rest.find(entry.word); at != std::string::npos) rest.erase(at, entry.word.size());
      } else if (rest.starts_with(entry.word)) {
        rest.erase(0, entry.word.size());
      } else if (rest.ends_with(entry.word)) {
        rest.resize(rest.size() - entry.word.size());
      }
    }
  };
  take(WordKind::press);
  take(WordKind::release);
  if (rest.size() != word.size()) take(WordKind::curve);
  return rest;
}

std::string_view cyrillicWordLike(std::string_view read) {
  constexpr std::size_t fewest = 6;  // letters; shorter words resemble Latin ones by chance
  const auto match = matchWord(read, {WordKind::press, WordKind::release}, TextSource::recognised);
  const bool isLong = match && letterCount(match->entry->word) >= fewest;
  return isLong && hasCyrillic(match->entry->word) ? match->entry->word : std::string_view();
}

std::string withoutOtherNames(std::string_view foldedText) {
  std::string text = " " + std::string(foldedText) + " ";
  for (const LexiconEntry& entry : entriesOf(WordKind::variant)) {
    if (entry.form != WordForm::phrase) continue;
    const std::string phrase = " " + std::string(entry.word) + " ";
    for (auto at = text.find(phrase); at != std::string::npos; at = text.find(phrase))
      text.replace(at, phrase.size(), " ");
  }
  return text.size() < 2 ? std::string() : text.substr(1, text.size() - 2);
}

}  // namespace detent::importer
