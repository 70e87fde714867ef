// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "base/source.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// Steps of loads and fits, paths through them and histories on those.
namespace spricka::model {

struct ApplyLoad {
  base::CaseId load_case;
  double factor = 1.0;
  bool operator==(const ApplyLoad&) const = default;
};
struct ApplyFit {
  base::ContactId contact;
  double factor = 1.0;
  bool operator==(const ApplyFit&) const = default;
};
struct MountContact {
  base::ContactId contact;
  bool operator==(const MountContact&) const = default;
};
struct DismountContact {
  base::ContactId contact;
  bool operator==(const DismountContact&) const = default;
};
using StepAction = std::variant<ApplyLoad, ApplyFit, MountContact, DismountContact>;

struct Step {
  std::string name;
  int substeps = 1; ///< 0: as many as the shear of contacts that rub needs
  std::vector<StepAction> actions;
  base::SourceSpan span;
};

/// A straight path through loads and fits: (1 - t) times those at the end of step `from` and t
/// times those of step `to`, t from 0 to `beyond`. Nothing is mounted or dismounted in between.
struct LoadPathDefinition {
  std::string name;
  base::StepId from;
  base::StepId to;
  double beyond = 1.0;
  base::SourceSpan span;
};

/// How the cycles of a history are found: closed ranges of a pass that repeats (ASTM E1049), or
/// each valley with the peak behind it.
enum class CycleCounting { rainflow, pairs };

/// What a life is told in besides passes: each has so many of them.
enum class SpectrumLifeUnit { passes, flights, hours, cycles };

/// Loads of a history before some were cut or left out.
struct UnreducedLoads {
  std::vector<std::array<double, 3>> cycles;
  std::vector<double> turning_points;
};

/// What the loads of a history were written as: v = at_from + (at_to - at_from) t.
struct SpectrumValues {
  std::string unit; ///< as the deck names it, may be empty
  double at_from = 0.0, at_to = 1.0;

  [[nodiscard]] double value_at(double t) const { return at_from + (at_to - at_from) * t; }
  [[nodiscard]] double place_of(double value) const {
    return (value - at_from) / (at_to - at_from);
  }
};

/// A history of places t on a load path; one pass through it is the unit of life.
struct SpectrumDefinition {
  std::string name;
  std::size_t path = 0;                             ///< of Model::load_paths
  bool sequence = false;                            ///< turning points; else cycles
  CycleCounting counting = CycleCounting::rainflow; ///< of turning points
  std::vector<std::array<double, 3>> cycles;        ///< low t, high t, count
  std::vector<double> turning_points;               ///< t, in their order
  std::optional<SpectrumValues> values;             ///< where the loads are not places t
  std::optional<double> clip;                       ///< t that higher ones were brought down to
  std::optional<double> omit;                       ///< range of t, smaller ones were left out
  std::optional<UnreducedLoads> unreduced;          ///< with clip or omit: what was there before
  SpectrumLifeUnit life_unit = SpectrumLifeUnit::passes;
  double life_units_per_pass = 1.0; ///< flights or hours
  std::string origin;               ///< of a generated history: how it was made, a sentence
  base::SourceSpan span;
};

} // namespace spricka::model
