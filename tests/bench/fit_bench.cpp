// SPDX-License-Identifier: GPL-3.0-or-later
// The fit's whole trade: pieces and error against time, for every setting, as a markdown table.
//
//   detent_fit_bench [--every N]
//
// Inputs: synthetic keys whose truth is a curve of known pieces, and, when the corpus is there
// (DETENT_CORPUS, or beside the checkout), its measured strokes. Both are drawn as a plot of 640 x 440 px and
// traced with the noise of a good trace (0.3 px, shared by neighbours: first-order autoregression, 0.7).
// Distances are score.py's: symmetric mean orthogonal distance over arc length, in percent of the spans of
// the item. Times are processor times of one thread.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "importer/fit/fit_stroke.h"
#include "model/units.h"

namespace {

using namespace detent;
using namespace detent::importer;

constexpr double width_px = 640, height_px = 440, noise_px = 0.3, noiseMemory = 0.7;

using Polyline = std::vector<CurvePoint>;

struct Item {
  std::string name;
  Stroke stroke = Stroke::press;
  Polyline truth;  ///< mm, N, by increasing displacement
  double span_mm = 1, span_N = 1;
  std::vector<CurvePoint> points;
};

double lengthOf(const CurvePoint& a, const CurvePoint& b) {
  return std::hypot(b.displacement_mm - a.displacement_mm, b.force_N - a.force_N);
}

Polyline scaled(const Polyline& line, double perX, double perF) {
  Polyline out;
  for (const CurvePoint& p : line) out.push_back({p.displacement_mm * perX, p.force_N * perF});
  return out;
}

Polyline resampled(const Polyline& line, double step) {
  std::vector<double> arc{0};
  for (std::size_t i = 1; i < line.size(); ++i) arc.push_back(arc.back() + lengthOf(line[i - 1], line[i]));
  const int n = std::max(2, static_cast<int>(std::ceil(arc.back() / step)) + 1);
  Polyline out;
  std::size_t k = 0;
  for (int i = 0; i < n; ++i) {
    const double at = arc.back() * i / (n - 1);
    while (k + 2 < arc.size() && arc[k + 1] < at) ++k;
    const double length = arc[k + 1] - arc[k], t = length > 0 ? (at - arc[k]) / length : 0;
    out.push_back({line[k].displacement_mm + t * (line[k + 1].displacement_mm - line[k].displacement_mm),
                   line[k].force_N + t * (line[k + 1].force_N - line[k].force_N)});
  }
  return out;
}

double meanDistance(const Polyline& from, const Polyline& to) {
  const Polyline samples = resampled(from, 0.002);
  double sum = 0;
  for (const CurvePoint& q : samples) {
    double best = 1e300;
    for (std::size_t i = 1; i < to.size(); ++i) {
      const double ax = to[i - 1].displacement_mm, ay = to[i - 1].force_N;
      const double vx = to[i].displacement_mm - ax, vy = to[i].force_N - ay, square = vx * vx + vy * vy;
      const double t =
          square > 0 ? std::clamp(((q.displacement_mm - ax) * vx + (q.force_N - ay) * vy) / square, 0.0, 1.0)
                     : 0;
      best = std::min(best, std::hypot(q.displacement_mm - ax - t * vx, q.force_N - ay - t * vy));
    }
    sum += best;
  }
  return sum / static_cast<double>(samples.size());
}

Polyline drawn(const StrokeCurve& curve) {
  Polyline line;
  const std::vector<Knot>& knots = curve.knots();
  for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
    const double x0 = knots[k].displacement_mm, h = knots[k + 1].displacement_mm - x0;
    line.push_back({x0, knots[k].force_N});
    for (int i = 1; h > 0 && i < 40; ++i) {
      const double t = i / 40.0, d = knots[k + 1].force_N - knots[k].force_N;
      const double a = knots[k].slopeAfter_N_per_mm * h, b = knots[k + 1].slopeBefore_N_per_mm * h;
      line.push_back(
          {x0 + h * t, knots[k].force_N + t * (a + t * ((3 * d - 2 * a - b) + t * (a + b - 2 * d)))});
    }
  }
  line.push_back({knots.back().displacement_mm, knots.back().force_N});
  return line;
}

/// A pixel-like trace of a polyline: a point per pixel, noise across the line shared by neighbours.
std::vector<CurvePoint> traced(const Item& item, unsigned seed) {
  const double perX = width_px / item.span_mm, perF = height_px / item.span_N;
  const Polyline pixels = resampled(scaled(item.truth, perX, perF), 1);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, 1);
  std::vector<CurvePoint> points;
  double offset = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    offset = noiseMemory * offset + std::sqrt(1 - noiseMemory * noiseMemory) * noise_px * normal(random);
    const CurvePoint &a = pixels[i > 2 ? i - 3 : 0], &b = pixels[std::min(i + 3, pixels.size() - 1)];
    const double dx = b.displacement_mm - a.displacement_mm, dy = b.force_N - a.force_N;
    const double length = std::max(std::hypot(dx, dy), 1e-9);
    points.push_back({(pixels[i].displacement_mm - offset * dy / length) / perX,
                      (pixels[i].force_N + offset * dx / length) / perF});
  }
  return points;
}

void addItem(std::vector<Item>& items, Item item) {
  item.points = traced(item, static_cast<unsigned>(items.size()) + 1);
  items.push_back(std::move(item));
}

/// Keys of two to nine pieces: linear, tactile, clicky with corners, two levels, with and without
/// bottom-outs.
std::vector<Item> syntheticItems() {
  std::vector<Item> items;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 24; ++i) {
    std::vector<Knot> knots{{0, 0, 4, 4}, {0.05, 0.2 + 0.2 * unit(random), 0.15, 0.15}};
    double x = 0.05, force = knots.back().force_N;
    for (int bump = 0; bump < i % 4; ++bump) {
      const double peak = force + 0.1 + 0.25 * unit(random), valley = peak - 0.05 - 0.2 * unit(random);
      const bool corner = i % 8 >= 4;
      x += 0.5 + 0.4 * unit(random);
      knots.push_back({x, peak, corner ? 0.3 : 0.0, corner ? -0.6 : 0.0});
      x += 0.2 + 0.3 * unit(random);
      knots.push_back({x, valley, 0, 0});
      force = valley;
    }
    knots.push_back({3.8, force + 0.2, 0.12, 0.12});
    if (i % 2 == 0) knots.push_back({3.8 + 0.02 * unit(random), 1.2, 40, 40});
    const auto curve = StrokeCurve::fromKnots(knots);
    if (!curve) continue;
    Item item{"synthetic " + std::to_string(i), Stroke::press, drawn(*curve), 1, 1, {}};
    const auto [least, most] = curve->forceRange_N();
    item.span_mm = curve->travel_mm();
    item.span_N = most - least;
    addItem(items, std::move(item));
  }
  return items;
}

std::filesystem::path corpus() {
  if (const char* given = std::getenv("DETENT_CORPUS")) return given;
  return std::filesystem::path(DETENT_SOURCE_DIR) / ".." / "shared" / "corpus";
}

/// Strokes of one folder of the corpus; items with several curves are left out.
std::vector<Item> corpusItems(const std::filesystem::path& folder, int every) {
  std::vector<std::filesystem::path> files;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none))
    if (std::filesystem::exists(entry.path() / "truth.csv")) files.push_back(entry.path() / "truth.csv");
  std::sort(files.begin(), files.end());
  std::vector<Item> items;
  for (std::size_t f = 0; f < files.size(); f += static_cast<std::size_t>(every)) {
    std::ifstream in(files[f]);
    std::string line;
    std::getline(in, line);
    if (line.find("curve") != std::string::npos) continue;
    std::map<std::string, Polyline> strokes;
    while (std::getline(in, line)) {
      std::stringstream row(line);
      std::string stroke, x, force;
      std::getline(row, stroke, ',');
      std::getline(row, x, ',');
      std::getline(row, force, ',');
      strokes[stroke].push_back({std::strtod(x.c_str(), nullptr),
                                 std::strtod(force.c_str(), nullptr) * newtonsPer(ForceUnit::gramForce)});
    }
    CurvePoint least{1e300, 1e300}, most{-1e300, -1e300};
    for (const auto& [name, points] : strokes)
      for (const CurvePoint& p : points) {
        least = {std::min(least.displacement_mm, p.displacement_mm), std::min(least.force_N, p.force_N)};
        most = {std::max(most.displacement_mm, p.displacement_mm), std::max(most.force_N, p.force_N)};
      }
    for (auto& [name, points] : strokes) {
      if (points.size() < 5) continue;
      Item item{files[f].parent_path().filename().string(),
                name == "press" ? Stroke::press : Stroke::release,
                std::move(points),
                most.displacement_mm - least.displacement_mm,
                most.force_N - least.force_N,
                {}};
      if (item.stroke == Stroke::release) std::reverse(item.truth.begin(), item.truth.end());
      addItem(items, std::move(item));
    }
  }
  return items;
}

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1))];
}

void benchSetting(const std::string& name, const std::vector<Item>& items, FitOptions options) {
  std::vector<double> distances, pieces, milliseconds;
  int failed = 0;
  for (const Item& item : items) {
    options.noise = {noise_px * item.span_mm / width_px, noise_px * item.span_N / height_px};
    const std::clock_t begin = std::clock();
    const auto fitted = fitStroke(item.points, item.stroke, options);
    milliseconds.push_back(1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    if (!fitted) {
      ++failed;
      continue;
    }
    const Polyline fit = scaled(drawn(fitted->curve), 1 / item.span_mm, 1 / item.span_N);
    const Polyline truth = scaled(item.truth, 1 / item.span_mm, 1 / item.span_N);
    distances.push_back(50 * (meanDistance(truth, fit) + meanDistance(fit, truth)));
    pieces.push_back(fitted->summary.pieces);
  }
  std::printf("| %s | %.0f / %.0f | %.3f / %.3f / %.3f | %.1f / %.1f | %d |\n", name.c_str(),
              quantile(pieces, 0.5), quantile(pieces, 0.9), quantile(distances, 0.5),
              quantile(distances, 0.9), quantile(distances, 1), quantile(milliseconds, 0.5),
              quantile(milliseconds, 0.9), failed);
  std::fflush(stdout);
}

void benchItems(const char* title, const std::vector<Item>& items) {
  if (items.empty()) {
    std::printf("SKIPPED %s: not found\n\n", title);
    return;
  }
  std::printf("### %s: %zu strokes\n\n", title, items.size());
  std::printf(
      "| setting | pieces, median / 90 %% | distance in %% of span, median / 90 %% / worst | ms per stroke, "
      "median / 90 %% "
      "| failed |\n|---|---|---|---|---|\n");
  const std::pair<const char*, FitEffort> efforts[] = {
      {"draft", FitEffort::draft}, {"standard", FitEffort::standard}, {"precise", FitEffort::precise}};
  for (const auto& [name, effort] : efforts) benchSetting(name, items, fitOptionsFor(effort, {1, 1}));
  for (const double share : {6e-3, 3e-3, 1.5e-3, 7e-4, 3e-4}) {
    FitOptions options = fitOptionsFor(FitEffort::standard, {1, 1});
    options.resolutionOfSpan = share;
    char name[60];
    std::snprintf(name, sizeof name, "standard, resolution %.2f %%", 100 * share);
    benchSetting(name, items, options);
  }
  for (const int rounds : {0, 1, 4}) {
    FitOptions options = fitOptionsFor(FitEffort::standard, {1, 1});
    options.evidenceRounds = rounds;
    benchSetting("standard, evidence rounds " + std::to_string(rounds), items, options);
  }
  for (const int pieces : {2, 4, 8, 16, 32}) {
    FitOptions options = fitOptionsFor(FitEffort::standard, {1, 1});
    options.criterion = PieceCriterion::fixed;
    options.pieces = pieces;
    benchSetting("fixed, " + std::to_string(pieces) + " pieces", items, options);
  }
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  int every = 1;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--every") == 0 && i + 1 < argc) {
      every = std::max(1, std::atoi(argv[++i]));
    } else {
      std::printf(
          "detent_fit_bench [--every N]: pieces and error against time of the fit's settings, as markdown "
          "tables.\n"
          "  --every N   take every Nth item of the corpus only\n");
      return std::strcmp(argv[i], "--help") == 0 ? 0 : 2;
    }
  }
  benchItems("Synthetic keys", syntheticItems());
  benchItems("Measured switches (real)", corpusItems(corpus() / "real", every));
  benchItems("Vendors' graphs (datasheets/ref)", corpusItems(corpus() / "datasheets" / "ref", every));
  return 0;
}
