// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/document/button_document.h"

#include <algorithm>
#include <QDir>
#include <QFileInfo>
#include <QUndoCommand>

#include "model/check.h"
#include "model/links.h"

namespace detent::editor {
namespace {

QImage imageOf(const importer::Raster& raster) {
  const QImage view(raster.rgb.data(), raster.width_px, raster.height_px, 3 * qsizetype(raster.width_px),
                    QImage::Format_RGB888);
  return view.copy();
}

// Annotations before and after.
class AnnotationStep : public QUndoCommand {
 public:
  AnnotationStep(ButtonDocument& document, Annotations next, const QString& label)
      : QUndoCommand(label), document_(document), before_(document.annotations()), after_(std::move(next)) {}
  void undo() override { document_.setAnnotations(before_); }
  void redo() override { document_.setAnnotations(after_); }

 private:
  ButtonDocument& document_;
  Annotations before_, after_;
};

}  // namespace

QTransform transformOf(const std::array<double, 9>& rows) {
  return {rows[0], rows[3], rows[6], rows[1], rows[4], rows[7], rows[2], rows[5], rows[8]};
}

ButtonDocument::ButtonDocument(Button button, QObject* parent)
    : QObject(parent), history_(std::move(button)) {
  history_.setRule([this](const Button& before, const Button& next) {
    return keptLinks(before, next, annotations_.links);
  });
  connect(&history_, &EditHistory::changed, this, [this] {
    emit changed();
    emit titleChanged();
  });
  connect(&history_.stack(), &QUndoStack::cleanChanged, this, &ButtonDocument::titleChanged);
}

// A destroyed undo stack signals that it is clean; nothing may then ask a partly destroyed document for its
// title.
ButtonDocument::~ButtonDocument() { history_.stack().disconnect(this); }

// Undo can remove the active second state.
std::size_t ButtonDocument::activeState() const {
  return std::min(activeState_, button().states().size() - 1);
}

void ButtonDocument::setActiveState(std::size_t state) {
  DETENT_CHECK(state < button().states().size(), "the active state is one of the button's");
  if (state == activeState_) return;
  activeState_ = state;
  emit activeStateChanged();
}

void ButtonDocument::setPath(const QString& path) {
  if (path == path_) return;
  path_ = path;
  emit titleChanged();
}

QString ButtonDocument::title() const {
  if (!path_.isEmpty()) {
    const QString name = QFileInfo(path_).fileName();
    return name.endsWith(QLatin1String(".button.json")) ? name.chopped(12)
                                                        : QFileInfo(path_).completeBaseName();
  }
  const QString name = QString::fromStdString(button().name());
  return name.isEmpty() ? tr("Untitled") : name;
}

void ButtonDocument::setOrigin(std::shared_ptr<const importer::ImportReport> origin) {
  origin_ = std::move(origin);
  emit originChanged();
}

void ButtonDocument::setSheet(std::optional<PlacedPage> sheet) {
  sheet_ = std::move(sheet);
  emit originChanged();
}

std::optional<PlacedPage> ButtonDocument::page() const {
  if (!origin_ || !origin_->evidence || origin_->evidence->view.raster.empty()) return sheet_;
  const importer::GraphEvidence& evidence = *origin_->evidence;
  return PlacedPage{imageOf(evidence.view.raster),
                    transformOf(evidence.axes.calibration.value.viewToUnits.m)};
}

void ButtonDocument::setCutout(std::optional<PageCutout> cutout) {
  if (cutout == cutout_) return;
  cutout_ = std::move(cutout);
  emit cutoutChanged();
}

void ButtonDocument::setAnnotations(Annotations annotations) {
  if (annotations == annotations_) return;
  annotations_ = std::move(annotations);
  emit annotationsChanged();
}

void ButtonDocument::annotate(Annotations next, const QString& label) {
  DETENT_CHECK(!history_.dragging(), "nothing is annotated in the middle of a drag");
  if (next != annotations_) history_.stack().push(new AnnotationStep(*this, std::move(next), label));
}

void ButtonDocument::wantOrigin() {
  if (originOnDemand()) emit originWanted();
}

QStringList distinctTitles(const std::vector<ButtonDocument*>& documents) {
  QStringList titles;
  for (const ButtonDocument* document : documents) titles << document->title();
  enum Mark { file, folder, number };
  for (const Mark mark : {file, folder, number}) {
    const QStringList before = titles;
    for (qsizetype i = 0; i < before.size(); ++i) {
      if (before.count(before[i]) == 1) continue;
      const ButtonDocument& document = *documents[static_cast<std::size_t>(i)];
      const QFileInfo path(document.path());
      QString words = document.path().isEmpty() ? ButtonDocument::tr("not saved")
                      : mark == file            ? path.fileName()
                                                : path.dir().dirName() + '/' + path.fileName();
      if (mark == number)
        words = QStringLiteral("%1, %2").arg(words).arg(before.first(i + 1).count(before[i]));
      titles[i] = QStringLiteral("%1 (%2)").arg(document.title(), words);
    }
  }
  return titles;
}

}  // namespace detent::editor
