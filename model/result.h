// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// External errors: a value, or a Failure with problem and remedies as data. Programming errors are
// DETENT_CHECKs; doubts are importer::Found.

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "model/message.h"
#include "model/remedy.h"

namespace detent {

/// Kind of a failure. The numbers are the programs' exit codes (docs/develop/architecture.md).
enum class FailureCode {
  internalFault = 1,    ///< a programming error that was caught
  wrongUsage = 2,       ///< an invalid call or argument
  unreadableInput = 3,  ///< the input is missing, broken, too large, or of another type than its name says
  noForceGraph = 4,     ///< readable, but without a force graph
  notCertain = 5,       ///< found, but not certain enough; the remedies say what to give
  deviceTrouble = 6,    ///< a device is missing, busy or lost
  cancelled = 130       ///< cancelled by the caller; the shell's number for Ctrl-C
};

/// "unreadable_input": name for scripts.
std::string_view nameOf(FailureCode code);

/// Subject of a Failure. Text made at run time is the name of a file or device; a literal is a part in words,
/// such as "press curve".
struct Subject {
  enum class Kind {
    none,
    named,  ///< a file or device by its name
    part,   ///< "press curve", "plot frame"
    option  ///< a command line option: "--frame"
  };
  Subject() = default;
  Subject(const std::string& itsOwn) : Subject(itsOwn.empty() ? Kind::none : Kind::named, Message(itsOwn)) {}
  template <std::size_t n>
  Subject(const char (&part)[n]) : Subject(n > 1 ? Kind::part : Kind::none, Message(part)) {}
  Subject(std::same_as<const char*> auto part) : Subject(Kind::part, Message(part)) {}
  static Subject option(std::string spelled) { return {Kind::option, std::move(spelled)}; }

  bool empty() const { return kind == Kind::none; }

  Kind kind = Kind::none;
  Message name;

 private:
  Subject(Kind itsKind, Message itsName) : kind(itsKind), name(std::move(itsName)) {}
};

/// An external error. Plain value, any thread.
struct Failure {
  FailureCode code = FailureCode::internalFault;
  Subject subject;               ///< the file or value: "plot.png", "press curve"
  Message place;                 ///< place in the subject: "page 3", "knot 4", "line 17"; may be empty
  Message problem;               ///< the fault, with the offending value
  Remedies remedies;             ///< next steps for the user
  std::string_view reason = {};  ///< the room's own code for the problem; static lifetime; may be empty

  /// Failure of a step that was cancelled.
  static Failure cancelled(Subject subject = {}) {
    return {FailureCode::cancelled, std::move(subject), {}, "cancelled", {}};
  }

  /// "SUBJECT, PLACE: PROBLEM. REMEDIES." on one line.
  std::string sentence() const;

  int exitCode() const { return static_cast<int>(code); }
};

/// A value or a Failure. Accessing the one that is not present is a programming error (checked).
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
