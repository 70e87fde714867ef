// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/front_rows.hpp"

#include "crack/front_fields.hpp"
#include "crack/intensity_row_builder.hpp"
#include "crack/tip_intensity.hpp"

namespace spricka::crack {

namespace {

using Builder = IntensityFunctionalBuilder<FrontAuxiliaryFields>;

// What `make` takes from the builder of a front; zero rows [dim * count, K] without a domain.
template <class Make>
SparseLinearFunctionals made_rows(const model::Model& model, const mesh::CrackedMesh& cracked,
                                  const mesh::CrackFront& front, const FrontIntegralDomains& fields,
                                  std::size_t count, const Make& make) {
  if (fields.empty()) {
    const int dim = cracked.mesh.dim;
    return {dim * static_cast<Eigen::Index>(count), KLayout(front.points.size(), dim).count()};
  }
  const FrontContext set = make_front_context(model, cracked, front, fields);
  const FrontAuxiliaryFields source(set, fields);
  Builder builder({source, front, fields.points});
  return make(builder);
}

} // namespace

SparseLinearFunctionals front_intensity_functionals(const model::Model& model,
                                                    const mesh::CrackedMesh& cracked,
                                                    const mesh::CrackFront& front,
                                                    const FrontIntegralDomains& domains,
                                                    model::CrackTipPlaneState state) {
  if (front.is_tip() && !domains.empty()) {
    return tip_intensity_functionals(model, cracked, front, domains.points.front(), state);
  }
  return made_rows(model, cracked, front, domains, cracked.mesh.node_count(),
                   [](Builder& builder) { return builder.displacement_functionals(); });
}

SparseLinearFunctionals supplementary_K_functionals(const model::Model& model,
                                                    const mesh::CrackedMesh& cracked,
                                                    const mesh::CrackFront& front,
                                                    const FrontIntegralDomains& fields,
                                                    const SupplementaryFunctions& others) {
  return made_rows(model, cracked, front, fields, static_cast<std::size_t>(others.count),
                   [&](Builder& builder) { return builder.supplementary_functionals(others); });
}

SparseLinearFunctionals face_force_front_functionals(const model::Model& model,
                                                     const mesh::CrackedMesh& cracked,
                                                     const mesh::CrackFront& front,
                                                     const FrontIntegralDomains& fields,
                                                     const std::vector<FacePointForces>& places) {
  std::size_t count = 0;
  for (const FacePointForces& place : places) {
    count += place.points.size();
  }
  return made_rows(model, cracked, front, fields, count,
                   [&](Builder& builder) { return builder.face_force_functionals(places); });
}

} // namespace spricka::crack
