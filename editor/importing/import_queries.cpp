// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/import_queries.h"

#include <algorithm>
#include <QBuffer>
#include <QFile>
#include <QFileInfo>

#include "model/check.h"

namespace detent::editor {
namespace {

constexpr int thumbnailSide_px = 320;  // twice the shown size, for screens with two pixels per point
// Larger pictures are scaled down for the screen, never for the import.
constexpr int sheetSide_px = 3200, viewSide_px = 2000;

PageThumbnail thumbnailOf(const importer::Page& page) {
  return {page.number, imageFrom(page.overview, thumbnailSide_px), boundsOf(page)};
}

/// The part of a page around a graph, upright.
QImage graphThumbnail(const importer::Page& page, const importer::ListedGraph& graph) {
  if (page.overview.empty()) return {};
  const importer::Raster& overview = page.overview;
  const importer::Affine toOverview = page.overviewToPage.inverse();
  const double margin = 0.12 * std::max(graph.frame.width(), graph.frame.height());
  const auto a = toOverview({graph.frame.x0 - margin, graph.frame.y0 - margin});
  const auto b = toOverview({graph.frame.x1 + margin, graph.frame.y1 + margin});
  const QRect part = QRectF(QPointF(a.x, a.y), QPointF(b.x, b.y)).normalized().toAlignedRect() &
                     QRect(0, 0, overview.width_px, overview.height_px);
  if (part.isEmpty()) return {};
  const QImage wrapped(overview.rgb.data(), overview.width_px, overview.height_px,
                       3 * static_cast<qsizetype>(overview.width_px), QImage::Format_RGB888);
  QImage cut = wrapped.copy(part);
  if (graph.quarterTurns != 0) cut = cut.transformed(QTransform().rotate(90.0 * graph.quarterTurns));
  return cut.scaled(thumbnailSide_px, thumbnailSide_px, Qt::KeepAspectRatio, Qt::SmoothTransformation)
      .convertToFormat(QImage::Format_RGB32);
}

/// PNG keeps transparency, which the importer lays on the background that shows the marks.
Result<importer::ImportSession> openPasted(const OpenPicture& query) {
  QByteArray png;
  QBuffer buffer(&png);
  buffer.open(QIODevice::WriteOnly);
  constexpr int fastCompression = 90;
  if (query.picture.isNull() || !query.picture.save(&buffer, "PNG", fastCompression)) {
    return Failure{FailureCode::unreadableInput, query.name.toStdString(), "",
                   Message("the clipboard holds no picture"),
                   Message("Copy the picture again, or save it to a file and open the file")};
  }
  return importer::ImportSession::fromBytes({png.begin(), png.end()}, query.name.toStdString());
}

}  // namespace

Answer ImportAnswers::answer(const Query& query, const importer::Progress& progress) {
  if (const auto* file = std::get_if<OpenFile>(&query)) {
    session_.reset();  // frees the memory of the previous file first
    return open(importer::ImportSession::open(QFile::encodeName(file->path).toStdString()),
                QFileInfo(file->path).fileName());
  }
  if (const auto* picture = std::get_if<OpenPicture>(&query)) {
    session_.reset();
    return open(openPasted(*picture), picture->name);
  }
  DETENT_CHECK(session_.has_value(), "a document is opened before anything of it is asked");
  if (const auto* ask = std::get_if<ReadThumbnail>(&query)) return thumbnail(ask->page, progress);
  if (const auto* ask = std::get_if<ReadSheet>(&query)) return sheet(ask->page, progress);
  if (const auto* ask = std::get_if<FindGraphs>(&query)) return graphs(*ask, progress);
  return imported(std::get<ImportOne>(query), progress);
}

Answer ImportAnswers::open(Result<importer::ImportSession> opened, const QString& name) {
  if (!opened) return opened.failure();
  session_ = std::move(opened).value();
  return DocumentFacts{name, session_->pageCount()};
}

Answer ImportAnswers::thumbnail(int number, const importer::Progress& progress) {
  const auto page = session_->page(number, progress);
  if (!page) return page.failure();
  return thumbnailOf(**page);
}

Answer ImportAnswers::sheet(int number, const importer::Progress& progress) {
  const auto page = session_->page(number, progress);
  if (!page) return page.failure();
  const importer::Page& p = **page;
  return PageSheet{number, PagePicture(p.overview, p.overviewToPage, sheetSide_px), boundsOf(p), p.unit};
}

Answer ImportAnswers::graphs(const FindGraphs& query, const importer::Progress& progress) {
  auto listed = session_->list(query.page, query.quality, {}, progress);
  if (!listed) return listed.failure();
  const auto page = session_->page(query.page, progress);
  if (!page) return page.failure();
  FoundGraphs found{thumbnailOf(**page), {}, std::move(listed->rejected)};
  for (auto& graph : listed->graphs) {
    QImage thumbnail = graphThumbnail(**page, graph);
    found.graphs.push_back({std::move(graph), std::move(thumbnail)});
  }
  return found;
}

Answer ImportAnswers::imported(const ImportOne& query, const importer::Progress& progress) {
  importer::ImportRequest request;
  if (!session_->isForceLog()) request.page = query.graph.page, request.graph = query.graph.graph;
  request.quality = query.quality;
  request.hints = query.hints;
  request.acceptDoubt = true;
  ImportedGraph answer{query.graph, {}, {}, {}, {}};
  auto [report, evidence, question, interpretations] = session_->attempt(request, progress);
  answer.evidence = std::move(evidence);
  answer.explanation = importer::explanationTable(interpretations);
  if (report)
    answer.report = std::make_shared<const importer::ImportReport>(std::move(report).value());
  else
    answer.failure = report.failure();
  if (answer.evidence) {
    const importer::PageView& view = answer.evidence->view;
    answer.view = PagePicture(view.raster, view.viewToPage, viewSide_px);
  }
  return answer;
}

}  // namespace detent::editor
