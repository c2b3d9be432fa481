// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Lets the user choose the open buttons that are averaged.

#include <optional>
#include <QDialog>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QStringList>
#include <vector>

#include "editor/document/display_units.h"
#include "model/unit_spread.h"

namespace detent::editor {

/// At first, the buttons of the current one's kind are ticked: those with as many states and tactile points.
/// Buttons of different kinds have no average. Works on copies. GUI thread.
class AverageDialog : public QDialog {
  Q_OBJECT

 public:
  /// `buttons` and `titles`: equally many, one or more; `current` is one of them.
  AverageDialog(std::vector<Button> buttons, const QStringList& titles, std::size_t current,
                const DisplayUnits& units, QWidget* parent = nullptr);

  /// The average of the ticked buttons; empty while there is none.
  const std::optional<UnitSpread>& spread() const { return spread_; }
  /// Titles of the ticked buttons, in the order of `UnitSpread`'s units.
  QStringList titles() const;

 private:
  void follow();

  std::vector<Button> buttons_;
  DisplayUnits units_;
  QListWidget* list_;
  QLabel* why_;
  QPushButton* create_;
  std::optional<UnitSpread> spread_;
};

}  // namespace detent::editor
