// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/set_shares.hpp"

#include "fe/element_outline.hpp"
#include "fe/jacobian.hpp"
#include "geometry/box.hpp"
#include "model/mesh.hpp"
#include "model/model.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace spricka::fe {
namespace {

using base::ElementId;
using base::Vec2;
using base::Vec3;
using Polygon = std::vector<Vec2>;

constexpr std::array<double, 3> whole{1.0, 0.0, 0.0};
constexpr int moment_degree = 5;    // squares of coordinates on curved elements
constexpr double sliver = 1e-9;     // of an element: what is less is round-off
constexpr double curve_room = 1e-2; // largest correction for curved rims

/// A triangle, anticlockwise, with the sign it counts with.
struct Triangle {
  std::array<Vec2, 3> corner;
  double sign = 1.0;
};

// A fan; where the outline is not seen from the first corner as a whole, signs take care of it.
std::vector<Triangle> fan(const Polygon& polygon) {
  std::vector<Triangle> result;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    Triangle t{{polygon[0], polygon[i], polygon[i + 1]}};
    if (base::cross(t.corner[1] - t.corner[0], t.corner[2] - t.corner[0]) < 0.0) {
      std::swap(t.corner[1], t.corner[2]);
      t.sign = -1.0;
    }
    result.push_back(t);
  }
  return result;
}

// Sutherland and Hodgman (1974): what of a convex polygon lies on the left of a line.
Polygon left_of(const Polygon& polygon, const Vec2& a, const Vec2& b) {
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& p = polygon[i];
    const Vec2& q = polygon[(i + 1) % polygon.size()];
    const double dp = base::cross(b - a, p - a);
    const double dq = base::cross(b - a, q - a);
    if (dp >= 0.0) {
      result.push_back(p);
    }
    if ((dp > 0.0 && dq < 0.0) || (dp < 0.0 && dq > 0.0)) {
      result.emplace_back(p + dp / (dp - dq) * (q - p));
    }
  }
  return result;
}

// Area and first moments about a point.
Vec3 moments_of(const Polygon& polygon, const Vec2& at) {
  Vec3 m = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Vec2 u = polygon[i] - polygon[0];
    const Vec2 v = polygon[i + 1] - polygon[0];
    const double area = 0.5 * base::cross(u, v);
    const Vec2 centre = polygon[0] + (u + v) / 3.0 - at;
    m += area * Vec3(1.0, centre.x(), centre.y());
  }
  return m;
}

// The same of what two outlines have in common, by their fans: each pair of triangles is clipped.
Vec3 common_moments(const std::vector<Triangle>& one, const std::vector<Triangle>& other,
                    const Vec2& at) {
  Vec3 sum = Vec3::Zero();
  for (const Triangle& s : one) {
    for (const Triangle& t : other) {
      Polygon piece(s.corner.begin(), s.corner.end());
      for (std::size_t k = 0; k < 3 && piece.size() > 2; ++k) {
        piece = left_of(piece, t.corner[k], t.corner[(k + 1) % 3]);
      }
      if (piece.size() > 2) {
        sum += s.sign * t.sign * moments_of(piece, at);
      }
    }
  }
  return sum;
}

// Integral of phi phi^T over an element, phi = 1, x, y about a point; entry 0, 0 is its area.
Eigen::Matrix3d mass_of(const model::Mesh& mesh, ElementId e, const Vec2& at) {
  Eigen::Matrix3d mass = Eigen::Matrix3d::Zero();
  const AnyElement<2>& element = shape::reference_element<2>(mesh.type[e.index()]);
  const AnyNodeVectors<2> X = element_coordinates(element, mesh, e).colwise() - at;
  for (const auto& point : shape::quadrature<2>(element.domain, moment_degree)) {
    const Eigen::Matrix2d J = X.lazyProduct(element.dN(point.r));
    const Vec2 x = X * element.N(point.r);
    const Vec3 phi(1.0, x.x(), x.y());
    mass += point.weight * J.determinant() * phi * phi.transpose();
  }
  return mass;
}

Vec2 centre_of(const Polygon& polygon) {
  Vec2 sum = Vec2::Zero();
  for (const Vec2& p : polygon) {
    sum += p;
  }
  return sum / static_cast<double>(polygon.size());
}

/// How the new elements of a mesh overlap the deck's elements that they stand for.
class Overlap {
public:
  Overlap(const model::Mesh& host, const std::vector<ElementId>& replaced, const model::Mesh& mesh,
          std::size_t first_fresh);
  [[nodiscard]] std::vector<CutElementShareFunction> shares(const std::vector<bool>& member) const;

private:
  struct HostOverlap {
    ElementId host;
    Vec3 moment; ///< of what both have in common
  };
  struct Fresh {
    ElementId element;
    Vec2 at;
    Eigen::Matrix3d mass;
    std::vector<HostOverlap> parts;
  };
  const model::Mesh& host_;
  const std::vector<ElementId>& replaced_;
  std::vector<Fresh> fresh_;
};

Overlap::Overlap(const model::Mesh& host, const std::vector<ElementId>& replaced,
                 const model::Mesh& mesh, std::size_t first_fresh)
    : host_(host), replaced_(replaced) {
  std::vector<geometry::Box<2>> boxes;
  std::vector<std::vector<Triangle>> fans;
  for (const ElementId e : replaced_) {
    const Polygon polygon = element_outline(host, e);
    boxes.push_back(geometry::Box<2>::around(polygon));
    fans.push_back(fan(polygon));
  }
  for (std::size_t i = first_fresh; i < mesh.element_count(); ++i) {
    const ElementId e(i);
    const Polygon polygon = element_outline(mesh, e);
    const geometry::Box<2> box = geometry::Box<2>::around(polygon);
    const std::vector<Triangle> own = fan(polygon);
    const Vec2 at = centre_of(polygon);
    Fresh found{e, at, mass_of(mesh, e, at), {}};
    for (std::size_t h = 0; h < replaced_.size(); ++h) {
      if (box.meets(boxes[h])) {
        const Vec3 moment = common_moments(own, fans[h], at);
        if (std::abs(moment[0]) > sliver * found.mass(0, 0)) {
          found.parts.push_back({replaced_[h], moment});
        }
      }
    }
    fresh_.push_back(std::move(found));
  }
}

// Of elements that lie within the set as a whole too, as [1, 0, 0].
std::vector<CutElementShareFunction> Overlap::shares(const std::vector<bool>& member) const {
  double wanted = 0.0; // what the cut elements have to take
  for (const ElementId e : replaced_) {
    wanted += member[e.index()] ? mass_of(host_, e, Vec2::Zero())(0, 0) : 0.0;
  }
  std::vector<CutElementShareFunction> result;
  double found = 0.0;
  for (const Fresh& f : fresh_) {
    Vec3 in = Vec3::Zero();
    double all = 0.0;
    for (const HostOverlap& part : f.parts) {
      all += part.moment[0];
      if (member[part.host.index()]) {
        in += part.moment;
      }
    }
    const double room = sliver * f.mass(0, 0);
    if (in[0] <= room || all <= 0.0) {
      continue;
    }
    // Nothing but round-off lies outside the set.
    if (all - in[0] <= room) {
      // Elements inside take their own area: the correction for curved rims is left to those that
      // are cut.
      wanted -= f.mass(0, 0);
      result.push_back({f.element, whole, f.at});
      continue;
    }
    in *= f.mass(0, 0) / all; // the polygons of curved elements are not quite they
    // The projection: integral and first moments of the share are those of the set's part.
    const Vec3 c = f.mass.ldlt().solve(in);
    result.push_back({f.element, {c[0], c[1], c[2]}, f.at});
    found += in[0];
  }
  if (found > 0.0 && std::abs(wanted / found - 1.0) < curve_room) {
    for (CutElementShareFunction& share : result) {
      if (share.c == whole) {
        continue;
      }
      for (double& c : share.c) {
        c *= wanted / found;
      }
    }
  }
  return result;
}

/// Elements of the deck's mesh that have no place in another, and the first that is new there:
/// those that stay keep their order and labels.
struct Replaced {
  std::vector<ElementId> elements;
  std::size_t first_fresh = 0;
};

Replaced replaced_elements(const model::Mesh& host, const model::Mesh& mesh) {
  Replaced result;
  for (std::size_t e = 0; e < host.element_count(); ++e) {
    const std::size_t at = result.first_fresh;
    if (at < mesh.element_count() && mesh.element_label[at] == host.element_label[e] &&
        mesh.element_net[at] == host.element_net[e] && mesh.type[at] == host.type[e]) {
      ++result.first_fresh;
    } else {
      result.elements.emplace_back(e);
    }
  }
  return result;
}

} // namespace

const CutElementShareFunction* ElementSetCoverage::find_cut_share_function(ElementId e) const {
  const auto at = std::ranges::lower_bound(cut, e, {}, &CutElementShareFunction::element);
  return at != cut.end() && at->element == e ? &*at : nullptr;
}

ElementSetCoverage find_set_coverage(const model::Model& model, const model::Mesh& mesh,
                                     base::ElementSetId set) {
  ElementSetCoverage result{mesh.set_with_id(set).elements, {}};
  const model::Mesh& host = model.mesh;
  if (&host == &mesh || mesh.dim != 2 || set.index() >= host.element_sets.size()) {
    return result;
  }
  const Replaced replaced = replaced_elements(host, mesh);
  std::vector<bool> member(host.element_count(), false);
  for (const ElementId e : host.set_with_id(set).elements) {
    member[e.index()] = true;
  }
  const auto in =
      std::ranges::count_if(replaced.elements, [&](ElementId e) { return member[e.index()]; });
  // The rim does not run through a patch: new elements are in the set, or not, as a whole.
  if (in == 0 || in == std::ssize(replaced.elements)) {
    return result;
  }
  const Overlap overlap(host, replaced.elements, mesh, replaced.first_fresh);
  std::erase_if(result.elements, [&](ElementId e) { return e.index() >= replaced.first_fresh; });
  for (const CutElementShareFunction& share : overlap.shares(member)) {
    result.elements.push_back(share.element);
    if (share.c != whole) {
      result.cut.push_back(share);
    }
  }
  return result;
}

} // namespace spricka::fe
