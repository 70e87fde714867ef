// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/front_rows.hpp"

#include "crack/front_fields.hpp"
#include "crack/intensity_row_builder.hpp"
#include "crack/tip_intensity.hpp"

namespace spricka::crack {

namespace {

using Builder = IntensityRowBuilder<FrontFields>;

// What `make` takes from the builder of a front; zero rows [dim * count, K] without a domain.
template <class Make>
SparseRows made_rows(const model::Model& model, const mesh::CrackedMesh& cracked,
                     const mesh::CrackFront& front, const FrontExtensions& fields,
                     std::size_t count, const Make& make) {
  if (fields.empty()) {
    const int dim = cracked.mesh.dim;
    return {dim * static_cast<Eigen::Index>(count), KLayout(front.points.size(), dim).count()};
  }
  const FrontSetting set = front_setting(model, cracked, front, fields);
  const FrontFields source(set, fields);
  Builder builder({source, front, fields.points});
  return make(builder);
}

} // namespace

SparseRows front_intensity_rows(const model::Model& model, const mesh::CrackedMesh& cracked,
                                const mesh::CrackFront& front, const FrontExtensions& domains,
                                model::CrackTipPlaneState state) {
  if (front.is_tip() && !domains.empty()) {
    return tip_intensity_rows(model, cracked, front, domains.points.front(), state);
  }
  return made_rows(model, cracked, front, domains, cracked.mesh.node_count(),
                   [](Builder& builder) { return builder.rows(); });
}

SparseRows supplementary_front_rows(const model::Model& model, const mesh::CrackedMesh& cracked,
                                    const mesh::CrackFront& front, const FrontExtensions& fields,
                                    const SupplementaryFunctions& others) {
  return made_rows(model, cracked, front, fields, static_cast<std::size_t>(others.count),
                   [&](Builder& builder) { return builder.supplementary_rows(others); });
}

SparseRows front_force_rows(const model::Model& model, const mesh::CrackedMesh& cracked,
                            const mesh::CrackFront& front, const FrontExtensions& fields,
                            const std::vector<FacePointForces>& places) {
  std::size_t count = 0;
  for (const FacePointForces& place : places) {
    count += place.points.size();
  }
  return made_rows(model, cracked, front, fields, count,
                   [&](Builder& builder) { return builder.force_rows(places); });
}

} // namespace spricka::crack
