// SPDX-License-Identifier: GPL-3.0-or-later
// PDF and SVG: paths, texts and images where the page has them; hostile documents are refused.

#include "importer/page/document.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <optional>
#include <string>

#include <catch2/catch.hpp>
#include <sys/wait.h>
#include <zlib.h>

using namespace detent;
using namespace detent::importer;

namespace {

using Bytes = std::vector<unsigned char>;

Bytes bytesOf(const std::string& text) { return {text.begin(), text.end()}; }

std::string streamObject(const std::string& dictionary, const std::string& content) {
  return "<<" + dictionary + "/Length " + std::to_string(content.size()) + ">>\nstream\n" + content +
         "\nendstream";
}

/// A PDF file of these objects; the first is the catalogue.
std::string pdfOf(const std::vector<std::string>& objects) {
  std::string out = "%PDF-1.4\n", table;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const std::string offset = std::to_string(out.size());
    table += std::string(10 - offset.size(), '0') + offset + " 00000 n \n";
    out += std::to_string(i + 1) + " 0 obj\n" + objects[i] + "\nendobj\n";
  }
  const std::string count = std::to_string(objects.size() + 1), start = std::to_string(out.size());
  return out + "xref\n0 " + count + "\n0000000000 65535 f \n" + table + "trailer\n<</Size " + count +
         "/Root 1 0 R>>\nstartxref\n" + start + "\n%%EOF\n";
}

/// One page of 200 x 100 points. Objects 5 and 6 are a font /F and an image /I of 4 x 2 grey pixels.
std::string onePage(const std::string& content, const std::string& pageEntries = "") {
  return pdfOf(
      {"<</Type/Catalog/Pages 2 0 R>>", "<</Type/Pages/Kids[3 0 R]/Count 1>>",
       "<</Type/Page/Parent 2 0 R/MediaBox[0 0 200 100]" + pageEntries +
           "/Contents 4 0 R/Resources<</Font<</F 5 0 R>>/XObject<</I 6 0 R/X 7 0 R>>>>>>",
       streamObject("", content), "<</Type/Font/Subtype/Type1/BaseFont/Helvetica>>",
       streamObject("/Type/XObject/Subtype/Image/Width 4/Height 2/ColorSpace/DeviceGray/BitsPerComponent 8",
                    std::string("\x10\x20\x30\x40\x50\x60\x70\x80", 8)),
       streamObject("/Type/XObject/Subtype/Form/BBox[0 0 200 100]", "0 0 1 RG 3 w 10 10 m 50 10 l S")});
}

struct Opened {
  Document document;
  Page page;
};

Opened open(const std::string& text, const std::string& name) {
  auto document = Document::fromBytes(bytesOf(text), name);
  INFO((document.ok() ? std::string() : document.failure().sentence()));
  REQUIRE(document.ok());
  auto page = document->page(1);
  INFO((page.ok() ? std::string() : page.failure().sentence()));
  REQUIRE(page.ok());
  return {std::move(document).value(), std::move(page).value()};
}

Failure documentRefusal(const std::string& text, const std::string& name, const PageLimits& limits = {}) {
  const auto document = Document::fromBytes(bytesOf(text), name, limits);
  if (!document) return document.failure();
  const auto page = document->page(1);
  REQUIRE_FALSE(page.ok());
  return page.failure();
}

const TextBox* textNamed(const std::vector<TextBox>& texts, const std::string& words) {
  for (const TextBox& text : texts)
    if (text.utf8 == words) return &text;
  return nullptr;
}

}  // namespace

TEST_CASE("strokes and fills keep colour, width, dash and place") {
  const auto opened = open(
      onePage("1 0 0 RG 2 w 10 20 m 60 90 l 110 20 l S  0 1 0 rg 20 20 30 10 re f  [4 2] 0 d 0 0 0 1 K 1 w "
              "0 50 m 200 50 l S"),
      "plot.pdf");
  REQUIRE(opened.page.paths.size() == 3);
  const VectorPath& stroke = opened.page.paths[0];
  REQUIRE(stroke.stroke);
  CHECK(*stroke.stroke == Rgb{255, 0, 0});
  CHECK_FALSE(stroke.fill);
  CHECK(stroke.strokeWidth == Approx(2));
  CHECK_FALSE(stroke.dashed);
  REQUIRE(stroke.polylines.size() == 1);
  REQUIRE(stroke.polylines[0].size() == 3);
  CHECK(stroke.polylines[0][1].x == Approx(60));
  CHECK(stroke.polylines[0][1].y == Approx(10));  // origin top left
  CHECK(*opened.page.paths[1].fill == Rgb{0, 255, 0});
  CHECK(opened.page.paths[1].closed[0]);
  CHECK(opened.page.paths[2].dashed);
  CHECK(opened.page.paths[2].stroke->r < 60);  // CMYK black
  CHECK(opened.page.width == 200);
  CHECK(opened.page.unit == PageUnit::point);
}

TEST_CASE("curves are flattened within the promised distance") {
  const auto opened = open(onePage("0 0 m 0 80 200 80 200 0 c S"), "plot.pdf");
  const auto& line = opened.page.paths[0].polylines[0];
  double worst = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double t = i / 1000.0, s = 1 - t;
    const Point p{3 * s * t * t * 200 + t * t * t * 200, 100 - 3 * s * s * t * 80 - 3 * s * t * t * 80};
    double nearest = 1e9;
    for (std::size_t k = 1; k < line.size(); ++k) {
      const double dx = line[k].x - line[k - 1].x, dy = line[k].y - line[k - 1].y;
      const double u = std::clamp(
          ((p.x - line[k - 1].x) * dx + (p.y - line[k - 1].y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
      nearest = std::min(nearest, std::hypot(p.x - line[k - 1].x - u * dx, p.y - line[k - 1].y - u * dy));
    }
    worst = std::max(worst, nearest);
  }
  CHECK(worst < 0.005);
}

TEST_CASE("lines to points far off the page stay straight on it, and end beside it") {
  // The page is 200 x 100 points; its surroundings reach from -200 to 400 and from -100 to 200.
  const Box around{-200, -100, 400, 200};
  for (const std::string far : {"1000", "100000", "1000000000", "3000000000", "100000000000000000000"}) {
    CAPTURE(far);
    const std::string half = "5" + far.substr(2);
    // A slanted line, a closed wedge, a rectangle, a curve, and a line that passes the page.
    const auto opened = open(onePage("1 w 0 0 m " + far + " " + half + " l S 10 10 m 50 50 l " + far +
                                     " 50 l h S 20 85 " + far + " 10 re f 0 0 m " + far + " 0 0 " + far +
                                     " 200 100 c S -" + far + " -50 m 300 " + far + " l S"),
                             "plot.pdf");
    for (const VectorPath& path : opened.page.paths)
      for (const auto& line : path.polylines)
        for (const Point& p : line) CHECK(around.grown(1e-6, 1e-6).contains(p));
    if (far.size() > 6) continue;  // MuPDF draws them elsewhere, so that their lines count as unseen
    REQUIRE(opened.page.paths.size() >= 3);
    const auto& slanted = opened.page.paths[0].polylines[0];
    REQUIRE(slanted.size() >= 2);
    CHECK(slanted[0].y == Approx(100));
    CHECK(slanted[1].x == Approx(400));
    CHECK(slanted[1].y == Approx(-100));
    const auto& wedge = opened.page.paths[1].polylines[0];
    REQUIRE(wedge.size() == 4);
    CHECK(opened.page.paths[1].closed[0]);
    CHECK(wedge[2].x == Approx(400));
    CHECK(wedge[2].y == Approx(50));
    CHECK(wedge[3].x == Approx(400));  // of the line back to the start
    CHECK(wedge[3].y == Approx(90 - 40 * 390 / (std::stod(far) - 10)));
    const auto& rectangle = opened.page.paths[2];
    CHECK(rectangle.polylines[0].size() <= 5);
    CHECK(rectangle.box.x1 == Approx(400));
    CHECK(rectangle.box.y0 == Approx(5));
  }
}

TEST_CASE("the line between two points off the page runs past its corner, not across it") {
  for (const std::string far : {"1000", "1000000000"}) {
    CAPTURE(far);
    const auto opened = open(onePage("0.9 g 5 5 m -" + far + " -50 l 300 " + far + " l h f"), "plot.pdf");
    REQUIRE(opened.page.paths.size() == 1);
    const auto& line = opened.page.paths[0].polylines[0];
    CHECK(std::ranges::find(line, Point{-200, -100}) != line.end());  // the upper left corner
  }
}

TEST_CASE("a line and a letter of any size have a box beside the page at most") {
  const Box around{-200, -100, 400, 200};
  for (const std::string size : {"150", "1000", "1000000000", "100000000000000000000"}) {
    CAPTURE(size);
    const auto thick = open(onePage(size + " w 50 50 m 90 50 l S"), "plot.pdf");
    for (const VectorPath& path : thick.page.paths) CHECK(path.strokeWidth <= around.width());
    const auto large = open(onePage("BT /F " + size + " Tf 30 30 Td (8) Tj ET"), "plot.pdf");
    for (const TextBox& text : large.page.texts) CHECK(around.contains(text.box));
    if (size == "150") CHECK(large.page.texts.size() == 1);
  }
}

TEST_CASE("forms are followed; what is clipped away is left out, what is cut says by what") {
  const auto opened =
      open(onePage("/X Do q 100 0 50 100 re W n 10 40 m 90 40 l S 120 60 m 190 60 l S Q"), "plot.pdf");
  REQUIRE(opened.page.paths.size() == 2);
  CHECK(*opened.page.paths[0].stroke == Rgb{0, 0, 255});
  REQUIRE(opened.page.paths[1].clip);
  CHECK(opened.page.paths[1].clip->x1 == Approx(150));
}

TEST_CASE("page rotation and crop box: everything is where the page shows it") {
  const auto opened = open(
      onePage("10 20 m 60 20 l S BT /F 10 Tf 20 50 Td (2.5 mm) Tj ET", "/Rotate 90/CropBox[0 10 200 100]"),
      "plot.pdf");
  CHECK(opened.page.width == Approx(90));
  CHECK(opened.page.height == Approx(200));
  const auto& line = opened.page.paths[0].polylines[0];
  CHECK(line[0].x == Approx(10));  // 20 - 10 above the crop box's floor becomes the distance from the left
  CHECK(line[0].y == Approx(10));
  CHECK(line[1].y == Approx(60));
  const TextBox* text = textNamed(opened.page.texts, "2.5 mm");
  REQUIRE(text);
  CHECK(text->angle_deg == Approx(-90));
  // Turned three quarters clockwise it reads upright again.
  const auto view = opened.document.view(opened.page, {0, 0, 90, 200}, 3);
  REQUIRE(view.ok());
  REQUIRE(textNamed(view->texts, "2.5 mm"));
  CHECK(textNamed(view->texts, "2.5 mm")->angle_deg == Approx(0).margin(1e-6));
}

TEST_CASE("labels on one baseline are boxes of their own") {
  const auto opened =
      open(onePage("BT /F 8 Tf 10 10 Td (0.5) Tj 40 0 Td (1.0) Tj 40 0 Td (Travel [mm]) Tj ET"), "plot.pdf");
  REQUIRE(opened.page.texts.size() == 3);
  CHECK(textNamed(opened.page.texts, "1.0"));
  CHECK(textNamed(opened.page.texts, "1.0")->box.contains(Point{53, 87}));
  CHECK(textNamed(opened.page.texts, "Travel [mm]"));
}

TEST_CASE("letters whose font the page does not bring are read and drawn, in every script") {
  const auto darkPixels = [](const Raster& raster) {
    int dark = 0;
    for (std::size_t i = 0; i < raster.rgb.size(); i += 3) dark += raster.rgb[i] < 128;
    return dark;
  };
  for (const std::string words : {"行程", "하중", "ストローク", "сила", "δύναμη", "כוח", "قوة", "แรง", "∑"}) {
    INFO(words);
    const auto opened = open(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"200\" height=\"100\"><text x=\"20\" y=\"60\" "
        "font-size=\"30\">" +
            words + "</text></svg>",
        "words.svg");
    CHECK(opened.page.texts.size() >= 1);
    CHECK(darkPixels(opened.page.overview) > 100);
  }
  // No font for cuneiform or music is linked: a box replaces the sign, and a remark names it.
  const auto rare = open(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"200\" height=\"100\"><text x=\"20\" "
      "y=\"60\">\xf0\x92\x80\x80</text></svg>",
      "rare.svg");
  CHECK(textNamed(rare.page.texts, "\xef\xbf\xbd"));
  REQUIRE(rare.page.remarks.size() == 1);
  CHECK(english(messageOf(rare.page.remarks[0])).find("\xf0\x92\x80\x80") != std::string::npos);

  const std::string song =
      "<</Type/Font/Subtype/Type0/BaseFont/STSong-Light/Encoding/UniGB-UCS2-H/DescendantFonts[7 0 R]>>";
  const auto sheet = open(
      pdfOf(
          {"<</Type/Catalog/Pages 2 0 R>>", "<</Type/Pages/Kids[3 0 R]/Count 1>>",
           "<</Type/Page/Parent 2 0 R/MediaBox[0 0 200 100]/Contents 4 0 R/Resources<</Font<</F 5 0 R>>>>>>",
           streamObject("", "BT /F 30 Tf 20 40 Td <884C7A0B> Tj ET"), song, "<<>>",
           "<</Type/Font/Subtype/CIDFontType0/BaseFont/STSong-Light/CIDSystemInfo<</Registry(Adobe)/"
           "Ordering(GB1)/Supplement "
           "4>>/FontDescriptor 8 0 R>>",
           "<</Type/FontDescriptor/FontName/STSong-Light/Flags 6/FontBBox[-25 -254 1000 880]/ItalicAngle "
           "0/Ascent 880/Descent "
           "-120/CapHeight 880/StemV 93>>"}),
      "sheet.pdf");
  CHECK(textNamed(sheet.page.texts, "行程"));
  CHECK(darkPixels(sheet.page.overview) > 100);
}

TEST_CASE("a region filled by an image is shown on the image's own pixels, whichever way it lies") {
  struct Case {
    std::string matrix;
    int width, height;
    std::vector<int> grey;  // as shown
  };
  const std::vector<Case> cases = {
      {"4 0 0 2 50 40", 4, 2, {0x10, 0x20, 0x30, 0x40, 0x50, 0x60, 0x70, 0x80}},
      {"-4 0 0 2 54 40", 4, 2, {0x40, 0x30, 0x20, 0x10, 0x80, 0x70, 0x60, 0x50}},
      {"0 4 -2 0 52 40", 2, 4, {0x40, 0x80, 0x30, 0x70, 0x20, 0x60, 0x10, 0x50}},
      {"0 -4 2 0 50 44", 2, 4, {0x50, 0x10, 0x60, 0x20, 0x70, 0x30, 0x80, 0x40}},
  };
  for (const Case& c : cases) {
    INFO(c.matrix);
    const auto opened = open(onePage("q " + c.matrix + " cm /I Do Q"), "scan.pdf");
    REQUIRE(opened.page.images.size() == 1);
    const PlacedImage& image = opened.page.images[0];
    CHECK(image.width_px == 4);
    const auto view = opened.document.view(opened.page, image.box);
    REQUIRE(view.ok());
    CHECK(view->nativePixels);
    REQUIRE(view->raster.width_px == c.width);
    REQUIRE(view->raster.height_px == c.height);
    for (std::size_t i = 0; i < c.grey.size(); ++i) CHECK(int{view->raster.rgb[3 * i]} == c.grey[i]);
    const Point first = view->viewToPage({-0.5, -0.5});
    CHECK(first.x == Approx(image.box.x0));
    CHECK(first.y == Approx(image.box.y0));
  }
}

TEST_CASE("a drawing over a background image is rendered finely") {
  std::string content = "q 200 0 0 100 0 0 cm /I Do Q ";
  for (int i = 0; i < 20; ++i) content += std::to_string(10 * i) + " 0 m 100 90 l S ";
  const auto opened = open(onePage(content), "plot.pdf");
  const auto view = opened.document.view(opened.page, {0, 0, 200, 100});
  REQUIRE(view.ok());
  CHECK_FALSE(view->nativePixels);
  CHECK(view->raster.width_px == 1000);
}

TEST_CASE("a view's paths lie on its pixels") {
  const auto opened = open(onePage("1 0 0 RG 2 w 20 50 m 180 50 l S"), "plot.pdf");
  for (int turns = 0; turns < 4; ++turns) {
    const auto view = opened.document.view(opened.page, {10, 10, 190, 90}, turns);
    REQUIRE(view.ok());
    REQUIRE(view->paths.size() == 1);
    const auto& line = view->paths[0].polylines[0];
    const int x = static_cast<int>(std::lround((line[0].x + line[1].x) / 2));
    const int y = static_cast<int>(std::lround((line[0].y + line[1].y) / 2));
    const std::uint8_t* p = view->raster.at(x, y);
    CHECK(p[0] == 255);
    CHECK(p[1] == 0);
  }
}

TEST_CASE("hostile and broken documents are refused") {
  const std::string good = onePage("10 20 m 60 90 l S");
  SECTION("truncated") {
    const Failure failure = documentRefusal(good.substr(0, good.size() / 2), "cut.pdf");
    CHECK(failure.code == FailureCode::unreadableInput);
    CHECK(english(failure.problem).find("truncated") != std::string::npos);
  }
  SECTION("ten thousand pages") {
    std::string kids;
    for (int i = 0; i < 10000; ++i) kids += "3 0 R ";
    const std::string many =
        pdfOf({"<</Type/Catalog/Pages 2 0 R>>", "<</Type/Pages/Kids[" + kids + "]/Count 10000>>",
               "<</Type/Page/Parent 2 0 R/MediaBox[0 0 9 9]>>"});
    CHECK(english(documentRefusal(many, "many.pdf").problem).find("10000 pages") != std::string::npos);
  }
  SECTION("an image that claims more pixels than allowed") {
    const std::string content = "q 9 0 0 9 0 0 cm /I Do Q";
    std::string huge = onePage(content);
    huge.replace(huge.find("/Width 4/Height 2"), 17, "/Width 60000/Height 60000");
    const Failure failure = documentRefusal(huge, "huge.pdf");
    INFO(failure.sentence());
    CHECK(english(failure.problem).find("60000 x 60000") != std::string::npos);
  }
  SECTION("more points than allowed") {
    PageLimits limits;
    limits.maxPathPoints = 50;
    std::string content = "0 0 m ";
    for (int i = 0; i < 100; ++i) content += std::to_string(i) + " 5 l ";
    CHECK(english(documentRefusal(onePage(content + "S"), "long.pdf", limits).problem)
              .find("the limit is 50") != std::string::npos);
  }
  SECTION("an SVG whose references multiply") {
    std::string svg =
        "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' width='9' "
        "height='9'><g id='a0'><path d='M0 0L9 9' stroke='red'/></g>";
    for (int i = 1; i < 12; ++i) {
      svg += "<g id='a" + std::to_string(i) + "'>";
      for (int k = 0; k < 8; ++k) svg += "<use xlink:href='#a" + std::to_string(i - 1) + "'/>";
      svg += "</g>";
    }
    PageLimits limits;
    limits.maxPageSeconds = 4;  // the drawing program gets a quarter of this
    CHECK(english(documentRefusal(svg + "</svg>", "bomb.svg", limits).problem) ==
          "the drawing takes too long to draw");
  }
  SECTION("an SVG nested too deep") {
    std::string svg = "<svg xmlns='http://www.w3.org/2000/svg'>";
    for (int i = 0; i < 100000; ++i) svg += "<g>";
    CHECK(english(documentRefusal(svg, "deep.svg").problem).find("256 deep") != std::string::npos);
  }
  SECTION("an SVG without a size, with another root, and one that is no XML") {
    for (const auto& [svg, words] :
         {std::pair("<svg xmlns='http://www.w3.org/2000/svg' width='0'/>", "no usable size"),
          std::pair("<html><svg/></html>", "its root is <html>"),
          std::pair("<svg><g></svg>", "the SVG cannot be drawn: ")}) {
      INFO(svg);
      CHECK(english(documentRefusal(svg, "odd.svg").problem).find(words) != std::string::npos);
    }
  }
}

namespace {

/// The one line that an element of an SVG draws.
std::vector<Point> lineOf(const std::string& element, const std::string& attributes) {
  const auto opened = open("<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100'><" + element +
                               " fill='none' stroke='#f00' " + attributes + "/></svg>",
                           "line.svg");
  REQUIRE(opened.page.paths.size() == 1);
  std::vector<Point> line = opened.page.paths[0].polylines.at(0);
  REQUIRE(line.size() == 2);
  return line;
}

}  // namespace

TEST_CASE("a list of points in an SVG ends at its first error") {
  // MuPDF does not return from the text behind "30,40".
  for (const std::string rest : {"", " x", " -,+ .", " %,2", " &#97; 5,6", " nan,1"}) {
    INFO(rest);
    const std::vector<Point> line = lineOf("polyline", "points='1e1,+20 30,40" + rest + "'");
    CHECK(line[0].x == Approx(10));
    CHECK(line[1].y == Approx(40));
  }
}

TEST_CASE("signs and character references in an SVG's numbers are read") {
  // MuPDF never went past a plus sign in a path, however it was written.
  const std::string data =
      GENERATE("d='M+10+20L30&#10;4&#x30;'", "d='M1e+1 20 30&#9;+40++5 60'",
               "d='M10,&#43;20 30,40&#43;&#43;'", "d='M7+15 27 35' transform='translate(+3,&#43;5)'");
  INFO(data);
  const std::vector<Point> line = lineOf("path", data);
  CHECK(line[0].x == Approx(10));
  CHECK(line[0].y == Approx(20));
  CHECK(line[1].x == Approx(30));
  CHECK(line[1].y == Approx(40));
}

TEST_CASE("one image that cannot be decoded costs that image only") {
  // Drawn by the page itself and through a form; a curve before and one after each.
  const std::string broken =
      streamObject("/Type/XObject/Subtype/Image/Width 4/Height 2/Filter/JPXDecode", "these are no wavelets");
  const std::string form = "/Type/XObject/Subtype/Form/BBox[0 0 200 100]/Resources<</XObject<</I 5 0 R>>>>";
  const auto page = [&](const std::string& image) {
    return pdfOf({"<</Type/Catalog/Pages 2 0 R>>", "<</Type/Pages/Kids[3 0 R]/Count 1>>",
                  "<</Type/Page/Parent 2 0 R/MediaBox[0 0 200 100]/Contents 4 0 R"
                  "/Resources<</XObject<</I 5 0 R/X 6 0 R>>>>>>",
                  streamObject("", "10 20 m 60 90 l S q 50 0 0 50 0 0 cm /I Do Q /X Do 10 20 m 90 20 l S"),
                  image, streamObject(form, "q 50 0 0 50 9 9 cm /I Do Q 10 30 m 90 30 l S")});
  };
  const auto opened = open(page(broken), "plot.pdf");
  CHECK(opened.page.paths.size() == 3);
  REQUIRE(opened.page.remarks.size() == 1);
  CHECK(opened.page.remarks[0].code == RemarkCode::imagesUndecoded);
  CHECK(opened.page.remarks[0].values.at(1).number == 1);
  CHECK(opened.document.view(opened.page, {0, 0, 200, 100}).ok());

  const auto whole = open(page(streamObject("/Type/XObject/Subtype/Image/Width 4/Height 2"
                                            "/ColorSpace/DeviceGray/BitsPerComponent 8",
                                            "12345678")),
                          "plot.pdf");
  CHECK(whole.page.paths.size() == 3);
  CHECK(whole.page.images.size() == 2);
  CHECK(whole.page.remarks.empty());
}

TEST_CASE("cancelling ends the reading of a page") {
  std::string content;
  for (int i = 0; i < 2000; ++i) content += "0 0 m 9 9 l S ";
  const auto document = Document::fromBytes(bytesOf(onePage(content)), "plot.pdf");
  REQUIRE(document.ok());
  Progress progress;
  progress.cancelled = [] { return true; };
  const auto page = document->page(1, progress);
  REQUIRE_FALSE(page.ok());
  CHECK(page.failure().code == FailureCode::cancelled);
}

TEST_CASE("SVG: classes, inherited anchors, references, clips") {
  const std::string svg = R"(<?xml version="1.0"?>
<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" width="200" height="100" viewBox="0 0 200 100">
<style><![CDATA[ /* plot */ .curve, path.other { fill: none; stroke: #d00000; stroke-width: 2 } ]]></style>
<defs><path id="tick" d="M0 0V5" stroke="blue"/></defs>
<path class="thin curve" d="M10 90 L60 20 L150 40"/>
<use xlink:href="#tick" x="30" y="80"/>
<g text-anchor="end" font-size="10"><text x="100" y="50"><tspan> 1.5</tspan></text></g></svg>)";
  const auto opened = open(svg, "plot.svg");
  CHECK(opened.page.width == 200);
  REQUIRE(opened.page.paths.size() == 2);
  CHECK(*opened.page.paths[0].stroke == Rgb{208, 0, 0});
  CHECK_FALSE(opened.page.paths[0].fill);
  CHECK(opened.page.paths[0].strokeWidth == Approx(2));
  CHECK(opened.page.paths[1].polylines[0][0].x == Approx(30));
  REQUIRE(textNamed(opened.page.texts, "1.5"));
  CHECK(textNamed(opened.page.texts, "1.5")->box.x1 == Approx(100).margin(0.2));
}

TEST_CASE("SVG: letters that are set twice, a little aside, are one text") {
  std::string svg = R"(<svg xmlns="http://www.w3.org/2000/svg" width="200" height="100" font-size="13">)";
  for (const char* x : {"18.8", "21.2", "20.0", "20.6"})  // a halo, and bold made by hand
    svg += std::string("<text x='") + x + "' y='50'>1</text><text x='" + x + "' y='80'>11 mm</text>";
  const auto opened = open(svg + "</svg>", "plot.svg");
  REQUIRE(opened.page.texts.size() == 2);
  CHECK(textNamed(opened.page.texts, "1"));
  CHECK(textNamed(opened.page.texts, "11 mm"));
}

namespace {

/// A drawing of 200 x 100 pixels with one path, #p, which must come out as a line from (10, 20) to (30, 40).
struct SvgFeature {
  const char* what;
  const char* body;
  Rgb stroke{255, 0, 0};
  double width = 2;
};

}  // namespace

TEST_CASE("SVG is drawn as browsers draw it") {
  const SvgFeature feature = GENERATE(values<SvgFeature>({
      {"rules by type", "<style>path{stroke:red;stroke-width:2}</style><path id='p' d='M10 20L30 40'/>"},
      {"ids over classes over types, own style over all",
       "<style>#p{stroke:lime} .c{stroke:blue} path{stroke:black;stroke-width:2}</style>"
       "<path id='p' class='c' style='stroke:red' d='M10 20L30 40'/>"},
      {"outer parts of selectors",
       "<style>path{stroke:red;stroke-width:2} .axis path{stroke:grey} .axis > path{stroke:blue}</style>"
       "<g class='plot'><path id='p' d='M10 20L30 40'/></g>"},
      {"an import first, comments, print after screen",
       "<style>@import url('a.css'); /* } */ @media screen{path{stroke:red;stroke-width:2}}"
       "@media print{path{stroke:lime}} @media (prefers-color-scheme: dark){path{stroke:white}}</style>"
       "<path id='p' d='M10 20L30 40'/>"},
      {"variables",
       "<style>:root{--ink:red;--w:2px} @media (prefers-color-scheme:dark){:root{--ink:white}}</style>"
       "<path id='p' style='stroke:var(--none, var(--ink));stroke-width:var(--w)' d='M10 20L30 40'/>"},
      {"colours for light screens",
       "<path style='stroke:light-dark(rgb(255,0,0), white);stroke-width:2' d='M10 20L30 40'/>"},
      {"a link",
       "<a href='http://example.org/?a=(1)&amp;b'><path stroke='red' stroke-width='2' d='M10 20L30 "
       "40'/></a>"},
      {"nested rules, lists of selectors, layers, supported features",
       "<style>@layer late, early;@layer early{path{stroke:lime}}@layer late{path{stroke:blue}}"
       ".plot{&amp; :is(path, line):where(.c){stroke:red} path{stroke-width:2}}"
       "@supports (stroke:red){.old:hover{display:inline} .old{display:none}}</style>"
       "<g class='plot'><path class='c' d='M10 20L30 40'/><path class='old c' d='M1 1L9 9'/></g>"},
      {"a colour by lightness, chroma and hue",
       "<path style='stroke:oklch(62.796% .25768 29.2339deg);stroke-width:2' d='M10 20L30 40'/>"},
      {"what no element can show",
       "<style>@keyframes in{from{opacity:0}} .absent{animation:in 1s} "
       ".absent:has(path){display:none}</style>"
       "<path stroke='red' stroke-width='2' style='rotate:none;filter:none' d='M10 20L30 40'/>"},
      {"a switch",
       "<switch><foreignObject requiredFeatures='x'/><g><path stroke='red' stroke-width='2' d='M10 20L30 "
       "40'/></g></switch>"},
      {"transform in CSS",
       "<path style='transform:translate(4px,5px);stroke:red;stroke-width:2' d='M6 15L26 35'/>"},
      {"transform about an origin",
       "<path transform='rotate(180)' transform-origin='20 30' stroke='red' stroke-width='2' d='M10 20L30 "
       "40'/>"},
      {"an inner viewport",
       "<svg x='8' y='9' width='99' height='80'><path stroke='red' stroke-width='2' d='M2 11L22 31'/></svg>"},
      {"a symbol",
       "<symbol id='s' viewBox='0 0 10 10'><path stroke='red' d='M0 0L10 10'/></symbol>"
       "<use href='#s' x='10' y='20' width='20' height='20'/>"},
      {"hidden lines beside it",
       "<g style='display:none'><path stroke='red' d='M1 1L9 9'/></g><path visibility='hidden' stroke='red' "
       "d='M1 1L9 9'/>"
       "<g opacity='0'><path stroke='red' d='M1 1L9 9'/></g><path stroke='red' d='M-90 1L-9 9'/>"
       "<path stroke='red' stroke-width='2' d='M10 20L30 40'/>"},
      {"lines that have the colour of what they are drawn on",
       "<rect width='200' height='100' fill='#eee'/><path stroke='#eee' d='M60 60L90 90'/>"
       "<path style='mix-blend-mode:lighten' stroke='#080' d='M40 10L90 30'/>"
       "<path stroke='red' stroke-width='2' d='M10 20L30 40'/>"},
      {"a line under a white box",
       "<path stroke='red' d='M60 60L90 90'/><rect x='50' y='50' width='50' height='45' fill='white' "
       "id='box'/>"
       "<path stroke='red' stroke-width='2' d='M10 20L30 40'/>"},
      {"the same line twice, a little aside",
       "<path stroke='red' stroke-width='2' d='M10 20L30 40'/><path stroke='red' stroke-width='2' d='M10.4 "
       "20L30.4 40'/>"},
      {"a width that is not scaled",
       "<path transform='scale(2,4)' vector-effect='non-scaling-stroke' stroke='red' stroke-width='2' d='M5 "
       "5L15 10'/>"},
      {"a shadow",
       "<filter id='f'><feGaussianBlur stdDeviation='2'/></filter><g style='filter:url(#f)'>"
       "<path filter='url(#f)' stroke='red' stroke-width='2' d='M10 20L30 40'/></g>"},
      {"a default of the document type", "<path class='c' d='M10 20L30 40'/>"},
  }));
  INFO(feature.what);
  const std::string type = "<!DOCTYPE svg [<!ATTLIST path stroke CDATA 'red' stroke-width CDATA '2'>]>";
  const bool byType = std::string_view(feature.what).find("document type") != std::string_view::npos;
  const auto opened =
      open((byType ? type : std::string()) +
               "<svg xmlns='http://www.w3.org/2000/svg' width='200' height='100'><g fill='none'>" +
               feature.body + "</g></svg>",
           "plot.svg");
  CHECK(opened.page.width == Approx(200));
  std::vector<VectorPath> lines;
  for (const VectorPath& path : opened.page.paths)
    if (path.stroke) lines.push_back(path);
  REQUIRE(lines.size() == 1);
  CHECK(*lines[0].stroke == feature.stroke);
  CHECK(lines[0].strokeWidth == Approx(feature.width).margin(0.01));
  std::vector<Point> line = lines[0].polylines.at(0);
  REQUIRE(line.size() == 2);
  if (line[0].x > line[1].x) std::swap(line[0], line[1]);
  CHECK(line[0].x == Approx(10).margin(0.005));
  CHECK(line[0].y == Approx(20).margin(0.005));
  CHECK(line[1].x == Approx(30).margin(0.005));
  CHECK(line[1].y == Approx(40).margin(0.005));
}

TEST_CASE("an SVG that only a browser draws rightly is refused and says what it uses") {
  struct Undrawn {
    const char *body, *what;
  };
  const Undrawn drawing = GENERATE(values<Undrawn>({
      {"<path class='p' style='translate:60px 4px' d='M10 20L30 40'/>", "it uses translate,"},
      {"<path class='p' style='rotate:180deg' d='M10 20L30 40'/>", "it uses rotate,"},
      {"<path class='p' style='transform:translate3d(0,-40px,0)' d='M10 20L30 40'/>",
       "it uses transform: translate3d(),"},
      {"<path class='p' style='transform:translate(10%,0)' d='M10 20L30 40'/>", "it uses transform: %,"},
      {"<path class='p' style='transform:rotate(.5turn)' d='M10 20L30 40'/>", "it uses transform: turn,"},
      {"<path class='p' style='clip-path:inset(50%)' d='M10 20L30 40'/>", "it uses clip-path,"},
      {"<path class='p' style='mask-image:linear-gradient(#000,#0000)' d='M10 20L30 40'/>",
       "it uses mask-image,"},
      {"<path class='p' style='filter:opacity(0)' d='M10 20L30 40'/>", "it uses filter,"},
      {"<path class='p' style='opacity:calc(1 - 1)' d='M10 20L30 40'/>", "it uses opacity,"},
      {"<path class='p' style='stroke:color-mix(in srgb, red, blue)' d='M10 20L30 40'/>",
       "it uses stroke: color-mix(),"},
      {"<g class='p' style='content-visibility:hidden'><path d='M10 20L30 40'/></g>",
       "it uses content-visibility,"},
      {"<style>.p{d:path('M10 20L30 40')}</style><path class='p' stroke='red'/>", "it uses d,"},
      {"<style>g:has(.p){display:none}</style><g><path class='p' d='M10 20L30 40'/></g>", "it uses :has,"},
      {"<style>@keyframes in{from{opacity:0}} .p{animation:in 1s infinite}</style><path class='p' d='M10 "
       "20L30 40'/>",
       "it uses animation,"},
      {"<path class='p' pathLength='1' stroke-dasharray='1' stroke-dashoffset='1' d='M10 20L30 40'/>",
       "it uses pathLength,"},
      {"<path class='p' d='M10 20L30 40'><set attributeName='visibility' to='hidden'/></path>",
       "it uses <set>,"},
  }));
  INFO(drawing.body);
  const Failure failure =
      documentRefusal(std::string("<svg xmlns='http://www.w3.org/2000/svg' width='200' height='100'>") +
                          drawing.body + "</svg>",
                      "plot.svg");
  CHECK(failure.code == FailureCode::unreadableInput);
  CHECK(english(failure.problem).find(drawing.what) != std::string::npos);
}

TEST_CASE("the background of an SVG's root fills its page") {
  const auto opened =
      open("<svg xmlns='http://www.w3.org/2000/svg' viewBox='-9 -9 200 100' style='background:#204060'/>",
           "plot.svg");
  REQUIRE(opened.page.paths.size() == 1);
  CHECK(*opened.page.paths[0].fill == Rgb{32, 64, 96});
  CHECK(opened.page.paths[0].box.width() == Approx(200).margin(0.1));
}

TEST_CASE("the background of an SVG's root is a colour only if it states one") {
  const auto pageFill = [](const std::string& background) {
    const auto opened = open(
        "<svg xmlns='http://www.w3.org/2000/svg' width='200' height='100' style='background:" + background +
            "'><path fill='none' stroke='red' d='M1 2L30 40'/></svg>",
        "plot.svg");
    for (const auto& path : opened.page.paths)
      if (path.fill) return path.fill;
    return std::optional<Rgb>();
  };
  for (const char* const colourless :
       {"0 0", "none", "initial", "transparent", "linear-gradient(red, blue)"}) {
    INFO(colourless);
    CHECK_FALSE(pageFill(colourless).has_value());
  }
  for (const char* const coloured :
       {"#204060 no-repeat 0 0", "none,rgb(32, 64, 96)", "0 0/9px #204060 none"}) {
    INFO(coloured);
    CHECK(pageFill(coloured) == Rgb{32, 64, 96});
  }
}

TEST_CASE("text of an SVG stands on the baseline that it names") {
  const auto top = [](const std::string& attributes) {
    const auto opened = open("<svg xmlns='http://www.w3.org/2000/svg' width='200' height='100'><g " +
                                 attributes + "><text x='20' y='50' font-size='10'>1.5</text></g></svg>",
                             "plot.svg");
    REQUIRE(textNamed(opened.page.texts, "1.5"));
    return textNamed(opened.page.texts, "1.5")->box.y0;
  };
  const double usual = top("");
  CHECK(top("dominant-baseline='central'") - usual == Approx(3.5).margin(0.1));
  CHECK(top("style='dominant-baseline:hanging'") - usual == Approx(7.3).margin(0.1));
}

TEST_CASE("an SVG's page is as large as it says, however it says it") {
  for (const auto& [head, width] :
       {std::pair("width='200' height='100'", 200.0), std::pair("viewBox='0 0 300 100'", 300.0),
        std::pair("width='100%' height='100%' viewBox='0 0 300 100'", 300.0),
        std::pair("width='1in' height='1in'", 96.0)}) {
    INFO(head);
    const auto opened = open("<svg xmlns='http://www.w3.org/2000/svg' " + std::string(head) +
                                 "><path stroke='red' d='M1 2L30 40'/></svg>",
                             "plot.svg");
    CHECK(opened.page.width == Approx(width).margin(0.01));
  }
}

TEST_CASE("clips of an SVG bound its lines, also those of several shapes") {
  const auto opened = open(R"svg(<svg xmlns="http://www.w3.org/2000/svg" width="200" height="100">
<clipPath id="axes"><rect x="10" y="20" width="40" height="50"/><rect x="50" y="20" width="60" height="50"/></clipPath>
<path d="M 0 30 L 150 30" clip-path="url(#axes)" style="fill: none; stroke: #ff0000"/></svg>)svg",
                           "plot.svg");
  REQUIRE(opened.page.paths.size() == 1);
  REQUIRE(opened.page.paths[0].clip);
  CHECK(opened.page.paths[0].clip->x0 == Approx(10).margin(0.01));
  CHECK(opened.page.paths[0].clip->x1 == Approx(110).margin(0.01));
}

TEST_CASE("what an SVG refers to outside of itself is not read, and that is said") {
  const std::string head =
      "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' width='200' "
      "height='100'>";
  const std::string line = "<path stroke='red' d='M10 20L30 40'/>";
  for (const std::string part : {"<image xlink:href='file:///etc/passwd' width='9' height='9'/>",
                                 "<image href='x.png' width='9' height='9'/>", "<use href='other.svg#a'/>",
                                 "<style>@import url(a.css);</style>",
                                 "<foreignObject width='9' height='9'><p "
                                 "xmlns='http://www.w3.org/1999/xhtml'>2</p></foreignObject>"}) {
    INFO(part);
    const auto opened = open(head + part + line + "</svg>", "plot.svg");
    CHECK(opened.page.paths.size() == 1);
    REQUIRE(opened.page.remarks.size() == 1);
    CHECK(english(messageOf(opened.page.remarks[0])).find("1 parts are not drawn") != std::string::npos);
  }
  const auto entity = open("<!DOCTYPE svg [<!ENTITY x SYSTEM 'file:///etc/hostname'>]>" + head +
                               "<text x='9' y='50'>a&x;b</text>" + line + "</svg>",
                           "plot.svg");
  CHECK(textNamed(entity.page.texts, "ab"));
  CHECK(open(head + "<script>while(true);</script>" + line + "</svg>", "plot.svg").page.remarks.empty());
}

TEST_CASE("drawing an SVG ends when it is cancelled, and leaves no process") {
  std::string svg =
      "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'><g id='a0'><path d='M0 0L9 9'/></g>";
  for (int i = 1; i < 12; ++i) {
    svg += "<g id='a" + std::to_string(i) + "'>";
    for (int k = 0; k < 8; ++k) svg += "<use href='#a" + std::to_string(i - 1) + "'/>";
    svg += "</g>";
  }
  const auto document = Document::fromBytes(bytesOf(svg + "</svg>"), "bomb.svg");
  REQUIRE(document.ok());
  int polls = 0;
  Progress progress;
  progress.cancelled = [&] { return ++polls > 2; };
  const auto page = document->page(1, progress);
  REQUIRE_FALSE(page.ok());
  CHECK(page.failure().code == FailureCode::cancelled);
  CHECK(polls == 3);
  CHECK(waitpid(-1, nullptr, WNOHANG) == -1);  // no child is left, running or dead
}

TEST_CASE("a letter counts once, and only where it is seen") {
  struct Case {
    const char* what;
    const char* content;
    std::vector<std::string> words;
  };
  const Case each = GENERATE(values<Case>({
      {"plain", "BT /F 10 Tf 20 50 Td (11.0) Tj ET", {"11.0"}},
      {"made bold by hand",
       "BT /F 10 Tf 20 50 Td (11.0) Tj ET BT /F 10 Tf 20.4 50 Td (11.0) Tj ET",
       {"11.0"}},
      {"one letter made bold by hand",
       "BT /F 10 Tf 20 50 Td (1) Tj ET BT /F 10 Tf 20.4 50 Td (1) Tj ET",
       {"1"}},
      {"with a shadow",
       "BT 0.7 g /F 10 Tf 21 49 Td (2.5) Tj ET BT 0 g /F 10 Tf 20 50 Td (2.5) Tj ET",
       {"2.5"}},
      {"with a halo", "BT 1 g /F 10 Tf 20.5 50 Td (2.5) Tj ET BT 0 g /F 10 Tf 20 50 Td (2.5) Tj ET", {"2.5"}},
      {"two zeros at a corner", "BT /F 10 Tf 20 50 Td (0) Tj ET BT /F 10 Tf 28 42 Td (0) Tj ET", {"0", "0"}},
      {"an invisible copy",
       "BT /F 10 Tf 20 50 Td (3.0) Tj ET BT 3 Tr /F 10 Tf 22 50 Td (4.0) Tj ET",
       {"3.0"}},
      {"white on white",
       "BT 1 g /F 10 Tf 20 50 Td (4.0) Tj ET BT 0 g /F 10 Tf 20 50 Td (3.0) Tj ET",
       {"3.0"}},
      {"white on black", "0 g 10 40 60 30 re f BT 1 g /F 10 Tf 20 50 Td (4.0) Tj ET", {"4.0"}},
      {"white on an area of some form",
       "0 g 10 40 m 60 40 l 70 80 l f BT 1 g /F 10 Tf 40 50 Td (4) Tj ET",
       {"4"}},
      {"under a white box",
       "BT /F 10 Tf 20 50 Td (4.0) Tj ET 1 g 10 40 60 30 re f BT 0 g /F 10 Tf 20 50 Td (3.0) Tj ET",
       {"3.0"}},
      {"under a box that cuts it", "BT /F 10 Tf 20 50 Td (4.0) Tj ET 1 g 10 57 60 30 re f", {"4.0"}},
      {"clipped away",
       "q 0 0 10 10 re W n BT /F 10 Tf 20 50 Td (4.0) Tj ET Q BT /F 10 Tf 20 20 Td (3.0) Tj ET",
       {"3.0"}},
  }));
  INFO(each.what);
  const auto opened = open(onePage(each.content), "plot.pdf");
  std::vector<std::string> words;
  for (const TextBox& text : opened.page.texts) words.push_back(text.utf8);
  CHECK(words == each.words);
}

TEST_CASE("text set invisibly counts on a picture that shows something there") {
  const std::string picture = "q 100 0 0 50 0 0 cm /I Do Q ";
  const std::string shown = picture + "BT 3 Tr /F 10 Tf 20 20 Td (1.5) Tj ET";
  CHECK(textNamed(open(onePage(shown), "scan.pdf").page.texts, "1.5"));
  const std::string beside = picture + "BT 3 Tr /F 10 Tf 120 70 Td (1.5) Tj ET";
  CHECK(open(onePage(beside), "scan.pdf").page.texts.empty());
  const std::string under = "BT /F 10 Tf 20 20 Td (1.5) Tj ET " + picture;
  CHECK(textNamed(open(onePage(under), "scan.pdf").page.texts, "1.5"));
  const std::string twice = shown + " BT 0 Tr /F 10 Tf 20.5 20 Td (1.5) Tj ET";
  CHECK(open(onePage(twice), "scan.pdf").page.texts.size() == 1);
}

namespace {

/// Thousands of objects that take long to draw and next to nothing to interpret.
std::string slowToDraw() {
  std::string content = "0.5 w ";
  for (int i = 0; i < 300000; ++i)
    content += std::to_string(i % 200) + " 0 m 200 " + std::to_string(i % 100) + " l 0 100 l 190 3 l f ";
  return onePage(content);
}

/// A pattern over the whole page whose cells stand `stepX` and `stepY` points apart.
std::string tiled(const std::string& stepX, const std::string& stepY) {
  return pdfOf(
      {"<</Type/Catalog/Pages 2 0 R>>", "<</Type/Pages/Kids[3 0 R]/Count 1>>",
       "<</Type/Page/Parent 2 0 R/MediaBox[0 0 200 100]/Contents 4 0 R/Resources<</Pattern<</P 5 0 R>>>>>>",
       streamObject("", "/Pattern cs /P scn 0 0 200 100 re f"),
       streamObject("/Type/Pattern/PatternType 1/PaintType 1/TilingType 1/BBox[0 0 10 10]/XStep " + stepX +
                        "/YStep " + stepY + "/Resources<<>>",
                    "1 0 0 rg 0 0 5 5 re f")});
}

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Of this process: other work on the machine does not count.
double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace

TEST_CASE("drawing a page ends when it is cancelled, within half a second") {
  using Clock = std::chrono::steady_clock;
  const auto document = Document::fromBytes(bytesOf(slowToDraw()), "plot.pdf");
  REQUIRE(document.ok());
  const auto start = Clock::now();
  std::optional<Clock::time_point> stopped;
  Progress progress;
  progress.cancelled =
      [&] {  // cancels after 2 s, when the page is being drawn, because interpreting takes less
        if (secondsSince(start) < 2) return false;
        if (!stopped) stopped = Clock::now();
        return true;
      };
  const auto page = document->page(1, progress);
  REQUIRE(stopped);
  CHECK(secondsSince(*stopped) < 0.5);
  REQUIRE_FALSE(page.ok());
  CHECK(page.failure().code == FailureCode::cancelled);
}

TEST_CASE("the limit on a page's time covers what is drawn") {
  PageLimits limits;
  limits.maxPageSeconds = 1.5;
  const double before_s = processorSeconds();
  const Failure failure = documentRefusal(slowToDraw(), "plot.pdf", limits);
  CHECK(processorSeconds() - before_s < 10);
  CHECK(failure.code == FailureCode::unreadableInput);
  CHECK(failure.sentence().find("plot.pdf, page 1: the page takes too long to") == 0);
}

namespace {

Bytes gzipped(const std::string& text) {
  Bytes packed(compressBound(text.size()) + 64);
  z_stream stream{};
  REQUIRE(deflateInit2(&stream, 9, Z_DEFLATED, MAX_WBITS + 16, 8, Z_DEFAULT_STRATEGY) == Z_OK);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = packed.data();
  stream.avail_out = static_cast<uInt>(packed.size());
  REQUIRE(deflate(&stream, Z_FINISH) == Z_STREAM_END);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

}  // namespace

TEST_CASE("one object that goes up and down the page without end is refused before it is drawn") {
  std::string path = "M0 0";
  for (int i = 0; i < 40000; ++i) path += " L" + std::to_string(i % 800) + (i % 2 == 0 ? " 500" : " 0");
  const std::string head = R"svg(<svg xmlns="http://www.w3.org/2000/svg" width="800" height="500">)svg";
  for (const std::string paint : {"fill='none' stroke='black'", "fill='red'"}) {
    INFO(paint);
    const double before_s = processorSeconds();
    const Failure failure =
        documentRefusal(head + "<path " + paint + " d='" + path + "'/></svg>", "plot.svg");
    CHECK(failure.code == FailureCode::unreadableInput);
    CHECK(english(failure.problem) == "the page takes too long to draw");
    CHECK(processorSeconds() - before_s < 2);
  }
  // As long a way along the page costs little.
  std::string level = "M0 250";
  for (int i = 0; i < 40000; ++i) level += " L" + std::to_string(i % 2 == 0 ? 800 : 0) + " 250";
  CHECK(open(head + "<path fill='none' stroke='black' d='" + level + "'/></svg>", "plot.svg").page.count ==
        1);
}

TEST_CASE("an SVG that was cut off is truncated, wherever it ends") {
  const std::string whole =
      R"svg(<?xml version="1.0"?><svg:svg xmlns:svg="http://www.w3.org/2000/svg" width="80" height="50"><svg:g>)svg"
      R"svg(<svg:svg width="10"></svg:svg><svg:path d="M0 0 L 80 50" stroke="black"/></svg:g></svg:svg>)svg";
  CHECK(open(whole + "\n<!-- made by hand -->\n", "plot.svg").page.count == 1);
  CHECK(open("<svg width='80' height='50' xmlns='http://www.w3.org/2000/svg'/>", "plot.svg").page.count == 1);
  for (const char* const last :
       {"</svg:sv", "</svg:svg", "</svg:g>", "50\" stro", "</svg:svg><svg:path", "<svg:g"}) {
    INFO("ends at " << last);
    const std::size_t end = std::string_view(last) == "</svg:svg" ? whole.size() - 1 : whole.find(last);
    const Failure failure = documentRefusal(whole.substr(0, end), "plot.svg");
    CHECK(failure.code == FailureCode::unreadableInput);
    CHECK(english(failure.problem).find("truncated") != std::string::npos);
  }
}

TEST_CASE("a drawing packed with gzip is read, within the limit on a file's size") {
  const std::string svg = "<svg xmlns='http://www.w3.org/2000/svg' width='80' height='50'>" +
                          std::string(3 << 20, ' ') + "<path d='M0 0L80 50' stroke='black'/></svg>";
  const Bytes packed = gzipped(svg);
  const auto document = Document::fromBytes(packed, "plot.svgz");
  REQUIRE(document.ok());
  CHECK(document->page(1)->paths.size() == 1);
  PageLimits limits;
  limits.maxFileMegabytes = 1;
  const auto bomb = Document::fromBytes(packed, "plot.svgz", limits);
  REQUIRE_FALSE(bomb.ok());
  CHECK(bomb.failure().code == FailureCode::unreadableInput);
  const auto cut = Document::fromBytes(Bytes(packed.begin(), packed.end() - 9), "plot.svgz");
  REQUIRE_FALSE(cut.ok());
  CHECK(cut.failure().code == FailureCode::unreadableInput);
}

TEST_CASE("a pattern of more cells than any page has objects is refused before it is drawn") {
  const std::pair<const char*, const char*> steps[] = {
      {"0.000001", "0.000001"}, {"0.001", "0.001"}, {"0.05", "0.05"}, {"0", "2"}, {"2", "0"}};
  for (const auto& [stepX, stepY] : steps) {
    INFO("steps " << stepX << ", " << stepY);
    const double before_s = processorSeconds();
    CHECK(documentRefusal(tiled(stepX, stepY), "plot.pdf").code == FailureCode::unreadableInput);
    CHECK(processorSeconds() - before_s < 1);
  }
  CHECK(open(tiled("2", "2"), "plot.pdf").page.count == 1);
}
