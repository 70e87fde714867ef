// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/bodies/condense_bodies.hpp"
#include "analysis/bodies/content_hash.hpp"
#include "analysis/scene/scene_ties.hpp"
#include "base/dense_solve.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace spricka::analysis {

namespace {

// A share of rest elements below which splitting a body does not pay.
constexpr double least_rest = 0.2;

std::vector<base::NodeId> nodes_of(const model::Mesh& mesh,
                                   const std::vector<base::ElementId>& elements) {
  std::vector<base::NodeId> nodes;
  for (const base::ElementId e : elements) {
    const std::span<const base::NodeId> own = mesh.element_nodes(e);
    nodes.insert(nodes.end(), own.begin(), own.end());
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

void make_node_external(const CondensationRequest& request, base::NodeId node,
                        std::vector<model::FreedomRole>& cls) {
  const auto dim = static_cast<std::size_t>(request.mesh.dim);
  for (std::size_t c = 0; c < dim; ++c) {
    make_freedom_external(dim * node.index() + c, *request.ties, cls);
  }
}

// A floating piece needs external freedoms on which its rigid modes differ: the first node, the one
// farthest from it, and in space the one farthest from their line.
void add_carriers(const CondensationRequest& request, const fe::Body& piece,
                  std::vector<model::FreedomRole>& cls) {
  const model::Mesh& mesh = request.mesh;
  const base::Vec3& a = mesh.x[piece.nodes.front().index()];
  const auto farthest = [&](const auto& distance) {
    return *std::max_element(piece.nodes.begin(), piece.nodes.end(),
                             [&](base::NodeId p, base::NodeId q) {
                               return distance(mesh.x[p.index()]) < distance(mesh.x[q.index()]);
                             });
  };
  make_node_external(request, piece.nodes.front(), cls);
  // Two nodes hold a body in the plane; in space it still turns about their line.
  base::Vec3 d = base::Vec3::Zero();
  for (int nodes = 1; nodes < mesh.dim; ++nodes) {
    const base::NodeId far = farthest(
        [&](const base::Vec3& x) { return d.isZero() ? (x - a).norm() : (x - a).cross(d).norm(); });
    make_node_external(request, far, cls);
    d = (mesh.x[far.index()] - a).normalized();
  }
}

// Whether the external freedoms of a body tell all its free modes apart.
bool externals_carry(const model::Mesh& mesh, const SubstructuredBody& body,
                     const std::vector<model::FreedomRole>& cls) {
  std::vector<Eigen::Index> external;
  for (const base::NodeId n : body.body.nodes) {
    for (int c = 0; c < mesh.dim; ++c) {
      const auto freedom = static_cast<Eigen::Index>(n.index()) * mesh.dim + c;
      if (cls[static_cast<std::size_t>(freedom)] == model::FreedomRole::external) {
        external.push_back(freedom);
      }
    }
  }
  base::Matrix modes(static_cast<Eigen::Index>(external.size()), body.free_rigid_modes.cols());
  for (std::size_t i = 0; i < external.size(); ++i) {
    modes.row(static_cast<Eigen::Index>(i)) = body.free_rigid_modes.row(external[i]);
  }
  if (modes.rows() < modes.cols()) {
    return false;
  }
  return base::column_rank(modes, 1e-6) == modes.cols();
}

// "LUG", "LUG/2" for a second piece of the same net, "COARSE+FINE" for nets tied together.
std::string body_name(const model::Model& model, const SubstructuredBody& body,
                      std::map<std::string, int>& seen) {
  std::vector<base::NetId> nets;
  for (const fe::Body& piece : body.pieces) {
    if (!piece.elements.empty()) {
      nets.push_back(piece.net);
    }
  }
  std::sort(nets.begin(), nets.end());
  nets.erase(std::unique(nets.begin(), nets.end()), nets.end());
  std::string name;
  for (const base::NetId net : nets) {
    const std::string& own = model.nets[net.index()].name;
    name += fmt::format("{}{}", name.empty() ? "" : "+", own.empty() ? "MODEL" : own);
  }
  const int piece = ++seen[name];
  return piece == 1 ? name : fmt::format("{}/{}", name, piece);
}

fe::Body union_of(const std::vector<fe::Body>& pieces) {
  fe::Body all = pieces.front();
  for (std::size_t p = 1; p < pieces.size(); ++p) {
    const fe::Body& piece = pieces[p];
    all.elements.insert(all.elements.end(), piece.elements.begin(), piece.elements.end());
    all.nodes.insert(all.nodes.end(), piece.nodes.begin(), piece.nodes.end());
  }
  std::sort(all.elements.begin(), all.elements.end());
  std::sort(all.nodes.begin(), all.nodes.end());
  return all;
}

bool have_dependent_freedom(const CondensationRequest& request,
                            const std::vector<base::ElementId>& elements) {
  const auto dim = static_cast<std::size_t>(request.mesh.dim);
  return std::ranges::any_of(nodes_of(request.mesh, elements), [&](base::NodeId n) {
    const auto first = request.cls.begin() + static_cast<std::ptrdiff_t>(dim * n.index());
    return std::find(first, first + static_cast<std::ptrdiff_t>(dim),
                     model::FreedomRole::dependent) != first + static_cast<std::ptrdiff_t>(dim);
  });
}

// Elements of a body that are condensed for themselves, by part; the others are the region's.
// Contact on unknowns of a part sees no ties there: with one a body that is not condensed is all
// region.
std::vector<std::vector<base::ElementId>>
parts_of(const CondensationRequest& request, const SubstructuredBody& body, bool uncondensed) {
  const model::Mesh& mesh = request.mesh;
  std::map<base::NetId, std::vector<base::ElementId>> by_net;
  std::map<base::NetId, bool> cut; // a crack's region takes some of its elements
  for (const base::ElementId e : body.body.elements) {
    const base::NetId net = mesh.element_net[e.index()];
    by_net[net].push_back(e);
    cut[net] = cut[net] || request.rest_element[e.index()];
  }
  std::vector<std::vector<base::ElementId>> parts;
  for (auto& [net, elements] : by_net) {
    const std::size_t count = elements.size();
    if (cut[net]) {
      std::erase_if(elements, [&](base::ElementId e) { return !request.rest_element[e.index()]; });
    }
    // A net that a crack cuts is split if enough of it stays; a whole net is a part if there are
    // others.
    const bool pays =
        cut[net] ? static_cast<double>(elements.size()) >= least_rest * static_cast<double>(count)
                 : by_net.size() > 1;
    const bool whole_body = by_net.size() == 1 && elements.size() == body.body.elements.size();
    if (pays && !whole_body && !(uncondensed && have_dependent_freedom(request, elements))) {
      parts.push_back(std::move(elements));
    }
  }
  return parts;
}

// Classes as a part sees them: what others share with it or tie to it is external, node by node, so
// that a node of the region has all its freedoms there.
std::vector<model::FreedomRole> classes_of_part(const CondensationRequest& request,
                                                const std::vector<base::NodeId>& nodes,
                                                const std::vector<bool>& shared,
                                                const std::vector<model::FreedomRole>& cls) {
  using model::FreedomRole;
  const auto dim = static_cast<std::size_t>(request.mesh.dim);
  std::vector<FreedomRole> own = cls;
  for (const base::NodeId n : nodes) {
    FreedomRole* const c = own.data() + dim * n.index();
    bool outside = shared[n.index()];
    for (std::size_t k = 0; k < dim; ++k) {
      outside = outside || c[k] == FreedomRole::external || c[k] == FreedomRole::dependent;
    }
    for (std::size_t k = 0; k < dim; ++k) {
      // A tie is a matter of the region: the part keeps its side of it as an external.
      if (c[k] == FreedomRole::dependent || (outside && c[k] == FreedomRole::local)) {
        c[k] = FreedomRole::external;
      }
    }
  }
  return own;
}

// Nodes that more than one of the element lists has, and masters of ties.
std::vector<bool> shared_nodes(const CondensationRequest& request,
                               const std::vector<std::vector<base::ElementId>>& lists) {
  const model::Mesh& mesh = request.mesh;
  std::vector<bool> shared(mesh.node_count(), false);
  std::vector<std::int32_t> owner(mesh.node_count(), -1);
  for (std::size_t l = 0; l < lists.size(); ++l) {
    for (const base::ElementId e : lists[l]) {
      for (const base::NodeId n : mesh.element_nodes(e)) {
        std::int32_t& who = owner[n.index()];
        shared[n.index()] = shared[n.index()] || (who >= 0 && who != static_cast<int>(l));
        who = static_cast<std::int32_t>(l);
      }
    }
  }
  for (const fe::ConstraintTransformation::DependentRow& row : request.ties->rows()) {
    for (const fe::FreedomTerm& t : row.terms) {
      shared[static_cast<std::size_t>(t.freedom / mesh.dim)] = true;
    }
  }
  return shared;
}

// Whether the rows themselves are eliminated with a body's factors, instead of all freedoms that
// they weigh. Nets that ties join are condensed to these.
bool stays_uncondensed(const CondensationRequest& request, const SubstructuredBody& body,
                       const std::vector<bool>& weighed) {
  const auto is_weighed = [&](base::NodeId n) { return weighed[n.index()]; };
  const auto net = [&](base::ElementId e) { return request.mesh.element_net[e.index()]; };
  const std::vector<base::ElementId>& elements = body.body.elements;
  return request.condensing == CondensationMode::automatic && request.mesh.dim == 3 &&
         std::ranges::any_of(body.body.nodes, is_weighed) &&
         std::ranges::all_of(elements,
                             [&](base::ElementId e) { return net(e) == net(elements.front()); });
}

// Nodes that contact rows weigh.
std::vector<bool> weighed_nodes(const CondensationRequest& request) {
  std::vector<bool> weighed(request.mesh.node_count(), false);
  for (const contact::ConstraintRow* row : request.rows) {
    for (const contact::RowEntry& entry : row->entries) {
      weighed[entry.node.index()] = true;
    }
  }
  return weighed;
}

// Externals of a body that stays uncondensed become locals; carriers hold it where it floats.
// Returns the freedoms that they were.
std::vector<std::int32_t> make_externals_local(const CondensationRequest& request,
                                               const SubstructuredBody& body,
                                               std::vector<model::FreedomRole>& cls) {
  std::vector<std::int32_t> freedoms;
  const int dim = request.mesh.dim;
  for (const base::NodeId n : body.body.nodes) {
    for (int c = 0; c < dim; ++c) {
      const auto freedom = static_cast<std::int32_t>(n.index()) * dim + c;
      model::FreedomRole& own = cls[static_cast<std::size_t>(freedom)];
      if (own == model::FreedomRole::external) {
        own = model::FreedomRole::local;
        freedoms.push_back(freedom);
      }
    }
  }
  if (body.free_rigid_modes.cols() > 0) {
    for (const fe::Body& piece : body.pieces) {
      add_carriers(request, piece, cls);
    }
  }
  return freedoms;
}

// Of the unknowns of a body, the locals of its parts and then those of its region, which are these
// freedoms.
std::vector<Eigen::Index> unknowns_of(const SubstructuredBody& body,
                                      const std::vector<std::int32_t>& freedoms) {
  std::vector<Eigen::Index> unknowns;
  for (const std::int32_t freedom : freedoms) {
    const auto f = static_cast<std::size_t>(freedom);
    Eigen::Index first = 0;
    Eigen::Index own = -1;
    for (const std::unique_ptr<Substructure>& part : body.parts) {
      const std::int32_t row = part->map.row[f];
      own = row >= 0 && row < part->map.locals ? first + row : own;
      first += part->map.locals;
    }
    unknowns.push_back(own >= 0 ? own : first + body.region.map.row[f]);
  }
  return unknowns;
}

void split(const CondensationRequest& request, SubstructuredBody& body,
           const std::vector<model::FreedomRole>& cls, bool uncondensed) {
  const model::Mesh& mesh = request.mesh;
  std::vector<std::vector<base::ElementId>> lists = parts_of(request, body, uncondensed);
  std::vector<base::NodeId> region_nodes = body.body.nodes;
  if (lists.empty()) {
    body.region.elements = body.body.elements;
  } else {
    std::vector<bool> in_part(mesh.element_count(), false);
    for (const auto& list : lists) {
      for (const base::ElementId e : list) {
        in_part[e.index()] = true;
      }
    }
    for (const base::ElementId e : body.body.elements) {
      if (!in_part[e.index()]) {
        body.region.elements.push_back(e);
      }
    }
    region_nodes = nodes_of(mesh, body.region.elements);
    for (const fe::Body& piece : body.pieces) {
      if (piece.elements.empty()) { // a node that only ties hold
        region_nodes.insert(region_nodes.end(), piece.nodes.begin(), piece.nodes.end());
      }
    }
    // Nodes between a part and the region are shared as well.
    lists.push_back(body.region.elements);
    const std::vector<bool> shared = shared_nodes(request, lists);
    lists.pop_back();
    for (auto& list : lists) {
      Substructure& part = *body.parts.emplace_back(std::make_unique<Substructure>());
      part.elements = std::move(list);
      const std::vector<base::NodeId> nodes = nodes_of(mesh, part.elements);
      part.map = fe::number_freedoms(mesh, nodes, classes_of_part(request, nodes, shared, cls));
      // The region's system also holds the external freedoms of its parts.
      for (std::size_t i = static_cast<std::size_t>(part.map.locals); i < part.map.freedom.size();
           ++i) {
        region_nodes.emplace_back(static_cast<std::size_t>(part.map.freedom[i] / mesh.dim));
      }
    }
    // Externals of neighbouring parts are the same nodes.
    std::sort(region_nodes.begin(), region_nodes.end());
    region_nodes.erase(std::unique(region_nodes.begin(), region_nodes.end()), region_nodes.end());
  }
  body.region.map = fe::number_freedoms(mesh, region_nodes, cls);
  if (!request.ties->rows().empty()) {
    body.region.map.ties = request.ties;
  }
}

} // namespace

std::vector<std::int32_t> SubstructuredBody::contact_freedoms() const {
  const std::vector<std::int32_t>& last = region.map.freedom;
  if (!is_uncondensed()) {
    return {last.begin() + region.map.locals, last.end()};
  }
  std::vector<std::int32_t> all;
  for (const std::unique_ptr<Substructure>& part : parts) {
    const std::vector<std::int32_t>& own = part->map.freedom;
    all.insert(all.end(), own.begin(), own.begin() + part->map.locals);
  }
  all.insert(all.end(), last.begin(), last.end());
  return all;
}

std::int64_t SubstructuredBody::contact_unknown_count() const {
  if (!is_uncondensed()) {
    return region.map.external_count();
  }
  std::int64_t count = region.map.size();
  for (const std::unique_ptr<Substructure>& part : parts) {
    count += part->map.locals;
  }
  return count;
}

std::vector<SubstructuredBody> partition_bodies(const CondensationRequest& request) {
  std::vector<model::FreedomRole> cls = request.cls;
  const model::Mesh& mesh = request.mesh;
  std::vector<std::vector<fe::Body>> joined =
      fe::join_tied_bodies(mesh, fe::find_bodies(mesh), *request.ties, cls);
  std::vector<SubstructuredBody> bodies(joined.size());
  const std::vector<bool> weighed = weighed_nodes(request);
  std::map<std::string, int> seen;
  for (std::size_t b = 0; b < joined.size(); ++b) {
    SubstructuredBody& body = bodies[b];
    body.pieces = std::move(joined[b]);
    body.body = union_of(body.pieces);
    body.name = body_name(request.model, body, seen);
    const base::Matrix modes = fe::rigid_modes(request.model, mesh, body.pieces);
    body.free_rigid_modes =
        modes * fe::free_rigid_modes(mesh, modes, body.pieces, *request.ties, cls);
    // Carriers become external before split() numbers any freedom.
    if (body.free_rigid_modes.cols() > 0 && !externals_carry(mesh, body, cls)) {
      for (const fe::Body& piece : body.pieces) {
        add_carriers(request, piece, cls);
      }
    }
    std::vector<std::int32_t> local;
    const bool uncondensed = stays_uncondensed(request, body, weighed);
    if (uncondensed) {
      local = make_externals_local(request, body, cls);
    }
    split(request, body, cls, uncondensed);
    body.region.weighed = unknowns_of(body, local);
  }
  return bodies;
}

std::vector<SubstructureHashes> hash_bodies(const CondensationRequest& request,
                                            const std::vector<SubstructuredBody>& bodies) {
  std::vector<SubstructureHashes> keys(bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    for (const std::unique_ptr<Substructure>& part : bodies[b].parts) {
      keys[b].parts.push_back(hash_substructure(request.model, request.mesh, *part, {}));
    }
    keys[b].region =
        hash_substructure(request.model, request.mesh, bodies[b].region, keys[b].parts);
  }
  return keys;
}

} // namespace spricka::analysis
