// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Presses the button that is being edited, and shows how it will feel.

#include <array>
#include <QVariantMap>
#include <QWidget>

#include "editor/document/view_settings.h"
#include "editor/feel/feel_session.h"

class QAction;
class QBoxLayout;
class QLabel;
class QToolButton;

namespace detent::editor {

class FeelSetup;
class ForceSetup;
class PressPad;
class PressStrip;
class SignalView;

/// Shows a session and takes presses: a pad for mouse, keys, pen and touch; the vibration and spectrogram of
/// a press; sound and force device; the setup. A and B are exchanged by one key. GUI thread.
class FeelPanel : public QWidget {
  Q_OBJECT

 public:
  /// `settings` and `session` must outlive it.
  FeelPanel(ViewSettings& settings, FeelSession& session, QWidget* parent = nullptr);

  /// Exchanges A and B (X), for menus and the list of shortcuts.
  QAction* exchangeAction() const { return exchange_; }

  /// Lets the keys press the button from now on.
  void takeKeys();

  /// The choices of the session and of the panel.
  QVariantMap saveState() const;
  void restoreState(const QVariantMap& state);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* padColumn(ViewSettings& settings);
  QWidget* viewColumn();
  QWidget* controlColumn(ViewSettings& settings);
  QWidget* setupPage(ViewSettings& settings);
  QLayout* choiceRow();
  QLayout* pressRow();
  QLayout* referenceRow();
  QAction* ownAction(const char* name, const QString& text, const QString& tip, Qt::Key key);
  QToolButton* buttonOf(QAction* action, const char* name, const QString& text);
  void connectPad();
  void connectSession();
  void layOut();
  void showPair();
  void writeNames();
  void showFelt();
  void showPad();
  void showPresses();
  void showReference();
  void showScale();
  void chooseReference();
  void showSettings();
  void follow();
  void showEvents(const std::vector<playback::EngineEvent>& events);

  FeelSession& session_;
  double lastPressed_s_ = 0;

  QBoxLayout* sections_ = nullptr;
  PressPad* pad_ = nullptr;
  PressStrip* strip_ = nullptr;
  SignalView *view_ = nullptr, *referenceView_ = nullptr;
  FeelSetup* setup_ = nullptr;
  ForceSetup* forceSetup_ = nullptr;
  QWidget* setupPage_ = nullptr;
  std::array<QToolButton*, 2> choices_{};
  QToolButton *setupToggle_ = nullptr, *standardPress_ = nullptr, *myPress_ = nullptr,
              *referenceChoice_ = nullptr, *referencePlay_ = nullptr, *noReference_ = nullptr;
  QLabel* referenceNote_ = nullptr;
  QAction *exchange_ = nullptr, *play_ = nullptr, *playReference_ = nullptr;
};

}  // namespace detent::editor
