// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/verify/verification.hpp"
#include "report/drawing/table.hpp"

#include <array>
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
  [[nodiscard]] bool is_unchanged() const;
};

/// One of the lists of changes, and how it is told.
struct ChangeKind {
  std::vector<VerificationChange> VerificationComparison::*changes;
  const char* in_summary;
  const char* in_table;
  double unit = 1.0; ///< times which its values stand in the table
};

/// In the order of the table.
inline constexpr std::array change_kinds{
    ChangeKind{&VerificationComparison::failed, "missed now", "missed now (error)"},
    ChangeKind{&VerificationComparison::worse, "larger error", "larger error"},
    ChangeKind{&VerificationComparison::slower, "slower", "slower (CPU, s)"},
    ChangeKind{&VerificationComparison::larger, "more memory", "more memory (MB)", 1e-6},
    ChangeKind{&VerificationComparison::passed, "passed again", "passed again (error)"},
    ChangeKind{&VerificationComparison::better, "smaller error", "smaller error"},
    ChangeKind{&VerificationComparison::faster, "faster", "faster (CPU, s)"}};

/// An error counts as another one where it differs by a tenth and by a hundredth of what is
/// allowed. CPU is compared when the machine's name is the same: a deck is slower when it takes
/// more than 1.5 times what the pace of all decks (their median ratio, which is what else the
/// machine has to do) makes expect, and the difference is more than the noise, four times what the
/// cheapest deck takes altogether. Memory counts from 1.2 times on.
VerificationComparison compare_verifications(const Verification& now, const Verification& before);

/// "larger error: 2, slower: 1"; "nothing has changed".
std::string comparison_summary(const VerificationComparison& comparison);

/// What has changed since the last verification; without rows: nothing.
report::ReportTable verification_change_table(const VerificationComparison& comparison);

} // namespace spricka::program
