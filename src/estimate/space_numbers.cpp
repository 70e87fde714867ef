// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/space_numbers.hpp"

#include "estimate/space_modes.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace spricka::estimate {

namespace {

using base::NodeId;

/// An edge (its ends and its middle) or a face (its corners; the fourth invalid of a triangle).
using PlaceKey = std::array<NodeId, 4>;

/// Something that modes belong to, with all of its nodes.
struct ModePlace {
  std::int32_t first = 0; ///< its first mode
  std::vector<NodeId> nodes;
  bool quadrilateral = false;
};

class Numbering {
public:
  Numbering(const model::Mesh& mesh, const std::vector<model::FreedomRole>& cls,
            const fe::ConstraintTransformation& ties)
      : mesh_(mesh), cls_(cls), ties_(ties) {}

  SolidModeNumbers make() {
    numbers_.first.push_back(0);
    for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
      const base::ElementId id(e);
      for (const SolidMode& mode : SolidModes::for_type(mesh_.type[e]).modes()) {
        add(id, mode);
      }
      numbers_.first.push_back(numbers_.mode.size());
    }
    hold();
    return std::move(numbers_);
  }

private:
  // The place of that key, which has so many modes.
  ModePlace& place_at(const PlaceKey& key, std::int32_t count, std::vector<NodeId> nodes) {
    const auto [at, made] = places_.try_emplace(key);
    if (made) {
      at->second = {next_, std::move(nodes), count == 4};
      next_ += count;
    }
    return at->second;
  }

  void add(base::ElementId e, const SolidMode& mode) {
    const base::ElementType type = mesh_.type[e.index()];
    const std::span<const NodeId> nodes = mesh_.element_nodes(e);
    const auto node = [&](int k) { return nodes[static_cast<std::size_t>(k)]; };
    if (mode.on == SolidMode::SolidModeSite::inside) {
      put(next_++, 1.0);
      return;
    }
    if (mode.on == SolidMode::SolidModeSite::edge) {
      const auto [i, j] = shape::edge_corners(type, mode.which);
      const NodeId middle = node(base::element_info(type).corners + mode.which);
      const ModePlace& at =
          place_at({std::min(node(i), node(j)), std::max(node(i), node(j)), middle, NodeId()}, 1,
                   {node(i), node(j), middle});
      put(at.first, node(i) < node(j) ? 1.0 : -1.0);
      return;
    }
    const std::span<const int> local = shape::side_nodes(type, mode.which);
    const bool triangle = mode.on == SolidMode::SolidModeSite::triangle;
    PlaceKey key{node(local[0]), node(local[1]), node(local[2]),
                 triangle ? NodeId() : node(local[3])};
    const PlaceKey corners = key;
    std::sort(key.begin(), key.begin() + (triangle ? 3 : 4));
    std::vector<NodeId> all;
    for (const int k : local) {
      all.push_back(node(k));
    }
    const ModePlace& at = place_at(key, triangle ? 1 : 4, std::move(all));
    if (triangle) {
      put(at.first, 1.0);
      return;
    }
    const FaceModeAxes axes = face_mode_axes(corners);
    const auto own = static_cast<std::size_t>(mode.number);
    put(at.first + axes.number[own], axes.sign[own]);
  }

  void put(std::int32_t mode, double sign) {
    numbers_.mode.push_back(mode);
    numbers_.sign.push_back(sign);
  }

  [[nodiscard]] bool given(NodeId n, std::size_t c) const {
    const model::FreedomRole k = cls_[3 * n.index() + c];
    return k == model::FreedomRole::suppressed || k == model::FreedomRole::prescribed;
  }

  /// Nodes by their part in ties.
  struct TiedNodes {
    std::vector<bool> follows, leads;
    std::set<std::vector<NodeId>> quadrilaterals; ///< whose diagonal is tied, nodes ascending
  };

  [[nodiscard]] TiedNodes tied_nodes() const {
    TiedNodes tied;
    tied.follows.assign(mesh_.node_count(), false);
    tied.leads.assign(mesh_.node_count(), false);
    std::set<std::vector<NodeId>> faces;
    for (const auto& [key, place] : places_) {
      if (place.quadrilateral) {
        faces.insert(sorted(place.nodes));
      }
    }
    std::map<std::vector<NodeId>, std::set<NodeId>> inside; // nodes that follow all of a face
    for (const fe::ConstraintTransformation::DependentRow& row : ties_.rows()) {
      std::vector<NodeId> masters;
      for (const fe::FreedomTerm& term : row.terms) {
        masters.emplace_back(static_cast<std::size_t>(term.freedom) / 3);
      }
      masters = sorted(std::move(masters));
      masters.erase(std::unique(masters.begin(), masters.end()), masters.end());
      tied.follows[static_cast<std::size_t>(row.freedom) / 3] = true;
      const bool is_face = faces.contains(masters);
      if (is_face) {
        inside[masters].emplace(static_cast<std::size_t>(row.freedom) / 3);
      }
      if (!is_face || inside[masters].size() > 1) {
        for (const NodeId n : masters) {
          tied.leads[n.index()] = true;
        }
      }
    }
    for (const auto& [face, nodes] : inside) {
      tied.quadrilaterals.insert(face);
    }
    return tied;
  }

  static std::vector<NodeId> sorted(std::vector<NodeId> nodes) {
    std::sort(nodes.begin(), nodes.end());
    return nodes;
  }

  void hold() {
    numbers_.free = base::Vector::Ones(3 * static_cast<Eigen::Index>(next_));
    const TiedNodes tied = tied_nodes();
    for (const auto& [key, place] : places_) {
      const bool joined =
          std::ranges::any_of(place.nodes, [&](NodeId n) { return tied.follows[n.index()]; }) ||
          std::ranges::all_of(place.nodes, [&](NodeId n) { return tied.leads[n.index()]; }) ||
          (place.quadrilateral && tied.quadrilaterals.contains(sorted(place.nodes)));
      for (std::size_t c = 0; c < 3; ++c) {
        if (joined || std::ranges::all_of(place.nodes, [&](NodeId n) { return given(n, c); })) {
          for (std::int32_t k = 0; k < (place.quadrilateral ? 4 : 1); ++k) {
            numbers_.free[3 * static_cast<Eigen::Index>(place.first + k) +
                          static_cast<Eigen::Index>(c)] = 0.0;
          }
        }
      }
    }
  }

  const model::Mesh& mesh_;
  const std::vector<model::FreedomRole>& cls_;
  const fe::ConstraintTransformation& ties_;
  std::map<PlaceKey, ModePlace> places_;
  std::int32_t next_ = 0;
  SolidModeNumbers numbers_;
};

} // namespace

SolidModeNumbers number_solid_modes(const model::Mesh& mesh,
                                    const std::vector<model::FreedomRole>& cls,
                                    const fe::ConstraintTransformation& ties) {
  return Numbering(mesh, cls, ties).make();
}

} // namespace spricka::estimate
