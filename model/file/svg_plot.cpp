// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/file/svg_plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>

#include "model/check.h"
#include "model/file/markup.h"
#include "model/metrics.h"
#include "model/sampling.h"

namespace detent {
namespace {

constexpr double marginLeft_px = 74, marginRight_px = 24, marginTop_px = 44, marginBottom_px = 60;
constexpr double fontSize_px = 12;
constexpr double glyphWidth_px = 6.6;  // of a sans-serif digit at fontSize_px, generous
constexpr const char* pressColour = "#0072b2";
constexpr const char* releaseColour = "#c46f00";

std::string fixed(double value, int decimals) {
  char buffer[400];
  std::snprintf(buffer, sizeof buffer, "%.*f", decimals, value);
  std::string text = buffer;
  // "-0.0" is 0.
  if (text.front() == '-' && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

std::string px(double value) { return fixed(value, 2); }

struct Spot {
  double x, y;
};

struct Box {
  double x0, y0, x1, y1;
  bool overlaps(const Box& o) const { return x0 < o.x1 && o.x0 < x1 && y0 < o.y1 && o.y0 < y1; }
  bool contains(const Spot& p) const { return p.x > x0 && p.x < x1 && p.y > y0 && p.y < y1; }
};

// One state's plot: the map from mm and N to pixels and what is drawn with it.
class Plot {
 public:
  Plot(const ButtonState& state, const SvgPlotStyle& style, std::string title, double top_px)
      : state_(state), style_(style), title_(std::move(title)), metrics_(metricsOf(state)) {
    frame_ = {marginLeft_px, top_px + marginTop_px, style.width_px - marginRight_px,
              top_px + style.height_px - marginBottom_px};
    chooseTicks();
  }

  std::string svg() {
    std::string out = "<g>\n";
    drawGrid(out);
    drawTitles(out);
    drawCurves(out);
    drawLegend(out);
    if (style_.callouts) drawCallouts(out);
    out += "<rect x=\"" + px(frame_.x0) + "\" y=\"" + px(frame_.y0) + "\" width=\"" +
           px(frame_.x1 - frame_.x0) + "\" height=\"" + px(frame_.y1 - frame_.y0) +
           "\" fill=\"none\" stroke=\"#222\" stroke-width=\"1.4\"/>\n";
    return out + "</g>\n";
  }

  PlotFrame frame() const { return {frame_.x0, frame_.y0, frame_.x1, frame_.y1, xTicks_, yTicks_}; }

 private:
  void chooseTicks() {
    const ForceGraph& graph = state_.graph;
    auto [low, high] = graph.press().forceRange_N();
    double left = graph.press().start_mm(), right = graph.press().end_mm();
    if (const auto& release = graph.release()) {
      const auto [releaseLow, releaseHigh] = release->forceRange_N();
      low = std::min(low, releaseLow);
      high = std::max(high, releaseHigh);
      left = std::min(left, release->start_mm());
      right = std::max(right, release->end_mm());
    }
    const double perUnit_mm = millimetresPer(style_.lengthUnit), perUnit_N = newtonsPer(style_.forceUnit);
    xTicks_ = niceTicks(std::min(left, 0.0) / perUnit_mm, right / perUnit_mm, 8);
    yTicks_ = niceTicks(std::min(low, 0.0) / perUnit_N, std::max(high, 0.0) / perUnit_N, 7);
  }

  Spot spot(double displacement_mm, double force_N) const {
    const PlotFrame map = frame();
    return {map.xPx(displacement_mm / millimetresPer(style_.lengthUnit)),
            map.yPx(force_N / newtonsPer(style_.forceUnit))};
  }

  static void line(std::string& out, Spot a, Spot b, const char* style) {
    out += "<line x1=\"" + px(a.x) + "\" y1=\"" + px(a.y) + "\" x2=\"" + px(b.x) + "\" y2=\"" + px(b.y) +
           "\" " + style + "/>\n";
  }
  static void text(std::string& out, Spot at, const char* anchor, const std::string& what,
                   const std::string& more = "") {
    out += "<text x=\"" + px(at.x) + "\" y=\"" + px(at.y) + "\" text-anchor=\"" + anchor + "\"" + more + ">" +
           escapedForMarkup(what) + "</text>\n";
  }

  void drawGrid(std::string& out) const {
    const char* grid = "stroke=\"#c9c9c9\" stroke-width=\"0.8\"";
    const char* tick = "stroke=\"#222\" stroke-width=\"1.2\"";
    for (int i = 0; i < xTicks_.count; ++i) {
      const double x = frame_.x0 + (frame_.x1 - frame_.x0) * i / (xTicks_.count - 1);
      line(out, {x, frame_.y0}, {x, frame_.y1}, grid);
      line(out, {x, frame_.y1}, {x, frame_.y1 + 5}, tick);
      text(out, {x, frame_.y1 + 19}, "middle", label(xTicks_, i));
    }
    for (int i = 0; i < yTicks_.count; ++i) {
      const double y = frame_.y1 - (frame_.y1 - frame_.y0) * i / (yTicks_.count - 1);
      line(out, {frame_.x0, y}, {frame_.x1, y}, grid);
      line(out, {frame_.x0 - 5, y}, {frame_.x0, y}, tick);
      text(out, {frame_.x0 - 9, y + 4}, "end", label(yTicks_, i));
    }
  }

  static std::string label(const Ticks& ticks, int i) {
    if (ticks.decimals <= 6 && std::abs(ticks.last()) < 1e7) return fixed(ticks.at(i), ticks.decimals);
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.4g", ticks.at(i));
    return buffer;
  }

  void drawTitles(std::string& out) const {
    const double middleX = 0.5 * (frame_.x0 + frame_.x1), middleY = 0.5 * (frame_.y0 + frame_.y1);
    const std::string xTitle = "Displacement (" + std::string(symbolOf(style_.lengthUnit)) + ")";
    const std::string yTitle = "Force (" + std::string(symbolOf(style_.forceUnit)) + ")";
    text(out, {middleX, frame_.y1 + 44}, "middle", xTitle);
    const double x = 20;
    text(out, {x, middleY}, "middle", yTitle, " transform=\"rotate(-90 " + px(x) + " " + px(middleY) + ")\"");
    if (!title_.empty())
      text(out, {middleX, frame_.y0 - 22}, "middle", title_, " font-size=\"15\" font-weight=\"bold\"");
  }

  // Hermite pieces as Béziers; walls as lines.
  std::string pathOf(const StrokeCurve& curve) const {
    const std::vector<Knot>& knots = curve.knots();
    const Spot start = spot(knots[0].displacement_mm, knots[0].force_N);
    std::string d("M");
    d += px(start.x) + " " + px(start.y);
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
      const Knot &a = knots[i], &b = knots[i + 1];
      const Spot end = spot(b.displacement_mm, b.force_N);
      const double third = (b.displacement_mm - a.displacement_mm) / 3;
      if (third == 0) {
        d += " L" + px(end.x) + " " + px(end.y);
        continue;
      }
      const Spot c1 = spot(a.displacement_mm + third, a.force_N + a.slopeAfter_N_per_mm * third);
      const Spot c2 = spot(b.displacement_mm - third, b.force_N - b.slopeBefore_N_per_mm * third);
      d += " C" + px(c1.x) + " " + px(c1.y) + " " + px(c2.x) + " " + px(c2.y) + " " + px(end.x) + " " +
           px(end.y);
    }
    return d;
  }

  void drawCurves(std::string& out) {
    const ForceGraph& graph = state_.graph;
    out += "<path class=\"press\" d=\"" + pathOf(graph.press()) + "\" fill=\"none\" stroke=\"" + pressColour +
           "\" stroke-width=\"2\" stroke-linejoin=\"round\"/>\n";
    remember(travelledSamples(graph, Stroke::press));
    if (!graph.release()) return;
    out += "<path class=\"release\" d=\"" + pathOf(*graph.release()) + "\" fill=\"none\" stroke=\"" +
           releaseColour + "\" stroke-width=\"2\" stroke-linejoin=\"round\" stroke-dasharray=\"7 4\"/>\n";
    remember(travelledSamples(graph, Stroke::release));
  }

  // Places texts should keep off.
  void remember(const std::vector<CurvePoint>& points) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const Spot a = spot(points[i].displacement_mm, points[i].force_N);
      const Spot b = spot(points[i + 1].displacement_mm, points[i + 1].force_N);
      const int parts = static_cast<int>(std::clamp(std::hypot(b.x - a.x, b.y - a.y) / 4, 1.0, 500.0));
      for (int k = 0; k <= parts; ++k)
        ink_.push_back({a.x + (b.x - a.x) * k / parts, a.y + (b.y - a.y) * k / parts});
    }
  }

  void drawLegend(std::string& out) {
    const double y = frame_.y0 - 8;
    double x = frame_.x0 + 4;
    const auto entry = [&](const char* name, const char* colour, const char* dash) {
      out += "<line x1=\"" + px(x) + "\" y1=\"" + px(y - 4) + "\" x2=\"" + px(x + 28) + "\" y2=\"" +
             px(y - 4) + "\" stroke=\"" + colour + "\" stroke-width=\"2\"" + dash + "/>\n";
      text(out, {x + 34, y}, "start", name);
      x += 34 + glyphWidth_px * 8 + 18;
    };
    entry("Press", pressColour, "");
    if (state_.graph.release()) entry("Release", releaseColour, " stroke-dasharray=\"7 4\"");
  }

  std::string valueText(CurvePoint p) const {
    char buffer[120];
    std::snprintf(buffer, sizeof buffer, "%.3g %s at %.3g %s", p.force_N / newtonsPer(style_.forceUnit),
                  std::string(symbolOf(style_.forceUnit)).c_str(),
                  p.displacement_mm / millimetresPer(style_.lengthUnit),
                  std::string(symbolOf(style_.lengthUnit)).c_str());
    return buffer;
  }

  // More would cover the curve: of a rough measurement's thousands the most prominent are named.
  static std::vector<TactileEvent> namedOf(std::vector<TactileEvent> events) {
    constexpr std::size_t most = 12;
    if (events.size() <= most) return events;
    std::ranges::nth_element(events, events.begin() + most, std::greater{},
                             [](const TactileEvent& e) { return e.point.prominence_N; });
    events.resize(most);
    return events;
  }

  void drawCallouts(std::string& out) {
    for (const TactileEvent& e : namedOf(metrics_.press.tactile))
      callout(out, {e.point.displacement_mm, e.point.force_N}, "Tactile point", -1);
    if (metrics_.operatingPoint) callout(out, *metrics_.operatingPoint, "Operating point", -1);
    if (metrics_.release)
      for (const TactileEvent& e : namedOf(metrics_.release->tactile))
        callout(out, {e.point.displacement_mm, e.point.force_N}, "Tactile point (release)", 1);
    if (metrics_.resetPoint) callout(out, *metrics_.resetPoint, "Reset point", 1);
    if (metrics_.press.bottomOut.wall)
      callout(out, {metrics_.press.bottomOut.displacement_mm, metrics_.press.bottomOut.force_N}, "Bottom-out",
              1);
  }

  // Two lines of text with a leader and a dot, where they cover neither curves nor each other if any place
  // allows.
  void callout(std::string& out, CurvePoint point, const std::string& name, double preferredSide) {
    const Spot at = spot(point.displacement_mm, point.force_N);
    const std::string value = valueText(point);
    const double width = glyphWidth_px * static_cast<double>(std::max(name.size(), value.size())) + 8,
                 height = 32;
    double bestCost = std::numeric_limits<double>::infinity();
    Box best{};
    for (int ring = 1; ring <= 6; ++ring)
      for (int direction = 0; direction < 12; ++direction) {
        const double angle = 2 * 3.14159265358979323846 * direction / 12;
        const Spot centre{at.x + std::cos(angle) * (20.0 * ring + 0.5 * width),
                          at.y + std::sin(angle) * (20.0 * ring + 0.5 * height)};
        const Box box{centre.x - 0.5 * width, centre.y - 0.5 * height, centre.x + 0.5 * width,
                      centre.y + 0.5 * height};
        const double cost = costOf(box) + 10.0 * ring + (preferredSide * std::sin(angle) < 0 ? 15 : 0);
        if (cost < bestCost) {
          bestCost = cost;
          best = box;
        }
      }
    taken_.push_back(best);
    const Spot edge{std::clamp(at.x, best.x0, best.x1), std::clamp(at.y, best.y0, best.y1)};
    line(out, at, edge, "stroke=\"#444\" stroke-width=\"0.9\"");
    out += "<circle cx=\"" + px(at.x) + "\" cy=\"" + px(at.y) + "\" r=\"3.2\" fill=\"#222\"/>\n";
    out += "<rect x=\"" + px(best.x0) + "\" y=\"" + px(best.y0) + "\" width=\"" + px(width) + "\" height=\"" +
           px(height) + "\" fill=\"#fff\" fill-opacity=\"0.85\"/>\n";
    const double middle = 0.5 * (best.x0 + best.x1);
    text(out, {middle, best.y0 + 13}, "middle", name, " font-size=\"11\"");
    text(out, {middle, best.y0 + 27}, "middle", value, " font-size=\"11\"");
  }

  double costOf(const Box& box) const {
    double cost = 0;
    if (box.x0 < frame_.x0 + 2 || box.x1 > frame_.x1 - 2 || box.y0 < frame_.y0 + 2 || box.y1 > frame_.y1 - 2)
      cost += 1e6;
    for (const Box& other : taken_)
      if (box.overlaps(other)) cost += 1e4;
    const Box wide{box.x0 - 3, box.y0 - 3, box.x1 + 3, box.y1 + 3};
    for (const Spot& p : ink_)
      if (wide.contains(p)) cost += 20;
    return cost;
  }

  const ButtonState& state_;
  const SvgPlotStyle& style_;
  std::string title_;
  StateMetrics metrics_;
  Box frame_{};
  Ticks xTicks_, yTicks_;
  std::vector<Spot> ink_;
  std::vector<Box> taken_;
};

}  // namespace

double Ticks::at(int i) const {
  // Multiples of the step, not sums: 0.3 prints as 0.3.
  return (std::round(first / step) + i) * step;
}

Ticks niceTicks(double low, double high, int aboutSteps) {
  DETENT_CHECK(std::isfinite(low) && std::isfinite(high) && low <= high && aboutSteps >= 2, "a finite range");
  if (!(high > low)) high = low == 0 ? 1 : low + std::abs(low);
  // A step keeps all its digits only above the smallest normal numbers: narrower ranges are one of their own.
  constexpr double narrowest = 1e-290;
  if (high - low < narrowest)
    high = low + std::max(narrowest, std::abs(low) * std::numeric_limits<double>::epsilon());
  const double rough = (high - low) / aboutSteps;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  Ticks ticks;
  ticks.step = 10 * power;
  for (double factor : {1.0, 2.0, 5.0})
    if (factor * power >= rough * (1 - 1e-9)) {
      ticks.step = factor * power;
      break;
    }
  ticks.first = std::floor(low / ticks.step + 1e-9) * ticks.step;
  ticks.count = static_cast<int>(std::ceil((high - ticks.first) / ticks.step - 1e-9)) + 1;
  ticks.count = std::clamp(ticks.count, 2, 2 * aboutSteps + 2);
  ticks.decimals = static_cast<int>(std::clamp(-std::floor(std::log10(ticks.step) + 1e-9), 0.0, 300.0));
  return ticks;
}

PlotFrame frameOfPlot(const ButtonState& state, const SvgPlotStyle& style) {
  return Plot(state, style, "", 0).frame();
}

std::string svgFrom(const Button& button, const SvgPlotStyle& style) {
  DETENT_CHECK(style.width_px > 200 && style.height_px > 200, "a plot larger than 200 px");
  const double height = style.height_px * static_cast<double>(button.states().size());
  std::string out =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
      px(style.width_px) + "\" height=\"" + px(height) + "\" viewBox=\"0 0 " + px(style.width_px) + " " +
      px(height) + "\" font-family=\"DejaVu Sans, Arial, Helvetica, sans-serif\" font-size=\"" +
      px(fontSize_px) + "\" fill=\"#222\">\n<title>" + escapedForMarkup(button.name()) +
      "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
  double top = 0;
  for (const ButtonState& state : button.states()) {
    const std::string title = button.name() + (state.name.empty() ? "" : " (" + state.name + ")");
    out += Plot(state, style, title, top).svg();
    top += style.height_px;
  }
  return out + "</svg>\n";
}

}  // namespace detent
