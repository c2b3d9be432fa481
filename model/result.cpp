// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/result.h"

#include <cstdio>
#include <cstdlib>

#include "model/check.h"

namespace detent {

std::string Failure::sentence() const {
  std::string text = subject;
  if (!place.empty()) text += (text.empty() ? "" : ", ") + place;
  if (!text.empty()) text += ": ";
  text += problem + ".";
  if (!remedy.empty()) text += " " + remedy + ".";
  return text;
}

void failCheck(const char* file, int line, const char* condition, const char* why) {
  std::fprintf(stderr, "%s:%d: check failed: %s (%s)\n", file, line, condition, why);
  std::abort();
}

}  // namespace detent
