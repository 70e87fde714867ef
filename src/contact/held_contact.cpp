// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/held_contact.hpp"

#include <utility>

namespace spricka::contact {

FreeResponse free_response(const ContactSystem& system, const std::vector<base::Matrix>& load) {
  const std::vector<const CondensedBody*>& bodies = system.bodies();
  FreeResponse out;
  out.on_mode.resize(system.B().cols(), load.empty() ? 0 : load.front().cols());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    out.u.push_back(bodies[b]->displacement(load[b]));
    const base::Matrix& Q = bodies[b]->modes();
    out.on_mode.middleRows(system.first_mode(b), Q.cols()) = Q.transpose() * load[b];
  }
  out.opening = system.openings(out.u);
  return out;
}

HeldContact::HeldContact(const ContactSystem& system, std::vector<std::size_t> rows)
    : system_(system), rows_(std::move(rows)), held_(system.compliance(rows_)) {}

HeldContact::Response HeldContact::respond(const base::Matrix& gap,
                                           const base::Matrix& on_mode) const {
  base::Matrix before(static_cast<Eigen::Index>(rows_.size()), gap.cols());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    before.row(static_cast<Eigen::Index>(i)) = gap.row(static_cast<Eigen::Index>(rows_[i]));
  }
  solve::HeldRows::Response found = held_.respond(before, on_mode);
  Response out;
  out.left_over = found.left_over;
  out.mode = std::move(found.alpha);
  out.force = base::Matrix::Zero(gap.rows(), gap.cols());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    out.force.row(static_cast<Eigen::Index>(rows_[i])) =
        found.lambda.row(static_cast<Eigen::Index>(i));
  }
  out.gap = gap + system_.W() * out.force + system_.B() * out.mode;
  return out;
}

std::vector<base::Matrix> HeldContact::displacement(const std::vector<base::Matrix>& load,
                                                    const Response& response) const {
  std::vector<base::Matrix> force = load;
  for (const std::size_t row : rows_) {
    system_.add_force(row, response.force.row(static_cast<Eigen::Index>(row)), force);
  }
  std::vector<base::Matrix> u;
  for (std::size_t b = 0; b < force.size(); ++b) {
    const base::Matrix& Q = system_.bodies()[b]->modes();
    u.push_back(system_.bodies()[b]->displacement(force[b]) +
                Q * response.mode.middleRows(system_.first_mode(b), Q.cols()));
  }
  return u;
}

} // namespace spricka::contact
