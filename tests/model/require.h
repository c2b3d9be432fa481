// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The value of a result that a test cannot go on without.

#include <utility>

#include <catch2/catch.hpp>

#include "model/result.h"

namespace detent::test {

template <class T>
T require(Result<T> result) {
  INFO((result.ok() ? "" : result.failure().sentence()));
  REQUIRE(result.ok());
  return *std::move(result);
}

}  // namespace detent::test
