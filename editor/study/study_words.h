// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Failures of a study as its windows say them.

#include <QString>

#include "model/result.h"

namespace detent::editor {

/// sentenceOf(), where an option of the program is named as the field of maker or desk that asks for the
/// same.
QString studySentence(Failure failure);

}  // namespace detent::editor
