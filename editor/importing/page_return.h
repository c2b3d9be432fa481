// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Finds the page of an imported button again, by name and hash, and shows it behind the curves. Its curves
// are traced again when their points are needed.

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <QObject>
#include <QPointer>
#include <QSettings>
#include <QThreadPool>
#include <set>

#include "editor/importing/placed_page.h"

namespace detent::editor {

/// The request with which the importer finds the same graph again: page, graph, quality, and the given hints
/// as far as the file keeps them (values of the axes, units, a frame, exchanged strokes, the switch chosen of
/// several; not colours and masks). The path is left empty.
importer::ImportRequest requestAgain(const Provenance& provenance);

/// A file counts as the sheet only by its contents, because name and folder prove nothing. One thread
/// searches and reads; documents may be closed meanwhile, and are never changed. A page that cannot be placed
/// by the data in the button's file (placed_page.h) is read again at once. GUI thread.
class PageReturn : public QObject {
  Q_OBJECT

 public:
  /// `places` keeps where sheets were last seen, by hash.
  explicit PageReturn(QSettings& folders, QObject* parent = nullptr);
  /// Waits for the thread.
  ~PageReturn() override;

  /// Traces the document's sheet when its points are needed.
  void attend(ButtonDocument& document);
  /// Remembers the path that a sheet was imported from.
  void remember(const Provenance& provenance, const QString& path);
  /// Searches beside the button's file and at the sheet's last location; if the sheet is missing, shows the
  /// page in the button's file. Does nothing for buttons without a sheet, and for those that have their page.
  void bringBack(ButtonDocument& document);
  /// Brings the page back from a file that a person chose.
  void bringBackFrom(ButtonDocument& document, const QString& path);

 signals:
  void returned(
      /// the page is shown, with its traced points if they were read
      detent::editor::ButtonDocument* document);
  /// The file is in none of the searched places.
  void missing(detent::editor::ButtonDocument* document, const QString& fileName);
  /// The chosen file is not the sheet, or could not be read.
  void refused(detent::editor::ButtonDocument* document, const QString& sentence);

 private:
  /// Result of the worker thread.
  struct Answer {
    QString path;  ///< path of the sheet; empty: it was not found
    std::optional<PlacedPage> page;
    std::shared_ptr<const importer::ImportReport> report;
    std::optional<Failure> failure;  ///< why the page could not be read again
  };
  /// Searches the locations and places the page. Reads it again if it cannot be placed, or if `traced` is
  /// required.
  static Answer findAndRead(const Button& button, const QStringList& folders, bool traced,
                            const std::atomic<bool>& stop);
  static void readAgain(const Button& button, Answer& answer, const importer::Progress& progress);
  void ask(ButtonDocument& document, const QStringList& folders, bool chosen);
  void trace(ButtonDocument& document);
  void start(ButtonDocument& document, const QStringList& folders, bool traced,
             std::function<void(ButtonDocument&, const Answer&)> take);
  QString lastPlaceOf(const Button& button) const;
  /// Shows the page that the button's file keeps, if the sheet is missing.
  static void showKept(ButtonDocument& document);
  void take(ButtonDocument& document, const Answer& answer, bool chosen);

  QSettings& places_;
  QThreadPool thread_;
  std::set<const ButtonDocument*> tracing_;
  std::atomic<bool> stop_ = false;
};

}  // namespace detent::editor
