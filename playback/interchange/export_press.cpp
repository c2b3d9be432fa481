// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/interchange/export_press.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "model/file/staged_text.h"
#include "model/version.h"
#include "playback/interchange/reduction.h"
#include "playback/measurement/exact_number.h"
#include "playback/offline/standard_press.h"

namespace detent::playback {

namespace {

constexpr std::string_view humanPress = "human:";

Failure wrongPress(const std::string& name) {
  return {FailureCode::wrongUsage, Subject::option("--press"), "",
          name.empty() ? Message("no press is named") : Message("%1 is not a press", name),
          Message("Give standard, human:120ms with 10 ms to 10 s, or a CSV of time_s,force_N or "
                  "time_s,displacement_mm")};
}

Reduction inFormat(const ExportSource& source, const ExportSettings& settings) {
  switch (settings.format) {
    case ExportFormat::package:
      return packageOf(source);
    case ExportFormat::cHeader:
      return cHeaderOf(source);
    case ExportFormat::ahap:
      return ahapOf(source);
    case ExportFormat::haptic:
      return hapticOf(source);
    case ExportFormat::android:
      return androidOf(source);
    case ExportFormat::openxr:
      return openxrOf(source);
    case ExportFormat::hjif:
      return hjifOf(source);
    case ExportFormat::bos1921:
      return bos1921Of(source);
    case ExportFormat::da728x:
      return da728xOf(source);
    case ExportFormat::drv2605:
      return drv2605Of(source);
    case ExportFormat::pcm:
      return pcmOf(source, settings.bits, settings.sampleRate_Hz);
    case ExportFormat::touchpad:
      break;
  }
  return touchpadOf(source);
}

bool sounds(const std::vector<std::vector<double>>& parts) {
  return std::any_of(parts.begin(), parts.end(), [](const std::vector<double>& part) {
    return std::any_of(part.begin(), part.end(), [](double sample) { return sample != 0; });
  });
}

/// Failure for a press that is too weak for a format's level steps.
Failure tooFaint(const PressPlan& plan, ExportFormat format) {
  double peak = 0;
  for (const float sample : plan.samples) peak = std::fmax(peak, std::fabs(static_cast<double>(sample)));
  return {FailureCode::wrongUsage, Subject::option("--format"), "",
          Message("%1 cannot hold this press: its strongest sample is only %2 of full scale, so nothing "
                  "would be felt",
                  std::string(exportFormats.word(format)), peak),
          Message("Press deeper, raise the gain of the device profile, or choose the Detent package, which "
                  "holds any press")};
}

}  // namespace

Result<Reduction> reductionOf(const ExportSource& source, const ExportSettings& settings) {
  Reduction reduction = inFormat(source, settings);
  if (settings.format != ExportFormat::touchpad && !sounds(reduction.played))
    return tooFaint(source.plan, settings.format);
  return reduction;
}

std::vector<double> playedBy(const std::vector<PlayedWave>& waves, const PressPlan& plan) {
  std::vector<double> samples(plan.samples.size(), 0);
  addTo(samples, waves, plan.sampleRate_Hz);
  return samples;
}

std::vector<std::string> headLines(const ExportSource& source, const ExportLoss& loss) {
  std::vector<std::string> lines{std::string("Made by Detent ") + version() + " from button \"" +
                                 source.plan.button + "\", feel " +
                                 std::string(feels.word(source.plan.feel)) + ": " + source.plan.press};
  for (const std::string& line : linesOf(loss)) lines.push_back(line);
  return lines;
}

std::string cComment(const std::vector<std::string>& lines) {
  std::string text = "/*";
  for (const std::string& line : lines) {
    text += lines.size() > 1 ? "\n * " : " ";
    for (const char c : line) {
      if (static_cast<unsigned char>(c) < ' ') continue;
      if (c == '/' && text.back() == '*') text += ' ';
      if (c == '*' && text.back() == '/') text += ' ';
      text += c;
    }
  }
  return text + " */\n";
}

std::string cString(const std::string& text) {
  std::string literal = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= ' ' && byte < 127 && c != '"' && c != '\\' && c != '?') {
      literal += c;
      continue;
    }
    literal += '\\';
    for (const unsigned shift : {6U, 3U, 0U}) literal += static_cast<char>('0' + (byte >> shift & 7U));
  }
  return literal + "\"";
}

std::string cFloat(double value) {
  std::string text = exact(static_cast<double>(static_cast<float>(value)));
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text + "f";
}

Result<Exported> exportPress(const Button& button, const HapticProgram& program, const PressTrace& trace,
                             const ExportSettings& settings) {
  if (settings.bits != 8 && settings.bits != 16)
    return Failure{FailureCode::wrongUsage, Subject::option("--bits"), "",
                   Message("samples of %1 bits are not supported", static_cast<std::size_t>(settings.bits)),
                   Message("Give 8 or 16")};
  if (settings.format == ExportFormat::pcm && !(settings.sampleRate_Hz >= HapticEngine::lowestSampleRate_Hz &&
                                                settings.sampleRate_Hz <= HapticEngine::highestSampleRate_Hz))
    return Failure{FailureCode::wrongUsage, Subject::option("--rate"), "",
                   Message("a rate of %1 samples a second is not supported", settings.sampleRate_Hz),
                   Message("Give a rate from 8000 to 192000")};
  if (Result<Done> ok = checkRendering(trace, {}); !ok) return ok.failure();
  Result<PressPlan> plan = planPress(button, program, trace, settings.pressName, {});
  if (!plan) return plan.failure();
  plan->feel = settings.feel;
  Result<Reduction> reduction = reductionOf({button, program, *plan}, settings);
  if (!reduction) return reduction.failure();
  reduction->loss.energyKept = energyKept(plan->samples, reduction->played, plan->sampleRate_Hz);
  return Exported{reduction->write(reduction->loss), reduction->loss};
}

std::string pathOf(const std::string& output, const ExportedFile& file) {
  std::filesystem::path path(output);
  const std::string ending = file.ending.empty() ? path.extension().string() : file.ending;
  return path.replace_extension().string() + file.part + ending;
}

Result<std::vector<std::string>> writeExported(const Exported& exported, const std::string& output) {
  std::vector<NamedText> files;
  std::vector<std::string> paths;
  for (const ExportedFile& file : exported.files) {
    paths.push_back(pathOf(output, file));
    if (std::find(paths.begin(), paths.end() - 1, paths.back()) != paths.end() - 1)
      return Failure{FailureCode::wrongUsage, output, "", Message("two exported files would get this name"),
                     Message("Give the file another ending than %1", file.ending)};
    files.push_back({paths.back(), file.text});
  }
  if (Result<Done> done = writeTextFilesAtomically(files); !done) return done.failure();
  return paths;
}

std::string pressInWords(const std::string& press) {
  if (press == "standard") return "human-like press of 0.3 s";
  if (namesPress(press)) return "human-like press, " + press.substr(humanPress.size()) + " down";
  return "recorded press " + std::filesystem::path(press).filename().string();
}

bool namesPress(const std::string& name) {
  return name.empty() || name == "standard" || name.starts_with(humanPress);
}

Result<PressTrace> namedPress(const std::string& name, const HapticProgram& program) {
  if (name == "standard") return standardPress(program);
  if (!name.starts_with(humanPress)) return wrongPress(name);
  double number = 0;
  const char* const end = name.data() + name.size();
  const auto [rest, error] = std::from_chars(name.data() + humanPress.size(), end, number);
  const std::string_view unit(rest, static_cast<std::size_t>(end - rest));
  StandardPress press;
  press.press_s = unit == "ms" ? number / 1000 : number;
  if (error != std::errc() || (unit != "ms" && unit != "s") ||
      !(press.press_s >= 0.01 && press.press_s <= 10))
    return wrongPress(name);
  return standardPress(program, press);
}

}  // namespace detent::playback
