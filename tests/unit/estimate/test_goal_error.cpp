// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/dense_solve.hpp"
#include "crack/front_rows.hpp"
#include "estimate/goal_error.hpp"

#include "estimate/mode_load.hpp"
#include "fe/assemble.hpp"
#include "fe/heat.hpp"
#include "mesh/cut/patch.hpp"
#include "mesh/generate/generate.hpp"
#include "model/model.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace spricka::test_goal_error {
namespace {

const base::NetId net0 = base::NetId(std::size_t{0});

/// A strip with an edge crack, its lower side held, pulled at the upper one; solved by dense
/// matrices, also with all cubic modes at once.
struct StripTriangle {
  model::Model model;
  mesh::CrackedMesh cracked;
  std::vector<crack::VirtualExtensionField> fields;
  std::vector<model::FreedomRole> cls;
  fe::DofMap map;
  fe::ConstraintTransformation ties{{}, {}};
  base::Matrix K;

  explicit StripTriangle(base::ElementType type, double turn = 0.0, double unit = 1.0,
                         bool quarter_point = true) {
    mesh::BlockSpec spec;
    spec.type = type;
    spec.size = {1.0, 2.0, 1.0};
    spec.nx = 3;
    spec.ny = 6;
    model.nets = {{"", {}}};
    mesh::generate_block(model.mesh, net0, "", spec);
    model.materials = {{"M", 1000.0, 0.3, 0.0, 1e-5, {}}};
    model.properties = {{base::ElementSetId(std::size_t{0}),
                         base::MaterialId(std::size_t{0}),
                         model::StressState::plane_strain,
                         0.7,
                         {}}};
    model.mesh.property.assign(model.mesh.element_count(), base::PropertyId(std::size_t{0}));
    mesh::CrackLine line;
    line.crack = base::CrackId(std::size_t{0});
    line.net = net0;
    line.points = {{0.0, 1.0, 0.0}, {0.4, 1.1, 0.0}};
    base::Diagnostics diagnostics;
    const std::vector<mesh::CrackLine> lines{line};
    mesh::TipMeshParameters tip{0.12, 0.05, 3, 8, quarter_point, true};
    auto found = mesh::insert_cracks(model.mesh, lines, std::vector{tip},
                                     std::vector<base::SourceSpan>(1), diagnostics);
    if (!found) {
      throw std::runtime_error("no cracked mesh");
    }
    cracked = std::move(*found);
    suppress();
    move(turn, unit);
    std::vector<int> left_out;
    fields = crack::TipNeighbourhood(cracked.mesh)
                 .extension_fields(cracked, cracked.fronts[0], {2}, left_out);
    std::vector<base::NodeId> nodes;
    const std::vector<bool> used = model::mark_nodes_in_use(cracked.mesh);
    for (std::size_t n = 0; n < used.size(); ++n) {
      if (used[n]) {
        nodes.emplace_back(n);
      }
    }
    map = fe::number_freedoms(cracked.mesh, nodes, cls);
    std::vector<base::ElementId> all;
    for (std::size_t e = 0; e < cracked.mesh.element_count(); ++e) {
      all.emplace_back(e);
    }
    const base::SymmetricCsc csc = fe::assemble_stiffness(model, cracked.mesh, all, {}, map);
    K = base::Matrix::Zero(csc.n, csc.n);
    for (std::int64_t j = 0; j < csc.n; ++j) {
      for (std::int64_t k = csc.start[static_cast<std::size_t>(j)];
           k < csc.start[static_cast<std::size_t>(j) + 1]; ++k) {
        const std::int64_t i = csc.row[static_cast<std::size_t>(k)];
        K(i, j) = K(j, i) = csc.value[static_cast<std::size_t>(k)];
      }
    }
  }

  void suppress() {
    cls.assign(2 * cracked.mesh.node_count(), model::FreedomRole::local);
    for (std::size_t n = 0; n < cracked.mesh.node_count(); ++n) {
      if (cracked.mesh.x[n].y() == 0.0) {
        cls[2 * n] = cls[2 * n + 1] = model::FreedomRole::suppressed;
      }
    }
  }

  void move(double turn, double unit) {
    const Eigen::AngleAxisd R(turn, base::Vec3::UnitZ());
    for (base::Vec3& x : cracked.mesh.x) {
      x = unit * (R * x);
    }
    for (mesh::CrackFront& front : cracked.fronts) {
      front.tip_point().x = unit * (R * front.tip_point().x);
      front.tip_point().growth = R * front.tip_point().growth;
      front.a *= unit;
      front.size *= unit;
      front.radius *= unit;
    }
  }

  [[nodiscard]] model::LoadCase pull(double x, double y) const {
    model::Load load;
    load.type = model::LoadType::traction;
    const auto& sets = cracked.mesh.face_sets;
    const auto top = std::ranges::find(sets, "YMAX", &model::FaceSet::name);
    load.faces = base::FaceSetId(static_cast<std::size_t>(top - sets.begin()));
    load.value = {base::CompiledExpression::make_constant(x),
                  base::CompiledExpression::make_constant(y)};
    return {"PULL", {load}};
  }

  [[nodiscard]] base::Matrix on_unknowns(const base::Matrix& nodal) const {
    base::Matrix f(map.size(), nodal.cols());
    for (std::int64_t i = 0; i < map.size(); ++i) {
      f.row(i) = nodal.row(map.freedom[static_cast<std::size_t>(i)]);
    }
    return f;
  }
  [[nodiscard]] base::Matrix nodal(const base::Matrix& x) const {
    base::Matrix u = base::Matrix::Zero(static_cast<Eigen::Index>(map.row.size()), x.cols());
    for (std::int64_t i = 0; i < map.size(); ++i) {
      u.row(map.freedom[static_cast<std::size_t>(i)]) = x.row(i);
    }
    return u;
  }
};

struct Found {
  std::vector<estimate::GoalError> errors;
  base::Vec2 K, K_cubic;   ///< of the mesh and of the mesh with all modes
  base::Vec2 eta_diagonal; ///< r_z^T K_ee^-1 r_u by a dense factor
  base::Vec2 eta_schur;    ///< r_z^T S^-1 r_u with the exact Schur complement of the modes
};

Found estimate_of(const StripTriangle& s, const model::LoadCase& load) {
  estimate::EdgeTable edges = estimate::make_edge_table(s.cracked.mesh);
  const std::size_t count = edges.edges.size();
  const estimate::CubicEnrichment modes(s.model, s.cracked.mesh, std::move(edges),
                                        std::vector<bool>(count, false));
  const estimate::ModeFreedomMap map =
      estimate::map_mode_freedoms(modes, estimate::find_mode_supports(modes, s.cls, s.ties), {});
  const mesh::CrackFront& front = s.cracked.fronts[0];
  const base::Matrix g = crack::front_intensity_functionals(s.model, s.cracked, front,
                                                            crack::wrap_tip_domains(s.fields),
                                                            model::CrackTipPlaneState::automatic);
  const base::Matrix g_e = modes.mode_functional(crack::K_functional_at_quadrature_points(
      s.model, s.cracked, front, s.fields, model::CrackTipPlaneState::automatic));
  const base::Vector f = fe::consistent_load_vector(s.model, s.cracked.mesh, load);
  const base::Vector f_e = estimate::mode_load(
      modes, load,
      fe::make_case_temperature(s.model, {s.cracked.mesh, s.cracked.mesh, nullptr, {}}, load));
  const Eigen::LDLT<base::Matrix> factor(s.K);
  const base::Matrix F = s.on_unknowns(f);
  const base::Matrix G = s.on_unknowns(g);
  const base::Vector u = s.nodal(factor.solve(F)).col(0);
  const base::Matrix z = s.nodal(factor.solve(G));
  Found found;
  found.errors = estimate::estimate_goal_errors(modes, map, {u, z, f_e, g_e});
  found.K = g.transpose() * u;

  // all together
  base::Matrix Kee(map.unknowns, map.unknowns);
  for (Eigen::Index j = 0; j < map.unknowns; ++j) {
    Kee.col(j) =
        map.reduce(modes.stiffness_product(map.expand(base::Vector::Unit(map.unknowns, j))));
  }
  base::Matrix Kep(map.unknowns, s.map.size());
  for (Eigen::Index j = 0; j < s.map.size(); ++j) {
    base::Matrix r = base::Matrix::Zero(modes.freedoms(), 1);
    modes.subtract_nodal_coupling(s.nodal(base::Vector::Unit(s.map.size(), j)), r);
    Kep.col(j) = -map.reduce(r).col(0);
  }
  EXPECT_LT((Kee - Kee.transpose()).cwiseAbs().maxCoeff(), 1e-12 * Kee.cwiseAbs().maxCoeff());
  const base::Matrix r_u = map.reduce(f_e) - Kep * factor.solve(F);
  const base::Matrix r_z = map.reduce(g_e) - Kep * factor.solve(G);
  const base::Matrix S = Kee - Kep * factor.solve(base::Matrix(Kep.transpose()));
  found.eta_diagonal = r_z.transpose() * base::solve_square_system(Kee, r_u);
  const base::Matrix e = base::solve_square_system(S, r_u);
  found.eta_schur = r_z.transpose() * e;
  const base::Matrix v = factor.solve(base::Matrix(F - Kep.transpose() * e));
  found.K_cubic = G.transpose() * v + map.reduce(g_e).transpose() * e;
  return found;
}

class GoalError : public testing::TestWithParam<base::ElementType> {};

// The residuals carry the whole difference between the mesh and the mesh with all modes; with K_ee
// instead of the Schur complement most of it is left, and the iteration finds that.
TEST_P(GoalError, IsMostOfWhatCubicElementsWouldChange) {
  const StripTriangle strip(GetParam());
  const Found found = estimate_of(strip, strip.pull(0.3, 1.0));
  const base::Vec2 change = found.K_cubic - found.K;
  EXPECT_GT(change.norm(), 1e-4 * found.K.norm());
  for (std::size_t k = 0; k < 2; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    EXPECT_NEAR(found.eta_schur[i], change[i], 1e-9 * found.K.norm());
    EXPECT_NEAR(found.errors[k].eta, found.eta_diagonal[i],
                0.01 * std::abs(found.eta_diagonal[i]) + 3e-3 * change.norm());
    double sum = 0.0;
    double size = 0.0;
    for (const double part : found.errors[k].of_element) {
      sum += part;
      size += std::abs(part);
    }
    EXPECT_NEAR(sum, found.errors[k].eta, 1e-12 * size);
    EXPECT_NEAR(size, found.errors[k].sum, 1e-12 * size);
  }
  const double part = found.errors[0].eta / change[0];
  EXPECT_GT(part, 0.5);
  EXPECT_LT(part, 1.05);
}

// Mode freedoms that only elements with straight sides and their mid nodes in the middle have:
// others cannot move quadratically.
std::vector<std::int32_t> freedoms_of_straight_elements(const model::Mesh& mesh,
                                                        const estimate::CubicEnrichment& modes) {
  std::vector<bool> straight(static_cast<std::size_t>(modes.freedoms()), true);
  for (std::size_t i = 0; i < mesh.element_count(); ++i) {
    const base::ElementId e(i);
    const auto nodes = mesh.element_nodes(e);
    const auto corners = static_cast<std::size_t>(base::element_info(mesh.type[i]).corners);
    // Eight nodes hold quadratics on parallelograms only.
    bool bent = corners == 4 && (mesh.x[nodes[0].index()] + mesh.x[nodes[2].index()] -
                                 mesh.x[nodes[1].index()] - mesh.x[nodes[3].index()])
                                        .norm() > 1e-12;
    for (std::size_t s = 0; s < corners; ++s) {
      const base::Vec3 middle =
          0.5 * (mesh.x[nodes[s].index()] + mesh.x[nodes[(s + 1) % corners].index()]);
      bent = bent || (mesh.x[nodes[corners + s].index()] - middle).norm() > 1e-12;
    }
    for (const std::int32_t freedom : modes.element_freedoms(e)) {
      straight[static_cast<std::size_t>(freedom)] =
          straight[static_cast<std::size_t>(freedom)] && !bent;
    }
  }
  std::vector<std::int32_t> found;
  for (std::size_t f = 0; f < straight.size(); ++f) {
    if (straight[f]) {
      found.push_back(static_cast<std::int32_t>(f));
    }
  }
  return found;
}

// Bent along the crack, which stays free of stress, the strip moves quadratically, as the mesh can:
// nothing is left to correct.
TEST_P(GoalError, IsNothingWhereTheMeshIsExact) {
  StripTriangle strip(GetParam(), 0.0, 1.0, false);
  estimate::EdgeTable edges = estimate::make_edge_table(strip.cracked.mesh);
  const std::size_t count = edges.edges.size();
  const estimate::CubicEnrichment modes(strip.model, strip.cracked.mesh, std::move(edges),
                                        std::vector<bool>(count, false));
  // sigma = s eta e1 e1^T with xi, eta along and across the crack.
  const double s = 5.0;
  const double E = 1000.0;
  const double nu = 0.3;
  const base::Vec2 e1 = strip.cracked.fronts[0].tip_point().growth.head<2>();
  const base::Vec2 e2(-e1.y(), e1.x());
  const base::Vec2 tip = strip.cracked.fronts[0].tip_point().x.head<2>();
  base::Vector u(2 * static_cast<Eigen::Index>(strip.cracked.mesh.node_count()));
  for (std::size_t n = 0; n < strip.cracked.mesh.node_count(); ++n) {
    const base::Vec2 d = strip.cracked.mesh.x[n].head<2>() - tip;
    const double xi = d.dot(e1);
    const double eta = d.dot(e2);
    const double a = s * (1.0 - nu * nu) / E;
    const double b = s * nu * (1.0 + nu) / E;
    u.segment<2>(2 * static_cast<Eigen::Index>(n)) =
        a * xi * eta * e1 - (0.5 * a * xi * xi + 0.5 * b * eta * eta) * e2;
  }
  // The tractions of that stress on the four sides: t = s (e1 . n) e1 eta.
  model::LoadCase load{"BEND", {}};
  const std::vector<std::pair<std::string, base::Vec2>> sides{
      {"XMIN", {-1, 0}}, {"XMAX", {1, 0}}, {"YMIN", {0, -1}}, {"YMAX", {0, 1}}};
  using base::OpCode;
  for (const auto& [name, normal] : sides) {
    model::Load one = strip.pull(0.0, 0.0).loads[0];
    const auto& sets = strip.cracked.mesh.face_sets;
    one.faces = base::FaceSetId(static_cast<std::size_t>(
        std::ranges::find(sets, name, &model::FaceSet::name) - sets.begin()));
    for (Eigen::Index c = 0; c < 2; ++c) {
      const double t = s * e1.dot(normal) * e1[c];
      one.value[static_cast<std::size_t>(c)].code = {
          {OpCode::x, 0.0},   {OpCode::number, t * e2.x()},      {OpCode::multiply, 0.0},
          {OpCode::y, 0.0},   {OpCode::number, t * e2.y()},      {OpCode::multiply, 0.0},
          {OpCode::add, 0.0}, {OpCode::number, t * tip.dot(e2)}, {OpCode::subtract, 0.0}};
    }
    load.loads.push_back(one);
  }
  base::Matrix r = estimate::mode_load(
      modes, load,
      fe::make_case_temperature(modes.model(), {modes.mesh(), modes.mesh(), nullptr, {}}, load));
  const double size = r.cwiseAbs().maxCoeff();
  EXPECT_GT(size, 1e-3);
  modes.subtract_nodal_coupling(u, r);
  int counted = 0;
  for (const std::int32_t freedom : freedoms_of_straight_elements(strip.cracked.mesh, modes)) {
    ++counted;
    EXPECT_LT(std::abs(r(freedom, 0)), 1e-11 * size);
  }
  EXPECT_GT(counted, modes.freedoms() / 10);
}

// Turned, in other units and with nodes numbered the other way round, the parts of K are the same.
TEST_P(GoalError, DoesNotDependOnAxesAndUnits) {
  const StripTriangle strip(GetParam());
  const Found found = estimate_of(strip, strip.pull(0.3, 1.0));
  const double turn = 0.7;
  const double unit = 25.4;
  const StripTriangle other(GetParam(), turn, unit);
  const base::Vec2 t = Eigen::Rotation2Dd(turn) * base::Vec2(0.3, 1.0);
  const Found moved = estimate_of(other, other.pull(t.x(), t.y()));
  const double size = std::abs(found.errors[0].eta);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(moved.errors[k].eta / std::sqrt(unit), found.errors[k].eta, 1e-8 * size);
    EXPECT_NEAR(moved.errors[k].sum / std::sqrt(unit), found.errors[k].sum, 1e-8 * size);
  }
}

TEST_P(GoalError, DoesNotDependOnTheNumbersOfNodes) {
  const StripTriangle strip(GetParam());
  const Found found = estimate_of(strip, strip.pull(0.3, 1.0));
  StripTriangle other(GetParam());
  model::Mesh& mesh = other.cracked.mesh;
  const std::size_t n = mesh.node_count();
  const auto turned = [n](base::NodeId id) { return base::NodeId(n - 1 - id.index()); };
  std::ranges::reverse(mesh.x);
  for (base::NodeId& id : mesh.nodes) {
    id = turned(id);
  }
  for (mesh::CrackFront& front : other.cracked.fronts) {
    front.tip_point().node = turned(front.tip_point().node);
  }
  for (mesh::CrackFaceNodes& crack_faces : other.cracked.faces) {
    for (auto* crack_face : {&crack_faces.left, &crack_faces.right}) {
      for (base::NodeId& id : *crack_face) {
        id = turned(id);
      }
    }
  }
  for (crack::VirtualExtensionField& field : other.fields) {
    for (crack::NodeMotion& moved : field.motion) {
      moved.node = turned(moved.node);
    }
  }
  other.suppress();
  StripTriangle fresh = std::move(other);
  std::vector<base::NodeId> nodes;
  const std::vector<bool> used = model::mark_nodes_in_use(fresh.cracked.mesh);
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (used[i]) {
      nodes.emplace_back(i);
    }
  }
  const fe::DofMap before = fresh.map;
  fresh.map = fe::number_freedoms(fresh.cracked.mesh, nodes, fresh.cls);
  std::vector<Eigen::Index> place; // of the new unknowns among the old
  for (const std::int32_t f : fresh.map.freedom) {
    const auto old = 2 * static_cast<std::int32_t>(n - 1 - static_cast<std::size_t>(f / 2)) + f % 2;
    place.push_back(before.row[static_cast<std::size_t>(old)]);
  }
  fresh.K = fresh.K(place, place).eval();
  const Found again = estimate_of(fresh, fresh.pull(0.3, 1.0));
  const double size = std::abs(found.errors[0].eta);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(again.errors[k].eta, found.errors[k].eta, 1e-8 * size);
  }
}

INSTANTIATE_TEST_SUITE_P(Types, GoalError,
                         testing::Values(base::ElementType::trimc6, base::ElementType::quamc8,
                                         base::ElementType::quamc9));

} // namespace
} // namespace spricka::test_goal_error
