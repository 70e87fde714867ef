// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/enrichment.hpp"
#include "mesh/generate/generate.hpp"
#include "model/model.hpp"

#include <gtest/gtest.h>

/// Matrices of modes that are kept from one crack length to the next.
namespace spricka::test_mode_memory {
namespace {

class ModeMatrixCache : public testing::TestWithParam<base::ElementType> {};

// They are those that would be made anew, also where an element of the same number is another by
// then: moved, of another law, framed otherwise. The last elements are not of the host.
TEST_P(ModeMatrixCache, KeptMatricesAreThoseMadeAnew) {
  model::Model model;
  mesh::BlockSpec spec;
  spec.type = GetParam();
  spec.size = {1.0, 2.0, 1.0};
  spec.nx = 3;
  spec.ny = 4;
  model.nets = {{"", {}}};
  mesh::generate_block(model.mesh, base::NetId(std::size_t{0}), "", spec);
  model.materials = {{"M", 1000.0, 0.3, 0.0, 1e-5, {}}};
  model.properties = {{base::ElementSetId(std::size_t{0}),
                       base::MaterialId(std::size_t{0}),
                       model::StressState::plane_strain,
                       0.7,
                       {}}};
  model::Mesh& mesh = model.mesh;
  mesh.property.assign(mesh.element_count(), base::PropertyId(std::size_t{0}));
  std::vector<base::ElementId> host;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    host.push_back(e + 3 < mesh.element_count() ? base::ElementId(e) : base::ElementId());
  }
  estimate::ModeMatrixCache memory;
  const estimate::EdgeTable edges = estimate::make_edge_table(mesh);
  std::vector<bool> framed(edges.edges.size(), false);
  const auto differs = [&] {
    const estimate::CubicEnrichment kept(model, mesh, edges, framed, {&memory, &host});
    const estimate::CubicEnrichment fresh(model, mesh, edges, framed);
    const base::Vector x = base::Vector::LinSpaced(fresh.freedoms(), -1.0, 2.0);
    const base::Matrix u = base::Matrix::NullaryExpr(
        2 * static_cast<Eigen::Index>(mesh.node_count()), 5,
        [](Eigen::Index i, Eigen::Index k) { return static_cast<double>(i % 7 - k); });
    base::Matrix r = base::Matrix::Zero(fresh.freedoms(), u.cols());
    base::Matrix r_kept = r;
    fresh.subtract_nodal_coupling(u, r);
    kept.subtract_nodal_coupling(u, r_kept);
    base::Matrix one = base::Matrix::Zero(fresh.freedoms(), 1); // as among other columns
    fresh.subtract_nodal_coupling(u.col(1), one);
    EXPECT_GT(one.norm(), 0.0);
    EXPECT_LE((one - r.col(1)).norm(), 1e-14 * r.norm());
    return (kept.stiffness_product(x) - fresh.stiffness_product(x)).cwiseAbs().maxCoeff() +
           (r_kept - r).cwiseAbs().maxCoeff();
  };
  EXPECT_EQ(differs(), 0.0);
  EXPECT_EQ(differs(), 0.0);
  for (base::Vec3& x : mesh.x) {
    x.x() += 0.01 * x.y() * x.y();
  }
  EXPECT_EQ(differs(), 0.0);
  model.materials[0].E *= 2.0;
  EXPECT_EQ(differs(), 0.0);
  for (std::size_t i = 0; i < framed.size(); ++i) {
    framed[i] = edges.edges[i].elements == 1;
  }
  EXPECT_EQ(differs(), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Types, ModeMatrixCache,
                         testing::Values(base::ElementType::trimc6, base::ElementType::quamc8,
                                         base::ElementType::quamc9));

} // namespace
} // namespace spricka::test_mode_memory
