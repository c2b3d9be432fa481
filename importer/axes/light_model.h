// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tesseract's model without nine tenths of its start-up time: a table of letters that older recognisers
// confused. The engine searches every letter of that table among the model's own; with those renamed to
// private code points it finds none and skips it. docs/develop/decisions/0406-text-engine.md

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace detent::importer {

/// A model to start the engine from memory with, and the letters behind its private code points.
class LightModel {
 public:
  /// Reads the bytes of a .traineddata file. nullopt if they are no such file or of another layout: then the
  /// engine has to start from the file itself.
  static std::optional<LightModel> from(std::string_view traineddata);

  /// The model for TessBaseAPI::Init from memory.
  const std::string& bytes() const { return bytes_; }
  /// Request to the engine, letter by letter, with its own names. Letters it does not know are left out.
  std::string renamed(std::string_view letters) const;
  /// The engine's answer, as written on the page.
  std::string original(std::string_view answer) const;

 private:
  std::string bytes_;
  std::vector<std::string> letters_;  // by code point, from the first private one on
};

}  // namespace detent::importer
