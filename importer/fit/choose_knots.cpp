#include "importer/fit/choose_knots.h"

#include <algorithm>
#include <cmath>

namespace detent::importer {

int parametersOf(const KnotChain& chain) {
  // Each end: one of its two coordinates and a slope.
  int count = 4;
  for (std::size_t k = 1; k + 1 < chain.size(); ++k) count += freedomOf(chain[k].joint);
  return count;
}

double correlationOf(const KnotChain& chain, const std::vector<SigmaPoint>& points) {
  const std::vector<ChainPiece> pieces = piecesOf(chain);
  const std::vector<Footpoint> feet = footpointsOn(chain, points);
  std::vector<double> residuals;
  residuals.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    residuals.push_back(std::clamp(signedResidual(pieces[feet[i].piece], points[i], feet[i].t), -3.0, 3.0));
  const auto covariance = [&](std::size_t lag) {
    double sum = 0;
    for (std::size_t i = lag; i < residuals.size(); ++i) sum += residuals[i] * residuals[i - lag];
    return sum;
  };
  const double variance = covariance(0);
  if (!(variance > 0)) return 1;
  double points_ = 1;
  for (std::size_t lag = 1; lag < std::min<std::size_t>(residuals.size() / 4, 50); ++lag) {
    const double rho = covariance(lag) / variance;
    if (rho < 0.05) break;
    points_ += 2 * rho;
  }
  return points_;
}

}  // namespace detent::importer
