// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The steps of a document as a list; a click goes to a step.

#include <QWidget>

#include "editor/document/button_document.h"

class QUndoView;

namespace detent::editor {

/// GUI thread. `document` must outlive it.
class HistoryPanel : public QWidget {
  Q_OBJECT

 public:
  explicit HistoryPanel(ButtonDocument& document, QWidget* parent = nullptr);

 private:
  QUndoView* view_;
};

}  // namespace detent::editor
