// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/partner.hpp"

#include <map>
#include <vector>

/// K and T as functionals of any displacement.
namespace spricka::crack {

/// What a displacement is contracted with at a point: its gradient, and about an axis the strain
/// round it.
struct Contracted {
  Eigen::Matrix2d M;
  double hoop = 0.0;
};

// Of one partner at the points of an element:
// s(u) : A + (H e1) . (s(v) grad q) with A = (H_v e1) (x) grad q - (div q) H_v is e1 . T grad q of
// the interaction; D is symmetric, so s(u) : A = H_u : s(A). About an axis all have components
// round it (crack.37), and partners have a divergence (crack.38). Calls visit(r, map, contracted),
// the weight of the point in it.
template <shape::ElementShape S, class Visit>
void for_element_points(const TipSetting& set, base::ElementId e,
                        const std::map<base::NodeId, double>& q, std::size_t partner,
                        Visit&& visit) {
  const fe::NodeVectors<S> X = fe::coordinates<S>(set.mesh, e);
  const Stiffness k(set, e);
  const Eigen::Matrix<double, S::nodes, 1> moved = extension_at<S>(set.mesh, e, q);
  const base::Vec2& e1 = set.tip.e1;
  for_domain_points<S>(set, e, [&](const shape::Point<2>& r, double weight) {
    const fe::Jacobian<S> at = fe::jacobian<S>(X, r);
    const Eigen::Matrix<double, S::nodes, 1> N = S::N(r);
    const base::Vec2 x = X * N;
    const double w = weight * at.det * set.depth(x);
    const base::Vec2 grad = at.dNdx.transpose() * moved;
    const double here = N.dot(moved);
    const double round = set.axial() ? here * e1.x() / x.x() : 0.0; // of q, round the axis
    const double div = e1.dot(grad) + round;
    const Partner v = partner_at(set, k, x, partner);
    const SectionState A =
        stressed(k, v.H * e1 * grad.transpose() - div * v.H, (round - div) * v.hoop);
    const Eigen::Matrix2d M = A.sigma + (v.sigma * grad + here * v.divergence) * e1.transpose();
    visit(r, at, Contracted{w * M, w * (A.sigma_hoop + v.sigma_hoop * round)});
  });
}

// The same for all elements of all domains, averaged over these: visit(e, r, map, contracted).
template <class Visit>
void for_contractions(const TipSetting& set, const std::vector<ExtensionField>& fields,
                      std::size_t partner, Visit&& visit) {
  const double part = 1.0 / static_cast<double>(fields.size());
  for (const ExtensionField& field : fields) {
    const std::map<base::NodeId, double> q = field.q();
    std::vector<base::ElementId> elements = field.elements;
    if (set.axial()) {
      elements.insert(elements.end(), field.inside.begin(), field.inside.end());
    }
    fe::for_plane_blocks(
        set.mesh, elements, [&]<shape::ElementShape S>(S, std::span<const base::ElementId> block) {
          for (const base::ElementId e : block) {
            for_element_points<S>(
                set, e, q, partner,
                [&](const shape::Point<2>& r, const fe::Jacobian<S>& at, const Contracted& c) {
                  visit(e, r, at, Contracted{part * c.M, part * c.hoop});
                });
          }
        });
  }
}

} // namespace spricka::crack
