// SPDX-License-Identifier: GPL-3.0-or-later
// SVG: detent-svg-worker draws it as a PDF when the page is requested; the PDF is then read like any other.

#include <algorithm>
#include <cmath>
#include <string_view>

#include "importer/page/embedded_fonts.h"
#include "importer/page/page_source.h"
#include "importer/page/picture_header.h"
#include "importer/svg/worker_client.h"

namespace detent::importer {
namespace {

constexpr double workersShare = 0.25;  // share of a page's time; the rest is for reading the PDF

/// Returns true if there is text with letters beyond ASCII, written directly or as character references, or
/// if the file is UTF-16.
bool mayNeedScripts(const Bytes& bytes) {
  constexpr std::string_view element = "text";
  const auto isBeyond = [](unsigned char c) { return c >= 0x80 || c == '&' || c == 0; };
  return std::ranges::find(bytes, 0) != bytes.end() ||
         (std::ranges::any_of(bytes, isBeyond) &&
          std::search(bytes.begin(), bytes.end(), element.begin(), element.end()) != bytes.end());
}

class SvgSource : public PageSource {
 public:
  explicit SvgSource(SourceFile file) : file_(std::move(file)) {}

  int pageCount() const override { return 1; }

  Result<Page> page(int number, const Progress& progress) override {
    if (auto failure = draw(progress)) return *failure;
    auto page = drawn_->page(number, progress);
    if (page) page->remarks.insert(page->remarks.end(), remarks_.begin(), remarks_.end());
    return page;
  }

  Result<PageView> view(const Page& page, const Box& region, int quarterTurns, const ViewOptions& options,
                        const Homography& levelToPage, const Progress& progress) override {
    if (auto failure = draw(progress)) return *failure;
    return drawn_->view(page, region, quarterTurns, options, levelToPage, progress);
  }

 private:
  /// Draws the PDF unless it exists already; returns nothing on success.
  std::optional<Failure> draw(const Progress& progress) {
    if (drawn_) return std::nullopt;
    svg::WorkerJob job;
    job.drawing = *file_.bytes;
    if (mayNeedScripts(*file_.bytes)) job.fonts = scriptFonts();
    job.processor_s =
        static_cast<int>(std::ceil(workersShare * std::clamp(file_.limits.maxPageSeconds, 0.1, 1e4)));
    constexpr double leastMemory_MB = 512;  // the libraries alone reserve part of it
    job.memory_MB = static_cast<int>(std::clamp(file_.limits.maxDocumentMegabytes, leastMemory_MB, 1e6));
    job.cancelled = progress.cancelled;
    svg::WorkerResult result = svg::drawSvg(job);
    if (result.end != svg::WorkerEnd::drawn) return refusal(result);
    if (result.leftOut > 0)
      remarks_.push_back({RemarkCode::pageUnreadable,
                          {1, Message("%1 parts are not drawn, because they are HTML or lie in other files",
                                      std::to_string(result.leftOut))}});
    if (!result.withoutFont.empty())
      remarks_.push_back({RemarkCode::pageUnreadable,
                          {1, Message("no installed font has the letters %1; boxes are drawn instead",
                                      result.withoutFont)}});
    SourceFile pdf = file_;
    pdf.bytes = std::make_shared<const Bytes>(std::move(result.pdf));
    pdf.pdfUnits = result.scale;
    auto opened = openPdfSource(pdf);
    if (!opened) return opened.failure();
    drawn_ = std::move(opened.value());
    return std::nullopt;
  }

  Failure refusal(const svg::WorkerResult& result) const {
    const auto otherwise =
        Message("Export the drawing as a PDF or as a picture of at least 300 dpi and import that");
    const auto cannot = [&](Message why) {
      return unreadable(file_.name, "", Message("the SVG cannot be drawn: %1", std::move(why)), otherwise);
    };
    const Remedies orRaise{{RemedyKind::advice, otherwise}, {RemedyKind::raiseLimit, {}}};
    switch (result.end) {
      case svg::WorkerEnd::cancelled:
        return Failure::cancelled(file_.name);
      case svg::WorkerEnd::truncated:
        return unreadable(file_.name, Message("end of file"),
                          Message("the %1 is truncated", kindName(FileKind::svg)),
                          Message("Copy or download the file again"));
      case svg::WorkerEnd::absent:
        return unreadable(
            file_.name, "",
            Message("the program detent-svg-worker, which draws SVG files, is not in %1", result.words),
            Message("Install Detent's package again, or export the drawing as a PDF and import that"));
      case svg::WorkerEnd::notStarted:
        return unreadable(file_.name, "",
                          Message("the program detent-svg-worker cannot be started (%1)", result.words),
                          Message("Close other programs and try again"));
      case svg::WorkerEnd::tooSlow:
        return unreadable(file_.name, "", Message("the drawing takes too long to draw"), orRaise);
      case svg::WorkerEnd::tooLarge:
        return unreadable(file_.name, "", Message("the drawing has too many objects"), otherwise);
      case svg::WorkerEnd::refused:
        return cannot(Message(result.words));
      case svg::WorkerEnd::broke:
      case svg::WorkerEnd::drawn:
        break;
    }
    return cannot(
        Message("the drawing needs more memory than allowed, or crashes the program that draws it"));
  }

  SourceFile file_;
  std::vector<Remark> remarks_;
  std::unique_ptr<PageSource> drawn_;
};

}  // namespace

OpenedSource openSvgSource(const SourceFile& file) { return OpenedSource(std::make_unique<SvgSource>(file)); }

}  // namespace detent::importer
