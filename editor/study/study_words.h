// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Failures of a study in the words of its windows.

#include <QString>

#include "model/result.h"

namespace detent::editor {

/// As sentenceOf(), with the name of the window's field instead of the program's option.
QString studySentence(Failure failure);

}  // namespace detent::editor
