// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/document/state_name.h"

#include <QCoreApplication>

namespace detent::editor {
namespace {

struct StateName {
  Q_DECLARE_TR_FUNCTIONS(StateName)
};

}  // namespace

// Files store Detent's own state names in English.
QString nameOfState(const Button& button, std::size_t state) {
  const std::string& name = button.states()[state].name;
  if (name.empty()) return StateName::tr("State %1").arg(state + 1);
  if (name == "unlocked") return StateName::tr("unlocked");
  if (name == "locked") return StateName::tr("locked");
  return QString::fromStdString(name);
}

}  // namespace detent::editor
