// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/strokes/switches.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <iterator>
#include <utility>

#include "importer/lexicon/stroke_words.h"
#include "importer/strokes/closed_loops.h"
#include "importer/strokes/legend.h"

namespace detent::importer {

namespace {

using Indices = std::vector<std::size_t>;

std::optional<Stroke> namedStroke(const CurveTrace& trace) {
  return trace.stroke ? trace.stroke : strokeNamedBy(trace.label);
}

/// Returns true for two strokes of one colour that the tracer separated.
bool shareAColour(const CurveTrace& a, const CurveTrace& b) {
  return a.color == b.color && a.stroke && b.stroke && *a.stroke != *b.stroke;
}

/// Removes arrows and leaders that have colours of their own: curves without a name that fall monotonically,
/// if the legend names a stroke among more than two curves.
Indices withoutMarks(const std::vector<CurveTrace>& traces, const Indices& drawn) {
  const auto isNamed = [&](std::size_t i) { return namedStroke(traces[i]).has_value(); };
  if (drawn.size() < 3 || std::ranges::none_of(drawn, isNamed)) return drawn;
  Indices kept;
  std::ranges::copy_if(drawn, std::back_inserter(kept), [&](std::size_t i) {
    return traces[i].stroke || !traces[i].label.empty() || !onlyFalls(traces[i]);
  });
  return kept;
}

/// Returns true if two names that contain nothing but a stroke are equal: characters that differ in few lines
/// were read alike.
bool readAlike(const CurveTrace& a, const CurveTrace& b) {
  return !a.stroke && !b.stroke && a.label == b.label && strokeNamedBy(a.label) &&
         switchNamedBy(a.label).empty();
}

/// Two curves that close a loop, whatever their names are.
std::optional<std::pair<std::size_t, std::size_t>> loopOf(std::vector<CurveTrace> traces,
                                                          const Indices& two) {
  for (CurveTrace& trace : traces) trace.label.clear();
  const std::vector<Indices> loops = closedLoops(traces, two);
  if (loops.size() != 1) return {};
  return std::pair(loops.front().front(), loops.front().back());
}

/// Loops formed by curves that have only a program's default names.
std::vector<Indices> loopsWithoutNames(std::vector<CurveTrace> traces, const Indices& drawn) {
  const auto isNameless = [&](std::size_t i) { return isDefaultName(traces[i].label) && !traces[i].stroke; };
  if (!std::ranges::all_of(drawn, isNameless)) return {};
  for (CurveTrace& trace : traces) trace.label.clear();
  return closedLoops(traces, drawn);
}

/// The press and the release that were named, by hand or by the legend, among curves without names (marks and
/// leaders). If the legend calls one just "press", the other's name may be misread.
std::optional<std::pair<std::size_t, std::size_t>> theNamedPair(const std::vector<CurveTrace>& traces,
                                                                const Indices& drawn) {
  Indices named;
  for (const std::size_t i : drawn)
    if (namedStroke(traces[i]) || namesACurve(traces[i].label)) named.push_back(i);
  if (named.size() != 2) return {};
  const CurveTrace &a = traces[named[0]], &b = traces[named[1]];
  if (namedStroke(a) == namedStroke(b)) return readAlike(a, b) ? loopOf(traces, named) : std::nullopt;
  const CurveTrace& sure = namedStroke(a) ? a : b;
  const bool bothNamed = namedStroke(a) && namedStroke(b);
  if (!bothNamed && !sure.stroke && !switchNamedBy(sure.label).empty()) return {};
  // another curve of this colour belongs to another switch
  if (drawn.size() > 2 && shareAColour(a, b)) return {};
  const bool byHand = a.stroke && b.stroke;
  if (!byHand && !mayBeOnePair(a.label, b.label)) return {};
  return std::pair(named[0], named[1]);
}

/// Returns true if this trace alone has a name that could not be read, and none of the other names is a
/// stroke's.
bool isUnreadName(std::size_t partner, const std::vector<CurveTrace>& traces, const Indices& drawn) {
  constexpr std::size_t fewest = 3;
  if (drawn.size() < fewest || !traces[partner].label.empty() || traces[partner].labelBox_px.empty())
    return false;
  return std::ranges::all_of(drawn, [&](std::size_t i) {
    return !namedStroke(traces[i]) && (i == partner || namesACurve(traces[i].label));
  });
}

/// Each trace's partner; a press without a release is its own. Empty if a trace has several, or if a release
/// has none.
std::vector<Indices> partnered(const std::vector<CurveTrace>& traces, const Indices& drawn) {
  std::vector<Indices> groups;
  for (const std::size_t i : drawn) {
    Indices partners, ofSameColour;
    for (const std::size_t j : drawn) {
      if (j == i) continue;
      if (shareAColour(traces[i], traces[j])) ofSameColour.push_back(j);
      if (namesOnePair(traces[i].label, traces[j].label)) partners.push_back(j);
    }
    // In a legend divided into groups, the strokes of every switch have the same names.
    if (!ofSameColour.empty()) partners = ofSameColour;
    const bool hasName = namesACurve(traces[i].label) || isUnreadName(i, traces, drawn);
    const bool alone = partners.empty() && hasName && namedStroke(traces[i]) != Stroke::release;
    if (partners.size() > 1 || (partners.empty() && !alone)) return {};
    if (alone) groups.push_back({i});
    if (!partners.empty() && i < partners.front()) groups.push_back({i, partners.front()});
  }
  return groups;
}

/// Returns true for two curves in different colours whose names may be words for strokes in an unlisted
/// language and whose paths are those of strokes.
bool areStrokesByPath(const std::vector<CurveTrace>& traces, const Indices& drawn) {
  if (drawn.size() != 2) return false;
  const CurveTrace &a = traces[drawn[0]], &b = traces[drawn[1]];
  return a.color != b.color && mayNameAStroke(a.label) && mayNameAStroke(b.label) && closeInOnePoint(a, b);
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

PlotSwitch switchOf(Indices group, const std::vector<CurveTrace>& traces) {
  putPressFirst(group, traces);
  const CurveTrace& press = traces[group[0]];
  PlotSwitch found{press.label, press.color, {}, group};
  if (namesBothStrokes(press.label)) found.name = switchNamedBy(press.label);
  if (group.size() < 2) return found;
  found.releaseColor = traces[group[1]].color;
  found.name = switchNamedBy(press.label);
  if (found.name.empty()) found.name = switchNamedBy(traces[group[1]].label);
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
  Indices drawn;
  for (std::size_t i = 0; i < traces.size(); ++i)
    if (traces[i].points_px.size() >= 2) drawn.push_back(i);
  if (drawn.empty()) return {};
  drawn = withoutMarks(traces, drawn);
  if (drawn.size() == 1) return {switchOf(drawn, traces)};
  if (const auto pair = theNamedPair(traces, drawn)) return {switchOf({pair->first, pair->second}, traces)};
  if (areStrokesByPath(traces, drawn)) {
    PlotSwitch joined = switchOf(drawn, traces);
    joined.name.clear();
    return {joined};
  }
  const bool unnamed =
      std::ranges::all_of(drawn, [&](std::size_t i) { return !traces[i].stroke && traces[i].label.empty(); });
  const std::vector<Indices> apart = unnamed ? pressesApart(traces, drawn) : std::vector<Indices>();
  if (apart.empty() && drawn.size() == 2 && mayBeOnePair(traces[drawn[0]].label, traces[drawn[1]].label))
    return {switchOf(drawn, traces)};

  std::vector<Indices> groups = loopsWithoutNames(traces, drawn);
  if (groups.empty()) groups = partnered(traces, drawn);
  if (groups.empty()) groups = closedLoops(traces, drawn);
  if (groups.empty()) groups = apart;
  std::vector<PlotSwitch> switches;
  for (Indices& group : groups) switches.push_back(switchOf(std::move(group), traces));
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
