#include "importer/quality.h"

namespace detent::importer {

QualitySettings settingsFor(Quality quality) {
  QualitySettings s;
  switch (quality) {
    case Quality::draft:
      s.view.minFrameWidth_px = 600;
      s.trace.pointSpacing_px = 3;
      s.traceNoise_px = 0.6;
      s.vectorNoise_share = 1e-3;
      s.maxPieces = 24;
      s.maxFitPoints = 300;
      s.fitTolerance = 1e-4;
      break;
    case Quality::standard:
      s.view.minFrameWidth_px = 1000;
      s.trace.pointSpacing_px = 1;
      s.traceNoise_px = 0.3;
      s.vectorNoise_share = 5e-4;
      s.maxPieces = 64;
      s.maxFitPoints = 1000;
      s.fitTolerance = 1e-6;
      break;
    case Quality::precise:
      s.view.minFrameWidth_px = 2000;
      s.trace.pointSpacing_px = 0.5;
      s.traceNoise_px = 0.2;
      s.vectorNoise_share = 2.5e-4;
      s.maxPieces = 160;
      s.maxFitPoints = 4000;
      s.fitTolerance = 1e-9;
      break;
  }
  return s;
}

}  // namespace detent::importer
