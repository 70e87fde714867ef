// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/mode_map.hpp"

#include "model/freedoms.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace spricka::estimate {

namespace {

std::int32_t freedom_of(base::NodeId n, int c) {
  return static_cast<std::int32_t>(2 * n.index()) + c;
}

// Nodes whose displacements take part in a tie, as the one that follows or as one followed.
std::vector<bool> tied_nodes(const model::Mesh& mesh, const fe::ConstraintTransformation& ties) {
  std::vector<bool> tied(mesh.node_count(), false);
  for (const fe::ConstraintTransformation::DependentRow& row : ties.rows()) {
    tied[static_cast<std::size_t>(row.freedom) / 2] = true;
    for (const fe::FreedomTerm& term : row.terms) {
      tied[static_cast<std::size_t>(term.freedom) / 2] = true;
    }
  }
  return tied;
}

// The node that another follows in both directions as it is; invalid: it follows otherwise.
base::NodeId leader(base::NodeId n, const fe::ConstraintTransformation& ties) {
  base::NodeId found;
  for (int c = 0; c < 2; ++c) {
    const fe::ConstraintTransformation::DependentRow* row = ties.find_row(freedom_of(n, c));
    if (row == nullptr) {
      return {};
    }
    // Weights that only round-off keeps from zero come from points that are nodes.
    const fe::FreedomTerm* only = nullptr;
    for (const fe::FreedomTerm& term : row->terms) {
      if (std::abs(term.coefficient) > 1e-9) {
        if (only != nullptr) {
          return {};
        }
        only = &term;
      }
    }
    if (only == nullptr || std::abs(only->coefficient - 1.0) > 1e-9 || only->freedom % 2 != c) {
      return {};
    }
    const base::NodeId at(static_cast<std::size_t>(only->freedom) / 2);
    if (found.valid() && found != at) {
      return {};
    }
    found = at;
  }
  return found;
}

} // namespace

base::Vector ModeFreedomMap::expand(const base::Vector& y) const {
  base::Vector x(static_cast<Eigen::Index>(unknown.size()));
  for (std::size_t i = 0; i < unknown.size(); ++i) {
    x[static_cast<Eigen::Index>(i)] = unknown[i] < 0 ? 0.0 : factor[i] * y[unknown[i]];
  }
  return x;
}

base::Matrix ModeFreedomMap::reduce(const base::Matrix& f) const {
  base::Matrix y = base::Matrix::Zero(unknowns, f.cols());
  for (std::size_t i = 0; i < unknown.size(); ++i) {
    if (unknown[i] >= 0) {
      // The transpose of expand: freedoms that share an unknown load it together.
      y.row(unknown[i]) += factor[i] * f.row(static_cast<Eigen::Index>(i));
    }
  }
  return y;
}

ModeSupports find_mode_supports(const CubicEnrichment& enrichment,
                                const std::vector<model::FreedomRole>& cls,
                                const fe::ConstraintTransformation& ties) {
  const std::vector<QuadraticEdge>& edges = enrichment.edges().edges;
  ModeSupports supports;
  supports.held.assign(static_cast<std::size_t>(enrichment.freedoms()), false);
  const auto given = [&](base::NodeId n, int c) {
    const model::FreedomRole k = cls[static_cast<std::size_t>(freedom_of(n, c))];
    return k == model::FreedomRole::suppressed || k == model::FreedomRole::prescribed;
  };
  const std::vector<bool> tied = tied_nodes(enrichment.mesh(), ties);
  std::map<std::array<base::NodeId, 3>, std::size_t> index;
  if (!ties.rows().empty()) {
    for (std::size_t e = 0; e < edges.size(); ++e) {
      index.emplace(edges[e].nodes, e);
    }
  }
  std::vector<bool> joined(edges.size(), false);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const std::array<base::NodeId, 3>& nodes = edges[e].nodes;
    std::array<bool, 2> held{};
    for (int c = 0; c < 2; ++c) {
      held[static_cast<std::size_t>(c)] =
          std::ranges::all_of(nodes, [&](base::NodeId n) { return given(n, c); });
    }
    if (enrichment.has_edge_frame(e) && (held[0] || held[1])) {
      held = {true, true}; // the frame has no such direction
    }
    supports.held[2 * e] = held[0];
    supports.held[2 * e + 1] = held[1];
    if (!std::ranges::all_of(nodes, [&](base::NodeId n) { return tied[n.index()]; })) {
      continue;
    }
    joined[e] = true;
    // Of matching nets: an edge whose nodes each follow one node of another edge has its modes.
    const std::array<base::NodeId, 3> lead{leader(nodes[0], ties), leader(nodes[1], ties),
                                           leader(nodes[2], ties)};
    const auto other =
        index.find({std::min(lead[0], lead[1]), std::max(lead[0], lead[1]), lead[2]});
    if (lead[0].valid() && lead[1].valid() && lead[2].valid() && other != index.end() &&
        !enrichment.has_edge_frame(e) && !enrichment.has_edge_frame(other->second)) {
      supports.shared.push_back({e, other->second, side_mode_sign(lead[0], lead[1])});
    }
  }
  for (const ModeSupports::SharedEdgeModes& s : supports.shared) {
    // Both edges of a shared pair keep their modes; others that ties join are held.
    joined[s.edge] = joined[s.as] = false;
  }
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (joined[e]) {
      supports.held[2 * e] = supports.held[2 * e + 1] = true;
    }
  }
  return supports;
}

ModeFreedomMap map_mode_freedoms(const CubicEnrichment& enrichment, const ModeSupports& supports,
                                 const std::vector<ClosedContactEdge>& closed) {
  const auto count = static_cast<std::size_t>(enrichment.freedoms());
  std::vector<bool> held = supports.held;
  // Whom a freedom follows, and how.
  std::vector<std::size_t> as(count);
  std::iota(as.begin(), as.end(), std::size_t{0});
  std::vector<double> factor(count, 1.0);
  const auto follow = [&](std::size_t freedom, std::size_t other, double f) {
    if (as[freedom] == freedom && as[other] == other && !held[freedom] && !held[other]) {
      as[freedom] = other;
      factor[freedom] = f;
    } else {
      // A mode that follows another one already, or is held, has no second to share with.
      held[freedom] = held[other] = true;
    }
  };
  for (const ModeSupports::SharedEdgeModes& s : supports.shared) {
    for (std::size_t c = 0; c < 2; ++c) {
      follow(2 * s.edge + c, 2 * s.as + c, s.factor);
    }
  }
  std::vector<bool> matched(enrichment.edges().edges.size(), false);
  for (const ClosedContactEdge& c : closed) {
    if (c.at->opposite) {
      // Normals and tangents of the two bodies look opposite ways.
      for (std::size_t k = 0; k < (c.bonded ? 2U : 1U); ++k) {
        follow(2 * *c.at->opposite + k, 2 * c.at->edge + k, -c.at->same_way);
      }
      matched[*c.at->opposite] = matched[c.at->edge] = true;
    }
  }
  std::vector<std::pair<std::size_t, double>> support;
  for (const ClosedContactEdge& c : closed) {
    if (!matched[c.at->edge] && c.loaded) {
      // The contact side follows this mode and resists: some part of the mode's own stiffness.
      support.emplace_back(2 * c.at->edge, c.support);
    } else if (!matched[c.at->edge]) {
      held[2 * c.at->edge] = true;
      if (c.bonded) {
        held[2 * c.at->edge + 1] = true;
      }
    }
  }
  ModeFreedomMap map;
  map.unknown.assign(count, -1);
  map.factor = std::move(factor);
  for (std::size_t i = 0; i < count; ++i) {
    if (as[i] == i && !held[i]) {
      map.unknown[i] = static_cast<std::int32_t>(map.unknowns++);
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (as[i] != i) {
      map.unknown[i] = held[i] ? -1 : map.unknown[as[i]];
    }
  }
  map.support = std::move(support);
  return map;
}

} // namespace spricka::estimate
