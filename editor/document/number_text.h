// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Numbers as text, everywhere in the editor. readQuantity (editor/quantity/quantity.h) reads them back as the
// same number, in every locale.

#include <QString>

namespace detent::editor {

/// Text of a number with at most `significant` digits, with the locale's decimal sign, without group
/// separators and trailing zeros; powers of ten only beyond 1e9 and below 1e-5. All digits before the
/// decimal sign are shown.
QString numberText(double value, int significant = 5);
/// Exactly `decimals` digits after the decimal sign; never "-0".
QString fixedText(double value, int decimals);

}  // namespace detent::editor
