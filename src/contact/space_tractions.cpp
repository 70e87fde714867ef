// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/space_tractions.hpp"

#include "contact/space/frames.hpp"
#include "contact/space_dual.hpp"
#include "contact/space_rows.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace spricka::contact {

namespace {

// Multipliers of a function's row: along the normal and the two tangents.
using Pushes = std::array<double, 3>;

std::vector<Pushes> pushes_of(const PairRows& pair, const base::Vector& lambda) {
  std::vector<Pushes> of_row(pair.normal.size(), Pushes{});
  for (std::size_t r = 0; r < pair.normal.size(); ++r) {
    of_row[r][0] = lambda[static_cast<Eigen::Index>(r)];
  }
  for (std::size_t t = 0; t < pair.tangent.size(); ++t) {
    const ConstraintRow& row = pair.tangent[t];
    of_row[static_cast<std::size_t>(row.normal)][static_cast<std::size_t>(row.along)] =
        lambda[static_cast<Eigen::Index>(pair.normal.size() + t)];
  }
  return of_row;
}

class Tractions {
public:
  Tractions(const PairRows& pair, const base::Vector& lambda,
            const std::function<bool(const model::Face&)>& wanted)
      : pair_(pair), own_(pair.contact.space), other_(pair.target.space), wanted_(wanted),
        frames_(own_), push_(pushes_of(pair, lambda)), functions_(functions_by_face(pair)) {
    for (std::size_t f = 0; f < own_.faces.size(); ++f) {
      own_wanted_.push_back(wanted(own_.faces[f].face));
    }
    for (const SolidFace& face : other_.faces) {
      other_wanted_.push_back(wanted(face.face));
    }
  }

  std::vector<FaceTraction> make() {
    const bool target_side = std::ranges::any_of(other_wanted_, [](bool wanted) { return wanted; });
    const std::function<Sight(const SurfaceTriangle&)> see = sight_of(pair_);
    for (const SurfaceTriangle& triangle : own_.triangles) {
      if (own_wanted_[triangle.face] || target_side) {
        add(triangle, see(triangle));
      }
    }
    std::vector<FaceTraction> all;
    for (auto& [face, points] : points_) {
      all.push_back({face, std::move(points)});
    }
    return all;
  }

private:
  // Row a of `dual` is the function dual to hat a; its multipliers push with it.
  void add(const SurfaceTriangle& triangle, const Sight& sight) {
    Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
    for (const SightPoint& p : sight.points) {
      moment += p.weight * p.hat * p.hat.transpose();
    }
    const Eigen::Matrix3d dual = dual_weights(moment);
    std::array<Pushes, 3> push{};
    for (std::size_t a = 0; a < 3; ++a) {
      const std::size_t at = functions_[triangle.face][static_cast<std::size_t>(triangle.node[a])];
      const int row = pair_.functions[at].row;
      push[a] = row < 0 ? Pushes{} : push_[static_cast<std::size_t>(row)];
    }
    for (const SightPoint& p : sight.points) {
      const Eigen::Vector3d weight = dual * (p.weight * p.hat);
      const std::array<Vec3, 3> along = frames_.at(own_.part[triangle.face], p.normal);
      Vec3 force = Vec3::Zero();
      for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t k = 0; k < 3; ++k) {
          force += push[a][k] * weight[static_cast<Eigen::Index>(a)] * along[k];
        }
      }
      if (own_wanted_[triangle.face]) {
        points_[own_.faces[triangle.face].face].push_back({p.r, -force});
      }
      if (!pair_.rigid && other_wanted_[p.target]) {
        points_[other_.faces[p.target].face].push_back({p.s, force});
      }
    }
  }

  const PairRows& pair_;
  const SpaceSurface& own_;
  const SpaceSurface& other_;
  const std::function<bool(const model::Face&)>& wanted_;
  Frames frames_;
  std::vector<Pushes> push_; ///< [normal row]
  std::vector<std::vector<std::size_t>> functions_;
  std::vector<bool> own_wanted_, other_wanted_;
  std::map<model::Face, std::vector<TractionPoint>> points_;
};

} // namespace

std::vector<FaceTraction> space_tractions(const PairRows& pair, const base::Vector& lambda,
                                          const std::function<bool(const model::Face&)>& wanted) {
  if (!pair.segments || pair.contact.space.faces.empty()) {
    return {};
  }
  return Tractions(pair, lambda, wanted).make();
}

} // namespace spricka::contact
