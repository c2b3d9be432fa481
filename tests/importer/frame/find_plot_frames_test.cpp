// SPDX-License-Identifier: GPL-3.0-or-later
// Frames drawn by the test are found where they were drawn; what is no plot gives nothing.

#include <random>

#include <catch2/catch.hpp>

#include "importer/frame/plot_frame.h"
#include "tests/importer/frame/drawn_plot.h"

using namespace detent;
using namespace detent::importer;
using namespace detent::importer::test;

namespace {

struct Seen {
  std::vector<Found<FrameCandidate>> candidates;
  std::vector<PlotFrame> frames;
};

Seen readingOf(const cv::Mat& grey) {
  const auto document = documentOf(grey);
  const auto page = document.page(1).value();
  Seen seen;
  seen.candidates = findPlotFrames(page);
  for (const auto& c : seen.candidates) {
    const auto view =
        document.view(page, c.value.regionBox, c.value.quarterTurns, {}, c.value.levelToPage).value();
    auto frame = locatePlotFrame(view, page, c.value);
    REQUIRE(frame.ok());
    // Back to page pixels, so that they can be compared with what was drawn.
    for (auto& corner : frame->value.corners) corner = view.viewToPage(corner);
    seen.frames.push_back(frame->value);
  }
  return seen;
}

void requireCorners(const PlotFrame& f, const PlotStyle& s, double within) {
  CHECK(f.corners[0].x == Approx(s.left).margin(within));
  CHECK(f.corners[0].y == Approx(s.top).margin(within));
  CHECK(f.corners[2].x == Approx(s.right).margin(within));
  CHECK(f.corners[2].y == Approx(s.bottom).margin(within));
}

}  // namespace

TEST_CASE("few numbers below stand for themselves where those beside the plot read upwards") {
  PlotStyle s;
  s.width = 560, s.height = 420, s.left = 60, s.top = 60, s.right = 530, s.bottom = 340;
  s.xSteps = 3, s.xStep = 1, s.labels = s.grid = false, s.xTitle = s.yTitle = "";
  Canvas c(s.width, s.height, s.paperGrey);
  drawInto(c, s);
  for (int k = 0; k <= s.xSteps; ++k)
    c.text(shown(k), s.left + (s.right - s.left) * k / s.xSteps, s.bottom + 24, 0, 0.4);
  for (const auto& [text, k] :
       {std::pair("0.0", 0), std::pair("0.5", 1), std::pair("1.0", 2), std::pair("1.5", 3)})
    c.text(text, s.left - 20, s.bottom - (s.bottom - s.top) * k / 3, 0, 0.4, 1);
  const Seen seen = readingOf(c.grey());
  REQUIRE(seen.frames.size() == 1);
  requireCorners(seen.frames[0], s, 0.6);
}

TEST_CASE("frames of many styles are found where they were drawn") {
  PlotStyle s;
  SECTION("box and light grid") {}
  SECTION("box without a grid") { s.grid = false; }
  SECTION("grid as dark as the frame") { s.gridGrey = 0; }
  SECTION("grey frame, very light grid") { s.lineGrey = 150, s.gridGrey = 235; }
  SECTION("thick") { s.lineWidth = 4; }
  SECTION("two axis lines and ticks") { s.box = s.grid = false; }
  SECTION("white on dark") { s.paperGrey = 40, s.lineGrey = 230, s.gridGrey = 90, s.textGrey = 230; }
  SECTION("labels at every second line") { s.labelEvery = 2; }
  SECTION("lines between pixels") { s.left = 100.37, s.top = 40.21, s.right = 820.83, s.bottom = 500.55; }
  SECTION("small") {
    s.width = 420, s.height = 300, s.left = 60, s.top = 20, s.right = 400, s.bottom = 240, s.xSteps = 4,
    s.ySteps = 4;
    s.xStep = 1, s.yTitle = "", s.textScale = 0.4;
  }
  const auto seen = readingOf(drawn(s));
  REQUIRE(seen.frames.size() == 1);
  CHECK(seen.candidates[0].value.quarterTurns == 0);
  CHECK(seen.candidates[0].confidence > 0.5);
  requireCorners(seen.frames[0], s, 0.15);
}

TEST_CASE("gridlines and ticks are placed to a tenth of a pixel") {
  PlotStyle s;
  s.left = 100.4, s.right = 819.6, s.top = 41.3, s.bottom = 499.7;
  s.lineWidth = 1.5;
  s.grid = GENERATE(true, false);
  const auto seen = readingOf(drawn(s));
  REQUIRE(seen.frames.size() == 1);
  for (int k = 0; k <= s.xSteps; ++k) {
    const double x = s.left + (s.right - s.left) * k / s.xSteps;
    double nearest = 1e9;
    for (const auto& line : seen.frames[0].xLines)
      nearest = std::min(nearest, std::abs(line.position_px - x));
    INFO("line " << k << " at " << x);
    CHECK(nearest < 0.1);
  }
}

TEST_CASE("a grid open at the top ends where its lines end") {
  PlotStyle s;
  s.topEdge = false;
  s.gridGrey = 0;
  const auto seen = readingOf(drawn(s));
  REQUIRE(seen.frames.size() == 1);
  CHECK(seen.frames[0].corners[0].y == Approx(s.top).margin(2));
}

TEST_CASE("an axis that runs on to an arrow does not widen the frame") {
  PlotStyle s;
  s.gridGrey = 0;
  Canvas c(s.width, s.height, 255);
  drawInto(c, s);
  c.column(s.left, s.top - 35, s.bottom, 1, 0);
  c.row(s.bottom, s.left, s.right + 70, 1, 0);
  const auto seen = readingOf(c.grey());
  REQUIRE(seen.frames.size() == 1);
  requireCorners(seen.frames[0], s, 0.15);
}

TEST_CASE("writing that punches holes into the grid does not split the frame") {
  PlotStyle s;
  s.gridGrey = 0;
  s.lineWidth = 2;
  Canvas c(s.width, s.height, 255);
  drawInto(c, s);
  c.fill(250, 230, 480, 260, 255);
  c.text("operating point", 365, 245, 0, 0.7);
  c.fill(430, 380, 640, 410, 255);
  c.text("reset point", 535, 395, 0, 0.7);
  const auto seen = readingOf(c.grey());
  REQUIRE(seen.frames.size() == 1);
  requireCorners(seen.frames[0], s, 0.15);
}

TEST_CASE("several graphs come in reading order") {
  PlotStyle s;
  s.width = 1500;
  s.left = 110, s.right = 650;
  PlotStyle t = s;
  t.left = 860, t.right = 1400;
  Canvas c(s.width, s.height, 255);
  drawInto(c, s);
  drawInto(c, t);
  const auto seen = readingOf(c.grey());
  REQUIRE(seen.frames.size() == 2);
  requireCorners(seen.frames[0], s, 0.15);
  requireCorners(seen.frames[1], t, 0.15);
}

TEST_CASE("a graph that lies on its side says how it stands up") {
  PlotStyle s;
  cv::Mat upright = drawn(s), lying;
  const bool clockwise = GENERATE(true, false);
  const bool touching = GENERATE(false, true);  // digits of a number, which appear upright as it lies
  if (touching)
    for (cv::Mat numbers : {upright.colRange(0, static_cast<int>(s.left) - 2),
                            upright.rowRange(static_cast<int>(s.bottom) + 3, upright.rows)})
      cv::erode(numbers, numbers, cv::Mat::ones(1, 4, CV_8U));
  cv::rotate(upright, lying, clockwise ? cv::ROTATE_90_CLOCKWISE : cv::ROTATE_90_COUNTERCLOCKWISE);
  const auto seen = readingOf(lying);
  REQUIRE_FALSE(seen.candidates.empty());
  const bool offered = std::any_of(
      seen.candidates.begin(), seen.candidates.end(),
      [&](const Found<FrameCandidate>& c) { return c.value.quarterTurns == (clockwise ? 3 : 1); });
  CHECK(offered);
}

TEST_CASE("a graph on its head is looked at so before one with numbers at the top and at the right") {
  cv::Mat onItsHead;
  cv::rotate(drawn(PlotStyle{}), onItsHead, cv::ROTATE_180);
  const auto seen = readingOf(onItsHead);
  REQUIRE(seen.candidates.size() == 2);
  CHECK(seen.candidates[0].value.quarterTurns == 2);
  CHECK(seen.candidates[1].value.quarterTurns == 0);
}

TEST_CASE("a scan a degree askew keeps its four corners") {
  PlotStyle s;
  s.lineWidth = 2;
  s.gridGrey = 60;
  const double degrees = GENERATE(-1.2, 0.8);
  const cv::Mat turn = cv::getRotationMatrix2D(
      {0.5F * static_cast<float>(s.width), 0.5F * static_cast<float>(s.height)}, degrees, 1);
  cv::Mat askew;
  cv::warpAffine(drawn(s), askew, turn, {s.width, s.height}, cv::INTER_CUBIC, cv::BORDER_CONSTANT,
                 cv::Scalar(255));
  const auto seen = readingOf(askew);
  REQUIRE(seen.frames.size() == 1);
  const auto expect = [&](double x, double y, const Point& found) {
    CHECK(found.x ==
          Approx(turn.at<double>(0, 0) * x + turn.at<double>(0, 1) * y + turn.at<double>(0, 2)).margin(0.5));
    CHECK(found.y ==
          Approx(turn.at<double>(1, 0) * x + turn.at<double>(1, 1) * y + turn.at<double>(1, 2)).margin(0.5));
  };
  expect(s.left, s.top, seen.frames[0].corners[0]);
  expect(s.right, s.top, seen.frames[0].corners[1]);
  expect(s.right, s.bottom, seen.frames[0].corners[2]);
  expect(s.left, s.bottom, seen.frames[0].corners[3]);
}

namespace {

/// The plot as a camera sees its sheet: `map` from the drawn plot to the picture; a light falls off to the
/// right.
cv::Mat photographOf(const PlotStyle& s, const cv::Matx33d& map) {
  cv::Mat seen;
  cv::warpPerspective(drawn(s), seen, map, {s.width, s.height}, cv::INTER_CUBIC, cv::BORDER_CONSTANT,
                      cv::Scalar(60));
  for (int y = 0; y < seen.rows; ++y)
    for (int x = 0; x < seen.cols; ++x) {
      std::uint8_t& value = seen.at<std::uint8_t>(y, x);
      value = static_cast<std::uint8_t>(value * (1 - 0.35 * x / seen.cols));
    }
  return seen;
}

}  // namespace

TEST_CASE("a photographed sheet stands level again, and its frame is found there") {
  PlotStyle s;
  s.lineWidth = 2;
  const cv::Matx33d map = GENERATE(cv::Matx33d(0.88, 0.05, 25, -0.06, 0.9, 60, -0.00015, 0.00008, 1),
                                   cv::Matx33d(0.85, -0.06, 70, 0.05, 0.85, 20, 0.0001, -0.0002, 1));
  const auto document = documentOf(photographOf(s, map));
  const auto page = document.page(1).value();
  const auto sheet = photographedSheet(page);
  REQUIRE(sheet);
  const auto candidates = findPlotFrames(page, {PaperBy::region, sheet});
  REQUIRE(candidates.size() == 1);
  const FrameCandidate& c = candidates[0].value;
  const auto view = document.view(page, c.regionBox, c.quarterTurns, {}, c.levelToPage).value();
  const auto frame = locatePlotFrame(view, page, c);
  REQUIRE(frame.ok());
  const std::array<Point, 4> meant{
      {{s.left, s.top}, {s.right, s.top}, {s.right, s.bottom}, {s.left, s.bottom}}};
  for (std::size_t k = 0; k < 4; ++k) {
    const cv::Vec3d at = map * cv::Vec3d(meant[k].x, meant[k].y, 1);
    const Point found = view.viewToPage(frame->value.corners[k]);
    CHECK(found.x == Approx(at[0] / at[2]).margin(0.8));
    CHECK(found.y == Approx(at[1] / at[2]).margin(0.8));
  }
}

TEST_CASE("corners given on a photograph make the same sheet; upright ones none") {
  PlotStyle s;
  const auto page = documentOf(drawn(s)).page(1).value();
  const std::vector<Point> askew{{120, 60}, {800, 90}, {780, 520}, {90, 480}};
  const auto sheet = sheetOfCorners(askew, page);
  REQUIRE(sheet);
  const Homography toLevel = sheet->inverse();
  CHECK(toLevel(askew[0]).x == Approx(toLevel(askew[3]).x).margin(1e-3));
  CHECK(toLevel(askew[1]).x == Approx(toLevel(askew[2]).x).margin(1e-3));
  CHECK(toLevel(askew[0]).y == Approx(toLevel(askew[1]).y).margin(1e-3));
  CHECK(toLevel(askew[3]).y == Approx(toLevel(askew[2]).y).margin(1e-3));
  CHECK_FALSE(sheetOfCorners({{100, 50}, {800, 50}, {800, 500}, {100, 500}}, page));
}

TEST_CASE("a picture without two directions of lines shows no photographed sheet") {
  cv::Mat grey(600, 900, CV_8U, cv::Scalar(255));
  SECTION("blank") {}
  SECTION("level lines alone") {
    for (int y = 60; y < 600; y += 60) cv::line(grey, {40, y}, {860, y}, cv::Scalar(0), 2);
  }
  CHECK_FALSE(photographedSheet(documentOf(grey).page(1).value()));
}

TEST_CASE("a picture that stands level is no photograph") {
  CHECK_FALSE(photographedSheet(documentOf(drawn(PlotStyle{})).page(1).value()));
}

TEST_CASE("lines rounded by Agg are known by their rims") {
  PlotStyle s;
  s.grid = false;
  SECTION("whole-pixel crest, thin equal rims: half a pixel off") {
    s.lineWidth = 1.11;
    const auto seen = readingOf(drawn(s));
    REQUIRE(seen.frames.size() == 1);
    CHECK(seen.frames[0].drawnOffset_px == Point{0.5, 0.5});
  }
  SECTION("one pixel sharp: nothing known") {
    const auto seen = readingOf(drawn(s));
    REQUIRE(seen.frames.size() == 1);
    CHECK(seen.frames[0].drawnOffset_px == Point{0, 0});
  }
  SECTION("smoothed where they stand") {
    s.lineWidth = 1.11, s.left = 100.3, s.right = 820.6, s.top = 40.2, s.bottom = 500.7;
    const auto seen = readingOf(drawn(s));
    REQUIRE(seen.frames.size() == 1);
    CHECK(seen.frames[0].drawnOffset_px == Point{0, 0});
  }
}

TEST_CASE("a render whose lines fall on whole pixels by chance is not taken for Agg's work") {
  PlotStyle s;
  s.grid = false, s.lineWidth = 1.11;
  const auto document = documentOf(drawn(s));
  const auto page = document.page(1).value();
  const auto candidates = findPlotFrames(page);
  REQUIRE(candidates.size() == 1);
  auto view = document.view(page, candidates[0].value.regionBox).value();
  view.nativePixels = false;
  CHECK(locatePlotFrame(view, page, candidates[0].value)->value.drawnOffset_px == Point{0, 0});
}

TEST_CASE("what is no plot has no frame") {
  cv::Mat grey(600, 900, CV_8U, cv::Scalar(255));
  std::mt19937 random(7);
  SECTION("blank") {}
  SECTION("one pixel") { grey = cv::Mat(1, 1, CV_8U, cv::Scalar(0)); }
  SECTION("noise") {
    for (int y = 0; y < grey.rows; ++y)
      for (int x = 0; x < grey.cols; ++x)
        grey.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(random() & 255U);
  }
  SECTION("something like a photograph") {
    for (int y = 0; y < grey.rows; ++y)
      for (int x = 0; x < grey.cols; ++x)
        grey.at<std::uint8_t>(y, x) =
            static_cast<std::uint8_t>(128 + 60 * std::sin(x / 70.0) + 50 * std::cos(y / 45.0 + x / 200.0));
  }
  SECTION("a page of text") {
    for (int line = 0; line < 22; ++line)
      cv::putText(grey, "The quick brown fox jumps over the lazy dog 0123456789", {20, 30 + 25 * line},
                  cv::FONT_HERSHEY_SIMPLEX, 0.8, cv::Scalar(0), 1, cv::LINE_AA);
  }
  SECTION("a table with numbers in its cells") {
    Canvas c(900, 600, 255);
    for (int k = 0; k <= 6; ++k) c.column(100 + 110 * k, 50, 450, 1, 0);
    for (int k = 0; k <= 8; ++k) c.row(50 + 50 * k, 100, 760, 1, 0);
    for (int i = 0; i < 6; ++i)
      for (int k = 0; k < 8; ++k)
        c.text(shown(static_cast<double>(random() % 997) / 10), 155 + 110 * i, 75 + 50 * k, 0);
    grey = c.grey();
  }
  SECTION("a grid of holes without numbers") {
    for (int i = 0; i < 9; ++i) cv::line(grey, {150 + 60 * i, 100}, {150 + 60 * i, 500}, cv::Scalar(0));
    for (int k = 0; k < 7; ++k) cv::line(grey, {150, 100 + 60 * k}, {630, 100 + 60 * k}, cv::Scalar(0));
  }
  CHECK(readingOf(grey).candidates.empty());
}

TEST_CASE("a page border around a graph is not taken for it") {
  PlotStyle s;
  Canvas c(s.width, s.height, 255);
  drawInto(c, s);
  cv::rectangle(c.grey(), {6, 6}, {893, 593}, cv::Scalar(0), 2);
  const auto seen = readingOf(c.grey());
  REQUIRE(seen.frames.size() == 1);
  requireCorners(seen.frames[0], s, 0.15);
}

TEST_CASE("frames given by hand") {
  const auto document = documentOf(drawn({}));
  const auto page = document.page(1).value();
  SECTION("two opposite corners in any order") {
    const auto given = frameFromCorners({{820, 500}, {100, 40}}, page);
    REQUIRE(given.ok());
    CHECK(given->by == DecidedBy::given);
    CHECK(given->confidence == 1);
    CHECK(given->value.pageBox == Box{100, 40, 820, 500});
  }
  SECTION("four corners are kept as they are") {
    const std::vector<Point> corners{{101, 42}, {819, 44}, {822, 503}, {99, 498}};
    const auto given = frameFromCorners(corners, page);
    REQUIRE(given.ok());
    const auto view = document.view(page, given->value.regionBox).value();
    const auto frame = locatePlotFrame(view, page, given->value);
    REQUIRE(frame.ok());
    CHECK(frame->by == DecidedBy::given);
    for (std::size_t k = 0; k < 4; ++k) {
      const Point p = view.viewToPage(frame->value.corners[k]);
      CHECK(p.x == Approx(corners[k].x).margin(1e-9));
      CHECK(p.y == Approx(corners[k].y).margin(1e-9));
    }
  }
  SECTION("nonsense is refused with a sentence") {
    const auto bad =
        GENERATE(std::vector<Point>{}, std::vector<Point>{{1, 1}}, std::vector<Point>{{1, 1}, {2, 2}, {3, 3}},
                 std::vector<Point>{{10, 10}, {10, 200}}, std::vector<Point>{{-50, 10}, {100, 200}},
                 std::vector<Point>{{100, 40}, {100, 500}, {820, 500}, {820, 40}},
                 std::vector<Point>{{std::nan(""), 10}, {100, 200}});
    const auto given = frameFromCorners(bad, page);
    REQUIRE_FALSE(given.ok());
    CHECK(given.failure().code == FailureCode::wrongUsage);
    CHECK_FALSE(given.failure().problem.empty());
    CHECK_FALSE(given.failure().remedies.empty());
  }
}
