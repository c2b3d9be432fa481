// SPDX-License-Identifier: GPL-3.0-or-later
// PDF. A page is recorded once as a display list; texts and renders are made from the list.

#include <algorithm>
#include <functional>
#include <list>
#include <span>
#include <string_view>

#include "importer/page/broken_images.h"
#include "importer/page/collect_device.h"
#include "importer/page/mupdf_context.h"
#include "importer/page/page_source.h"
#include "importer/page/stoppable_run.h"
#include "importer/page/text_boxes.h"
#include "importer/page/view_grid.h"

namespace detent::importer {
namespace {

constexpr double overviewDpi = 150;  // enough for labels of 5 pt
/// Total vertical extent of one object's lines that is drawn per second at the least, for lines across the
/// whole page: 1.5e7 took 13 s.
constexpr double risePerSecond = 2.5e5;
constexpr double overviewMaxSide_px = 2000;
constexpr int letterContrast = 60;        // levels, in the box of a visible letter
constexpr int overviewAntialiasBits = 6;  // half the time of 8 on pages with 1e5 glyph outlines

/// Calls a function at the end of its scope.
struct FinalCall {
  explicit FinalCall(std::function<void()> function) : call(std::move(function)) {}
  FinalCall(const FinalCall&) = delete;
  FinalCall& operator=(const FinalCall&) = delete;
  ~FinalCall() { call(); }
  const std::function<void()> call;
};

/// A recorded page. Owns the display list of its context.
struct RecordedPage {
  int number = 0;
  fz_context* context = nullptr;
  fz_display_list* list = nullptr;
  double width = 0, height = 0;
  CollectedPage collected;
  bool pathsHandedOut = false;  ///< there may be a hundred thousand paths, so they are moved, not copied

  RecordedPage(int pageNumber, fz_context* itsContext) : number(pageNumber), context(itsContext) {}
  RecordedPage(const RecordedPage&) = delete;
  RecordedPage& operator=(const RecordedPage&) = delete;
  ~RecordedPage() { fz_drop_display_list(context, list); }
};

class MupdfSource : public PageSource {
 public:
  explicit MupdfSource(SourceFile file)
      : file_(std::move(file)),
        context_(static_cast<std::size_t>(std::max(16.0, file_.limits.maxDocumentMegabytes) * 1024 * 1024)) {}

  ~MupdfSource() override {
    recorded_.clear();
    if (context_.get()) fz_drop_document(context_.get(), document_);
  }
  MupdfSource(const MupdfSource&) = delete;
  MupdfSource& operator=(const MupdfSource&) = delete;

  /// Opens the document; returns nothing on success.
  std::optional<Failure> open();

  int pageCount() const override { return pageCount_; }
  Result<Page> page(int number, const Progress& progress) override;
  Result<PageView> view(const Page& page, const Box& region, int quarterTurns, const ViewOptions& options,
                        const Homography&, const Progress& progress) override;

 private:
  std::string kind() const { return file_.pdfUnits > 0 ? "SVG" : "PDF"; }
  /// Factor from the page's units in the file to those of Page.
  double scale() const { return file_.pdfUnits > 0 ? 1 / file_.pdfUnits : 1; }
  std::string placeOf(int number) const { return "page " + std::to_string(number); }
  Failure damaged(const std::string& place, const std::string& error) const;
  std::optional<Failure> refusal(const CollectControl& control, int number) const;
  Remedies simplify() const;
  double endOfPage_s() const {
    return processorSeconds() + std::clamp(file_.limits.maxPageSeconds, 0.0, 1e6);
  }

  Result<RecordedPage*> recorded(int number, const Progress& progress);
  Result<std::unique_ptr<RecordedPage>> record(int number, const Progress& progress);
  bool measure(RecordedPage& page, fz_page* loaded, std::string& error);
  bool runIntoList(RecordedPage& page, fz_page* loaded, CollectControl& control, const Progress& progress,
                   std::string& error);
  std::optional<Failure> drawnOn(const RecordedPage& page, const fz_matrix& matrix, const fz_rect& area,
                                 const Progress& progress, const std::function<fz_device*()>& newDevice);
  Result<std::vector<TextBox>> textsOf(const RecordedPage& page, LetterKeys seen, const Progress& progress);
  Result<Raster> render(const RecordedPage& page, const ViewGrid& grid, int antialiasBits,
                        const Progress& progress);

  SourceFile file_;
  MupdfContext context_;
  fz_document* document_ = nullptr;
  int pageCount_ = 0;
  int brokenImages_ = 0;  ///< images removed from the document so that its pages can be read
  std::list<std::unique_ptr<RecordedPage>> recorded_;  ///< recorded pages, most recent first
};

Failure MupdfSource::damaged(const std::string& place, const std::string& error) const {
  return unreadable(
      file_.name, place,
      Message("the %1 is damaged (%2)", kind(), error.empty() ? Message("no reason given") : Message(error)),
      Message("Open the file in a viewer and print or export it again, or import a picture of the page"));
}

std::optional<Failure> MupdfSource::open() {
  fz_context* context = context_.get();
  constexpr std::string_view endMark = "%%EOF";
  constexpr std::size_t endMarkWithin = 4096;  // bytes
  const auto end = std::span(*file_.bytes).last(std::min(file_.bytes->size(), endMarkWithin));
  if (!context)
    return unreadable(file_.name, "", Message("there is not enough memory to open the file"),
                      Message("Close other programs and try again"));
  if (kind() == "PDF" && std::search(end.begin(), end.end(), endMark.begin(), endMark.end()) == end.end())
    return unreadable(file_.name, Message("end of file"),
                      Message("the PDF is truncated (its end mark is missing)"),
                      Message("Copy or download the file again"));
  std::string error;
  bool locked = false;
  const bool opened = guarded(context, error, [&] {
    fz_stream* stream = fz_open_memory(context, file_.bytes->data(), file_.bytes->size());
    fz_try(context) document_ = fz_open_document_with_stream(context, "application/pdf", stream);
    fz_always(context) fz_drop_stream(context, stream);
    fz_catch(context) fz_rethrow(context);
    locked = fz_needs_password(context, document_) && !fz_authenticate_password(context, document_, "");
    if (!locked) pageCount_ = fz_count_pages(context, document_);
  });
  if (!opened) return damaged("", error);
  if (locked)
    return unreadable(file_.name, "", Message("the PDF is encrypted with a password"),
                      Message("Save a copy without the password and import that"));
  if (pageCount_ <= 0) return damaged("", "it has no pages");
  if (pageCount_ > file_.limits.maxPages)
    return unreadable(file_.name, "",
                      Message("the document has %1 pages, more than the limit of %2",
                              std::to_string(pageCount_), std::to_string(file_.limits.maxPages)),
                      {{RemedyKind::advice,
                        Message("Save the pages with the graphs as a document of their own and import that")},
                       {RemedyKind::raiseLimit, {}}});
  return std::nullopt;
}

Remedies MupdfSource::simplify() const {
  return {{RemedyKind::advice, Message("Export the page as a picture of at least 300 dpi and import that")},
          {RemedyKind::raiseLimit, {}}};
}

std::optional<Failure> MupdfSource::refusal(const CollectControl& control, int number) const {
  const auto because = [&](Message why) {
    return unreadable(file_.name, placeOf(number), std::move(why), simplify());
  };
  switch (control.stop) {
    case CollectStop::none:
      break;
    case CollectStop::cancelled:
      return Failure::cancelled(file_.name);
    case CollectStop::tooManyPoints:
      return because(Message("the drawing has too many points (the limit is %1)",
                             std::to_string(file_.limits.maxPathPoints)));
    case CollectStop::tooManyOperations:
      return because(Message("the page has too many objects"));
    case CollectStop::tooDense:
      return because(Message("the page takes too long to draw"));
    case CollectStop::tooSlow:
      return because(Message("the page takes too long to interpret"));
    case CollectStop::imageTooLarge:
      return because(Message("an image on the page claims %1 x %2 pixels, which is more than the limit",
                             std::to_string(control.imageWidth_px), std::to_string(control.imageHeight_px)));
    case CollectStop::outOfMemory:
      return because(Message("the page needs more memory than allowed"));
  }
  return std::nullopt;
}

bool MupdfSource::measure(RecordedPage& page, fz_page* loaded, std::string& error) {
  fz_rect bounds = fz_empty_rect;
  if (!guarded(context_.get(), error, [&] { bounds = fz_bound_page(context_.get(), loaded); })) return false;
  page.width = scale() * (static_cast<double>(bounds.x1) - bounds.x0);
  page.height = scale() * (static_cast<double>(bounds.y1) - bounds.y0);
  constexpr double largestSide = 1e6;  // points; 350 m
  if (page.width > 0 && page.height > 0 && page.width < largestSide && page.height < largestSide) return true;
  error = "its page has no usable size";
  return false;
}

bool MupdfSource::runIntoList(RecordedPage& page, fz_page* loaded, CollectControl& control,
                              const Progress& progress, std::string& error) {
  fz_context* context = context_.get();
  fz_cookie cookie{};
  control.cookie = &cookie;
  const Box bounds{0, 0, page.width, page.height};
  bool done = false;
  auto run = [&] {
    fz_device* recorder = nullptr;
    fz_device* device = nullptr;
    fz_var(recorder);
    fz_var(device);
    fz_try(context) {
      const fz_rect box = fz_bound_page(context, loaded);
      page.list = fz_new_display_list(
          context, fz_make_rect(0, 0, static_cast<float>(page.width), static_cast<float>(page.height)));
      recorder = fz_new_list_device(context, page.list);
      device = newCollectDevice(context, recorder, bounds, &page.collected, &control);
      const auto toPage = static_cast<float>(scale());
      fz_run_page(context, loaded, device,
                  fz_make_matrix(toPage, 0, 0, toPage, -toPage * box.x0, -toPage * box.y0), &cookie);
      fz_close_device(context, device);
    }
    fz_always(context) {
      fz_drop_device(context, device);
      fz_drop_device(context, recorder);
    }
    fz_catch(context) fz_rethrow(context);
  };
  const RunStop stop =
      runStoppable(cookie, endOfPage_s(), progress, [&] { done = guarded(context, error, run); });
  control.cookie = nullptr;
  if (stop != RunStop::none)
    control.stop = stop == RunStop::cancelled ? CollectStop::cancelled : CollectStop::tooSlow;
  return done;
}

Result<std::unique_ptr<RecordedPage>> MupdfSource::record(int number, const Progress& progress) {
  fz_context* context = context_.get();
  auto page = std::make_unique<RecordedPage>(number, context);
  std::string error;
  fz_page* loaded = nullptr;
  if (!guarded(context, error, [&] { loaded = fz_load_page(context, document_, number - 1); }))
    return damaged(placeOf(number), error);

  CollectControl control;
  control.maxPathPoints = static_cast<std::size_t>(std::max(0, file_.limits.maxPathPoints));
  control.maxOperations = control.maxPathPoints / 4 + 1000;
  control.maxImagePixels = file_.limits.maxMegapixels * 1e6;
  control.maxRise = risePerSecond * std::clamp(file_.limits.maxPageSeconds, 0.0, 1e6);
  bool done = measure(*page, loaded, error) && runIntoList(*page, loaded, control, progress, error);
  if (!done && control.stop == CollectStop::none) {
    if (const int broken = leaveOutBrokenImages(context, loaded); broken > 0) {
      brokenImages_ += broken;
      page = std::make_unique<RecordedPage>(number, context);
      done = measure(*page, loaded, error) && runIntoList(*page, loaded, control, progress, error);
    }
  }
  fz_drop_page(context, loaded);
  if (auto failure = refusal(control, number)) return *failure;
  if (!done) return damaged(placeOf(number), error);
  dropRepeats(page->collected.paths);
  return Result<std::unique_ptr<RecordedPage>>(std::move(page));
}

Result<RecordedPage*> MupdfSource::recorded(int number, const Progress& progress) {
  constexpr std::size_t keptPages = 3;
  const auto known =
      std::find_if(recorded_.begin(), recorded_.end(), [&](const auto& p) { return p->number == number; });
  if (known != recorded_.end()) {
    recorded_.splice(recorded_.begin(), recorded_, known);
    return recorded_.front().get();
  }
  auto fresh = record(number, progress);
  if (!fresh) return fresh.failure();
  recorded_.push_front(std::move(fresh.value()));
  if (recorded_.size() > keptPages) recorded_.pop_back();
  return recorded_.front().get();
}

/// Runs the display list into a device within the time limit. Returns a failure if the result cannot be used.
std::optional<Failure> MupdfSource::drawnOn(const RecordedPage& page, const fz_matrix& matrix,
                                            const fz_rect& area, const Progress& progress,
                                            const std::function<fz_device*()>& newDevice) {
  fz_context* context = context_.get();
  fz_cookie cookie{};
  std::string error;
  bool done = false;
  auto draw = [&] {
    fz_device* device = nullptr;
    fz_var(device);
    fz_try(context) {
      device = newDevice();
      fz_run_display_list(context, page.list, device, matrix, area, &cookie);
      fz_close_device(context, device);
    }
    fz_always(context) fz_drop_device(context, device);
    fz_catch(context) fz_rethrow(context);
  };
  const RunStop stop =
      runStoppable(cookie, endOfPage_s(), progress, [&] { done = guarded(context, error, draw); });
  if (stop == RunStop::cancelled) return Failure::cancelled(file_.name);
  if (stop == RunStop::tooSlow)
    return unreadable(file_.name, placeOf(page.number), Message("the page takes too long to draw"),
                      simplify());
  if (!done) return damaged(placeOf(page.number), error);
  return std::nullopt;
}

Result<std::vector<TextBox>> MupdfSource::textsOf(const RecordedPage& page, LetterKeys seen,
                                                  const Progress& progress) {
  fz_context* context = context_.get();
  fz_stext_page* text = nullptr;
  const FinalCall drop([&] { fz_drop_stext_page(context, text); });
  fz_stext_options options{};
  // each ligature stays one letter, because letters are identified by code and place
  options.flags = FZ_STEXT_PRESERVE_LIGATURES;
  const auto failure = drawnOn(page, fz_identity, fz_infinite_rect, progress, [&] {
    text = fz_new_stext_page(
        context, fz_make_rect(0, 0, static_cast<float>(page.width), static_cast<float>(page.height)));
    return fz_new_stext_device(context, text, &options);
  });
  if (failure) return *failure;
  return textBoxes(*text, {0, 0, page.width, page.height}, std::move(seen));
}

/// Difference in levels between the darkest and the brightest pixel of a box, for the channel where it is
/// largest.
int contrastIn(const Raster& picture, const Box& box) {
  // A damaged drawing puts lines anywhere: a place is cut to the picture before it becomes a whole number.
  const auto pixelAt = [](double at, int size_px) {
    return static_cast<int>(std::min<double>(size_px, std::max(0.0, at)));
  };
  const int left = pixelAt(box.x0, picture.width_px), top = pixelAt(box.y0, picture.height_px);
  int most = 0;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    int darkest = 255, brightest = 0;
    for (int y = top; y <= box.y1 && y < picture.height_px; ++y)
      for (int x = left; x <= box.x1 && x < picture.width_px; ++x) {
        const int level = picture.at(x, y)[channel];
        darkest = std::min(darkest, level);
        brightest = std::max(brightest, level);
      }
    most = std::max(most, brightest - darkest);
  }
  return most;
}

/// Returns true if a stroked line is invisible: it has its background's colour, or is drawn with a blend mode
/// that hides it.
bool isUnseen(const VectorPath& path, const Raster& picture, const Affine& toPicture) {
  // levels: thin grey lines are visible from this on; number of samples
  constexpr int leastContrast = 2, seenForSure = 32;
  constexpr double leastSeen = 0.2;  // share of the samples: invisible lines cross visible ones
  const double reach = path.strokeWidth / 2 * std::hypot(toPicture.a, toPicture.b) + 1.5;
  int samples = 0, seen = 0;
  for (const auto& line : path.polylines)
    for (std::size_t i = 1; i < line.size() && seen < seenForSure; i += 1 + line.size() / seenForSure)
      for (const double along : {0.2, 0.5, 0.8}) {
        const Point at = toPicture(line[i - 1] + along * (line[i] - line[i - 1]));
        ++samples;
        seen += contrastIn(picture, Box{at.x, at.y, at.x, at.y}.grown(reach, reach)) >= leastContrast;
      }
  return samples > 0 && seen < std::min(leastSeen * samples, 1.0 * seenForSure);
}

/// MuPDF's rows may be padded and its pixels may have other channels; the renders here are plain RGB.
Raster copyPixels(const unsigned char* samples, std::ptrdiff_t stride, int width, int height) {
  Raster raster;
  raster.width_px = width;
  raster.height_px = height;
  const std::size_t row = 3 * static_cast<std::size_t>(width);
  raster.rgb.resize(row * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y)
    std::copy_n(samples + stride * y, row, raster.rgb.data() + row * static_cast<std::size_t>(y));
  return raster;
}

Result<Raster> MupdfSource::render(const RecordedPage& page, const ViewGrid& grid, int antialiasBits,
                                   const Progress& progress) {
  fz_context* context = context_.get();
  fz_set_aa_level(context, antialiasBits);
  const int width = grid.rect.width, height = grid.rect.height;
  const Affine toPixels = grid.pageToUprightCorners();
  const auto f = [](double v) { return static_cast<float>(v); };
  const fz_matrix matrix = fz_make_matrix(f(toPixels.a), f(toPixels.b), f(toPixels.c), f(toPixels.d),
                                          f(toPixels.e - grid.rect.x), f(toPixels.f - grid.rect.y));
  fz_pixmap* pixmap = nullptr;
  const FinalCall drop([&] { fz_drop_pixmap(context, pixmap); });
  const auto failure = drawnOn(
      page, matrix, fz_make_rect(0, 0, static_cast<float>(width), static_cast<float>(height)), progress, [&] {
        pixmap = fz_new_pixmap_with_bbox(context, fz_device_rgb(context), fz_make_irect(0, 0, width, height),
                                         nullptr, 0);
        fz_clear_pixmap_with_value(context, pixmap, 255);
        return fz_new_draw_device(context, fz_identity, pixmap);
      });
  if (failure) return *failure;
  return copyPixels(fz_pixmap_samples(context, pixmap), fz_pixmap_stride(context, pixmap), width, height);
}

Result<Page> MupdfSource::page(int number, const Progress& progress) {
  recorded_.remove_if([&](const auto& p) { return p->number == number && p->pathsHandedOut; });
  auto found = recorded(number, progress);
  if (!found) return found.failure();
  RecordedPage& source = **found;
  const ViewGrid grid = overviewGrid(source.width, source.height, overviewDpi / 72, overviewMaxSide_px);
  auto overview = render(source, grid, overviewAntialiasBits, progress);
  if (!overview) return overview.failure();
  const Affine toOverview = grid.viewToPage(0).inverse();
  const LetterKeys seen = source.collected.visibility.seen(
      [&](const Box& letter) { return contrastIn(*overview, toOverview.boxOf(letter)) >= letterContrast; });
  auto texts = textsOf(source, seen, progress);
  if (!texts) return texts.failure();

  Page page;
  page.source = file_.name;
  page.number = number;
  page.count = pageCount_;
  page.unit = PageUnit::point;
  page.width = source.width;
  page.height = source.height;
  page.overview = std::move(overview.value());
  page.overviewToPage = grid.viewToPage(0);
  page.texts = std::move(texts.value());
  page.paths = std::move(source.collected.paths);
  std::erase_if(page.paths, [&](const VectorPath& path) {
    return path.stroke && isUnseen(path, page.overview, toOverview);
  });
  source.pathsHandedOut = true;
  for (const ImagePlacement& placement : source.collected.images) page.images.push_back(placement.image);
  if (brokenImages_ > 0) page.remarks = {{RemarkCode::imagesUndecoded, {number, brokenImages_}}};
  return page;
}

Result<PageView> MupdfSource::view(const Page& page, const Box& region, int quarterTurns,
                                   const ViewOptions& options, const Homography&, const Progress& progress) {
  auto found = recorded(page.number, progress);
  if (!found) return found.failure();
  const RecordedPage& source = **found;
  const auto grid = chooseGrid(region, quarterTurns, page, source.collected.images, options,
                               file_.limits.maxMegapixels * 1e6);
  if (!grid)
    return Failure{FailureCode::wrongUsage, file_.name, placeOf(page.number),
                   Message("the region lies outside the page"),
                   Message("Give a region inside %1 x %2 points", page.width, page.height)};
  auto upright = render(source, *grid, 8, progress);
  if (!upright) return upright.failure();
  PageView view;
  view.raster = quarterTurns == 0
                    ? std::move(upright.value())
                    : turnedCrop(*upright, {0, 0, grid->rect.width, grid->rect.height}, quarterTurns);
  const Affine viewToPage = grid->viewToPage(quarterTurns);
  view.viewToPage = viewToPage;
  view.nativePixels = grid->nativePixels;
  carryContent(page, region, quarterTurns, viewToPage.inverse(), view);
  return view;
}

}  // namespace

OpenedSource openPdfSource(const SourceFile& file) {
  auto source = std::make_unique<MupdfSource>(file);
  if (auto failure = source->open()) return *failure;
  return OpenedSource(std::move(source));
}

}  // namespace detent::importer
