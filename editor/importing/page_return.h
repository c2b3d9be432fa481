// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The page of a button that was imported once: found again by name and hash, read again, and put behind the
// curves, with its traced points.

#include <atomic>
#include <memory>
#include <optional>
#include <QObject>
#include <QPointer>
#include <QSettings>
#include <QThreadPool>

#include "editor/document/button_document.h"

namespace detent::editor {

/// What the importer is asked so that it finds again what it found then: page, graph, quality, and what was
/// given by hand as far as the file keeps it (values of the axes, units, a frame, exchanged strokes; not
/// colours and masks). The path is left empty.
importer::ImportRequest requestAgain(const Provenance& provenance);

/// A file is the sheet only if its contents are: name and place alone prove nothing. One thread of its own
/// looks and reads; documents may be closed meanwhile. GUI thread.
class PageReturn : public QObject {
  Q_OBJECT

 public:
  /// `places` keeps where sheets were last seen, by hash.
  explicit PageReturn(QSettings& places, QObject* parent = nullptr);
  /// Waits for the thread.
  ~PageReturn() override;

  /// Where a sheet was imported from.
  void remember(const Provenance& provenance, const QString& path);
  /// Looks beside the button's file and where the sheet was last; nothing for buttons that came from no sheet,
  /// and for those that have their page.
  void bringBack(ButtonDocument& document);
  /// From a file that a person chose.
  void bringBackFrom(ButtonDocument& document, const QString& path);

 signals:
  void returned(detent::editor::ButtonDocument* document);
  /// Nowhere it could be.
  void missing(detent::editor::ButtonDocument* document, const QString& fileName);
  /// The chosen file is another one, or could not be read this time.
  void refused(detent::editor::ButtonDocument* document, const QString& sentence);

 private:
  /// What the thread came to.
  struct Answer {
    QString path;  ///< of the sheet; empty: none of the places held it
    std::shared_ptr<const importer::ImportReport> report;
    std::optional<Failure> failure;  ///< of reading it again
  };
  static Answer lookAndRead(const Button& button, const QStringList& places, const std::atomic<bool>& stop);
  void ask(ButtonDocument& document, const QStringList& places, bool chosen);
  void take(ButtonDocument& document, const Answer& answer, bool chosen);

  QSettings& places_;
  QThreadPool thread_;
  std::atomic<bool> stop_ = false;
};

}  // namespace detent::editor
