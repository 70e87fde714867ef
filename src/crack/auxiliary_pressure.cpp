// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/auxiliary_pressure.hpp"

#include "crack/auxiliary_field.hpp"
#include "crack/plane_side.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace spricka::crack {

namespace {

/// A point of a face: what presses there, per displacement of a auxiliary field along the radius.
struct PressedPoint {
  std::vector<base::NodeId> nodes;
  SideValues N, dN;
  base::Vec2 tangent, normal;
  Polar place;
  double weight = 0.0; ///< lambda / x included
};

// Order along the crack of the nodes of one face; -1: not on it.
class CrackFaceOrder {
public:
  explicit CrackFaceOrder(const std::vector<base::NodeId>& face) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      place_[face[i]] = static_cast<int>(i);
    }
  }
  // Neighbours along the crack, with the middle node between them.
  [[nodiscard]] bool has_side(const std::vector<base::NodeId>& nodes) const {
    std::vector<int> at;
    for (const base::NodeId n : nodes) {
      const auto met = place_.find(n);
      if (met == place_.end()) {
        return false;
      }
      at.push_back(met->second);
    }
    return std::abs(at[0] - at[1]) == static_cast<int>(nodes.size()) - 1;
  }

private:
  std::map<base::NodeId, int> place_;
};

constexpr int degree = 9;

using PressedVisit = std::function<void(const PressedPoint& point)>;

// Visits the points of a side of an element. Towards the tip 1 + xi = 2 t^2, as products of
// auxiliary fields with derivatives of displacements go with roots of the distance.
void for_points_of(const TipSetting& set, base::ElementId e, const PlaneSide& side,
                   const PressedVisit& visit) {
  PressedPoint p;
  p.nodes = side.nodes;
  const double from = p.nodes[0] == set.tip_node ? 1.0 : p.nodes[1] == set.tip_node ? -1.0 : 0.0;
  const SideVectors R = side.positions_from_tip(set.tip.x);
  const double lambda = SectionElasticity(set, e).law.lambda;
  for (const auto& point : shape::line_rule(degree)) {
    shape::Point<1> r = point.r;
    double weight = point.weight;
    if (from != 0.0) {
      const double t = 0.5 * (1.0 + point.r[0]);
      r[0] = from * (2.0 * t * t - 1.0);
      weight *= 2.0 * t; // d xi = 4 t dt, and dt is half of dr
    }
    p.N = side.shape.N(r);
    p.dN = side.shape.dN(r);
    p.tangent = base::Vec2(R * p.dN).normalized();
    p.normal = {p.tangent.y(), -p.tangent.x()};
    const base::Vec2 at = R * p.N;
    p.place = polar_on_face({{0.0, 0.0}, set.tip.e1, set.tip.e2}, at, p.normal);
    const base::Vec2 x = set.tip.x + at;
    p.weight = weight * set.relative_depth(x) * lambda / x.x();
    visit(p);
  }
}

// The same on all sides of some elements that are faces of the tip's crack.
void for_pressed_points(const TipSetting& set, const std::vector<base::ElementId>& elements,
                        const PressedVisit& visit) {
  if (!set.is_axisymmetric() || set.crack_faces == nullptr) {
    return;
  }
  const CrackFaceOrder left(set.crack_faces->left);
  const CrackFaceOrder right(set.crack_faces->right);
  for (const base::ElementId e : elements) {
    for (int s = 0; s < base::element_info(set.mesh.type[e.index()]).sides; ++s) {
      const PlaneSide side(set.mesh, {e, s});
      if (left.has_side(side.nodes) || right.has_side(side.nodes)) {
        for_points_of(set, e, side, visit);
      }
    }
  }
}

std::vector<base::ElementId> elements_of(const std::vector<ExtensionField>& fields) {
  std::vector<base::ElementId> all;
  for (const ExtensionField& field : fields) {
    all.insert(all.end(), field.elements.begin(), field.elements.end());
    all.insert(all.end(), field.inside.begin(), field.inside.end());
  }
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

} // namespace

void add_auxiliary_pressure(const TipSetting& set, const std::vector<ExtensionField>& fields,
                            const base::Vector& u, ConfigurationalForces& out) {
  for_pressed_points(set, elements_of(fields), [&](const PressedPoint& p) {
    double opens = 0.0; // n . du/dr
    for (std::size_t i = 0; i < p.nodes.size(); ++i) {
      const auto freedom = 2 * static_cast<Eigen::Index>(p.nodes[i].index());
      opens += p.dN[static_cast<Eigen::Index>(i)] * p.normal.dot(u.segment<2>(freedom));
    }
    for (std::size_t k = 1; k < auxiliary_field_count; ++k) {
      const double outwards = auxiliary_field_displacement(set, p.place, k).x();
      for (std::size_t i = 0; i < p.nodes.size(); ++i) {
        out[p.nodes[i]][k].head<2>() -=
            p.N[static_cast<Eigen::Index>(i)] * outwards * p.weight * opens * p.tangent;
      }
    }
  });
}

void add_auxiliary_pressure_row(const TipSetting& set, const ExtensionField& field,
                                std::size_t auxiliary, double factor, base::Vector& row) {
  const std::map<base::NodeId, double> q = field.extension_by_node();
  for_pressed_points(set, elements_of({field}), [&](const PressedPoint& p) {
    double moved = 0.0;
    for (std::size_t i = 0; i < p.nodes.size(); ++i) {
      const auto at = q.find(p.nodes[i]);
      moved += at == q.end() ? 0.0 : p.N[static_cast<Eigen::Index>(i)] * at->second;
    }
    const double amount = factor * moved * set.tip.e1.dot(p.tangent) * p.weight *
                          auxiliary_field_displacement(set, p.place, auxiliary).x();
    for (std::size_t i = 0; i < p.nodes.size(); ++i) {
      row.segment<2>(2 * static_cast<Eigen::Index>(p.nodes[i].index())) -=
          amount * p.dN[static_cast<Eigen::Index>(i)] * p.normal;
    }
  });
}

} // namespace spricka::crack
