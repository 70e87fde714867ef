// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/rigid_bodies.hpp"

#include "grammar/lexeme.hpp"
#include "model/model.hpp"
#include "program/study/deck_edits.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

using deck::DeckCard;
using deck::DeckText;

class RigidMaker {
public:
  RigidMaker(const model::Model& model, const Joint& joint, const DeckText& steps)
      : model_(model), joint_(joint), given_(steps) {}

  // Bodies that are loaded stay, with a modulus that makes them rigid; others become targets.
  RigidBodyDeck run(DeckText text) const {
    std::string reason = "no body is there only to press";
    bool changed = stiffen(text);
    for (const JointContact& contact : joint_.contacts) {
      changed = put_target(text, contact, reason) || changed;
    }
    if (!changed) {
      return {std::nullopt, reason};
    }
    drop_undefined_loads(text);
    return {std::move(text), {}};
  }

private:
  // Bodies without a crack that carry the load into the others.
  [[nodiscard]] std::set<std::string> pins() const {
    std::set<std::string> pins;
    for (const JointContact& contact : joint_.contacts) {
      for (const std::string& net : {contact.slave.net, contact.master.net}) {
        const bool pressing = joint_.cracked.empty() || pressing_nets(joint_).contains(net);
        if (!net.empty() && pressing && joint_.loaded.contains(net) &&
            !joint_.cracked.contains(net) && !is_supported(net) && !joint_.heated.contains(net)) {
          pins.insert(net);
        }
      }
    }
    return pins;
  }

  // Held in every direction of the plane or of space somewhere.
  [[nodiscard]] bool is_supported(const std::string& net) const {
    std::array<bool, 3> held{false, false, false};
    for (const model::FreedomAssignment& freedom : model_.freedoms) {
      for (const base::NodeId n : model_.mesh.set_with_id(freedom.nodes).nodes) {
        const base::NetId own = model_.mesh.node_net[n.index()];
        const bool here = own.valid() && grammar::to_upper(model_.nets[own.index()].name) == net;
        for (std::size_t d = 0; d < 3 && here; ++d) {
          held.at(d) = held.at(d) || freedom.dof.at(d);
        }
      }
    }
    return held[0] && held[1];
  }

  bool stiffen(DeckText& text) const {
    constexpr const char* times = "1e4"; // pressures change by 1e-4 beyond it (benchmark C06)
    std::set<std::string> made;
    const std::set<std::string> stiff = pins();
    for (DeckCard& card : text) {
      if (card.name == "PROPERTY" && stiff.contains(net_prefix(*card.find("ESET")))) {
        made.insert(card.word_value("MATERIAL"));
        card.set("MATERIAL", card.word_value("MATERIAL") + "_RIGID");
      }
    }
    DeckText more;
    for (const DeckCard& card : text) {
      if (card.name == "MATERIAL" && made.contains(card.word_value("NAME"))) {
        DeckCard rigid = card;
        rigid.set("NAME", card.word_value("NAME") + "_RIGID");
        rigid.set("E", fmt::format("({}*{})", times, *card.find("E")));
        more.push_back(std::move(rigid));
      }
    }
    for (DeckCard& card : more) {
      append_card(text, std::move(card));
    }
    return !more.empty();
  }

  // Whether a net meets others in this contact alone, is not held, loaded, warmed or cracked.
  [[nodiscard]] bool only_presses(const std::string& net, const JointContact& in) const {
    const bool elsewhere = std::ranges::any_of(joint_.contacts, [&](const JointContact& other) {
      return other.name != in.name && (other.slave.net == net || other.master.net == net);
    });
    return !net.empty() && !elsewhere && !is_supported(net) && !joint_.loaded.contains(net) &&
           !joint_.heated.contains(net) && !joint_.cracked.contains(net);
  }

  // The body that stays is the one that is loaded, cracked or met by others, else the master's.
  bool put_target(DeckText& text, const JointContact& contact, std::string& reason) const {
    const bool slave = only_presses(contact.slave.net, contact);
    const bool master = only_presses(contact.master.net, contact);
    if (contact.rigid || contact.bonded || (!slave && !master)) {
      return false;
    }
    const std::optional<AnalyticalSurface> surface =
        fit_analytical_surface(model_, contact.name, slave);
    if (!surface) {
      reason = fmt::format("the surface of {} is neither straight nor round",
                           slave ? contact.slave.net : contact.master.net);
      return false;
    }
    const auto card = std::ranges::find_if(text, [&](const DeckCard& c) {
      return c.name == "CONTACT" && c.word_value("NAME") == contact.name;
    });
    if (card == text.end()) {
      return false;
    }
    const std::string other = *card->find(slave ? "MASTER" : "SLAVE");
    DeckCard replaced = *card;
    replaced.set("SLAVE", other);
    replaced.set("MASTER", contact.name + "_RIGID");
    replaced.erase("MULTIPLIER");
    remove_nets(text, {slave ? contact.slave.net : contact.master.net});
    append_card(text, target(contact.name + "_RIGID", *surface));
    append_card(text, std::move(replaced));
    put_back_fit(text, contact.name);
    return true;
  }

  // The contact went with its net, and its fit with it: as the deck has it.
  void put_back_fit(DeckText& text, const std::string& contact) const {
    for (DeckCard& card : text) {
      if (card.name != "STEP") {
        continue;
      }
      const auto own = std::ranges::find_if(given_, [&](const DeckCard& c) {
        return c.name == "STEP" && c.word_value("NAME") == card.word_value("NAME");
      });
      DeckCard lines = *own;
      filter_lines(lines, [&](const std::vector<std::string>& fields) {
        return grammar::to_upper(fields.front()) == "FIT" && fields.size() > 1 &&
               grammar::to_upper(fields[1]) == contact;
      });
      card.data += lines.data;
    }
  }

  // A body on the left of a LINE, outside or inside an ARC: the one that stays.
  [[nodiscard]] static DeckCard target(const std::string& name, const AnalyticalSurface& surface) {
    DeckCard card;
    card.name = "RIGID";
    card.set("NAME", name);
    card.set("SHAPE", surface.round ? "ARC" : "LINE");
    const bool turned = surface.body_left; // the body that goes was on the left
    const base::Vec3& first = turned ? surface.second : surface.first;
    const base::Vec3& second = turned ? surface.first : surface.second;
    card.set("X0", fmt::format("{:.12g}", first.x()));
    card.set("Y0", fmt::format("{:.12g}", first.y()));
    if (surface.round) {
      const double radius = surface.body_outside ? -surface.radius : surface.radius;
      card.set("X0", fmt::format("{:.12g}", surface.first.x()));
      card.set("Y0", fmt::format("{:.12g}", surface.first.y()));
      card.set("R", fmt::format("{:.12g}", radius));
    } else {
      card.set("X1", fmt::format("{:.12g}", second.x()));
      card.set("Y1", fmt::format("{:.12g}", second.y()));
    }
    return card;
  }

  const model::Model& model_;
  const Joint& joint_;
  const DeckText& given_;
};

} // namespace

RigidBodyDeck make_rigid(const model::Model& model, const Joint& joint, DeckText text,
                         const DeckText& steps) {
  return RigidMaker(model, joint, steps).run(std::move(text));
}

} // namespace spricka::program
