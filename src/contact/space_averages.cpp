// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/space_averages.hpp"

#include "base/index.hpp"
#include "contact/make_rows.hpp"
#include "shape/quadrature.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace spricka::contact {

using base::index;

namespace {

// Of a function's area: on coarse curved faces some per cent lie beside the planes of the
// triangles.
constexpr double all_covered = 0.95;
constexpr double least_spread = 1e-3; // of places, squared: across it they lie on one line
constexpr int hat_degree = 5;

// What the node k of a face gives to its corner c: all of its own, half of the middle of a side
// that ends there, a quarter of the centre.
double share_of(std::size_t c, std::size_t k, std::size_t corners) {
  if (k < corners) {
    return k == c ? 1.0 : 0.0;
  }
  const std::size_t side = k - corners; // from corner `side` to the next
  return k == 2 * corners ? 0.25 : side == c || (side + 1) % corners == c ? 0.5 : 0.0;
}

// Where the mean that each function weighs is taken: int phi x dA / int phi dA.
std::vector<base::Vec3> centres_of(const PairConstraints& pair,
                                   const std::vector<std::vector<std::size_t>>& faces) {
  const FacetSurface& surface = pair.contact;
  std::vector<base::Vec3> moment(pair.functions.size(), base::Vec3::Zero());
  base::Vector area = base::Vector::Zero(index(pair.functions.size()));
  for (const HatElement& t : surface.elements) {
    const geometry::ElementSide& face = surface.facets[t.facet];
    const std::array<Vec2, 3> r = hat_node_local_coordinates(face, t.node);
    for (const auto& [q, weight] : shape::triangle_rule(hat_degree)) {
      const std::array<double, 3> hat{1.0 - q[0] - q[1], q[0], q[1]};
      const geometry::SidePoint at = face.point(hat[0] * r[0] + hat[1] * r[1] + hat[2] * r[2]);
      for (std::size_t k = 0; k < hat.size(); ++k) {
        const std::size_t i = faces[t.facet][static_cast<std::size_t>(t.node[k])];
        const double w = weight * at.area_vector().norm() * hat[k];
        area[index(i)] += w;
        moment[i] += w * at.x;
      }
    }
  }
  for (std::size_t i = 0; i < moment.size(); ++i) {
    moment[i] /= area[index(i)];
  }
  return moment;
}

// Pressures at the corners of faces (contact_space.6), and what is linear between them.
class Averages {
public:
  Averages(const PairConstraints& pair, const base::Vector& p, const std::vector<bool>& closed)
      : pair_(pair), p_(p), faces_(functions_by_facet(pair)), centre_(centres_of(pair, faces_)),
        given_(pair.functions.size()), sound_(pair.functions.size(), true),
        beside_(pair.functions.size()), normal_(pair.functions.size(), base::Vec3::Zero()),
        place_(pair.functions.size(), base::Vec3::Zero()), mean_(p.size()) {
    for (const SingularContactEdge& end : pair.sharp_ends) {
      if (!end.bounded) {
        sharp_.insert(end.nodes.begin(), end.nodes.end());
      }
    }
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      look_at(f, closed);
    }
    for (std::size_t c = 0; c < given_.size(); ++c) {
      take_mean(c);
    }
  }

  // As p itself where a face round a corner is not all covered and closed, or has a node at an edge
  // where the pressure has no bound.
  [[nodiscard]] base::Vector values() const {
    base::Vector out = p_;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      for (std::size_t k = 0; k < faces_[f].size(); ++k) {
        double sum = 0.0;
        bool known = true;
        for (std::size_t c = 0; c < corners_of(f); ++c) {
          if (const double share = share_of(c, k, corners_of(f)); share > 0.0) {
            known = known && sound_[faces_[f][c]];
            sum += known ? share * at_corner(faces_[f][c]) : 0.0;
          }
        }
        if (known) {
          out[index(faces_[f][k])] = sum;
        }
      }
    }
    return out;
  }

private:
  [[nodiscard]] std::size_t corners_of(std::size_t f) const {
    return static_cast<std::size_t>(pair_.contact.facets[f].corner_count());
  }

  void look_at(std::size_t f, const std::vector<bool>& closed) {
    const geometry::ElementSide& face = pair_.contact.facets[f];
    // Corners of node pairs on faces of 6 nodes open and close at random: nothing acts there.
    const bool all = !pair_.segments || std::ranges::all_of(faces_[f], [&](std::size_t i) {
      const MultiplierFunction& own = pair_.functions[i];
      return closed[i] && !own.joined && own.area >= all_covered * own.whole &&
             !sharp_.contains(own.node);
    });
    const base::Vec3 normal = face.area_vector(face.domain_centre());
    for (std::size_t c = 0; c < corners_of(f); ++c) {
      const std::size_t corner = faces_[f][c];
      sound_[corner] = sound_[corner] && all;
      normal_[corner] += normal;
      place_[corner] = face.X.col(index(c));
      for (std::size_t k = 0; k < faces_[f].size(); ++k) {
        if (const double share = share_of(c, k, corners_of(f)); share > 0.0) {
          given_[corner][faces_[f][k]] = share;
        }
      }
      for (std::size_t k = 0; k < corners_of(f); ++k) {
        beside_[corner].insert(faces_[f][k]);
      }
    }
  }

  // P_c = sum share w p / sum share w over the faces round a corner, and the place it is the
  // pressure of.
  void take_mean(std::size_t c) {
    double force = 0.0;
    double area = 0.0;
    base::Vec3 moment = base::Vec3::Zero();
    for (const auto& [giver, share] : given_[c]) {
      const double w = share * pair_.functions[giver].area;
      force += w * p_[index(giver)];
      area += w;
      moment += w * centre_[giver];
    }
    mean_[index(c)] = area > 0.0 ? force / area : 0.0;
    centre_of_mean_.push_back(area > 0.0 ? base::Vec3(moment / area) : place_[c]);
  }

  // From the place of the mean to the corner, which at the edge of a surface lie apart: by the
  // gradient along the surface that fits the means round it best.
  [[nodiscard]] double at_corner(std::size_t c) const {
    const base::Vec3 n = normal_[c].normalized();
    const base::Vec3 e1 = n.unitOrthogonal();
    const base::Vec3 e2 = n.cross(e1);
    const auto along = [&](const base::Vec3& d) { return Vec2(d.dot(e1), d.dot(e2)); };
    Eigen::Matrix2d square = Eigen::Matrix2d::Zero();
    Vec2 load = Vec2::Zero();
    double least = mean_[index(c)];
    for (const std::size_t k : beside_[c]) {
      if (sound_[k]) {
        const Vec2 d = along(centre_of_mean_[k] - centre_of_mean_[c]);
        square += d * d.transpose();
        load += (mean_[index(k)] - mean_[index(c)]) * d;
        least = std::min(least, mean_[index(k)]);
      }
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(square);
    Vec2 gradient = Vec2::Zero();
    for (Eigen::Index i = 0; i < 2; ++i) {
      // A direction in which no other mean lies has no gradient.
      if (eigen.eigenvalues()[i] > least_spread * eigen.eigenvalues()[1]) {
        const Vec2 v = eigen.eigenvectors().col(i);
        gradient += v.dot(load) / eigen.eigenvalues()[i] * v;
      }
    }
    base::Vec3 way = place_[c] - centre_of_mean_[c];
    for (std::size_t i = 0; i < 3; ++i) {
      way[index(i)] = pair_.functions[c].held[i] ? 0.0 : way[index(i)];
    }
    const double p = mean_[index(c)] + gradient.dot(along(way));
    return least >= 0.0 ? std::max(p, 0.0) : p;
  }

  const PairConstraints& pair_;
  const base::Vector& p_;
  std::set<base::NodeId> sharp_;
  std::vector<std::vector<std::size_t>> faces_;      ///< [face] its functions
  std::vector<base::Vec3> centre_;                   ///< [function]
  std::vector<std::map<std::size_t, double>> given_; ///< [corner] shares, by giver
  std::vector<bool> sound_;                          ///< [corner]
  std::vector<std::set<std::size_t>> beside_;        ///< [corner] corners of its faces
  std::vector<base::Vec3> normal_, place_;           ///< [corner]
  base::Vector mean_;                                ///< [corner]
  std::vector<base::Vec3> centre_of_mean_;           ///< [corner]
};

} // namespace

base::Vector average_multipliers_to_corners(const PairConstraints& pair, const base::Vector& p,
                                            const std::vector<bool>& closed) {
  // Twins pass pressures on without a ripple; their faces are coarse where a crack is wide, and a
  // mean would flatten what changes over a few of them.
  return pair.faces ? p : Averages(pair, p, closed).values();
}

} // namespace spricka::contact
