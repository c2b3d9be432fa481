// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Live list of warnings about the button, each leading to its place.

#include <QLabel>
#include <QListWidget>
#include <QTimer>
#include <QWidget>
#include <vector>

#include "editor/document/button_document.h"
#include "editor/document/view_settings.h"
#include "model/validation.h"

namespace detent::editor {

/// The model's warnings, and the page's printed values beside those of the graph. GUI thread.
class ChecksPanel : public QWidget {
  Q_OBJECT

 public:
  ChecksPanel(ButtonDocument& document, ViewSettings& settings, QWidget* parent = nullptr);
  QStringList texts() const;

 signals:
  /// A check was chosen; its place as far as known.
  void placeChosen(detent::WarningPlace place);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void wantPage();
  void follow();
  void show(const std::vector<Warning>& warnings);
  void add(const QString& text, bool odd, const WarningPlace& place);

  ButtonDocument& document_;
  ViewSettings& settings_;
  QListWidget* list_;
  QLabel* nothing_;
  QTimer pause_;
  std::vector<WarningPlace> places_;
};

}  // namespace detent::editor
