// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/front_rows.hpp"

#include "crack/front_fields.hpp"
#include "crack/intensity_row_builder.hpp"
#include "crack/tip_intensity.hpp"

namespace spricka::crack {

namespace {

using Builder = IntensityFunctionalBuilder<FrontAuxiliaryFields>;

// What `make` takes from the builder of a front; nothing without a domain.
template <class Make>
auto made_rows(const model::Model& model, const mesh::CrackedMesh& cracked,
               const mesh::CrackFront& front, const FrontIntegralDomains& fields,
               const Make& make) {
  const FrontContext set = make_front_context(model, cracked, front, fields);
  const FrontAuxiliaryFields source(set, fields);
  const Builder builder({source, front, fields.points});
  return make(builder);
}

// Of so many functions, all zero.
SparseLinearFunctionals zero_rows(const mesh::CrackedMesh& cracked, const mesh::CrackFront& front,
                                  std::size_t count) {
  const int dim = cracked.mesh.dim;
  return {dim * static_cast<Eigen::Index>(count), KLayout(front.points.size(), dim).count()};
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
  return supplemented_intensity_functionals(model, cracked, front, domains, {}).of_nodes;
}

IntensityFunctionals supplemented_intensity_functionals(const model::Model& model,
                                                        const mesh::CrackedMesh& cracked,
                                                        const mesh::CrackFront& front,
                                                        const FrontIntegralDomains& fields,
                                                        const SupplementaryFunctions& others) {
  if (fields.empty()) {
    return {zero_rows(cracked, front, cracked.mesh.node_count()),
            zero_rows(cracked, front, static_cast<std::size_t>(others.count))};
  }
  return made_rows(model, cracked, front, fields, [&](const Builder& builder) {
    return builder.displacement_functionals(others);
  });
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
  if (fields.empty()) {
    return zero_rows(cracked, front, count);
  }
  return made_rows(model, cracked, front, fields,
                   [&](const Builder& builder) { return builder.face_force_functionals(places); });
}

} // namespace spricka::crack
