// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Documents of editors that died, offered once at the start.

#include "editor/window/controller_context.h"

namespace detent::editor {

/// Offers what was left behind. Nothing is discarded without a question, and no file of a dead editor is
/// removed before it is in this editor's own store. GUI thread.
class RecoveryController : public QObject {
  Q_OBJECT

 public:
  explicit RecoveryController(const ControllerContext& context, QObject* parent = nullptr);

  /// Says what was left, with a choice; nothing if nothing was.
  void offer();

 signals:
  /// A button stands in this tab again, with its unsaved changes.
  void recovered(detent::editor::DocumentTab* tab);

 private:
  void say(const QList<LeftBehind>& left);
  void discard(const QList<LeftBehind>& left);
  void recover(const QList<LeftBehind>& left);
  static void recoverInto(ButtonDocument& document, const RecoveryRecord& record);
  DocumentTab& recoverOne(const RecoveryRecord& record);

  ControllerContext at_;
};

}  // namespace detent::editor
