// SPDX-License-Identifier: GPL-3.0-or-later
// export_limits [COUNT [FIRST_SEED [FORMAT...]]]: draws buttons and presses, exports each in one format, and
// counts what passes a limit of it. With formats named, only the draws that fall on them are exported: after
// a change of one writer the others need no second count. Figures: docs/reference/export-formats.md.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>
#include <string>

#include "tests/playback/interchange/fuzzed_exports.h"

using namespace detent;
using namespace detent::playback;
using namespace detent::test;

namespace {

struct Tally {
  std::uint64_t written = 0, refused = 0, passed = 0;
};

/// A refusal's sentence without its numbers.
std::string reasonOf(std::string sentence) {
  for (char& c : sentence)
    if (c >= '0' && c <= '9') c = '#';
  return sentence.substr(0, 120);
}

}  // namespace

int main(int count, char** arguments) {
  const std::uint64_t draws = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 10000;
  const std::uint64_t first = count > 2 ? std::strtoull(arguments[2], nullptr, 10) : 1;
  const std::set<std::string> formats(arguments + std::min(count, 3), arguments + count);
  std::map<std::string, Tally> tallies;
  std::map<std::string, std::uint64_t> reasons;
  std::uint64_t shown = 0;
  for (std::uint64_t seed = first; seed < first + draws; ++seed) {
    const FuzzedExport drawn = fuzzedExport(seed);
    const std::string format(exportFormats.word(drawn.settings.format));
    if (!formats.empty() && !formats.contains(format)) continue;
    const ExportVerdict verdict = judgedByLimits(drawn);
    Tally& tally = tallies[format];
    ++(verdict.refusal.empty() ? tally.written : tally.refused);
    if (!verdict.refusal.empty()) ++reasons[reasonOf(verdict.refusal)];
    if (verdict.violations.empty()) continue;
    ++tally.passed;
    if (shown++ < 20)
      std::printf("seed %llu, %s: %s\n", static_cast<unsigned long long>(seed), format.c_str(),
                  verdict.violations.front().c_str());
  }
  std::printf("| format | written | refused | passes a limit |\n|---|---|---|---|\n");
  Tally all;
  for (const auto& [name, tally] : tallies) {
    std::printf("| %s | %llu | %llu | %llu |\n", name.c_str(), static_cast<unsigned long long>(tally.written),
                static_cast<unsigned long long>(tally.refused),
                static_cast<unsigned long long>(tally.passed));
    all.written += tally.written;
    all.refused += tally.refused;
    all.passed += tally.passed;
  }
  std::printf("| all | %llu | %llu | %llu |\n", static_cast<unsigned long long>(all.written),
              static_cast<unsigned long long>(all.refused), static_cast<unsigned long long>(all.passed));
  for (const auto& [reason, times] : reasons)
    std::printf("%llu: %s\n", static_cast<unsigned long long>(times), reason.c_str());
  return all.passed == 0 ? 0 : 1;
}
