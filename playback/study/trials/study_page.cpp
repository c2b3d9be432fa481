// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/trials/study_page.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <functional>

#include "model/file/markup.h"
#include "model/version.h"
#include "playback/study/statistics/rank_correlation.h"
#include "playback/study/trials/study_output.h"

namespace detent::playback {

namespace {

constexpr const char* style = R"(
:root { color-scheme: light; }
body { font: 15px/1.5 system-ui, "DejaVu Sans", sans-serif; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; color: #1c2430; background: #fff; }
h1 { font-size: 1.6rem; margin-bottom: .2rem; } h2 { font-size: 1.15rem; margin: 2rem 0 .5rem; }
table { border-collapse: collapse; margin: .5rem 0; } th, td { padding: .25rem .7rem; text-align: right; border-bottom: 1px solid #dde3ea; }
th { font-weight: 600; } td:first-child, th:first-child, .words { text-align: left; }
td.one { background: #d9dde3; } td.more { background: #8b95a3; color: #fff; }
caption { caption-side: bottom; min-width: 26rem; text-align: left; color: #56606e; font-size: .85rem; padding-top: .3rem; }
.band { position: fixed; top: 0; left: 0; right: 0; background: #b3261e; color: #fff; text-align: center; font-weight: 700; padding: .3rem; z-index: 1; }
.banded { padding-top: 2.2rem; } .sheet, .sheet > * > tr > td { display: block; border: 0; padding: 0; margin: 0; text-align: left; }
.notes { border-left: 4px solid #c77700; padding: .2rem 1rem; background: #fff7ea; }
.small { color: #56606e; font-size: .85rem; } svg text { font: 12px system-ui, "DejaVu Sans", sans-serif; fill: #1c2430; }
.blank { color: #56606e; overflow: hidden; } section { break-inside: avoid; } @media print { body { margin: 0; max-width: none; } .banded { padding-top: 0; }
  .sheet { display: table; width: 100%; } .sheet > thead { display: table-header-group; } .sheet > thead > tr > td { height: 2.6rem; } }
)";

__attribute__((format(printf, 1, 2))) std::string formattedHtml(const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  char text[1024];
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return text;
}

std::string htmlCell(const std::string& text) { return "<td>" + text + "</td>"; }
std::string head(const std::string& text) { return "<th>" + text + "</th>"; }

std::string percentText(double share) { return formattedHtml("%.2f %%", 100 * share); }
std::string interval(const Interval& i) { return formattedHtml("%.1f–%.1f %%", 100 * i.low, 100 * i.high); }

std::string row(const std::string& name, const StudyResults& results,
                const std::function<std::string(const GroupResult&)>& text) {
  std::string line = "<tr>" + head(name);
  for (const GroupResult& group : results.groups) line += htmlCell(text(group));
  return line + "</tr>\n";
}

std::string countText(const Count& c) {
  if (c.trials == 0) return "–";
  return formattedHtml("%zu / %zu (%s)", c.errors, c.trials, percentText(rateOf(c)).c_str());
}

std::string table1Html(const StudyResults& results) {
  std::string text = "<section><h2>Table 1. Summary</h2>\n<table><tr><th></th>";
  for (const GroupResult& group : results.groups) text += head(escapedForMarkup(group.condition));
  text += "</tr>\n";
  text +=
      row("Participants", results, [](const GroupResult& g) { return std::to_string(g.participantCount); });
  text += row("Avg. time (SD)", results, [](const GroupResult& g) {
    return g.meanTime_min > 0 ? formattedHtml("%.1f min (%.1f)", g.meanTime_min, g.sdTime_min)
                              : std::string("–");
  });
  text += row("Errors / trials", results, [](const GroupResult& g) { return countText(g.errors); });
  text += row("Wilson 95 %", results, [](const GroupResult& g) { return interval(g.wilson); });
  text +=
      row("Clopper–Pearson 95 %", results, [](const GroupResult& g) { return interval(g.clopperPearson); });
  text += row("Participants resampled (BCa, tails by Student's t) 95 %", results,
              [](const GroupResult& g) { return g.bootstrap ? interval(*g.bootstrap) : std::string("–"); });
  text += row("ABX tests failed / total", results, [](const GroupResult& g) { return countText(g.fails); });
  return text +
         "<caption>Wilson and Clopper–Pearson take trials as independent; those of one person are not, "
         "which resampling participants accounts for.</caption></table></section>\n";
}

const PairResult* pairResult(const GroupResult& group, std::size_t first, std::size_t second) {
  for (const PairResult& pair : group.pairs)
    if (pair.first == first && pair.second == second) return &pair;
  return nullptr;
}

std::string table2Cell(const PairResult* pair) {
  if (pair == nullptr) return "<td></td>";
  const std::size_t fails = pair->failCount.value_or(0);
  const char* shade = fails == 0 ? "" : fails == 1 ? " class=\"one\"" : " class=\"more\"";
  return formattedHtml("<td%s>%zu%s</td>", shade, pair->errors.errors, markOf(*pair));
}

std::string table2Html(const StudyResults& results, const GroupResult& group) {
  const std::size_t n = results.labels.size();
  std::string text =
      "<section><h2>Table 2. Errors by all participants: " + escapedForMarkup(group.condition) +
      "</h2>\n<table><tr><th></th>";
  for (std::size_t i = 0; i + 1 < n; ++i) text += head(escapedForMarkup(results.labels[i]));
  text += "</tr>\n";
  for (std::size_t second = 1; second < n; ++second) {
    text += "<tr>" + head(escapedForMarkup(results.labels[second]));
    for (std::size_t first = 0; first < second; ++first) text += table2Cell(pairResult(group, first, second));
    text += "</tr>\n";
  }
  const bool hasFailCounts = std::any_of(group.pairs.begin(), group.pairs.end(),
                                         [](const PairResult& pair) { return pair.failCount.has_value(); });
  return text +
         (hasFailCounts
              ? "<caption>* light: one participant failed the ABX test of the pair; ** dark: two or "
                "more.</caption>"
              : "<caption>Which pairs' tests were failed is not told.</caption>") +
         "</table></section>\n";
}

constexpr double barsWidth = 430, barHeight = 14, barStep = 24;
constexpr double letterWidth = 7.5, besideBars = 16;  // for the chart's 12 px letters
constexpr std::size_t barLabelBytes = 16;             // most bytes of one of a pair's two labels

/// End of the scale with room for the longest interval: 5, 10, 20, 50 or 100 %.
double scaleEnd(const GroupResult& group) {
  double highest = 0;
  for (const PairResult& pair : group.pairs) highest = std::max(highest, pair.wilson.high);
  for (const double end : {0.05, 0.1, 0.2, 0.5})
    if (highest <= end) return end;
  return 1;
}

std::string bars(const StudyResults& results, const GroupResult& group) {
  const std::vector<std::string> labels = shortened(results.labels, barLabelBytes);
  std::size_t longest = 0;
  for (const PairResult& pair : group.pairs)
    longest = std::max(longest, widthOf(pairName(labels, pair.first, pair.second)));
  const double barsLeft = besideBars + letterWidth * static_cast<double>(longest);
  const double end = scaleEnd(group), perShare = barsWidth / end;
  const double height = barStep * static_cast<double>(group.pairs.size()) + 30;
  std::string text = formattedHtml(
      "<section><h2>Error rate by pair: %s</h2>\n<svg width=\"%.0f\" height=\"%.0f\" role=\"img\">",
      escapedForMarkup(group.condition).c_str(), barsLeft + barsWidth + 60, height);
  for (int tick = 0; tick <= 5; ++tick) {
    const double x = barsLeft + barsWidth * tick / 5;
    text += formattedHtml(
        "<line x1=\"%.1f\" x2=\"%.1f\" y1=\"0\" y2=\"%.1f\" stroke=\"#dde3ea\"/>"
        "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\">%.3g %%</text>\n",
        x, x, height - 22, x, height - 6, 100 * end * tick / 5);
  }
  double y = 4;
  for (const PairResult& pair : group.pairs) {
    const double middle = y + barHeight / 2, rate = rateOf(pair.errors);
    text += formattedHtml("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"end\">", barsLeft - 8, middle + 4) +
            escapedForMarkup(pairName(labels, pair.first, pair.second)) + "<title>" +
            escapedForMarkup(pairName(results.labels, pair.first, pair.second)) + "</title></text>";
    text += formattedHtml("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"#3567a8\"/>",
                          barsLeft, y, rate * perShare, barHeight);
    text += formattedHtml(
        "<line x1=\"%.1f\" x2=\"%.1f\" y1=\"%.1f\" y2=\"%.1f\" stroke=\"#1c2430\" stroke-width=\"1.5\"/>\n",
        barsLeft + pair.wilson.low * perShare, barsLeft + pair.wilson.high * perShare, middle, middle);
    y += barStep;
  }
  return text + "</svg><p class=\"small\">Lines: Wilson 95 %.</p></section>\n";
}

std::string sensitivity(const Sensitivity& s, double value) {
  return formattedHtml("%s%.2f", s.noError ? "≈ " : "", value);
}

std::string pairTable(const StudyResults& results, const GroupResult& group) {
  std::string text =
      "<section><h2>Pairs: " + escapedForMarkup(group.condition) +
      "</h2>\n<table><tr><th>Pair</th><th>Errors</th><th>Wilson 95 %</th><th>Clopper–Pearson</th>"
      "<th>d′ differencing</th><th>d′ independent</th><th>Failed</th></tr>\n";
  for (const PairResult& pair : group.pairs) {
    text += "<tr>" + htmlCell(escapedForMarkup(pairName(results.labels, pair.first, pair.second))) +
            htmlCell(formattedHtml("%zu / %zu", pair.errors.errors, pair.errors.trials)) +
            htmlCell(interval(pair.wilson)) + htmlCell(interval(pair.clopperPearson)) +
            htmlCell(sensitivity(pair.sensitivity, pair.sensitivity.differencing) +
                     formattedHtml(" (%.2f)", pair.sensitivity.low)) +
            htmlCell(sensitivity(pair.sensitivity, pair.sensitivity.independent)) +
            htmlCell(pair.failCount ? std::to_string(*pair.failCount) : "–") + "</tr>\n";
  }
  return text +
         "<caption>d′ of all participants together. Pairs are mixed, so differencing is the model that fits; "
         "in brackets what 97.5 % are above. ≈: no error was made, what half an error "
         "gives.</caption></table></section>\n";
}

std::string participantTable(const StudyResults& results, const GroupResult& group) {
  std::string text = "<section><h2>Participants: " + escapedForMarkup(group.condition) +
                     "</h2>\n<table><tr><th>Participant</th><th>Errors</th><th>Pairs told apart</th>"
                     "<th>… after Holm</th></tr>\n";
  for (std::size_t i = 0; i < group.participants.size(); ++i) {
    std::size_t tests = 0, passed = 0, sure = 0;
    for (const PairResult& pair : group.pairs) {
      for (const AbxTest& test : pair.tests) {
        if (test.participant != group.participants[i]) continue;
        ++tests;
        if (test.discriminates) ++passed;
        if (test.adjusted < 0.05) ++sure;
      }
    }
    text += "<tr>" + htmlCell(escapedForMarkup(group.participants[i])) +
            htmlCell(countText(group.perParticipant[i])) +
            htmlCell(formattedHtml("%zu of %zu", passed, tests)) +
            htmlCell(formattedHtml("%zu of %zu", sure, tests)) + "</tr>\n";
  }
  std::string rule = "No number of errors in so few trials tells skill from guessing.";
  if (results.rule.mostErrors)
    rule = formattedHtml(
        "Told apart: at most %zu error%s in %zu, p = %.4f by guessing. Someone who is right nine times in "
        "ten still fails that rule of ten in 26 %% of runs.",
        *results.rule.mostErrors, *results.rule.mostErrors == 1 ? "" : "s", results.trialsPerTest,
        results.rule.p);
  return text + "<caption>" + rule + "</caption></table></section>\n";
}

std::string confusionHtml(const StudyResults& results, const GroupResult& group) {
  std::string text =
      "<section><h2>Matches: " + escapedForMarkup(group.condition) + "</h2>\n<table><tr><th>X \\ answer</th>";
  for (const std::string& label : results.labels) text += head(escapedForMarkup(label));
  text += "</tr>\n";
  for (std::size_t x = 0; x < group.confusion.size(); ++x) {
    text += "<tr>" + head(escapedForMarkup(results.labels[x]));
    std::size_t all = 0;
    for (const std::size_t c : group.confusion[x]) all += c;
    for (const std::size_t c : group.confusion[x]) {
      const double share = all > 0 ? static_cast<double>(c) / static_cast<double>(all) : 0;
      text += formattedHtml("<td style=\"background: rgba(53,103,168,%.2f)\">%zu</td>", 0.6 * share, c);
    }
    text += "</tr>\n";
  }
  return text + "<caption>Rows: what X was. Columns: what was answered.</caption></table></section>\n";
}

/// Caption of the rank correlation; empty if there are too few pairs for an order.
std::string rankCaption(const std::vector<double>& predicted, const std::vector<double>& found) {
  constexpr std::size_t fewest = 3;
  if (found.size() < fewest) return {};
  return formattedHtml(
      "<caption>Rank correlation (Spearman) of foretold and found: %.2f over %zu pairs (one-sided p = "
      "%.3f, pairs permuted). What is found "
      "scatters by itself: a perfect forecast of the paper's noisy group would reach about "
      "0.74.</caption>",
      spearman(predicted, found), found.size(), spearmanP(predicted, found));
}

std::string foretoldTable(const StudyResults& results, const GroupResult& group,
                          const std::vector<ForetoldPair>& foretold) {
  std::vector<double> found, predicted;
  std::string lines;
  for (const ForetoldPair& pair : foretold) {
    const PairResult* seen = pairResult(group, pair.first, pair.second);
    if (seen == nullptr || pair.mode != group.mode) continue;
    found.push_back(rateOf(seen->errors));
    predicted.push_back(pair.errorRate);
    lines += "<tr>" + htmlCell(escapedForMarkup(pairName(results.labels, pair.first, pair.second))) +
             htmlCell(formattedHtml("%.1f", pair.dPrime)) + "<td class=\"words\">" +
             escapedForMarkup(pair.verdict) + "</td>" +
             htmlCell(formattedHtml("%zu / %zu", seen->errors.errors, seen->errors.trials)) +
             "<td class=\"words\">" + escapedForMarkup(pair.reason) + "</td></tr>\n";
  }
  if (lines.empty()) return {};
  return "<section><h2>Foretold and found: " + escapedForMarkup(group.condition) +
         "</h2>\n<table><tr><th>Pair</th><th>d′ foretold</th><th class=\"words\">Foretold</th>"
         "<th>Errors found</th><th class=\"words\">What differs</th></tr>\n" +
         lines + rankCaption(predicted, found) + "</table></section>\n";
}

std::string comparisons(const StudyResults& results) {
  if (results.comparisons.empty()) return {};
  const auto pairs = pairsOf(results.labels.size());
  std::string text =
      "<section><h2>Conditions against each other</h2>\n<table><tr><th>Conditions</th><th "
      "class=\"words\">Pair</th><th>People</th>"
      "<th>Difference of error rates</th><th>95 %</th><th>p</th><th>p, Holm</th></tr>\n";
  for (const GroupComparison& c : results.comparisons) {
    const std::string pair =
        c.pair ? pairName(results.labels, pairs[*c.pair].first, pairs[*c.pair].second) : "all";
    text += "<tr>" + htmlCell(escapedForMarkup(c.first + " − " + c.second)) + "<td class=\"words\">" +
            escapedForMarkup(pair) + "</td>" +
            htmlCell(formattedHtml("%zu%s", c.participants, c.paired ? ", in both" : "")) +
            htmlCell(formattedHtml("%+.2f %%", 100 * c.difference)) +
            htmlCell(c.interval
                         ? formattedHtml("%+.1f to %+.1f %%", 100 * c.interval->low, 100 * c.interval->high)
                         : std::string("–")) +
            htmlCell(formattedHtml("%.4f", c.p)) + htmlCell(formattedHtml("%.4f", c.adjusted)) + "</tr>\n";
  }
  return text +
         "<caption>Two-sided. People who were in both conditions are their own control: the signs of persons "
         "are flipped, exactly up "
         "to 20 people. Else participants are permuted between the groups. Holm over all conditions, and "
         "over all pairs and "
         "conditions.</caption></table></section>\n";
}

std::string band(const StudyResults& results) {
  if (results.anySimulated) return "SIMULATION — the program answered in place of people";
  if (results.anyRehearsal) return "REHEARSAL — no sound device: nothing was felt";
  return {};
}

std::string notes(const StudyResults& results) {
  if (results.warnings.empty()) return {};
  std::string text = "<section><h2>To be known</h2>\n<ul class=\"notes\">\n";
  for (const std::string& warning : results.warnings) text += "<li>" + escapedForMarkup(warning) + "</li>\n";
  return text + "</ul></section>\n";
}

}  // namespace

std::string pageBeginning(const std::string& title, const std::string& bodyClass) {
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"><title>" +
         escapedForMarkup(title) + "</title><style>" + style + "</style></head>\n<body" +
         (bodyClass.empty() ? "" : " class=\"" + bodyClass + "\"") + ">\n";
}

std::string resultsPage(const StudyResults& results, const std::vector<ForetoldPair>& foretold) {
  const std::string warning = band(results);
  std::string text = pageBeginning(results.study, warning.empty() ? "" : "banded");
  // A table's head is printed on every page, which keeps the place for the warning free.
  if (!warning.empty())
    text += "<div class=\"band\">" + warning +
            "</div>\n<table class=\"sheet\"><thead><tr><td></td></tr></thead><tbody><tr><td>\n";
  text += "<h1>" + escapedForMarkup(results.study) + "</h1>\n<p class=\"small\">" + nameOf(results.kind) +
          ", buttons ";
  for (std::size_t i = 0; i < results.labels.size(); ++i) {
    const std::string& name = results.names[i];
    text += (i > 0 ? ", " : "") + escapedForMarkup(name == results.labels[i] || name.empty()
                                                       ? results.labels[i]
                                                       : results.labels[i] + " (" + name + ")");
  }
  if (!results.feel.empty()) text += "; feel " + results.feel;
  text += ". " + escapedForMarkup(results.source) + " Detent " + version() + "</p>\n";
  text += notes(results);
  if (!results.groups.empty()) text += table1Html(results);
  for (const FigureTable& table : results.tables) text += tableMarkup(table);
  for (const GroupResult& group : results.groups) {
    if (!group.pairs.empty())
      text += table2Html(results, group) + bars(results, group) + pairTable(results, group) +
              foretoldTable(results, group, foretold);
    if (!group.confusion.empty()) text += confusionHtml(results, group);
    if (!group.participants.empty() && !group.pairs.empty()) text += participantTable(results, group);
  }
  text += comparisons(results);
  if (const StudyResults other = otherwise(results); !other.groups.empty() || !other.tables.empty()) {
    text += "<h2>" + otherwiseTitle(results) + "</h2>\n";
    if (!other.groups.empty()) text += table1Html(other);
    for (const FigureTable& table : other.tables) text += tableMarkup(table);
  }
  if (!warning.empty()) text += "</td></tr></tbody></table>\n";
  return text + "</body></html>\n";
}

}  // namespace detent::playback
