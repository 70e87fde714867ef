// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/held_contact.hpp"

#include <utility>

namespace spricka::contact {

HeldContact::HeldContact(const ContactSystem& system, std::vector<std::size_t> rows)
    : system_(system), rows_(std::move(rows)), held_(system.compliance(rows_)) {}

HeldContact::Response HeldContact::respond(const std::vector<base::Matrix>& load,
                                           const base::Matrix& gap) const {
  const std::vector<const CondensedBody*>& bodies = system_.bodies();
  const Eigen::Index modes = system_.first_mode(bodies.size());
  Response out;
  base::Matrix on_modes(modes, gap.cols());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    out.u.push_back(bodies[b]->displacement(load[b]));
    const base::Matrix& Q = bodies[b]->modes();
    on_modes.middleRows(system_.first_mode(b), Q.cols()) = Q.transpose() * load[b];
  }
  base::Matrix opened = gap;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    opened.row(static_cast<Eigen::Index>(i)) += system_.openings(rows_[i], out.u);
  }
  const solve::HeldRows::Response found = held_.respond(opened, on_modes);
  out.left_over = found.left_over;
  out.force = found.lambda;
  std::vector<base::Matrix> force = load;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    system_.add_force(rows_[i], out.force.row(static_cast<Eigen::Index>(i)), force);
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const base::Matrix& Q = bodies[b]->modes();
    out.u[b] = bodies[b]->displacement(force[b]) +
               Q * found.alpha.middleRows(system_.first_mode(b), Q.cols());
  }
  return out;
}

} // namespace spricka::contact
