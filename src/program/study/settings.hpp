// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/study/variant_runs.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// Which variants of a deck a study runs, and their decks.
namespace spricka::program {

/// What is varied; settings of one family with several sizes are a series.
enum class SettingFamily {
  given,      ///< the deck as it is
  whole,      ///< meshes of bodies and nets of tips, all sizes alike; a deck without cracks: bodies
  host,       ///< meshes of bodies alone
  tip,        ///< nets of tips alone
  quarter,    ///< all sizes, with QUARTER=NO
  linear,     ///< all sizes, with linear elements
  transition, ///< JOIN=TRANSITION
  tube,       ///< TUBE=NO
  part,       ///< one side of the planes of symmetry
  tolerance,  ///< TOL, from the coarsest mesh
  path,       ///< steps in place of load paths
  asked,      ///< --vary
  peer        ///< CalculiX on the meshes of others
};

/// For legends: "all sizes", "without quarter points".
const char* display_name(SettingFamily family);

struct StudySetting : DeckVariant {
  SettingFamily family = SettingFamily::given;
  double fineness = 1.0; ///< elements have 1/fineness of the deck's sizes, where those vary
};

/// A parameter and the values that the command line wants of it.
struct ParameterVariation {
  std::string parameter;
  std::vector<std::string> values;
};

struct StudyPlan {
  std::vector<StudySetting> settings; ///< the deck itself first, then by worth
  std::vector<std::string> notes;     ///< what cannot be varied, and why
  MeshParameterSet mesh_parameter;
};

/// Writes the decks of all settings into `folder`. Finenesses at which numbers of elements would be
/// broken are replaced by the next that a deck can be read with.
StudyPlan plan_study_settings(const StudiedDeck& deck,
                              const std::vector<ParameterVariation>& requests,
                              const std::filesystem::path& folder);

} // namespace spricka::program
