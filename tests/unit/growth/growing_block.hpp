// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "growth/growth_integrator.hpp"
#include "model/model.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

/// Ellipses in a block that grow by a K that a formula gives.
namespace spricka::test {

using base::Vec3;
using growth::TipStation;

/// A block of hexahedra with an ellipse in the plane z = 0; K comes from a formula.
struct Block {
  model::Model model;

  Block(const Vec3& low, const Vec3& high, int n) {
    model::Mesh& mesh = model.mesh;
    mesh.dim = 3;
    for (int i = 0; i < (n + 1) * (n + 1) * (n + 1); ++i) {
      const int row = i / (n + 1) % (n + 1);
      const int layer = i / ((n + 1) * (n + 1));
      const Vec3 part(i % (n + 1), row, layer);
      model::add_node(mesh, low + (high - low).cwiseProduct(part) / n,
                      static_cast<base::Label>(i) + 1, base::NetId(0));
    }
    const auto node = [&](int i, int j, int k) {
      return base::NodeId(static_cast<std::size_t>((k * (n + 1) + j) * (n + 1) + i));
    };
    for (int e = 0; e < n * n * n; ++e) {
      const int i = e % n;
      const int j = e / n % n;
      const int k = e / (n * n);
      const std::array nodes{node(i, j, k),
                             node(i + 1, j, k),
                             node(i + 1, j + 1, k),
                             node(i, j + 1, k),
                             node(i, j, k + 1),
                             node(i + 1, j, k + 1),
                             node(i + 1, j + 1, k + 1),
                             node(i, j + 1, k + 1)};
      model::add_element(mesh, base::ElementType::hexe8, nodes, static_cast<base::Label>(e) + 1,
                         base::NetId(0));
    }
    mesh.property.assign(mesh.element_count(), base::PropertyId(0));
    model.nets.push_back({"", {}});
    model.properties.emplace_back();
    model.growth.emplace();
    model.growth->law = model::CrackGrowthLaw::paris;
    model.growth->tolerance = 1e-3;
  }

  void ellipse(const Vec3& centre, double a, double c, const std::string& name = "C") {
    model::CrackDefinition crack;
    crack.name = name;
    crack.kind = model::CrackDefinitionKind::ellipse;
    crack.net = base::NetId(0);
    crack.plane = {.place = centre,
                   .normal = Vec3::UnitZ(),
                   .along = Vec3::UnitX(),
                   .a = a,
                   .c = c,
                   .closed = false};
    model.cracks.push_back(crack);
  }
};

inline double paris(double K_max, double K_min, const model::PlaceOnCrack& /*place*/ = {}) {
  return 1e-9 * std::pow(K_max - K_min, 3);
}

// K1 at a place of the crack.
using KAt = std::function<double(const growth::CrackGeometry& cracks, const Vec3& x)>;

inline void run(growth::GrowthIntegrator& march, const KAt& K_at,
                const growth::GrowthRateFunction& law = paris) {
  for (int k = 0; k < 300 && !march.growth_end(); ++k) {
    base::Diagnostics diagnostics;
    const auto cracks = march.propose_next_cracks(diagnostics);
    if (!cracks) {
      if (!march.growth_end()) {
        march.shorten_step("no front");
      }
      continue;
    }
    std::vector<TipStation> found(march.tips().size());
    for (std::size_t tip = 0; tip < found.size(); ++tip) {
      const Vec3& x = cracks->aims[tip];
      found[tip].x = x.x();
      found[tip].y = x.y();
      found[tip].z = x.z();
      found[tip].K_max = K_at(*cracks, x);
      found[tip].rate = law(found[tip].K_max, 0.0, {});
    }
    march.accept_or_reject_station(std::move(found));
  }
  ASSERT_TRUE(march.growth_end()) << "no end after 300 stations";
}

} // namespace spricka::test
