// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/library/report_page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <set>
#include <string_view>

#include "model/file/markup.h"
#include "model/file/svg_plot.h"
#include "model/units.h"
#include "model/version.h"

namespace detent::importer {
namespace {

const double gf = newtonsPer(ForceUnit::gramForce);

template <class... Values>
std::string format(const char* pattern, Values... values) {
  std::array<char, 256> text{};
  std::snprintf(text.data(), text.size(), pattern, values...);
  return text.data();
}

const char* const style =
    "body{font:15px/1.45 system-ui,sans-serif;max-width:68rem;margin:2rem auto;padding:0 1rem;color:#1b1b1b}"
    "h1{font-size:1.5rem}h2{font-size:1.15rem;margin-top:2rem}table{border-collapse:collapse;width:100%}"
    "th,td{padding:.3rem .6rem;border-bottom:1px solid #ddd;text-align:right;vertical-align:top}"
    "th:first-child,td:first-child{text-align:left}td.words,th.words{text-align:left;font-size:.85rem}"
    ".wide{overflow-x:auto}"
    ".plots{display:grid;grid-template-columns:repeat(auto-fill,minmax(20rem,1fr));gap:1rem}"
    "figure{margin:0}figcaption{font-size:.85rem}svg{width:100%;height:auto}svg text{font:11px "
    "system-ui,sans-serif;fill:#555}"
    ".own{stroke:#1b1b1b}.other{stroke:#c2410c}path{fill:none;stroke-width:1.6}.up{stroke-dasharray:4 3}"
    ".grid{stroke:#e4e4e4;stroke-width:1}"
    "@media print{body{margin:0;max-width:none}figure{break-inside:avoid}}";

/// Axes of a plot, the same for all plots of a page, so that they can be compared.
struct Axes {
  static constexpr double width_px = 340, height_px = 220, left_px = 34, right_px = 8, top_px = 8,
                          bottom_px = 30;
  double most_mm = 1, most_gf = 1;

  double x(double mm) const { return left_px + (width_px - left_px - right_px) * mm / most_mm; }
  double y(double force_gf) const {
    return height_px - bottom_px -
           (height_px - top_px - bottom_px) * std::clamp(force_gf / most_gf, -0.1, 1.0);
  }
};

Axes axesOf(const LibrarySwitch& like, const std::vector<FoundSwitch>& found) {
  Axes axes{like.shape.travel_mm, 1};
  const auto take = [&](const FeltShape& shape) {
    axes.most_mm = std::max(axes.most_mm, shape.travel_mm);
    for (const float force_N : shape.press_N) axes.most_gf = std::max(axes.most_gf, force_N / gf);
  };
  take(like.shape);
  for (const FoundSwitch& each : found) take(each.entry.shape);
  axes.most_gf *= 1.05;
  return axes;
}

std::string pathOf(const Axes& axes, const std::vector<float>& forces_N, double travel_mm, const char* kind) {
  if (forces_N.empty()) return {};
  std::string text = "<path class=\"" + std::string(kind) + "\" d=\"M";
  for (std::size_t i = 0; i < forces_N.size(); i += 3)
    text += format("%.1f %.1f ", axes.x(travel_mm * double(i) / double(forces_N.size() - 1)),
                   axes.y(double{forces_N[i]} / gf));
  return text + "\"/>";
}

std::string curvesOf(const Axes& axes, const FeltShape& shape, const std::string& kind) {
  return pathOf(axes, shape.press_N, shape.travel_mm, kind.c_str()) +
         pathOf(axes, shape.release_N, shape.travel_mm, (kind + " up").c_str());
}

std::string gridOf(const Axes& axes) {
  std::string text;
  const Ticks travel_mm = niceTicks(0, axes.most_mm, 4), force_gf = niceTicks(0, axes.most_gf, 4);
  for (int i = 0; i < travel_mm.count && travel_mm.at(i) <= axes.most_mm; ++i) {
    const double x = axes.x(travel_mm.at(i));
    text += format("<line class=\"grid\" x1=\"%.1f\" x2=\"%.1f\" y1=\"%.1f\" y2=\"%.1f\"/>", x, x,
                   Axes::top_px, Axes::height_px - Axes::bottom_px);
    text += format("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\">%g</text>", x,
                   Axes::height_px - Axes::bottom_px + 13, travel_mm.at(i));
  }
  for (int i = 0; i < force_gf.count && force_gf.at(i) <= axes.most_gf; ++i) {
    const double y = axes.y(force_gf.at(i));
    text += format("<line class=\"grid\" x1=\"%.1f\" x2=\"%.1f\" y1=\"%.1f\" y2=\"%.1f\"/>", Axes::left_px,
                   Axes::width_px - Axes::right_px, y, y);
    text += format("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"end\">%g</text>", Axes::left_px - 5, y + 4,
                   force_gf.at(i));
  }
  return text + format("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"end\">mm from contact; gf</text>",
                       Axes::width_px - Axes::right_px, Axes::height_px - 4);
}

std::string plotOf(const Axes& axes, const std::string& curves, const std::string& caption) {
  return "<figure><svg viewBox=\"0 0 340 220\" role=\"img\">" + gridOf(axes) + curves + "</svg><figcaption>" +
         caption + "</figcaption></figure>\n";
}

std::string switchTitle(const LibrarySwitch& entry) {
  return escapedForMarkup(entry.name + (entry.unit.empty() ? "" : ", unit " + entry.unit) +
                          (entry.run.empty() ? "" : ", run " + entry.run));
}

struct Column {
  KeyFigure figure;
  const char* heading;
  double unit;
  const char* pattern;
};

const std::array<Column, 7>& columns() {
  using enum KeyFigure;
  static const std::array<Column, 7> all{{{peakForce, "peak, gf", gf, "%.1f"},
                                          {peakTravel, "at, mm", 1, "%.2f"},
                                          {drop, "drop, gf", gf, "%.1f"},
                                          {operatingForce, "operating, gf", gf, "%.1f"},
                                          {bottomOutForce, "bottom-out, gf", gf, "%.1f"},
                                          {totalTravel, "travel, mm", 1, "%.2f"},
                                          {pressWork, "work, mJ", 1, "%.2f"}}};
  return all;
}

/// " ± 0.2"; empty if the error is smaller than the last digit shown.
std::string errorOf(double error, const Column& column) {
  const std::string shown = format(column.pattern, error / column.unit);
  return shown.find_first_of("123456789") == std::string::npos ? "" : " ± " + shown;
}

/// "54.1 ± 0.2", with the scatter between units below it.
std::string figureOf(const LibrarySwitch& entry, const SwitchSpread& spread, const Column& column) {
  const auto& value = entry.figures[column.figure];
  if (!value) return "–";
  std::string text = format(column.pattern, *value / column.unit);
  if (const auto& sigma = entry.sigmas[column.figure])
    text += "<small>" + errorOf(*sigma, column) + "</small>";
  if (const auto& sd = spread.sd[column.figure]; sd && !errorOf(*sd, column).empty())
    text +=
        "<br><small>" + std::string(spread.units > 1 ? "units" : "runs") + errorOf(*sd, column) + "</small>";
  return text;
}

std::string ratingsOf(const std::vector<Rating>& ratings) {
  std::string text;
  for (const Rating& each : ratings)
    text += "<br><small>rated by " + escapedForMarkup(ratingWords(each)) + "; " +
            escapedForMarkup(each.licence) + "</small>";
  return text;
}

std::string rowOf(const LibrarySwitch& entry, const SwitchSpread& spread, const std::string& distance,
                  const std::vector<Rating>& ratings) {
  std::string row = "<tr><td>" + switchTitle(entry) + "</td><td>" + distance + "</td>";
  for (const Column& column : columns()) row += "<td>" + figureOf(entry, spread, column) + "</td>";
  return row + "<td class=\"words\">" +
         escapedForMarkup(entry.credit.empty() ? "credit unknown" : entry.credit) + "; " +
         escapedForMarkup(entry.licence) + "; " +
         escapedForMarkup(std::filesystem::path(entry.source).filename().string()) +
         (entry.scaleDoubtful ? "; its forces may lie well off other laboratories'" : "") +
         ratingsOf(ratings) + "</td></tr>\n";
}

std::string tableOf(const LibrarySwitch& like, const std::vector<FoundSwitch>& found) {
  std::string text = "<div class=\"wide\"><table><thead><tr><th>switch</th><th>distance</th>";
  for (const Column& column : columns()) text += "<th>" + std::string(column.heading) + "</th>";
  text +=
      "<th class=\"words\">credit; licence; file</th></tr></thead><tbody>\n" + rowOf(like, {}, "asked", {});
  for (const FoundSwitch& each : found)
    text += rowOf(each.entry, each.spread, format("%.2f", each.distance_labNoise.value_or(0)), each.ratings);
  return text + "</tbody></table></div>\n";
}

/// Authors of the measurements on the page, each with the licences of their data.
std::string creditsOf(const LibrarySwitch& like, const std::vector<FoundSwitch>& found) {
  std::map<std::string, std::set<std::string>> licences;
  const auto take = [&](const LibrarySwitch& each) {
    licences[each.credit.empty() ? "credit unknown" : each.credit].insert(each.licence);
  };
  take(like);
  for (const FoundSwitch& each : found) take(each.entry);
  std::string text = "<ul>";
  for (const auto& [credit, all] : licences) {
    text += "<li>" + escapedForMarkup(credit) + ": ";
    for (const std::string& licence : all)
      text += (licence == *all.begin() ? "" : ", ") + escapedForMarkup(licence);
    text += "</li>";
  }
  return text + "</ul>\n";
}

}  // namespace

std::string reportPage(const LibrarySwitch& like, const std::vector<FoundSwitch>& found,
                       std::size_t fitting) {
  const std::string name = switchTitle(like);
  const Axes axes = axesOf(like, found);
  const auto alike = std::ranges::count_if(
      found, [](const FoundSwitch& each) { return each.distance_labNoise.value_or(1) < 1; });
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width\"><title>Feels like " +
      name + "</title><style>" + style + "</style></head><body>\n<h1>What feels like " + name + "</h1>\n<p>";
  page += format(
      "The %zu nearest of %zu. Distances are in units of what two laboratories differ by on one switch (%g "
      "gf). ",
      found.size(), fitting, labNoise_gf);
  page +=
      alike == 0
          ? std::string("None is below 1, where nobody could say that they differ.")
          : format(
                "Of the %zu below 1 nobody can say that they differ, so read them as a group and not as a "
                "ranking.",
                static_cast<std::size_t>(alike));
  page +=
      " Behind ± stands a standard error, where it reaches the last place shown: of the meter's noise and "
      "steps, not of "
      "its calibration. Curves begin "
      "at first contact; the release is dashed. No figure here says how good a switch "
      "is.</p>\n";
  page += tableOf(like, found) + "<h2>Curves</h2><p>Black: " + name + ".</p><div class=\"plots\">\n";
  for (const FoundSwitch& each : found)
    page += plotOf(axes, curvesOf(axes, each.entry.shape, "other") + curvesOf(axes, like.shape, "own"),
                   switchTitle(each.entry) + format(", %.2f", each.distance_labNoise.value_or(0)));
  page += "</div>\n<h2>Credits and licences</h2>\n" + creditsOf(like, found);
  page +=
      "<p>Where none is stated, ask before you pass the measurements on. What is compared: "
      "docs/guide/library.md "
      "of Detent " +
      escapedForMarkup(version()) + ".</p>\n</body></html>\n";
  return page;
}

}  // namespace detent::importer
