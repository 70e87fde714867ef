// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/section_limit.hpp"

#include "base/disjoint_sets.hpp"
#include "fe/assemble.hpp"
#include "geometry/box.hpp"
#include "mesh/front_curve.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace spricka::growth {

namespace {

using base::ElementId;
using base::NodeId;
using base::Vec2;
using base::Vec3;
using Tetrahedron = std::array<int, 4>;

constexpr double in_plane = 1e-8;        // of the body
constexpr double at_end = 1e-6;          // of the section
constexpr double least_pieces = 10000.0; // of a section

// Corners of tetrahedra that fill an element of 4, 6 or 8 corners.
std::span<const Tetrahedron> tetrahedra(int corners) {
  static constexpr std::array<Tetrahedron, 1> of_tetrahedron{{{0, 1, 2, 3}}};
  static constexpr std::array<Tetrahedron, 3> of_wedge{{{0, 1, 2, 3}, {1, 2, 3, 4}, {2, 3, 4, 5}}};
  static constexpr std::array<Tetrahedron, 6> of_brick{
      {{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6}, {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}}};
  return corners == 4   ? std::span<const Tetrahedron>(of_tetrahedron)
         : corners == 6 ? std::span<const Tetrahedron>(of_wedge)
                        : std::span<const Tetrahedron>(of_brick);
}

class RemainingSection {
public:
  RemainingSection(const CrackedBodies& in, const mesh::CrackFront& front)
      : in_(in), mesh_(in.cracked.mesh), groups_(mesh_.node_count()) {
    const mesh::FrontFrame frame = front.curve->at(0.0);
    origin_ = frame.x;
    normal_ = frame.b;
    first_ = frame.m;
    second_ = normal_.cross(first_);
    measure_heights();
    mark_crack_faces();
    side_.assign(mesh_.node_count(), 0);
    for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
      cut(ElementId(e));
    }
    join_ties(in.ties);
    keep(groups_.root(front.points.front().node.index()));
  }

  [[nodiscard]] const std::vector<SectionPiece>& pieces() const { return pieces_; }
  [[nodiscard]] const std::vector<ElementId>& below() const { return below_; }

  /// Normal force on the elements below from those above and its moments q about the front's first
  /// point, f reduced by the ties.
  [[nodiscard]] SectionLoad load(const base::Matrix& f) const {
    double N = 0.0;
    Vec3 M = Vec3::Zero();
    for (std::size_t n = 0; n < mesh_.node_count(); ++n) {
      if (on_cut_[n]) {
        const Vec3 F = f.col(0).segment<3>(3 * static_cast<Eigen::Index>(n));
        N += F.dot(normal_);
        M += (mesh_.x[n] - origin_).cross(F);
      }
    }
    // r x (sigma n) has -sigma r1 along the second axis and sigma r2 along the first.
    return {N, {-M.dot(second_), M.dot(first_)}};
  }

  /// Adds the mirror image beyond planes of symmetry: where all of one end of the section is held
  /// along a global axis. The half cannot tilt about such a plane.
  void complete(SectionLoad& load) {
    for (int axis = 0; axis < 3; ++axis) {
      const Vec2 way(first_[axis], second_[axis]);
      if (way.norm() < 1.0 - in_plane) { // the axis does not lie in the section
        continue;
      }
      if (const std::optional<double> place = held_end(axis)) {
        const double at = *place - origin_[axis]; // along `way`
        const std::size_t own = pieces_.size();
        for (std::size_t i = 0; i < own; ++i) {
          const SectionPiece& piece = pieces_[i];
          pieces_.push_back({piece.at - 2.0 * (piece.at.dot(way) - at) * way, piece.area});
        }
        load.q = 2.0 * load.q - 2.0 * (load.q.dot(way) - at * load.N) * way;
        load.N *= 2.0;
      }
    }
  }

private:
  struct CutTriangle {
    std::array<Vec2, 3> x;
    double area = 0.0;
    std::size_t node = 0; ///< of its element
  };

  // The end of the cut along an axis at which all nodes are held along it.
  [[nodiscard]] std::optional<double> held_end(int axis) const {
    double low = std::numeric_limits<double>::max();
    double high = -low;
    for (std::size_t n = 0; n < mesh_.node_count(); ++n) {
      if (on_cut_[n]) {
        low = std::min(low, mesh_.x[n][axis]);
        high = std::max(high, mesh_.x[n][axis]);
      }
    }
    const double near = at_end * (high - low);
    for (const double end : {low, high}) {
      int held = 0;
      bool free = false;
      for (std::size_t n = 0; n < mesh_.node_count(); ++n) {
        if (on_cut_[n] && std::abs(mesh_.x[n][axis] - end) <= near) {
          const model::FreedomRole cls = in_.cls[3 * n + static_cast<std::size_t>(axis)];
          held += cls == model::FreedomRole::suppressed ? 1 : 0;
          free = free || (cls != model::FreedomRole::suppressed &&
                          cls != model::FreedomRole::dependent); // goes where others go
        }
      }
      if (high > low && held > 1 && !free) {
        return end;
      }
    }
    return std::nullopt;
  }

  void measure_heights() {
    const double nothing = in_plane * geometry::Box<3>::around(mesh_.x).diagonal();
    height_.reserve(mesh_.node_count());
    for (const Vec3& x : mesh_.x) {
      const double h = (x - origin_).dot(normal_);
      height_.push_back(std::abs(h) < nothing ? 0.0 : h);
    }
  }

  void mark_crack_faces() {
    on_face_.assign(mesh_.node_count(), false);
    for (const mesh::CrackFaceNodes& faces : in_.cracked.faces) {
      for (const std::vector<NodeId>* side : {&faces.left, &faces.right}) {
        for (const NodeId n : *side) {
          on_face_[n.index()] = true;
        }
      }
    }
  }

  // The plane itself counts as above: what lies in it is the upper side of elements below.
  void cut(ElementId e) {
    const std::span<const NodeId> nodes = mesh_.element_nodes(e);
    const int corners = base::element_info(mesh_.type[e.index()]).corners;
    double middle = 0.0;
    for (int i = 0; i < corners; ++i) {
      middle += height_[nodes[static_cast<std::size_t>(i)].index()];
    }
    const bool is_below = middle < 0.0;
    if (is_below) {
      below_.push_back(e);
    }
    for (const NodeId n : nodes) {
      side_[n.index()] = static_cast<char>(side_[n.index()] | (is_below ? 2 : 1));
    }
    const std::size_t before = cuts_.size();
    for (const Tetrahedron& t : tetrahedra(corners)) {
      cut(nodes, t);
    }
    if (cuts_.size() > before) {
      for (const NodeId n : nodes) {
        groups_.join_sets(n.index(), nodes[0].index());
      }
    }
  }

  void cut(std::span<const NodeId> nodes, const Tetrahedron& corners) {
    std::vector<std::size_t> above, below;
    bool face = true;
    for (const int i : corners) {
      const std::size_t n = nodes[static_cast<std::size_t>(i)].index();
      (height_[n] >= 0.0 ? above : below).push_back(n);
      face = face && (height_[n] < 0.0 || (height_[n] == 0.0 && on_face_[n]));
    }
    if (above.empty() || below.empty() || (face && above.size() == 3)) {
      return;
    }
    const auto crossing = [&](std::size_t a, std::size_t b) -> Vec2 {
      const double part = height_[a] / (height_[a] - height_[b]);
      const Vec3 x = (1.0 - part) * mesh_.x[a] + part * mesh_.x[b] - origin_;
      return {x.dot(first_), x.dot(second_)};
    };
    if (above.size() == 2) {
      const std::array<Vec2, 4> x{crossing(above[0], below[0]), crossing(above[0], below[1]),
                                  crossing(above[1], below[1]), crossing(above[1], below[0])};
      add({x[0], x[1], x[2]}, below[0]);
      add({x[0], x[2], x[3]}, below[0]);
    } else {
      std::array<Vec2, 3> x;
      for (std::size_t k = 0; k < 3; ++k) {
        x.at(k) = above.size() == 1 ? crossing(above[0], below[k]) : crossing(above[k], below[0]);
      }
      add(x, below[0]);
    }
  }

  void add(const std::array<Vec2, 3>& x, std::size_t node) {
    const Vec2 u = x[1] - x[0];
    const Vec2 v = x[2] - x[0];
    const double area = 0.5 * std::abs(u.x() * v.y() - u.y() * v.x());
    if (area > 0.0) {
      cuts_.push_back({x, area, node});
    }
  }

  // A dependent node of the cut belongs to where its masters are, and its forces go there.
  void join_ties(const fe::ConstraintTransformation& ties) {
    std::vector<bool> of_cut(mesh_.node_count(), false);
    for (const CutTriangle& cut : cuts_) {
      of_cut[groups_.root(cut.node)] = true;
    }
    for (const fe::ConstraintTransformation::DependentRow& row : ties.rows()) {
      const auto slave = static_cast<std::size_t>(row.freedom / 3);
      const bool joins = of_cut[groups_.root(slave)];
      for (const auto& term : row.terms) {
        const auto master = static_cast<std::size_t>(term.freedom / 3);
        side_[master] = static_cast<char>(side_[master] | side_[slave]);
        if (joins) {
          groups_.join_sets(master, slave);
        }
      }
    }
  }

  void keep(std::size_t group) {
    on_cut_.assign(mesh_.node_count(), false);
    for (std::size_t n = 0; n < mesh_.node_count(); ++n) {
      on_cut_[n] = side_[n] == 3 && groups_.root(n) == group;
    }
    std::erase_if(cuts_, [&](const CutTriangle& cut) { return groups_.root(cut.node) != group; });
    double area = 0.0;
    for (const CutTriangle& cut : cuts_) {
      area += cut.area;
    }
    for (const CutTriangle& cut : cuts_) {
      divide(cut, static_cast<int>(std::ceil(std::sqrt(least_pieces * cut.area / area))));
    }
  }

  // Into n^2 triangles: |v| bends within those on the neutral line.
  void divide(const CutTriangle& cut, int n) {
    const Vec2 u = (cut.x[1] - cut.x[0]) / n;
    const Vec2 v = (cut.x[2] - cut.x[0]) / n;
    const double area = cut.area / (n * n);
    for (int i = 0; i < n; ++i) {
      for (int k = 0; i + k < n; ++k) {
        const Vec2 corner = cut.x[0] + i * u + k * v;
        pieces_.push_back({corner + (u + v) / 3.0, area});
        if (i + k + 1 < n) {
          pieces_.push_back({corner + 2.0 * (u + v) / 3.0, area});
        }
      }
    }
  }

  const CrackedBodies& in_;
  const model::Mesh& mesh_;
  Vec3 origin_, normal_, first_, second_; ///< of the section, axes unit
  std::vector<double> height_;            ///< [node] above the plane
  std::vector<bool> on_face_;             ///< [node] of a crack
  std::vector<char> side_;                ///< [node] 1: in elements above, 2: below
  std::vector<bool> on_cut_;              ///< [node]
  base::DisjointSets groups_;             ///< of nodes that hang together
  std::vector<CutTriangle> cuts_;
  std::vector<SectionPiece> pieces_;
  std::vector<ElementId> below_;
};

} // namespace

// The least D(e, k) with N e + q k = 1: quadratic problems whose weights are those of the one
// before, 1/|v|, until D stays. Pieces on the neutral line have the weight of some tiny v.
double plastic_load_ratio(const std::vector<SectionPiece>& section, const SectionLoad& on,
                          double flow_stress) {
  double area = 0.0;
  for (const SectionPiece& piece : section) {
    area += piece.area;
  }
  const double width = std::sqrt(area);
  const Vec3 load(on.N, on.q.x() / width, on.q.y() / width);
  if (!(area > 0.0) || !(load.norm() > 0.0)) {
    return 0.0;
  }
  constexpr int most = 200;
  constexpr double settled = 1e-9;
  constexpr double tiny = 1e-6; // of the mean velocity
  std::vector<double> weight(section.size(), 1.0);
  double least = std::numeric_limits<double>::infinity();
  for (int round = 0; round < most; ++round) {
    Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < section.size(); ++i) {
      const Vec3 b(1.0, section[i].at.x() / width, section[i].at.y() / width);
      H += section[i].area * weight[i] * b * b.transpose();
    }
    const Vec3 way = H.inverse() * load;
    const Vec3 z = way / load.dot(way);
    double D = 0.0;
    for (std::size_t i = 0; i < section.size(); ++i) {
      const double v = z[0] + (z[1] * section[i].at.x() + z[2] * section[i].at.y()) / width;
      D += section[i].area * std::abs(v);
      weight[i] = std::abs(v);
    }
    const double floor = tiny * D / area;
    for (double& w : weight) {
      w = 1.0 / std::max(w, floor);
    }
    const bool done = D > (1.0 - settled) * least;
    least = std::min(least, D);
    if (done) {
      break;
    }
  }
  return 1.0 / (flow_stress * least);
}

double plastic_load_ratio(const CrackedBodies& in, const mesh::CrackFront& front,
                          const base::Vector& u, double flow_stress) {
  if (front.curve == nullptr) {
    return 0.0;
  }
  RemainingSection section(in, front);
  // At nodes of the cut the internal forces of what lies below do not sum to zero: they are what
  // the rest carries.
  base::Vector own = base::Vector::Zero(u.size());
  fe::add_internal_force(in.model, in.cracked.mesh, section.below(), u, own);
  base::Matrix f = own;
  in.ties.transfer_forces_to_masters(f);
  SectionLoad load = section.load(f);
  section.complete(load);
  return plastic_load_ratio(section.pieces(), load, flow_stress);
}

} // namespace spricka::growth
