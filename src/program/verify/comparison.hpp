// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/verify/verification.hpp"

#include <string>
#include <vector>

namespace spricka::program {

/// A check that has another error than in the last verification, or a deck that costs something
/// else.
struct VerificationChange {
  std::string deck;
  std::string what; ///< the check with the values of its point; empty: of the deck
  double before = 0.0;
  double now = 0.0;
};

/// A verification beside the last one, as far as both have the same decks.
struct VerificationComparison {
  std::string program, machine;           ///< of the last one
  std::vector<VerificationChange> failed; ///< missed now, passed before (errors)
  std::vector<VerificationChange> passed; ///< the other way round
  std::vector<VerificationChange> worse;  ///< larger errors, still allowed
  std::vector<VerificationChange> better;
  std::vector<VerificationChange> slower, faster; ///< CPU [s]; empty on another machine
  std::vector<VerificationChange> larger;         ///< memory [bytes]
  double pace = 1.0; ///< CPU of the decks that both have over that before, in the median
  bool same_machine = false;

  /// Whether nothing failed, passed, changed its error, time or memory against the run before.
  [[nodiscard]] bool is_unchanged() const {
    return failed.empty() && passed.empty() && worse.empty() && better.empty() && slower.empty() &&
           faster.empty() && larger.empty();
  }
};

/// An error counts as another one where it differs by a tenth and by a hundredth of what is
/// allowed. CPU is compared when the machine's name is the same: a deck is slower when it takes
/// more than 1.5 times what the pace of all decks (their median ratio, which is what else the
/// machine has to do) makes expect, and the difference is more than the noise, four times what the
/// cheapest deck takes altogether. Memory counts from 1.2 times on.
VerificationComparison compare(const Verification& now, const Verification& before);

/// "larger error: 2, slower: 1"; "nothing has changed".
std::string summary(const VerificationComparison& comparison);

} // namespace spricka::program
