// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/adjoint/front_edges.hpp"

#include "analysis/steps/row_opening.hpp"
#include "base/index.hpp"
#include "contact/space_spot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

namespace spricka::analysis {

namespace {

using base::index;

// Pivots below this share of the largest belong to redundant rows.
constexpr double no_own_pivot = 1e-10;
// Lines of one pair that are looked at one by one; what is left of them counts as one more.
constexpr std::size_t most_lines = 6;

/// Normal rows that change their state together: a connected line of them beside an edge of what
/// is closed.
struct RowLine {
  std::vector<std::size_t> rows; ///< of the table
  bool closed = false;
  bool sharp = false; ///< at an edge of one surface, else where contact ends on both
};

using Neighbours = std::vector<std::set<std::size_t>>; // [normal row of a pair]

// Splits chosen rows of a pair into connected lines.
void add_lines(const Neighbours& next, std::vector<bool> chosen, const RowLine& kind,
               std::size_t first, std::vector<RowLine>& lines) {
  std::vector<RowLine> found;
  for (std::size_t r = 0; r < chosen.size(); ++r) {
    if (!chosen[r]) {
      continue;
    }
    RowLine line = kind;
    std::vector<std::size_t> open{r};
    chosen[r] = false;
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      line.rows.push_back(first + at);
      for (const std::size_t b : next[at]) {
        if (chosen[b]) {
          chosen[b] = false;
          open.push_back(b);
        }
      }
    }
    found.push_back(std::move(line));
  }
  std::ranges::stable_sort(found, std::greater<>(), [](const RowLine& l) { return l.rows.size(); });
  while (found.size() > most_lines) {
    std::vector<std::size_t>& last = found[most_lines - 1].rows;
    last.insert(last.end(), found.back().rows.begin(), found.back().rows.end());
    found.pop_back();
  }
  std::ranges::move(found, std::back_inserter(lines));
}

// The rows of a pair at sharp edges that are closed.
std::vector<bool> at_sharp_edges(const contact::PairConstraints& pair,
                                 const std::vector<bool>& closed) {
  std::set<base::NodeId> nodes;
  for (const contact::SingularContactEdge& end : pair.sharp_ends) {
    nodes.insert(end.nodes.begin(), end.nodes.end());
  }
  std::vector<bool> at(pair.normal.size(), false);
  for (const contact::MultiplierFunction& function : pair.functions) {
    if (function.row >= 0 && nodes.contains(function.node)) {
      const auto r = static_cast<std::size_t>(function.row);
      at[r] = closed[r];
    }
  }
  return at;
}

// Whether a contact presses on the faces of a crack, as a body between them does. Elsewhere a sharp
// edge is far from K, or beside the mouth (coarse_surface_effect.hpp), where taking a row of coarse
// elements away says nothing of an error.
bool presses_on_a_crack(const Discretisation& scene, const model::Contact& contact) {
  std::set<std::pair<base::ElementId, int>> sides;
  for (const mesh::CrackFaceNodes& faces : scene.cracked.faces) {
    for (const auto* some : {&faces.left_sides, &faces.right_sides}) {
      for (const model::Face& face : *some) {
        sides.emplace(face.element, face.side);
      }
    }
  }
  return std::ranges::any_of(std::array{contact.slave, contact.master}, [&](base::FaceSetId id) {
    return id.valid() && std::ranges::any_of(scene.cracked.mesh.set_with_id(id).faces,
                                             [&](const model::Face& face) {
                                               return sides.contains({face.element, face.side});
                                             });
  });
}

void add_lines_of(const Discretisation& scene, const StepState& state, std::size_t c,
                  std::vector<RowLine>& lines) {
  const contact::PairConstraints& pair = scene.pairs[c];
  const std::vector<bool>& closed = state.pair_closed[c];
  const Neighbours next = contact::neighbouring_normal_rows(pair);
  std::vector<bool> last(closed.size(), false);
  std::vector<bool> beyond(closed.size(), false);
  for (std::size_t r = 0; r < closed.size(); ++r) {
    if (std::ranges::any_of(next[r], [&](std::size_t b) { return closed[b] != closed[r]; })) {
      (closed[r] ? last : beyond)[r] = true;
    }
  }
  const std::size_t first = scene.table.first[c];
  add_lines(next, last, {.rows = {}, .closed = true, .sharp = false}, first, lines);
  add_lines(next, beyond, {.rows = {}, .closed = false, .sharp = false}, first, lines);
  if (presses_on_a_crack(scene, scene.contacts[c])) {
    add_lines(next, at_sharp_edges(pair, closed), {.rows = {}, .closed = true, .sharp = true},
              first, lines);
  }
}

std::vector<RowLine> lines_of(const Discretisation& scene, const StepState& state) {
  std::vector<RowLine> lines;
  for (std::size_t c = 0; c < scene.pairs.size(); ++c) {
    // Bonded rows have no other state, and with friction K has no bar at all.
    if (state.mounted[c] && scene.pairs[c].tangent.empty() && scene.pairs[c].segments) {
      add_lines_of(scene, state, c, lines);
    }
  }
  return lines;
}

// Pressure of a closed row, or gap of an open one: what its line takes away.
double to_go(const Discretisation& scene, const StepState& state, std::size_t row) {
  const ContactRowTable::ContactRowLocation at = scene.table.places[row];
  return state.pair_closed[at.pair][at.index] ? state.pair_lambda[at.pair][index(at.index)]
                                              : state.pair_gap[at.pair][index(at.index)];
}

// A column for each line: gaps that open its rows, or forces that close them, each as if it were
// alone (estimate.13).
struct Trials {
  base::Matrix alone;  ///< [row of the table, line]
  base::Matrix gaps;   ///< [row of the table, line] of lines that open
  base::Matrix forces; ///< [row of the table, line] of lines that close
};

Trials trials_of(const Discretisation& scene, const FrozenContactStep& step,
                 const std::vector<RowLine>& lines) {
  std::vector<std::size_t> rows;
  for (const RowLine& line : lines) {
    rows.insert(rows.end(), line.rows.begin(), line.rows.end());
  }
  const base::Vector pivot = step.system.fixed_active_set()->row_pivots(rows);
  const Eigen::Index count = index(lines.size());
  Trials trials{.alone = base::Matrix::Zero(index(scene.table.size()), count),
                .gaps = base::Matrix::Zero(index(scene.table.size()), count),
                .forces = base::Matrix::Zero(index(scene.table.size()), count)};
  Eigen::Index i = 0;
  for (Eigen::Index l = 0; l < count; ++l) {
    const RowLine& line = lines[static_cast<std::size_t>(l)];
    const double largest = pivot.segment(i, index(line.rows.size())).maxCoeff();
    for (const std::size_t row : line.rows) {
      const double p = pivot[i++];
      if (!(p > no_own_pivot * largest)) {
        continue;
      }
      const double alone = to_go(scene, step.state, row) / p;
      trials.alone(index(row), l) = line.closed ? alone : -alone;
      if (line.closed) {
        trials.gaps(index(row), l) = alone;
      } else {
        trials.forces(index(row), l) = -alone;
      }
    }
  }
  return trials;
}

// The rows of a line feel each other: of what each would take alone the part that takes away most
// of all their pressures or gaps together (estimate.25).
double share_together(const Discretisation& scene, const FrozenContactStep& step,
                      const RowLine& line, const base::Vector& alone, const base::Vector& u,
                      const base::Vector& force) {
  double wanted = 0.0;
  double done = 0.0;
  for (const std::size_t row : line.rows) {
    const double x = alone[index(row)];
    const double answer =
        line.closed ? force[index(row)] : row_opening(scene.contact_row(row), 3, u);
    wanted -= x * to_go(scene, step.state, row);
    done += x * answer;
  }
  return done != 0.0 ? std::max(0.0, wanted / done) : 0.0;
}

} // namespace

ContactEdgeKChange contact_edge_K_changes(const Discretisation& scene,
                                          const FrozenContactStep& step, const KFunctionals& K) {
  ContactEdgeKChange changes{base::Vector::Zero(K.of_displacements().cols()),
                             base::Vector::Zero(K.of_displacements().cols())};
  const std::vector<RowLine> lines = lines_of(scene, step.state);
  if (lines.empty() || step.system.fixed_active_set() == nullptr ||
      !step.system.fixed_active_set()->is_consistent()) {
    return changes;
  }
  const Trials trials = trials_of(scene, step, lines);
  const FrozenContactResponse answer = step.system.solve_row_response(trials.gaps, trials.forces);
  if (!answer.why_not.empty()) {
    return changes;
  }
  for (std::size_t l = 0; l < lines.size(); ++l) {
    const Eigen::Index at = index(l);
    const base::Vector alone = trials.alone.col(at);
    const base::Vector u = answer.u.col(at);
    base::Vector force = answer.force.col(at);
    const double share = share_together(scene, step, lines[l], alone, u, force);
    if (!lines[l].closed) { // what closes them presses on the front's domains, too
      force += alone;
    }
    const base::Vector change =
        (share * (K.of_displacements().transpose() * u + K.of_contact_forces() * force)).cwiseAbs();
    if (lines[l].sharp) {
      changes.sharp += change;
    } else {
      changes.ends = changes.ends.cwiseMax(change);
    }
  }
  return changes;
}

} // namespace spricka::analysis
