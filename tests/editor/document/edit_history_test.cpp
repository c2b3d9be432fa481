// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/document/edit_history.h"

#include <random>

#include <catch2/catch.hpp>

#include "model/edits.h"
#include "model/templates.h"

using namespace detent;
using namespace detent::editor;

namespace {

Button start() {
  auto button = tactileButton();
  REQUIRE(button);
  return *button;
}

Button stronger(const Button& button, double factor) {
  auto scaled = scaleForce(button, factor);
  REQUIRE(scaled);
  return *scaled;
}

}  // namespace

TEST_CASE("Undo restores exactly, redo repeats exactly, over any sequence of edits") {
  const Button first = start();
  EditHistory history(first);
  std::vector<Button> states{first};
  std::size_t at = 0;
  std::mt19937 random(7);
  for (int i = 0; i < 300; ++i) {
    const auto choice = random() % 4;
    if (choice == 0 && at > 0) {
      history.stack().undo();
      --at;
    } else if (choice == 1 && at + 1 < states.size()) {
      history.stack().redo();
      ++at;
    } else {
      states.erase(states.begin() + static_cast<std::ptrdiff_t>(at) + 1, states.end());
      states.push_back(stronger(states[at], random() % 2 ? 1.1 : 0.9));
      history.apply(states.back(), "Scale force");
      ++at;
    }
    REQUIRE(history.button() == states[at]);
  }
}

TEST_CASE("A drag is one step, whatever it previews") {
  const Button first = start();
  EditHistory history(first);
  history.beginDrag("Drag tactile point");
  for (const double factor : {1.1, 1.2, 1.3}) {
    history.preview(stronger(first, factor));
    CHECK(history.button() == stronger(first, factor));
    CHECK(history.committed() == first);
  }
  history.finishDrag();
  CHECK(history.stack().count() == 1);
  CHECK(history.stack().undoText() == "Drag tactile point");
  CHECK(history.button() == stronger(first, 1.3));
  history.stack().undo();
  CHECK(history.button() == first);
}

TEST_CASE("An unfinished drag restores, and one that ends where it began leaves no step") {
  const Button first = start();
  EditHistory history(first);
  int changes = 0;
  QObject::connect(&history, &EditHistory::changed, [&] { ++changes; });

  history.beginDrag("Drag");
  history.preview(stronger(first, 2));
  history.cancelDrag();
  CHECK(history.button() == first);
  CHECK(changes == 2);  // the preview and its end are both shown

  history.beginDrag("Drag");
  history.preview(stronger(first, 2));
  history.preview(first);
  history.finishDrag();
  CHECK(history.stack().count() == 0);
  CHECK_FALSE(history.modified());
}

TEST_CASE("Steps that change nothing are dropped; nudges of one kind become one step") {
  const Button first = start();
  EditHistory history(first);
  history.apply(first, "Nothing");
  CHECK(history.stack().count() == 0);

  history.apply(stronger(first, 1.1), "Nudge", "knot 2");
  history.apply(stronger(first, 1.2), "Nudge", "knot 2");
  CHECK(history.stack().count() == 1);
  history.apply(stronger(first, 1.3), "Nudge", "knot 3");
  CHECK(history.stack().count() == 2);
  history.stack().undo();
  history.stack().undo();
  CHECK(history.button() == first);

  history.apply(stronger(first, 1.1), "Nudge", "knot 2");
  history.apply(first, "Nudge", "knot 2");  // there and back again
  CHECK(history.stack().count() == 0);
  CHECK(history.button() == first);
}

TEST_CASE("Saved is a place in the history, not a flag") {
  EditHistory history(start());
  CHECK_FALSE(history.modified());
  history.apply(stronger(history.button(), 1.1), "Scale force");
  CHECK(history.modified());
  history.markSaved();
  history.stack().undo();
  CHECK(history.modified());
  history.stack().redo();
  CHECK_FALSE(history.modified());
}
