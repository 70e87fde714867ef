// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/space_rows.hpp"

#include "contact/row_builder.hpp"
#include "contact/space/frames.hpp"
#include "contact/space/rigid_round.hpp"
#include "contact/space/twin_projection.hpp"
#include "contact/space_dual.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <functional>
#include <map>
#include <memory>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

namespace spricka::contact {

namespace {

constexpr double weak_cover = 0.2; // of a function: less of it joins a neighbour
constexpr double no_cover = 1e-9;  // round-off
constexpr double twice = 1e-6;     // of a triangle: more than all of it

using PartNode = std::pair<std::size_t, base::NodeId>;

// Integrals of a triangle's three hats times what the two surfaces move along one direction.
struct HatMotionIntegrals {
  using OfHats = std::array<geometry::SidePositions, 3>; ///< [hat] by face node
  OfHats own;
  std::vector<OfHats> target;
};

struct HatIntegrals {
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero(); ///< hat times hat
  Eigen::Vector3d gap = Eigen::Vector3d::Zero();
  Eigen::Vector3d round_gap = Eigen::Vector3d::Zero();
  std::vector<std::size_t> targets;         ///< faces met
  std::array<HatMotionIntegrals, 3> motion; ///< along the normal and the tangents
};

class SpaceRows {
public:
  SpaceRows(PairConstraints& pair, std::optional<double> declared_gap, bool tangents,
            const NodesBehind& at_front)
      : pair_(pair), own_(pair.contact.space), other_(pair.target.space), declared_(declared_gap),
        directions_(tangents ? 3 : 1), at_front_(at_front), frames_(own_) {}

  void make() {
    number_functions();
    const std::function<ProjectedTriangle(const SurfaceTriangle&)> see = target_projector(pair_);
    for (const SurfaceTriangle& triangle : own_.triangles) {
      const ProjectedTriangle projection = see(triangle);
      pair_.unprojected_area += projection.unprojected_area;
      if (projection.flat_seen > (1.0 + twice) * projection.flat_area) {
        pair_.trouble = "the surfaces face each other twice at one place (two layers of the master "
                        "lie within a fifth of the slave's extent)";
        pair_.found = true;
        return;
      }
      add(triangle, projection);
    }
    pair_.segments = true;
    join_weak_ones();
    join_front();
    append();
    pair_.found = !pair_.normal.empty();
  }

private:
  void number_functions() {
    for (const SurfaceTriangle& t : own_.triangles) {
      for (const int n : t.node) {
        const base::NodeId node = own_.faces[t.face].nodes[static_cast<std::size_t>(n)];
        place_.try_emplace(PartNode{own_.part[t.face], node}, 0);
      }
    }
    for (auto& [key, at] : place_) {
      at = pair_.functions.size();
      pair_.functions.push_back({.node = key.second, .part = key.first});
    }
    rows_.resize(pair_.functions.size());
    beside_.resize(pair_.functions.size());
  }

  [[nodiscard]] HatIntegrals integrate(const SurfaceTriangle& triangle,
                                       const ProjectedTriangle& projection) const {
    HatIntegrals sum;
    const geometry::ElementSide& face = own_.faces[triangle.face];
    const auto nodes = static_cast<Eigen::Index>(face.nodes.size());
    for (int k = 0; k < directions_; ++k) {
      for (auto& own : sum.motion[static_cast<std::size_t>(k)].own) {
        own.setZero(3, nodes);
      }
    }
    const bool rigid = pair_.rigid.has_value();
    for (const ProjectionPoint& p : projection.points) {
      if (!rigid && (sum.targets.empty() || sum.targets.back() != p.target)) {
        sum.targets.push_back(p.target);
        const auto count = static_cast<Eigen::Index>(other_.faces[p.target].nodes.size());
        for (int k = 0; k < directions_; ++k) {
          auto& fresh = sum.motion[static_cast<std::size_t>(k)].target.emplace_back();
          for (auto& of_hat : fresh) {
            of_hat.setZero(3, count);
          }
        }
      }
      const geometry::SideValues N = face.N(p.r);
      const geometry::SideValues M = rigid ? geometry::SideValues() : other_.faces[p.target].N(p.s);
      const std::array<Vec3, 3> along = frames_.at(own_.part[triangle.face], p.normal);
      const Eigen::Vector3d w = p.weight * p.hat;
      sum.moment += w * p.hat.transpose();
      sum.gap += declared_.value_or(p.gap) * w;
      sum.round_gap += declared_.value_or(p.round_gap) * w;
      for (int k = 0; k < directions_; ++k) {
        HatMotionIntegrals& motion = sum.motion[static_cast<std::size_t>(k)];
        for (std::size_t h = 0; h < 3; ++h) {
          const Vec3 push = w[static_cast<Eigen::Index>(h)] * along[static_cast<std::size_t>(k)];
          motion.own[h] -= push * N.transpose();
          if (!rigid) {
            motion.target.back()[h] += push * M.transpose();
          }
        }
      }
    }
    return sum;
  }

  void add(const SurfaceTriangle& triangle, const ProjectedTriangle& projection) {
    const std::array<std::size_t, 3> at = functions_of(triangle);
    for (std::size_t a = 0; a < at.size(); ++a) {
      pair_.functions[at[a]].whole += projection.whole[static_cast<Eigen::Index>(a)];
    }
    if (projection.points.empty()) {
      return;
    }
    const HatIntegrals sum = integrate(triangle, projection);
    const Eigen::Matrix3d dual = dual_weights(sum.moment);
    for (std::size_t a = 0; a < at.size(); ++a) {
      const Eigen::RowVector3d weight = dual.row(static_cast<Eigen::Index>(a));
      std::array<ConstraintRowBuilder, 3>& row = rows_[at[a]];
      row[0].gap += weight * sum.gap;
      row[0].round_gap += weight * sum.round_gap;
      const double area = weight * sum.moment.rowwise().sum();
      for (int k = 0; k < directions_; ++k) {
        row[static_cast<std::size_t>(k)].area += area;
        add_motion(triangle, sum, static_cast<std::size_t>(k), weight,
                   row[static_cast<std::size_t>(k)]);
      }
      for (const std::size_t b : at) {
        if (b != at[a]) {
          beside_[at[a]].push_back(b);
        }
      }
    }
  }

  [[nodiscard]] std::array<std::size_t, 3> functions_of(const SurfaceTriangle& t) const {
    const std::vector<base::NodeId>& nodes = own_.faces[t.face].nodes;
    std::array<std::size_t, 3> at{};
    for (std::size_t i = 0; i < at.size(); ++i) {
      at[i] = place_.at({own_.part[t.face], nodes[static_cast<std::size_t>(t.node[i])]});
    }
    return at;
  }

  void add_motion(const SurfaceTriangle& triangle, const HatIntegrals& sum, std::size_t k,
                  const Eigen::RowVector3d& weight, ConstraintRowBuilder& row) const {
    const auto add_nodes = [&](const std::vector<base::NodeId>& nodes, const auto& of_hat) {
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        const auto c = static_cast<Eigen::Index>(i);
        row.add_contribution(nodes[i], weight[0] * of_hat[0].col(c) + weight[1] * of_hat[1].col(c) +
                                           weight[2] * of_hat[2].col(c));
      }
    };
    add_nodes(own_.faces[triangle.face].nodes, sum.motion[k].own);
    for (std::size_t t = 0; t < sum.targets.size(); ++t) {
      add_nodes(other_.faces[sum.targets[t]].nodes, sum.motion[k].target[t]);
    }
  }

  [[nodiscard]] double cover(std::size_t i) const {
    return rows_[i][0].area > 0.0 ? rows_[i][0].area / pair_.functions[i].whole : 0.0;
  }

  // The strongest of the weak ones first: each joins the best covered neighbour; where that is weak
  // itself, as before coarse faces, slivers add up to one row.
  void join_weak_ones() {
    root_.resize(rows_.size());
    std::iota(root_.begin(), root_.end(), std::size_t{0});
    std::vector<std::size_t> weak;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      pair_.functions[i].area = rows_[i][0].area;
      if (rows_[i][0].area > 0.0 && cover(i) < weak_cover) {
        weak.push_back(i);
      }
    }
    std::vector<double> covered(rows_.size());
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      covered[i] = cover(i);
    }
    std::ranges::stable_sort(weak, std::greater<>(), [&](std::size_t i) { return covered[i]; });
    for (const std::size_t i : weak) {
      std::size_t best = i;
      for (const std::size_t b : beside_[i]) {
        if (covered[b] > covered[best]) {
          best = b;
        }
      }
      if (best == i) {
        if (covered[i] <= no_cover) {
          rows_[i] = {};
        }
        continue; // what is covered must hold
      }
      root_[i] = root_[best];
      for (std::size_t k = 0; k < rows_[i].size(); ++k) {
        rows_[root_[i]][k].add_contribution(rows_[i][k]);
      }
      rows_[i] = {};
      ++pair_.merged;
    }
  }

  // Nodes of a crack's front belong to both faces: their own rows would ask nothing.
  void join_front() {
    for (const auto& [key, i] : place_) {
      const auto behind = at_front_.find(key.second);
      if (behind == at_front_.end()) {
        continue;
      }
      if (const auto taker = place_.find({key.first, behind->second}); taker != place_.end()) {
        root_[i] = root_[taker->second];
        for (std::size_t k = 0; k < rows_[i].size(); ++k) {
          rows_[root_[i]][k].add_contribution(rows_[i][k]);
        }
      }
      rows_[i] = {};
    }
  }

  void append() {
    std::vector<int> row_of(rows_.size(), -1);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (!(rows_[i][0].area > 0.0)) {
        continue;
      }
      row_of[i] = static_cast<int>(pair_.normal.size());
      const base::NodeId node = pair_.functions[i].node;
      for (int k = 1; k < directions_; ++k) {
        pair_.tangent.push_back(rows_[i][static_cast<std::size_t>(k)].make_row(node, row_of[i], k));
      }
      pair_.normal.push_back(rows_[i][0].make_row(node));
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      pair_.functions[i].row = row_of[root_[i]];
      pair_.functions[i].joined = root_[i] != i;
    }
  }

  PairConstraints& pair_;
  const SpaceSurface& own_;
  const SpaceSurface& other_;
  std::optional<double> declared_;
  int directions_; ///< 1, or 3 with tangents
  const NodesBehind& at_front_;
  SurfaceFrames frames_;
  std::map<PartNode, std::size_t> place_;
  std::vector<std::array<ConstraintRowBuilder, 3>> rows_; ///< [function] along normal and tangents
  std::vector<std::vector<std::size_t>> beside_;          ///< [function] those of covered triangles
  std::vector<std::size_t> root_;                         ///< [function] whose row has it
};

} // namespace

void fill_space_mortar_rows(PairConstraints& pair, std::optional<double> declared_gap,
                            bool tangents, const NodesBehind& at_front) {
  SpaceRows(pair, declared_gap, tangents, at_front).make();
}

std::function<ProjectedTriangle(const SurfaceTriangle&)>
target_projector(const PairConstraints& pair) {
  const SpaceSurface& own = pair.contact.space;
  if (pair.faces) {
    const std::optional<std::vector<TwinFace>> twins = twin_faces(own, pair.target.space);
    assert(twins);
    return [&own, twins = *twins](const SurfaceTriangle& triangle) {
      return project_onto_twin(own, twins[triangle.face], triangle);
    };
  }
  if (pair.rigid_shape) {
    return [&own, shape = *pair.rigid_shape](const SurfaceTriangle& triangle) {
      return project_onto_rigid(own, shape, triangle);
    };
  }
  // A std::function can be copied, the tree of a Sighting can't.
  return [projection = std::make_shared<SurfaceProjection>(own, pair.target.space)](
             const SurfaceTriangle& triangle) { return projection->project_triangle(triangle); };
}

std::vector<std::vector<std::size_t>> functions_by_face(const PairConstraints& pair) {
  const SpaceSurface& surface = pair.contact.space;
  std::map<PartNode, std::size_t> place;
  for (std::size_t i = 0; i < pair.functions.size(); ++i) {
    place[{pair.functions[i].part, pair.functions[i].node}] = i;
  }
  std::vector<std::vector<std::size_t>> all;
  for (std::size_t f = 0; f < surface.faces.size(); ++f) {
    std::vector<std::size_t>& at = all.emplace_back();
    for (const base::NodeId n : surface.faces[f].nodes) {
      const auto own = place.find({surface.part[f], n});
      if (own != place.end()) { // corners come first
        at.push_back(own->second);
      }
    }
  }
  return all;
}

} // namespace spricka::contact
