// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Switches force on and off, and shows its meters and whether the device can render the button.

#include <QWidget>

#include "editor/document/view_settings.h"
#include "editor/feel/force_session.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace detent::editor {

class ForceMeter;

/// Shows a force session and starts and stops it. GUI thread.
class ForceBox : public QWidget {
  Q_OBJECT

 public:
  /// Both must outlive it.
  ForceBox(ViewSettings& settings, ForceSession& session, QWidget* parent = nullptr);

 private:
  void showState();
  void showMeters();
  void showMargin();
  QString stateWords() const;

  ViewSettings& settings_;
  ForceSession& session_;
  QToolButton* force_ = nullptr;
  ForceMeter* meter_ = nullptr;
  QLabel *status_ = nullptr, *stability_ = nullptr;
  QPushButton* stable_ = nullptr;
};

}  // namespace detent::editor
