// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Properties with a fixed seed: a test that failed yesterday fails today. RC_PARAMS="seed=N
// max_success=10000" tries others and more; .ci/nightly does.

#include <cstdlib>
#include <sstream>
#include <string>
#include <utility>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

namespace detent::tests {

/// Runs a callable with RC_ASSERTs on 100 random cases inside a Catch test, or on as many as RC_PARAMS says.
template <class Testable>
void holdsAlways(const std::string& name, Testable&& testable) {
  rc::detail::TestParams parameters = rc::detail::configuration().testParams;
  if (std::getenv("RC_PARAMS") == nullptr) parameters.seed = 20131008;
  rc::detail::TestMetadata metadata;
  metadata.id = name;
  metadata.description = name;
  const auto result = rc::detail::checkTestable(std::forward<Testable>(testable), metadata, parameters);
  std::ostringstream message;
  rc::detail::printResultMessage(result, message);
  INFO(name << ": " << message.str());
  CHECK(result.template is<rc::detail::SuccessResult>());
}

}  // namespace detent::tests
