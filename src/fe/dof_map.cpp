// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/dof_map.hpp"

#include "model/model.hpp"

#include <algorithm>

namespace spricka::fe {

namespace {

using model::FreedomRole;

// Where cards differ on a freedom the higher rank counts.
int rank(FreedomRole cls) {
  switch (cls) {
  case FreedomRole::local:
    return 0;
  case FreedomRole::external:
    return 1;
  case FreedomRole::prescribed:
    return 2;
  case FreedomRole::suppressed:
    return 3;
  case FreedomRole::dependent: // no card says so
    return 4;
  }
  return 0;
}

// A point on the axis has no way to leave it.
void hold_axis(const model::Mesh& mesh, std::vector<FreedomRole>& cls) {
  const double reach = model::axis_tolerance(mesh);
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    if (mesh.x[n].x() <= reach) {
      cls[2 * n] = FreedomRole::suppressed;
    }
  }
}

} // namespace

std::vector<FreedomRole> classify_freedoms(const model::Model& model, const model::Mesh& mesh) {
  const auto dim = static_cast<std::size_t>(mesh.dim);
  std::vector<FreedomRole> cls(dim * mesh.node_count(), FreedomRole::local);
  for (const model::NodeSetFreedomRole& freedom : model.freedoms) {
    for (const base::NodeId n : mesh.set_with_id(freedom.nodes).nodes) {
      for (std::size_t c = 0; c < dim; ++c) {
        FreedomRole& now = cls[dim * n.index() + c];
        if (freedom.dof[c] && rank(freedom.cls) > rank(now)) {
          now = freedom.cls;
        }
      }
    }
  }
  if (model::is_axisymmetric(model)) {
    hold_axis(mesh, cls);
  }
  return cls;
}

DofMap number_freedoms(const model::Mesh& mesh, const std::vector<base::NodeId>& nodes,
                       const std::vector<FreedomRole>& cls) {
  const auto dim = static_cast<std::size_t>(mesh.dim);
  DofMap dofs;
  dofs.row.assign(dim * mesh.node_count(), -1);
  // Locals first: they are condensed, externals stay.
  for (const FreedomRole wanted : {FreedomRole::local, FreedomRole::external}) {
    for (const base::NodeId n : nodes) {
      for (std::size_t c = 0; c < dim; ++c) {
        const std::size_t freedom = dim * n.index() + c;
        if (cls[freedom] == wanted) {
          dofs.row[freedom] = static_cast<std::int32_t>(dofs.freedom.size());
          dofs.freedom.push_back(static_cast<std::int32_t>(freedom));
        }
      }
    }
    if (wanted == FreedomRole::local) {
      dofs.locals = dofs.size();
    }
  }
  return dofs;
}

} // namespace spricka::fe
