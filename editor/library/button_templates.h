// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Templates for new buttons, with the words by which a designer chooses them.

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

/// All templates (model/templates.h), from plain to complex.
std::vector<ButtonTemplate> buttonTemplates();

}  // namespace detent::editor
