// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/file/svg_plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>

#include "model/check.h"
#include "model/file/markup.h"
#include "model/metrics.h"
#include "model/sampling.h"

namespace detent {
namespace {

constexpr double marginLeft_px = 74, marginRight_px = 24, marginTop_px = 44, marginBottom_px = 60;
constexpr double designedFor_px = 12;  // font size for which the other lengths here are designed
constexpr double glyphWidth_px = 6.6;  // width of a sans-serif digit of that size, generous
constexpr double secondScale_px = 58;  // space for the second scale at the right
constexpr double dimensionRow_px = 24, leaderGap_px = 7;
constexpr double leaderUnderName = 2000;  // cost of a leader under a name, in places of curve under the words

std::string fixed(double value, int decimals) {
  char buffer[400];
  std::snprintf(buffer, sizeof buffer, "%.*f", decimals, value);
  std::string text = buffer;
  // "-0.0" becomes "0.0".
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

// Drawing of one state: map from mm and N to pixels, and the elements.
class Plot {
 public:
  Plot(const ButtonState& state, const SvgPlotStyle& style, std::string title, double top_px)
      : state_(state), style_(style), title_(std::move(title)), metrics_(metricsOf(state)) {
    const double right = marginRight_px + (style.secondForceUnit ? secondScale_px : 0);
    frame_ = {sized(marginLeft_px), top_px + sized(marginTop_px), style.width_px - sized(right),
              top_px + style.height_px - sized(marginBottom_px)};
    edge_px_ = frame_.x1;
    frame_.x1 = frame_.x0 + (edge_px_ - frame_.x0) / (1 + style.roomBeyondEnd);
    chooseTicks();
  }

  std::string svg() {
    std::string out = "<g>\n";
    drawGrid(out);
    if (style_.secondForceUnit) drawSecondScale(out);
    drawTitles(out);
    for (const Stroke stroke : {Stroke::press, Stroke::release})
      if (stroke == Stroke::press || state_.graph.release()) remember(travelledSamples(state_.graph, stroke));
    if (style_.dimensions) drawDimensions(out);
    // beneath the curves, so that they stay visible where it is crowded
    if (style_.callouts) drawCallouts(out);
    drawCurves(out);
    out += dots_;
    drawLegend(out);
    out += "<rect x=\"" + px(frame_.x0) + "\" y=\"" + px(frame_.y0) + "\" width=\"" +
           px(edge_px_ - frame_.x0) + "\" height=\"" + px(frame_.y1 - frame_.y0) +
           "\" fill=\"none\" stroke=\"#222\" stroke-width=\"1.4\"/>\n";
    return out + "</g>\n";
  }

  /// Labels that svg() left out, in words.
  const std::vector<std::string>& withoutRoom() const { return withoutRoom_; }

  PlotFrame frame() const { return {frame_.x0, frame_.y0, frame_.x1, frame_.y1, xTicks_, yTicks_}; }

 private:
  double sized(double designed_px) const { return designed_px * style_.fontSize_px / designedFor_px; }
  std::string colourOf(Stroke stroke) const {
    if (style_.monochrome) return stroke == Stroke::press ? "#000" : "#111";
    return stroke == Stroke::press ? "#0072b2" : "#c46f00";
  }
  std::string numbered(std::string digits) const {
    if (style_.decimalSign != '.') std::ranges::replace(digits, '.', style_.decimalSign);
    return digits;
  }

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
    const AxisEnds x = style_.xEnds.value_or(AxisEnds{std::min(left, 0.0) / perUnit_mm, right / perUnit_mm});
    const AxisEnds y =
        style_.yEnds.value_or(AxisEnds{std::min(low, 0.0) / perUnit_N, std::max(high, 0.0) / perUnit_N});
    // Labels of a small plot keep their distance.
    const auto steps = [&](double length_px, double each_px, int most) {
      return std::clamp(static_cast<int>(length_px / sized(each_px)), 2, most);
    };
    xTicks_ = niceTicks(x.lowest, x.highest, steps(frame_.x1 - frame_.x0, 45, 8));
    if (style_.roomBeyondEnd > 0 && !style_.xEnds) endBehindCurve(x.highest);
    yTicks_ = niceTicks(y.lowest, y.highest, steps(frame_.y1 - frame_.y0, 28, 7));
  }

  // Ends the frame behind the curves if the last tick lies far out.
  void endBehindCurve(double highest) {
    constexpr int leastTicks = 3;
    const double end = highest + style_.roomBeyondEnd * (highest - xTicks_.first);
    if (xTicks_.count <= leastTicks || end >= xTicks_.last()) return;
    --xTicks_.count;
    frame_.x1 = frame_.x0 + (edge_px_ - frame_.x0) * (xTicks_.last() - xTicks_.first) / (end - xTicks_.first);
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

  static constexpr const char* tickLine = "stroke=\"#222\" stroke-width=\"1.2\"";

  void drawGrid(std::string& out) const {
    const char* grid = "stroke=\"#c9c9c9\" stroke-width=\"0.8\"";
    for (int i = 0; i < xTicks_.count; ++i) {
      const double x = frame_.x0 + (frame_.x1 - frame_.x0) * i / (xTicks_.count - 1);
      line(out, {x, frame_.y0}, {x, frame_.y1}, grid);
      line(out, {x, frame_.y1}, {x, frame_.y1 + sized(5)}, tickLine);
      text(out, {x, frame_.y1 + sized(19)}, "middle", label(xTicks_, i));
    }
    for (int i = 0; i < yTicks_.count; ++i) {
      const double y = frame_.y1 - (frame_.y1 - frame_.y0) * i / (yTicks_.count - 1);
      line(out, {frame_.x0, y}, {edge_px_, y}, grid);
      line(out, {frame_.x0 - sized(5), y}, {frame_.x0, y}, tickLine);
      text(out, {frame_.x0 - sized(9), y + sized(4)}, "end", label(yTicks_, i));
    }
  }

  // The same forces in another unit, with its own round ticks.
  void drawSecondScale(std::string& out) const {
    const double perFirst = newtonsPer(style_.forceUnit) / newtonsPer(*style_.secondForceUnit);
    const double low = yTicks_.first * perFirst, high = yTicks_.last() * perFirst;
    const Ticks ticks = niceTicks(low, high, yTicks_.count);
    for (int i = 0; i < ticks.count; ++i) {
      const double share = (ticks.at(i) - low) / (high - low);
      if (share < -1e-9 || share > 1 + 1e-9) continue;
      const double y = frame_.y1 - share * (frame_.y1 - frame_.y0);
      line(out, {edge_px_, y}, {edge_px_ + sized(5), y}, tickLine);
      text(out, {edge_px_ + sized(9), y + sized(4)}, "start", label(ticks, i));
    }
    upright(out, style_.width_px - sized(14),
            style_.words.force + " (" + std::string(symbolOf(*style_.secondForceUnit)) + ")");
  }

  void upright(std::string& out, double x, const std::string& what) const {
    const double y = 0.5 * (frame_.y0 + frame_.y1);
    text(out, {x, y}, "middle", what, " transform=\"rotate(-90 " + px(x) + " " + px(y) + ")\"");
  }

  std::string label(const Ticks& ticks, int i) const {
    if (ticks.decimals <= 6 && std::abs(ticks.last()) < 1e7)
      return numbered(fixed(ticks.at(i), ticks.decimals));
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.4g", ticks.at(i));
    return numbered(buffer);
  }

  void drawTitles(std::string& out) const {
    const double middleX = 0.5 * (frame_.x0 + edge_px_);
    text(out, {middleX, frame_.y1 + sized(44)}, "middle",
         style_.words.displacement + " (" + std::string(symbolOf(style_.lengthUnit)) + ")");
    upright(out, sized(20), style_.words.force + " (" + std::string(symbolOf(style_.forceUnit)) + ")");
    if (!title_.empty())
      text(out, {middleX, frame_.y0 - sized(27)}, "middle", title_,
           " font-size=\"" + px(sized(15)) + "\" font-weight=\"bold\"");
  }

  // Hermite pieces as Béziers; vertical pieces as lines.
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
    if (style_.tolerance || style_.tolerance_N) drawTolerance(out, travelledSamples(graph, Stroke::press));
    // The release lies above the press: its dashes on the common bottom-out are seen, and read back.
    drawStroke(out, Stroke::press, "");
    if (graph.release()) drawStroke(out, Stroke::release, dash());
  }

  std::string dash() const {
    const double unit = style_.lineWidth_px / 2;
    return " stroke-dasharray=\"" + px(7 * unit) + " " + px(4 * unit) + "\"";
  }

  void drawStroke(std::string& out, Stroke stroke, const std::string& dashes) {
    const bool press = stroke == Stroke::press, cut = style_.xEnds || style_.yEnds;
    out += "<path class=\"" + std::string(press ? "press" : "release") + "\" d=\"" +
           (cut ? cutPathOf(travelledSamples(state_.graph, stroke)) : pathOf(state_.graph.curve(stroke))) +
           "\" fill=\"none\" stroke=\"" + colourOf(stroke) + "\" stroke-width=\"" + px(style_.lineWidth_px) +
           "\" stroke-linejoin=\"round\"" + dashes + "/>\n";
  }

  // Clips a line to the frame. No clip path, because programs that read only basic SVG would draw over the
  // axes.
  std::string cutPathOf(const std::vector<CurvePoint>& points) const {
    std::string d;
    std::optional<Spot> pen;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const auto part = insideFrame(spot(points[i].displacement_mm, points[i].force_N),
                                    spot(points[i + 1].displacement_mm, points[i + 1].force_N));
      if (!part) continue;
      const auto& [from, to] = *part;
      if (!pen || pen->x != from.x || pen->y != from.y) d += " M" + px(from.x) + " " + px(from.y);
      d += " L" + px(to.x) + " " + px(to.y);
      pen = to;
    }
    return d.empty() ? "M" + px(frame_.x0) + " " + px(frame_.y1) : d.substr(1);
  }

  std::optional<std::pair<Spot, Spot>> insideFrame(Spot a, Spot b) const {
    double first = 0, last = 1;
    const auto within = [&](double at, double way, double low, double high) {
      if (way == 0) return at >= low && at <= high;
      const double in = (low - at) / way, out = (high - at) / way;
      first = std::max(first, std::min(in, out));
      last = std::min(last, std::max(in, out));
      return first <= last;
    };
    const Spot way{b.x - a.x, b.y - a.y};
    const double right = style_.xEnds ? frame_.x1 : edge_px_;
    if (!within(a.x, way.x, frame_.x0, right) || !within(a.y, way.y, frame_.y0, frame_.y1)) return {};
    const auto at = [&](double share) {
      if (share == 0) return a;
      return share == 1 ? b : Spot{a.x + share * way.x, a.y + share * way.y};
    };
    return std::pair{at(first), at(last)};
  }

  void drawTolerance(std::string& out, const std::vector<CurvePoint>& press) const {
    std::string d;
    const auto add = [&](const CurvePoint& p, double side) {
      const double away_N = style_.tolerance ? *style_.tolerance * p.force_N : *style_.tolerance_N;
      const Spot at = spot(p.displacement_mm, p.force_N + side * away_N);
      d += (d.empty() ? "M" : " L") + px(std::clamp(at.x, frame_.x0, edge_px_)) + " " +
           px(std::clamp(at.y, frame_.y0, frame_.y1));
    };
    for (const CurvePoint& p : press) add(p, 1);
    for (std::size_t i = press.size(); i-- > 0;) add(press[i], -1);
    out += "<path class=\"tolerance\" d=\"" + d + " Z\" fill=\"#dfe7ee\"/>\n";
  }

  // Draws pre-travel and differential travel, one row each, at the top or bottom of the frame, wherever the
  // curves leave more space.
  void drawDimensions(std::string& out) {
    if (!metrics_.operatingPoint) return;
    const double closes_mm = metrics_.operatingPoint->displacement_mm;
    const double height = sized(2 * dimensionRow_px + 8), end = spot(closes_mm, 0).x;
    const auto drawnBetween = [&](double top, double bottom) {
      return std::ranges::count_if(drawn_,
                                   [&](const Spot& p) { return p.x < end && p.y > top && p.y < bottom; });
    };
    const bool above =
        drawnBetween(frame_.y0, frame_.y0 + height) <= drawnBetween(frame_.y1 - height, frame_.y1);
    const double first = above ? frame_.y0 + sized(dimensionRow_px) : frame_.y1 - sized(8);
    const double step = sized(dimensionRow_px) * (above ? 1 : -1);
    dimension(out, 0, closes_mm, style_.words.preTravel, first);
    if (metrics_.resetPoint)
      dimension(out, metrics_.resetPoint->displacement_mm, closes_mm, style_.words.differentialTravel,
                first + step);
  }

  void dimension(std::string& out, double from_mm, double to_mm, const std::string& name, double y) {
    if (from_mm == to_mm) return;
    const double a = spot(std::min(from_mm, to_mm), 0).x, b = spot(std::max(from_mm, to_mm), 0).x;
    const char* thin = "stroke=\"#777\" stroke-width=\"0.7\"";
    line(out, {a, y}, {b, y}, thin);
    for (const double x : {a, b}) line(out, {x, y - sized(4)}, {x, y + sized(4)}, thin);
    char value[60];
    std::snprintf(value, sizeof value, "%.3g", std::abs(to_mm - from_mm) / millimetresPer(style_.lengthUnit));
    const std::string words = name + " " + numbered(value) + " " + std::string(symbolOf(style_.lengthUnit));
    const double width = sized(glyphWidth_px) * static_cast<double>(words.size());
    const double least = frame_.x0 + 0.5 * width + 4, most = edge_px_ - 0.5 * width - 4;
    if (least > most) return withoutRoom_.push_back(words);
    const double x = std::clamp(0.5 * (a + b), least, most);
    text(out, {x, y - sized(5)}, "middle", words, smallText());
    taken_.push_back({x - 0.5 * width, y - sized(18), x + 0.5 * width, y + sized(5)});
  }

  std::string smallText() const { return " font-size=\"" + px(sized(11)) + "\""; }

  // Marks places that labels should avoid.
  void remember(const std::vector<CurvePoint>& points) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const Spot a = spot(points[i].displacement_mm, points[i].force_N);
      const Spot b = spot(points[i + 1].displacement_mm, points[i + 1].force_N);
      const int parts = static_cast<int>(std::clamp(std::hypot(b.x - a.x, b.y - a.y) / 4, 1.0, 500.0));
      for (int k = 0; k <= parts; ++k)
        drawn_.push_back({a.x + (b.x - a.x) * k / parts, a.y + (b.y - a.y) * k / parts});
    }
  }

  void drawLegend(std::string& out) {
    const double y = frame_.y0 - sized(8);
    double x = frame_.x0 + 4;
    const auto entry = [&](const std::string& name, Stroke stroke, const std::string& dashes) {
      line(out, {x, y - sized(4)}, {x + sized(28), y - sized(4)},
           ("stroke=\"" + colourOf(stroke) + "\" stroke-width=\"" + px(style_.lineWidth_px) + "\"" + dashes)
               .c_str());
      text(out, {x + sized(34), y}, "start", name);
      x += sized(34 + glyphWidth_px * (static_cast<double>(name.size()) + 1) + 18);
    };
    entry(style_.words.press + toleranceText(), Stroke::press, "");
    if (state_.graph.release()) entry(style_.words.release, Stroke::release, dash());
  }

  // Half width of the band as text.
  std::string toleranceText() const {
    char buffer[60] = "";
    if (style_.tolerance)
      std::snprintf(buffer, sizeof buffer, " \u00b1 %.3g %%", 100 * *style_.tolerance);
    else if (style_.tolerance_N)
      std::snprintf(buffer, sizeof buffer, " \u00b1 %.3g %s",
                    *style_.tolerance_N / newtonsPer(style_.forceUnit),
                    std::string(symbolOf(style_.forceUnit)).c_str());
    return numbered(buffer);
  }

  std::string valueText(CurvePoint p) const {
    char buffer[120];
    std::snprintf(buffer, sizeof buffer, "%.3g %s %s %.3g %s", p.force_N / newtonsPer(style_.forceUnit),
                  std::string(symbolOf(style_.forceUnit)).c_str(), style_.words.at.substr(0, 20).c_str(),
                  p.displacement_mm / millimetresPer(style_.lengthUnit),
                  std::string(symbolOf(style_.lengthUnit)).c_str());
    return numbered(buffer);
  }

  // Limits the callouts to the most prominent points; thousands of a rough measurement would cover the curve.
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
      callout(out, {e.point.displacement_mm, e.point.force_N}, style_.words.tactilePoint, -1);
    if (metrics_.operatingPoint) callout(out, *metrics_.operatingPoint, style_.words.operatingPoint, -1);
    if (metrics_.release)
      for (const TactileEvent& e : namedOf(metrics_.release->tactile))
        callout(out, {e.point.displacement_mm, e.point.force_N}, style_.words.tactilePointOfRelease, 1);
    if (metrics_.resetPoint) callout(out, *metrics_.resetPoint, style_.words.resetPoint, 1);
    if (metrics_.press.bottomOut.isSteep)
      callout(out, {metrics_.press.bottomOut.displacement_mm, metrics_.press.bottomOut.force_N},
              style_.words.bottomOut, 1);
    out += plates_;
  }

  // Draws a dot, and two lines of text with a leader: inside the frame, free of other labels, and of curves if
  // possible. Without room for the text, the dot alone.
  void callout(std::string& out, CurvePoint point, const std::string& name, double preferredSide) {
    const Spot at = spot(point.displacement_mm, point.force_N);
    const std::string value = valueText(point);
    const double width = sized(glyphWidth_px * static_cast<double>(std::max(name.size(), value.size())) + 8),
                 height = sized(32);
    double bestCost = std::numeric_limits<double>::infinity();
    Box best{};
    for (int ring = 1; ring <= 10; ++ring)
      for (int direction = 0; direction < 12; ++direction) {
        const double angle = 2 * 3.14159265358979323846 * direction / 12;
        const Spot centre{at.x + std::cos(angle) * (sized(20) * ring + 0.5 * width),
                          at.y + std::sin(angle) * (sized(20) * ring + 0.5 * height)};
        const Box box{centre.x - 0.5 * width, centre.y - 0.5 * height, centre.x + 0.5 * width,
                      centre.y + 0.5 * height};
        if (!hasRoom(box)) continue;
        const double cost = costOf(box) + 10.0 * ring + (preferredSide * std::sin(angle) < 0 ? 15 : 0) +
                            (underAnother(at, nearestOf(box, at)) ? leaderUnderName : 0);
        if (cost < bestCost) {
          bestCost = cost;
          best = box;
        }
      }
    dots_ += "<circle cx=\"" + px(at.x) + "\" cy=\"" + px(at.y) + "\" r=\"3.2\" fill=\"#222\"/>\n";
    if (!std::isfinite(bestCost)) return withoutRoom_.push_back(name + " " + value);
    const Spot edge = nearestOf(best, at);
    line(out, awayFrom(at, edge), edge, "stroke=\"#444\" stroke-width=\"0.9\"");
    plates_ += "<rect x=\"" + px(best.x0) + "\" y=\"" + px(best.y0) + "\" width=\"" + px(width) +
               "\" height=\"" + px(height) + "\" fill=\"#fff\" fill-opacity=\"0.85\"/>\n";
    const double middle = 0.5 * (best.x0 + best.x1);
    text(plates_, {middle, best.y0 + sized(13)}, "middle", name, smallText());
    text(plates_, {middle, best.y0 + sized(27)}, "middle", value, smallText());
    taken_.push_back(best);
  }

  static Spot nearestOf(const Box& box, Spot to) {
    return {std::clamp(to.x, box.x0, box.x1), std::clamp(to.y, box.y0, box.y1)};
  }

  // Returns true if a leader would run under another callout's text.
  bool underAnother(Spot at, Spot edge) const {
    constexpr int positions = 16;
    for (int i = 0; i <= positions; ++i) {
      const double share = static_cast<double>(i) / positions;
      const Spot there{at.x + share * (edge.x - at.x), at.y + share * (edge.y - at.y)};
      if (std::ranges::any_of(taken_, [there](const Box& other) { return other.contains(there); }))
        return true;
    }
    return false;
  }

  // Start of a leader that avoids the curve.
  Spot awayFrom(Spot at, Spot towards) const {
    const double length = std::hypot(towards.x - at.x, towards.y - at.y);
    const double gap = std::min(sized(leaderGap_px), length);
    if (length == 0) return at;
    return {at.x + gap * (towards.x - at.x) / length, at.y + gap * (towards.y - at.y) / length};
  }

  // Returns true if a box lies inside the frame and over no other label.
  bool hasRoom(const Box& box) const {
    return box.x0 >= frame_.x0 + 2 && box.x1 <= edge_px_ - 2 && box.y0 >= frame_.y0 + 2 &&
           box.y1 <= frame_.y1 - 2 &&
           std::ranges::none_of(taken_, [&](const Box& other) { return box.overlaps(other); });
  }

  double costOf(const Box& box) const {
    double cost = 0;
    const Box widened{box.x0 - 3, box.y0 - 3, box.x1 + 3, box.y1 + 3};
    for (const Spot& p : drawn_)
      if (widened.contains(p)) cost += 20;
    return cost;
  }

  const ButtonState& state_;
  const SvgPlotStyle& style_;
  std::string title_;
  StateMetrics metrics_;
  Box frame_{};         // area between the first and the last tick
  double edge_px_ = 0;  // right edge of the drawn frame
  Ticks xTicks_, yTicks_;
  std::vector<Spot> drawn_;
  std::vector<Box> taken_;
  std::string plates_;  // texts of callouts, over all leaders
  std::string dots_;    // dots of callouts, over the curves
  std::vector<std::string> withoutRoom_;
};

}  // namespace

double Ticks::at(int i) const {
  // Multiples of the step, not sums: 0.3 prints as 0.3.
  return (std::round(first / step) + i) * step;
}

Ticks niceTicks(double low, double high, int aboutSteps) {
  DETENT_CHECK(std::isfinite(low) && std::isfinite(high) && low <= high && aboutSteps >= 2, "a finite range");
  if (!(high > low)) high = low == 0 ? 1 : low + std::abs(low);
  // With a smaller range, a double could not hold all digits of the step.
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

namespace {

struct Drawing {
  std::string plots;  // SVG elements
  std::vector<std::string> withoutRoom;
};

Drawing drawingOf(const Button& button, const SvgPlotStyle& style) {
  Drawing drawing;
  double top = 0;
  for (const ButtonState& state : button.states()) {
    const std::string name = state.name == "unlocked" ? style.words.unlocked
                             : state.name == "locked" ? style.words.locked
                                                      : state.name;
    Plot plot(state, style, button.name() + (name.empty() ? "" : " (" + name + ")"), top);
    drawing.plots += plot.svg();
    std::ranges::copy(plot.withoutRoom(), std::back_inserter(drawing.withoutRoom));
    top += style.height_px;
  }
  return drawing;
}

}  // namespace

std::vector<std::string> labelsWithoutRoom(const Button& button, const SvgPlotStyle& style) {
  return drawingOf(button, style).withoutRoom;
}

std::string svgFrom(const Button& button, const SvgPlotStyle& style) {
  DETENT_CHECK(style.width_px > 200 && style.height_px > 200, "a plot larger than 200 px");
  const double height = style.height_px * static_cast<double>(button.states().size());
  const double unit = style.width_mm ? *style.width_mm / style.width_px : 1;
  const char* unitName = style.width_mm ? "mm" : "";
  std::string out =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
      px(style.width_px * unit) + unitName + "\" height=\"" + px(height * unit) + unitName +
      "\" viewBox=\"0 0 " + px(style.width_px) + " " + px(height) + "\" font-family=\"" +
      escapedForMarkup(style.font) + "\" font-size=\"" + px(style.fontSize_px) +
      "\" fill=\"#222\">\n<title>" + escapedForMarkup(button.name()) + "</title>\n<rect width=\"" +
      px(style.width_px) + "\" height=\"" + px(height) + "\" fill=\"#fff\"/>\n";
  return out + drawingOf(button, style).plots + "</svg>\n";
}

}  // namespace detent
