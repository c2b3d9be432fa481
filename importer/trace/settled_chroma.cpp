// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/settled_chroma.h"

#include <algorithm>
#include <cmath>

#include "importer/page/luma.h"

namespace detent::importer::trace {

namespace {

/// A pixel's difference to the paper, brightness and colour separate, as in JFIF (ITU-R BT.601).
struct Tone {
  double bright = 0;
  Point colour;  ///< Cb, Cr
};

Tone toneOf(double r, double g, double b) {
  const double y = luma(r, g, b);
  return {y, {0.564 * (b - y), 0.713 * (r - y)}};
}

class ChromaSettler {
 public:
  ChromaSettler(Raster& raster, Rgb paper, const ChromaOptions& options)
      : raster_(raster), paper_(toneOf(paper.r, paper.g, paper.b)), options_(options) {}

  bool run() {
    if (sharpnessOfColour() >= options_.sharpness) return false;
    struct Change {
      int x, y;
      Tone tone;
    };
    std::vector<Change> changes;
    for (int y = 0; y < raster_.height_px; ++y)
      for (int x = 0; x < raster_.width_px; ++x) {
        const Tone here = at(x, y);
        if (isColourless(here)) continue;
        const Tone core = coreAround(x, y);
        if (std::abs(core.bright) < options_.leastContrast) continue;
        const Point due = std::clamp(here.bright / core.bright, 0.0, 1.0) * core.colour;
        changes.push_back({x, y, {here.bright, due}});
      }
    for (const Change& change : changes) paint(change.x, change.y, change.tone);
    return !changes.empty();
  }

 private:
  // Calculated anew each time: tones of all pixels would take eight times the memory of the picture.
  Tone at(int x, int y) const {
    const std::uint8_t* p = raster_.at(x, y);
    const Tone tone = toneOf(p[0], p[1], p[2]);
    return {tone.bright - paper_.bright, tone.colour - paper_.colour};
  }

  bool isColourless(const Tone& tone) const {
    // Most pixels are paper, far below the limit in either norm; this one takes no root.
    const double most = std::abs(tone.colour.x) + std::abs(tone.colour.y);
    return most < 0.99 * options_.leastChroma || norm(tone.colour) < options_.leastChroma;
  }

  /// Second against first differences along rows and columns where there is colour, colour against
  /// brightness; 1 without colour.
  double sharpnessOfColour() const {
    double colour1 = 0, colour2 = 0, bright1 = 0, bright2 = 0;
    for (int y = 1; y + 1 < raster_.height_px; ++y)
      for (int x = 1; x + 1 < raster_.width_px; ++x) {
        const Tone here = at(x, y);
        if (isColourless(here)) continue;
        for (const auto& [before, after] :
             {std::pair(at(x - 1, y), at(x + 1, y)), std::pair(at(x, y - 1), at(x, y + 1))}) {
          colour1 += norm(here.colour - before.colour);
          colour2 += norm(after.colour - 2.0 * here.colour + before.colour);
          bright1 += std::abs(here.bright - before.bright);
          bright2 += std::abs(after.bright - 2 * here.bright + before.bright);
        }
      }
    return colour1 > 0 && bright2 > 0 ? colour2 * bright1 / (colour1 * bright2) : 1;
  }

  /// The nearby pixel of the same hue with the largest difference to the paper's brightness.
  Tone coreAround(int x, int y) const {
    Tone core = at(x, y);
    const Point hue = core.colour;
    const int reach = options_.reach_px;
    for (int v = std::max(0, y - reach); v <= std::min(raster_.height_px - 1, y + reach); ++v)
      for (int u = std::max(0, x - reach); u <= std::min(raster_.width_px - 1, x + reach); ++u) {
        const Tone tone = at(u, v);
        if (std::abs(tone.bright) <= std::abs(core.bright)) continue;
        if (dot(tone.colour, hue) >= options_.sameHue * norm(tone.colour) * norm(hue) &&
            norm(tone.colour) >= options_.leastChroma)
          core = tone;
      }
    return core;
  }

  void paint(int x, int y, const Tone& tone) {
    const double bright = paper_.bright + tone.bright;
    const Point colour = paper_.colour + tone.colour;
    const double r = bright + colour.y / 0.713, b = bright + colour.x / 0.564;
    const double g = (bright - lumaOfRed * r - lumaOfBlue * b) / lumaOfGreen;
    std::uint8_t* p = raster_.rgb.data() + (raster_.at(x, y) - raster_.rgb.data());
    const auto level = [](double v) { return static_cast<std::uint8_t>(std::clamp(v + 0.5, 0.0, 255.0)); };
    p[0] = level(r), p[1] = level(g), p[2] = level(b);
  }

  Raster& raster_;
  Tone paper_;
  const ChromaOptions& options_;
};

}  // namespace

bool settleChroma(Raster& raster, Rgb paper, const ChromaOptions& options) {
  return ChromaSettler(raster, paper, options).run();
}

}  // namespace detent::importer::trace
