// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a state of a button is called beside the others.

#include <QString>

#include "model/button.h"

namespace detent::editor {

/// Its own name, in the person's language where Detent gave it, or the number it has. `state` < the button's states.
QString nameOfState(const Button& button, std::size_t state);

}  // namespace detent::editor
