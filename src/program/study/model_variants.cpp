// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/model_variants.hpp"

#include "grammar/lexeme.hpp"
#include "model/model.hpp"
#include "program/study/halves.hpp"
#include "program/study/rigid_bodies.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

using deck::DeckCard;
using deck::DeckText;

RewrittenDeck no_place(std::string reason) {
  return {std::nullopt, std::move(reason)};
}

void drop_friction(DeckText& text) {
  constexpr std::array keys{std::pair{"CONTACT", "MU"}, std::pair{"CRACK", "MU"},
                            std::pair{"STEP", "SUBSTEPS"}, std::pair{"GROW", "HISTORY"}};
  for (const auto& [name, key] : keys) {
    for (DeckCard& card : cards_named(text, name)) {
      card.erase(key);
    }
  }
}

// Contacts of these names (upper case) are net: neither fits nor clearances.
void make_net(DeckText& text, const std::set<std::string>& contacts) {
  for (DeckCard& card : cards_named(text, "CONTACT")) {
    if (contacts.contains(card.word_value("NAME"))) {
      card.erase("INTERFERENCE");
      card.erase("DIAMETRAL");
      card.set("GAP", "0");
    }
  }
  drop_fits(text, contacts);
}

// Clearances are closed as well: a bonded pair that starts apart would be pulled together.
void bond(DeckText& text, bool keep_fits) {
  std::set<std::string> all;
  for (DeckCard& card : cards_named(text, "CONTACT")) {
    card.set("TYPE", "BONDED");
    card.erase("MU");
    all.insert(card.word_value("NAME"));
  }
  if (!keep_fits) {
    make_net(text, all);
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
      add_section("axisymmetric", "the section of round bodies", "AXI");
      add_section("plane strain", "the section of the bodies in plane strain", "STRAIN");
      add_section("plane stress", "the section of the bodies in plane stress", "STRESS");
    } else {
      add("plane strain", "plane strain in place of plane stress", state("STRESS", "STRAIN"));
      add("plane stress", "plane stress in place of plane strain", state("STRAIN", "STRESS"));
    }
    return std::move(variants_);
  }

private:
  void add(const std::string& name, const std::string& words, RewrittenDeck made,
           const std::optional<SectionMapping>& section = {}) {
    ModelVariant& variant = variants_.emplace_back();
    static_cast<RewrittenDeck&>(variant) = std::move(made);
    variant.name = name;
    variant.file = name + ".deck";
    std::ranges::replace(variant.file, ' ', '_');
    variant.words = words;
    variant.section = section;
    variant.simpler = variant.section || !name.starts_with("plane");
  }

  void add_part() {
    SymmetricPart part = reduce_by_symmetry(model_, given_);
    add(part.name, part.words, {std::move(part.text), std::move(part.reason)});
    variants_.back().mirrored = part.mirrored;
  }

  void add_section(const std::string& name, const std::string& words, const char* state) {
    SectionDeck made = section_deck(model_, given_, state);
    add(name, words, {made.text, made.reason}, made.text ? std::optional(made.view) : std::nullopt);
  }

  [[nodiscard]] bool any(bool JointContact::*what) const {
    return std::ranges::any_of(joint_.contacts,
                               [&](const JointContact& contact) { return contact.*what; });
  }

  [[nodiscard]] RewrittenDeck friction() const {
    return joint_.friction ? RewrittenDeck{smooth_, {}} : no_place("nothing rubs");
  }

  [[nodiscard]] RewrittenDeck mounting() const {
    return any(&JointContact::mounted) ? RewrittenDeck{at_once_, {}}
                                       : no_place("nothing is mounted later");
  }

  [[nodiscard]] RewrittenDeck interference() const {
    if (!any(&JointContact::presses)) {
      return no_place("no contact has an interference");
    }
    std::set<std::string> pressing;
    for (const JointContact& contact : joint_.contacts) {
      if (contact.presses) {
        pressing.insert(contact.name);
      }
    }
    DeckText text = at_once_;
    make_net(text, pressing);
    return {std::move(text), {}};
  }

  [[nodiscard]] bool can_bond() const {
    return std::ranges::any_of(joint_.contacts, [](const JointContact& contact) {
      return !contact.bonded && !contact.rigid;
    });
  }

  [[nodiscard]] RewrittenDeck fits() const {
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

  [[nodiscard]] RewrittenDeck bonding() const {
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

  [[nodiscard]] RewrittenDeck rigid() const { return make_rigid(model_, joint_, at_once_, given_); }

  [[nodiscard]] RewrittenDeck bearing(const char* shape) const {
    const std::set<std::string> nets = pressing_nets(joint_);
    if (nets.empty()) {
      return no_place(joint_.cracked.empty() ? "without a crack there is no body to keep"
                                             : "no body presses on that with the crack");
    }
    std::string surface;
    DeckText text = at_once_;
    for (const DeckCard& card : cards_named(text, "CONTACT")) {
      const bool slave = nets.contains(net_prefix(*card.find("SLAVE")));
      if (slave != nets.contains(net_prefix(*card.find("MASTER")))) {
        if (!surface.empty()) {
          return no_place("bodies press on more than one surface");
        }
        surface = *card.find(slave ? "MASTER" : "SLAVE");
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
    for (DeckCard card : cards_named(at_once_, "LOAD")) {
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
      lines.front().front() = surface;
      loads.push_back(deck::make_card(
          "LOAD", {{"CASE", *card.find("CASE")}, {"TYPE", "BEARING"}, {"SHAPE", shape}},
          fmt::format("  {}\n", fmt::join(lines.front(), "  "))));
    }
    return loads.empty() ? "what presses is not loaded" : "";
  }

  [[nodiscard]] RewrittenDeck state(const std::string& from, const std::string& to) const {
    DeckText text = given_;
    bool changed = false;
    for (DeckCard& card : text) {
      const bool body = card.name == "PROPERTY";
      if ((body || card.name == "CRACK") && card.word_value("STATE") == from) {
        card.set("STATE", to);
        changed = changed || body;
      }
    }
    return changed ? RewrittenDeck{std::move(text), {}}
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
