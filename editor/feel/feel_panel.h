// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Press the button one edits, and see what it will feel like.

#include <memory>
#include <optional>
#include <QVariantMap>
#include <QWidget>

#include "editor/document/button_document.h"
#include "editor/document/finger_position.h"
#include "editor/document/view_settings.h"
#include "editor/feel/feel_devices.h"

class QAction;

namespace detent::editor {

/// A pad to press with mouse, keys, pen, touch or a force sensor; the vibration and spectrogram of a standard
/// press; the sound device. Two buttons, A and B, are exchanged under the finger by one key. No sound device
/// is touched before the first press. Without one everything but the sound works. GUI thread.
class FeelPanel : public QWidget {
  Q_OBJECT

 public:
  explicit FeelPanel(ViewSettings& settings, QWidget* parent = nullptr, const FeelDevices& devices = {});
  ~FeelPanel() override;

  /// A, the button being edited; may be null. Must outlive its use here or be destroyed as a QObject.
  void setDocument(ButtonDocument* document);
  /// B, to compare with; may be null.
  void setOther(ButtonDocument* other);
  /// The one that is pressed now: A, or B after an exchange.
  ButtonDocument* feltDocument() const;
  /// From A to B and back; nothing where one of them is missing.
  void exchange();
  /// The same as an action (X), for menus and the list of shortcuts.
  QAction* exchangeAction() const;

  /// Choices that outlive a run (device, gain, drive, placement ...), as plain text and numbers. Restoring
  /// opens no device: sound begins with the next press, the sensor is offered.
  QVariantMap saveState() const;
  void restoreState(const QVariantMap& state);

 signals:
  /// Where the finger stands on A's graph, at least 60 times a second while it presses; nullopt when it has
  /// left, and while B is pressed.
  void fingerMoved(std::optional<detent::editor::FingerPosition> position);
  /// The same for B.
  void otherFingerMoved(std::optional<detent::editor::FingerPosition> position);
  void feltDocumentChanged(detent::editor::ButtonDocument* document);
  void statusMessage(const QString& message);

 protected:
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace detent::editor
