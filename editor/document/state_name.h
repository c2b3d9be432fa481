// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Name of a button state among others.

#include <QString>

#include "model/button.h"

namespace detent::editor {

/// Name of a state, translated if Detent gave it, or its number. `state` < number of states.
QString nameOfState(const Button& button, std::size_t state);

}  // namespace detent::editor
