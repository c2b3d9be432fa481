// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "model/number_table.h"
#include "playback/offline/press_files.h"

namespace detent::playback {

namespace {

constexpr std::size_t largestTrace_bytes = 1U << 30;

Failure badTrace(const std::string& name, Message place, Message problem) {
  return {
      FailureCode::unreadableInput, name, std::move(place), std::move(problem),
      Message(
          "A press trace has the header time_s,force_N or time_s,displacement_mm and two numbers per line")};
}

}  // namespace

Result<PressTrace> parsePressTrace(const std::string& text, const std::string& name) {
  NumberTable table(text);
  if (!table.next()) return badTrace(name, "", Message("the file is empty"));
  PressTrace trace;
  const std::vector<std::string_view>& fields = table.fields();
  const bool inForce = table.is({"time_s", "force_N"});
  if (!inForce && !table.is({"time_s", "displacement_mm"}))
    return badTrace(name, table.place(),
                    Message("the first line is %1, not the names of the columns", quotedBegin(table.line())));
  trace.quantity = inForce ? PressTrace::Quantity::force_N : PressTrace::Quantity::displacement_mm;
  while (table.next()) {
    if (fields.size() != 2)
      return badTrace(name, table.place(),
                      Message("%1 has %2 fields, not 2", quotedBegin(table.line()), fields.size()));
    const auto time_s = table.finite(0), value = numberFrom(fields[1]);
    if (!time_s) return badTrace(name, table.place(), Message("%1 is not a time", quotedBegin(fields[0])));
    if (!value) return badTrace(name, table.place(), Message("%1 is not a number", quotedBegin(fields[1])));
    trace.readings.push_back({*time_s, *value});
  }
  if (trace.readings.empty()) return badTrace(name, table.place(), Message("no reading follows the header"));
  return trace;
}

Result<PressTrace> readPressTrace(const std::filesystem::path& file) {
  const auto text =
      readTable(file.string(), largestTrace_bytes, "Give a press trace CSV, cut into parts if it is large");
  if (!text) return text.failure();
  return parsePressTrace(*text, file.string());
}

}  // namespace detent::playback
