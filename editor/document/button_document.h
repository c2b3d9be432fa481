// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One open button: its history, file, page, and active state.

#include <array>
#include <memory>
#include <optional>
#include <QByteArray>
#include <QImage>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QTransform>
#include <vector>

#include "editor/document/edit_history.h"
#include "importer/importer.h"
#include "model/annotations.h"
#include "model/file/page_cutout.h"

namespace detent::editor {

/// A datasheet page behind the curves. Plain value.
struct PlacedPage {
  QImage picture;
  QTransform pixelToAxes;  ///< from pixel centres (0,0 top left) to mm and N; may be projective
  bool readable = true;    ///< reading it again may give traced points; false after that failed
};

/// Transform of a projective map written row by row for column vectors, as in importer and button files.
QTransform transformOf(const std::array<double, 9>& rows);

/// Content of a tab. Views draw its values and connect to its signals; only tools and operations call
/// `history()`. GUI thread.
class ButtonDocument : public QObject {
  Q_OBJECT

 public:
  explicit ButtonDocument(Button button, QObject* parent = nullptr);
  ~ButtonDocument() override;

  EditHistory& history() { return history_; }
  const EditHistory& history() const { return history_; }
  /// The shown button, including a running drag.
  const Button& button() const { return history_.button(); }

  /// The state that canvas, tools and panels work on; always valid.
  std::size_t activeState() const;
  void setActiveState(std::size_t state);
  const ForceGraph& graph() const { return button().states()[activeState()].graph; }

  /// Absolute; empty for a button that was never saved.
  const QString& path() const { return path_; }
  void setPath(const QString& path);
  /// Hash of the file when it was last read or written here; empty if there was none. Writers compare it with
  /// the disk first (files/document_files.h).
  const QByteArray& knownContent() const { return knownContent_; }
  void setKnownContent(const QByteArray& hash) { knownContent_ = hash; }
  /// File name without suffixes, else the button's name, else "Untitled".
  QString title() const;

  /// Page, traced points and confidence of the import; null without one, and for buttons opened from a file
  /// until their sheet was read again. Shared and immutable.
  const std::shared_ptr<const importer::ImportReport>& origin() const { return origin_; }
  void setOrigin(std::shared_ptr<const importer::ImportReport> origin);
  /// The page of a button opened from a file whose sheet was found, without traced points.
  const std::optional<PlacedPage>& sheet() const { return sheet_; }
  void setSheet(std::optional<PlacedPage> sheet);
  /// The page behind the curves, of the import or the sheet; nullopt without either.
  std::optional<PlacedPage> page() const;
  /// The page stored in the file, now or at the next save; nullopt unless the user chose that.
  const std::optional<PageCutout>& cutout() const { return cutout_; }
  void setCutout(std::optional<PageCutout> cutout);
  /// Remarks, named versions and links of the file.
  const Annotations& annotations() const { return annotations_; }
  /// Sets annotations as read; no undo step.
  void setAnnotations(Annotations annotations);
  /// Makes one undo step, unless nothing changes. Not during a drag.
  void annotate(Annotations next, const QString& label);
  /// Returns true if there is no origin, but reading the sheet again would give one.
  bool originOnDemand() const { return sheet_ && sheet_->readable && !origin_; }
  /// Requests traced points or printed values; they arrive with `originChanged`, if available.
  void wantOrigin();

 signals:
  /// The button or its preview changed.
  void changed();
  void activeStateChanged();
  void originChanged();  ///< The origin or the sheet changed.
  void cutoutChanged();
  void annotationsChanged();
  void originWanted();  ///< emitted by wantOrigin if the origin must be read
  /// The path, the name or the unsaved mark changed.
  void titleChanged();

 private:
  EditHistory history_;
  std::size_t activeState_ = 0;
  QString path_;
  QByteArray knownContent_;
  std::shared_ptr<const importer::ImportReport> origin_;
  std::optional<PlacedPage> sheet_;
  std::optional<PageCutout> cutout_;
  Annotations annotations_;
};

/// Titles of open buttons, in their order. Equal ones are followed by the name of their file, then of its
/// folder, or by "not saved", then by a number in this order.
QStringList distinctTitles(const std::vector<ButtonDocument*>& documents);

}  // namespace detent::editor
