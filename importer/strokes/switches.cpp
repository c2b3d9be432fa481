// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/strokes/switches.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <iterator>
#include <utility>

#include "importer/lexicon/stroke_words.h"
#include "importer/strokes/legend.h"
#include "importer/strokes/pairings.h"

namespace detent::importer {

namespace {

using Indices = std::vector<std::size_t>;

std::optional<Stroke> namedStroke(const CurveTrace& trace) {
  return trace.stroke ? trace.stroke : strokeNamedBy(trace.label);
}

double meanRow(const CurveTrace& trace) {
  double sum = 0;
  for (const Point& p : trace.points_px) sum += p.y;
  return sum / static_cast<double>(trace.points_px.size());
}

/// Puts the press first: by name, else the higher curve.
void putPressFirst(Indices& pair, const std::vector<CurveTrace>& traces) {
  if (pair.size() < 2) return;
  const CurveTrace &a = traces[pair[0]], &b = traces[pair[1]];
  const std::optional<Stroke> ofA = namedStroke(a), ofB = namedStroke(b);
  const bool separated = ofA != ofB;
  const bool exchanged = separated ? ofA == Stroke::release || ofB == Stroke::press : meanRow(a) > meanRow(b);
  if (exchanged) std::swap(pair[0], pair[1]);
}

PlotSwitch switchOf(const Pairing& pairing, const std::vector<CurveTrace>& traces) {
  Indices group{pairing.trace};
  if (pairing.other) group.push_back(*pairing.other);
  putPressFirst(group, traces);
  const CurveTrace& press = traces[group[0]];
  PlotSwitch found{press.label, press.color, {}, group, confidenceOf(pairing)};
  if (namesBothStrokes(press.label)) found.name = switchNamedBy(press.label);
  if (group.size() < 2) return found;
  const CurveTrace& release = traces[group[1]];
  found.releaseColor = release.color;
  found.name = switchNamedBy(press.label);
  if (found.name.empty()) found.name = switchNamedBy(release.label);
  // words for strokes in an unlisted language; one colour has one name, that of its switch
  if (press.color != release.color && mayNameAStroke(press.label) && mayNameAStroke(release.label))
    found.name.clear();
  return found;
}

/// Sorts switches in the order of the legend, row by row from its top. Labels are in one row if the middle of
/// one lies within the height of the other.
void putInLegendOrder(std::vector<PlotSwitch>& switches, const std::vector<CurveTrace>& traces) {
  const auto labelOf = [&](const PlotSwitch& s) { return traces[s.traces.front()].labelBox_px; };
  std::sort(switches.begin(), switches.end(), [&](const PlotSwitch& a, const PlotSwitch& b) {
    return labelOf(a).middle().y < labelOf(b).middle().y;
  });
  for (auto row = switches.begin(); row != switches.end();) {
    const double labelBottom = labelOf(*row).y1;
    const auto next = std::find_if(row, switches.end(),
                                   [&](const PlotSwitch& s) { return labelOf(s).middle().y > labelBottom; });
    std::sort(row, next,
              [&](const PlotSwitch& a, const PlotSwitch& b) { return labelOf(a).x0 < labelOf(b).x0; });
    row = next;
  }
}

std::string listOf(const std::vector<PlotSwitch>& switches) {
  std::string list;
  for (std::size_t i = 0; i < switches.size(); ++i) {
    const PlotSwitch& s = switches[i];
    list += (i > 0 ? ", " : "") + std::to_string(i + 1);
    if (!s.name.empty()) list += " \"" + s.name + "\"";
    list += " (" + nameOf(s.pressColor) + (s.releaseColor ? " and " + nameOf(*s.releaseColor) : "") + ")";
  }
  return list;
}

/// Lower case without accents, letters and digits only; other bytes above ASCII stay.
std::string bare(std::string_view name) {
  std::string out;
  for (const char c : folded(name)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 || std::isalnum(byte)) out += static_cast<char>(byte < 0x80 ? std::tolower(byte) : byte);
  }
  return out;
}

/// The name with letters that resemble each other in pixels replaced by one of them.
std::string blurred(std::string_view name) {
  constexpr std::string_view kConfusable = "0o1l5s8b2zil";  // first like second, third like fourth, ...
  std::string out = bare(name);
  for (char& c : out)
    for (std::size_t i = 0; i < kConfusable.size(); i += 2)
      if (c == kConfusable[i]) c = kConfusable[i + 1];
  return out;
}

/// Indices of switches with a name, or a legend text of a stroke, that equals the requested one after both
/// pass through `spelled`.
template <class Spelled>
Indices named(const std::vector<PlotSwitch>& switches, const std::vector<CurveTrace>& traces,
              const std::string& requested, Spelled spelled) {
  const std::string wanted = spelled(requested);
  Indices fitting;
  for (std::size_t i = 0; i < switches.size() && !wanted.empty(); ++i) {
    bool fits = spelled(switches[i].name) == wanted;
    for (const std::size_t t : switches[i].traces) fits = fits || spelled(traces[t].label) == wanted;
    if (fits) fitting.push_back(i);
  }
  return fitting;
}

/// Switches whose name is the end of the requested one: the legend key was read together with the rest of it.
Indices namedByTheirEnds(const std::vector<PlotSwitch>& switches, const std::string& requested) {
  constexpr std::size_t fewest = 4;  // letters and digits
  const std::string wanted = bare(requested);
  Indices fitting;
  for (std::size_t i = 0; i < switches.size(); ++i)
    if (const std::string name = bare(switches[i].name); name.size() >= fewest && wanted.ends_with(name))
      fitting.push_back(i);
  return fitting;
}

/// Words of letters and digits, lower case; bytes above ASCII are letters.
std::vector<std::string> nameWordsOf(std::string_view name) {
  std::vector<std::string> words(1);
  for (const char c : folded(name)) {
    const std::string letter = bare({&c, 1});
    if (!letter.empty())
      words.back() += letter;
    else if (!words.back().empty())
      words.emplace_back();
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

/// Returns true if a word of at least five letters differs from another in one inner letter, which a text
/// engine may have misread. First and last letters and digits distinguish switches: "SwitchA", "Mk2".
bool isMisreadOf(const std::string& read, const std::string& requested) {
  constexpr std::size_t fewest = 5;
  if (read.size() != requested.size() || requested.size() < fewest) return false;
  const auto [here, there] = std::ranges::mismatch(read, requested);
  if (there == requested.begin() || there == requested.end() || std::next(there) == requested.end())
    return false;
  const auto isLetter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  return isLetter(*here) && isLetter(*there) && std::equal(std::next(here), read.end(), std::next(there));
}

/// Switches whose name differs from the request in one misread letter of one long word.
Indices namedNearly(const std::vector<PlotSwitch>& switches, const std::string& requested) {
  const std::vector<std::string> wanted = nameWordsOf(requested);
  Indices fitting;
  for (std::size_t i = 0; i < switches.size(); ++i) {
    const std::vector<std::string> words = nameWordsOf(switches[i].name);
    if (words.size() != wanted.size() || words.empty()) continue;
    const auto [here, there] = std::ranges::mismatch(words, wanted);
    if (there != wanted.end() && isMisreadOf(*here, *there) &&
        std::equal(std::next(here), words.end(), std::next(there)))
      fitting.push_back(i);
  }
  return fitting;
}

std::optional<std::size_t> numbered(const std::string& requested, std::size_t count) {
  std::size_t number = 0;
  const char* const end = requested.data() + requested.size();
  const auto [after, error] = std::from_chars(requested.data(), end, number);
  if (error != std::errc() || after != end || number < 1 || number > count) return {};
  return number - 1;
}

constexpr const char* kPlace = "plot frame";

}  // namespace

std::vector<PlotSwitch> switchesAmong(const std::vector<CurveTrace>& traces) {
  std::vector<PlotSwitch> switches;
  for (const Pairing& each : bestPairings(traces)) switches.push_back(switchOf(each, traces));
  const auto isSure = [](const PlotSwitch& each) { return each.sure >= leastSure; };
  if (switches.size() > 1 && !std::ranges::all_of(switches, isSure)) return {};
  const bool inLegend = std::none_of(switches.begin(), switches.end(), [&](const PlotSwitch& s) {
    return traces[s.traces.front()].labelBox_px.empty();
  });
  if (inLegend) {
    putInLegendOrder(switches, traces);
  } else {
    std::sort(switches.begin(), switches.end(), [&](const PlotSwitch& a, const PlotSwitch& b) {
      return meanRow(traces[a.traces.front()]) < meanRow(traces[b.traces.front()]);
    });
  }
  return switches;
}

Result<std::size_t> chosenSwitch(const std::vector<PlotSwitch>& switches,
                                 const std::vector<CurveTrace>& traces, const std::string& requested) {
  const Remedies choose = RemedyKind::chooseSwitch;
  if (requested.empty()) {
    if (switches.size() == 1) return std::size_t{0};
    return failureOf({DoubtCode::severalSwitches, {switches.size(), listOf(switches)}, choose}, kPlace);
  }
  for (const Indices& fitting :
       {named(switches, traces, requested, [](const std::string& s) { return s; }),
        named(switches, traces, requested, [](const std::string& s) { return bare(s); }),
        named(switches, traces, requested, [](const std::string& s) { return blurred(s); }),
        namedByTheirEnds(switches, requested), namedNearly(switches, requested)})
    if (fitting.size() == 1) return fitting.front();
  if (const auto index = numbered(requested, switches.size())) return *index;
  Failure notThere{FailureCode::wrongUsage, kPlace, "",
                   Message("no single curve is named \"%1\"; the plot shows %2", requested, listOf(switches)),
                   choose};
  notThere.reason = nameOf(DoubtCode::severalSwitches);
  return notThere;
}

bool isNamed(const std::vector<PlotSwitch>& switches, std::size_t partner,
             const std::vector<CurveTrace>& traces, const std::string& requested) {
  return numbered(requested, switches.size()) == partner ||
         !named({switches[partner]}, traces, requested, blurred).empty();
}

}  // namespace detent::importer
