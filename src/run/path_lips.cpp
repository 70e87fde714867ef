// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/load_paths.hpp"

#include "crack/stress_intensity.hpp"
#include "run/lip_contact.hpp"

#include <algorithm>

/// Faces of cracks on load paths.
namespace spricka::run {

std::vector<std::size_t> LoadPaths::touching(const StepSolver& solver,
                                             const std::vector<results::LoadPath>& paths) const {
  std::vector<std::size_t> lines;
  if (scene_.cracked.lips.empty()) {
    return lines;
  }
  const auto look = [&](const base::Vector& u) {
    for (const std::size_t line : touching_lines(model_, scene_, u)) {
      if (std::ranges::find(lines, line) == lines.end()) {
        lines.push_back(line);
      }
    }
  };
  for (std::size_t p = 0; p < paths.size(); ++p) {
    const End& from = ends_.at(model_.load_paths[p].from.index());
    const End& to = ends_.at(model_.load_paths[p].to.index());
    for (const double t : paths[p].t) {
      const base::Vector factor = (1.0 - t) * from.case_factor + t * to.case_factor;
      std::vector<base::Vector> external(bodies_.size());
      if (solver.system() != nullptr) {
        contact::ContactSystem::Demand demand = from.demand;
        demand.gap = (1.0 - t) * from.demand.gap + t * to.demand.gap;
        for (std::size_t b = 0; b < demand.load.size(); ++b) {
          demand.load[b] = (1.0 - t) * from.demand.load[b] + t * to.demand.load[b];
        }
        contact::ContactSystem::Answer answer = solver.system()->solve(demand, {});
        if (answer.solution.status != solve::ContactStatus::solved) {
          continue; // where nothing holds a body any more the path has ended
        }
        for (std::size_t i = 0; i < answer.u.size(); ++i) {
          external[solver.condensed()[i]] = std::move(answer.u[i]);
        }
      }
      base::Vector u = scene_.case_displacement * factor;
      for (std::size_t b = 0; b < bodies_.size(); ++b) {
        recover_body(bodies_[b], external[b], factor, u);
      }
      look(u);
    }
  }
  std::ranges::sort(lines);
  return lines;
}

void LoadPaths::add_lip_forces(base::Matrix& of_row) const {
  for (std::size_t t = 0; t < scene_.cracked.tips.size(); ++t) {
    const mesh::Tip& tip = scene_.cracked.tips[t];
    const std::optional<LipPair>& lip = scene_.lip_pairs[tip.crack.index()];
    if (!lip) {
      continue;
    }
    const base::Matrix weight =
        crack::lip_intensity_rows(model_, scene_.cracked, tip, scene_.tips[t].fields,
                                  model_.cracks[tip.crack.index()].state, lip->sides);
    for (std::size_t r = scene_.table.first[lip->pair]; r < scene_.table.first[lip->pair + 1];
         ++r) {
      for (const contact::RowEntry& entry : scene_.table.rows[r]->entries) {
        const auto at = 2 * static_cast<Eigen::Index>(entry.node.index());
        of_row.col(static_cast<Eigen::Index>(r)).segment<2>(2 * static_cast<Eigen::Index>(t)) +=
            weight.middleRows<2>(at).transpose() * entry.weight.head<2>();
      }
    }
  }
}

bool LoadPaths::close_tip(std::size_t t, const End& end, const solve::SolutionPath& found,
                          base::PiecewiseLinear& K1) const {
  const std::optional<std::size_t> row = row_at_tip(scene_, scene_.cracked.tips[t]);
  const auto at = row ? std::ranges::find(end.demand.rows, *row) : end.demand.rows.end();
  if (at == end.demand.rows.end()) {
    return false;
  }
  const auto place = at - end.demand.rows.begin();
  bool closed = found.closed[static_cast<std::size_t>(place)];
  bool any = false;
  std::vector<double> value;
  std::vector<double> slope;
  auto change = found.changes.begin();
  for (std::size_t s = 0; s < found.segments.size(); ++s) {
    for (; change != found.changes.end() && change->segment == s; ++change) {
      closed = change->row == place ? change->closes : closed;
    }
    any = any || closed;
    value.push_back(closed ? 0.0 : K1.at_knot(s));
    slope.push_back(closed ? 0.0 : K1.slope(s));
  }
  K1 = base::PiecewiseLinear(K1.knots(), std::move(value), std::move(slope));
  return any;
}

} // namespace spricka::run
