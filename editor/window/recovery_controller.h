// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Offers the documents of editors that have crashed, once at the start.

#include "editor/window/controller_context.h"

namespace detent::editor {

/// Nothing is discarded without a question, and no file of a crashed editor is removed before its document is
/// in this editor's own store. GUI thread.
class RecoveryController : public QObject {
  Q_OBJECT

 public:
  explicit RecoveryController(const ControllerContext& context, QObject* parent = nullptr);

  /// Shows a notice with the documents that were left and a choice; nothing if there are none.
  void offer();

 signals:
  /// A button is open in this tab again, with its unsaved changes.
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
