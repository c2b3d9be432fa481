// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How the rooms report the world's faults (STYLE 7): a value, or a sentence that helps.
// Bugs of ours are DETENT_CHECKs; doubt is importer::Found, not an error.

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace detent {

/// Why something could not be done. The numbers are the programs' exit codes (DESIGN.md).
enum class FailureCode {
  internalFault = 1,    ///< a bug of ours, caught
  wrongUsage = 2,       ///< a call or argument that cannot mean anything
  unreadableInput = 3,  ///< the input is missing, broken, too large, or not what it says it is
  noForceGraph = 4,     ///< readable, but no force graph stands in it
  notCertain = 5,       ///< found, but not certain enough; `remedy` says what to pass
  deviceTrouble = 6     ///< a device is missing, busy or lost
};

/// One fault of the world, in the three parts every message has. Plain value, any thread.
struct Failure {
  FailureCode code = FailureCode::internalFault;
  std::string subject;  ///< the file or value: "plot.png", "press curve"
  std::string place;    ///< where in it: "page 3", "knot 4", "line 17"; may be empty
  std::string problem;  ///< what is wrong, with the offending value
  std::string remedy;   ///< what to do next

  /// "SUBJECT, PLACE: PROBLEM. REMEDY." in one line.
  std::string sentence() const;

  int exitCode() const { return static_cast<int>(code); }
};

/// A value or the Failure that prevented it. Asking for the one that is not there is a bug (checked).
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Failure failure) : state_(std::in_place_index<1>, std::move(failure)) {}

  bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  const T& value() const& { return std::get<0>(state_); }
  T& value() & { return std::get<0>(state_); }
  T&& value() && { return std::get<0>(std::move(state_)); }
  const T& operator*() const& { return value(); }
  T& operator*() & { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  const T* operator->() const { return &value(); }
  T* operator->() { return &value(); }

  const Failure& failure() const { return std::get<1>(state_); }

 private:
  std::variant<T, Failure> state_;
};

/// Success without a value.
struct Done {};

}  // namespace detent
