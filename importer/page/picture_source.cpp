// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures: the page is the picture, and a view is a crop of its own pixels. Pixels of a picture that is
// larger than any plot needs are averaged (docs/develop/decisions/0300-page-views-and-large-pictures.md).

#include <algorithm>
#include <cmath>

#include "importer/page/crop.h"
#include "importer/page/decode_picture.h"
#include "importer/page/even_light.h"
#include "importer/page/page_source.h"

namespace detent::importer {
namespace {

/// Most pixels of a page. No plot needs more: 16 million are four times as many as an A4 page has at 300 dpi
/// across its width.
constexpr double mostPixels = 16e6;

/// Side length in px of the square of pixels that is averaged into one pixel.
int reductionOf(int width_px, int height_px) {
  const double pixels = static_cast<double>(width_px) * height_px;
  return std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / mostPixels))));
}

class PictureSource : public PageSource {
 public:
  PictureSource(SourceFile file, FileKind kind, std::vector<PictureHeader> headers)
      : file_(std::move(file)), kind_(kind), headers_(std::move(headers)) {}

  int pageCount() const override { return static_cast<int>(headers_.size()); }

  Result<Page> page(int number, const Progress&) override {
    const PictureHeader& header = headers_[static_cast<std::size_t>(number - 1)];
    std::optional<Raster> raster = decodePicture(*file_.bytes, kind_, header);
    if (!raster) return undecodable(number);
    Page page;
    page.source = file_.name;
    page.number = number;
    page.count = pageCount();
    page.unit = PageUnit::pixel;
    page.width = raster->width_px;
    page.height = raster->height_px;
    page.dpi = header.dpi;
    const int factor = reductionOf(raster->width_px, raster->height_px);
    if (factor == 1) {
      page.overview = std::move(*raster);
      return page;
    }
    const PixelRect all{0, 0, raster->width_px, raster->height_px};
    page.overview = reducedCrop(*raster, all, factor);
    page.overviewToPage = reducedCropToRaster(all, factor);
    large_ = {number, std::move(*raster)};
    return page;
  }

  Result<PageView> view(const Page& page, const Box& region, int quarterTurns, const ViewOptions&,
                        const Homography& levelToPage, const Progress&) override {
    if (levelToPage != Homography{}) return levelView(page, region, quarterTurns, levelToPage);
    const Result<const Raster*> pixels = pixelsOf(page);
    if (!pixels) return pixels.failure();
    const Raster& picture = **pixels;
    const auto rect = touchedPixels(region, picture.width_px, picture.height_px);
    if (!rect)
      return Failure{FailureCode::wrongUsage, file_.name, placeOf(page.number),
                     Message("the region lies outside the picture"),
                     Message("Give a region inside %1 x %2 pixels", picture.width_px, picture.height_px)};
    PageView view;
    const int factor = reductionOf(rect->width, rect->height);
    if (factor == 1) {
      view.raster = turnedCrop(picture, *rect, quarterTurns);
      view.viewToPage = turnedCropToRaster(*rect, quarterTurns);
      view.nativePixels = true;
      return view;
    }
    const Raster reduced = reducedCrop(picture, *rect, factor);
    const PixelRect all{0, 0, reduced.width_px, reduced.height_px};
    view.raster = turnedCrop(reduced, all, quarterTurns);
    view.viewToPage = reducedCropToRaster(*rect, factor).after(turnedCropToRaster(all, quarterTurns));
    return view;
  }

 private:
  Failure undecodable(int number) const {
    if (kind_ == FileKind::gif)
      return unreadable(file_.name, placeOf(number), Message("the GIF picture is damaged or animated"),
                        Message("Save the picture that shows the whole graph as PNG and import that"));
    return unreadable(file_.name, placeOf(number),
                      Message("the %1 is damaged and cannot be decoded", kindName(kind_)),
                      Message("Save or export the picture again and import the new file"));
  }

  /// A levelled region of the page, interpolated between the pixels of its overview.
  static PageView levelView(const Page& page, const Box& region, int quarterTurns,
                            const Homography& levelToPage) {
    const Box whole = levelToPage.inverse().boxOf({0, 0, page.width - 1, page.height - 1}),
              seen = region.common(whole);
    const double left = std::floor(seen.x0), top = std::floor(seen.y0);
    const int width = static_cast<int>(std::ceil(seen.x1) - left) + 1,
              height = static_cast<int>(std::ceil(seen.y1) - top) + 1;
    const int factor = reductionOf(width, height);
    const PixelRect all{0, 0, (width + factor - 1) / factor, (height + factor - 1) / factor};
    const Homography toPage = levelToPage.after(reducedCropToRaster({0, 0, width, height}, factor))
                                  .after(Affine{1, 0, 0, 1, left / factor, top / factor});
    PageView view;
    view.raster = turnedCrop(resampled(page.overview, Homography(page.overviewToPage.inverse()).after(toPage),
                                       all.width, all.height),
                             all, quarterTurns);
    if (!levelToPage.isAffine()) view.raster = evenlyLit(std::move(view.raster));
    view.viewToPage = toPage.after(turnedCropToRaster(all, quarterTurns));
    return view;
  }

  /// All pixels of a large picture, kept apart from its page.
  struct Large {
    int page = 0;
    Raster raster;
  };

  /// The picture as stored: the page's own pixels, or for a large picture the kept ones, which are decoded
  /// again if another picture has replaced them.
  Result<const Raster*> pixelsOf(const Page& page) {
    if (page.overviewToPage == Affine{}) return &page.overview;
    if (large_.page != page.number)
      if (const auto again = this->page(page.number, {}); !again) return again.failure();
    return &large_.raster;
  }

  std::string placeOf(int number) const {
    return pageCount() > 1 ? "page " + std::to_string(number) : std::string();
  }

  SourceFile file_;
  FileKind kind_;
  std::vector<PictureHeader> headers_;
  Large large_;
};

std::string megapixels(double pixels) {
  std::string text = std::to_string(pixels / 1e6);
  return text.substr(0, text.find('.') + 2);
}

std::optional<Failure> refusal(const SourceFile& file, FileKind kind, const PictureHeader& header) {
  if (header.width_px <= 0 || header.height_px <= 0)
    return unreadable(file.name, Message("header"),
                      Message("the %1 is damaged or cut off: it states no width and height", kindName(kind)),
                      Message("Save or export the picture again and import the new file"));
  const double pixels = static_cast<double>(header.width_px) * static_cast<double>(header.height_px);
  if (pixels > file.limits.maxMegapixels * 1e6)
    return unreadable(
        file.name, Message("header"),
        Message("the picture claims %1 x %2 pixels, which is more than the limit of %3 megapixels",
                std::to_string(header.width_px), std::to_string(header.height_px),
                megapixels(file.limits.maxMegapixels * 1e6)),
        {{RemedyKind::advice, Message("Scale the picture down or crop it to the graph")},
         {RemedyKind::raiseLimit, {}}});
  if (!header.complete)
    return unreadable(file.name, Message("end of file"), Message("the %1 is truncated", kindName(kind)),
                      Message("Copy or download the file again"));
  return std::nullopt;
}

}  // namespace

OpenedSource openPictureSource(const SourceFile& file) {
  const FileKind kind = sniffFileKind(*file.bytes);
  std::vector<PictureHeader> headers = readPictureHeaders(*file.bytes, kind, file.limits.maxPages);
  if (headers.empty()) headers.emplace_back();
  for (const PictureHeader& header : headers)
    if (auto failure = refusal(file, kind, header)) return *failure;
  return OpenedSource(std::make_unique<PictureSource>(file, kind, std::move(headers)));
}

}  // namespace detent::importer
