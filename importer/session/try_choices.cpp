// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/session/try_choices.h"

#include <sstream>
#include <string>

namespace detent::importer {

bool takeUp(const Choice& choice, ImportHints& hints) {
  std::istringstream words(choice.option);
  for (std::string name, value; words >> name;) {
    if (name == "--no-release") {
      hints.strokes.noRelease = true;
      continue;
    }
    if (!(words >> value)) return false;
    if (name == "--record" || name == "--curve")
      hints.strokes.curve = value;
    else if (name == "--press-color")
      hints.trace.pressColor = colorFrom(value);
    else if (name == "--release-color")
      hints.trace.releaseColor = colorFrom(value);
    else if (name == "--x-unit")
      hints.axes.xUnit = lengthUnitFrom(value);
    else if (name == "--y-unit")
      hints.axes.yUnit = forceUnitFrom(value);
    else if (name == "--displacement-column")
      hints.columns.displacement = value;
    else if (name == "--force-column")
      hints.columns.force = value;
    else if (name == "--release-displacement-column")
      hints.columns.releaseDisplacement = value;
    else if (name == "--release-force-column")
      hints.columns.releaseForce = value;
    else
      return false;
  }
  return true;
}

std::optional<Question> withAcceptedChoices(const Question& question, const ImportRequest& request,
                                            const Progress& progress,
                                            const std::function<bool(const ImportRequest&)>& isAccepted) {
  Question left{question.what, {}};
  for (const auto& choice : question.choices) {
    ImportRequest answered = request;
    answered.acceptDoubt = false;
    if (progress.isCancelled()) return {};
    if (takeUp(choice, answered.hints) && isAccepted(answered)) left.choices.push_back(choice);
  }
  if (left.choices.empty()) return {};
  return left;
}

}  // namespace detent::importer
