// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The page of a button that was imported once: found again by name and hash, and put behind the curves. Its
// curves are traced again where somebody wants the points.

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

/// A file is the sheet only if its contents are: name and folder alone prove nothing. One thread of its own
/// searches and reads; documents may be closed meanwhile, and are never changed. A page that cannot be laid
/// behind the curves by the file's data (placed_page.h) is read again at once. GUI thread.
class PageReturn : public QObject {
  Q_OBJECT

 public:
  /// `places` keeps where sheets were last seen, by hash.
  explicit PageReturn(QSettings& folders, QObject* parent = nullptr);
  /// Waits for the thread.
  ~PageReturn() override;

  /// Traces the document's sheet when somebody wants the points.
  void attend(ButtonDocument& document);
  /// Remembers the path that a sheet was imported from.
  void remember(const Provenance& provenance, const QString& path);
  /// Searches beside the button's file and at the sheet's last location; else shows the page that the file
  /// keeps. Nothing for buttons that came from no sheet, and for those that have their page.
  void bringBack(ButtonDocument& document);
  /// Brings the page back from a file that a person chose.
  void bringBackFrom(ButtonDocument& document, const QString& path);

 signals:
  void returned(
      detent::editor::ButtonDocument* document);  ///< the page; the traced points too where they were read
  /// The file lies in none of the searched places.
  void missing(detent::editor::ButtonDocument* document, const QString& fileName);
  /// The chosen file is another one, or could not be read this time.
  void refused(detent::editor::ButtonDocument* document, const QString& sentence);

 private:
  /// Result of the thread.
  struct Answer {
    QString path;  ///< of the sheet; empty: none of the places held it
    std::optional<PlacedPage> page;
    std::shared_ptr<const importer::ImportReport> report;
    std::optional<Failure> failure;  ///< why the page could not be read again
  };
  /// Searches the locations, lays the page, and reads it again if that cannot be done or `traced` is wanted.
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
