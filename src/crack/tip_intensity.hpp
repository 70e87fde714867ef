// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/front_forces.hpp"
#include "crack/stress_intensity.hpp"
#include "crack/supplementary_functions.hpp"
#include "model/cracks.hpp"
#include "shape/shape.hpp"

#include <array>
#include <optional>
#include <vector>

/// What front_intensity and front_intensity_functionals do with a tip in the plane, and its K as a
/// functional of other functions.
namespace spricka::crack {

/// What is asked of a front: K by domains, and on request what else.
struct FrontIntensityOptions {
  std::optional<double> shift; ///< of a tip, finite shift in tip element sizes; empty: analytic
  model::CrackTipPlaneState state = model::CrackTipPlaneState::automatic; ///< of a tip
  bool opening = false; ///< K from the opening of the crack's faces as well
};

/// K1, K2, G and T of a tip with one domain at least from nodal displacements u [2 * node]:
///   G   = sum_n q_n e1 . P_n(u, u),   P_n(u, v) = integral (s(u) : grad v - W(u, v) I) grad N_n +
///   .., K_m = E'/2 sum_n q_n e1 . P_n(u, v_m),  v_m the near-tip field with K_m = 1, T   = E'
///   sum_n q_n e1 . P_n(u, v_3) - ..,  v_3 the field of a unit force at the tip,
/// the analytic derivative -1/2 u^T (dK/da) u + u^T (df/da) of the discrete energy when nodes move
/// with q (Parks 1974; deLorenzi 1982; interaction form: Yau, Wang, Corten 1980; T: Kfouri 1986),
/// with the terms of `loads`: forces per volume, tractions on the crack faces, temperature (manual,
/// crack.18 to crack.26). Per unit thickness; doubled on a symmetry line. With a finite shift the
/// magnitude of K comes from the differenced energy (Hellen 1975; Parks 1974), the ratio K2/K1 from
/// the interaction form.
StressIntensity tip_intensity(const model::Model& model, const mesh::CrackedMesh& cracked,
                              const mesh::CrackFront& front,
                              const std::vector<VirtualExtensionField>& fields,
                              const FrontIntensityOptions& request, const base::Vector& u,
                              const FrontLoads& loads);

/// K1 and K2 of a tip with one domain at least as functions of u; zero between two materials.
/// [2 * node, 2]
SparseLinearFunctionals tip_intensity_functionals(const model::Model& model,
                                                  const mesh::CrackedMesh& cracked,
                                                  const mesh::CrackFront& front,
                                                  const std::vector<VirtualExtensionField>& fields,
                                                  model::CrackTipPlaneState state);

/// The same functional of any displacement gradient, also of functions that are not the mesh's: K_m
/// is the sum over the points of M_m : grad u (row i: gradient of u_i), about an axis with hoop_m
/// u_x / x.
struct KFunctionalQuadraturePoint {
  base::ElementId element;
  shape::Point<2> r = shape::Point<2>::Zero(); ///< in the element's reference coordinates
  std::array<Eigen::Matrix2d, 2> M;            ///< by mode, integration weight included
  std::array<double, 2> hoop{};                ///< the same
};
/// The functional of K at the integration points of all domains. Empty without a domain and where
/// the tip lies between two materials; on a symmetric half that of K2 is zero.
std::vector<KFunctionalQuadraturePoint> K_functional_at_quadrature_points(
    const model::Model& model, const mesh::CrackedMesh& cracked, const mesh::CrackFront& front,
    const std::vector<VirtualExtensionField>& fields, model::CrackTipPlaneState state);
/// The same for forces between the faces: rows^T f is what FrontLoads::crack_faces add to K1
/// and K2. [dim * node, 2]
base::Matrix face_force_tip_functionals(const model::Model& model, const mesh::CrackedMesh& cracked,
                                        const mesh::CrackFront& front,
                                        const std::vector<VirtualExtensionField>& fields,
                                        model::CrackTipPlaneState state,
                                        const std::vector<model::Face>& faces);

} // namespace spricka::crack
