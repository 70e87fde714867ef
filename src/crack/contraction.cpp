// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/contraction.hpp"

namespace spricka::crack {

namespace {

// Of one auxiliary field at the points of an element:
// s(u) : A + (H e1) . (s(v) grad q) with A = (H_v e1) (x) grad q - (div q) H_v is e1 . T grad q of
// the interaction; D is symmetric, so s(u) : A = H_u : s(A). About an axis all have components
// round it (crack.37), and auxiliary fields have a divergence (crack.38). The weight of a point
// goes in, as does `part`.
void for_element_points(const TipSetting& set, base::ElementId e,
                        const std::map<base::NodeId, double>& q, std::size_t auxiliary, double part,
                        const ContractionVisit& visit) {
  const PlaneElement& element = plane_element(set.mesh, e);
  const PlaneVectors X = fe::coordinates(element, set.mesh, e);
  const SectionElasticity k(set, e);
  const PlaneValues moved = extension_at(set.mesh, e, q);
  const base::Vec2& e1 = set.tip.e1;
  for_domain_points(set, e, [&](const shape::Point<2>& r, double weight) {
    const fe::Jacobian<PlaneElement> at = fe::jacobian(element, X, r);
    const PlaneValues N = element.N(r);
    const base::Vec2 x = X * N;
    const double w = weight * at.det * set.relative_depth(x);
    const base::Vec2 grad = at.dNdx.transpose() * moved;
    const double here = N.dot(moved);
    const double round =
        set.is_axisymmetric() ? here * e1.x() / x.x() : 0.0; // of q, round the axis
    const double div = e1.dot(grad) + round;
    const AuxiliaryField v = auxiliary_field_at(set, k, x, auxiliary);
    const SectionState A =
        state_from_gradient(k, v.H * e1 * grad.transpose() - div * v.H, (round - div) * v.hoop);
    const Eigen::Matrix2d M = A.sigma + (v.sigma * grad + here * v.divergence) * e1.transpose();
    const double hoop = A.sigma_hoop + v.sigma_hoop * round;
    visit(e, r, at, {part * (w * M), part * (w * hoop)});
  });
}

} // namespace

void for_contractions(const TipSetting& set, const std::vector<ExtensionField>& fields,
                      std::size_t auxiliary, const ContractionVisit& visit) {
  const double part = 1.0 / static_cast<double>(fields.size());
  for (const ExtensionField& field : fields) {
    const std::map<base::NodeId, double> q = field.extension_by_node();
    std::vector<base::ElementId> elements = field.elements;
    if (set.is_axisymmetric()) {
      elements.insert(elements.end(), field.inside.begin(), field.inside.end());
    }
    for (const base::ElementId e : elements) {
      for_element_points(set, e, q, auxiliary, part, visit);
    }
  }
}

} // namespace spricka::crack
