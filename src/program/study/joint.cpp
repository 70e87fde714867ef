// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/joint.hpp"

#include "grammar/lexeme.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::program {

namespace {

std::string net_name(const model::Model& model, base::NetId net) {
  return net.valid() ? grammar::to_upper(model.nets[net.index()].name) : std::string();
}

std::string net_of(const model::Model& model, base::FaceSetId set) {
  std::string name;
  bool first = true;
  for (const model::Face& face : model.mesh.set_with_id(set).faces) {
    const std::string own = net_name(model, model.mesh.element_net[face.element.index()]);
    if (!first && own != name) {
      return {};
    }
    name = own;
    first = false;
  }
  return name;
}

void note_nets(const model::Model& model, const model::Load& load, std::set<std::string>& nets) {
  const model::Mesh& mesh = model.mesh;
  if (load.elements.valid()) {
    for (const base::ElementId e : mesh.set_with_id(load.elements).elements) {
      nets.insert(net_name(model, mesh.element_net[e.index()]));
    }
  }
  if (load.faces.valid()) {
    for (const model::Face& face : mesh.set_with_id(load.faces).faces) {
      nets.insert(net_name(model, mesh.element_net[face.element.index()]));
    }
  }
  if (load.nodes.valid()) {
    for (const base::NodeId n : mesh.set_with_id(load.nodes).nodes) {
      nets.insert(net_name(model, mesh.node_net[n.index()]));
    }
  }
}

void note_cracks(const model::Model& model, Joint& joint) {
  for (const model::CrackDefinition& crack : model.cracks) {
    joint.friction = joint.friction || crack.mu > 0.0;
    if (crack.net.valid()) {
      joint.cracked.insert(net_name(model, crack.net));
    }
    if (crack.path.valid()) {
      for (const base::NodeId n : model.mesh.set_with_id(crack.path).nodes) {
        joint.cracked.insert(net_name(model, model.mesh.node_net[n.index()]));
      }
    }
  }
}

bool is_mounted(const model::Model& model, std::size_t contact) {
  return std::ranges::any_of(model.steps, [&](const model::Step& step) {
    return std::ranges::any_of(step.actions, [&](const model::Action& action) {
      const auto* mount = std::get_if<model::MountContact>(&action);
      const auto* dismount = std::get_if<model::DismountContact>(&action);
      return (mount != nullptr && mount->contact.index() == contact) ||
             (dismount != nullptr && dismount->contact.index() == contact);
    });
  });
}

// Nodes of a surface, and the middle of the elements behind it.
struct JointSurfaceNodes {
  std::vector<base::Vec3> x;
  base::Vec3 behind = base::Vec3::Zero();
};

JointSurfaceNodes nodes_of(const model::Mesh& mesh, const model::FaceSet& set) {
  JointSurfaceNodes nodes;
  std::set<base::NodeId> seen;
  double count = 0.0;
  for (const model::Face& face : set.faces) {
    const auto all = mesh.element_nodes(face.element);
    const auto corners =
        static_cast<std::size_t>(base::element_info(mesh.type[face.element.index()]).corners);
    const auto side = static_cast<std::size_t>(face.side);
    for (const std::size_t corner : {side, (side + 1) % corners}) {
      if (seen.insert(all[corner]).second) {
        nodes.x.push_back(mesh.x[all[corner].index()]);
      }
    }
    for (std::size_t c = 0; c < corners; ++c) {
      nodes.behind += mesh.x[all[c].index()];
      count += 1.0;
    }
  }
  nodes.behind /= std::max(count, 1.0);
  return nodes;
}

double cross(const base::Vec3& a, const base::Vec3& b) {
  return a.x() * b.y() - a.y() * b.x();
}

std::optional<AnalyticalSurface> straight(const JointSurfaceNodes& nodes) {
  AnalyticalSurface line;
  line.first = nodes.x.front();
  const auto far = std::ranges::max_element(
      nodes.x, {}, [&](const base::Vec3& x) { return (x - line.first).squaredNorm(); });
  line.second = *far;
  line.first = *std::ranges::max_element(
      nodes.x, {}, [&](const base::Vec3& x) { return (x - line.second).squaredNorm(); });
  const base::Vec3 along = line.second - line.first;
  constexpr double bent = 1e-6; // of its length
  for (const base::Vec3& x : nodes.x) {
    if (std::abs(cross(along, x - line.first)) > bent * along.squaredNorm()) {
      return std::nullopt;
    }
  }
  line.body_left = cross(along, nodes.behind - line.first) > 0.0;
  return line;
}

std::optional<AnalyticalSurface> round(const JointSurfaceNodes& nodes) {
  const std::size_t n = nodes.x.size();
  const base::Vec3& a = nodes.x[0];
  const base::Vec3& b = nodes.x[n / 3];
  const base::Vec3& c = nodes.x[2 * n / 3];
  const double area = 2.0 * cross(b - a, c - a);
  if (n < 5 || std::abs(area) < 1e-9 * (b - a).squaredNorm()) {
    return std::nullopt;
  }
  const double bb = (b - a).squaredNorm();
  const double cc = (c - a).squaredNorm();
  AnalyticalSurface circle;
  circle.round = true;
  circle.first = a + base::Vec3(((c - a).y() * bb - (b - a).y() * cc) / area,
                                ((b - a).x() * cc - (c - a).x() * bb) / area, 0.0);
  circle.radius = (a - circle.first).norm();
  constexpr double uneven = 1e-5; // of the radius
  for (const base::Vec3& x : nodes.x) {
    const double distance = (x - circle.first).norm();
    if (std::abs(distance - circle.radius) > uneven * circle.radius) {
      return std::nullopt;
    }
  }
  return circle;
}

// Whether the body of a round surface lies outside it: its elements do, one by one.
bool lies_outside(const model::Mesh& mesh, const model::FaceSet& set,
                  const AnalyticalSurface& circle) {
  const base::ElementId e = set.faces.front().element;
  const auto corners = static_cast<std::size_t>(base::element_info(mesh.type[e.index()]).corners);
  double farthest = 0.0;
  for (std::size_t c = 0; c < corners; ++c) {
    farthest = std::max(farthest, (mesh.x[mesh.element_nodes(e)[c].index()] - circle.first).norm());
  }
  return farthest > circle.radius * (1.0 + 1e-6);
}

} // namespace

Joint analyse_joint(const model::Model& model) {
  Joint joint;
  note_cracks(model, joint);
  for (const model::LoadCase& load_case : model.cases) {
    for (const model::Load& load : load_case.loads) {
      const bool hot = load.type == model::LoadType::temperature;
      note_nets(model, load, hot ? joint.heated : joint.loaded);
    }
  }
  for (std::size_t c = 0; c < model.contacts.size(); ++c) {
    const model::Contact& contact = model.contacts[c];
    JointContact found;
    found.name = grammar::to_upper(contact.name);
    found.slave.net = net_of(model, contact.slave);
    found.rigid = !contact.master.valid();
    found.master.net = found.rigid ? std::string() : net_of(model, contact.master);
    found.bonded = contact.type == model::ContactType::bonded;
    found.rubs = contact.mu > 0.0;
    found.given_gap = contact.gap.has_value();
    found.presses = contact.gap.value_or(0.0) < 0.0;
    found.mounted = is_mounted(model, c);
    joint.friction = joint.friction || found.rubs;
    joint.contacts.push_back(std::move(found));
  }
  return joint;
}

std::set<std::string> pressing_nets(const Joint& joint) {
  std::set<std::string> reached = joint.cracked;
  for (std::size_t round = 0; round < joint.contacts.size(); ++round) {
    for (const JointContact& contact : joint.contacts) {
      if (contact.rigid || contact.slave.net.empty() || contact.master.net.empty()) {
        continue;
      }
      if (reached.contains(contact.slave.net) || reached.contains(contact.master.net)) {
        reached.insert(contact.slave.net);
        reached.insert(contact.master.net);
      }
    }
  }
  for (const std::string& net : joint.cracked) {
    reached.erase(net);
  }
  return reached;
}

std::optional<AnalyticalSurface> fit_analytical_surface(const model::Model& model,
                                                        const std::string& contact, bool slave) {
  const auto found = std::ranges::find_if(model.contacts, [&](const model::Contact& c) {
    return grammar::to_upper(c.name) == contact;
  });
  if (model.mesh.dim != 2 || found == model.contacts.end()) {
    return std::nullopt;
  }
  const base::FaceSetId id = slave ? found->slave : found->master;
  if (!id.valid() || model.mesh.set_with_id(id).faces.empty()) {
    return std::nullopt;
  }
  const model::FaceSet& set = model.mesh.set_with_id(id);
  const JointSurfaceNodes nodes = nodes_of(model.mesh, set);
  if (std::optional<AnalyticalSurface> line = straight(nodes)) {
    return line;
  }
  std::optional<AnalyticalSurface> circle = round(nodes);
  if (circle) {
    circle->body_outside = lies_outside(model.mesh, set, *circle);
  }
  return circle;
}

} // namespace spricka::program
