// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/joint.hpp"

#include "geometry/circle_fit.hpp"
#include "geometry/element_side.hpp"
#include "grammar/lexeme.hpp"
#include "model/mesh_side.hpp"
#include "model/model.hpp"
#include "program/study/deck_edits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include <fmt/format.h>

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
  for (const model::NodeSetFreedomRole& freedom : model.freedoms) {
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

std::set<std::string> find_only_pressing_nets(const Joint& joint) {
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

namespace {

using deck::DeckCard;
using deck::DeckCardList;

// Corners of edges: nodes between them need not lie on an arc.
std::vector<base::Vec3> corners(const std::vector<geometry::ElementSide>& edges) {
  std::vector<base::Vec3> all;
  for (const geometry::ElementSide& edge : edges) {
    all.emplace_back(edge.X.col(0));
    all.emplace_back(edge.X.col(1));
  }
  return all;
}

// The line of straight edges with the bodies of others on its left.
std::optional<DeckCard> line_of(const std::string& name,
                                const std::vector<geometry::ElementSide>& edges) {
  const std::vector<base::Vec3> nodes = corners(edges);
  const auto farthest_from = [&](const base::Vec3& end) {
    return *std::ranges::max_element(nodes, {},
                                     [&](const base::Vec3& x) { return (x - end).squaredNorm(); });
  };
  const base::Vec3 second = farthest_from(nodes.front());
  const base::Vec3 first = farthest_from(second);
  const base::Vec3 along = second - first;
  constexpr double bent = 1e-6; // of its length
  for (const base::Vec3& x : nodes) {
    if (along.cross(x - first).norm() > bent * along.squaredNorm()) {
      return std::nullopt;
    }
  }
  // Edges run with their own body on the left, which goes.
  return along.dot(nodes[1] - nodes[0]) > 0.0 ? make_rigid_line_card(name, second, first)
                                              : make_rigid_line_card(name, first, second);
}

// The circle of round edges with the bodies of others on the side where theirs was not.
std::optional<DeckCard> circle_of(const std::string& name,
                                  const std::vector<geometry::ElementSide>& edges) {
  std::vector<geometry::WeightedPoint> points;
  for (const base::Vec3& x : corners(edges)) {
    points.push_back({x.head<2>(), 1.0});
  }
  const geometry::FittedCircle circle = geometry::fit_circle(points);
  constexpr std::size_t fewest = 4; // edges
  constexpr double uneven = 1e-5;   // of the radius
  const bool on_it = std::ranges::all_of(points, [&](const geometry::WeightedPoint& point) {
    return std::abs((point.x - circle.centre).norm() - circle.radius) <= uneven * circle.radius;
  });
  if (edges.size() < fewest || !on_it) {
    return std::nullopt;
  }
  const base::Vec3 centre(circle.centre.x(), circle.centre.y(), 0.0);
  double inward = 0.0; // outer normals of a body outside point to the centre
  for (const geometry::ElementSide& edge : edges) {
    inward += edge.area_vector(base::Vec2::Zero()).dot(centre - edge.X.col(0));
  }
  return make_rigid_circle_card(name, centre, inward > 0.0 ? -circle.radius : circle.radius);
}

// The rigid target that stands for the surface of a contact's (upper case) slave or master; empty
// for surfaces that are neither straight nor round, and in space.
std::optional<DeckCard> target_of(const model::Model& model, const std::string& contact, bool slave,
                                  const std::string& name) {
  const auto found = std::ranges::find_if(model.contacts, [&](const model::Contact& c) {
    return grammar::to_upper(c.name) == contact;
  });
  std::vector<geometry::ElementSide> edges;
  if (model.mesh.dim == 2 && found != model.contacts.end()) {
    const base::FaceSetId id = slave ? found->slave : found->master;
    for (const model::Face& face :
         id.valid() ? model.mesh.set_with_id(id).faces : std::vector<model::Face>()) {
      edges.push_back(model::element_side(model.mesh, face));
    }
  }
  if (edges.empty()) {
    return std::nullopt;
  }
  const std::optional<DeckCard> line = line_of(name, edges);
  return line ? line : circle_of(name, edges);
}

class RigidMaker {
public:
  RigidMaker(const model::Model& model, const Joint& joint, const DeckCardList& steps)
      : model_(model), joint_(joint), given_(steps) {}

  // Bodies that are loaded stay, with a modulus that makes them rigid; others become targets.
  DeckVariant run(DeckCardList text) const {
    std::string reason = "no body is there only to press";
    bool changed = stiffen(text);
    for (const JointContact& contact : joint_.contacts) {
      changed = put_target(text, contact, reason) || changed;
    }
    if (!changed) {
      return make_refused_variant(reason);
    }
    drop_undefined_loads(text);
    return {.text = std::move(text)};
  }

private:
  // Not held, warmed or cracked.
  [[nodiscard]] bool is_free(const std::string& net) const {
    return !net.empty() && !joint_.supported.contains(net) && !joint_.heated.contains(net) &&
           !joint_.cracked.contains(net);
  }

  // Bodies without a crack that carry the load into the others.
  [[nodiscard]] std::set<std::string> pins() const {
    const std::set<std::string> pressing = find_only_pressing_nets(joint_);
    std::set<std::string> pins;
    for (const JointContact& contact : joint_.contacts) {
      for (const std::string& net : {contact.slave_net, contact.master_net}) {
        if (is_free(net) && joint_.loaded.contains(net) &&
            (joint_.cracked.empty() || pressing.contains(net))) {
          pins.insert(net);
        }
      }
    }
    return pins;
  }

  bool stiffen(DeckCardList& text) const {
    constexpr const char* times = "1e4"; // pressures change by 1e-4 beyond it (benchmark C06)
    std::set<std::string> made;
    const std::set<std::string> stiff = pins();
    for (DeckCard& card : cards_named(text, "PROPERTY")) {
      if (stiff.contains(net_prefix(*card.find("ESET")))) {
        made.insert(card.word_value("MATERIAL"));
        card.set_key("MATERIAL", card.word_value("MATERIAL") + "_RIGID");
      }
    }
    for (const std::string& name : made) {
      DeckCard card = *find_card_with_key_value(text, "MATERIAL", "NAME", name);
      card.set_key("NAME", name + "_RIGID");
      card.set_key("E", fmt::format("({}*{})", times, *card.find("E")));
      append_card(text, std::move(card));
    }
    return !made.empty();
  }

  // Whether a net meets others in this contact alone, and is not loaded either.
  [[nodiscard]] bool only_presses(const std::string& net, const JointContact& in) const {
    return is_free(net) && !joint_.loaded.contains(net) &&
           std::ranges::none_of(joint_.contacts, [&](const JointContact& other) {
             return other.name != in.name && (other.slave_net == net || other.master_net == net);
           });
  }

  // The body that stays is the one that is loaded, cracked or met by others, else the master's.
  bool put_target(DeckCardList& text, const JointContact& contact, std::string& reason) const {
    const bool slave = only_presses(contact.slave_net, contact);
    const bool master = only_presses(contact.master_net, contact);
    if (contact.rigid || contact.bonded || (!slave && !master)) {
      return false;
    }
    const std::string target = contact.name + "_RIGID";
    const std::optional<DeckCard> surface = target_of(model_, contact.name, slave, target);
    if (!surface) {
      reason = fmt::format("the surface of {} is neither straight nor round",
                           slave ? contact.slave_net : contact.master_net);
      return false;
    }
    const DeckCard* const card = find_card_with_key_value(text, "CONTACT", "NAME", contact.name);
    if (card == nullptr) {
      return false;
    }
    const std::string other = *card->find(slave ? "MASTER" : "SLAVE");
    DeckCard replaced = *card;
    replaced.set_key("SLAVE", other);
    replaced.set_key("MASTER", target);
    replaced.erase("MULTIPLIER");
    remove_nets_with_dependents(text, {slave ? contact.slave_net : contact.master_net});
    append_card(text, *surface);
    append_card(text, std::move(replaced));
    put_back_fit(text, contact.name);
    return true;
  }

  // The contact went with its net, and its fit with it: as the deck has it.
  void put_back_fit(DeckCardList& text, const std::string& contact) const {
    DeckCardList fits = given_;
    filter_step_actions(fits, [&](const std::string& action, const std::string& name) {
      return action == "FIT" && name == contact;
    });
    for (DeckCard& card : cards_named(text, "STEP")) {
      card.data += find_card_with_key_value(fits, "STEP", "NAME", card.word_value("NAME"))->data;
    }
  }

  const model::Model& model_;
  const Joint& joint_;
  const DeckCardList& given_;
};

} // namespace

DeckVariant make_pressing_bodies_rigid(const model::Model& model, const Joint& joint,
                                       DeckCardList text, const DeckCardList& steps) {
  return RigidMaker(model, joint, steps).run(std::move(text));
}

} // namespace spricka::program
