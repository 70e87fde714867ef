// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/space/front_rows.hpp"

#include "crack/space/front_row_builder.hpp"

namespace spricka::crack {

namespace {

AuxiliaryFieldColumns modes(const mesh::CrackFront& front) {
  // In a half model the others are zero by symmetry; their columns stay.
  return front.symmetric_half ? AuxiliaryFieldColumns{{1}} : AuxiliaryFieldColumns{{1, 2, 3}};
}

// AuxiliaryFieldColumns of K1 alone, spread over those of the layout.
SparseRows spread(const SparseRows& rows, std::size_t points) {
  const KLayout layout(points, 3);
  if (rows.cols() == layout.count()) {
    return rows;
  }
  RowEntries entries;
  for (Eigen::Index c = 0; c < rows.cols(); ++c) {
    for (SparseRows::InnerIterator at(rows, c); at; ++at) {
      entries.emplace_back(at.row(), layout.at(static_cast<std::size_t>(c), 1), at.value());
    }
  }
  SparseRows all(rows.rows(), layout.count());
  all.setFromTriplets(entries.begin(), entries.end());
  return all;
}

SparseRows nothing(const mesh::CrackedMesh& cracked, Eigen::Index columns) {
  return {3 * static_cast<Eigen::Index>(cracked.mesh.node_count()), columns};
}

} // namespace

SparseRows front_intensity_rows(const model::Model& model, const mesh::CrackedMesh& cracked,
                                const mesh::CrackFront& front, const FrontExtensions& fields) {
  if (fields.empty()) {
    return nothing(cracked, KLayout(front.points.size(), 3).count());
  }
  const FrontSetting set = front_setting(model, cracked, front, fields);
  return spread(IntensityRowBuilder(set, front, fields, modes(front)).rows(), front.points.size());
}

SparseRows supplementary_front_rows(const model::Model& model, const mesh::CrackedMesh& cracked,
                                    const mesh::CrackFront& front, const FrontExtensions& fields,
                                    const SupplementaryFunctions& others) {
  if (fields.empty()) {
    return {3 * others.count, KLayout(front.points.size(), 3).count()};
  }
  const FrontSetting set = front_setting(model, cracked, front, fields);
  return spread(IntensityRowBuilder(set, front, fields, modes(front)).supplementary_rows(others),
                front.points.size());
}

SparseRows front_t_rows(const model::Model& model, const mesh::CrackedMesh& cracked,
                        const mesh::CrackFront& front, const FrontExtensions& fields) {
  const auto count = static_cast<Eigen::Index>(front.points.size());
  if (fields.empty()) {
    return nothing(cracked, count);
  }
  const FrontSetting set = front_setting(model, cracked, front, fields);
  SparseRows rows = IntensityRowBuilder(set, front, fields, {{line_force_auxiliary}}).rows();
  // E' nu e_tt of (crack_space.12).
  RowEntries entries;
  const auto strain = strain_along(front, cracked.mesh, fields);
  for (std::size_t i = 0; i < strain.size(); ++i) {
    for (const NodeWeight& entry : strain[i]) {
      for (Eigen::Index c = 0; c < 3 && !fields.points[i].empty(); ++c) {
        entries.emplace_back(3 * static_cast<Eigen::Index>(entry.node.index()) + c,
                             static_cast<Eigen::Index>(i),
                             set.E_effective() * set.body.nu * entry.weight[c]);
      }
    }
  }
  SparseRows more(rows.rows(), rows.cols());
  more.setFromTriplets(entries.begin(), entries.end());
  return rows + more;
}

SparseRows front_force_rows(const model::Model& model, const mesh::CrackedMesh& cracked,
                            const mesh::CrackFront& front, const FrontExtensions& fields,
                            const std::vector<FacePointForces>& places) {
  if (fields.empty()) {
    Eigen::Index points = 0;
    for (const FacePointForces& place : places) {
      points += static_cast<Eigen::Index>(place.points.size());
    }
    return {3 * points, KLayout(front.points.size(), 3).count()};
  }
  const FrontSetting set = front_setting(model, cracked, front, fields);
  return spread(IntensityRowBuilder(set, front, fields, modes(front)).force_rows(places),
                front.points.size());
}

} // namespace spricka::crack
