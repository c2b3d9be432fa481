// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Interpretations compete: each candidate carries named evidence in one unit, the natural logarithm of a
// likelihood ratio. The best few are kept; the margins to those that would give a different result are the
// confidence.

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace detent::importer {

/// One reason for or against an interpretation.
struct EvidenceTerm {
  std::string name;          ///< "title", "unit", "travel": as scripts see it
  std::string about;         ///< source of the conclusion: a column's title, a value
  double logLikelihood = 0;  ///< > 0 speaks for it
};

/// Sum of named evidence. Rules of thumb overlap, so each counts only in part (kRuleWorth, calibrated on
/// drawn tables: docs/measurements/import-confidence.md). Measured distributions count in full.
class Evidence {
 public:
  /// Adds a rule of thumb with the log-likelihood that it would have alone.
  void add(std::string name, std::string about, double ruleOfThumb) {
    addCounted(std::move(name), std::move(about), kRuleWorth * ruleOfThumb);
  }
  void addCounted(std::string name, std::string about, double logLikelihood) {
    terms_.push_back({std::move(name), std::move(about), logLikelihood});
    total_ += logLikelihood;
  }
  void add(const Evidence& other) {
    terms_.insert(terms_.end(), other.terms_.begin(), other.terms_.end());
    total_ += other.total_;
  }
  double total() const { return total_; }
  const std::vector<EvidenceTerm>& terms() const { return terms_; }

  static constexpr double kRuleWorth = 0.5;  ///< share of a rule's log-likelihood

 private:
  std::vector<EvidenceTerm> terms_;
  double total_ = 0;
};

/// One of the best interpretations: its assignment of roles and the reasons, for --explain and the editor.
struct ExplainedInterpretation {
  std::string reading;  ///< "displacement 1 \"Travel (mm)\", force 2 \"Force (N)\""
  Evidence evidence;
};

/// A way to answer a question: `option` as the command line takes it.
struct Choice {
  std::string text, option;
};

/// The point in which the remaining interpretations differ, as a question to the user.
struct Question {
  std::string what;
  std::vector<Choice> choices;
};

/// Keeps the `most` candidates of the highest evidence, the best first. `Candidate` has a member `evidence`.
template <class Candidate>
class BestFew {
 public:
  explicit BestFew(std::size_t most) : most_(most) {}
  void offer(Candidate candidate) {
    const auto place = std::ranges::upper_bound(
        kept_, candidate.evidence.total(), [](double a, double b) { return a > b; },
        [](const Candidate& c) { return c.evidence.total(); });
    kept_.insert(place, std::move(candidate));
    if (kept_.size() > most_) kept_.pop_back();
  }
  const std::vector<Candidate>& kept() const { return kept_; }
  std::vector<Candidate>& kept() { return kept_; }

 private:
  std::size_t most_;
  std::vector<Candidate> kept_;
};

/// Probability of an interpretation among its rivals, by the margins of its evidence over theirs; 1 without
/// rivals.
double confidenceOfMargins(const std::vector<double>& margins);

/// The table that --explain prints: a column per interpretation, a row per term.
std::string explanationTable(const std::vector<ExplainedInterpretation>& best);

}  // namespace detent::importer
