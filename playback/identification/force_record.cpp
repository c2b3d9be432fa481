// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/identification/force_record.h"

#include <vector>

#include "model/number_table.h"

namespace detent::playback {

namespace {

constexpr std::size_t largestRecord_bytes = 1U << 28;
constexpr const char* form =
    "A record has the header time_s,displacement_mm,force_N and three numbers per line";
const std::vector<std::string_view> columnNames{"time_s", "displacement_mm", "force_N"};

}  // namespace

Result<ForceRecord> parseForceRecord(const std::string& text, const std::string& name) {
  NumberTable table(text);
  const auto bad = [&](const std::string& problem) {
    return Failure{FailureCode::unreadableInput, name, table.place(), problem, form};
  };
  if (!table.next()) return Failure{FailureCode::unreadableInput, name, "", "the file is empty", form};
  const auto columns = table.columns(columnNames);
  if (!columns) return bad("the header is " + quotedBegin(table.line()));
  ForceRecord record;
  std::vector<double>* const values[] = {&record.time_s, &record.displacement_mm, &record.force_N};
  while (table.next()) {
    for (std::size_t c = 0; c < columnNames.size(); ++c) {
      const std::optional<double> value = table.finite((*columns)[c]);
      if (!value) return bad(std::string(columnNames[c]) + " is no finite number");
      if (c == 0 && !record.time_s.empty() && *value <= record.time_s.back())
        return bad("the time does not increase");
      values[c]->push_back(*value);
    }
  }
  return record;
}

Result<ForceRecord> readForceRecord(const std::string& file) {
  const auto text = readTable(file, largestRecord_bytes, form);
  if (!text) return text.failure();
  return parseForceRecord(*text, file);
}

}  // namespace detent::playback
