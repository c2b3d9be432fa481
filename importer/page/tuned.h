// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Thresholds that can be ablated. An options struct states each with its unit and reason; `tests/bench/ablate.py` drives a program that
// tries other values over the corpus and prints what each is worth.

namespace detent::importer {

/// `standard`. Only the bench's own program (tests/bench/tuned_from_environment.cpp) answers with another value for `name`.
double tuned(const char* name, double standard);

}  // namespace detent::importer
