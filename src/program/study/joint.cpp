// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/joint.hpp"

#include "grammar/lexeme.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <map>

namespace spricka::program {

namespace {

std::string net_name(const model::Model& model, base::NetId net) {
  return net.valid() ? grammar::to_upper(model.nets[net.index()].name) : std::string();
}

// The one net of a surface; empty where there are several.
std::string net_of(const model::Model& model, base::FaceSetId set) {
  std::set<std::string> nets;
  for (const model::Face& face : model.mesh.set_with_id(set).faces) {
    nets.insert(net_name(model, model.mesh.element_net[face.element.index()]));
  }
  return nets.size() == 1 ? *nets.begin() : std::string();
}

void note_nets(const model::Model& model, const model::Load& load, std::set<std::string>& nets) {
  const model::Mesh& mesh = model.mesh;
  const auto note_element = [&](base::ElementId e) {
    nets.insert(net_name(model, mesh.element_net[e.index()]));
  };
  if (load.elements.valid()) {
    std::ranges::for_each(mesh.set_with_id(load.elements).elements, note_element);
  }
  if (load.faces.valid()) {
    std::ranges::for_each(mesh.set_with_id(load.faces).faces, note_element, &model::Face::element);
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

void note_supports(const model::Model& model, Joint& joint) {
  std::map<std::string, std::array<bool, 3>> held; // by net
  for (const model::FreedomAssignment& freedom : model.freedoms) {
    for (const base::NodeId n : model.mesh.set_with_id(freedom.nodes).nodes) {
      std::array<bool, 3>& own = held[net_name(model, model.mesh.node_net[n.index()])];
      std::ranges::transform(own, freedom.dof, own.begin(), std::logical_or<>());
      if (own[0] && own[1]) {
        joint.supported.insert(net_name(model, model.mesh.node_net[n.index()]));
      }
    }
  }
}

bool is_mounted(const model::Model& model, std::size_t contact) {
  const auto mounts = [&](const model::StepAction& action) {
    const auto* mount = std::get_if<model::MountContact>(&action);
    const auto* dismount = std::get_if<model::DismountContact>(&action);
    return (mount != nullptr && mount->contact.index() == contact) ||
           (dismount != nullptr && dismount->contact.index() == contact);
  };
  return std::ranges::any_of(model.steps, [&](const model::Step& step) {
    return std::ranges::any_of(step.actions, mounts);
  });
}

} // namespace

Joint analyse_joint(const model::Model& model) {
  Joint joint;
  note_cracks(model, joint);
  note_supports(model, joint);
  for (const model::LoadCase& load_case : model.cases) {
    for (const model::Load& load : load_case.loads) {
      const bool hot = load.type == model::LoadType::temperature;
      note_nets(model, load, hot ? joint.heated : joint.loaded);
    }
  }
  for (std::size_t c = 0; c < model.contacts.size(); ++c) {
    const model::Contact& contact = model.contacts[c];
    const bool rigid = !contact.master.valid();
    joint.contacts.push_back({.name = grammar::to_upper(contact.name),
                              .slave_net = net_of(model, contact.slave),
                              .master_net = rigid ? std::string() : net_of(model, contact.master),
                              .rigid = rigid,
                              .bonded = contact.type == model::ContactType::bonded,
                              .presses = contact.gap.value_or(0.0) < 0.0,
                              .mounted = is_mounted(model, c)});
    joint.friction = joint.friction || contact.mu > 0.0;
  }
  return joint;
}

std::set<std::string> find_pressing_nets(const Joint& joint) {
  std::set<std::string> reached = joint.cracked;
  for (std::size_t round = 0; round < joint.contacts.size(); ++round) {
    for (const JointContact& contact : joint.contacts) {
      if (contact.rigid || contact.slave_net.empty() || contact.master_net.empty()) {
        continue;
      }
      if (reached.contains(contact.slave_net) || reached.contains(contact.master_net)) {
        reached.insert(contact.slave_net);
        reached.insert(contact.master_net);
      }
    }
  }
  for (const std::string& net : joint.cracked) {
    reached.erase(net);
  }
  return reached;
}

} // namespace spricka::program
