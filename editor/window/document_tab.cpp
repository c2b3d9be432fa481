// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/document_tab.h"

#include <QVBoxLayout>

#include "editor/canvas/graph_canvas.h"
#include "editor/panels/annotations_panel.h"
#include "editor/panels/checks_panel.h"
#include "editor/panels/history_panel.h"
#include "editor/panels/key_figures_model.h"
#include "editor/panels/key_figures_panel.h"
#include "editor/panels/selection_panel.h"
#include "editor/panels/values_model.h"
#include "editor/panels/values_panel.h"
#include "editor/tools/hit_test.h"

namespace detent::editor {

DocumentTab::DocumentTab(std::unique_ptr<ButtonDocument> document, ViewSettings& settings, QWidget* parent)
    : QWidget(parent),
      document_(std::move(document)),
      settings_(settings),
      notices_(new NoticeBar),
      workspace_(new GraphWorkspace(*document_, settings)) {
  setObjectName("documentTab");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(notices_);
  layout->addWidget(workspace_, 1);
}

DocumentTab::~DocumentTab() {
  delete values_;
  delete inspector_;
  delete history_;
  delete checks_;
  delete annotations_;
  delete workspace_;
}

QWidget* DocumentTab::valuesPanel() {
  if (!values_) {
    auto* values = new ValuesPanel(*document_, settings_, nullptr);
    values_ = values;
    // Graph and table share one selection.
    GraphCanvas& canvas = workspace_->canvas();
    connect(values, &ValuesPanel::markChosen, &canvas, &GraphCanvas::setSelected);
    connect(&canvas, &GraphCanvas::selectionChanged, values,
            [values, &canvas] { values->showMark(canvas.selected()); });
    connect(&values->model(), &QAbstractItemModel::modelReset, values,
            [values, &canvas] { values->showMark(canvas.selected()); });
  }
  return values_;
}

QWidget* DocumentTab::inspector() {
  if (!inspector_) {
    auto* selection = new SelectionPanel(*document_, settings_);
    auto* figures = new KeyFiguresPanel(*document_, settings_);
    inspector_ = new QWidget;
    auto* column = new QVBoxLayout(inspector_);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    column->addWidget(selection);
    column->addWidget(figures, 1);
    inspector_->setFocusProxy(figures);
    GraphCanvas& canvas = workspace_->canvas();
    connect(&canvas, &GraphCanvas::selectionChanged, selection,
            [selection, &canvas] { selection->showMark(canvas.selected()); });
    selection->showMark(canvas.selected());
    connect(workspace_, &GraphWorkspace::valuesRequested, this, [this, selection](FirstValue first) {
      emit inspectorWanted();
      if (!selection->edit(first)) emit workspace_->statusMessage(tr("Select a point to type its values."));
    });
    connect(selection, &SelectionPanel::edited, workspace_, qOverload<>(&QWidget::setFocus));
    connect(figures, &KeyFiguresPanel::contactsRequested, this, [this] {
      for (QAction* action : workspace_->editActions())
        if (action->objectName() == QLatin1String("operationContacts")) action->trigger();
    });
    connect(&figures->model(), &KeyFiguresModel::previewChanged, this,
            [this, figures] { workspace_->canvas().showPreview(figures->model().preview()); });
  }
  return inspector_;
}

QWidget* DocumentTab::checksPanel() {
  if (!checks_) {
    auto* checks = new ChecksPanel(*document_, settings_, nullptr);
    checks_ = checks;
    connect(checks, &ChecksPanel::placeChosen, this, &DocumentTab::showPlace);
  }
  return checks_;
}

// Selects the mark at a place, or the section around it, and scrolls to it.
void DocumentTab::showPlace(const WarningPlace& place) {
  if (place.state && *place.state < document_->button().states().size())
    document_->setActiveState(*place.state);
  if (!place.at_mm) return;
  GraphCanvas& canvas = workspace_->canvas();
  const Stroke stroke = place.stroke.value_or(Stroke::press);
  std::optional<MarkId> there;
  for (const Mark& mark : pointMarks(canvas.state(), canvas.values()))
    if (!there && mark.id.stroke == stroke && mark.at.displacement_mm == *place.at_mm) there = mark.id;
  if (const auto section = sectionAt(canvas.values().of(stroke), *place.at_mm); !there && section)
    there = MarkId{MarkKind::section, stroke, *section};
  canvas.setSelected(there);
  const double force_N = canvas.state().graph.curve(stroke).force_N(*place.at_mm);
  if (!canvas.shownRange().contains(*place.at_mm, force_N)) canvas.fit();
}

QWidget* DocumentTab::annotationsPanel() {
  if (!annotations_) {
    auto* annotations = new AnnotationsPanel(*document_, settings_, workspace_->canvas());
    annotations_ = annotations;
    connect(annotations, &AnnotationsPanel::said, workspace_, &GraphWorkspace::statusMessage);
    connect(annotations, &AnnotationsPanel::versionOpened, this, &DocumentTab::versionOpened);
  }
  return annotations_;
}

QWidget* DocumentTab::historyPanel() {
  if (!history_) history_ = new HistoryPanel(*document_, nullptr);
  return history_;
}

}  // namespace detent::editor
