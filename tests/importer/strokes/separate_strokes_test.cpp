// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "importer/page/polyline.h"
#include "importer/strokes/stroke_pair.h"

using namespace detent;
using namespace detent::importer;

namespace {

/// 100 px per mm, 200 px per N, origin at (50, 450).
AxesFound axes() {
  AxesFound found;
  found.calibration.value.viewToUnits = {0.01, 0, -0.5, 0, -0.005, 2.25, 0, 0, 1};
  return found;
}

CurveTrace traced(double lift_N, Rgb color = {0, 0, 255}, double to_mm = 4) {
  CurveTrace t;
  t.color = color;
  t.confidence = 1;
  for (double mm = 0; mm <= to_mm; mm += 0.01) {
    const double force = 0.3 + 0.1 * mm + lift_N * std::sin(M_PI * mm / 4);
    t.points_px.push_back({50 + 100 * mm, 450 - 200 * force});
  }
  for (double f = 0; f < 0.5; f += 0.01) {
    const Point last = t.points_px.back();
    t.points_px.push_back({last.x + 0.01, last.y - 2});
  }
  return t;
}

bool rests(const Found<StrokePair>& found, EvidenceCode on) {
  return std::any_of(found.evidence.begin(), found.evidence.end(),
                     [on](const EvidenceItem& evidence) { return evidence.code == on; });
}

Result<Found<StrokePair>> separate(const std::vector<CurveTrace>& traces, bool swap = false) {
  StrokeHints hints;
  hints.swap = swap;
  return separateStrokes(traces, axes(), hints);
}

}  // namespace

TEST_CASE("Hysteresis: the press lies above", "[strokes]") {
  for (bool pressFirst : {true, false}) {
    std::vector<CurveTrace> traces = {traced(0.1, {255, 0, 0}), traced(-0.05, {0, 0, 255})};
    if (!pressFirst) std::swap(traces[0], traces[1]);
    const auto found = separate(traces);
    REQUIRE(found.ok());
    CHECK(found->confidence > 0.9);
    CHECK(found->by == DecidedBy::found);
    CHECK(rests(*found, EvidenceCode::pressAboveRelease));
    const StrokePair& pair = found->value;
    REQUIRE(pair.release.has_value());
    CHECK(pair.press.points[200].force_N == Approx(0.6).epsilon(0.01));
    // In the order travelled: out and back.
    CHECK(pair.press.points.front().displacement_mm < pair.press.points.back().displacement_mm);
    CHECK(pair.release->points.front().displacement_mm > pair.release->points.back().displacement_mm);
    CHECK(pair.press.points.size() == pair.press.points_px.size());
    CHECK(pair.release->points.size() == pair.release->points_px.size());
    // Millimetres, newtons and the bottom-out as drawn.
    CHECK(pair.press.points.front().displacement_mm == Approx(0).margin(1e-9));
    CHECK(pair.press.points.front().force_N == Approx(0.3));
    CHECK(pair.press.points.back().force_N - pair.release->points.back().force_N > 0.5);
  }
}

TEST_CASE("A press alone is doubted where its legend has an entry for the release too", "[strokes]") {
  CurveTrace press = traced(0.1);
  press.label = "press";
  press.labelBox_px = {100, 40, 150, 52};
  AxesFound read = axes();
  const auto confidenceBeside = [&](const std::string& text, const Box& box) {
    read.texts = {{press.label, press.labelBox_px, 1, 0}, {text, box, 1, 0}};
    const auto found = separateStrokes({press}, read);
    REQUIRE(found.ok());
    CHECK_FALSE(found->value.release.has_value());
    CHECK(rests(*found, EvidenceCode::releaseNamedNotSeen) == (found->confidence < 0.5));
    return found->confidence;
  };
  const Box below{100, 60, 160, 72}, beside{260, 41, 330, 53}, elsewhere{400, 300, 460, 312};
  CHECK(confidenceBeside("release", below) < 0.5);
  CHECK(confidenceBeside("release", beside) < 0.5);
  CHECK(confidenceBeside("release", elsewhere) < 0.5);  // a callout's
  // A word of a sentence, a point's name, another switch's release.
  CHECK(confidenceBeside("Release date", elsewhere) > 0.8);
  CHECK(confidenceBeside("reset point", below) > 0.8);
  CHECK(confidenceBeside("Switch B release", below) > 0.8);
  CHECK(confidenceBeside("press force", below) > 0.8);
}

TEST_CASE("A press alone without a name is doubted where the plot names a release", "[strokes]") {
  AxesFound read = axes();
  const auto confidenceBeside = [&](const std::string& text) {
    read.texts = {{text, {400, 300, 460, 312}, 1, 0}};
    const auto found = separateStrokes({traced(0.1)}, read);
    REQUIRE(found.ok());
    return found->confidence;
  };
  CHECK(confidenceBeside("Release") < 0.5);
  CHECK(confidenceBeside("Release stroke") < 0.5);
  CHECK(confidenceBeside("Press stroke Release stroke") < 0.5);  // a legend's row, read as one line
  CHECK(confidenceBeside("Release force") > 0.8);                // of a table of figures
  CHECK(confidenceBeside("Release date") > 0.8);
  CHECK(confidenceBeside("Release point") > 0.8);
  CHECK(confidenceBeside("Press") > 0.8);
}

TEST_CASE("The legend outweighs hysteresis", "[strokes]") {
  std::vector<CurveTrace> traces = {traced(0.004), traced(0, {255, 0, 0})};
  traces[0].label = "Upstroke";
  traces[1].label = "Downstroke (press)";
  const auto found = separate(traces);
  REQUIRE(found.ok());
  CHECK(rests(*found, EvidenceCode::namedByLegend));
  CHECK(found->value.press.points_px[100] == traces[1].points_px[100]);
}

TEST_CASE("What the tracer settled is kept", "[strokes]") {
  std::vector<CurveTrace> traces = {traced(0.01), traced(0)};
  traces[0].stroke = Stroke::release;
  traces[1].stroke = Stroke::press;
  const auto found = separate(traces);
  REQUIRE(found.ok());
  CHECK(found->value.press.points_px[100] == traces[1].points_px[100]);
}

TEST_CASE("Evidence says whether the tracer or a person named the strokes", "[strokes]") {
  struct Row {
    Rgb pressColor;
    EvidenceCode says, saysNot;
  };
  for (const Row& row :
       {Row{{0, 0, 255}, EvidenceCode::distinguishedByPath, EvidenceCode::distinguishedByHand},
        Row{{255, 0, 0}, EvidenceCode::distinguishedByHand, EvidenceCode::distinguishedByPath}}) {
    std::vector<CurveTrace> traces = {traced(0.1, row.pressColor), traced(-0.05)};
    traces[0].stroke = Stroke::press;
    const auto found = separate(traces);
    REQUIRE(found.ok());
    CHECK(rests(*found, row.says));
    CHECK_FALSE(rests(*found, row.saysNot));
  }
}

TEST_CASE("A person may say that a button has no release", "[strokes]") {
  StrokeHints hints;
  hints.noRelease = true;
  struct Row {
    const char* curves;
    std::vector<CurveTrace> traces;
    std::optional<Stroke> given;  // of the first curve
  };
  const std::vector<CurveTrace> twoSwitches{traced(0.1, {255, 0, 0}, 3), traced(-0.05)};
  for (const Row& row :
       {Row{"one", {traced(0.1)}, {}}, Row{"one, named by hand", {traced(0.1)}, Stroke::press},
        Row{"two switches, one named by hand", twoSwitches, Stroke::press},
        Row{"a loop", {traced(0.1), traced(-0.05)}, Stroke::press}}) {
    CAPTURE(row.curves);
    std::vector<CurveTrace> traces = row.traces;
    traces[0].stroke = row.given;
    const auto found = separateStrokes(traces, axes(), hints);
    REQUIRE(found.ok());
    CHECK_FALSE(found->value.release);
    CHECK(found->value.press.points_px == traces[0].points_px);
    CHECK(found->confidence > 0.9);
  }
  const auto unknown = separateStrokes(twoSwitches, axes(), hints);  // which of them is still a question
  CHECK((!unknown.ok() || unknown->confidence < 0.5));
}

TEST_CASE("Exchanged by hand", "[strokes]") {
  const std::vector<CurveTrace> traces = {traced(0.1), traced(-0.05)};
  const auto found = separate(traces, true);
  REQUIRE(found.ok());
  CHECK(found->by == DecidedBy::given);
  CHECK(found->confidence == 1);
  CHECK(found->value.press.points_px[100] == traces[1].points_px[100]);
}

TEST_CASE("Traces drawn backwards come out in the order travelled", "[strokes]") {
  std::vector<CurveTrace> traces = {traced(0.1), traced(-0.05)};
  std::reverse(traces[0].points_px.begin(), traces[0].points_px.end());
  const auto found = separate(traces);
  REQUIRE(found.ok());
  CHECK(found->value.press.points.front().displacement_mm < 0.1);
  CHECK(found->value.press.points[200].force_N > found->value.release->points[300].force_N);
}

TEST_CASE("A release that lies above the press is none", "[strokes]") {
  std::vector<CurveTrace> traces = {traced(0.1), traced(-0.05)};
  for (std::size_t i = 0; i < 100; ++i) traces[1].points_px[i].y -= 60;  // along a callout's box
  CHECK(separate(traces)->confidence < 0.5);
  traces[1].color = {255, 0, 0};  // in colours of their own they may be two switches' as well
  CHECK(separate(traces)->confidence < 0.5);
  traces[0].stroke = Stroke::press, traces[1].stroke = Stroke::release;  // the user names the strokes
  CHECK(separate(traces).ok());
}

TEST_CASE("A release that drops later than the press is another switch's", "[strokes]") {
  const auto dropping = [](double at_mm, double lift_N, Rgb color) {
    CurveTrace t;
    t.color = color;
    t.confidence = 1;
    for (double mm = 0; mm <= 4; mm += 0.01) {
      const double force = 0.3 + lift_N + 0.05 * mm + 0.15 * std::exp(-std::pow((mm - at_mm) / 0.3, 2));
      t.points_px.push_back({50 + 100 * mm, 450 - 200 * force});
    }
    return t;
  };
  const Rgb black{0, 0, 0}, red{255, 0, 0};
  std::vector<CurveTrace> traces = {dropping(1.2, 0.2, black), dropping(1.8, 0, black)};
  traces[0].stroke = Stroke::press, traces[1].stroke = Stroke::release;  // as separated in one colour
  CHECK(separate(traces)->confidence < 0.5);
  CHECK(separate({dropping(1.2, 0.2, black), dropping(1.8, 0, red)})->confidence < 0.5);
  traces[1].color = red;  // the user names the strokes
  CHECK(separate(traces).ok());
}

TEST_CASE("On the level floor of a dome's valley noise does not say where the drop is over", "[strokes]") {
  const auto dome = [](double peak_mm, double peak_N, double floor_mm, double floor_N, double lowest_mm) {
    CurveTrace t;
    t.confidence = 1;
    for (double mm = 0; mm <= 4; mm += 0.01) {
      const double force = mm < peak_mm    ? peak_N * mm / peak_mm
                           : mm < floor_mm ? std::lerp(peak_N, floor_N, (mm - peak_mm) / (floor_mm - peak_mm))
                           : mm < 3.4      ? floor_N - (std::abs(mm - lowest_mm) < 0.02 ? 0.004 : 0)
                                           : std::lerp(floor_N, 2, (mm - 3.4) / 0.6);
      t.points_px.push_back({50 + 100 * mm, 450 - 200 * force});
    }
    return t;
  };
  CurveTrace press = dome(2, 1.8, 2.8, 1, 2.85), release = dome(1.8, 1.2, 2.6, 0.8, 3.3);
  press.color = {255, 0, 0}, release.color = {0, 0, 255};
  const auto found = separate({press, release});
  REQUIRE(found.ok());
  CHECK(found->confidence > 0.9);
}

TEST_CASE(
    "A stroke whose bottom-out lies under the other's is extended up it; one that ends across the other is "
    "not",
    "[strokes]") {
  CurveTrace press = traced(0.1, {255, 0, 0}), release = traced(-0.05, {0, 0, 255});
  for (CurveTrace* stroke : {&press, &release}) stroke->width_px.assign(stroke->points_px.size(), 4);
  const auto whole_N = separate({press, release})->value.release->points.front().force_N;
  const auto cutAt = [&](double highest_N) {
    CurveTrace cut = release;
    while (cut.points_px.back().y < 450 - 200 * highest_N) cut.points_px.pop_back(), cut.width_px.pop_back();
    return cut;
  };
  const auto led = separate({press, cutAt(0.8)});
  REQUIRE(led.ok());
  CHECK(led->value.release->points.front().force_N == Approx(whole_N).margin(0.03));
  CHECK(separate({cutAt(0.8), press})->value.release->points.front().force_N == Approx(whole_N).margin(0.03));
  // Seen beside its press to its end, a release begins there; a press reaches its release's force anyway.
  for (const double beside_px : {1.0, 2.2}) {
    CAPTURE(beside_px);
    CurveTrace seen = cutAt(0.8);
    for (Point& p : seen.points_px) p.x += beside_px;
    const double start_N = separate({press, seen})->value.release->points.front().force_N;
    CHECK(start_N == Approx(beside_px < 2 ? whole_N : 0.8).margin(0.03));
    CurveTrace shortPress = press;
    while (shortPress.points_px.back().y < 450 - 200 * 0.8)
      shortPress.points_px.pop_back(), shortPress.width_px.pop_back();
    for (Point& p : shortPress.points_px) p.x += beside_px;
    const double reached_N = separate({shortPress, release})->value.press.points.back().force_N;
    CHECK(reached_N == Approx(whole_N).margin(0.03));
  }
  CurveTrace across = cutAt(0.69);  // comes to the start of the bottom-out level
  across.points_px.push_back({press.points_px.back().x, across.points_px.back().y});
  across.width_px.push_back(4);
  CHECK(separate({press, across})->value.release->points.front().force_N < whole_N - 0.3);
}

TEST_CASE("Identical curves cannot be distinguished", "[strokes]") {
  const auto found = separate({traced(0.05), traced(0.05, {255, 0, 0})});
  REQUIRE_FALSE(found.ok());
  CHECK(found.failure().code == FailureCode::notCertain);
  CHECK(found.failure().remedies.include(RemedyKind::pickPress));
  CHECK(found.failure().reason == nameOf(DoubtCode::strokesAlike));
  CHECK(english(found.failure().problem).find("#ff0000") != std::string::npos);
}

TEST_CASE("One curve is a press; none is no graph; many need a choice", "[strokes]") {
  const auto one = separate({traced(0.1)});
  REQUIRE(one.ok());
  CHECK_FALSE(one->value.release.has_value());
  CHECK(one->confidence > 0.8);

  CHECK(separate({}).failure().code == FailureCode::noForceGraph);
  CHECK(separate({CurveTrace{}}).failure().code == FailureCode::noForceGraph);

  std::vector<CurveTrace> many = {traced(0.1, {1, 2, 3}), traced(0.05, {255, 0, 0}), traced(0, {0, 255, 0})};
  const auto unclear = separate(many);
  REQUIRE_FALSE(unclear.ok());
  CHECK(unclear.failure().code == FailureCode::notCertain);
  CHECK(english(unclear.failure().problem).find("#010203") != std::string::npos);
  many[0].label = "downstroke";
  many[2].label = "upstroke";
  const auto clear = separate(many);
  REQUIRE(clear.ok());
  CHECK(clear->value.press.points_px[100] == many[0].points_px[100]);
  CHECK(clear->value.release->points_px[clear->value.release->points_px.size() - 101] ==
        many[2].points_px[100]);
}

TEST_CASE("A shorter release and points that are not finite", "[strokes]") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                   infinite = std::numeric_limits<double>::infinity();
  for (const Point bad : {Point{nan, 100}, {100, nan}, {infinite, 100}, {100, -infinite}, {nan, nan}})
    for (const std::size_t at : {std::size_t{0}, std::size_t{7}, std::size_t{200}}) {
      CAPTURE(bad.x, bad.y, at);
      std::vector<CurveTrace> traces = {traced(0.1), traced(-0.05, {255, 0, 0}, 2.5)};
      traces[0].points_px[at] = bad;
      const auto found = separate(traces);
      REQUIRE(found.ok());
      REQUIRE(found->value.release);
      for (const CurvePoint& p : found->value.press.points) CHECK(std::isfinite(p.displacement_mm));
      CHECK(found->value.press.points.size() + 1 == traces[0].points_px.size());
      CHECK(found->value.press.points_px.back() == traces[0].points_px.back());
    }
  std::vector<CurveTrace> traces = {traced(0.1), traced(-0.05, {255, 0, 0})};
  for (Point& p : traces[1].points_px) p.y = nan;
  const auto one = separate(traces);
  REQUIRE(one.ok());
  CHECK_FALSE(one->value.release);
  CHECK(one->confidence > 0.8);
  CHECK(separate({traces[1]}).failure().code == FailureCode::noForceGraph);
}

TEST_CASE("Lines that stand side by side are not the strokes of one switch", "[strokes]") {
  // Two leaders: each one line of its own colour, above and below, but never over the same travel.
  CurveTrace left = traced(0.1, {0, 255, 0}, 1), right = traced(-0.05, {0, 255, 0}, 1);
  for (Point& p : right.points_px) p.x += 90;
  const auto apart = separate({left, right});
  REQUIRE(apart.ok());
  CHECK(apart->confidence < 0.5);
  for (Point& p : right.points_px) p.x -= 90;
  CHECK(separate({left, right})->confidence > 0.9);
}

TEST_CASE("Strokes that end in different places are doubted, unless something says that they belong together",
          "[strokes]") {
  std::vector<CurveTrace> traces = {traced(0.1), traced(-0.05, {255, 0, 0}, 3.4)};
  CHECK(separate(traces)->confidence < 0.5);
  CHECK(separate({traced(0.1), traced(-0.05, {255, 0, 0}, 3.8)})->confidence > 0.9);
  CurveTrace hidden = traced(-0.05, {255, 0, 0});  // the last of its bottom-out lies under the press
  hidden.points_px.resize(hidden.points_px.size() - 25);
  CHECK(separate({traces[0], hidden})->confidence > 0.9);
  if (GENERATE(false, true)) {  // 5 % of the travel less far, and half a bottom-out higher
    traces[1] = traced(-0.05, {255, 0, 0}, 3.8);
    const Point top = traces[1].points_px.back();
    for (int i = 1; i <= 25; ++i) traces[1].points_px.push_back({top.x + 0.01 * i, top.y - 2 * i});
    CHECK(separate(traces)->confidence < 0.5);
  }
  SECTION("the legend") {
    traces[0].label = "Downstroke";
    traces[1].label = "Upstroke";
    CHECK(separate(traces)->confidence > 0.9);
  }
  SECTION("a person") {
    traces[0].stroke = Stroke::press;
    traces[1].stroke = Stroke::release;
    CHECK(separate(traces)->confidence > 0.9);
  }
}

TEST_CASE(
    "A loop that stays open where neither stroke is steep is two curves, unless the legend says otherwise",
    "[strokes]") {
  // To 4 mm without a bottom-out; the release `open_px` of 190 lower at its end.
  const auto flat = [](double open_px, Rgb colour) {
    CurveTrace t;
    for (int i = 0; i <= 400; ++i) t.points_px.push_back({50.0 + i, 250 - 0.475 * i + open_px});
    t.color = colour;
    t.confidence = 1;
    return t;
  };
  const Rgb black{0, 0, 0}, red{255, 0, 0};
  CHECK(separate({flat(0, black), flat(20, red)})->confidence > 0.9);
  std::vector<CurveTrace> open{flat(0, black), flat(50, red)};
  CHECK(separate(open)->confidence < 0.5);
  std::vector<CurveTrace> walled = open;  // along bottom-outs they may be cut at different heights
  for (CurveTrace& each : walled)
    for (int i = 1; i <= 20; ++i)
      each.points_px.push_back({each.points_px.back().x + 0.3, each.points_px.back().y - 5});
  CHECK(separate(walled)->confidence > 0.9);
  open[0].label = "Press", open[1].label = "Release";
  CHECK(separate(open)->confidence > 0.9);
}

TEST_CASE("Two presses of one shape that end apart are two samples, unless something says what they are",
          "[strokes]") {
  // A dome of which the second sample is 17 % weaker; both rise to bottom-outs that end apart.
  const auto dome = [](double scale, double moved_mm, Rgb colour) {
    CurveTrace t;
    for (double mm = 0; mm <= 3.6 + moved_mm; mm += 0.01) {
      const double at_mm = mm - moved_mm;
      const double force = 0.35 * (1 - std::exp(-mm / 0.06)) +
                           0.35 * std::exp(-std::pow((at_mm - 1.6) / 0.4, 2)) +
                           2.3 * std::max(0.0, at_mm - 3.2);
      t.points_px.push_back({50 + 100 * mm, 450 - 200 * scale * force});
    }
    t.color = colour;
    t.confidence = 1;
    return t;
  };
  const Rgb black{0, 0, 0}, red{255, 0, 0};
  const double moved_mm = GENERATE(0.0, -0.1);
  std::vector<CurveTrace> samples{dome(1, 0, black), dome(0.83, moved_mm, red)};
  const auto found = separate(samples);
  if (moved_mm < 0) {  // their bottom-outs cross: no release lies above its press
    REQUIRE_FALSE(found.ok());
    CHECK(found.failure().reason == nameOf(DoubtCode::severalSwitches));
    return;
  }
  CHECK(found->confidence < 0.5);
  samples[0].label = "Press", samples[1].label = "Release";
  CHECK(separate(samples)->confidence > 0.9);
  // A curve that comes back from the press's end is its release, however similar.
  CurveTrace release = dome(0.83, 0, red);
  while (release.points_px.back().x > 50 + 350) release.points_px.pop_back();
  release.points_px.push_back(samples[0].points_px.back());
  samples[0].label.clear();
  CHECK(separate({samples[0], release})->confidence > 0.9);
}

TEST_CASE("Two bottom-outs that end at different heights beside each other are two presses'", "[strokes]") {
  const auto through = [](const Polyline& points, Rgb colour) {
    CurveTrace t;
    t.points_px = densified(points, 1);
    t.color = colour;
    t.confidence = 1;
    return t;
  };
  const CurveTrace press = through({{50, 450}, {60, 300}, {400, 270}, {420, 60}}, {0, 0, 0});
  const double beside_px = GENERATE(0.0, 8.0);
  std::vector<CurveTrace> bothStrokes{
      press, through({{50, 450}, {60, 350}, {404 + beside_px, 320}, {410 + beside_px, 165}}, {255, 0, 0})};
  const auto found = separate(bothStrokes);
  REQUIRE(found.ok());
  CHECK((found->confidence < 0.5) == (beside_px > 0));  // a release cut lower begins on the press
  bothStrokes[0].label = "Press", bothStrokes[1].label = "Release";
  CHECK(separate(bothStrokes)->confidence > 0.9);
}

TEST_CASE("A switch whose colour the legend names twice has two strokes", "[strokes]") {
  std::vector<CurveTrace> traces{traced(0.1, {255, 0, 0}), traced(-0.05, {0, 0, 255})};
  traces[0].label = "Heron", traces[1].label = "Kite";
  StrokeHints hints;
  hints.curve = "Heron";
  CHECK(separateStrokes(traces, axes(), hints).ok());
  traces[0].label += " / Her0n u";
  hints.curve = "1";
  CHECK_FALSE(separateStrokes(traces, axes(), hints).ok());
}

TEST_CASE("A locked key's release covers part of the travel: the legend says that it belongs to the press",
          "[strokes]") {
  std::vector<CurveTrace> traces = {traced(0.1), traced(-0.05, {255, 0, 0})};
  std::erase_if(traces[1].points_px, [](Point p) { return p.x < 50 + 100 * 2.9; });
  CHECK(separate(traces)->confidence < 0.5);
  traces[0].label = "Downstroke";
  traces[1].label = "Upstroke";
  CHECK(separate(traces)->confidence > 0.9);
}

TEST_CASE("A locked key's release comes down to the force at rest: no legend has to say whose it is",
          "[strokes]") {
  // From rest to 4 mm; the release leaves the bottom-out and ends at the travel at which the key locks.
  const auto through = [](std::vector<CurvePoint> drawn, Rgb colour) {
    CurveTrace t;
    for (const CurvePoint& p : drawn)
      t.points_px.push_back({50 + 100 * p.displacement_mm, 450 - 200 * p.force_N});
    t.color = colour;
    t.confidence = 1;
    return t;
  };
  const Rgb black{0, 0, 0}, red{255, 0, 0};
  const CurveTrace press = through({{0, 0}, {0.1, 0.5}, {3.6, 0.8}, {4, 2}}, black);
  const auto confidenceOf = [&](std::vector<CurvePoint> back) {
    const auto found = separate({through(std::move(back), red), press});
    REQUIRE(found.ok());
    CHECK(found->value.press.points_px.front() == press.points_px.front());
    return found->confidence;
  };
  CHECK(confidenceOf({{2.5, 0.05}, {2.6, 0.4}, {3.7, 0.6}, {4, 2}}) > 0.9);
  CHECK(confidenceOf({{2.5, 0.35}, {2.6, 0.4}, {3.7, 0.6}, {4, 2}}) < 0.5);      // ends at half the force
  CHECK(confidenceOf({{2.5, 0.05}, {2.6, 0.4}, {3.7, 0.6}, {3.8, 1.0}}) < 0.5);  // and begins elsewhere
}

TEST_CASE("A curve that ends on another switch's way is hidden by it, one that ends across it is not",
          "[strokes]") {
  const auto named = [](const Polyline& points, Rgb colour, const std::string& name) {
    CurveTrace t;
    t.points_px = densified(points, 1);
    t.color = colour;
    t.confidence = 1;
    t.label = name;
    return t;
  };
  const CurveTrace other = named({{50, 450}, {100, 350}, {400, 320}, {440, 100}}, {255, 0, 0}, "Switch B");
  StrokeHints hints;
  hints.curve = "Switch A";
  const auto chosen = [&](Polyline last) {
    last.insert(last.begin(), {{50, 450}, {100, 380}, {300, 370}});
    return separateStrokes({named(last, {0, 0, 255}, "Switch A"), other}, axes(), hints);
  };
  CHECK(chosen({{330, 327}}).ok());
  CHECK(chosen({{280, 300}}).ok());
  const auto hidden = chosen({{396, 345}, {404, 300}});
  REQUIRE_FALSE(hidden.ok());
  CHECK(hidden.failure().code == FailureCode::notCertain);
}

TEST_CASE("Traces that are hardly believed make no certain strokes", "[strokes]") {
  std::vector<CurveTrace> traces = {traced(0.1, {255, 0, 0}), traced(-0.05)};
  traces[1].confidence = 0.1;
  CHECK(separate(traces)->confidence < 0.5);
  CHECK(separate({traces[1]})->confidence < 0.5);
  traces[1].confidence = 0.5;
  CHECK(separate(traces)->confidence > 0.5);
}
