// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/feel/reference_drawing.h"

#include <utility>

#include "playback/sharing.h"

namespace detent::editor {

static_assert(drawnRate_Hz == playback::referenceRate_Hz);

ReferenceDrawing referenceDrawingOf(const std::string& file) {
  ReferenceDrawing drawing;
  Result<playback::ReferenceSignal> read = playback::readReference(file);
  if (!read) {
    drawing.failure = read.failure();
    return drawing;
  }
  drawing.samples = std::move(read->samples);
  drawing.peak = read->peak;
  drawing.notes = std::move(read->notes);
  drawing.spectrogram = playback::spectrogramOf(drawing.samples, drawnRate_Hz);
  return drawing;
}

}  // namespace detent::editor
