// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/Core>

namespace spricka::contact {

/// Weights of three hats in the functions dual to them, D m^-1 of (contact_space.4), for the
/// integrals m of hat times hat: row a has those of the function dual to hat a. On a sliver the
/// hats are nearly one function: what they have no measure of is left out.
Eigen::Matrix3d dual_hat_weights(const Eigen::Matrix3d& moment);

} // namespace spricka::contact
