// SPDX-License-Identifier: GPL-3.0-or-later
// What makes the condensation of a net another one.
#include "analysis/bodies/content_hash.hpp"
#include "mesh/generate/generate.hpp"
#include "model/model.hpp"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

namespace spricka::test_net_hash {
namespace {

/// A bar of four bricks along x, of which the last two are the net.
struct HalfBar : testing::Test {
  model::Model model;
  analysis::Substructure net;

  HalfBar() {
    mesh::BlockSpec spec;
    spec.type = base::ElementType::hexec20;
    spec.size = {4.0, 1.0, 1.0};
    spec.nx = 4;
    spec.ny = 1;
    spec.nz = 1;
    model.nets = {{"", {}}};
    mesh::generate_solid_block(model.mesh, base::NetId(std::size_t{0}), "", spec);
    model.materials = {{"M", 1000.0, 0.3, 0.0, 0.0, {}}};
    model.properties = {{base::ElementSetId(std::size_t{0}),
                         base::MaterialId(std::size_t{0}),
                         model::StressState::solid,
                         1.0,
                         {}}};
    model.mesh.property.assign(model.mesh.element_count(), base::PropertyId(std::size_t{0}));
    std::vector<base::NodeId> nodes;
    for (std::size_t n = 0; n < model.mesh.node_count(); ++n) {
      if (model.mesh.x[n].x() > 1.9) {
        nodes.emplace_back(n);
      }
    }
    net.elements = {base::ElementId(std::size_t{2}), base::ElementId(std::size_t{3})};
    net.map = fe::number_freedoms(model.mesh, nodes, free());
  }

  [[nodiscard]] std::vector<model::FreedomRole> free() const {
    return std::vector(3 * model.mesh.node_count(), model::FreedomRole::local);
  }
  /// The x freedom of the corner at x.
  [[nodiscard]] std::int32_t at(double x) const {
    for (std::size_t n = 0; n < model.mesh.node_count(); ++n) {
      if ((model.mesh.x[n] - base::Vec3(x, 0.0, 0.0)).norm() < 1e-9) {
        return static_cast<std::int32_t>(3 * n);
      }
    }
    return -1;
  }
  [[nodiscard]] analysis::HashKey tied(double slave, double master, double coefficient) const {
    analysis::Substructure own = net;
    const std::vector<fe::Tie> ties{{{{at(slave), 1.0}, {at(master), -coefficient}}}};
    own.map.ties = std::make_shared<const fe::ConstraintTransformation>(ties, free());
    return analysis::hash_substructure(model, model.mesh, own, {});
  }
};

TEST_F(HalfBar, TiesOfOthersLeaveItAlone) {
  EXPECT_EQ(tied(0.0, 1.0, 1.0), tied(0.0, 1.0, 0.5));
  EXPECT_EQ(tied(0.0, 1.0, 1.0), tied(1.0, 0.0, 1.0));
}

TEST_F(HalfBar, ItsOwnTiesMakeItAnother) {
  EXPECT_NE(tied(4.0, 3.0, 1.0), tied(4.0, 3.0, 0.5));
  EXPECT_NE(tied(4.0, 3.0, 1.0), tied(0.0, 1.0, 1.0));
  EXPECT_NE(tied(0.0, 4.0, 1.0), tied(0.0, 4.0, 0.5)); // another net hangs on it
}

TEST_F(HalfBar, APlaceOrAModulusMakesItAnother) {
  const analysis::HashKey before = tied(0.0, 1.0, 1.0);
  model.materials[0].E = 1001.0;
  const analysis::HashKey stiffer = tied(0.0, 1.0, 1.0);
  EXPECT_NE(before, stiffer);
  for (base::Vec3& x : model.mesh.x) {
    x.y() += x.x() > 3.9 ? 1e-12 : 0.0;
  }
  EXPECT_NE(stiffer, tied(0.0, 1.0, 1.0));
}

} // namespace
} // namespace spricka::test_net_hash
