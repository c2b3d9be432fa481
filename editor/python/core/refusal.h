// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A Failure that becomes a Python exception of its kind.

#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/result.h"

namespace detent::python {

/// Data of the exception.
struct Refused {
  int code = 1;                       ///< the programs' exit code
  std::string sentence;               ///< the sentence that the program would print
  std::vector<std::string> remedies;  ///< one entry per remedy, most likely first
  std::string reportJson;             ///< the program's output with --json; empty if there is none

  static Refused from(const Failure& failure, std::string reportJson = {});
};

/// Becomes detent.Failure or one of its subclasses.
class Refusal : public std::exception {
 public:
  explicit Refusal(Refused why) : why_(std::move(why)) {}
  const Refused& why() const { return why_; }
  const char* what() const noexcept override { return why_.sentence.c_str(); }

 private:
  Refused why_;
};

/// A value, or the Refusal to throw once Python's lock is held again.
template <class T>
struct Answer {
  std::optional<T> value;
  Refused refused;

  T take() && {
    if (!value) throw Refusal(std::move(refused));
    return *std::move(value);
  }
};

/// Result of `work`. An exception becomes the Refusal that the program would report.
template <class T, class Work>
Answer<T> answerOf(const Work& work) {
  try {
    return {work(), {}};
  } catch (const Refusal& refusal) {
    return {{}, refusal.why()};
  } catch (const std::bad_alloc&) {
    return {{}, {3, "needs more memory than is available.", {}, {}}};
  } catch (const std::exception& fault) {
    return {{},
            {1,
             std::string("internal fault: ") + fault.what() + ". Please report it with the input file.",
             {},
             {}}};
  }
}

/// Returns the value, or throws its Failure as a Refusal.
template <class T>
T valueOf(Result<T> result) {
  if (!result) throw Refusal(Refused::from(result.failure()));
  return std::move(*result);
}

}  // namespace detent::python
