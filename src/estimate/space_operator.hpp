// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "estimate/element_block.hpp"
#include "estimate/space_numbers.hpp"
#include "model/forward.hpp"
#include "model/mesh.hpp"

#include <cstddef>
#include <vector>

/// The stiffness of the cubic modes of a mesh of solids as an operator. No matrix is kept: it is
/// larger than what it is made of. Blocks of elements of one type go through the points of a rule
/// together (fe.8): their gradients and their forces are each one dense product with the slopes of
/// the functions in reference coordinates, the same for all elements of a type.
namespace spricka::estimate {

/// Points at which the stiffness of modes is integrated: as many as curved elements need, or fewer
/// where an approximation serves.
enum class ModeStiffnessRule { full, reduced };

class SolidModeStiffness {
public:
  /// The mesh must outlive it.
  SolidModeStiffness(const model::Model& model, const model::Mesh& mesh, SolidModeNumbers numbers);

  [[nodiscard]] const SolidModeNumbers& mode_numbers() const { return numbers_; }

  /// Displacements of nodes [3 * node] and of modes [3 * mode]; null: zero.
  struct NodalAndModeDisplacements {
    const base::Vector* nodes = nullptr;
    const base::Vector* modes = nullptr;
  };
  /// Where forces on them are added up; null: not asked for.
  struct NodalAndModeForces {
    base::Vector* nodes = nullptr;
    base::Vector* modes = nullptr;
  };
  /// Adds the elastic forces of nodal and mode displacements to the vectors asked for, which have
  /// their sizes already.
  void add_forces(const NodalAndModeDisplacements& motion, const NodalAndModeForces& forces,
                  ModeStiffnessRule rule = ModeStiffnessRule::full) const;

  /// The 3 by 3 blocks on the diagonal of K_ee. [mode]
  [[nodiscard]] std::vector<Eigen::Matrix3d> diagonal_blocks() const;

private:
  /// What blocks are asked for.
  struct ForceRequest {
    const NodalAndModeDisplacements& motion;
    const NodalAndModeForces& wanted;
    ModeStiffnessRule rule;
  };
  void make_forces(const ElementBlock& block, const ForceRequest& asked, base::Matrix& Z,
                   base::Matrix& G, base::Matrix& F) const;
  void add_diagonal(const ElementBlock& block, std::vector<Eigen::Matrix3d>& diagonal) const;

  const model::Mesh& mesh_;
  SolidModeNumbers numbers_;
  std::vector<ElementBlock> blocks_;
};

} // namespace spricka::estimate
