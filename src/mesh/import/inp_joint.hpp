// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/label.hpp"
#include "base/vec.hpp"
#include "mesh/import/inp_text.hpp"

#include <compare>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace spricka::mesh {

/// Contact, ties, supports and loads of an input file as they are written, for whoever makes cards
/// of a deck of them. Names are those of the file, without its instance.
struct InpJointCards {
  struct InpContactPair {
    std::string name; ///< of a tie that has one
    std::string slave, master;
    std::string interaction;         ///< empty of a tie
    std::optional<double> adjust;    ///< slave nodes as near as this are moved onto the master
    std::optional<double> clearance; ///< *CLEARANCE, VALUE=
    bool tie = false;
    InpLocation place;
  };
  struct InpSurfaceInteraction {
    std::string name;
    double friction = 0.0;
    bool tied = false; ///< PRESSURE-OVERCLOSURE=TIED
    bool soft = false; ///< a contact stiffness is given
    bool without_slip = false;
    InpLocation place;
  };
  struct InpTarget {
    std::string set;      ///< or empty:
    base::Label node = 0; ///< of an element for forces per volume
    auto operator<=>(const InpTarget&) const = default;
  };
  struct InpDisplacement {
    InpTarget of;
    int dof = 0; ///< from 0
    double value = 0.0;
    InpLocation place;
  };
  enum class InpLoadKind { force, pressure, body };
  struct InpLoad {
    InpLoadKind kind = InpLoadKind::force;
    InpTarget on; ///< nodes, a surface, elements
    /// Force on each node, force per volume; the first is a pressure.
    base::Vec3 value = base::Vec3::Zero();
    bool per_mass = false; ///< an acceleration
    InpLocation place;
  };
  /// What cards say outside of steps or in one step.
  struct InpStepContent {
    std::string procedure;                                                ///< "STATIC"
    bool large_displacements = false;                                     ///< NLGEOM
    bool new_supports = false, new_forces = false, new_pressures = false; ///< OP=NEW
    std::vector<InpDisplacement> displacements;
    std::vector<InpLoad> loads;
    InpLocation place;
  };

  std::string title;
  std::vector<InpContactPair> pairs;
  std::vector<InpSurfaceInteraction> interactions;
  std::vector<InpStepContent> steps{1}; ///< the first is what stands outside of steps
  std::size_t side_pressures = 0;       ///< surfaces DLOAD_1, DLOAD_2 .. of sides under *DLOAD
};

} // namespace spricka::mesh
