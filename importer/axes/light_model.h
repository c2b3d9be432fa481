// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Loads Tesseract's model in a tenth of the usual start-up time. Most of that time the engine searches its
// letters for those of a table of letters that older recognisers confused. This model renames those letters
// to private code points, so the engine finds none of them and skips the search.
// docs/develop/decisions/0406-text-engine.md

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace detent::importer {

/// A renamed model for starting the engine from memory, with the letters behind its private code points.
class LightModel {
 public:
  /// Reads the bytes of a .traineddata file. nullopt if they are none or have another layout; the engine must
  /// then start from the file itself.
  static std::optional<LightModel> from(std::string_view traineddata);

  /// The model for TessBaseAPI::Init from memory.
  const std::string& bytes() const { return bytes_; }
  /// Translates a list of letters for the engine into its private names. Letters that the model does not have
  /// are left out.
  std::string renamed(std::string_view letters) const;
  /// Translates the engine's answer back to the letters on the page.
  std::string original(std::string_view answer) const;

 private:
  std::string bytes_;
  std::vector<std::string> letters_;  // by code point, from the first private code point on
};

}  // namespace detent::importer
