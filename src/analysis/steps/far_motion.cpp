// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/steps/far_motion.hpp"

#include "analysis/steps/rigid_motion.hpp"
#include "analysis/steps/row_opening.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

constexpr double too_far = 10.0;
constexpr double no_motion = 1e-12; // of the body's size
// What a unit of motion opens at least of some closed row where a wedge or taper holds the body:
// the slope of a taper pin is 0.01.
constexpr double wedge = 3e-3;

/// The rigid motion of each body, and the largest of what makes bodies move soundly.
struct Motions {
  std::vector<base::Vector> rigid; ///< [condensed body][dim * node]
  double sound = 0.0;              ///< [length]
};

Motions motions_of(const Discretisation& scene, const std::vector<SubstructuredBody>& bodies,
                   const SolvedContactIncrement& solved, const base::Vector& prescribed) {
  Motions out;
  out.sound = prescribed.size() > 0 ? prescribed.cwiseAbs().maxCoeff() : 0.0;
  const solve::ContactSolution& s = solved.solution.contact;
  for (std::size_t i = 0; i < solved.condensed.size(); ++i) {
    const contact::CondensedBody& body = *bodies[solved.condensed[i]].condensed;
    const base::Vector moved = body.rigid_modes() * s.alpha.segment(solved.system.first_mode(i),
                                                                    body.rigid_modes().cols());
    base::Vector& rigid = out.rigid.emplace_back(base::Vector::Zero(
        static_cast<Eigen::Index>(scene.cracked.mesh.node_count()) * scene.cracked.mesh.dim));
    for (std::size_t k = 0; k < body.external_freedoms().size(); ++k) {
      const auto at = static_cast<Eigen::Index>(k);
      rigid[body.external_freedoms()[k]] = moved[at];
      out.sound = std::max(out.sound, std::abs(solved.solution.u[i][at] - moved[at]));
    }
  }
  for (std::size_t i = 0; i < solved.problem.rows.size(); ++i) {
    const contact::ConstraintRow& row = scene.contact_row(solved.problem.rows[i]);
    if (s.closed[i] && !row.tangential) {
      out.sound = std::max(out.sound,
                           std::abs(solved.problem.gap[static_cast<Eigen::Index>(i)]) / row.area);
    }
  }
  return out;
}

// Largest opening of a closed row, as a length.
double opened_by(const Discretisation& scene, const SolvedContactIncrement& solved,
                 const base::Vector& rigid) {
  double most = 0.0;
  for (std::size_t i = 0; i < solved.problem.rows.size(); ++i) {
    const std::size_t r = solved.problem.rows[i];
    if (solved.solution.contact.closed[i]) {
      const contact::ConstraintRow& row = scene.reduced_contact_row(r);
      most = std::max(most, std::abs(row_opening(row, scene.cracked.mesh.dim, rigid)) / row.area);
    }
  }
  return most;
}

double size_of(const model::Mesh& mesh, const fe::Body& body) {
  base::Vec3 low = mesh.x[body.nodes.front().index()];
  base::Vec3 high = low;
  for (const base::NodeId n : body.nodes) {
    low = low.cwiseMin(mesh.x[n.index()]);
    high = high.cwiseMax(mesh.x[n.index()]);
  }
  return (high - low).norm();
}

} // namespace

base::OptionalFailure find_excessive_rigid_motion(const Discretisation& scene,
                                                  const std::vector<SubstructuredBody>& bodies,
                                                  const SolvedContactIncrement& solved,
                                                  const base::Vector& prescribed) {
  const Motions motions = motions_of(scene, bodies, solved, prescribed);
  for (std::size_t i = 0; i < motions.rigid.size(); ++i) {
    const SubstructuredBody& body = bodies[solved.condensed[i]];
    const base::Vector& rigid = motions.rigid[i];
    const double far = rigid.size() > 0 ? rigid.cwiseAbs().maxCoeff() : 0.0;
    const double size = size_of(scene.cracked.mesh, body.body);
    if (far <= no_motion * size) {
      continue;
    }
    const bool slides =
        far > too_far * motions.sound && opened_by(scene, solved, rigid) < wedge * far;
    if (!slides && !(far > size + too_far * motions.sound)) {
      continue;
    }
    return base::OperationFailure{
        .kind = base::ProgramOutcome::not_solvable,
        .why = fmt::format(
            "body {} would move as a rigid body by {:.3g} ({}), {:.2g} times the gaps and the "
            "displacements by deformation ({:.3g}): next to nothing holds this motion",
            body.name, far, describe_rigid_motion(scene.cracked.mesh, body.body, rigid),
            far / motions.sound, motions.sound)};
  }
  return std::nullopt;
}

} // namespace spricka::analysis
