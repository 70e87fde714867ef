// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/steps/held_modes.hpp"

#include "analysis/scene/scene_loads.hpp"
#include "analysis/scene/sliding_contacts.hpp"
#include "analysis/steps/let_go.hpp"
#include "analysis/steps/missing_contact.hpp"
#include "analysis/steps/rigid_motion.hpp"
#include "analysis/steps/step_factors.hpp"
#include "base/dense_solve.hpp"
#include "model/model.hpp"
#include "solve/friction_cones.hpp"
#include "solve/load_balance.hpp"
#include "solve/mode_split.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

/// The free rigid modes of all bodies side by side.
class AllModes {
public:
  AllModes(const Discretisation& scene, const std::vector<SubstructuredBody>& bodies)
      : scene_(scene), bodies_(bodies) {
    body_of_.assign(scene.cracked.mesh.node_count(), -1);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      for (const base::NodeId n : bodies[b].body.nodes) {
        body_of_[n.index()] = static_cast<std::int32_t>(b);
      }
      first_.push_back(first_.back() + bodies[b].free_rigid_modes.cols());
    }
    find_openings();
  }

  [[nodiscard]] Eigen::Index count() const { return first_.back(); }
  [[nodiscard]] Eigen::Index first(std::size_t body) const { return first_[body]; }
  [[nodiscard]] std::size_t body_of(Eigen::Index mode) const {
    return static_cast<std::size_t>(std::upper_bound(first_.begin(), first_.end(), mode) -
                                    first_.begin() - 1);
  }

  /// What a unit of each mode opens of some rows [row, mode].
  [[nodiscard]] base::Matrix openings(const std::vector<std::size_t>& rows) const {
    base::Matrix B(static_cast<Eigen::Index>(rows.size()), count());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      B.row(static_cast<Eigen::Index>(i)) = B_.row(static_cast<Eigen::Index>(rows[i]));
    }
    return B;
  }

  /// The largest of what a mode would open of these rows if it moved their nodes along their
  /// forces.
  [[nodiscard]] double opening_scale(const std::vector<std::size_t>& rows) const {
    double motion = 0.0;
    for (const SubstructuredBody& body : bodies_) {
      motion = body.free_rigid_modes.size() > 0
                   ? std::max(motion, body.free_rigid_modes.cwiseAbs().maxCoeff())
                   : motion;
    }
    double scale = 0.0;
    for (const std::size_t r : rows) {
      double size = 0.0;
      for (const contact::RowEntry& entry : scene_.contact_row(r).entries) {
        size += entry.weight.lpNorm<1>();
      }
      scale = std::max(scale, motion * size);
    }
    return scale;
  }

  /// Generalised loads [mode] of a nodal load.
  [[nodiscard]] base::Vector loads(const base::Vector& nodal) const {
    base::Vector h(count());
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      h.segment(first_[b], bodies_[b].free_rigid_modes.cols()) =
          bodies_[b].free_rigid_modes.transpose() * nodal;
    }
    return h;
  }

private:
  [[nodiscard]] std::optional<contact::RigidModesAtNode> at(base::NodeId node) const {
    const std::int32_t b = body_of_[node.index()];
    if (b < 0) {
      return std::nullopt;
    }
    const int dim = scene_.cracked.mesh.dim;
    return contact::RigidModesAtNode{
        static_cast<std::size_t>(b),
        bodies_[static_cast<std::size_t>(b)].free_rigid_modes.middleRows(
            static_cast<Eigen::Index>(node.index()) * dim, dim)};
  }

  void find_openings() {
    const int dim = scene_.cracked.mesh.dim;
    B_ = base::Matrix::Zero(static_cast<Eigen::Index>(scene_.table.size()), count());
    for (std::size_t r = 0; r < scene_.table.size(); ++r) {
      for (const contact::RowEntry& entry : scene_.contact_row(r).entries) {
        if (const auto own = at(entry.node)) {
          B_.block(static_cast<Eigen::Index>(r), first_[own->body], 1, own->motion.cols()) +=
              entry.weight.head(dim).transpose() * own->motion;
        }
      }
    }
    contact::remove_self_sliding_openings(
        pressing_contact_surfaces(scene_), first_, [&](base::NodeId node) { return at(node); }, B_);
  }

  const Discretisation& scene_;
  const std::vector<SubstructuredBody>& bodies_;
  std::vector<std::int32_t> body_of_;
  std::vector<Eigen::Index> first_{0};
  base::Matrix B_; ///< [row, mode] of all rows
};

std::vector<std::size_t> all_rows(const Discretisation& scene) {
  std::vector<std::size_t> rows;
  for (std::size_t r = 0; r < scene.table.size(); ++r) {
    rows.push_back(r);
  }
  return rows;
}

// A basis of the columns' span in reduced echelon form: X, Y and the rotation apart where they can
// be told apart.
base::Matrix reduced(base::Matrix A) {
  constexpr double none = 1e-7;
  base::Matrix basis(A.rows(), 0);
  for (Eigen::Index row = 0; row < A.rows() && A.cols() > 0; ++row) {
    Eigen::Index best = 0;
    if (!(A.row(row).cwiseAbs().maxCoeff(&best) > none)) {
      continue;
    }
    const base::Vector pivot = A.col(best) / A(row, best);
    for (Eigen::Index c = 0; c < A.cols(); ++c) {
      if (c != best) {
        A.col(c) -= A(row, c) * pivot;
      }
    }
    for (Eigen::Index c = 0; c < basis.cols(); ++c) {
      basis.col(c) -= basis(row, c) * pivot;
    }
    basis.conservativeResize(Eigen::NoChange, basis.cols() + 1);
    basis.rightCols(1) = pivot;
    A.col(best).setZero();
  }
  return basis;
}

// The motions of one body among some directions [mode, k] of all.
std::vector<std::string> motions(const model::Model& model, const model::Mesh& mesh,
                                 const SubstructuredBody& body, const base::Matrix& part) {
  std::vector<std::string> names;
  if (part.size() == 0) {
    return names;
  }
  const base::SingularVectors svd = base::left_singular_vectors(part);
  // `part` is a piece of an orthonormal basis: what is below this is no motion of the body.
  const Eigen::Index rank = (svd.values.array() > 1e-9).count();
  const base::Matrix rigid = fe::rigid_modes(model, mesh, body.pieces);
  const base::Matrix mix = rigid.transpose() * (body.free_rigid_modes *
                                                svd.vectors.leftCols(rank)); // [rigid mode, rank]
  // Named by rigid motions of the pieces: the free modes are any combination of those.
  const base::Matrix basis = reduced(mix);
  for (Eigen::Index k = 0; k < basis.cols(); ++k) {
    names.push_back(describe_rigid_motion(mesh, body.body, rigid * basis.col(k)));
  }
  return names;
}

} // namespace

std::vector<results::BodyRestraintPreview>
rigid_mode_support(const model::Model& model, const Discretisation& scene,
                   const std::vector<SubstructuredBody>& bodies) {
  const model::Mesh& mesh = scene.cracked.mesh;
  const AllModes modes(scene, bodies);
  const solve::ModeSplit split = solve::split_controllable_modes(
      modes.openings(all_rows(scene)), modes.opening_scale(all_rows(scene)));
  std::vector<results::BodyRestraintPreview> found;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const SubstructuredBody& body = bodies[b];
    results::BodyRestraintPreview preview;
    preview.name = body.name;
    preview.nodes = body.body.nodes.size();
    preview.elements = body.body.elements.size();
    preview.modes = static_cast<int>(fe::rigid_modes(model, mesh, body.pieces).cols());
    const auto free = static_cast<int>(body.free_rigid_modes.cols());
    preview.by_supports = preview.modes - free;
    preview.by_nothing =
        motions(model, mesh, body,
                split.uncontrollable.middleRows(modes.first(b), body.free_rigid_modes.cols()));
    preview.by_contact = free - static_cast<int>(preview.by_nothing.size());
    found.push_back(std::move(preview));
  }
  return found;
}

std::vector<base::OperationFailure>
unsupported_loads(const model::Model& model, const Discretisation& scene,
                  const std::vector<SubstructuredBody>& bodies) {
  const AllModes modes(scene, bodies);
  const base::Matrix pull = reduced_case_loads(model, scene);
  std::vector<base::OperationFailure> unheld;
  StepActionFactors factors =
      initial_step_factors(model, scene.case_load.cols(), scene.contacts.size());
  for (const model::Step& step : model.steps) {
    apply_step_actions(step, factors);
    std::vector<std::size_t> rows;
    std::vector<bool> equality;
    std::vector<solve::FrictionRow> friction;
    for (std::size_t c = 0; c < scene.contacts.size(); ++c) {
      for (std::size_t r = scene.table.first[c]; factors.mounted[c] && r < scene.table.first[c + 1];
           ++r) {
        rows.push_back(r);
        equality.push_back(scene.contacts[c].type == model::ContactType::bonded);
        if (scene.contact_row(r).tangential && !equality.back()) {
          const int at = static_cast<int>(rows.size()) - 1;
          const int normal =
              at - static_cast<int>(r - scene.table.first[c]) + scene.contact_row(r).normal;
          // A second tangent of a normal row follows the first: the two are a vector.
          if (!friction.empty() && friction.back().normal == normal) {
            friction.back().second = at;
          } else {
            friction.push_back({normal, at, scene.contacts[c].mu, -1});
          }
        }
      }
    }
    const base::Matrix B = modes.openings(rows);
    const base::Vector h = modes.loads(pull * factors.case_factor);
    if (h.size() == 0) {
      continue;
    }
    // Supports that move load bodies too, though no force of a case does: that is in h only.
    // So do the forces that move them: round-off of these is no load.
    const double scale =
        std::max({(scene.case_load * factors.case_factor).lpNorm<1>(),
                  (pull * factors.case_factor).lpNorm<1>(), h.cwiseAbs().maxCoeff()});
    const solve::ModeSplit split = solve::split_controllable_modes(B, modes.opening_scale(rows));
    // Motions that no row feels come first: the balance is that of the others (solve.16).
    base::Vector motion = solve::uncontrollable_motion(split, h, solve::resting_load * scale);
    if (motion.size() == 0) {
      // Stiffness plays no part in whether rows can take the loads.
      const base::Matrix none;
      const solve::ControllableProblem plain{.W = none,
                                             .B = B * split.controllable,
                                             .b = base::Vector::Zero(B.rows()),
                                             .h = split.controllable.transpose() * h,
                                             .equality = equality,
                                             .d = {}};
      const solve::LoadBalance balance = solve::balance_loads(
          solve::cone_edge_balance_problem(plain.B, plain.h, equality, friction));
      motion = solve::unstopped_opening_motion(split, balance,
                                               solve::rest_load * std::max(scale, h.norm()));
      if (motion.size() > 0 && !friction.empty()) {
        motion = solve::sliding_motion(split, plain, friction, balance);
      }
    }
    if (motion.size() > 0) {
      Eigen::Index most = 0;
      motion.cwiseAbs().maxCoeff(&most);
      const std::size_t b = modes.body_of(most);
      const base::Vector own = bodies[b].free_rigid_modes *
                               motion.segment(modes.first(b), bodies[b].free_rigid_modes.cols());
      std::string why =
          fmt::format("step {}: body {} is loaded but not held: {}{}", step.name, bodies[b].name,
                      describe_rigid_motion(scene.cracked.mesh, bodies[b].body, own),
                      explain_unjoined_neighbour(model, scene, bodies, b));
      why += explain_release(model, scene, bodies, step, why);
      unheld.push_back({.why = std::move(why), .span = step.span});
    }
  }
  return unheld;
}

} // namespace spricka::analysis
