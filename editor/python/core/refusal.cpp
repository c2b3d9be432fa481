// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/python/core/refusal.h"

namespace detent::python {

Refused Refused::from(const Failure& failure, std::string reportJson) {
  std::vector<std::string> remedies;
  for (const Remedy& remedy : failure.remedies) remedies.push_back(commandLineWords(Remedies(remedy)));
  return {failure.exitCode(), failure.sentence(), std::move(remedies), std::move(reportJson)};
}

}  // namespace detent::python
