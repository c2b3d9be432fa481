// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One open button: its history, its file, the page it came from, and which of its states is worked on.

#include <array>
#include <memory>
#include <optional>
#include <QByteArray>
#include <QImage>
#include <QObject>
#include <QString>
#include <QTransform>

#include "editor/document/edit_history.h"
#include "importer/importer.h"
#include "model/annotations.h"
#include "model/file/page_cutout.h"

namespace detent::editor {

/// A datasheet page as it lies behind the curves. Plain value.
struct PlacedPage {
  QImage picture;
  QTransform pixelToAxes;  ///< from pixel centres (0,0 top left) to mm and N; may be projective
  bool readable = true;    ///< reading it again may give traced points; false once that has failed
};

/// Of a projective map written row by row for column vectors, as the importer and button files have it.
QTransform transformOf(const std::array<double, 9>& rows);

/// What a tab shows. Views draw its values and listen to its signals; only tools and operations call
/// `history()`. GUI thread.
class ButtonDocument : public QObject {
  Q_OBJECT

 public:
  explicit ButtonDocument(Button button, QObject* parent = nullptr);
  ~ButtonDocument() override;

  EditHistory& history() { return history_; }
  const EditHistory& history() const { return history_; }
  /// What is shown now, running drag included.
  const Button& button() const { return history_.button(); }

  /// The state that canvas, tools and panels work on; always one the button has.
  std::size_t activeState() const;
  void setActiveState(std::size_t state);
  const ForceGraph& graph() const { return button().states()[activeState()].graph; }

  /// Absolute; empty for a button that was never saved.
  const QString& path() const { return path_; }
  void setPath(const QString& path);
  /// Hash of what the file held when it was last read or written here; empty where there was none. Whoever
  /// writes compares it with the disk first (files/document_files.h).
  const QByteArray& knownContent() const { return knownContent_; }
  void setKnownContent(const QByteArray& hash) { knownContent_ = hash; }
  /// File name without suffixes, else the button's name, else "Untitled".
  QString title() const;

  /// Page, traced points and confidence of the import this button came from; null without one, and for
  /// buttons opened from a file until their sheet was read again. Shared and never changed.
  const std::shared_ptr<const importer::ImportReport>& origin() const { return origin_; }
  void setOrigin(std::shared_ptr<const importer::ImportReport> origin);
  /// The page alone, of a button opened from a file whose sheet was found; nothing was traced on it yet.
  const std::optional<PlacedPage>& sheet() const { return sheet_; }
  void setSheet(std::optional<PlacedPage> sheet);
  /// What lies behind the curves, of the import or of the sheet; nothing where there is neither.
  std::optional<PlacedPage> page() const;
  /// The page as the file keeps it, or will when it is saved; empty unless a person chose that.
  const std::optional<PageCutout>& cutout() const { return cutout_; }
  void setCutout(std::optional<PageCutout> cutout);
  /// Remarks, named versions and links, as the file keeps them.
  const Annotations& annotations() const { return annotations_; }
  /// As they were read; no step.
  void setAnnotations(Annotations annotations);
  /// One step that can be undone; nothing where they are the same. Not during a drag.
  void annotate(Annotations next, const QString& label);
  /// There is no origin, but reading the sheet again would give one.
  bool originOnDemand() const { return sheet_ && sheet_->readable && !origin_; }
  /// Whoever needs traced points or printed values says so; they come as `originChanged`, if they can be had.
  void wantOrigin();

 signals:
  /// The button (or its preview) is another value now.
  void changed();
  void activeStateChanged();
  void originChanged();  ///< origin or sheet
  void cutoutChanged();
  void annotationsChanged();
  void originWanted();  ///< by wantOrigin, where it is on demand
  /// Path, name or unsaved mark.
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

}  // namespace detent::editor
