// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/adjoint/tip_advance.hpp"

#include "analysis/scene/front_functionals.hpp"
#include "analysis/scene/front_name.hpp"
#include "analysis/scene/scene_heat.hpp"
#include "fe/assemble.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace spricka::analysis {

namespace {

// Whether a case acts on an element or a node that moves.
bool acts_on(const model::Mesh& mesh, const model::LoadCase& load_case,
             const std::vector<bool>& moves) {
  const auto node = [&](base::NodeId n) { return moves[n.index()]; };
  const auto element = [&](base::ElementId e) {
    return std::ranges::any_of(mesh.element_nodes(e), node);
  };
  const auto face = [&](const model::Face& f) { return element(f.element); };
  return std::ranges::any_of(load_case.loads, [&](const model::Load& load) {
    if (load.nodes.valid()) {
      return std::ranges::any_of(mesh.set_with_id(load.nodes).nodes, node);
    }
    return load.elements.valid()
               ? std::ranges::any_of(mesh.set_with_id(load.elements).elements, element)
               : std::ranges::any_of(mesh.set_with_id(load.faces).faces, face);
  });
}

} // namespace

VirtualTipExtension::VirtualTipExtension(const model::Model& model, const Discretisation& scene,
                                         std::size_t tip)
    : model_(model), scene_(scene), name_(front_name(model, scene, scene.cracked.fronts[tip])),
      a_(scene.cracked.fronts[tip].a),
      // one ring beyond the tip's domains moves all of them as one; where it does not fit, the
      // largest domain moves itself
      motion_(estimate::make_tip_mesh_motion(
          scene.cracked, tip,
          scene.domains[tip].beyond.value_or(scene.domains[tip].points.front().back()))),
      strained_(motion_.field.elements) {
  if (model::is_axisymmetric(model)) {
    strained_.insert(strained_.end(), motion_.field.inside.begin(), motion_.field.inside.end());
    std::ranges::sort(strained_);
  }
  std::vector<bool> moves(scene.cracked.mesh.node_count(), false);
  for (const crack::NodeMotion& moved : motion_.field.motion) {
    moves[moved.node.index()] = true;
  }
  find_hindrances(moves);
  ahead_ = moved_by(1.0);
  behind_ = moved_by(-1.0);
  move_loads(moves);
  row_rate_.resize(scene.domains.size());
  for (std::size_t t = 0; t < scene.domains.size(); ++t) {
    // About an axis what moves as one comes to other radii.
    if (model::is_axisymmetric(model) ||
        !estimate::moves_domains_rigidly(scene.cracked.mesh, motion_,
                                         scene.domains[t].points.front())) {
      row_rate_[t] = base::Matrix(front_displacement_K_functionals(model, *ahead_, t) -
                                  front_displacement_K_functionals(model, *behind_, t)) /
                     (2.0 * motion_.step);
    }
  }
}

void VirtualTipExtension::find_hindrances(const std::vector<bool>& moves) {
  const int dim = scene_.cracked.mesh.dim;
  for (std::size_t r = 0; r < scene_.table.size(); ++r) {
    if (std::ranges::any_of(scene_.contact_row(r).entries,
                            [&](const contact::RowEntry& e) { return moves[e.node.index()]; })) {
      rows_.push_back(r);
    }
  }
  const auto tied = [&](std::int32_t freedom) {
    return moves[static_cast<std::size_t>(freedom / dim)];
  };
  for (const fe::ConstraintTransformation::DependentRow& row : scene_.ties->rows()) {
    tied_ =
        tied_ || tied(row.freedom) ||
        std::ranges::any_of(row.terms, [&](const fe::FreedomTerm& t) { return tied(t.freedom); });
  }
}

// Rows of contacts and ties are not moved along; open rows have no part in K.
std::string VirtualTipExtension::why_no_derivative(const std::vector<bool>& closed) const {
  if (tied_) {
    return "ties hold what moves with the tip";
  }
  if (std::ranges::any_of(rows_, [&](std::size_t r) { return closed[r]; })) {
    return "closed contacts lie on what moves with the tip";
  }
  if (discontinuous_) {
    return "the temperature jumps within elements that move with the tip";
  }
  if (singular_) {
    return "the loads are singular at the tip: where it moves out of their field K has no slope";
  }
  return {};
}

// Temperatures stay in space while the elements move through them.
std::unique_ptr<Discretisation> VirtualTipExtension::moved_by(double steps) const {
  auto side = std::make_unique<Discretisation>();
  side->cracked = estimate::move_tip_mesh(scene_.cracked, motion_, steps);
  side->domains = scene_.domains;
  side->case_temperature = scene_.case_temperature;
  for (std::size_t c = 0; c < model_.cases.size(); ++c) {
    side->case_heat.push_back(scene_case_temperature(model_, *side, model_.cases[c]));
    if (const base::Vector& T = side->case_heat.back()->temperature; T.size() > 0) {
      side->case_temperature.col(static_cast<Eigen::Index>(c)) = T;
    }
  }
  return side;
}

// Loads are fields in space: nodes that move through them take other parts of them.
base::Vector VirtualTipExtension::load_rate(const model::LoadCase& load_case, std::size_t c,
                                            const Discretisation& ahead,
                                            const Discretisation& behind, double distance) const {
  const auto of = [&](const Discretisation& side) -> base::Vector {
    return fe::consistent_load_vector(model_, side.cracked.mesh,
                                      without_temperature_loads(load_case)) +
           thermal_nodal_forces(model_, side.cracked.mesh, *side.case_heat[c]);
  };
  return (of(ahead) - of(behind)) / distance;
}

void VirtualTipExtension::move_loads(const std::vector<bool>& moves) {
  // A field that is smooth at the tip changes over a part of an element as over a thousandth of it.
  constexpr double far = 1e3; // steps
  constexpr double most_difference = 0.1;
  constexpr double nothing = 1e-10; // of the loads over a step: what moves as one changes by that
  const auto cases = static_cast<Eigen::Index>(model_.cases.size());
  base::Matrix rate = base::Matrix::Zero(scene_.case_load.rows(), cases);
  std::unique_ptr<Discretisation> far_ahead, far_behind;
  for (Eigen::Index c = 0; c < cases; ++c) {
    const auto number = static_cast<std::size_t>(c);
    const model::LoadCase& load_case = model_.cases[number];
    if (!acts_on(scene_.cracked.mesh, load_case, moves)) {
      continue;
    }
    rate.col(c) = load_rate(load_case, number, *ahead_, *behind_, 2.0 * motion_.step);
    if (far_ahead == nullptr) {
      far_ahead = moved_by(far);
      far_behind = moved_by(-far);
    }
    const base::Vector over_far =
        load_rate(load_case, number, *far_ahead, *far_behind, 2.0 * far * motion_.step);
    const double least = nothing * scene_.case_load.col(c).norm() / motion_.step;
    singular_ =
        singular_ || (over_far - rate.col(c)).norm() > most_difference * rate.col(c).norm() + least;
    const std::vector<bool>& discontinuous = scene_.case_heat[number]->discontinuous;
    for (std::size_t e = 0; e < discontinuous.size(); ++e) {
      discontinuous_ = discontinuous_ ||
                       (discontinuous[e] &&
                        std::ranges::any_of(scene_.cracked.mesh.element_nodes(base::ElementId(e)),
                                            [&](base::NodeId n) { return moves[n.index()]; }));
    }
  }
  if ((rate.array() != 0.0).any()) {
    load_rate_ = std::move(rate);
  }
}

base::Vector VirtualTipExtension::load_derivative(const base::Vector& u,
                                                  const base::Vector& case_factor) const {
  base::Vector ahead = base::Vector::Zero(u.size());
  base::Vector behind = ahead;
  fe::add_internal_force(model_, ahead_->cracked.mesh, strained_, u, ahead);
  fe::add_internal_force(model_, behind_->cracked.mesh, strained_, u, behind);
  // - dK_0/da u by central differences of the internal forces (sensitivity.9).
  base::Vector out = (behind - ahead) / (2.0 * motion_.step);
  if (load_rate_.size() > 0) {
    out += load_rate_ * case_factor.head(load_rate_.cols());
  }
  return out;
}

base::Vector VirtualTipExtension::explicit_derivative(const base::Vector& u,
                                                      const base::Vector& case_factor) const {
  const crack::KLayout layout = scene_.k_layout();
  base::Vector out = base::Vector::Zero(layout.count());
  for (std::size_t t = 0; t < row_rate_.size(); ++t) {
    if (row_rate_[t].size() > 0) {
      layout.segment_of_point(out, t) += row_rate_[t].transpose() * u;
    }
  }
  if (load_rate_.size() > 0) {
    const base::Matrix rate =
        (K_added_by_load_cases(model_, *ahead_) - K_added_by_load_cases(model_, *behind_)) /
        (2.0 * motion_.step);
    out += rate * case_factor.head(rate.cols());
  }
  return out;
}

ParameterPartialDerivatives
VirtualTipExtension::length_partial_derivatives(const StepState& state) const {
  ParameterPartialDerivatives out;
  out.is.cause = results::SensitivityParameter::length;
  out.is.name = name_;
  out.is.value = a_;
  out.load = load_derivative(state.u, state.case_factor);
  out.direct = explicit_derivative(state.u, state.case_factor);
  return out;
}

} // namespace spricka::analysis
