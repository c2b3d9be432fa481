// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <catch2/catch.hpp>

#include "playback/measurement/normal.h"
#include "playback/study/statistics/abx_sensitivity.h"
#include "playback/study/statistics/binomial.h"
#include "playback/study/statistics/paired_difference.h"
#include "playback/study/statistics/rank_correlation.h"
#include "playback/study/statistics/resampling.h"
#include "playback/study/statistics/same_different.h"
#include "playback/study/statistics/shuffle.h"

using namespace detent::playback;

namespace {

double phi(double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); }

double printed(double value, int digits) {
  const double scale = std::pow(10, digits);
  return std::round(value * scale) / scale;
}

}  // namespace

TEST_CASE("normal: quantile is the inverse of the distribution, to the tails") {
  for (const double p : {1e-12, 1e-6, 0.025, 0.3, 0.5, 0.84, 0.975, 1 - 1e-9})
    CHECK(normalCdf(normalQuantile(p)) == Approx(p).epsilon(1e-9));
  CHECK(normalQuantile(0.975) == Approx(1.959963984540054).margin(1e-12));
  CHECK(std::isinf(normalQuantile(0)));
  CHECK(std::isinf(normalQuantile(1)));
}

TEST_CASE("d' of ABX: both strategies give back the share they were found for, to 1e-6") {
  for (const double pc : {0.51, 0.55, 0.6, 0.65, 0.7, 0.75, 0.8, 0.85, 0.9, 0.95, 0.97, 0.98, 0.99, 0.999}) {
    const double d = dPrimeOf(pc, AbxStrategy::differencing);
    const double i = dPrimeOf(pc, AbxStrategy::independentObservations);
    const double root2 = std::sqrt(2.0), root6 = std::sqrt(6.0);
    CHECK(phi(d / root2) * phi(d / root6) + phi(-d / root2) * phi(-d / root6) == Approx(pc).margin(1e-12));
    CHECK(phi(i / root2) * phi(i / 2) + phi(-i / root2) * phi(-i / 2) == Approx(pc).margin(1e-12));
  }
}

TEST_CASE("d' of ABX: the printed table of Macmillan and Creelman's two models") {
  const struct {
    double pc, independent, differencing;
  } table[] = {{0.55, 0.69, 0.76}, {0.60, 1.00, 1.12}, {0.65, 1.27, 1.42}, {0.70, 1.53, 1.72},
               {0.75, 1.79, 2.02}, {0.80, 2.07, 2.35}, {0.85, 2.40, 2.75}, {0.90, 2.81, 3.26},
               {0.95, 3.43, 4.07}, {0.97, 3.85, 4.63}, {0.98, 4.17, 5.04}, {0.99, 4.69, 5.70}};
  for (const auto& row : table) {
    CHECK(printed(dPrimeOf(row.pc, AbxStrategy::independentObservations), 2) == Approx(row.independent));
    CHECK(printed(dPrimeOf(row.pc, AbxStrategy::differencing), 2) == Approx(row.differencing));
  }
  CHECK(dPrimeOf(0.4, AbxStrategy::differencing) == 0);
  CHECK(std::isinf(dPrimeOf(1, AbxStrategy::differencing)));
  CHECK(dPrimeOf(std::nan(""), AbxStrategy::differencing) == 0);
}

TEST_CASE("binomial: at most so many errors in ten by guessing") {
  CHECK(atMost({0, 10}, 0.5) == Approx(1.0 / 1024).epsilon(1e-12));
  CHECK(atMost({1, 10}, 0.5) == Approx(11.0 / 1024).epsilon(1e-12));
  CHECK(printed(atMost({1, 10}, 0.5), 4) == 0.0107);
  CHECK(printed(atMost({2, 10}, 0.5), 4) == 0.0547);
  CHECK(printed(atMost({3, 10}, 0.5), 3) == 0.172);
  // right nine times in ten, and still fails in 26 % of studies
  CHECK(printed(1 - atMost({1, 10}, 0.1), 2) == 0.26);
  CHECK(atMost({10, 10}, 0.5) == 1);
  CHECK(atMost({3, 10}, 0) == 1);
  CHECK(atMost({3, 10}, 1) == 0);
}

TEST_CASE("binomial: Wilson and Clopper-Pearson, to their printed digits") {
  const struct {
    Count count;
    double wilsonLow, wilsonHigh, exactLow, exactHigh;
  } table[] = {{{10, 90}, 6.1, 19.3, 5.5, 19.5}, {{5, 90}, 2.4, 12.4, 1.8, 12.5},
               {{0, 90}, 0, 4.1, 0, 4.0},        {{46, 1350}, 2.6, 4.5, 2.5, 4.5},
               {{8, 135}, 3.0, 11.3, 2.6, 11.3}, {{76, 96}, 70.0, 86.1, 69.7, 86.8}};
  for (const auto& row : table) {
    CAPTURE(row.count.errors, row.count.trials);
    CHECK(printed(100 * wilson(row.count).low, 1) == Approx(row.wilsonLow));
    CHECK(printed(100 * wilson(row.count).high, 1) == Approx(row.wilsonHigh));
    CHECK(printed(100 * clopperPearson(row.count).low, 1) == Approx(row.exactLow));
    CHECK(printed(100 * clopperPearson(row.count).high, 1) == Approx(row.exactHigh));
  }
  CHECK(printed(100 * wilson({8, 1350}).low, 2) == 0.30);
  CHECK(printed(100 * wilson({8, 1350}).high, 2) == 1.16);
  CHECK(printed(100 * clopperPearson({8, 1350}).low, 2) == 0.26);
  CHECK(printed(100 * clopperPearson({8, 1350}).high, 2) == 1.16);
  CHECK(wilson({0, 0}).high == 1);
  CHECK(clopperPearson({7, 7}).high == 1);
}

TEST_CASE("Holm: steps down, never below its predecessor, in the order given") {
  const std::vector<double> adjusted = holm({0.01, 0.04, 0.03, 0.005});
  CHECK(adjusted[0] == Approx(0.03));
  CHECK(adjusted[1] == Approx(0.06));
  CHECK(adjusted[2] == Approx(0.06));
  CHECK(adjusted[3] == Approx(0.02));
  CHECK(holm({}).empty());
  CHECK(holm({0.9, 0.8})[0] == 1);
}

TEST_CASE("a million guessers: 1.07 +- 0.03 % make at most one error in ten") {
  StudyRandom random(1);
  std::size_t passed = 0;
  constexpr std::size_t guessers = 1000000;
  for (std::size_t i = 0; i < guessers; ++i) {
    int errors = 0;
    for (int t = 0; t < 10; ++t) errors += static_cast<int>(drawBelow(random, 2));
    if (errors <= 1) ++passed;
  }
  CHECK(100 * static_cast<double>(passed) / guessers == Approx(1.07).margin(0.03));
}

TEST_CASE("bootstrap over participants: nothing to resample gives nothing, spread gives an interval") {
  CHECK_FALSE(participantBootstrap({}));
  CHECK_FALSE(participantBootstrap({{3, 10}}));
  CHECK_FALSE(participantBootstrap({{3, 10}, {3, 10}, {3, 10}, {3, 10}, {3, 10}, {3, 10}}));
  CHECK_FALSE(participantBootstrap({{0, 150}, {2, 150}, {3, 150}, {5, 150}, {5, 150}}));  // too few
  const std::vector<Count> people{{0, 150}, {2, 150}, {3, 150}, {5, 150}, {5, 150},
                                  {6, 150}, {7, 150}, {8, 150}, {10, 150}};
  const auto interval = participantBootstrap(people);
  REQUIRE(interval);
  const double rate = 46.0 / 1350;
  CHECK(interval->low < rate);
  CHECK(interval->high > rate);
  CHECK(interval->low > 0.01);
  CHECK(interval->high < 0.06);
  CHECK(participantBootstrap(people)->low == interval->low);  // deterministic
}

TEST_CASE("bootstrap: its 95 % cover the true rate about as often as they say") {
  StudyRandom random(7);
  int covered = 0;
  constexpr int studies = 200;
  for (int s = 0; s < studies; ++s) {
    std::vector<Count> people;
    for (int i = 0; i < 18; ++i) {
      const double own = 0.02 + 0.16 * drawShare(random);  // mean 0.10
      Count c{0, 60};
      for (int t = 0; t < 60; ++t) c.errors += drawShare(random) < own ? 1 : 0;
      people.push_back(c);
    }
    const auto i = participantBootstrap(people, {400, 3, 0.95});
    if (i && i->low <= 0.10 && 0.10 <= i->high) ++covered;
  }
  CHECK(covered > studies * 87 / 100);
}

TEST_CASE("groups: alike people give no difference, far ones do") {
  const std::vector<Count> few{{0, 50}, {1, 50}, {2, 50}, {1, 50}, {0, 50}, {1, 50}};
  const std::vector<Count> many{{9, 50}, {12, 50}, {10, 50}, {8, 50}, {11, 50}, {14, 50}};
  CHECK(groupDifferenceP(few, few) > 0.5);
  CHECK(groupDifferenceP(few, many) < 0.01);
  CHECK(groupDifferenceP(few, {}) == 1);
}

TEST_CASE("Student: the quantiles of the printed tables") {
  const struct {
    std::size_t degrees;
    double p, t;
  } table[] = {{1, 0.975, 12.7062}, {2, 0.975, 4.30265}, {3, 0.95, 2.35336},   {4, 0.975, 2.77645},
               {5, 0.995, 4.03214}, {10, 0.9, 1.37218},  {17, 0.975, 2.10982}, {120, 0.975, 1.97993}};
  for (const auto& row : table) CHECK(studentQuantile(row.p, row.degrees) == Approx(row.t).epsilon(5e-6));
  CHECK(studentQuantile(0.5, 3) == Approx(0).margin(1e-6));
  CHECK(studentCdf(-1, 4) == Approx(1 - studentCdf(1, 4)));
  CHECK(studentQuantile(0.975, 100000) == Approx(normalQuantile(0.975)).epsilon(1e-4));
}

TEST_CASE("Spearman: ties, order, constants") {
  CHECK(spearman({1, 2, 3, 4}, {10, 20, 30, 40}) == Approx(1));
  CHECK(spearman({1, 2, 3, 4}, {4, 3, 2, 1}) == Approx(-1));
  CHECK(spearman({1, 2, 2, 3}, {1, 3, 2, 4}) == Approx(0.9486832981));
  CHECK(spearman({1, 1, 1}, {1, 2, 3}) == 0);
}

TEST_CASE("shuffle: every place is equally likely, and the text decides the order") {
  std::vector<std::size_t> at(5, 0);
  StudyRandom random(3);
  for (int i = 0; i < 50000; ++i) {
    std::vector<int> items{0, 1, 2, 3, 4};
    shuffle(items, random);
    for (std::size_t k = 0; k < items.size(); ++k)
      if (items[k] == 0) ++at[k];
  }
  for (const std::size_t n : at) CHECK(static_cast<double>(n) == Approx(10000).margin(400));
  CHECK(randomSeededBy("1:P01")() == randomSeededBy("1:P01")());
  CHECK(randomSeededBy("1:P01")() != randomSeededBy("1:P02")());
}

// p by scipy 1.10.1, stats.permutation_test((d,), mean, permutation_type="samples", n_resamples=inf); limits
// by sorting the means of all subsets in Python.
TEST_CASE(
    "paired: signs of persons flipped, every pattern once; the interval is what the test does not refuse") {
  const PairedDifference better = pairedDifference({0.02, 0.05, 0.01, 0.08, 0.03, 0.04, 0.06, 0.07});
  CHECK(better.mean == Approx(0.045));
  CHECK(better.p == Approx(0.0078125));
  REQUIRE(better.interval);
  CHECK(better.interval->low == Approx(0.023333333333333334));
  CHECK(better.interval->high == Approx(0.06666666666666667));
  const PairedDifference mixed = pairedDifference({0.1, -0.05, 0.2, 0.0, 0.15, -0.02, 0.3, 0.12, 0.07});
  CHECK(mixed.p == Approx(0.0390625));
  CHECK(mixed.interval->low == Approx(0.01));
  CHECK(mixed.interval->high == Approx(0.19));
  const PairedDifference tied = pairedDifference({0.1, 0.2, -0.1, 0.1, 0.0, 0.3});
  CHECK(tied.p == Approx(0.25));
  CHECK(tied.interval->low == Approx(-0.1));
}

TEST_CASE("paired: few people, nobody, no difference, many people") {
  CHECK(pairedDifference({0.1, 0.2, -0.3}).mean == 0);  // not -0.00 or +0.00 for want of the last digit
  CHECK(pairedDifference({}).p == 1);
  CHECK(pairedDifference({0, 0, 0, 0, 0, 0, 0}).p == 1);
  CHECK_FALSE(pairedDifference({0.1, 0.2, 0.3, 0.4, 0.5}).interval);
  CHECK(pairedDifference({0.1, 0.2, 0.3, 0.4, 0.5}).p == Approx(2.0 / 32));
  std::vector<double> many;
  for (int i = 0; i < 40; ++i) many.push_back(0.1 + 0.01 * i);
  const PairedDifference far = pairedDifference(many);
  CHECK(far.p < 1e-4);
  CHECK(far.interval->low > 0.2);
  CHECK(far.interval->high < 0.4);
  std::vector<double> around;
  for (int i = 0; i < 40; ++i) around.push_back(i % 2 == 0 ? 0.1 : -0.1);
  CHECK(pairedDifference(around).p == 1);
}

TEST_CASE(
    "paired: its 5 % are kept where nothing differs, and it finds what the best test of nine people finds") {
  StudyRandom random(7);
  const auto normal = [&] { return normalQuantile(std::max(drawShare(random), 1e-12)); };
  int falseAlarms = 0, covered = 0, found = 0;
  constexpr int studies = 1500;
  for (int i = 0; i < studies; ++i) {
    std::vector<double> d(9);
    for (double& x : d) x = normal();
    const PairedDifference null = pairedDifference(d);
    falseAlarms += null.p <= 0.05 ? 1 : 0;
    covered += null.interval->low <= 0 && null.interval->high >= 0 ? 1 : 0;
    for (double& x : d) x += 1;
    found += pairedDifference(d).p <= 0.05 ? 1 : 0;
  }
  CHECK(falseAlarms < 0.065 * studies);  // 4.98 % at most: 25.5 of 512 patterns
  CHECK(falseAlarms > 0.03 * studies);
  CHECK(covered > 0.93 * studies);
  CHECK(found == Approx(0.75 * studies).margin(0.05 * studies));  // t test of nine: 0.75
}

TEST_CASE("Spearman: its p by shuffling") {
  const std::vector<double> x{1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  CHECK(spearmanP(x, x) == Approx(1e-4));
  CHECK(spearmanP(x, {10, 9, 8, 7, 6, 5, 4, 3, 2, 1}) == Approx(1).margin(1e-3));
  CHECK(spearmanP(x, std::vector<double>(10, 1)) == 1);
  CHECK(spearmanP(x, {2, 1, 4, 3, 6, 5, 7, 10, 9, 8}) < 0.01);
}

// Right values: tests/cli/same_different_test.py, by scipy.
TEST_CASE("same/different: d' by both models, its likelihood interval, and an exact p", "[study]") {
  const SameDifferentDPrime d = dPrimeOf({60, 48, 60, 21});
  CHECK(d.differencing == Approx(2.4944355544765506).epsilon(1e-9));
  CHECK(d.independent == Approx(1.982979769666547).epsilon(1e-9));
  CHECK(d.low == Approx(1.8467755691813572).epsilon(1e-5));
  REQUIRE(d.high);
  CHECK(*d.high == Approx(3.132826477253325).epsilon(1e-5));
  CHECK_FALSE(d.moved);
  const SameDifferentDPrime perfect = dPrimeOf({10, 10, 10, 0});
  CHECK(perfect.differencing == Approx(5.097981776093407).epsilon(1e-9));
  CHECK(perfect.independent == Approx(3.8976437250145435).epsilon(1e-9));
  CHECK(perfect.moved);
  CHECK_FALSE(perfect.high);
  CHECK(perfect.low > 1);
  const SameDifferentDPrime none = dPrimeOf({40, 12, 40, 14});
  CHECK(none.differencing == 0);
  CHECK(none.low == 0);
  CHECK(none.high);
  CHECK(guessedP({{10, 7, 10, 3}, {10, 9, 10, 6}}) == Approx(0.021648169785911924).epsilon(1e-9));
  CHECK(guessedP({{10, 0, 10, 0}, {10, 10, 10, 10}}) == Approx(1));  // always the same answer says nothing
}
