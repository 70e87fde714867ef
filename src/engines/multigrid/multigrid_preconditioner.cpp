// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/multigrid/multigrid_preconditioner.hpp"
#include "engines/multigrid/petsc_session.hpp"

#include <array>

#include <petscksp.h>

namespace spricka::engines {

namespace {

constexpr PetscInt unknowns_of_node = 3;

const NodalStiffness& stiffness_of(Mat matrix) {
  void* context = nullptr;
  MatShellGetContext(matrix, &context);
  return *static_cast<const NodalStiffness*>(context);
}

PetscErrorCode multiply_by_stiffness(Mat matrix, Vec x, Vec y) {
  const double* from = nullptr;
  double* to = nullptr;
  PetscCall(VecGetArrayRead(x, &from));
  PetscCall(VecGetArrayWrite(y, &to));
  stiffness_of(matrix).multiply(from, to);
  PetscCall(VecRestoreArrayRead(x, &from));
  return VecRestoreArrayWrite(y, &to);
}

PetscErrorCode copy_stiffness_diagonal(Mat matrix, Vec y) {
  double* to = nullptr;
  PetscCall(VecGetArrayWrite(y, &to));
  stiffness_of(matrix).copy_diagonal(to);
  return VecRestoreArrayWrite(y, &to);
}

// The motions that a coarse level must have without an error [3 nodes, 6]; PETSc looks at them
// where they are.
void give_rigid_motions(const base::Matrix& motions, Mat matrix) {
  std::array<PetscVector, 6> vectors;
  std::array<Vec, 6> views{};
  for (std::size_t k = 0; k < vectors.size(); ++k) {
    throw_if_petsc_failed(VecCreateSeqWithArray(
        PETSC_COMM_SELF, unknowns_of_node, static_cast<PetscInt>(motions.rows()),
        motions.col(static_cast<Eigen::Index>(k)).data(), vectors[k].put()));
    views[k] = vectors[k].get();
  }
  PetscNullSpace space;
  throw_if_petsc_failed(MatNullSpaceCreate(PETSC_COMM_SELF, PETSC_FALSE,
                                           static_cast<PetscInt>(views.size()), views.data(),
                                           space.put()));
  throw_if_petsc_failed(MatSetNearNullSpace(matrix, space.get()));
}

} // namespace

struct MultigridPreconditioner::Hierarchy {
  FullRows rows;         ///< while the levels are made; for good where there is one level only
  PetscMatrix assembled; ///< a view of these
  PetscMatrix stiffness; ///< a view of the nodal one, which the finest level works with
  PetscVector residual, correction;
  PetscPreconditioner levels;

  explicit Hierarchy(const NodalStiffness& K);
  void make_levels(const NodalStiffness& K);
  void give_finest_level(const NodalStiffness& K);
};

MultigridPreconditioner::Hierarchy::Hierarchy(const NodalStiffness& K) {
  make_levels(K);
  give_finest_level(K);
  const auto n = static_cast<PetscInt>(unknowns_of_node * K.nodes());
  throw_if_petsc_failed(
      VecCreateSeqWithArray(PETSC_COMM_SELF, unknowns_of_node, n, nullptr, residual.put()));
  throw_if_petsc_failed(
      VecCreateSeqWithArray(PETSC_COMM_SELF, unknowns_of_node, n, nullptr, correction.put()));
}

void MultigridPreconditioner::Hierarchy::make_levels(const NodalStiffness& K) {
  rows = K.full_rows();
  const base::Matrix motions = K.rigid_motions();
  const auto n = static_cast<PetscInt>(unknowns_of_node * K.nodes());
  throw_if_petsc_failed(MatCreateSeqAIJWithArrays(PETSC_COMM_SELF, n, n, rows.start.data(),
                                                  rows.column.data(), rows.value.data(),
                                                  assembled.put()));
  throw_if_petsc_failed(MatSetBlockSize(assembled.get(), unknowns_of_node));
  throw_if_petsc_failed(MatSetOption(assembled.get(), MAT_SPD, PETSC_TRUE));
  give_rigid_motions(motions, assembled.get());
  throw_if_petsc_failed(PCCreate(PETSC_COMM_SELF, levels.put()));
  PC pc = levels.get();
  throw_if_petsc_failed(PCSetOptionsPrefix(pc, "spricka_"));
  throw_if_petsc_failed(PCSetOperators(pc, assembled.get(), assembled.get()));
  throw_if_petsc_failed(PCSetType(pc, PCGAMG));
  // Smoothed prolongations save iterations, but make the levels below so full that one load on a
  // cube of 3e5 unknowns takes twice the time.
  throw_if_petsc_failed(PCGAMGSetNSmooths(pc, 0));
  // Aggregates of the finest level reach two elements far: those of one leave so many that the
  // level below takes most of the time.
  throw_if_petsc_failed(PCGAMGSetAggressiveLevels(pc, 1));
  throw_if_petsc_failed(PCSetUp(pc));
  throw_if_petsc_failed(PCMGSetCycleType(pc, PC_MG_CYCLE_W));
  throw_if_petsc_failed(PCSetReusePreconditioner(pc, PETSC_TRUE));
  throw_if_petsc_failed(MatSetNearNullSpace(assembled.get(), nullptr));
}

void MultigridPreconditioner::Hierarchy::give_finest_level(const NodalStiffness& K) {
  PetscInt count = 0;
  throw_if_petsc_failed(PCMGGetLevels(levels.get(), &count));
  if (count < 2) {
    return; // so few unknowns that they are solved for at once
  }
  const auto n = static_cast<PetscInt>(unknowns_of_node * K.nodes());
  // PETSc takes no pointer to const; what it is given calls nothing but const functions.
  void* const context = const_cast<NodalStiffness*>(&K); // NOLINT(*-const-cast)
  throw_if_petsc_failed(MatCreateShell(PETSC_COMM_SELF, n, n, n, n, context, stiffness.put()));
  Mat view = stiffness.get();
  const auto function = [](auto* f) { return reinterpret_cast<void (*)()>(f); }; // NOLINT
  throw_if_petsc_failed(MatShellSetOperation(view, MATOP_MULT, function(multiply_by_stiffness)));
  throw_if_petsc_failed(
      MatShellSetOperation(view, MATOP_GET_DIAGONAL, function(copy_stiffness_diagonal)));
  KSP smoother = nullptr;
  throw_if_petsc_failed(PCMGGetSmoother(levels.get(), count - 1, &smoother));
  throw_if_petsc_failed(KSPSetOperators(smoother, view, view));
  throw_if_petsc_failed(KSPSetUp(smoother));
  throw_if_petsc_failed(PCMGSetResidual(levels.get(), count - 1, PCMGResidualDefault, view));
  rows = FullRows(); // no level looks at them again
}

MultigridPreconditioner::MultigridPreconditioner(const NodalStiffness& K) {
  const PetscSession session;
  hierarchy_ = std::make_unique<Hierarchy>(K);
}

MultigridPreconditioner::~MultigridPreconditioner() {
  const PetscSession session;
  hierarchy_.reset();
}

void MultigridPreconditioner::apply(const base::Vector& r, base::Vector& z) const {
  const PetscSession session;
  const Hierarchy& h = *hierarchy_;
  throw_if_petsc_failed(VecPlaceArray(h.residual.get(), r.data()));
  throw_if_petsc_failed(VecPlaceArray(h.correction.get(), z.data()));
  const PetscErrorCode applied = PCApply(h.levels.get(), h.residual.get(), h.correction.get());
  throw_if_petsc_failed(VecResetArray(h.residual.get()));
  throw_if_petsc_failed(VecResetArray(h.correction.get()));
  throw_if_petsc_failed(applied);
}

} // namespace spricka::engines
