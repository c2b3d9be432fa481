// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/quantity/reading_error.h"

#include <algorithm>
#include <cmath>

namespace detent::editor {

std::optional<DisplayUnits> unitsOfPage(const Button& button) {
  const auto& from = button.provenance();
  if (!from || !from->xAxis || !from->yAxis) return {};
  const auto length = lengthUnitFrom(from->xAxis->unit);
  const auto force = forceUnitFrom(from->yAxis->unit);
  if (!length || !force) return {};
  return DisplayUnits{*length, *force};
}

std::optional<ReadingError> readingErrorOf(const Button& button) {
  const auto& from = button.provenance();
  const auto units = unitsOfPage(button);
  if (!units || from->frame.size() != 4) return {};
  const double width = from->frame[2] - from->frame[0], height = from->frame[3] - from->frame[1];
  if (!(width > 0 && height > 0)) return {};
  // Documents are rendered with a frame of about this width; the unit of a picture's frame is its pixel.
  constexpr double renderedFrame_px = 1000;
  const QString file = QString::fromStdString(from->sourceFile).toLower();
  const bool rendered = file.endsWith(QLatin1String(".pdf")) || file.endsWith(QLatin1String(".svg"));
  const double pxPerUnit = rendered ? std::max(1.0, renderedFrame_px / width) : 1;
  const double fit_px = std::max(from->pressRms_px, from->releaseRms_px);
  // share of the axis: no drawing is more accurate, even if its file has more digits
  constexpr double leastShare = 1e-4;
  const auto error = [&](const AxisProvenance& axis, double unit, double size) {
    const double share = std::max(leastShare, std::hypot(fit_px, axis.residual_px) / (size * pxPerUnit));
    return share * std::abs(axis.max - axis.min) * unit;
  };
  return ReadingError{error(*from->xAxis, units->toMm(1), width), error(*from->yAxis, units->toN(1), height)};
}

QString readText(double value, Quantity quantity, const DisplayUnits& units,
                 const std::optional<ReadingError>& error, int significant) {
  // most digits of a typed number; numbers that were read from a page have sixteen
  constexpr int mostTyped = 8;
  constexpr int digitsOfReadSlope = 3;  // the error of a slope is some percent
  constexpr int mostDecimals = 6;
  const auto rounded = readQuantity(quantityText(value, quantity, units, mostTyped), quantity, units).value;
  const bool asTyped = rounded && std::abs(*rounded - value) <= 1e-12 * std::abs(value);
  if (!error || asTyped) return quantityText(value, quantity, units, significant);
  if (quantity == Quantity::slope) return quantityText(value, quantity, units, digitsOfReadSlope);
  const double unit = shownUnitOf(quantity, units);
  const double sigma = (quantity == Quantity::length ? error->mm : error->N) / unit;
  if (!(sigma > 0)) return quantityText(value, quantity, units, significant);
  const int ofError = static_cast<int>(std::ceil(-std::log10(sigma)));
  const int beforePoint =
      value == 0 ? 1 : static_cast<int>(std::floor(std::log10(std::abs(value / unit)))) + 1;
  return fixedText(value / unit, std::clamp(std::min(ofError, significant - beforePoint), 0, mostDecimals));
}

}  // namespace detent::editor
