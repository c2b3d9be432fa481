// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/document/begun_in.h"

#include <algorithm>

namespace detent::editor {

Button begunIn(const Button& button, std::size_t state) {
  std::vector<ButtonState> states = button.states();
  if (state == 0 || state >= states.size()) return button;
  std::rotate(states.begin(), states.begin() + static_cast<std::ptrdiff_t>(state), states.end());
  return Button::fromStates(button.name(), std::move(states), button.provenance()).value();
}

}  // namespace detent::editor
