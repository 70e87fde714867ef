// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/make_rows.hpp"

#include "base/parallel.hpp"
#include "contact/contiguous_ranges.hpp"
#include "contact/push_only.hpp"
#include "contact/space/opposite.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <numeric>
#include <utility>

namespace spricka::contact {

namespace {

constexpr double weak_cover = 0.2; // of a function: less of it joins a neighbour
constexpr double no_cover = 1e-9;  // round-off
constexpr double twice = 1e-6;     // of an element: more than all of it

// Why rows cannot be made of what an element has opposite; empty: they can.
std::string trouble_of(const OppositePointsOfElement& projection) {
  return projection.trouble.empty() && projection.flat_seen > (1.0 + twice) * projection.flat_area
             ? "the surfaces face each other twice at one place (two layers of the master lie "
               "within a fifth of the slave's extent)"
             : projection.trouble;
}

class MortarRows {
public:
  MortarRows(PairConstraints& pair, const MortarRowOptions& options)
      : pair_(pair), options_(options), functions_(pair.functions), sums_(pair, options) {}

  void make(const ElementProjector& project) {
    const std::vector<HatElement>& elements = pair_.contact.elements;
    auto opposite = std::make_shared<std::vector<std::vector<PairQuadraturePoint>>>();
    opposite->reserve(elements.size());
    base::make_and_take_in_order(
        elements.size(), elements_at_a_time,
        [&](std::size_t e) { return sums_.contribution(elements[e], project); },
        [&](std::size_t e, const ElementContribution& own) {
          if (pair_.trouble.empty()) {
            opposite->emplace_back(own.projection.points.begin(), own.projection.points.end());
            pair_.unprojected_area += own.projection.unprojected_area;
            pair_.trouble = trouble_of(own.projection);
            if (pair_.trouble.empty()) {
              sums_.add(elements[e], own);
            }
          }
        });
    name_functions();
    if (!pair_.trouble.empty()) {
      pair_.found = true;
      return;
    }
    pair_.segments = true;
    pair_.opposite = std::move(opposite);
    join_weak_ones();
    join_front();
    append();
    pair_.found = !pair_.normal.empty();
  }

private:
  void name_functions() {
    functions_.resize(sums_.functions().size());
    for (const auto& [key, i] : sums_.places()) {
      functions_[i] = {.node = key.second, .part = key.first, .held = {}};
    }
    for (std::size_t i = 0; i < functions_.size(); ++i) {
      functions_[i].whole = sums_.functions()[i].whole;
      functions_[i].area = row_of(i)[0].area;
    }
  }

  [[nodiscard]] std::array<ConstraintRowBuilder, 3>& row_of(std::size_t i) {
    return sums_.functions()[i].row;
  }

  // A sliver of cover makes a row that weighs next to nothing: its function joins a neighbour's.
  // What none can take must hold, but for round-off.
  void join_weak_ones() {
    root_.resize(functions_.size());
    std::iota(root_.begin(), root_.end(), std::size_t{0});
    std::vector<std::size_t> weak;
    for (std::size_t i = 0; i < functions_.size(); ++i) {
      const double area = functions_[i].area;
      covered_.push_back(area > 0.0 ? area / functions_[i].whole : 0.0);
      if (area > 0.0 && covered_[i] < weak_cover) {
        weak.push_back(i);
      }
    }
    const SequenceLinks along = links_along_curves();
    const bool curves = !pair_.contact.plane.chains.empty();
    if (!curves) { // the strongest first, so that slivers before coarse faces add up to one row
      std::ranges::stable_sort(weak, std::greater<>(), [&](std::size_t i) { return covered_[i]; });
    }
    for (const std::size_t i : weak) {
      const std::size_t taker = curves ? taker_along(along, i) : best_covered(i);
      if (taker != i) {
        join(i, taker);
        ++pair_.merged;
      } else if (row_of(i)[0].area <= no_cover * functions_[i].whole) {
        row_of(i) = {};
      }
    }
  }

  // The next function of each along the curves.
  [[nodiscard]] SequenceLinks links_along_curves() const {
    SequenceLinks links(functions_.size());
    for (const ChainRange& chain : node_ranges_of_chains(pair_.contact)) {
      for (std::size_t i = 1; i < chain.count; ++i) {
        links.join(chain.first + i - 1, chain.first + i);
      }
      if (chain.closed) {
        links.join(chain.first + chain.count - 1, chain.first);
      }
    }
    return links;
  }

  // Of the neighbours along a curve the next if it is well covered, else the last; before a narrow
  // target, where neither is, slivers are handed on and become one row.
  [[nodiscard]] std::size_t taker_along(const SequenceLinks& links, std::size_t i) const {
    const auto well_covered = [&](const std::optional<std::size_t>& k) {
      return k && covered_[*k] >= weak_cover;
    };
    const std::optional<std::size_t>& next = links.next[i];
    if (well_covered(next)) {
      return *next;
    }
    if (well_covered(links.last[i])) {
      return *links.last[i];
    }
    return next && *next > i && functions_[*next].area > 0.0 ? *next : i;
  }

  [[nodiscard]] std::size_t best_covered(std::size_t i) const {
    std::size_t best = i;
    for (const std::size_t b : sums_.functions()[i].beside) {
      if (covered_[b] > covered_[best]) {
        best = b;
      }
    }
    return best;
  }

  // The row of a function goes to another's, or to that which has it.
  void join(std::size_t i, std::size_t taker) {
    root_[i] = root_[taker];
    for (std::size_t k = 0; k < row_of(i).size(); ++k) {
      row_of(root_[i])[k].add_contribution(row_of(i)[k]);
    }
    row_of(i) = {};
  }

  // Nodes of a crack's front belong to both faces: their own rows would ask nothing.
  void join_front() {
    for (const auto& [key, i] : sums_.places()) {
      const auto behind = options_.at_front.find(key.second);
      if (behind == options_.at_front.end()) {
        continue;
      }
      if (const auto taker = sums_.places().find({key.first, behind->second});
          taker != sums_.places().end()) {
        join(i, taker->second);
      }
      row_of(i) = {};
    }
  }

  void append() {
    std::vector<int> numbers(functions_.size(), -1);
    for (std::size_t i = 0; i < functions_.size(); ++i) {
      if (!(row_of(i)[0].area > 0.0)) {
        continue;
      }
      numbers[i] = static_cast<int>(pair_.normal.size());
      const base::NodeId node = functions_[i].node;
      for (std::size_t k = 1; k < sums_.direction_count(); ++k) {
        pair_.tangent.push_back(row_of(i)[k].make_row(node, numbers[i], static_cast<int>(k)));
      }
      pair_.normal.push_back(row_of(i)[0].make_row(node));
    }
    for (std::size_t i = 0; i < functions_.size(); ++i) {
      std::size_t taker = root_[i];
      while (root_[taker] != taker) { // along a curve slivers are handed on
        taker = root_[taker];
      }
      functions_[i].row = numbers[taker];
      functions_[i].joined = taker != i;
    }
  }

  PairConstraints& pair_;
  const MortarRowOptions& options_;
  std::vector<MultiplierFunction>& functions_; ///< of the pair
  MortarSums sums_;
  std::vector<double> covered_;   ///< [function] part of its whole area
  std::vector<std::size_t> root_; ///< [function] whose row has it
};

// Whether some function has a row of a selection. [row]
bool has_row_in(const std::vector<bool>& rows, const PairConstraints& pair,
                const std::vector<std::size_t>& functions) {
  return std::ranges::any_of(functions, [&](std::size_t i) {
    const int row = pair.functions[i].row;
    return row >= 0 && rows[static_cast<std::size_t>(row)];
  });
}

// Puts sums in the place of chosen rows. [row]
void replace_rows(PairConstraints& pair, const MortarSums& sums, const std::vector<bool>& chosen) {
  std::map<int, std::array<ConstraintRowBuilder, 3>> rows;
  for (const bool joined : {false, true}) { // as rows are joined: what has the row comes first
    for (std::size_t i = 0; i < pair.functions.size(); ++i) {
      MultiplierFunction& function = pair.functions[i];
      if (function.joined != joined || !has_row_in(chosen, pair, {i})) {
        continue;
      }
      const FunctionSums& own = sums.functions()[i];
      function.area = own.row[0].area;
      function.whole = own.whole;
      for (std::size_t k = 0; k < own.row.size(); ++k) {
        rows[function.row][k].add_contribution(own.row[k]);
      }
    }
  }
  for (const auto& [r, row] : rows) {
    ConstraintRow& normal = pair.normal[static_cast<std::size_t>(r)];
    normal = row[0].make_row(normal.node);
  }
  for (ConstraintRow& tangent : pair.tangent) {
    if (const auto row = rows.find(tangent.normal); row != rows.end()) {
      tangent = row->second[static_cast<std::size_t>(tangent.along)].make_row(
          tangent.node, tangent.normal, tangent.along);
    }
  }
}

} // namespace

bool renew_mortar_rows(PairConstraints& pair, const ElementProjector& project,
                       const MortarRowOptions& options, const std::vector<bool>& changed) {
  const std::vector<HatElement>& elements = pair.contact.elements;
  MortarSums sums(pair, options);
  std::vector<bool> rows(pair.normal.size(), false);
  std::vector<std::size_t> without_row;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    for (const std::size_t i :
         changed[e] ? sums.functions_of(elements[e]) : std::vector<std::size_t>()) {
      if (const int row = pair.functions[i].row; row >= 0) {
        rows[static_cast<std::size_t>(row)] = true;
      } else {
        without_row.push_back(i);
      }
    }
  }
  std::vector<std::size_t> some; // all elements of the functions that have these rows
  for (std::size_t e = 0; e < elements.size(); ++e) {
    if (changed[e] || has_row_in(rows, pair, sums.functions_of(elements[e]))) {
      some.push_back(e);
    }
  }
  auto opposite = std::make_shared<std::vector<std::vector<PairQuadraturePoint>>>(*pair.opposite);
  bool good = true;
  base::make_and_take_in_order(
      some.size(), elements_at_a_time,
      [&](std::size_t i) { return sums.contribution(elements[some[i]], project); },
      [&](std::size_t i, const ElementContribution& own) {
        good = good && trouble_of(own.projection).empty();
        if (good) {
          (*opposite)[some[i]].assign(own.projection.points.begin(), own.projection.points.end());
          sums.add(elements[some[i]], own);
        }
      });
  good = good && std::ranges::none_of(without_row, [&](std::size_t i) {
           return sums.functions()[i].row[0].area > no_cover * sums.functions()[i].whole;
         });
  if (good) {
    replace_rows(pair, sums, rows);
    pair.opposite = std::move(opposite);
  }
  return good;
}

void fill_mortar_rows(PairConstraints& pair, const ElementProjector& project,
                      const MortarRowOptions& options) {
  MortarRows(pair, options).make(project);
}

std::vector<std::vector<std::size_t>> functions_by_facet(const PairConstraints& pair) {
  const FacetSurface& surface = pair.contact;
  std::map<SmoothPartNode, std::size_t> place;
  for (std::size_t i = 0; i < pair.functions.size(); ++i) {
    place[{pair.functions[i].part, pair.functions[i].node}] = i;
  }
  std::vector<std::vector<std::size_t>> all;
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    std::vector<std::size_t>& at = all.emplace_back();
    for (const base::NodeId n : surface.facets[f].nodes) {
      const auto own = place.find({surface.part[f], n});
      if (own != place.end()) { // corners come first
        at.push_back(own->second);
      }
    }
  }
  return all;
}

std::vector<std::vector<int>> normal_rows_by_facet(const PairConstraints& pair) {
  std::vector<std::vector<int>> all;
  for (const std::vector<std::size_t>& functions : functions_by_facet(pair)) {
    std::vector<int>& rows = all.emplace_back();
    for (const std::size_t i : functions) {
      rows.push_back(pair.functions[i].row);
    }
  }
  return all;
}

} // namespace spricka::contact
