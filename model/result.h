// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How the rooms report the world's faults: a value, or what is wrong and what helps, as data.
// Bugs of ours are DETENT_CHECKs; doubt is importer::Found, not an error.

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "model/message.h"
#include "model/remedy.h"

namespace detent {

/// Why something could not be done. The numbers are the programs' exit codes (docs/develop/architecture.md).
enum class FailureCode {
  internalFault = 1,    ///< a bug of ours, caught
  wrongUsage = 2,       ///< a call or argument that cannot mean anything
  unreadableInput = 3,  ///< the input is missing, broken, too large, or not what it says it is
  noForceGraph = 4,     ///< readable, but no force graph stands in it
  notCertain = 5,       ///< found, but not certain enough; the remedies say what to give by hand
  deviceTrouble = 6,    ///< a device is missing, busy or lost
  cancelled = 130       ///< who asked for it does not want it any more; the shell's number for Ctrl-C
};

/// "unreadable_input": as scripts see it.
std::string_view nameOf(FailureCode code);

/// What a Failure is about. A text made while running is something's own name, a literal a part in words.
struct Subject {
  enum class Kind {
    none,
    named,  ///< a file, a device: by its own name
    part,   ///< "press curve", "plot frame"
    option  ///< an option of the program: "--frame"
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

/// One fault of the world, in the parts every message has. Plain value, any thread.
struct Failure {
  FailureCode code = FailureCode::internalFault;
  Subject subject;               ///< the file or value: "plot.png", "press curve"
  Message place;                 ///< where in it: "page 3", "knot 4", "line 17"; may be empty
  Message problem;               ///< what is wrong, with the offending value
  Remedies remedies;             ///< what to do next
  std::string_view reason = {};  ///< the room's own code of what is wrong, where it has one; never freed

  /// What a step gives that was told to stop.
  static Failure cancelled(Subject subject = {}) {
    return {FailureCode::cancelled, std::move(subject), {}, "cancelled", {}};
  }

  /// "SUBJECT, PLACE: PROBLEM. REMEDIES." in one line, as a program says it.
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
