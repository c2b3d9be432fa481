// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/result.h"

#include <cstdio>
#include <cstdlib>

#include "model/check.h"

namespace detent {

std::string_view nameOf(FailureCode code) {
  switch (code) {
    case FailureCode::internalFault:
      return "internal_fault";
    case FailureCode::wrongUsage:
      return "wrong_usage";
    case FailureCode::unreadableInput:
      return "unreadable_input";
    case FailureCode::noForceGraph:
      return "no_force_graph";
    case FailureCode::notCertain:
      return "not_certain";
    case FailureCode::deviceTrouble:
      return "device_trouble";
    case FailureCode::cancelled:
      return "cancelled";
  }
  return "";
}

std::string Failure::sentence() const {
  std::string text = english(subject.name);
  if (!place.empty()) {
    if (!text.empty()) text += ", ";
    text += english(place);
  }
  if (!text.empty()) text += ": ";
  text += english(problem);
  text += '.';
  const std::string helps = commandLineWords(remedies);
  if (!helps.empty()) text.append(1, ' ').append(helps).append(1, '.');
  return text;
}

void failCheck(const char* file, int line, const char* condition, const char* why) {
  std::fprintf(stderr, "%s:%d: check failed: %s (%s)\n", file, line, condition, why);
  std::abort();
}

}  // namespace detent
