// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Buttons to start from, with the words a designer chooses them by.

#include <QString>
#include <vector>

#include "model/button.h"

namespace detent::editor {

/// One entry of "New from template".
struct ButtonTemplate {
  QString id;           ///< stable: "linear", "tactile", ...
  QString name;         ///< "Tactile"
  QString description;  ///< one line
  Button button;
};

/// model/templates.h, from the plain to the rich.
std::vector<ButtonTemplate> buttonTemplates();

}  // namespace detent::editor
