// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// *.button.json: the button file (docs/reference/file-format.md, button.schema.json beside this file).
// One version number; newer versions are refused, older ones are migrated. Every double survives bit for bit.
// Unknown keys are refused, because a misspelt key would silently lose a value; keys that begin with "x-"
// belong to other programs, are ignored and not written back. Duplicate keys are refused.

#include <optional>
#include <string>
#include <string_view>

#include "model/annotations.h"
#include "model/button.h"
#include "model/file/page_cutout.h"

namespace detent {

/// Newest version that is read. The oldest version that can hold the content is written, so files without
/// cut-out and annotations stay readable for programs that know version 2.
constexpr int buttonFileVersion = 5;

/// Contents of a button file.
struct ButtonFile {
  Button button;
  std::optional<PageCutout> cutout = {};
  Annotations annotations = {};
};

/// `subject` names the text in Failures (a file name). Failures: unreadableInput with line and column for
/// malformed JSON, with the path of the value ("states[0].press[3].force_N") otherwise.
Result<ButtonFile> buttonFileFromJson(std::string_view text, const std::string& subject);
/// Reads the button of a file's JSON, without its other parts.
Result<Button> buttonFromJson(std::string_view text, const std::string& subject);

/// Deterministic text, one knot per line, ending in a newline. Invalid UTF-8 in names becomes U+FFFD.
std::string jsonFrom(const Button& button, const std::optional<PageCutout>& cutout = {},
                     const Annotations& annotations = {});

Result<ButtonFile> readWholeButtonFile(const std::string& path);
/// Reads the button of a file, without its other parts.
Result<Button> readButtonFile(const std::string& path);
/// Atomic: see writeTextFileAtomically.
Result<Done> writeButtonFile(const std::string& path, const Button& button);

}  // namespace detent
