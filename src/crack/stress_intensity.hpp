// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/extension.hpp"
#include "crack/lip_term.hpp"
#include "crack/williams.hpp"
#include "mesh/patch.hpp"
#include "model/model.hpp"

#include <functional>
#include <optional>
#include <vector>

/// K of one tip from a converged displacement by virtual crack extension.
namespace spricka::crack {

/// Body force density at a point of an element [force/length^3]; empty: none.
using BodyForce = std::function<base::Vec2(base::ElementId, const base::Vec2&)>;

/// The values of one domain.
struct DomainValue {
  int rings = 0;
  double K1 = 0.0, K2 = 0.0; ///< [stress * length^0.5]
  double G = 0.0;            ///< from the displacement itself [force/length]
};

struct StressIntensity {
  double K1 = 0.0, K2 = 0.0, G = 0.0; ///< means over the domains
  double G_from_K = 0.0;              ///< (K1^2 + K2^2) / E'
  double spread = 0.0;                ///< (max - min of K1) / hypot(K1, K2)
  double E_effective = 0.0;           ///< E' that belongs to the K printed
  std::vector<DomainValue> domains;
  std::optional<double> shift_error; ///< G by finite shift over analytic G, minus 1
};

struct VceRequest {
  std::optional<double> shift; ///< finite shift in tip element sizes; empty: analytic
  model::CrackState state = model::CrackState::automatic;
  const LipForces* lips = nullptr; ///< between the faces of the tip's crack; null: there are none
};

/// K1, K2 and G from nodal displacements u [dim * node]:
///   G  = sum_n q_n e1 . P_n(u, u),   P_n(u, v) = integral (s(u) : grad v - W(u, v) I) grad N_n,
///   K_m = E'/2 . 2 sum_n q_n e1 . P_n(u, v_m),  v_m the near-tip field with K_m = 1,
/// the analytic derivative -1/2 u^T (dK/da) u of the discrete energy when nodes move with q
/// (Parks 1974; deLorenzi 1982; interaction form: Yau, Wang, Corten 1980). Per unit thickness;
/// doubled on a symmetry line. With a finite shift the magnitude comes from the differenced
/// stiffness (Hellen 1975; Parks 1974), the ratio K2/K1 from the interaction form.
StressIntensity stress_intensity(const model::Model& model, const mesh::CrackedMesh& cracked,
                                 const mesh::Tip& tip, const std::vector<ExtensionField>& fields,
                                 const VceRequest& request, const base::Vector& u,
                                 const BodyForce& body_force);

/// K1 and K2 as linear functionals of u: rows^T u is what stress_intensity finds for u without body
/// forces by the analytic derivative. [dim * node, 2]
base::Matrix intensity_rows(const model::Model& model, const mesh::CrackedMesh& cracked,
                            const mesh::Tip& tip, const std::vector<ExtensionField>& fields,
                            model::CrackState state);

/// The same for forces between the faces: rows^T f is what those of VceRequest add to K1 and K2.
/// [dim * node, 2]
base::Matrix lip_intensity_rows(const model::Model& model, const mesh::CrackedMesh& cracked,
                                const mesh::Tip& tip, const std::vector<ExtensionField>& fields,
                                model::CrackState state, const std::vector<model::Face>& faces);

} // namespace spricka::crack
