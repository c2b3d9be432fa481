// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Writes a press of a button in the formats of other devices, each with an account of what the format does
// not carry (docs/reference/export-formats.md: contents of each file, and how a player is assumed to play
// it).

#include <string>
#include <vector>

#include "model/button.h"
#include "model/named_values.h"
#include "model/result.h"
#include "playback/interchange/export_loss.h"
#include "playback/interchange/exported_file.h"
#include "playback/offline/render_press.h"
#include "playback/prepare/playback_settings.h"
#include "playback/realtime/haptic_program.h"

namespace detent::playback {

enum class ExportFormat {
  package,  ///< thresholds, bursts, curve: everything, as JSON
  cHeader,  ///< the data package as a C header for firmware
  ahap,     ///< Apple, a pair of files
  haptic,   ///< Lofelt and Meta
  android,  ///< Kotlin
  openxr,   ///< XR_EXT_haptic_parametric
  hjif,     ///< ISO/IEC 23090-31
  bos1921,  ///< piezo driver, slices
  da728x,   ///< LRA driver, snippet memory
  drv2605,  ///< LRA driver, real-time amplitudes
  pcm,      ///< samples as a C array
  touchpad  ///< threshold and intensity of a haptic touchpad
};

inline constexpr auto exportFormats = named<ExportFormat>({{"package", ExportFormat::package},
                                                           {"c", ExportFormat::cHeader},
                                                           {"ahap", ExportFormat::ahap},
                                                           {"haptic", ExportFormat::haptic},
                                                           {"android", ExportFormat::android},
                                                           {"openxr", ExportFormat::openxr},
                                                           {"hjif", ExportFormat::hjif},
                                                           {"bos1921", ExportFormat::bos1921},
                                                           {"da728x", ExportFormat::da728x},
                                                           {"drv2605", ExportFormat::drv2605},
                                                           {"pcm", ExportFormat::pcm},
                                                           {"touchpad", ExportFormat::touchpad}});

struct ExportSettings {
  ExportFormat format = ExportFormat::package;
  std::string pressName;         ///< description of the press, for the file
  Feel feel = Feel::clear;       ///< how the program was prepared, for the file
  double sampleRate_Hz = 48000;  ///< sample rate of pcm; 8000..192000
  unsigned bits = 16;            ///< bits of a sample of pcm; 8 or 16
};

struct Exported {
  std::vector<ExportedFile> files;
  ExportLoss loss;
};

/// Failure: as planPress; wrongUsage for settings outside their ranges, and for a press so weak that the
/// format would contain no sound. Any thread; allocates.
Result<Exported> exportPress(const Button& button, const HapticProgram& program, const PressTrace& trace,
                             const ExportSettings& settings);

struct ExportSource;
struct Reduction;

/// The press in the format of the settings, before it becomes text (reduction.h). Failure: nothing would
/// sound in this format.
Result<Reduction> reductionOf(const ExportSource& source, const ExportSettings& settings);

/// Path of a file of an export.
std::string pathOf(const std::string& output, const ExportedFile& file);

/// Writes all files of an export, or none if one of them cannot be written; returns their paths.
Result<std::vector<std::string>> writeExported(const Exported& exported, const std::string& output);

/// A press by its name: "standard", or "human:120ms" (or "human:0.12s"), a human-like press of which the
/// downward movement takes this long, 10 ms to 10 s. Failure wrongUsage: a name that is neither.
Result<PressTrace> namedPress(const std::string& name, const HapticProgram& program);
/// Returns true if `name` has the form of a press name, valid or not; anything else is a file.
bool namesPress(const std::string& name);
/// Description of a press name or of a press trace's file, for exported files.
std::string pressInWords(const std::string& press);

}  // namespace detent::playback
