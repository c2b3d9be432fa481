// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of every file format become upright opaque RGB. A file that is no picture is refused with a
// message that says what to do.

#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <catch2/catch.hpp>
#include <opencv2/imgcodecs.hpp>

#include "importer/page/document.h"
#include "importer/page/even_light.h"
#include "importer/page/picture_header.h"
#include "model/sha256.h"

using namespace detent;
using namespace detent::importer;

namespace {

using Bytes = std::vector<unsigned char>;

/// Every pixel differs from every other.
cv::Mat numberedPixels(int width, int height) {
  cv::Mat mat(height, width, CV_8UC3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      mat.at<cv::Vec3b>(y, x) =
          cv::Vec3b(static_cast<unsigned char>(10 * x), static_cast<unsigned char>(20 * y), 7);
  return mat;
}

Bytes encoded(const std::string& extension, const cv::Mat& mat) {
  Bytes bytes;
  REQUIRE(cv::imencode(extension, mat, bytes));
  return bytes;
}

Page firstPage(const Bytes& bytes, const std::string& name = "plot") {
  const auto document = Document::fromBytes(bytes, name);
  REQUIRE(document.ok());
  auto page = document->page(1);
  REQUIRE(page.ok());
  return std::move(page).value();
}

Rgb pixel(const Raster& raster, int x, int y) {
  const std::uint8_t* p = raster.at(x, y);
  return {p[0], p[1], p[2]};
}

Failure refusalOf(const Bytes& bytes, const std::string& name, const PageLimits& limits = {}) {
  const auto document = Document::fromBytes(bytes, name, limits);
  if (!document) return document.failure();
  const auto page = document->page(1);
  REQUIRE_FALSE(page.ok());
  return page.failure();
}

void putBigEndian(Bytes& bytes, std::uint32_t value, std::size_t size) {
  for (std::size_t i = size; i-- > 0;) bytes.push_back(static_cast<unsigned char>(value >> (8 * i) & 0xff));
}

/// A JPEG with an EXIF block that states this orientation and 300 dpi.
Bytes withExif(const Bytes& jpeg, std::uint32_t orientation) {
  Bytes tiff{'M', 'M', 0, 42, 0, 0, 0, 8};
  putBigEndian(tiff, 3, 2);
  const std::array<std::array<std::uint32_t, 4>, 3> entries = {
      {{0x112, 3, 1, orientation << 16}, {0x11a, 5, 1, 50}, {0x128, 3, 1, 2 << 16}}};
  for (const auto& entry : entries) {
    putBigEndian(tiff, entry[0], 2);
    putBigEndian(tiff, entry[1], 2);
    putBigEndian(tiff, entry[2], 4);
    putBigEndian(tiff, entry[3], 4);
  }
  putBigEndian(tiff, 0, 4);
  putBigEndian(tiff, 300, 4);
  putBigEndian(tiff, 1, 4);
  Bytes out(jpeg.begin(), jpeg.begin() + 2);
  out.insert(out.end(), {0xff, 0xe1});
  putBigEndian(out, static_cast<std::uint32_t>(tiff.size() + 8), 2);
  for (const char c : {'E', 'x', 'i', 'f', '\0', '\0'}) out.push_back(static_cast<unsigned char>(c));
  out.insert(out.end(), tiff.begin(), tiff.end());
  out.insert(out.end(), jpeg.begin() + 2, jpeg.end());
  return out;
}

std::uint32_t crc32(const Bytes& bytes, std::size_t from) {
  std::uint32_t crc = 0xffffffff;
  for (std::size_t i = from; i < bytes.size(); ++i) {
    crc ^= bytes[i];
    for (int k = 0; k < 8; ++k) crc = crc & 1 ? 0xedb88320 ^ crc >> 1 : crc >> 1;
  }
  return ~crc;
}

/// The same PNG with another size in its header (and a header checksum that fits).
Bytes claiming(Bytes png, std::uint32_t width, std::uint32_t height) {
  Bytes head(png.begin(), png.begin() + 16);
  putBigEndian(head, width, 4);
  putBigEndian(head, height, 4);
  head.insert(head.end(), png.begin() + 24, png.begin() + 29);
  putBigEndian(head, crc32(head, 12), 4);
  std::copy(head.begin(), head.end(), png.begin());
  return png;
}

void putLittleEndian(Bytes& to, std::uint32_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) to.push_back(static_cast<unsigned char>(value >> 8 * i));
}

/// A BMP all of one colour (30, 20, 10) in 32 bits, 24 where the header is OS/2's of 12 bytes.
Bytes bitmapOf(std::uint32_t width, std::uint32_t height, std::uint32_t head, std::uint32_t compression) {
  const std::uint32_t bits = head == 12 ? 24 : 32, pixels = width * height * bits / 8;
  Bytes out{'B', 'M'};
  putLittleEndian(out, 14 + head + pixels, 4);
  putLittleEndian(out, 0, 4);
  putLittleEndian(out, 14 + head, 4);
  putLittleEndian(out, head, 4);
  for (const std::uint32_t side : {width, height}) putLittleEndian(out, side, head == 12 ? 2 : 4);
  putLittleEndian(out, 1, 2);
  putLittleEndian(out, bits, 2);
  if (head > 12) putLittleEndian(out, compression, 4);
  for (std::uint32_t i = 0; head > 12 && i < 5; ++i) putLittleEndian(out, 0, 4);
  if (head >= 56)
    for (const std::uint32_t mask : {0xFF0000U, 0xFF00U, 0xFFU, 0xFF000000U}) putLittleEndian(out, mask, 4);
  for (std::uint32_t i = 0; i < width * height; ++i)
    putLittleEndian(out, 0xFF1E140A, static_cast<int>(bits) / 8);
  return out;
}

}  // namespace

TEST_CASE("lossless formats give their pixels, and a view is a crop of them") {
  const cv::Mat mat = numberedPixels(7, 5);
  for (const std::string extension : {".png", ".bmp", ".tiff"}) {
    INFO(extension);
    const Page page = firstPage(encoded(extension, mat));
    REQUIRE(page.overview.width_px == 7);
    REQUIRE(page.overview.height_px == 5);
    CHECK(page.unit == PageUnit::pixel);
    CHECK(page.overviewToPage == Affine{});
    for (int y = 0; y < 5; ++y)
      for (int x = 0; x < 7; ++x)
        CHECK(pixel(page.overview, x, y) ==
              Rgb{7, static_cast<std::uint8_t>(20 * y), static_cast<std::uint8_t>(10 * x)});
  }
}

TEST_CASE("a turned view shows the same pixels, and its map leads back to them") {
  const auto document = Document::fromBytes(encoded(".png", numberedPixels(9, 6)), "plot.png");
  REQUIRE(document.ok());
  const auto page = document->page(1);
  REQUIRE(page.ok());
  for (int turns = 0; turns < 4; ++turns) {
    INFO(turns);
    const auto view = document->view(*page, {2, 1, 6, 3}, turns);
    REQUIRE(view.ok());
    CHECK(view->nativePixels);
    CHECK(view->raster.width_px == (turns % 2 ? 3 : 5));
    CHECK(view->raster.height_px == (turns % 2 ? 5 : 3));
    for (int y = 0; y < view->raster.height_px; ++y)
      for (int x = 0; x < view->raster.width_px; ++x) {
        const Point p = view->viewToPage({static_cast<double>(x), static_cast<double>(y)});
        CHECK(pixel(view->raster, x, y) ==
              pixel(page->overview, static_cast<int>(p.x), static_cast<int>(p.y)));
      }
  }
  // One clockwise turn brings the region's bottom left pixel to the top left.
  CHECK(document->view(*page, {2, 1, 6, 3}, 1)->viewToPage({0, 0}) == Point{2, 3});
}

TEST_CASE("uneven light is divided away, marks keep their share of it, a dark background stays") {
  Raster shaded;
  shaded.width_px = 640, shaded.height_px = 480;
  const auto lightAt = [](int x) { return 1 - 0.5 * x / 640; };
  const bool dark = GENERATE(false, true);
  for (int y = 0; y < 480; ++y)
    for (int x = 0; x < 640; ++x) {
      const bool drawn = y % 60 == 30;
      const double value = dark ? (drawn ? 230 : 40) : (drawn ? 110 : 220);
      for (const double tint : {1.0, 0.96, 0.85})
        shaded.rgb.push_back(static_cast<std::uint8_t>(value * tint * (dark ? 1 : lightAt(x))));
    }
  const Raster even = evenlyLit(shaded);
  if (dark) {
    CHECK(even.rgb == shaded.rgb);
    return;
  }
  for (const int x : {5, 320, 630}) {
    INFO(x);
    const Rgb paper = pixel(even, x, 100), drawn = pixel(even, x, 150);
    for (const int channel : {int(paper.r), int(paper.g), int(paper.b)}) CHECK(std::abs(channel - 240) <= 6);
    for (const int channel : {int(drawn.r), int(drawn.g), int(drawn.b)}) CHECK(std::abs(channel - 120) <= 6);
  }
}

TEST_CASE("a projective map and its inverse lead there and back, its boxes hold all four corners") {
  const Homography map{{0.9, 0.1, 20, -0.05, 1.1, 4, 0.0002, -0.0001, 1}};
  const Point p{120, 340}, back = map.inverse()(map(p));
  CHECK(back.x == Approx(p.x));
  CHECK(back.y == Approx(p.y));
  const Homography twice = map.after(map);
  CHECK(twice(p).x == Approx(map(map(p)).x));
  CHECK(twice(p).y == Approx(map(map(p)).y));
  const Box box{0, 0, 400, 300}, around = map.boxOf(box);
  for (const Point corner : {Point{0, 0}, Point{400, 0}, Point{400, 300}, Point{0, 300}})
    CHECK(around.grown(1e-9, 1e-9).contains(map(corner)));
  const Affine doubled{2, 0, 0, 2, 5, 7};
  CHECK(Homography(doubled).scaleAt(p) == Approx(2));
  CHECK(Homography(doubled).isAffine());
  CHECK_FALSE(map.isAffine());
}

TEST_CASE("a large picture is seen reduced, a part of it in its own pixels") {
  cv::Mat mat(4001, 6000, CV_8UC3, cv::Scalar(255, 255, 255));
  mat(cv::Rect(1000, 2000, 40, 20)).setTo(cv::Scalar(0, 0, 0));
  const auto document = Document::fromBytes(encoded(".bmp", mat), "plot.bmp");
  REQUIRE(document.ok());
  const auto page = document->page(1);
  REQUIRE(page.ok());
  CHECK(page->width == 6000);
  CHECK(page->overview.width_px == 3000);
  CHECK(page->overview.height_px == 2001);  // the last row is of one row alone
  CHECK(page->overviewToPage({0, 0}) == Point{0.5, 0.5});
  CHECK(pixel(page->overview, 500, 1000) == Rgb{0, 0, 0});
  CHECK(pixel(page->overview, 520, 1000) == Rgb{255, 255, 255});
  for (int turns = 0; turns < 4; ++turns) {
    INFO(turns);
    const auto all = document->view(*page, {0, 0, 5999, 4000}, turns);
    REQUIRE(all.ok());
    CHECK_FALSE(all->nativePixels);
    const Point black = all->viewToPage.inverse()({1010.5, 2008.5});
    CHECK(pixel(all->raster, static_cast<int>(black.x), static_cast<int>(black.y)) == Rgb{0, 0, 0});
    CHECK(std::abs(black.x - std::round(black.x)) < 1e-9);
  }
  const auto part = document->view(*page, {990, 1990, 1100, 2100});
  REQUIRE(part.ok());
  CHECK(part->nativePixels);
  CHECK(pixel(part->raster, 10, 10) == Rgb{0, 0, 0});
  CHECK(pixel(part->raster, 9, 10) == Rgb{255, 255, 255});
}

TEST_CASE("a region is clipped; one beside the page is refused") {
  const auto document = Document::fromBytes(encoded(".png", numberedPixels(9, 6)), "plot.png");
  const auto page = document->page(1);
  const auto all = document->view(*page, {-100, -100, 100, 100});
  REQUIRE(all.ok());
  CHECK(all->raster.rgb == page->overview.rgb);
  const auto beside = document->view(*page, {20, 20, 30, 30});
  REQUIRE_FALSE(beside.ok());
  CHECK(beside.failure().code == FailureCode::wrongUsage);
}

TEST_CASE("EXIF orientation is applied and its resolution read") {
  cv::Mat mat(16, 32, CV_8UC3, cv::Scalar(255, 255, 255));
  mat(cv::Rect(0, 0, 16, 8)) = cv::Scalar(0, 0, 0);  // the stored top left is dark
  const Bytes jpeg = encoded(".jpg", mat);
  struct Case {
    std::uint32_t orientation;
    int width, darkX, darkY;  // size as shown, and position of the dark corner
  };
  for (const Case& c : {Case{1, 32, 2, 2},
                        {2, 32, 29, 2},
                        {3, 32, 29, 13},
                        {4, 32, 2, 13},
                        {5, 16, 2, 2},
                        {6, 16, 13, 2},
                        {7, 16, 13, 29},
                        {8, 16, 2, 29}}) {
    INFO(c.orientation);
    const Page page = firstPage(withExif(jpeg, c.orientation));
    CHECK(page.width == c.width);
    CHECK(pixel(page.overview, c.darkX, c.darkY).r < 60);
    const auto opposite =
        pixel(page.overview, page.overview.width_px - 1 - c.darkX, page.overview.height_px - 1 - c.darkY);
    CHECK(opposite.r > 200);
    REQUIRE(page.dpi);
    CHECK(*page.dpi == 300);
  }
}

TEST_CASE("16 bits, grey and transparency become opaque 8-bit colour") {
  cv::Mat deep(2, 2, CV_16UC3, cv::Scalar(65535, 32896, 257));
  CHECK(pixel(firstPage(encoded(".png", deep)).overview, 1, 1) == Rgb{1, 128, 255});
  cv::Mat grey(2, 2, CV_8UC1, cv::Scalar(77));
  CHECK(pixel(firstPage(encoded(".png", grey)).overview, 0, 0) == Rgb{77, 77, 77});
  cv::Mat half(2, 2, CV_8UC4, cv::Scalar(0, 0, 255, 128));
  CHECK(pixel(firstPage(encoded(".png", half)).overview, 0, 0) == Rgb{255, 127, 127});
}

TEST_CASE("transparent plots are put on the background on which their marks are visible") {
  const auto lettersIn = [](const cv::Scalar& drawn, const cv::Scalar& grid) {
    cv::Mat mat(60, 60, CV_8UC4, cv::Scalar(0, 0, 0, 0));
    for (int i = 0; i < 60; i += 10) mat.row(i) = grid;  // many pixels of grid, few of letters
    for (int i = 25; i < 35; ++i) mat.at<cv::Vec4b>(i, 5) = cv::Vec4b(drawn);
    return mat;
  };
  const cv::Scalar black(0, 0, 0, 255), white(255, 255, 255, 255), light(220, 220, 220, 255),
      dark(60, 60, 60, 255);
  CHECK(pixel(firstPage(encoded(".png", lettersIn(black, light))).overview, 50, 55) == Rgb{255, 255, 255});
  CHECK(pixel(firstPage(encoded(".png", lettersIn(white, dark))).overview, 50, 55) == Rgb{0, 0, 0});
}

TEST_CASE("a framed plot's background is no mark within a rim: its letters show its colour") {
  const auto letteredPlot = [](int letters, int line, int background) {
    cv::Mat mat(120, 160, CV_8UC4, cv::Scalar(0, 0, 0, 0));
    const cv::Rect area(30, 10, 120, 90);
    mat(area) = cv::Scalar(line, line, line, 255);
    mat({area.x + 1, area.y + 1, area.width - 2, area.height - 2}) =
        cv::Scalar(background, background, background, 255);
    for (int y = 20; y < 90; y += 12) mat({10, y, 2, 8}) = cv::Scalar(letters, letters, letters, 255);
    return pixel(firstPage(encoded(".png", mat)).overview, 4, 115);
  };
  CHECK(letteredPlot(0, 0, 255) == Rgb{255, 255, 255});    // a white plot with a black frame
  CHECK(letteredPlot(0, 255, 255) == Rgb{255, 255, 255});  // and without one
  CHECK(letteredPlot(255, 255, 20) == Rgb{0, 0, 0});
}

TEST_CASE("a cut-out keeps at its rims the shade it stood on") {
  const auto cutOut = [](int paper, int drawn, int grid) {  // every line with half its contrast on both sides
    cv::Mat mat(60, 60, CV_8UC4, cv::Scalar(0, 0, 0, 0));
    const auto row = [&](int y, int line) {
      for (int dy : {-1, 0, 1}) {
        const int grey = dy == 0 ? line : (line + paper) / 2;
        mat.row(y + dy) = cv::Scalar(grey, grey, grey, 255);
      }
    };
    for (int y = 5; y < 50; y += 8) row(y, grid);  // so pale that half the contrast hardly shows
    row(53, drawn);
    return pixel(firstPage(encoded(".png", mat)).overview, 30, 58);
  };
  CHECK(cutOut(255, 0, 225) == Rgb{255, 255, 255});
  CHECK(cutOut(0, 255, 30) == Rgb{0, 0, 0});
}

namespace {

/// 16 x 17 pixels as Pillow writes them, interlaced: row y in colour y % 4 of white, red, blue and one that
/// is transparent.
Bytes interlacedGif() {
  return {0x47, 0x49, 0x46, 0x38, 0x39, 0x61, 0x10, 0x00, 0x11, 0x00, 0x81, 0x00, 0x00, 0xff, 0xff, 0xff,
          0xc8, 0x00, 0x00, 0x00, 0x00, 0xc8, 0x00, 0x78, 0x00, 0x21, 0xf9, 0x04, 0x01, 0x00, 0x00, 0x03,
          0x00, 0x2c, 0x00, 0x00, 0x00, 0x00, 0x10, 0x00, 0x11, 0x00, 0x40, 0x08, 0x3b, 0x00, 0x01, 0x08,
          0x1c, 0x48, 0xb0, 0xa0, 0xc1, 0x83, 0x08, 0x13, 0x2a, 0x5c, 0xc8, 0x50, 0xa0, 0x80, 0x87, 0x10,
          0x23, 0x4a, 0x9c, 0x48, 0xb1, 0xa2, 0xc5, 0x8b, 0x16, 0x03, 0x68, 0xdc, 0xc8, 0xb1, 0x63, 0x80,
          0x01, 0x20, 0x43, 0x8a, 0x1c, 0x39, 0xc0, 0xa3, 0xc9, 0x8d, 0x24, 0x53, 0x86, 0x3c, 0x79, 0x52,
          0xa5, 0x4a, 0x96, 0x26, 0x5d, 0xa6, 0x0c, 0x08, 0x00, 0x3b};
}

}  // namespace

TEST_CASE("a GIF's rows come in their order, and what is transparent shows the paper") {
  const Raster picture = firstPage(interlacedGif(), "plot.gif").overview;
  REQUIRE(picture.width_px == 16);
  REQUIRE(picture.height_px == 17);
  const Rgb white{255, 255, 255}, rows[] = {white, {200, 0, 0}, {0, 0, 200}, white};
  for (int y = 0; y < 17; ++y) {
    INFO(y);
    CHECK(pixel(picture, 9, y) == rows[y % 4]);
  }
}

TEST_CASE("a GIF that ends early, claims another size, or is a film, is refused") {
  const Bytes whole = interlacedGif();
  for (std::size_t size : {whole.size() - 1, whole.size() / 2, std::size_t{20}})
    CHECK(
        refusalOf(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)), "plot.gif").code ==
        FailureCode::unreadableInput);
  Bytes reaching = whole;
  reaching[6] = 0x0f;  // the picture would stand beyond its screen
  CHECK(refusalOf(reaching, "plot.gif").code == FailureCode::unreadableInput);
  Bytes film(whole.begin(), whole.end() - 1);
  film.insert(film.end(), whole.begin() + 25, whole.end());
  const Failure refusal = refusalOf(film, "plot.gif");
  CHECK(refusal.code == FailureCode::unreadableInput);
  CHECK(english(refusal.problem).find("animated") != std::string::npos);
}

TEST_CASE("a picture of a format that is not read is refused by its name, with a remedy") {
  using namespace std::string_literals;
  const std::pair<std::string, std::string> heads[] = {
      {"\0\0\0\x18"
       "ftypheic\0\0\0\0mif1heic"s,
       "HEIC picture"},
      {"\0\0\0\x1c"
       "ftypmif1\0\0\0\0mif1avifmiaf"s,
       "AVIF picture"},
      {"\0\0\0\x0cjP  \r\n\x87\n\0\0\0\x14"s, "JPEG 2000 picture"}};
  for (const auto& [head, kind] : heads)
    for (const char* const name : {"plot.png", "plot"}) {
      const Failure failure = refusalOf(Bytes(head.begin(), head.end()), name);
      INFO(failure.sentence());
      CHECK(failure.code == FailureCode::unreadableInput);
      CHECK(english(failure.problem).find(kind) != std::string::npos);
      CHECK(failure.sentence().find("save it as PNG") != std::string::npos);
    }
  // A video begins like such a picture.
  const std::string video =
      "\0\0\0\x18"
      "ftypisom\0\0\2\0isommp41"s;
  CHECK(english(refusalOf(Bytes(video.begin(), video.end()), "plot").problem)
            .find("type of the content is not known") != std::string::npos);
}

TEST_CASE("what cannot be read is refused with name, problem and remedy") {
  const Bytes png = encoded(".png", numberedPixels(30, 30));
  const std::string text = "travel,force\n1,2\n";
  struct Case {
    Bytes bytes;
    std::string name, says;
  };
  const std::vector<Case> cases = {
      {{}, "empty.png", "0 bytes"},
      {Bytes(png.begin(), png.begin() + 60), "cut.png", "truncated"},
      {claiming(png, 100000, 100000), "huge.png", "100000 x 100000"},
      {Bytes(text.begin(), text.end()), "text.png", "plain text"},
      {png, "plot.pdf", "PNG picture"},
      {Bytes{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n', 0, 0}, "head.png", "no width"},
      {claiming(png, 31, 30), "lies.png", "damaged"},
  };
  for (const Case& c : cases) {
    const Failure failure = refusalOf(c.bytes, c.name);
    INFO(failure.sentence());
    CHECK(failure.code == FailureCode::unreadableInput);
    CHECK(english(failure.subject.name) == c.name);
    CHECK(english(failure.problem).find(c.says) != std::string::npos);
    CHECK_FALSE(failure.remedies.empty());
  }
  const Bytes jpeg = encoded(".jpg", numberedPixels(30, 30));
  CHECK(english(refusalOf(Bytes(jpeg.begin(), jpeg.end() - 20), "cut.jpg").problem).find("truncated") !=
        std::string::npos);
}

TEST_CASE("a BMP that ends before its pixels is truncated, however it says what they hold") {
  // Header lengths and compressions: OS/2; none, masks, masks and alpha.
  for (const auto& [head, compression] :
       std::vector<std::pair<std::uint32_t, std::uint32_t>>{{12, 0}, {40, 0}, {56, 3}, {56, 6}}) {
    INFO(head << " " << compression);
    const Bytes whole = bitmapOf(8, 4, head, compression);
    const Page page = firstPage(whole, "plot.bmp");
    CHECK(page.width == 8);
    CHECK(pixel(page.overview, 3, 2) == Rgb{30, 20, 10});
    const Failure failure = refusalOf(Bytes(whole.begin(), whole.end() - 1), "cut.bmp");
    CHECK(english(failure.problem).find("truncated") != std::string::npos);
  }
}

TEST_CASE("a picture under another picture's name is read as what it is") {
  CHECK(firstPage(encoded(".bmp", numberedPixels(4, 4)), "plot.png").width == 4);
}

TEST_CASE("limits are options") {
  PageLimits limits;
  limits.maxMegapixels = 0.0001;
  CHECK(
      english(refusalOf(encoded(".png", numberedPixels(20, 20)), "plot.png", limits).problem).find("limit") !=
      std::string::npos);
  limits = {};
  limits.maxFileMegabytes = 0.00001;
  CHECK(
      english(refusalOf(encoded(".png", numberedPixels(20, 20)), "plot.png", limits).problem).find("limit") !=
      std::string::npos);
}

TEST_CASE("files: missing, a folder, and one that is there") {
  const auto folder = std::filesystem::temp_directory_path();
  CHECK(Document::open((folder / "detent-no-such-file.png").string()).failure().code ==
        FailureCode::unreadableInput);
  CHECK(english(Document::open(folder.string()).failure().problem).find("folder") != std::string::npos);
  const auto path = folder / "detent-page-test.png";
  const Bytes png = encoded(".png", numberedPixels(4, 4));
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
  const auto document = Document::open(path.string());
  REQUIRE(document.ok());
  CHECK(document->name() == "detent-page-test.png");
  CHECK(document->sha256() == sha256Hex(png));
  std::filesystem::remove(path);
}

TEST_CASE("SHA-256 of the standard's examples") {
  const auto of = [](const std::string& s) { return sha256Hex(Bytes(s.begin(), s.end())); };
  CHECK(of("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(of("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

TEST_CASE("affine maps: composition and inverse") {
  const Affine turn{0, 2, -3, 0, 5, 7}, shift{1, 0, 0, 1, -4, 9};
  const Point p{1.5, -2};
  CHECK(turn.after(shift)(p) == turn(shift(p)));
  const Point back = turn.inverse()(turn(p));
  CHECK(back.x == Approx(p.x));
  CHECK(back.y == Approx(p.y));
}
