// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "archive/card_marks.hpp"
#include "model/forward.hpp"
#include "results/results.hpp"
#include "results/store.hpp"

#include <array>
#include <string>
#include <vector>

/// The list of a restart file: what was kept, and of which deck.
namespace spricka::archive {

/// How the list knows an increment.
struct CheckpointEntry {
  int round = 1; ///< of $TIPNET TOL
  int number = 1;
  double asked = 0.0; ///< crack length that the loop asked for; 0: it found it itself
  std::string law;    ///< that its state is of, and spectrum, as growth_law_text() tells them
  std::string file;   ///< in the folder
  std::string hash;   ///< of the file's content
  double cpu = 0.0, wall = 0.0;
  std::vector<results::LogLine> log;
};

struct CheckpointList {
  std::vector<CardFingerprint> cards;
  std::vector<CheckpointEntry> entries;
  std::string growth;           ///< growth_settings_text() of the deck
  std::string course;           ///< growth_course_text() of the deck
  std::array<double, 2> ends{}; ///< growth_length_and_cycle_limits() of the deck
};

/// Writes cards and entries as tables, the growth's rules and ends as attributes.
void write_checkpoint_list_group(results::StoreGroup root, const CheckpointList& list);
/// Reads back what write_checkpoint_list_group has written. Throws StoreError.
CheckpointList read_checkpoint_list_group(const results::StoreGroup& root);

/// What of $GROW every increment depends on, in words. Lengths of LAW=INCREMENT are compared one by
/// one; AMAX and CYCLES only say where a growth ends.
std::string growth_settings_text(const model::Model& model);
/// The same with the spectra, of whose cards `cards` has the hashes: all that rates depend on.
std::string growth_law_text(const model::Model& model, const std::vector<CardFingerprint>& cards);
/// What of $GROW says where cracks go and what is kept of them, whatever the law, in words.
std::string growth_course_text(const model::Model& model);
/// Where a growth by a law ends: AMAX, CYCLES; infinite where there is none.
std::array<double, 2> growth_length_and_cycle_limits(const model::Model& model);

} // namespace spricka::archive
