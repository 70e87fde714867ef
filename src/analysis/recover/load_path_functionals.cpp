// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/load_path_functionals.hpp"

#include <algorithm>
#include <utility>

namespace spricka::analysis {

namespace {

// Functionals that are condensed at a time.
constexpr Eigen::Index most_columns = 64;

} // namespace

const ContactAndRigidModeFunctionals&
LoadPathFunctionals::contact_functionals(const StepSolver& solver) {
  if (!of_contact_) {
    of_contact_ = condense_functionals(solver);
  }
  return *of_contact_;
}

ContactAndRigidModeFunctionals LoadPathFunctionals::condense_functionals(const StepSolver& solver) {
  const Eigen::Index all = count();
  ContactAndRigidModeFunctionals out;
  if (solver.contact_system() == nullptr || all == 0) {
    return out;
  }
  const crack::SparseLinearFunctionals& K = K_.of_displacements();
  const contact::ContactSystem& system = *solver.contact_system();
  Eigen::Index modes = 0;
  for (const std::size_t b : solver.condensed_body_indices()) {
    modes += bodies_[b].condensed->rigid_modes().cols();
  }
  const auto rows = static_cast<Eigen::Index>(scene_.table.size());
  out.of_row.resize(all, rows);
  out.of_mode.resize(all, modes);
  for (Eigen::Index first = 0; first < all;) {
    const bool of_K = first < K_count();
    const Eigen::Index columns = std::min(most_columns, (of_K ? K_count() : all) - first);
    base::Matrix nodal = of_K ? base::Matrix(K.middleCols(first, columns))
                              : openings_.opening_functionals(first - K_count(), columns);
    // A functional is condensed as a load is (solve.32).
    scene_.ties->transfer_forces_to_masters(nodal);
    std::vector<base::Matrix> external;
    std::vector<base::Matrix> moved;
    for (const std::size_t b : solver.condensed_body_indices()) {
      external.push_back(condense_load(bodies_[b], *scene_.ties, nodal).external);
      // K feels the bodies with a front alone.
      moved.push_back(external.back().isZero(0.0)
                          ? external.back()
                          : bodies_[b].condensed->displacements_under_forces(external.back()));
    }
    for (Eigen::Index k = 0; k < nodal.cols(); ++k) {
      std::vector<base::Vector> u;
      for (std::size_t i = 0; i < moved.size(); ++i) {
        u.emplace_back(moved[i].col(k));
        const base::Matrix& Q =
            bodies_[solver.condensed_body_indices()[i]].condensed->rigid_modes();
        out.of_mode.row(first + k).segment(system.first_mode(i), Q.cols()) =
            external[i].col(k).transpose() * Q;
      }
      for (Eigen::Index r = 0; r < rows; ++r) {
        out.of_row(first + k, r) = system.row_opening(static_cast<std::size_t>(r), u);
      }
    }
    first += nodal.cols();
  }
  // Between faces in contact a unit of a row changes K without moving anything, too (crack.33).
  out.of_row.topRows(K_count()) += K_.of_contact_forces();
  return out;
}

base::Vector LoadPathFunctionals::evaluate_without_contact(const base::Vector& case_factor,
                                                           const StepSolver& solver) {
  base::Vector u = scene_.case_displacement * case_factor;
  for (const SubstructuredBody& body : bodies_) {
    base::Vector external;
    if (body.condensed) {
      // Known for unit cases where it takes a solution of its own.
      external = body.case_motion.size() > 0
                     ? base::Vector(body.case_motion * case_factor)
                     : base::Vector(body.condensed->displacements_under_forces(body.external_load *
                                                                               case_factor));
    }
    recover_body_displacements(body, external, case_factor, u);
  }
  base::Vector values(count());
  // With contact the functionals are needed all the same; their product costs next to nothing.
  values.head(K_count()) = solver.contact_system() == nullptr
                               ? evaluate_K_values(model_, scene_, u, case_factor)
                               : base::Vector(K_.of_displacements().transpose() * u +
                                              K_added_by_loads(model_, scene_, case_factor));
  values.tail(openings_.count()) = openings_.evaluate_openings(u);
  return values;
}

base::Vector
LoadPathFunctionals::evaluate_increment(const contact::ContactSystem::IncrementProblem& problem,
                                        const contact::ContactSystem::IncrementSolution& solution,
                                        const StepSolver& solver) {
  if (of_case_.cols() == 0) {
    of_case_.resize(count(), scene_.case_load.cols());
    for (Eigen::Index c = 0; c < of_case_.cols(); ++c) {
      // Bodies alone are linear in the factors: unit cases now, a product in each increment.
      of_case_.col(c) = evaluate_without_contact(base::Vector::Unit(of_case_.cols(), c), solver);
    }
  }
  const ContactAndRigidModeFunctionals& by = contact_functionals(solver);
  base::Vector value = of_case_ * solver.factors().case_factor;
  value += by.of_mode * solution.contact.alpha;
  for (std::size_t i = 0; i < problem.rows.size(); ++i) {
    value += by.of_row.col(static_cast<Eigen::Index>(problem.rows[i])) *
             solution.contact.lambda[static_cast<Eigen::Index>(i)];
  }
  return value;
}

} // namespace spricka::analysis
