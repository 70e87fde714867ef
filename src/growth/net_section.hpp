// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "base/vec.hpp"
#include "model/forward.hpp"

namespace spricka::growth {

/// The material straight ahead of a tip, up to the next edge.
struct NetSectionLigament {
  base::NodeId tip;
  base::Vec3 from = base::Vec3::Zero();      ///< the tip
  base::Vec3 direction = base::Vec3::Zero(); ///< unit
  double length = 0.0;
};

/// Force N and bending moment M that a ligament carries, over its plastic limit: the p with
/// (N/p / N_p)^2 + |M/p| / M_p = 1, N_p = s t c and M_p = s t c^2 / 4 of a rectangle (manual,
/// growth.6); at 1 all of it yields at the flow stress s. From the internal forces of the elements
/// on one side of it at displacements u [dim * node]; shear does not count.
double plastic_load_ratio(const model::Model& model, const model::Mesh& mesh,
                          const NetSectionLigament& ligament, const base::Vector& u,
                          double flow_stress);

} // namespace spricka::growth
