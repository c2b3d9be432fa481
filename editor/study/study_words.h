// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Failures of a study as its windows say them.

#include <QString>

#include "model/result.h"

namespace detent::editor {

/// sentenceOf(), with the field of the window in place of the program's option.
QString studySentence(Failure failure);

}  // namespace detent::editor
