// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "base/source.hpp"

#include <array>
#include <cstddef>
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

/// A history of places t on a load path; one pass through it is the unit of life.
struct SpectrumDefinition {
  std::string name;
  std::size_t path = 0;                             ///< of Model::load_paths
  bool sequence = false;                            ///< turning points; else cycles
  CycleCounting counting = CycleCounting::rainflow; ///< of turning points
  std::vector<std::array<double, 3>> cycles;        ///< low t, high t, count
  std::vector<double> turning_points;               ///< t, in their order
  base::SourceSpan span;
};

} // namespace spricka::model
