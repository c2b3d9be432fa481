// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// *.button.json: the file of a button (docs/reference/file-format.md, button.schema.json beside this file).
//
// One version number; newer versions are refused, older ones migrated for ever. Every double survives bit for
// bit. Unknown keys are refused, because a misspelt key would silently lose a value; keys that begin with
// "x-" are free for other programs, are ignored here, and are not written back. Keys given twice are refused.

#include <optional>
#include <string>
#include <string_view>

#include "model/annotations.h"
#include "model/button.h"
#include "model/file/page_cutout.h"

namespace detent {

/// The newest that is read. Written is the oldest that can hold the content: what has neither cut-out nor annotations stays
/// readable for programs that know version 2.
constexpr int buttonFileVersion = 5;

/// Everything a file holds.
struct ButtonFile {
  Button button;
  std::optional<PageCutout> cutout = {};
  Annotations annotations = {};
};

/// `subject` names the text in Failures (a file name). Failures: unreadableInput with line and column for
/// malformed JSON, with the path of the value ("states[0].press[3].force_N") for everything else.
Result<ButtonFile> buttonFileFromJson(std::string_view text, const std::string& subject);
/// The button alone.
Result<Button> buttonFromJson(std::string_view text, const std::string& subject);

/// Deterministic text, one knot per line, ending in a newline. Bytes of names that are no UTF-8 become
/// U+FFFD.
std::string jsonFrom(const Button& button, const std::optional<PageCutout>& cutout = {},
                     const Annotations& annotations = {});

Result<ButtonFile> readWholeButtonFile(const std::string& path);
/// The button alone.
Result<Button> readButtonFile(const std::string& path);
/// Atomic: see writeTextFileAtomically.
Result<Done> writeButtonFile(const std::string& path, const Button& button);

}  // namespace detent
