// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "importer/page/polyline.h"
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

Box Affine::boxOf(const Box& box) const { return Homography(*this).boxOf(box); }

Affine::operator Homography() const { return {{a, c, e, b, d, f, 0, 0, 1}}; }

Homography Homography::after(const Homography& first) const {
  Homography combined;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column)
      combined.m[3 * row + column] = m[3 * row] * first.m[column] + m[3 * row + 1] * first.m[3 + column] +
                                     m[3 * row + 2] * first.m[6 + column];
  return combined;
}

Box Homography::boxOf(const Box& box) const {
  return boundsOf({(*this)(Point{box.x0, box.y0}), (*this)(Point{box.x1, box.y0}),
                   (*this)(Point{box.x1, box.y1}), (*this)(Point{box.x0, box.y1})});
}

double Homography::scaleAt(Point p) const {
  const double w = m[6] * p.x + m[7] * p.y + m[8];
  const double determinant = m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
                             m[2] * (m[3] * m[7] - m[4] * m[6]);
  return std::sqrt(std::abs(determinant / (w * w * w)));
}

Homography Homography::inverse() const {
  Homography inverse{{m[4] * m[8] - m[5] * m[7], m[2] * m[7] - m[1] * m[8], m[1] * m[5] - m[2] * m[4],
                      m[5] * m[6] - m[3] * m[8], m[0] * m[8] - m[2] * m[6], m[2] * m[3] - m[0] * m[5],
                      m[3] * m[7] - m[4] * m[6], m[1] * m[6] - m[0] * m[7], m[0] * m[4] - m[1] * m[3]}};
  const double determinant = m[0] * inverse.m[0] + m[1] * inverse.m[3] + m[2] * inverse.m[6];
  DETENT_CHECK(determinant != 0 && std::isfinite(determinant),
               "a projective map that is inverted is regular");
  for (double& value : inverse.m) value /= determinant;
  return inverse;
}

}  // namespace detent::importer
