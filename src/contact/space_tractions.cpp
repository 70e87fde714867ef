// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/space_tractions.hpp"

#include "base/parallel.hpp"
#include "contact/make_rows.hpp"
#include "contact/space/frames.hpp"
#include "contact/space/opposite.hpp"
#include "contact/space_dual.hpp"
#include "model/mesh_side.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>

namespace spricka::contact {

namespace {

// Rows of a function: along the normal and the two tangents; -1: none.
using RowsAlong = std::array<std::int64_t, 3>;

std::vector<RowsAlong> rows_along(const PairConstraints& pair) {
  std::vector<RowsAlong> of_row(pair.normal.size(), RowsAlong{-1, -1, -1});
  for (std::size_t r = 0; r < pair.normal.size(); ++r) {
    of_row[r][0] = static_cast<std::int64_t>(r);
  }
  for (std::size_t t = 0; t < pair.tangent.size(); ++t) {
    const ConstraintRow& row = pair.tangent[t];
    of_row[static_cast<std::size_t>(row.normal)][static_cast<std::size_t>(row.along)] =
        static_cast<std::int64_t>(pair.normal.size() + t);
  }
  return of_row;
}

class Tractions {
public:
  Tractions(const PairConstraints& pair, const std::function<bool(const model::Face&)>& wanted)
      : pair_(pair), own_(pair.contact), other_(pair.target), frames_(own_),
        rows_(rows_along(pair)), functions_(functions_by_facet(pair)) {
    for (std::size_t f = 0; f < own_.facets.size(); ++f) {
      own_wanted_.push_back(wanted(model::face_of_side(own_.facets[f])));
    }
    for (const geometry::ElementSide& face : other_.facets) {
      other_wanted_.push_back(wanted(model::face_of_side(face)));
    }
  }

  std::vector<UnitFaceTraction> make() {
    const bool target_side = std::ranges::any_of(other_wanted_, [](bool wanted) { return wanted; });
    std::vector<std::size_t> triangles;
    for (std::size_t t = 0; t < own_.elements.size(); ++t) {
      if (own_wanted_[own_.elements[t].facet] || target_side) {
        triangles.push_back(t);
      }
    }
    base::make_and_take_in_order(
        triangles.size(), elements_at_a_time,
        [&](std::size_t i) {
          return points_of(own_.elements[triangles[i]], (*pair_.opposite)[triangles[i]]);
        },
        [&](std::size_t /*i*/, std::vector<TrianglePointForces>&& points) {
          for (TrianglePointForces& one : points) {
            points_[one.face].push_back(std::move(one.point));
          }
        });
    std::vector<UnitFaceTraction> all;
    for (auto& [face, points] : points_) {
      all.push_back({face, std::move(points)});
    }
    return all;
  }

private:
  struct TrianglePointForces {
    model::Face face;
    FacePointRowForces point;
  };

  // Row a of `dual` is the function dual to hat a; its multipliers push with it.
  [[nodiscard]] std::vector<TrianglePointForces>
  points_of(const HatElement& triangle, const std::vector<PairQuadraturePoint>& points) const {
    std::vector<TrianglePointForces> found;
    Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
    for (const PairQuadraturePoint& p : points) {
      moment += p.weight * p.hat * p.hat.transpose();
    }
    const Eigen::Matrix3d dual = dual_hat_weights(moment);
    std::array<RowsAlong, 3> rows{};
    for (std::size_t a = 0; a < 3; ++a) {
      const std::size_t at = functions_[triangle.facet][static_cast<std::size_t>(triangle.node[a])];
      const int row = pair_.functions[at].row;
      rows[a] = row < 0 ? RowsAlong{-1, -1, -1} : rows_[static_cast<std::size_t>(row)];
    }
    for (const PairQuadraturePoint& p : points) {
      const Eigen::Vector3d weight = dual * (p.weight * p.hat);
      const std::array<Vec3, 3> along = frames_.at(own_.part[triangle.facet], p.normal);
      std::vector<FacePointRowForces::RowForce> forces;
      for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t k = 0; k < 3; ++k) {
          if (rows[a][k] >= 0) {
            forces.push_back({static_cast<std::size_t>(rows[a][k]),
                              weight[static_cast<Eigen::Index>(a)] * along[k]});
          }
        }
      }
      if (own_wanted_[triangle.facet]) {
        TrianglePointForces& own = found.emplace_back(
            TrianglePointForces{model::face_of_side(own_.facets[triangle.facet]), {p.r, forces}});
        for (FacePointRowForces::RowForce& one : own.point.rows) {
          one.force = -one.force;
        }
      }
      if (!pair_.rigid && other_wanted_[p.target]) {
        found.push_back({model::face_of_side(other_.facets[p.target]), {p.s, std::move(forces)}});
      }
    }
    return found;
  }

  const PairConstraints& pair_;
  const FacetSurface& own_;
  const FacetSurface& other_;
  SurfaceFrames frames_;
  std::vector<RowsAlong> rows_; ///< [normal row]
  std::vector<std::vector<std::size_t>> functions_;
  std::vector<bool> own_wanted_, other_wanted_;
  std::map<model::Face, std::vector<FacePointRowForces>> points_;
};

} // namespace

std::vector<UnitFaceTraction>
solid_pair_unit_tractions(const PairConstraints& pair,
                          const std::function<bool(const model::Face&)>& wanted) {
  if (!pair.segments) {
    return {};
  }
  return Tractions(pair, wanted).make();
}

std::vector<FaceTraction>
solid_pair_tractions(const PairConstraints& pair, const base::Vector& lambda,
                     const std::function<bool(const model::Face&)>& wanted) {
  std::vector<FaceTraction> all;
  for (const UnitFaceTraction& unit : solid_pair_unit_tractions(pair, wanted)) {
    FaceTraction& on_face = all.emplace_back();
    on_face.face = unit.face;
    for (const FacePointRowForces& point : unit.points) {
      Vec3 force = Vec3::Zero();
      for (const FacePointRowForces::RowForce& one : point.rows) {
        force += lambda[static_cast<Eigen::Index>(one.row)] * one.force;
      }
      on_face.points.push_back({point.r, force});
    }
  }
  return all;
}

} // namespace spricka::contact
