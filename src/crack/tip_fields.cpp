// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/tip_fields.hpp"

#include "fe/corner_rule.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace spricka::crack {

namespace {

// Order along the crack of the nodes of one face.
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

std::vector<base::ElementId>
all_of_domains(const std::vector<VirtualExtensionField>& fields,
               std::vector<base::ElementId> VirtualExtensionField::*member) {
  std::vector<base::ElementId> all;
  for (const VirtualExtensionField& f : fields) {
    all.insert(all.end(), (f.*member).begin(), (f.*member).end());
  }
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

} // namespace

GradientStressState<2> SectionElasticity::state_from_gradient(const Tensor<2>& H,
                                                              double hoop) const {
  GradientStressState<2> state{
      .H = H, .hoop = hoop, .sigma = stress_from_gradient<2>(D, H), .sigma_hoop = 0.0};
  if (law.axisymmetric) {
    const double pressed = law.lambda * hoop;
    state.sigma.diagonal().array() += pressed;
    state.sigma_hoop = law.lambda * H.trace() + pressed + 2.0 * law.mu * hoop;
  }
  return state;
}

void SectionElasticity::set_stress(GradientStressStates<2>& of) const {
  for (Eigen::Index k = 0; k < of.hoop.size(); ++k) {
    Tensor<2> H;
    H << of.H[0][0][k], of.H[1][0][k], of.H[0][1][k], of.H[1][1][k];
    const GradientStressState<2> state = state_from_gradient(H, of.hoop[k]);
    for (std::size_t j = 0; j < 2; ++j) {
      for (std::size_t i = 0; i < 2; ++i) {
        of.sigma[j][i][k] = state.sigma(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      }
    }
    of.sigma_hoop[k] = state.sigma_hoop;
  }
}

TipAuxiliaryFields::TipAuxiliaryFields(const TipContext& set,
                                       const std::vector<VirtualExtensionField>& fields)
    : set_(set), strained_(all_of_domains(fields, &VirtualExtensionField::elements)) {
  const std::vector<base::ElementId> inside =
      all_of_domains(fields, &VirtualExtensionField::inside);
  std::ranges::set_difference(inside, strained_, std::back_inserter(rigid_));
  if (!set.is_axisymmetric() || set.crack_faces == nullptr) {
    return;
  }
  const CrackFaceOrder left(set.crack_faces->left);
  const CrackFaceOrder right(set.crack_faces->right);
  for (const std::vector<base::ElementId>* elements : {&strained_, &rigid_}) {
    for (const base::ElementId e : *elements) {
      for (int s = 0; s < base::element_info(set.mesh.type[e.index()]).sides; ++s) {
        const model::Face face{e, s};
        const std::vector<base::NodeId> nodes = model::element_side(set.mesh, face).nodes;
        if (left.has_side(nodes) || right.has_side(nodes)) {
          sides_.push_back(
              {face, left.has_side(nodes) ? UpperOrLowerFace::upper : UpperOrLowerFace::lower});
        }
      }
    }
  }
}

std::vector<shape::QuadraturePoint<2>>
TipAuxiliaryFields::element_quadrature(base::ElementId e) const {
  const PlaneElement& element = plane_reference_element(set_.mesh, e);
  const std::array<base::NodeId, 1> tips{set_.tip_node};
  const int corner = set_.is_axisymmetric() ? fe::find_tip_corner(set_.mesh, e, tips) : -1;
  if (corner < 0) {
    const auto points = shape::quadrature<2>(element.domain, domain_degree);
    return {points.begin(), points.end()};
  }
  std::vector<shape::QuadraturePoint<2>> points;
  for (const fe::ReferenceChart& chart : fe::reference_charts(element, corner)) {
    fe::for_chart_points(chart, {0.0, 0.0, 1.0}, [&](const shape::Point<2>& r, double weight) {
      points.push_back({r, weight});
    });
  }
  return points;
}

shape::ShapeFunctionValues<2> TipAuxiliaryFields::shape_functions(base::ElementId e,
                                                                  std::size_t /*number*/,
                                                                  const base::Vec2& r) const {
  const PlaneElement& element = plane_reference_element(set_.mesh, e);
  return {element.N(r), element.dN(r)};
}

AuxiliaryFields<2> TipAuxiliaryFields::auxiliary_fields(base::ElementId /*e*/,
                                                        std::size_t /*number*/, const base::Vec2& x,
                                                        const SectionElasticity& k) const {
  AuxiliaryFields<2> all;
  for (std::size_t auxiliary = 1; auxiliary < auxiliary_field_count<2>; ++auxiliary) {
    all.set(auxiliary, auxiliary_field(x, auxiliary, k));
  }
  return all;
}

AuxiliaryField<2> TipAuxiliaryFields::auxiliary_field(const base::Vec2& x, std::size_t auxiliary,
                                                      const SectionElasticity& k) const {
  const PolarCoordinates at = polar_coordinates(set_.tip, x);
  const Tensor<2> H = auxiliary_field_gradient(set_, at, auxiliary);
  if (!set_.is_axisymmetric()) {
    return {k.state_from_gradient(H, 0.0), base::Vec2::Zero()};
  }
  const double hoop = auxiliary_field_displacement(set_, at, auxiliary).x() / x.x();
  // (crack.39): in the section alone it is at rest.
  const base::Vec2 divergence((k.law.lambda + 2.0 * k.law.mu) * (H(0, 0) - hoop),
                              k.law.lambda * H(0, 1) + k.law.mu * (H(0, 1) + H(1, 0)));
  return {k.state_from_gradient(H, hoop), divergence / x.x()};
}

// Towards the tip 1 + xi = 2 t^2.
std::vector<shape::QuadraturePoint<2>> tip_side_quadrature(const TipContext& set,
                                                           const geometry::ElementSide& side) {
  const double from = side.nodes[0] == set.tip_node   ? 1.0
                      : side.nodes[1] == set.tip_node ? -1.0
                                                      : 0.0;
  std::vector<shape::QuadraturePoint<2>> points;
  for (const auto& [r, weight] : shape::line_rule(domain_degree)) {
    const double t = 0.5 * (1.0 + r[0]);
    // d xi = 4 t dt, and dt is half of dr.
    points.push_back(from == 0.0 ? shape::QuadraturePoint<2>{{r[0], 0.0}, weight}
                                 : shape::QuadraturePoint<2>{{from * (2.0 * t * t - 1.0), 0.0},
                                                             2.0 * t * weight});
  }
  return points;
}

// Of points much nearer to the tip than sixteen digits of their coordinates tell, as a rule has
// them where a load jumps at the tip, the distance is right even so: nodes are seen from the tip.
std::optional<TipPlace> TipAuxiliaryFields::locate_on_side(const geometry::ElementSide& side,
                                                           const base::Vec2& r,
                                                           UpperOrLowerFace /*on*/) const {
  const Eigen::Matrix2Xd R = side.X.topRows<2>().colwise() - set_.tip.x;
  const base::Vec2 from = R * side.N(r);
  const base::Vec2 along = R * side.dN(r).col(0); // the body on the left
  if (!(from.squaredNorm() > 0.0 && along.squaredNorm() > 0.0)) {
    return std::nullopt;
  }
  const base::Vec2 tangent = along.normalized();
  const base::Vec2 normal(tangent.y(), -tangent.x());
  return TipPlace{polar_coordinates_on_face({{0.0, 0.0}, set_.tip.e1, set_.tip.e2}, from, normal),
                  set_.tip.x + from, tangent, side.element};
}

base::Vec2 TipAuxiliaryFields::auxiliary_traction(const Place& at, std::size_t auxiliary,
                                                  const base::Vec2& area) const {
  const double outwards = auxiliary_field_displacement(set_, at.polar, auxiliary).x();
  return elasticity(at.element).law.lambda * outwards / at.x.x() * area;
}

} // namespace spricka::crack
