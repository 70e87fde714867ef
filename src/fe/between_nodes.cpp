// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/between_nodes.hpp"

#include "fe/load_rule.hpp"
#include "model/loads.hpp"
#include "model/mesh.hpp"

namespace spricka::fe {

namespace {

void visit_side(const geometry::ElementSide& side, const model::Load& load,
                DisplacementInterpolationError& worst) {
  geometry::SidePositions nodal(3, side.X.cols());
  for (Eigen::Index n = 0; n < nodal.cols(); ++n) {
    nodal.col(n) = load_value(load, side.X.col(n));
  }
  const auto look = [&](const UnitPoint& t) {
    const geometry::SideValues N = side.N(map_from_unit_cube<2>(side.domain(), t).r);
    const base::Vec3 x = side.X * N;
    const double off = (load_value(load, x) - nodal * N).cwiseAbs().maxCoeff();
    if (off > worst.off) {
      worst = {off, x};
    }
  };
  // Deviations show on a grid; a peak between its points does not.
  const int pieces = side.is_edge() ? 32 : 8;
  const int rows = side.is_edge() ? 1 : pieces;
  for (int i = 0; i < pieces; ++i) {
    for (int j = 0; j < rows; ++j) {
      look({(i + 0.5) / pieces, (j + 0.5) / rows, 0.0});
    }
  }
}

} // namespace

DisplacementInterpolationError displacement_interpolation_error(const model::Mesh& mesh,
                                                                const model::Load& load) {
  DisplacementInterpolationError worst;
  if (is_constant(load)) {
    return worst;
  }
  for (const model::Face& face :
       model::sides_with_all_nodes_in(mesh, mesh.set_with_id(load.nodes).nodes)) {
    visit_side(model::element_side(mesh, face), load, worst);
  }
  return worst;
}

} // namespace spricka::fe
