// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/feel/reference_source.h"

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

ReferenceSource::ReferenceSource(QObject* parent)
    : QObject(parent), requests_([this](const Waiting& next) { read(next); }) {}

void ReferenceSource::request(const std::string& file) {
  ++requested_;
  requests_.put({requested_, file});
}

void ReferenceSource::read(const Waiting& next) {
  auto drawing = std::make_shared<ReferenceDrawing>(referenceDrawingOf(next.file));
  drawing->revision = next.revision;
  // Queued events for an object that is gone are dropped by Qt; the destructor waits for this thread.
  QMetaObject::invokeMethod(
      this,
      [this, drawing] {
        if (drawing->revision == requested_) emit ready(drawing);
      },
      Qt::QueuedConnection);
}

}  // namespace detent::editor
