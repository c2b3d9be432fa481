// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tries the choices of a question before it is put to a person.

#include <functional>
#include <optional>

#include "importer/importer.h"

namespace detent::importer {

/// The question with the choices that lead to an accepted result; `isAccepted` tries each with its hints.
/// nullopt if none does, or if the work was cancelled.
std::optional<Question> withAcceptedChoices(const Question& question, const ImportRequest& request,
                                            const Progress& progress,
                                            const std::function<bool(const ImportRequest&)>& isAccepted);

}  // namespace detent::importer
