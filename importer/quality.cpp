// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/quality.h"

namespace detent::importer {

QualitySettings settingsFor(Quality quality) {
  QualitySettings s;
  switch (quality) {
    case Quality::draft:
      s.view.minFrameWidth_px = 600;
      s.trace.pointSpacing_px = 3;
      s.fit = FitEffort::draft;
      s.traceNoise_px = 0.6;
      s.vectorNoise_share = 1e-3;
      break;
    case Quality::standard:
      s.view.minFrameWidth_px = 1000;
      s.trace.pointSpacing_px = 1;
      s.fit = FitEffort::standard;
      s.traceNoise_px = 0.3;
      s.vectorNoise_share = 5e-4;
      break;
    case Quality::precise:
      s.view.minFrameWidth_px = 2000;
      s.trace.pointSpacing_px = 0.5;
      s.fit = FitEffort::precise;
      s.secondOpinion = true;
      s.refineAxes = true;
      s.traceNoise_px = 0.2;
      s.vectorNoise_share = 2.5e-4;
      break;
  }
  return s;
}

}  // namespace detent::importer
