// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Operations on a graph, each as fields and a pure edit (operation_dialog.h shows them).

#include <optional>

#include "editor/canvas/graph_marks.h"
#include "editor/panels/operation_dialog.h"

namespace detent::editor {

/// Start values of an operation.
struct OperationTarget {
  const Button& button;
  std::size_t state;
  const GraphValues& values;       ///< values of the active state
  std::optional<MarkId> selected;  ///< the operation's dialogue begins with this stroke and tactile point
  const importer::ImportReport* origin = nullptr;
  bool originOnDemand = false;  ///< the origin can be read on request

  const ForceGraph& graph() const { return button.states()[state].graph; }
};

Operation addJumpOperation(const OperationTarget& target);
Operation removeJumpOperation(const OperationTarget& target);  ///< needs a tactile point
Operation makeLinearOperation(const OperationTarget& target);
Operation mirrorOperation(const OperationTarget& target);
Operation removeReleaseOperation(const OperationTarget& target);  ///< needs a release curve
Operation scaleForceOperation(const OperationTarget& target);
Operation scaleTravelOperation(const OperationTarget& target);
Operation snapRatioOperation(const OperationTarget& target);  ///< needs a tactile point of the press
Operation refitOperation(const OperationTarget& target);      ///< needs an origin
Operation contactsOperation(const OperationTarget& target);
Operation dampingOperation(const OperationTarget& target);
Operation twoLevelOperation(const OperationTarget& target);
Operation selfLockingOperation(const OperationTarget& target);
Operation addStateOperation(const OperationTarget& target);     ///< needs a momentary button
Operation removeStateOperation(const OperationTarget& target);  ///< needs two states

}  // namespace detent::editor
