#include "importer/fit/fit_stroke.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "importer/fit/choose_knots.h"
#include "importer/fit/segment_stroke.h"

namespace detent::importer {
namespace {

std::vector<Knot> modelKnots(const KnotChain& chain, const StrokeSamples& samples) {
  const std::vector<ChainPiece> pieces = piecesOf(chain);
  const double slopeUnit = samples.newtonsPerV / samples.mmPerU;
  std::vector<Knot> knots;
  for (std::size_t k = 0; k < chain.size(); ++k) {
    Knot knot{samples.displacement_mm(chain[k].u()), samples.force_N(chain[k].v()), 0, 0};
    if (k > 0 && pieces[k - 1].h > 0)
      knot.slopeBefore_N_per_mm = pieces[k - 1].b / pieces[k - 1].h * slopeUnit;
    if (k < pieces.size() && pieces[k].h > 0)
      knot.slopeAfter_N_per_mm = pieces[k].a / pieces[k].h * slopeUnit;
    if (k == 0) knot.slopeBefore_N_per_mm = knot.slopeAfter_N_per_mm;
    if (k == pieces.size()) knot.slopeAfter_N_per_mm = knot.slopeBefore_N_per_mm;
    knots.push_back(knot);
  }
  return knots;
}

}  // namespace

FitOptions fitOptionsFor(FitEffort effort, PointNoise noise) {
  FitOptions options;
  options.noise = noise;
  (void)effort;
  return options;
}

std::string FitSummary::brief() const {
  char text[160];
  std::snprintf(text, sizeof text, "%d pieces through %d points, rms %.2f sigma, largest %.1f sigma, %.0f ms",
                pieces, points, rmsSigma, maxSigma, 1e3 * seconds);
  return text;
}

Result<FittedStroke> fitStroke(const std::vector<CurvePoint>& points, Stroke stroke,
                               const FitOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  Result<StrokeSamples> prepared = prepareSamples(points, stroke, options);
  if (!prepared) return prepared.failure();
  const StrokeSamples& samples = *prepared;
  const double n = static_cast<double>(samples.points.size());
  ChoiceSettings settings;
  settings.rounds = options.evidenceRounds;
  settings.maxPieces = options.maxPieces;
  settings.solve.robustScale = options.robustScale;
  settings.solve.tolerance = options.tolerance;
  const Evidence evidence(n, options.correlationPoints > 0 ? options.correlationPoints : 3);
  KnotChain chain = segmentStroke(samples.points, options.candidateKnots, 2 * evidence.chiSquarePer(1));
  const SolveReport solved = chooseKnots(chain, samples.points, evidence, settings);
  dropRedundantKnots(chain);
  Result<StrokeCurve> curve = StrokeCurve::fromKnots(modelKnots(chain, samples));
  if (!curve) return curve.failure();
  FitSummary summary;
  summary.pieces = static_cast<int>(chain.size()) - 1;
  summary.points = static_cast<int>(samples.points.size());
  summary.outcome = solved.converged ? FitOutcome::converged : FitOutcome::iterationLimit;
  summary.correlationPoints = correlationOf(residualsOf(chain, samples.points));
  double sum = 0;
  const std::vector<Footpoint> feet = footpointsOn(chain, samples.points);
  for (const Footpoint& f : feet) {
    sum += f.squaredDistance;
    summary.maxSigma = std::max(summary.maxSigma, std::sqrt(f.squaredDistance));
  }
  summary.bic = evidence.score(chiSquareOf(chain, samples.points, options.robustScale), parametersOf(chain));
  summary.rmsSigma = std::sqrt(sum / n);
  summary.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return FittedStroke{std::move(*curve), summary};
}

}  // namespace detent::importer
