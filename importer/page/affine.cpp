// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/raster.h"
#include "model/check.h"

namespace detent::importer {

Affine Affine::after(const Affine& first) const {
  return {a * first.a + c * first.b, b * first.a + d * first.b,     a * first.c + c * first.d,
          b * first.c + d * first.d, a * first.e + c * first.f + e, b * first.e + d * first.f + f};
}

Affine Affine::inverse() const {
  const double determinant = a * d - b * c;
  DETENT_CHECK(determinant != 0, "an affine map that is inverted has a determinant other than 0");
  const double ia = d / determinant, ib = -b / determinant;
  const double ic = -c / determinant, id = a / determinant;
  return {ia, ib, ic, id, -(ia * e + ic * f), -(ib * e + id * f)};
}

}  // namespace detent::importer
