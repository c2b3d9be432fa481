// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// "New": choose the button to start from.

#include <optional>
#include <QDialog>
#include <QListWidget>
#include <vector>

#include "editor/library/button_templates.h"

namespace detent::editor {

/// Modal. GUI thread.
class TemplateDialog : public QDialog {
  Q_OBJECT

 public:
  explicit TemplateDialog(QWidget* parent = nullptr);
  /// The template chosen when the dialogue was accepted.
  const ButtonTemplate& chosen() const;
  void choose(const QString& id);

 private:
  std::vector<ButtonTemplate> templates_;
  QListWidget* list_ = nullptr;
};

}  // namespace detent::editor
