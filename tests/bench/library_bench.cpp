// SPDX-License-Identifier: GPL-3.0-or-later
// library_bench DATABASE [--out docs/measurements/bench-library.md]: is a switch found by another
// laboratory's record of it? The database holds clones of force-curves-tidy and of the Open-Switch curve
// meter, indexed by detent-import. Pairs are switches of one name in both; weights are fitted without the
// pair that is judged. Figures: docs/measurements/bench-library.md, between the marks.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "importer/library/feel_distance.h"
#include "importer/library/store.h"
#include "model/text.h"

using namespace detent;
using namespace detent::importer;

namespace {

using Words = std::set<std::string>;

/// Words by which one laboratory says who made a switch and the other does not.
const Words makers{"gateron",   "jwk",      "jwick",     "durock",    "tecsee",   "kailh",     "ktt",
                   "outemu",    "gazzew",   "nk",        "zealpc",    "akko",     "novelkeys", "cherry",
                   "everglide", "haimu",    "huano",     "tkc",       "redragon", "bsun",      "kbdfans",
                   "ttc",       "aflion",   "alphakeys", "jerrzi",    "sp",       "momoka",    "leobog",
                   "star",      "keychron", "equalz",    "adobaulabs"};
/// Words that say nothing of which switch it is.
const Words said{"switch",     "switches",   "the", "by",      "stock",
                 "monochrome", "remeasured", "low", "profile", "linear"};

struct Named {
  Words maker, model;
};

bool isMark(const std::string& word) { return word.size() == 1 && word[0] >= '0' && word[0] <= '9'; }

Named namedBy(const std::string& name) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : lowered(name) + " ") {
    const bool kept = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '.';
    if (kept) word += c;
    if (kept || word.empty()) continue;
    if (word == "c3equalz")
      words.insert(words.end(), {"c3", "equalz"});
    else if (!said.contains(word))
      words.push_back(word);
    word.clear();
  }
  if (words.size() > 1 && isMark(words.back())) words.pop_back();  // mark of the unit
  Named named;
  for (const std::string& each : words) (makers.contains(each) ? named.maker : named.model).insert(each);
  return named;
}

bool within(const Words& a, const Words& b) { return std::ranges::includes(b, a); }

/// One model, no maker against another, and more than one common word if no maker is common.
bool isSame(const Named& a, const Named& b) {
  if (a.model.empty() || a.model != b.model || !(within(a.maker, b.maker) || within(b.maker, a.maker)))
    return false;
  const bool commonMaker =
      std::ranges::any_of(a.maker, [&](const std::string& each) { return b.maker.contains(each); });
  return commonMaker || (a.model.size() > 1 && !(a.maker.empty() && b.maker.empty())) || a.model.size() > 2;
}

/// One record of one laboratory, with its differences to every record of the other.
struct Query {
  std::vector<std::vector<FeelDifference>> to;
  std::vector<std::size_t> same;
};
struct Pair {
  std::string name;
  std::vector<Query> queries;
};

std::vector<Pair> pairsOf(const std::vector<LibrarySwitch>& wanted, const std::vector<LibrarySwitch>& among) {
  std::vector<Named> names;
  for (const LibrarySwitch& each : among) names.push_back(namedBy(each.name));
  std::map<Words, Pair> pairs;
  for (const LibrarySwitch& each : wanted) {
    const Named name = namedBy(each.name);
    Query query;
    for (std::size_t i = 0; i < among.size(); ++i)
      if (isSame(name, names[i])) query.same.push_back(i);
    if (query.same.empty()) continue;
    const FeelDistance distance(each.shape);
    for (const LibrarySwitch& other : among) query.to.push_back(distance.differencesTo(other.shape));
    Pair& pair = pairs[name.model];
    pair.name = each.name;
    pair.queries.push_back(std::move(query));
  }
  std::vector<Pair> list;
  for (auto& [model, pair] : pairs) list.push_back(std::move(pair));
  return list;
}

double medianOf(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

/// Result of one set of weights for one pair; medians over the pair's records.
struct Outcome {
  double rank = 0, distance_gf = 0, logChance = 0;
};

/// The chance that the right one is drawn, where nearness decides with the noise of laboratories; one in
/// fifty pairs is no pair at all.
double logChanceOf(const std::vector<double>& distances_gf, double right_gf) {
  constexpr double noise_gf = 1.5, notTheSame = 0.02;
  const auto likeness = [&](double d_gf) {
    return std::exp(-(d_gf * d_gf - right_gf * right_gf) / (2 * noise_gf * noise_gf));
  };
  double sum = 0;
  for (const double each : distances_gf) sum += likeness(each);
  return std::log((1 - notTheSame) / sum + notTheSame / double(distances_gf.size()));
}

Outcome outcomeOf(const Pair& pair, const FeelWeights& weights) {
  std::vector<double> ranks, distances, chances;
  for (const Query& query : pair.queries) {
    std::vector<double> all;
    for (const auto& each : query.to) all.push_back(distance_gf(each, weights));
    double right = all[query.same.front()];
    for (const std::size_t i : query.same) right = std::min(right, all[i]);
    ranks.push_back(1 + double(std::ranges::count_if(all, [&](double d) { return d < right; })));
    distances.push_back(right);
    chances.push_back(logChanceOf(all, right));
  }
  return {medianOf(ranks), medianOf(distances), medianOf(chances)};
}

std::vector<FeelWeights> candidates() {
  std::vector<FeelWeights> all;
  for (const double release : {0.7, 1.0, 1.4})
    for (const double slope : {0.0, 0.05, 0.1})
      for (const double level : {0.45, 0.63, 0.9, 1.1})
        for (const double travel : {7, 10, 15, 20})
          for (const double shift : {3, 6, 10}) all.push_back({release, slope, level, travel, shift});
  return all;
}

using Outcomes = std::vector<Outcome>;

Outcomes withWeights(const std::vector<Pair>& pairs, const FeelWeights& weights) {
  Outcomes outcomes;
  for (const Pair& pair : pairs) outcomes.push_back(outcomeOf(pair, weights));
  return outcomes;
}

/// Judges each pair in both directions, with the weights that are best for all other pairs.
std::pair<Outcomes, Outcomes> leavingOneOut(const std::vector<Pair>& there, const std::vector<Pair>& back) {
  std::vector<std::pair<Outcomes, Outcomes>> tried;
  for (const FeelWeights& weights : candidates())
    tried.emplace_back(withWeights(there, weights), withWeights(back, weights));
  std::pair<Outcomes, Outcomes> judged;
  for (std::size_t left = 0; left < there.size(); ++left) {
    const auto worth = [&](const std::pair<Outcomes, Outcomes>& outcomes) {
      double sum = 0;
      for (std::size_t i = 0; i < there.size(); ++i)
        sum += i == left ? 0 : outcomes.first[i].logChance + outcomes.second[i].logChance;
      return sum;
    };
    const auto& best = *std::ranges::max_element(tried, {}, worth);
    judged.first.push_back(best.first[left]);
    judged.second.push_back(best.second[left]);
  }
  return judged;
}

/// Another way to compare: a function of the differences and the direction (1: there, -1: back).
struct Method {
  const char* name;
  std::function<std::vector<FeelDifference>(std::vector<FeelDifference>, double way)> of;
};

/// Difference between the forces of two laboratories on the same switch: median over all other pairs, to
/// half a gf, so that no pair influences its own judgement.
double levelBetween_gf(const std::vector<Pair>& there) {
  std::set<double> halves;
  for (std::size_t left = 0; left < there.size(); ++left) {
    std::vector<double> levels;
    for (std::size_t i = 0; i < there.size(); ++i)
      if (i != left)
        for (const Query& query : there[i].queries)
          for (const std::size_t same : query.same) {
            const auto& byShift = query.to[same];
            levels.push_back(byShift[byShift.size() / 2].level_gf);
          }
    halves.insert(std::round(2 * medianOf(levels)) / 2);
  }
  std::fprintf(stderr, "level between the laboratories, each pair left out:");
  for (const double half : halves) std::fprintf(stderr, " %g", half);
  std::fprintf(stderr, " gf\n");
  return *halves.begin();
}

std::vector<Pair> compared(const std::vector<Pair>& pairs, const Method& method, double way) {
  std::vector<Pair> other = pairs;
  for (Pair& pair : other)
    for (Query& query : pair.queries)
      for (auto& each : query.to) each = method.of(std::move(each), way);
  return other;
}

/// Prints fitted weights, for comparison with those of feel_distance.h.
void sayFitted(const std::vector<Pair>& there, const std::vector<Pair>& back) {
  const std::vector<FeelWeights> every = candidates();
  const auto worth = [&](const FeelWeights& weights) {
    double sum = 0;
    for (const auto* pairs : {&there, &back})
      for (const Outcome& each : withWeights(*pairs, weights)) sum += each.logChance;
    return sum;
  };
  const FeelWeights best = *std::ranges::max_element(every, {}, worth);
  std::fprintf(stderr, "fitted on all: release %g, slope %g mm, level %g, travel %g, shift %g gf/mm\n",
               best.release, best.slope_mm, best.level, best.travel_gf_per_mm, best.shift_gf_per_mm);
}

/// Wilson's 95 % interval of a share.
std::pair<double, double> wilson(double hits, double count) {
  constexpr double z = 1.96;
  const double share = hits / count, middle = share + z * z / (2 * count);
  const double half = z * std::sqrt(share * (1 - share) / count + z * z / (4 * count * count));
  const double scale = 1 + z * z / count;
  return {(middle - half) / scale, (middle + half) / scale};
}

std::string rowOf(const char* name, const Outcomes& outcomes) {
  const auto count = double(outcomes.size());
  const auto upTo = [&](double rank) {
    return double(std::ranges::count_if(outcomes, [&](const Outcome& o) { return o.rank <= rank; }));
  };
  std::vector<double> ranks;
  for (const Outcome& each : outcomes) ranks.push_back(each.rank);
  const auto [low, high] = wilson(upTo(10), count);
  char text[240];
  std::snprintf(text, sizeof text, "| %s | %.0f %% | %.0f %% | **%.0f %%** (%.0f–%.0f) | %g |\n", name,
                100 * upTo(1) / count, 100 * upTo(5) / count, 100 * upTo(10) / count, 100 * low, 100 * high,
                medianOf(ranks));
  return text;
}

bool isOpenSwitch(const LibrarySwitch& each) { return each.source.ends_with(".ods"); }

/// Time of 5,000 comparisons.
double search_ms(const std::vector<LibrarySwitch>& all) {
  constexpr int rounds = 5000;
  const auto begin = std::chrono::steady_clock::now();
  const FeelDistance distance(all.front().shape);
  double sum = 0;
  for (int i = 0; i < rounds; ++i) sum += distance.to(all[static_cast<std::size_t>(i) % all.size()].shape);
  const double ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  return std::isfinite(sum) ? ms : -1;
}

std::string tableOf(const std::vector<LibrarySwitch>& openSwitch, const std::vector<LibrarySwitch>& tidy) {
  const std::vector<Pair> there = pairsOf(openSwitch, tidy), back = pairsOf(tidy, openSwitch);
  const Outcomes shipped = withWeights(there, {});
  std::vector<double> distances;
  for (const Outcome& each : shipped) distances.push_back(each.distance_gf);
  const auto [thereLeft, backLeft] = leavingOneOut(there, back);
  std::ostringstream out;
  out << there.size() << " switches have one name in both; " << openSwitch.size()
      << " records of Open-Switch, " << tidy.size()
      << " of force-curves-tidy. In brackets the 95 % interval.\n\n| asked | first | top 5 | top 10 | median "
         "rank |\n|---|---|---|---|---|\n";
  out << rowOf("Open-Switch's record, weights fitted without the pair", thereLeft);
  out << rowOf("the same with the weights above (fitted on all)", shipped);
  out << rowOf("force-curves-tidy's record, weights fitted without the pair", backLeft);
  Outcomes total = thereLeft;
  total.insert(total.end(), backLeft.begin(), backLeft.end());
  out << rowOf("both ways together, weights fitted without the pair", total);
  const double level_gf = levelBetween_gf(there);
  const std::vector<Method> methods{
      {"contact fixed",
       [](std::vector<FeelDifference> all, double) {
         std::erase_if(all, [](const FeelDifference& each) { return each.shift_mm != 0; });
         return all;
       }},
      {"without slopes",
       [](std::vector<FeelDifference> all, double) {
         for (FeelDifference& each : all) each.slope_gf2_per_mm2 = 0;
         return all;
       }},
      {"press alone",
       [](std::vector<FeelDifference> all, double) {
         for (FeelDifference& each : all) each.release_gf2 = 0;
         return all;
       }},
      {"the laboratories' own level taken off", [level_gf](std::vector<FeelDifference> all, double way) {
         for (FeelDifference& each : all) each.level_gf -= way * level_gf;
         return all;
       }}};
  for (const Method& method : methods) {
    const auto [thereOther, backOther] =
        leavingOneOut(compared(there, method, 1), compared(back, method, -1));
    const std::string name = method.name;  // figures of docs/develop/decisions/0811, beside the page
    std::fputs(rowOf((name + ", Open-Switch's record").c_str(), thereOther).c_str(), stderr);
    std::fputs(rowOf((name + ", force-curves-tidy's record").c_str(), backOther).c_str(), stderr);
  }
  char text[120];
  std::snprintf(text, sizeof text, "\nMedian distance within a pair: %.1f gf, one lab noise.\n",
                medianOf(distances));
  out << text;
  sayFitted(there, back);
  for (std::size_t i = 0; i < there.size(); ++i)
    std::fprintf(stderr, "%5g  %5.1f gf  %s\n", shipped[i].rank, shipped[i].distance_gf,
                 there[i].name.c_str());
  return out.str();
}

int putInto(const std::string& path, const std::string& table) {
  std::ifstream in(path);
  std::string text((std::istreambuf_iterator<char>(in)), {});
  const std::string open = "<!-- library_bench -->\n", close = "<!-- /library_bench -->";
  const std::size_t from = text.find(open), to = text.find(close);
  if (from == std::string::npos || to == std::string::npos) {
    std::fprintf(stderr, "%s: no marks of library_bench. Pass docs/measurements/bench-library.md.\n",
                 path.c_str());
    return 2;
  }
  text.replace(from + open.size(), to - from - open.size(), table);
  std::ofstream(path) << text;
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 && !(argc == 4 && std::string(argv[2]) == "--out")) {
    std::fprintf(stderr, "library_bench DATABASE [--out docs/measurements/bench-library.md]\n");
    return 2;
  }
  const auto store = LibraryStore::openToRead(argv[1]);
  const auto all = store ? store->switches() : Result<std::vector<LibrarySwitch>>(store.failure());
  if (!all) {
    std::fprintf(stderr, "%s\n", all.failure().sentence().c_str());
    return 3;
  }
  std::vector<LibrarySwitch> openSwitch, tidy;
  for (const LibrarySwitch& each : *all) (isOpenSwitch(each) ? openSwitch : tidy).push_back(each);
  const std::string table = tableOf(openSwitch, tidy);
  std::fputs(table.c_str(), stdout);
  std::fprintf(stderr, "5000 distances: %.1f ms\n", search_ms(*all));
  return argc == 4 ? putInto(argv[3], table) : 0;
}
