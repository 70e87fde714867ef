// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/make_rows.hpp"

#include "base/index.hpp"
#include "base/parallel.hpp"
#include "contact/contiguous_ranges.hpp"
#include "contact/push_only.hpp"
#include "contact/row_builder.hpp"
#include "contact/space/frames.hpp"
#include "contact/space/opposite.hpp"
#include "contact/space_dual.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

namespace spricka::contact {

using base::index;

namespace {

constexpr double weak_cover = 0.2; // of a function: less of it joins a neighbour
constexpr double no_cover = 1e-9;  // round-off
constexpr double twice = 1e-6;     // of an element: more than all of it

// Integrals of an element's hats times what the two surfaces move along one direction.
struct HatMotionIntegrals {
  using OfHats = std::array<geometry::SidePositions, 3>; ///< [hat] by node of the facet
  OfHats own;
  std::vector<OfHats> target;
};

struct HatIntegrals {
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero(); ///< hat times hat
  Eigen::Vector3d gap = Eigen::Vector3d::Zero();
  Eigen::Vector3d round_gap = Eigen::Vector3d::Zero();
  std::vector<std::size_t> targets;         ///< facets met
  std::array<HatMotionIntegrals, 3> motion; ///< along the normal and the tangents
};

struct ElementContribution {
  OppositePointsOfElement projection;
  HatIntegrals sum;        ///< where something lies opposite
  Eigen::Matrix3d weights; ///< [function, hat]
};

void set_zero(HatMotionIntegrals::OfHats& of_hats, std::size_t nodes) {
  for (geometry::SidePositions& of_hat : of_hats) {
    of_hat.setZero(3, index(nodes));
  }
}

class MortarRows {
public:
  MortarRows(PairConstraints& pair, const MortarRowOptions& options)
      : pair_(pair), own_(pair.contact), other_(pair.target), options_(options),
        functions_(pair.functions), frames_(own_),
        directions_(options.tangents ? frames_.count() : 1) {}

  void make(const ElementProjector& project) {
    number_functions();
    auto opposite = std::make_shared<std::vector<std::vector<PairQuadraturePoint>>>();
    opposite->reserve(own_.elements.size());
    base::make_and_take_in_order(
        own_.elements.size(), elements_at_a_time,
        [&](std::size_t e) { return contribution(own_.elements[e], project); },
        [&](std::size_t e, const ElementContribution& own) {
          if (pair_.trouble.empty()) {
            opposite->emplace_back(own.projection.points.begin(), own.projection.points.end());
            add(own_.elements[e], own);
          }
        });
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
  void number_functions() {
    for (const SmoothPartNode& key : smooth_part_nodes(own_)) {
      place_[key] = functions_.size();
      functions_.push_back({.node = key.second, .part = key.first, .held = {}});
    }
    rows_.resize(functions_.size());
    beside_.resize(functions_.size());
  }

  [[nodiscard]] HatIntegrals integrate(const HatElement& element,
                                       const OppositePointsOfElement& projection) const {
    HatIntegrals sum;
    const geometry::ElementSide& facet = own_.facets[element.facet];
    for (std::size_t k = 0; k < directions_; ++k) {
      set_zero(sum.motion[k].own, facet.nodes.size());
    }
    const bool rigid = other_.facets.empty();
    for (const PairPoint& p : projection.points) {
      if (!rigid && (sum.targets.empty() || sum.targets.back() != p.target)) {
        sum.targets.push_back(p.target);
        for (std::size_t k = 0; k < directions_; ++k) {
          set_zero(sum.motion[k].target.emplace_back(), other_.facets[p.target].nodes.size());
        }
      }
      const geometry::SideValues N = facet.N(p.r);
      const geometry::SideValues M =
          rigid ? geometry::SideValues() : other_.facets[p.target].N(p.s);
      const std::array<Vec3, 3> along = frames_.at(own_.part[element.facet], p.normal);
      const Eigen::Vector3d w = p.weight * p.hat;
      sum.moment += w * p.hat.transpose();
      sum.gap += options_.declared_gap.value_or(p.gap) * w;
      sum.round_gap += options_.declared_gap.value_or(p.round_gap) * w;
      for (std::size_t k = 0; k < directions_; ++k) {
        HatMotionIntegrals& motion = sum.motion[k];
        for (std::size_t h = 0; h < element.node_count(); ++h) {
          const Vec3 push = w[index(h)] * along[k];
          motion.own[h] -= push * N.transpose();
          if (!rigid) {
            motion.target.back()[h] += push * M.transpose();
          }
        }
      }
    }
    return sum;
  }

  [[nodiscard]] ElementContribution contribution(const HatElement& element,
                                                 const ElementProjector& project) const {
    ElementContribution own;
    own.projection = project(element);
    if (own.projection.trouble.empty() && !own.projection.points.empty()) {
      own.sum = integrate(element, own.projection);
      own.weights = element.node_count() == 3 ? dual_hat_weights(own.sum.moment)
                                              : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
    }
    return own;
  }

  void add(const HatElement& element, const ElementContribution& own) {
    const OppositePointsOfElement& projection = own.projection;
    pair_.unprojected_area += projection.unprojected_area;
    pair_.trouble = projection.trouble;
    if (projection.flat_seen > (1.0 + twice) * projection.flat_area) {
      pair_.trouble = "the surfaces face each other twice at one place (two layers of the master "
                      "lie within a fifth of the slave's extent)";
    }
    if (!pair_.trouble.empty()) {
      return;
    }
    const std::vector<std::size_t> at = functions_of(element);
    for (std::size_t a = 0; a < at.size(); ++a) {
      functions_[at[a]].whole += projection.whole[index(a)];
    }
    if (projection.points.empty()) {
      return;
    }
    const HatIntegrals& sum = own.sum;
    for (std::size_t a = 0; a < at.size(); ++a) {
      const Eigen::RowVector3d weight = own.weights.row(index(a));
      std::array<ConstraintRowBuilder, 3>& row = rows_[at[a]];
      // (contact.2), and along the tangents (contact.21).
      row[0].gap += weight * sum.gap;
      row[0].round_gap += weight * sum.round_gap;
      const double area = weight * sum.moment.rowwise().sum();
      for (std::size_t k = 0; k < directions_; ++k) {
        row[k].area += area;
        add_motion(element, sum, k, weight, row[k]);
      }
      for (const std::size_t b : at) {
        if (b != at[a]) {
          beside_[at[a]].push_back(b);
        }
      }
    }
  }

  [[nodiscard]] std::vector<std::size_t> functions_of(const HatElement& element) const {
    std::vector<std::size_t> at;
    for (std::size_t i = 0; i < element.node_count(); ++i) {
      at.push_back(place_.at(own_.part_node(element, i)));
    }
    return at;
  }

  void add_motion(const HatElement& element, const HatIntegrals& sum, std::size_t k,
                  const Eigen::RowVector3d& weight, ConstraintRowBuilder& row) const {
    const auto add_nodes = [&](const std::vector<base::NodeId>& nodes, const auto& of_hat) {
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        Vec3 motion = weight[0] * of_hat[0].col(index(i)) + weight[1] * of_hat[1].col(index(i));
        if (element.node_count() == 3) {
          motion += weight[2] * of_hat[2].col(index(i));
        }
        row.add_contribution(nodes[i], motion);
      }
    };
    add_nodes(own_.facets[element.facet].nodes, sum.motion[k].own);
    for (std::size_t t = 0; t < sum.targets.size(); ++t) {
      add_nodes(other_.facets[sum.targets[t]].nodes, sum.motion[k].target[t]);
    }
  }

  // A sliver of cover makes a row that weighs next to nothing: its function joins a neighbour's.
  // What none can take must hold, but for round-off.
  void join_weak_ones() {
    root_.resize(rows_.size());
    std::iota(root_.begin(), root_.end(), std::size_t{0});
    std::vector<std::size_t> weak;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const double area = rows_[i][0].area;
      functions_[i].area = area;
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
      } else if (rows_[i][0].area <= no_cover * functions_[i].whole) {
        rows_[i] = {};
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
    return next && *next > i && rows_[*next][0].area > 0.0 ? *next : i;
  }

  [[nodiscard]] std::size_t best_covered(std::size_t i) const {
    std::size_t best = i;
    for (const std::size_t b : beside_[i]) {
      if (covered_[b] > covered_[best]) {
        best = b;
      }
    }
    return best;
  }

  // The row of a function goes to another's, or to that which has it.
  void join(std::size_t i, std::size_t taker) {
    root_[i] = root_[taker];
    for (std::size_t k = 0; k < rows_[i].size(); ++k) {
      rows_[root_[i]][k].add_contribution(rows_[i][k]);
    }
    rows_[i] = {};
  }

  // Nodes of a crack's front belong to both faces: their own rows would ask nothing.
  void join_front() {
    for (const auto& [key, i] : place_) {
      const auto behind = options_.at_front.find(key.second);
      if (behind == options_.at_front.end()) {
        continue;
      }
      if (const auto taker = place_.find({key.first, behind->second}); taker != place_.end()) {
        join(i, taker->second);
      }
      rows_[i] = {};
    }
  }

  void append() {
    std::vector<int> row_of(rows_.size(), -1);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (!(rows_[i][0].area > 0.0)) {
        continue;
      }
      row_of[i] = static_cast<int>(pair_.normal.size());
      const base::NodeId node = functions_[i].node;
      for (std::size_t k = 1; k < directions_; ++k) {
        pair_.tangent.push_back(rows_[i][k].make_row(node, row_of[i], static_cast<int>(k)));
      }
      pair_.normal.push_back(rows_[i][0].make_row(node));
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      std::size_t taker = root_[i];
      while (root_[taker] != taker) { // along a curve slivers are handed on
        taker = root_[taker];
      }
      functions_[i].row = row_of[taker];
      functions_[i].joined = taker != i;
    }
  }

  PairConstraints& pair_;
  const FacetSurface& own_;
  const FacetSurface& other_;
  const MortarRowOptions& options_;
  std::vector<MultiplierFunction>& functions_; ///< of the pair
  SurfaceFrames frames_;
  std::size_t directions_; ///< 1, or with tangents 2 in the plane and 3 in space
  std::map<SmoothPartNode, std::size_t> place_;
  std::vector<std::array<ConstraintRowBuilder, 3>> rows_; ///< [function] along normal and tangents
  std::vector<std::vector<std::size_t>> beside_;          ///< [function] those of covered elements
  std::vector<double> covered_;                           ///< [function] part of its whole area
  std::vector<std::size_t> root_;                         ///< [function] whose row has it
};

} // namespace

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
