// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/space/front_rows.hpp"

#include "crack/space/face_forces.hpp"
#include "crack/space/solid_blocks.hpp"
#include "fe/face.hpp"

#include <map>
#include <set>

namespace spricka::crack {

using base::Vec3;

namespace {

/// How nodes move with one point of the front, the mean over its domains per length of the front.
using PointMotion = std::map<base::NodeId, Vec3>;

PointMotion motion_of(const mesh::FrontPoint& point, const std::vector<ExtensionField>& domains) {
  PointMotion motion;
  const double part = 1.0 / (static_cast<double>(domains.size()) * point.weight);
  for (const ExtensionField& field : domains) {
    for (const NodeMotion& moved : field.motion) {
      motion.try_emplace(moved.node, Vec3::Zero()).first->second += part * moved.q * moved.along;
    }
  }
  return motion;
}

/// Which partners, and where their rows go.
struct Columns {
  std::vector<std::size_t> partners;

  [[nodiscard]] Eigen::Index count() const { return static_cast<Eigen::Index>(partners.size()); }
};

using Entries = std::vector<Eigen::Triplet<double>>;

/// One front with the motions of its points, and which points move an element.
class RowBuilder {
public:
  RowBuilder(const FrontSetting& set, const mesh::Front& front, const FrontFields& fields,
             Columns columns)
      : set_(set), fields_(fields), columns_(std::move(columns)) {
    for (std::size_t i = 0; i < fields.points.size(); ++i) {
      motion_.push_back(fields.points[i].empty() ? PointMotion()
                                                 : motion_of(front.points[i], fields.points[i]));
      for (const ExtensionField& field : fields.points[i]) {
        for (const base::ElementId e : field.elements) {
          points_of_[e].insert(i);
        }
      }
    }
  }

  [[nodiscard]] SparseRows rows() {
    for_solid_blocks(set_.mesh, fields_.elements(),
                     [&]<shape::ElementShape S>(S, std::span<const base::ElementId> block) {
                       for (const base::ElementId e : block) {
                         add_element<S>(e);
                       }
                     });
    for (const FrontSide& side : fields_.sides) {
      fe::with_side(set_.mesh, side.face, [&]<shape::Shape Side>(Side) {
        if constexpr (Side::dim == 2) {
          add_side<Side>(side);
        }
      });
    }
    return made(3 * static_cast<Eigen::Index>(set_.mesh.node_count()));
  }

  [[nodiscard]] SparseRows force_rows(const std::vector<FaceForces>& places) {
    std::map<model::Face, FaceSide> moved;
    for (const FrontSide& side : fields_.sides) {
      moved.emplace(side.face, side.on);
    }
    Eigen::Index first = 0;
    for (const FaceForces& place : places) {
      const auto known = moved.find(place.face);
      if (known != moved.end()) {
        fe::with_side(set_.mesh, place.face, [&]<shape::Shape Side>(Side) {
          if constexpr (Side::dim == 2) {
            add_places<Side>(place, known->second, first);
          }
        });
      }
      first += 3 * static_cast<Eigen::Index>(place.points.size());
    }
    return made(first);
  }

private:
  [[nodiscard]] SparseRows made(Eigen::Index count) const {
    SparseRows rows(count, columns_.count() * static_cast<Eigen::Index>(motion_.size()));
    rows.setFromTriplets(entries_.begin(), entries_.end());
    return rows;
  }

  // The motion of some nodes with a point of the front; false: they rest.
  template <class Nodes, class Motion>
  bool gather(std::size_t point, const Nodes& nodes, Motion& q) const {
    bool moves = false;
    q.setZero();
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      const auto at = motion_[point].find(nodes[n]);
      if (at != motion_[point].end()) {
        q.col(static_cast<Eigen::Index>(n)) = at->second;
        moves = true;
      }
    }
    return moves;
  }

  void put(Eigen::Index row, std::size_t point, std::size_t column, const Vec3& value) {
    const Eigen::Index at =
        columns_.count() * static_cast<Eigen::Index>(point) + static_cast<Eigen::Index>(column);
    for (Eigen::Index c = 0; c < 3; ++c) {
      if (value[c] != 0.0) {
        entries_.emplace_back(row + c, at, value[c]);
      }
    }
  }

  // The displacement gradient H is contracted with s(A - q_k,k H_w) + sigma_w (grad q)^T +
  // div sigma_w (x) q, A = H_w grad q (crack_space.10).
  template <shape::ElementShape S> void add_element(base::ElementId e) {
    const fe::NodeVectors<S> X = fe::coordinates<S>(set_.mesh, e);
    const std::span<const base::NodeId> nodes = set_.mesh.nodes_of(e);
    std::vector<std::pair<std::size_t, fe::NodeVectors<S>>> moved;
    for (const std::size_t i : points_of_.at(e)) {
      fe::NodeVectors<S> q;
      if (gather(i, nodes, q)) {
        moved.emplace_back(i, q);
      }
    }
    const std::size_t width = columns_.partners.size();
    std::vector<fe::NodeVectors<S>> sums(moved.size() * width, fe::NodeVectors<S>::Zero());
    for (const auto& point : shape::quadrature<S>(front_degree)) {
      const fe::Jacobian<S> at = fe::jacobian<S>(X, point.r);
      const Eigen::Matrix<double, S::nodes, 1> N = S::N(point.r);
      const FrontPlace place = set_.axes.place(X * N);
      const TurningAxes axes(place);
      for (std::size_t k = 0; k < width; ++k) {
        const MovingField w = moving_field(columns_.partners[k], place, axes, set_.body);
        for (std::size_t j = 0; j < moved.size(); ++j) {
          const Tensor<3> grad = moved[j].second * at.dNdx;
          const Tensor<3> M = isotropic_stress(set_.body, w.H * grad - grad.trace() * w.H) +
                              w.sigma * grad.transpose() +
                              w.divergence * (moved[j].second * N).transpose();
          sums[width * j + k] += point.weight * at.det * M * at.dNdx.transpose();
        }
      }
    }
    for (std::size_t j = 0; j < moved.size(); ++j) {
      for (std::size_t k = 0; k < width; ++k) {
        const double factor = set_.factor(columns_.partners[k]);
        for (std::size_t n = 0; n < nodes.size(); ++n) {
          put(3 * static_cast<Eigen::Index>(nodes[n].index()), moved[j].first, k,
              factor * sums[width * j + k].col(static_cast<Eigen::Index>(n)));
        }
      }
    }
  }

  template <shape::Shape Side> void add_side(const FrontSide& side) {
    const fe::SideNodes<Side> X = fe::side_coordinates<Side>(set_.mesh, side.face);
    const auto nodes = fe::nodes_of_face<Side>(set_.mesh, side.face);
    for (const std::size_t i : points_of_.at(side.face.element)) {
      fe::SideNodes<Side> q;
      if (!gather(i, nodes, q)) {
        continue;
      }
      for (const auto& point : shape::quadrature<Side>(front_degree)) {
        const Eigen::Matrix<double, Side::nodes, 1> N = Side::N(point.r);
        const FrontPlace place = set_.axes.place(X * N, side.on);
        const Vec3 area = point.weight * fe::area_vector<Side>(X, point.r);
        const Eigen::Matrix<double, Side::nodes, 1> along =
            surface_gradients<Side>(X, point.r) * (q * N);
        for (std::size_t k = 0; k < columns_.partners.size(); ++k) {
          const std::size_t partner = columns_.partners[k];
          const Vec3 t =
              set_.factor(partner) * (moving_field(partner, place, set_.body).sigma * area);
          for (std::size_t n = 0; n < nodes.size(); ++n) {
            put(3 * static_cast<Eigen::Index>(nodes[n].index()), i, k,
                -along[static_cast<Eigen::Index>(n)] * t);
          }
        }
      }
    }
  }

  template <shape::Shape Side>
  void add_places(const FaceForces& on, FaceSide side, Eigen::Index first) {
    const fe::SideNodes<Side> X = fe::side_coordinates<Side>(set_.mesh, on.face);
    const auto nodes = fe::nodes_of_face<Side>(set_.mesh, on.face);
    for (const std::size_t i : points_of_.at(on.face.element)) {
      fe::SideNodes<Side> q;
      if (!gather(i, nodes, q)) {
        continue;
      }
      for (std::size_t p = 0; p < on.points.size(); ++p) {
        const Eigen::Matrix<double, Side::nodes, 1> N = Side::N(on.points[p].r.head<2>());
        const FrontPlace place = set_.axes.place(X * N, side);
        if (!(place.r > 0.0)) {
          continue; // the front itself, a line without an area
        }
        for (std::size_t k = 0; k < columns_.partners.size(); ++k) {
          const std::size_t partner = columns_.partners[k];
          put(first + 3 * static_cast<Eigen::Index>(p), i, k,
              -set_.factor(partner) * (moving_field(partner, place, set_.body).H * (q * N)));
        }
      }
    }
  }

  const FrontSetting& set_;
  const FrontFields& fields_;
  Columns columns_;
  std::vector<PointMotion> motion_; ///< [point]
  std::map<base::ElementId, std::set<std::size_t>> points_of_;
  Entries entries_;
};

Columns modes(const mesh::Front& front) {
  // In a half model the others are zero by symmetry; their columns stay.
  return front.symmetric_half ? Columns{{1}} : Columns{{1, 2, 3}};
}

// Columns of K1 alone, spread over those of the layout.
SparseRows spread(const SparseRows& rows, std::size_t points) {
  const KLayout layout(points, 3);
  if (rows.cols() == layout.count()) {
    return rows;
  }
  Entries entries;
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
                                const mesh::Front& front, const FrontFields& fields) {
  if (fields.empty()) {
    return nothing(cracked, KLayout(front.points.size(), 3).count());
  }
  const FrontSetting set = front_setting(model, cracked, front, fields);
  return spread(RowBuilder(set, front, fields, modes(front)).rows(), front.points.size());
}

SparseRows front_t_rows(const model::Model& model, const mesh::CrackedMesh& cracked,
                        const mesh::Front& front, const FrontFields& fields) {
  const auto count = static_cast<Eigen::Index>(front.points.size());
  if (fields.empty()) {
    return nothing(cracked, count);
  }
  const FrontSetting set = front_setting(model, cracked, front, fields);
  SparseRows rows = RowBuilder(set, front, fields, {{line_force_partner}}).rows();
  // E' nu e_tt of (crack_space.12).
  Entries entries;
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
                            const mesh::Front& front, const FrontFields& fields,
                            const std::vector<FaceForces>& places) {
  if (fields.empty()) {
    Eigen::Index points = 0;
    for (const FaceForces& place : places) {
      points += static_cast<Eigen::Index>(place.points.size());
    }
    return {3 * points, KLayout(front.points.size(), 3).count()};
  }
  const FrontSetting set = front_setting(model, cracked, front, fields);
  return spread(RowBuilder(set, front, fields, modes(front)).force_rows(places),
                front.points.size());
}

} // namespace spricka::crack
