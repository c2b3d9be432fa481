// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/fit/fit_stroke.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>

#include "importer/fit/choose_knots.h"
#include "importer/fit/segment_stroke.h"
#include "importer/fit/tactile_misfit.h"

namespace detent::importer {
namespace {

std::optional<Failure> faultOf(const FitOptions& o) {
  const auto wrong = [](const char* field, double value, const char* range) {
    char number[40];
    std::snprintf(number, sizeof number, "%g", value);
    return Failure{FailureCode::wrongUsage, "fit options", field, std::string("is ") + number,
                   std::string("Give ") + range};
  };
  const auto positive = [](double value) { return std::isfinite(value) && value > 0; };
  const auto within = [](double value, double low, double high) { return value >= low && value <= high; };
  if (!positive(o.noise.sigma_mm)) return wrong("noise.sigma_mm", o.noise.sigma_mm, "a noise above 0 mm");
  if (!positive(o.noise.sigma_N)) return wrong("noise.sigma_N", o.noise.sigma_N, "a noise above 0 N");
  if (o.criterion == PieceCriterion::fixed && !within(o.pieces, 1, 2000))
    return wrong("pieces", o.pieces, "1 to 2000 pieces");
  if (!within(o.maxPieces, 1, 2000)) return wrong("maxPieces", o.maxPieces, "1 to 2000 pieces");
  if (!positive(o.robustScale)) return wrong("robustScale", o.robustScale, "a scale above 0 sigma");
  if (!positive(o.noiseAtTactilePoints_share) || o.noiseAtTactilePoints_share > 1)
    return wrong("noiseAtTactilePoints_share", o.noiseAtTactilePoints_share, "a share above 0 and up to 1");
  if (!positive(o.tolerance) || o.tolerance > 1e-2) return wrong("tolerance", o.tolerance, "above 0 to 1e-2");
  if (!within(o.maxPoints, 4, 1e7)) return wrong("maxPoints", o.maxPoints, "4 to 10 million points");
  if (!within(o.resolutionOfSpan, 0, 0.1)) return wrong("resolutionOfSpan", o.resolutionOfSpan, "0 to 0.1");
  if (!within(o.correlationPoints, 0, 1e6))
    return wrong("correlationPoints", o.correlationPoints, "0, or 1 and more");
  if (!within(o.candidateKnots, 8, 2000))
    return wrong("candidateKnots", o.candidateKnots, "8 to 2000 places");
  if (!within(o.evidenceRounds, 0, 20)) return wrong("evidenceRounds", o.evidenceRounds, "0 to 20 rounds");
  return {};
}

ChoiceSettings choiceSettings(const FitOptions& options) {
  ChoiceSettings settings;
  settings.rounds = options.evidenceRounds;
  settings.maxPieces = options.maxPieces;
  settings.solve.robustScale = options.robustScale;
  settings.solve.tolerance = options.tolerance;
  return settings;
}

/// With fewer points than one cubic has parameters they are joined by straight pieces.
constexpr std::size_t fewestStrokePoints = 5;

KnotChain joined(const std::vector<SigmaPoint>& points) {
  KnotChain chain;
  for (const SigmaPoint& p : points) chain.push_back({{p.u, p.v, 0, 0}, JointKind::corner});
  levelDisplacements(chain);
  dropRedundantKnots(chain);
  for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
    const double h = chain[k + 1].u() - chain[k].u();
    const double slope = h > 0 ? (chain[k + 1].v() - chain[k].v()) / h : 0;
    chain[k].at[3] = slope;
    chain[k + 1].at[2] = slope;
  }
  chain.front().joint = chain.back().joint = JointKind::smooth;
  chain.front().at[2] = chain.front().at[3];
  return chain;
}

struct ChosenChain {
  KnotChain chain;
  KnotEvidence evidence{1, 1};
  FitOutcome outcome = FitOutcome::converged;
};

ChosenChain chooseChain(const StrokeSamples& samples, const FitOptions& options) {
  const std::vector<SigmaPoint>& points = samples.points;
  const double n = static_cast<double>(points.size());
  // The first cut uses more knots than the evidence for cubics supports, because removing knots is more
  // reliable than adding them.
  constexpr int parametersPerCut = 2;
  constexpr double longestCorrelation = 10;  // points; beyond it the residuals show shape, not noise
  KnotEvidence evidence(n, std::max(1.0, options.correlationPoints));
  Segmentation cut = segmentStroke(points, options.candidateKnots, evidence.chiSquarePer(parametersPerCut));
  if (options.correlationPoints == 0 && cut.correlationPoints > 1.2) {
    evidence = KnotEvidence(n, std::min(longestCorrelation, cut.correlationPoints));
    cut = segmentStroke(points, options.candidateKnots, evidence.chiSquarePer(parametersPerCut));
  }
  const ChoiceSettings settings = choiceSettings(options);
  bool converged = true;
  if (options.criterion == PieceCriterion::fixed) {
    converged = reachPieces(cut.chain, points, options.pieces, settings);
  } else {
    converged = chooseKnots(cut.chain, points, evidence, settings);
    if (static_cast<int>(cut.chain.size()) - 1 > options.maxPieces)
      converged = reachPieces(cut.chain, points, options.maxPieces, settings);
  }
  // Corners of drawn lines may lie outside the points by up to the robust scale.
  if (returnStrayKnots(cut.chain, points, options.robustScale + 2) > 0) converged = false;
  return {std::move(cut.chain), evidence, converged ? FitOutcome::converged : FitOutcome::iterationLimit};
}

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

/// Distances in sigmas of the given noise, orthogonal to the curve in these units.
void addDistances(FitSummary& summary, const ChosenChain& fit, const StrokeSamples& samples,
                  const PointNoise& noise) {
  const std::vector<ChainPiece> pieces = piecesOf(fit.chain);
  const std::vector<Footpoint> footpoints = footpointsOn(fit.chain, samples.points);
  const double perU = samples.mmPerU / noise.sigma_mm, perV = samples.newtonsPerV / noise.sigma_N;
  double sum = 0;
  for (std::size_t i = 0; i < footpoints.size(); ++i) {
    const ChainPiece& piece = pieces[footpoints[i].piece];
    const double t = footpoints[i].t;
    const double du = (samples.points[i].u - piece.u(t)) * perU,
                 dv = (samples.points[i].v - piece.v(t)) * perV;
    const double alongU = piece.h * perU, alongV = piece.dv(t) * perV, along = std::hypot(alongU, alongV);
    const bool inside = t > 0 && t < 1 && along > 0;
    const double distance = inside ? std::abs(dv * alongU - du * alongV) / along : std::hypot(du, dv);
    sum += distance * distance;
    summary.maxSigma = std::max(summary.maxSigma, distance);
  }
  summary.rmsSigma = std::sqrt(sum / static_cast<double>(footpoints.size()));
}

std::size_t nearestKnot(const KnotChain& chain, double u, double v) {
  const auto distance = [&](const ChainKnot& k) { return std::hypot(k.u() - u, k.v() - v); };
  const auto best = std::min_element(chain.begin(), chain.end(), [&](const ChainKnot& a, const ChainKnot& b) {
    return distance(a) < distance(b);
  });
  return static_cast<std::size_t>(best - chain.begin());
}

void addErrors(FitSummary& summary, const StrokeCurve& curve, Stroke stroke, const ChosenChain& fit,
               const StrokeSamples& samples, const FitOptions& options) {
  const KnotErrors errors = knotErrors(fit.chain, samples.points, choiceSettings(options).solve);
  if (fit.outcome != FitOutcome::tooFewPoints) summary.condition = errors.condition;
  // `correlationPoints` residuals share one error.
  const double inflation = std::sqrt(summary.correlationPoints);
  const double sign = stroke == Stroke::press ? 1 : -1;
  for (const TactilePoint& point : tactilePoints(curve, stroke)) {
    const std::size_t knot =
        nearestKnot(fit.chain, samples.u(point.displacement_mm), samples.v(point.force_N));
    const TactileMisfit misfit =
        tactileMisfit(fit.chain, samples.points, fit.chain[knot], sign, summary.correlationPoints);
    summary.tactilePoints.push_back(
        {point, std::hypot(errors.sigmas[knot].u * inflation, misfit.u) * samples.mmPerU,
         std::hypot(errors.sigmas[knot].v * inflation, misfit.v) * samples.newtonsPerV});
  }
}

}  // namespace

FitOptions fitOptionsFor(FitEffort effort, PointNoise noise) {
  FitOptions options;
  options.noise = noise;
  if (effort == FitEffort::draft) {
    options.maxPoints = 400;
    options.candidateKnots = 80;
    options.evidenceRounds = 1;
    options.resolutionOfSpan = 3e-3;
    options.tolerance = 1e-4;
  } else if (effort == FitEffort::precise) {
    options.maxPoints = 4000;
    options.maxPieces = 200;
    options.candidateKnots = 400;
    options.evidenceRounds = 4;
    options.resolutionOfSpan = 7e-4;
    options.tolerance = 1e-8;
  }
  return options;
}

std::string FitSummary::brief() const {
  char text[200];
  std::snprintf(text, sizeof text,
                "%d pieces through %d points, rms %.2f sigma, largest %.1f sigma, %.0f ms%s", pieces, points,
                rmsSigma, maxSigma, 1e3 * seconds,
                outcome == FitOutcome::converged        ? ""
                : outcome == FitOutcome::iterationLimit ? ", iteration limit"
                                                        : ", too few points to fit: joined");
  return text;
}

Result<FittedStroke> fitStroke(const std::vector<CurvePoint>& points, Stroke stroke,
                               const FitOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  if (const std::optional<Failure> fault = faultOf(options)) return *fault;
  const Result<StrokeSamples> prepared = prepareSamples(points, stroke, options);
  if (!prepared) return prepared.failure();
  const StrokeSamples& samples = *prepared;

  ChosenChain fit;
  if (samples.points.size() < fewestStrokePoints) {
    fit.chain = joined(samples.points);
    fit.outcome = FitOutcome::tooFewPoints;
  } else {
    fit = chooseChain(samples, options);
  }
  Result<StrokeCurve> curve = StrokeCurve::fromKnots(modelKnots(fit.chain, samples));
  if (!curve) return curve.failure();

  FitSummary summary;
  summary.outcome = fit.outcome;
  summary.pieces = static_cast<int>(fit.chain.size()) - 1;
  summary.points = static_cast<int>(samples.points.size());
  const std::vector<double> residuals = residualsOf(fit.chain, samples.points);
  summary.correlationPoints = correlationOf(residuals);
  summary.bic = fit.evidence.score(chiSquareOf(fit.chain, samples.points, options.robustScale),
                                   parametersOf(fit.chain));
  addDistances(summary, fit, samples, options.noise);
  addErrors(summary, *curve, stroke, fit, samples, options);
  summary.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return FittedStroke{std::move(*curve), std::move(summary)};
}

}  // namespace detent::importer
