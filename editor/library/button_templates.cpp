// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/library/button_templates.h"

#include <QCoreApplication>

#include "model/check.h"
#include "model/templates.h"

namespace detent::editor {
namespace {

struct Templates {
  Q_DECLARE_TR_FUNCTIONS(Templates)
};

// The defaults of a template are valid (tests/model checks them).
Button whole(Result<Button> button) {
  DETENT_CHECK(button.ok(), "a template with its default values is a valid button");
  return *std::move(button);
}

Button named(const Button& button, const QString& name) {
  auto result = Button::fromStates(name.toStdString(), button.states());
  return whole(std::move(result));
}

}  // namespace

std::vector<ButtonTemplate> buttonTemplates() {
  std::vector<ButtonTemplate> all;
  const auto add = [&](const char* id, const QString& name, const QString& description,
                       Result<Button> button) {
    all.push_back({QString::fromLatin1(id), name, description, named(whole(std::move(button)), name)});
  };
  add("linear", Templates::tr("Linear"), Templates::tr("Force rises evenly; no tactile point"),
      linearButton());
  add("tactile", Templates::tr("Tactile"), Templates::tr("One soft bump on the way down and up"),
      tactileButton());
  add("clicky", Templates::tr("Clicky"), Templates::tr("The force collapses at the tactile point"),
      clickyButton());
  add("two-level", Templates::tr("Two-level"),
      Templates::tr("Two tactile points, the second stronger, as on a camera's shutter button"),
      twoLevelButton());
  add("self-locking", Templates::tr("Self-locking"),
      Templates::tr("One press locks it down, the next press releases it; two states"), selfLockingButton());
  return all;
}

}  // namespace detent::editor
