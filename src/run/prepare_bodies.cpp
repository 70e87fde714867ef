// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/condense_bodies.hpp"
#include "run/content_hash.hpp"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace spricka::run {

namespace {

// A share of rest elements below which splitting a body does not pay.
constexpr double least_rest = 0.3;
std::vector<base::NodeId> nodes_of(const model::Mesh& mesh,
                                   const std::vector<base::ElementId>& elements) {
  std::vector<base::NodeId> nodes;
  for (const base::ElementId e : elements) {
    const std::span<const base::NodeId> own = mesh.nodes_of(e);
    nodes.insert(nodes.end(), own.begin(), own.end());
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

void make_external(const model::Mesh& mesh, base::NodeId node,
                   std::vector<model::FreedomClass>& cls) {
  for (std::size_t c = 0; c < static_cast<std::size_t>(mesh.dim); ++c) {
    model::FreedomClass& k = cls[static_cast<std::size_t>(mesh.dim) * node.index() + c];
    k = k == model::FreedomClass::local ? model::FreedomClass::external : k;
  }
}

// A floating body needs external freedoms on which its rigid modes differ: the first node, the one
// farthest from it, and in space the one farthest from their line.
void add_carriers(const model::Mesh& mesh, const fe::Body& body,
                  std::vector<model::FreedomClass>& cls) {
  const base::Vec3& a = mesh.x[body.nodes.front().index()];
  const auto farthest = [&](const auto& distance) {
    return *std::max_element(body.nodes.begin(), body.nodes.end(),
                             [&](base::NodeId p, base::NodeId q) {
                               return distance(mesh.x[p.index()]) < distance(mesh.x[q.index()]);
                             });
  };
  const base::NodeId far = farthest([&](const base::Vec3& x) { return (x - a).norm(); });
  make_external(mesh, body.nodes.front(), cls);
  make_external(mesh, far, cls);
  if (mesh.dim == 3) {
    const base::Vec3 d = (mesh.x[far.index()] - a).normalized();
    make_external(mesh, farthest([&](const base::Vec3& x) { return (x - a).cross(d).norm(); }),
                  cls);
  }
}

std::size_t external_nodes(const model::Mesh& mesh, const fe::Body& body,
                           const std::vector<model::FreedomClass>& cls) {
  const auto dim = static_cast<std::size_t>(mesh.dim);
  return static_cast<std::size_t>(
      std::count_if(body.nodes.begin(), body.nodes.end(), [&](base::NodeId n) {
        for (std::size_t c = 0; c < dim; ++c) {
          if (cls[dim * n.index() + c] != model::FreedomClass::external) {
            return false;
          }
        }
        return true;
      }));
}

// "LUG", or "LUG/2" for a second piece of the same net.
std::vector<std::string> body_names(const model::Model& model,
                                    const std::vector<fe::Body>& bodies) {
  std::vector<std::string> names;
  std::map<base::NetId, int> seen;
  for (const fe::Body& body : bodies) {
    const std::string& net = model.nets[body.net.index()].name;
    const int piece = ++seen[body.net];
    const std::string name = net.empty() ? "MODEL" : net;
    names.push_back(piece == 1 ? name : fmt::format("{}/{}", name, piece));
  }
  return names;
}

void split(const CondenseRequest& request, BodyNet& body,
           const std::vector<model::FreedomClass>& cls) {
  const model::Mesh& mesh = request.mesh;
  std::vector<base::ElementId> rest;
  for (const base::ElementId e : body.body.elements) {
    (request.rest_element[e.index()] ? rest : body.region.elements).push_back(e);
  }
  const auto count = static_cast<double>(body.body.elements.size());
  if (body.region.elements.empty() || static_cast<double>(rest.size()) < least_rest * count) {
    body.region.elements = body.body.elements;
    body.region.map = fe::number_freedoms(mesh, body.body.nodes, cls);
    return;
  }
  body.rest = std::make_unique<Net>();
  body.rest->elements = std::move(rest);
  const std::vector<base::NodeId> rest_nodes = nodes_of(mesh, body.rest->elements);
  std::vector<base::NodeId> region_nodes = nodes_of(mesh, body.region.elements);
  std::vector<model::FreedomClass> with_rim = cls;
  for (const base::NodeId n : rest_nodes) {
    if (std::binary_search(region_nodes.begin(), region_nodes.end(), n)) {
      make_external(mesh, n, with_rim);
    }
  }
  body.rest->map = fe::number_freedoms(mesh, rest_nodes, with_rim);
  // The region's system also holds the external freedoms of the rest.
  for (std::size_t i = static_cast<std::size_t>(body.rest->map.locals);
       i < body.rest->map.freedom.size(); ++i) {
    region_nodes.emplace_back(static_cast<std::size_t>(body.rest->map.freedom[i] / mesh.dim));
  }
  std::sort(region_nodes.begin(), region_nodes.end());
  region_nodes.erase(std::unique(region_nodes.begin(), region_nodes.end()), region_nodes.end());
  body.region.map = fe::number_freedoms(mesh, region_nodes, cls);
}

} // namespace

std::vector<BodyNet> prepare_bodies(const CondenseRequest& request) {
  std::vector<model::FreedomClass> cls = request.cls;
  const model::Mesh& mesh = request.mesh;
  const std::vector<fe::Body> found = fe::find_bodies(mesh);
  const std::vector<std::string> names = body_names(request.model, found);
  std::vector<BodyNet> bodies(found.size());
  for (std::size_t b = 0; b < found.size(); ++b) {
    BodyNet& body = bodies[b];
    body.name = names[b];
    body.body = found[b];
    const base::Matrix modes = fe::rigid_modes(mesh, body.body.nodes);
    const base::Matrix free = fe::free_modes(mesh, modes, body.body.nodes, cls);
    body.free_modes = modes * free;
    const std::size_t wanted = mesh.dim == 2 ? 2 : 3;
    if (free.cols() > 0 && external_nodes(mesh, body.body, cls) < wanted) {
      add_carriers(mesh, body.body, cls);
    }
    split(request, body, cls);
  }
  return bodies;
}

std::vector<NetKeys> hash_bodies(const CondenseRequest& request,
                                 const std::vector<BodyNet>& bodies) {
  std::vector<NetKeys> keys(bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    std::vector<HashKey> parts;
    if (bodies[b].rest) {
      keys[b].rest = hash_net(request.model, request.mesh, *bodies[b].rest, {});
      parts.push_back(*keys[b].rest);
    }
    keys[b].region = hash_net(request.model, request.mesh, bodies[b].region, parts);
  }
  return keys;
}

} // namespace spricka::run
