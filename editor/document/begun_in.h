// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// First state of a press of a self-locking button.

#include <cstddef>

#include "model/button.h"

namespace detent::editor {

/// The button with that state first; unchanged if it has no such state. Any thread.
Button begunIn(const Button& button, std::size_t state);

}  // namespace detent::editor
