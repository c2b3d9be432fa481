// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A press of a self-locking button begins in one of its states.

#include <cstddef>

#include "model/button.h"

namespace detent::editor {

/// The button with that state first, as programs begin; a state it does not have: as it is. Any thread.
Button begunIn(const Button& button, std::size_t state);

}  // namespace detent::editor
