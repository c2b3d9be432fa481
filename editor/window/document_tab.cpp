// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/document_tab.h"

#include <QVBoxLayout>

#include "editor/canvas/graph_canvas.h"
#include "editor/panels/history_panel.h"
#include "editor/panels/values_panel.h"

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
  delete history_;
  delete workspace_;
}

QWidget* DocumentTab::valuesPanel() {
  if (!values_) {
    auto* values = new ValuesPanel(*document_, settings_, nullptr);
    values_ = values;
    // One selection: what is picked in the graph is picked in the table, and the other way round.
    GraphCanvas& canvas = workspace_->canvas();
    connect(values, &ValuesPanel::markChosen, &canvas, &GraphCanvas::setSelected);
    connect(&canvas, &GraphCanvas::selectionChanged, values,
            [values, &canvas] { values->showMark(canvas.selected()); });
  }
  return values_;
}

QWidget* DocumentTab::historyPanel() {
  if (!history_) history_ = new HistoryPanel(*document_, nullptr);
  return history_;
}

}  // namespace detent::editor
