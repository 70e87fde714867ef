// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/model_variants.hpp"

#include "grammar/lexeme.hpp"
#include "model/model.hpp"
#include "program/study/deck_edits.hpp"
#include "program/study/halves.hpp"
#include "program/study/rigid_bodies.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

using deck::DeckCard;
using deck::DeckText;

/// A text, or why there is none.
struct Made {
  std::optional<DeckText> text;
  std::string reason;
  std::optional<SectionMapping> section = {};
};

Made no_place(std::string reason) {
  return {std::nullopt, std::move(reason)};
}

std::string file_name(const std::string& name) {
  std::string file;
  for (const char c : name) {
    file += c == ' ' ? '_' : c;
  }
  return file + ".deck";
}

void drop_friction(DeckText& text) {
  for (DeckCard& card : text) {
    if (card.name == "CONTACT" || card.name == "CRACK") {
      card.erase("MU");
    } else if (card.name == "STEP") {
      card.erase("SUBSTEPS");
    } else if (card.name == "GROW") {
      card.erase("HISTORY");
    }
  }
}

void drop_interference(DeckText& text, const Joint& joint) {
  std::set<std::string> pressing;
  for (const JointContact& contact : joint.contacts) {
    if (contact.presses) {
      pressing.insert(contact.name);
    }
  }
  for (DeckCard& card : text) {
    if (card.name == "CONTACT" && pressing.contains(card.word_value("NAME"))) {
      card.erase("INTERFERENCE");
      card.erase("DIAMETRAL");
      card.set("GAP", "0");
    }
  }
  drop_fits(text, pressing);
}

// Clearances are closed as well: a bonded pair that starts apart would be pulled together.
void bond(DeckText& text, bool keep_fits) {
  std::set<std::string> all;
  for (DeckCard& card : text) {
    if (card.name != "CONTACT") {
      continue;
    }
    card.set("TYPE", "BONDED");
    card.erase("MU");
    if (!keep_fits) {
      card.erase("INTERFERENCE");
      card.erase("DIAMETRAL");
      card.set("GAP", "0");
      all.insert(card.word_value("NAME"));
    }
  }
  if (!keep_fits) {
    drop_fits(text, all);
  }
}

class VariantMaker {
public:
  VariantMaker(const StudiedDeck& deck, const Joint& joint)
      : model_(*deck.ready->model), joint_(joint), given_(deck.text) {
    drop_requests(given_);
    apply_defines(given_, deck.defines);
    smooth_ = given_;
    drop_friction(smooth_);
    at_once_ = smooth_;
    drop_mounts(at_once_);
  }

  std::vector<ModelVariant> run() {
    add("as given", "the deck itself", {given_, {}});
    add_part();
    add("without friction", "all surfaces are smooth", friction());
    add("all at once", "nothing is mounted later, all stands from the beginning", mounting());
    add("bonded with its fits", "contacts can neither open nor slip; interferences press", fits());
    add("without interference", "all fits are net", interference());
    add("bonded", "contacts can neither open nor slip; all fits are net", bonding());
    add("rigid pressing body", "what only presses is rigid", rigid());
    add("cosine pressure", "a cosine pressure in place of what presses", bearing("COSINE"));
    add("uniform pressure", "a uniform pressure in place of what presses", bearing("UNIFORM"));
    if (model_.mesh.dim == 3) {
      add("axisymmetric", "the section of round bodies", section("AXI"));
      add("plane strain", "the section of the bodies in plane strain", section("STRAIN"));
      add("plane stress", "the section of the bodies in plane stress", section("STRESS"));
    } else {
      add("plane strain", "plane strain in place of plane stress", state("STRESS", "STRAIN"));
      add("plane stress", "plane stress in place of plane strain", state("STRAIN", "STRESS"));
    }
    return std::move(variants_);
  }

private:
  void add(const std::string& name, const std::string& words, Made made) {
    ModelVariant& variant = variants_.emplace_back();
    variant.name = name;
    variant.file = file_name(name);
    variant.words = words;
    variant.text = std::move(made.text);
    variant.section = std::move(made.section);
    variant.simpler = variant.section || !name.starts_with("plane");
    variant.reason = std::move(made.reason);
  }

  void add_part() {
    SymmetricPart part = reduce_by_symmetry(model_, given_);
    add(part.name, part.words, {std::move(part.text), std::move(part.reason)});
    variants_.back().mirrored = part.mirrored;
  }

  [[nodiscard]] bool any(bool JointContact::*what) const {
    return std::ranges::any_of(joint_.contacts,
                               [&](const JointContact& contact) { return contact.*what; });
  }

  [[nodiscard]] Made friction() const {
    return joint_.friction ? Made{smooth_, {}} : no_place("nothing rubs");
  }

  [[nodiscard]] Made mounting() const {
    return any(&JointContact::mounted) ? Made{at_once_, {}} : no_place("nothing is mounted later");
  }

  [[nodiscard]] Made interference() const {
    if (!any(&JointContact::presses)) {
      return no_place("no contact has an interference");
    }
    DeckText text = at_once_;
    drop_interference(text, joint_);
    return {std::move(text), {}};
  }

  [[nodiscard]] bool can_bond() const {
    return std::ranges::any_of(joint_.contacts, [](const JointContact& contact) {
      return !contact.bonded && !contact.rigid;
    });
  }

  [[nodiscard]] Made fits() const {
    if (!any(&JointContact::presses)) {
      return no_place("no contact has an interference");
    }
    if (!can_bond()) {
      return no_place("all contacts are bonded");
    }
    DeckText text = at_once_;
    bond(text, true);
    return {std::move(text), {}};
  }

  [[nodiscard]] Made bonding() const {
    if (joint_.contacts.empty()) {
      return no_place("there is no contact");
    }
    if (!can_bond() && !any(&JointContact::presses) && !any(&JointContact::mounted)) {
      return no_place("all contacts are bonded");
    }
    DeckText text = at_once_;
    bond(text, false);
    return {std::move(text), {}};
  }

  [[nodiscard]] Made rigid() const {
    RigidBodyDeck made = make_rigid(model_, joint_, at_once_, given_);
    return {std::move(made.text), std::move(made.reason)};
  }

  [[nodiscard]] Made bearing(const char* shape) const {
    const std::set<std::string> nets = pressing_nets(joint_);
    if (nets.empty()) {
      return no_place(joint_.cracked.empty() ? "without a crack there is no body to keep"
                                             : "no body presses on that with the crack");
    }
    std::string surface;
    DeckText text = at_once_;
    for (const DeckCard& card : text) {
      const bool contact = card.name == "CONTACT";
      const std::string slave = contact ? net_prefix(*card.find("SLAVE")) : std::string();
      const std::string master = contact ? net_prefix(*card.find("MASTER")) : std::string();
      if (contact && nets.contains(slave) != nets.contains(master)) {
        if (!surface.empty()) {
          return no_place("bodies press on more than one surface");
        }
        surface = *card.find(nets.contains(slave) ? "MASTER" : "SLAVE");
      }
    }
    if (surface.empty()) {
      return no_place("the surface that is pressed on belongs to no net of its own");
    }
    std::vector<DeckCard> loads;
    if (const std::string reason = bearing_loads(nets, surface, shape, loads); !reason.empty()) {
      return no_place(reason);
    }
    remove_nets(text, nets);
    for (DeckCard& load : loads) {
      append_card(text, std::move(load));
    }
    drop_undefined_loads(text);
    return {std::move(text), {}};
  }

  // One load for each case that presses; why not, in words.
  [[nodiscard]] std::string bearing_loads(const std::set<std::string>& nets,
                                          const std::string& surface, const char* shape,
                                          std::vector<DeckCard>& loads) const {
    for (DeckCard card : at_once_) {
      if (card.name != "LOAD") {
        continue;
      }
      std::vector<std::vector<std::string>> lines;
      filter_lines(card, [&](const std::vector<std::string>& fields) {
        if (nets.contains(net_prefix(fields.front()))) {
          lines.push_back(fields);
        }
        return true;
      });
      if (lines.empty()) {
        continue;
      }
      if (card.word_value("TYPE") != "RESULTANT" || lines.size() > 1) {
        return "the load of what presses is no single RESULTANT";
      }
      DeckCard load;
      load.name = "LOAD";
      load.set("CASE", *card.find("CASE"));
      load.set("TYPE", "BEARING");
      load.set("SHAPE", shape);
      load.data = "  " + surface;
      for (std::size_t i = 1; i < lines.front().size(); ++i) {
        load.data += "  " + lines.front()[i];
      }
      load.data += "\n";
      loads.push_back(std::move(load));
    }
    return loads.empty() ? "what presses is not loaded" : "";
  }

  [[nodiscard]] Made section(const char* state) const {
    SectionDeck made = section_deck(model_, given_, state);
    return made.text ? Made{std::move(made.text), {}, std::move(made.view)}
                     : no_place(std::move(made.reason));
  }

  [[nodiscard]] Made state(const std::string& from, const std::string& to) const {
    DeckText text = given_;
    bool changed = false;
    for (DeckCard& card : text) {
      if (card.name == "PROPERTY" && card.word_value("STATE") == from) {
        card.set("STATE", to);
        changed = true;
      } else if (card.name == "CRACK" && card.word_value("STATE") == from) {
        card.set("STATE", to);
      }
    }
    return changed ? Made{std::move(text), {}}
                   : no_place(fmt::format("no body is in plane {}",
                                          from == "STRESS" ? "stress" : "strain"));
  }

  const model::Model& model_;
  const Joint& joint_;
  DeckText given_;
  DeckText smooth_;
  DeckText at_once_;
  std::vector<ModelVariant> variants_;
};

} // namespace

std::vector<ModelVariant> make_variants(const StudiedDeck& deck, const Joint& joint) {
  return VariantMaker(deck, joint).run();
}

} // namespace spricka::program
