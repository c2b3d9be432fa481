// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Queries of the dialogue to the import thread, and their answers: plain values, both ways.

#include <memory>
#include <optional>
#include <QImage>
#include <QString>
#include <variant>
#include <vector>

#include "editor/importing/page_picture.h"
#include "importer/importer.h"

namespace detent::editor {

/// A graph of the open document: page from 1, number on its page from 1.
struct GraphId {
  int page = 0, graph = 0;
  friend bool operator==(const GraphId&, const GraphId&) = default;
  /// Reading order.
  friend bool operator<(const GraphId& a, const GraphId& b) {
    return a.page != b.page ? a.page < b.page : a.graph < b.graph;
  }
};

struct OpenFile {
  QString path;
};
struct OpenPicture {
  QImage picture;
  QString name;
};
struct ReadThumbnail {
  int page = 1;
};
struct ReadSheet {
  int page = 1;
};
struct FindGraphs {
  int page = 1;
  importer::Quality quality = importer::Quality::standard;
};
struct ImportOne {
  GraphId graph;
  importer::ImportHints hints;
  importer::Quality quality = importer::Quality::standard;
};
using Query = std::variant<OpenFile, OpenPicture, ReadThumbnail, ReadSheet, FindGraphs, ImportOne>;

struct DocumentFacts {
  QString name;
  int pages = 0;  ///< 0: a force meter's log
};
struct PageThumbnail {
  int page = 1;
  QImage picture;
  QRectF bounds;  ///< bounds of the page, page units
};
struct PageSheet {
  int page = 1;
  PagePicture picture;
  QRectF bounds;
  importer::PageUnit unit = importer::PageUnit::pixel;
};
struct FoundGraph {
  importer::ListedGraph listed;
  QImage thumbnail;
};
struct FoundGraphs {
  PageThumbnail thumbnail;
  std::vector<FoundGraph> graphs;
  std::vector<importer::RejectedFrame> rejected;
};
struct ImportedGraph {
  GraphId graph;
  std::shared_ptr<const importer::ImportReport> report;  ///< null if the import failed
  std::optional<Failure> failure;                        ///< then
  std::shared_ptr<const importer::GraphEvidence>
      evidence;                  ///< evidence of the steps that ran; null if no frame was read, and for logs
  PagePicture view;              ///< the evidence's pixels; empty without it
  std::string explanation = {};  ///< best readings of a log with their evidence, as --explain prints them
};
using Answer = std::variant<Failure, DocumentFacts, PageThumbnail, PageSheet, FoundGraphs, ImportedGraph>;

/// The open document with the pictures made from it. One thread at a time; the import thread's.
class ImportAnswers {
 public:
  /// Answer to a query. Asking for a page before anything was opened is a programming error (checked).
  Answer answer(const Query& query, const importer::Progress& progress);

 private:
  Answer open(Result<importer::ImportSession> opened, const QString& name);
  Answer thumbnail(int page, const importer::Progress& progress);
  Answer sheet(int page, const importer::Progress& progress);
  Answer graphs(const FindGraphs& query, const importer::Progress& progress);
  Answer imported(const ImportOne& query, const importer::Progress& progress);

  std::optional<importer::ImportSession> session_;
};

}  // namespace detent::editor
