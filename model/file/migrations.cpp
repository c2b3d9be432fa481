// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/file/migrations.h"

#include "model/file/json_text.h"

namespace detent {

const std::vector<Migration>& buttonMigrations() {
  static const std::vector<Migration> steps{
      [](nlohmann::json&) {},  // 2 adds the optional provenance.warningCodes
      [](nlohmann::json&) {},  // 3 adds the optional cutout
      [](nlohmann::json&) {},  // 4 adds the optional notes, versions and links
      [](nlohmann::json&) {},  // 5 adds the optional speed_mm_per_s and otherSpeeds of a state
  };
  return steps;
}

Result<nlohmann::json> migrated(nlohmann::json document, const std::vector<Migration>& steps,
                                const std::string& subject) {
  const auto newest = static_cast<long long>(steps.size()) + 1;
  const auto refuse = [&](Message problem, Remedies remedies) -> Failure {
    return {FailureCode::unreadableInput, subject, Message("version"), std::move(problem),
            std::move(remedies)};
  };
  const auto found = document.find("version");
  if (found == document.end())
    return refuse(Message("the field is missing"), Message("Add \"version\": %1", std::to_string(newest)));
  if (!found->is_number_integer())
    return refuse("the version is " + jsonText(*found).substr(0, 40) + ", not a whole number",
                  "Write \"version\": " + std::to_string(newest));
  const bool tooLarge = found->is_number_unsigned() && found->get<unsigned long long>() > 1000000;
  const long long version = tooLarge ? 1000000 : found->get<long long>();
  if (version > newest)
    return refuse(Message("the file has version %1; this program reads versions up to %2", jsonText(*found),
                          std::to_string(newest)),
                  Message("Update Detent to open this file"));
  if (version < 1)
    return refuse("the version is " + jsonText(*found) + ", but versions count from 1", "Correct the number");
  for (auto step = static_cast<std::size_t>(version - 1); step < steps.size(); ++step) {
    steps[step](document);
    document["version"] = static_cast<long long>(step) + 2;
  }
  return document;
}

}  // namespace detent
