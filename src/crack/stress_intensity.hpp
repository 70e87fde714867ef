// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/crack_face_term.hpp"
#include "crack/extension.hpp"
#include "crack/tip_loads.hpp"
#include "crack/williams.hpp"
#include "mesh/cut/cracked.hpp"
#include "model/cracks.hpp"
#include "model/forward.hpp"
#include "model/mesh.hpp"
#include "shape/shape.hpp"

#include <array>
#include <optional>
#include <vector>

/// K and T of one tip from a converged displacement by virtual crack extension.
namespace spricka::crack {

/// The values of one domain.
struct DomainIntensity {
  int rings = 0;
  double K1 = 0.0, K2 = 0.0; ///< [stress * length^0.5]
  double K3 = 0.0;           ///< in space
  double G = 0.0; ///< from the displacement [force/length]; NaN: a temperature jumps in elements
  double T = 0.0; ///< [stress]
};

/// What a point of a front in space has beside the values of a tip.
struct FrontPointIntensity {
  bool at_surface = false; ///< the front leaves the body there: K is a number of the mesh
  double T_along = 0.0;    ///< stress along the front that K leaves [stress]
  /// K1, K2, K3 by a smooth curve through the values of all points (manual, crack_space.15).
  std::array<double, 3> smooth{};
  /// Of a point at the surface: K1, K2, K3 as those farther inside go on to it (crack_space.16).
  std::optional<std::array<double, 3>> from_inside;
  std::optional<double> opening_K3; ///< beside StressIntensity::opening
};

struct StressIntensity {
  double K1 = 0.0, K2 = 0.0, G = 0.0; ///< means over the domains
  double K3 = 0.0;                    ///< the same, in space
  double T = 0.0;           ///< stress along the crack at the tip that K leaves, its mean [stress]
  double G_from_K = 0.0;    ///< (K1^2 + K2^2) / E', in space with K3^2 / 2 mu
  double spread = 0.0;      ///< (max - min of K1) / hypot(K1, K2); in space see crack_space.14
  double E_effective = 0.0; ///< E' that belongs to the K printed
  /// The tip lies between two materials: its stresses oscillate, there is no K1, K2 (all 0), only
  /// G.
  bool two_materials = false;
  std::vector<DomainIntensity> domains;
  std::optional<double> shift_error;            ///< G by finite shift over analytic G, minus 1
  std::optional<std::array<double, 2>> opening; ///< K1, K2 by the opening of the crack faces
  std::optional<FrontPointIntensity> front;     ///< in space
};

/// G [energy/length^2] of stress intensity factors K1, K2, K3: K1^2 / E' + K2^2 / E' + K3^2 / 2 mu.
double energy_release_rate(double E_effective, double mu, const std::array<double, 3>& K);

/// From the domains of a point, one at least, its means, G of K and spread: the largest range of
/// the first `compared` modes over sqrt(E' G of K). Two materials and E' are known.
void summarise_domains(double mu, std::size_t compared, StressIntensity& result);

struct TipIntensityRequest {
  std::optional<double> shift; ///< finite shift in tip element sizes; empty: analytic
  model::TipConstraint state = model::TipConstraint::automatic;
  const CrackFaceForces* crack_faces =
      nullptr;          ///< between the faces of the tip's crack; null: there are none
  bool opening = false; ///< K from the opening of the crack faces as well
};

/// K1, K2, G and T from nodal displacements u [dim * node]:
///   G   = sum_n q_n e1 . P_n(u, u),   P_n(u, v) = integral (s(u) : grad v - W(u, v) I) grad N_n +
///   .., K_m = E'/2 sum_n q_n e1 . P_n(u, v_m),  v_m the near-tip field with K_m = 1, T   = E'
///   sum_n q_n e1 . P_n(u, v_3) - ..,  v_3 the field of a unit force at the tip,
/// the analytic derivative -1/2 u^T (dK/da) u + u^T (df/da) of the discrete energy when nodes move
/// with q (Parks 1974; deLorenzi 1982; interaction form: Yau, Wang, Corten 1980; T: Kfouri 1986),
/// with the terms of `loads`: forces per volume, tractions on the crack faces, temperature (manual,
/// crack.18 to crack.26). Per unit thickness; doubled on a symmetry line. With a finite shift the
/// magnitude of K comes from the differenced energy (Hellen 1975; Parks 1974), the ratio K2/K1 from
/// the interaction form.
StressIntensity stress_intensity(const model::Model& model, const mesh::CrackedMesh& cracked,
                                 const mesh::CrackFront& front,
                                 const std::vector<ExtensionField>& fields,
                                 const TipIntensityRequest& request, const base::Vector& u,
                                 const TipLoads& loads);

/// K1 and K2 as functions of u, rows^T u + what the loads add at u = 0: what stress_intensity finds
/// by the analytic derivative. The rows are their exact gradient. [dim * node, 2]
base::Matrix intensity_rows(const model::Model& model, const mesh::CrackedMesh& cracked,
                            const mesh::CrackFront& front,
                            const std::vector<ExtensionField>& fields, model::TipConstraint state);

/// The same functional of any displacement gradient, also of functions that are not the mesh's: K_m
/// is the sum over the points of M_m : grad u (row i: gradient of u_i), about an axis with hoop_m
/// u_x / x.
struct IntensityFunctionalPoint {
  base::ElementId element;
  shape::Point<2> r = shape::Point<2>::Zero(); ///< in the element's reference coordinates
  std::array<Eigen::Matrix2d, 2> M;            ///< by mode, integration weight included
  std::array<double, 2> hoop{};                ///< the same
};
/// The functional of K at the integration points of all domains. Empty without a domain and where
/// the tip lies between two materials; on a symmetric half that of K2 is zero.
std::vector<IntensityFunctionalPoint> intensity_points(const model::Model& model,
                                                       const mesh::CrackedMesh& cracked,
                                                       const mesh::CrackFront& front,
                                                       const std::vector<ExtensionField>& fields,
                                                       model::TipConstraint state);
/// The same for forces between the faces: rows^T f is what those of TipIntensityRequest add to K1
/// and K2. [dim * node, 2]
base::Matrix crack_face_intensity_rows(const model::Model& model, const mesh::CrackedMesh& cracked,
                                       const mesh::CrackFront& front,
                                       const std::vector<ExtensionField>& fields,
                                       model::TipConstraint state,
                                       const std::vector<model::Face>& faces);

} // namespace spricka::crack
