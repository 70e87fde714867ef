// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/assemble.hpp"
#include "tests/places.hpp"
#include "tests/unit/support/pinned_ring.hpp"
#include "tests/unit/support/solved_scene.hpp"

#include <Eigen/LU>

#include <fmt/format.h>

namespace spricka::test_adjoint {
namespace {

using test::SolvedScene;

// Stiffness of the whole mesh, column by column.
base::Matrix dense_stiffness(const model::Model& model, const model::Mesh& mesh) {
  const auto n = static_cast<Eigen::Index>(mesh.node_count()) * mesh.dim;
  std::vector<std::vector<base::ElementId>> around(mesh.node_count());
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (const base::NodeId node : mesh.element_nodes(base::ElementId(e))) {
      around[node.index()].emplace_back(e);
    }
  }
  base::Matrix K(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    base::Vector column = base::Vector::Zero(n);
    fe::add_internal_force(model, mesh, around[static_cast<std::size_t>(j / mesh.dim)],
                           base::Vector::Unit(n, j), column);
    K.col(j) = column;
  }
  return K;
}

// Closed contact rows, then supports, ties and nodes without elements as rows of constraints;
// `contact`: which rows of the table.
base::Matrix constraints(const analysis::Discretisation& scene, const base::Matrix& K,
                         const std::vector<bool>& closed, std::vector<std::size_t>& contact) {
  const model::Mesh& mesh = scene.cracked.mesh;
  const auto n = static_cast<Eigen::Index>(mesh.node_count()) * mesh.dim;
  std::vector<base::Vector> rows;
  for (std::size_t r = 0; r < closed.size(); ++r) {
    if (!closed[r]) {
      continue;
    }
    contact.push_back(r);
    base::Vector& row = rows.emplace_back(base::Vector::Zero(n));
    for (const contact::RowEntry& entry : scene.contact_row(r).entries) {
      row.segment(static_cast<Eigen::Index>(entry.node.index()) * mesh.dim, mesh.dim) +=
          entry.weight.head(mesh.dim);
    }
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    const model::FreedomRole k = scene.cls[static_cast<std::size_t>(i)];
    if (k == model::FreedomRole::suppressed || k == model::FreedomRole::prescribed ||
        K(i, i) == 0.0) {
      rows.emplace_back(base::Vector::Unit(n, i));
    }
  }
  for (const fe::ConstraintTransformation::DependentRow& tie : scene.ties->rows()) {
    base::Vector& row = rows.emplace_back(base::Vector::Unit(n, tie.freedom));
    for (const fe::FreedomTerm& term : tie.terms) {
      row[term.freedom] -= term.coefficient;
    }
  }
  base::Matrix out(static_cast<Eigen::Index>(rows.size()), n);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    out.row(static_cast<Eigen::Index>(r)) = rows[r];
  }
  return out;
}

// z and w as one dense solution with multipliers gives them.
void compare_with_dense(SolvedScene& solved) {
  const analysis::Discretisation& scene = solved.scene();
  const base::Matrix K = dense_stiffness(solved.model(), scene.cracked.mesh);
  const analysis::StressIntensityAdjoints& adjoint = solved.length->solve_adjoints(*solved.solver);
  ASSERT_TRUE(adjoint.is_available()) << adjoint.why_not;
  std::vector<std::size_t> contact;
  const base::Matrix C = constraints(scene, K, adjoint.closed, contact);
  const Eigen::Index n = K.rows();
  const Eigen::Index m = C.rows();
  const double size = K.diagonal().mean();
  base::Matrix saddle = base::Matrix::Zero(n + m, n + m);
  saddle.topLeftCorner(n, n) = K / size;
  saddle.bottomLeftCorner(m, n) = C;
  saddle.topRightCorner(n, m) = -C.transpose();
  base::Matrix right = base::Matrix::Zero(n + m, adjoint.rows.cols());
  right.topRows(n) = adjoint.rows / size;
  const base::Matrix found = Eigen::PartialPivLU<base::Matrix>(saddle).solve(right);
  ASSERT_LT((saddle * found - right).cwiseAbs().maxCoeff(), 1e-10 * right.cwiseAbs().maxCoeff());
  for (Eigen::Index k = 0; k < right.cols(); ++k) {
    const double z_size = found.col(k).head(n).cwiseAbs().maxCoeff();
    EXPECT_GT(z_size, 0.0);
    EXPECT_LT((adjoint.z.col(k) - found.col(k).head(n)).cwiseAbs().maxCoeff(), 1e-9 * z_size);
    const double w_size = std::max(size * found.col(k).tail(m).cwiseAbs().maxCoeff(), 1e-300);
    base::Vector w = base::Vector::Zero(adjoint.w.rows());
    for (std::size_t i = 0; i < contact.size(); ++i) {
      w[static_cast<Eigen::Index>(contact[i])] = size * found(n + static_cast<Eigen::Index>(i), k);
    }
    EXPECT_LT((adjoint.w.col(k) - w).cwiseAbs().maxCoeff(), 1e-9 * w_size);
  }
}

// The adjoint gives back K of the displacements, by tip.
void compare_intensities(SolvedScene& solved, const analysis::StepState& state, double tolerance) {
  const analysis::StressIntensityAdjoints& adjoint = solved.length->solve_adjoints(*solved.solver);
  ASSERT_TRUE(adjoint.is_available()) << adjoint.why_not;
  const crack::KLayout layout = solved.scene().k_layout();
  const base::Vector K = adjoint.rows.transpose() * state.u;
  const base::Vector found = solved.intensity(adjoint);
  for (std::size_t t = 0; t < layout.points(); ++t) {
    const base::Vec2 of_tip = layout.segment_of_point(K, t);
    EXPECT_GT(of_tip.norm(), 0.0);
    EXPECT_LT((layout.segment_of_point(found, t) - of_tip).norm(), tolerance * of_tip.norm());
  }
}

// A ring with a crack, a pin pressed into it and pulled: free but for its rotation, partly open.
const std::string rings = test::pinned_ring({}, R"($TIPNET CRACK=C SECTORS=8 RINGS=3
$STEP NAME=PRESS
  FIT FIT 1
$STEP NAME=PULLED
  FIT FIT 1
  LOAD PULL 1
)");

TEST(StressIntensityAdjoints, OfAFloatingPinIsThatOfADenseSolution) {
  SolvedScene solved(rings);
  for (const std::size_t step : {0U, 1U}) {
    const std::optional<analysis::StepState> state = solved.solve(step);
    ASSERT_TRUE(state);
    const auto& closed = state->pair_closed.at(0);
    EXPECT_EQ(std::ranges::count(closed, false) > 0, step == 1);
    compare_with_dense(solved);
    compare_intensities(solved, *state, 1e-11);
  }
}

// Three blocks in a row that ties hold together; the last is moved, and an equation with a
// right-hand side strains it all. A foot bears on a rigid floor.
TEST(StressIntensityAdjoints, OfTiedNetsIsThatOfADenseSolution) {
  SolvedScene solved(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=P
  $MESH SHAPE=BLOCK TYPE=QUAMC8 Y0=20 LX=40 LY=40 NX=5 NY=5
$ENDNET
$NET NAME=LO
  $MESH SHAPE=BLOCK TYPE=QUAMC8 LX=40 LY=20 NX=4 NY=2
$ENDNET
$NET NAME=UP
  $MESH SHAPE=BLOCK TYPE=TRIMC6 Y0=60 LX=40 LY=20 NX=4 NY=2
$ENDNET
$MPC TYPE=TRANSITION SLAVE=LO.YMAX MASTER=P.YMIN
$MPC TYPE=TRANSITION SLAVE=UP.YMIN MASTER=P.YMAX
$MATERIAL NAME=AL E=70000 NU=0.33
$PROPERTY ESET=P.BODY MATERIAL=AL STATE=STRAIN
$PROPERTY ESET=LO.BODY MATERIAL=AL STATE=STRAIN
$PROPERTY ESET=UP.BODY MATERIAL=AL STATE=STRAIN
$CRACK NAME=C NET=P ANGLE=0 A0=12
  0 40
$TIPNET CRACK=C SECTORS=8 RINGS=3
$RIGID NAME=FLOOR SHAPE=LINE X0=-10 Y0=0 X1=50 Y1=0
$CONTACT NAME=FOOT SLAVE=LO.YMIN MASTER=FLOOR
$NSET NAME=A WHERE=(abs(x) + abs(y) < 1e-6)
$NSET NAME=B WHERE=(abs(x - 40) + abs(y) < 1e-6)
$FREEDOM CLASS=SUPPRESSED DOF=X
  A
$FREEDOM CLASS=PRESCRIBED DOF=XY
  UP.YMAX
$LOAD CASE=LIFT TYPE=DISP
  UP.YMAX 0.001 (-0.02 + 0.001*x)
$LOAD CASE=SIDE TYPE=TRACTION
  P.XMAX 5 -1
$STEP NAME=S
  LOAD LIFT 1
  LOAD SIDE 2
$END
)");
  const std::optional<analysis::StepState> state = solved.solve(0);
  ASSERT_TRUE(state);
  const auto& closed = state->pair_closed.at(0);
  EXPECT_GT(std::ranges::count(closed, true), 0);
  EXPECT_GT(std::ranges::count(closed, false), 0);
  compare_with_dense(solved);
  compare_intensities(solved, *state, 1e-11);
}

TEST(StressIntensityAdjoints, GivesKOfTheLugBack) {
  SolvedScene solved(fmt::format(R"($DECK VERSION=1 LENGTH=mm FORCE=N
$INCLUDE FILE='{}/lug_model.inc'
$CONTACT NAME=BUSH SLAVE=SLEEVE.OUTER MASTER=LUG.BORE DIAMETRAL=0.084
$CONTACT NAME=PIN  SLAVE=SHAFT.OUTER  MASTER=SLEEVE.INNER GAP=0
$STEP NAME=PRESS
  FIT BUSH 1
$STEP NAME=HALF
  LOAD SHAFTLOAD 0.5
$STEP NAME=ALL
  LOAD SHAFTLOAD 1
$CRACK NAME=TOP NET=LUG A0=(0.3*R) ANGLE=90[deg] STATE=STRESS
  0 (R)
$CRACK NAME=LOW NET=LUG A0=(0.3*R) ANGLE=-90[deg] STATE=STRESS
  0 (-R)
$END
)",
                                 test::decks_folder()));
  for (const std::size_t step : {0U, 1U, 2U}) {
    const std::optional<analysis::StepState> state = solved.solve(step);
    ASSERT_TRUE(state);
    compare_intensities(solved, *state, 1e-10);
  }
}

TEST(StressIntensityAdjoints, OfSlidingContactsIsNotGiven) {
  std::string deck = rings;
  deck.replace(deck.find("INTERFERENCE=0.01"), 17, "INTERFERENCE=0.01 MU=0.2");
  SolvedScene solved(deck);
  ASSERT_TRUE(solved.solve(0));
  const analysis::StressIntensityAdjoints& adjoint = solved.length->solve_adjoints(*solved.solver);
  EXPECT_FALSE(adjoint.is_available());
  EXPECT_EQ(adjoint.z.size(), 0);
}

} // namespace
} // namespace spricka::test_adjoint
