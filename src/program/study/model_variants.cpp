// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/lexeme.hpp"
#include "model/model.hpp"
#include "program/study/deck_edits.hpp"
#include "program/study/deck_variant.hpp"
#include "program/study/joint.hpp"
#include "program/study/mesh_parameters.hpp"
#include "report/drawing/file.hpp"
#include "sense/half_model.hpp"
#include "sense/mirrors.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

using deck::DeckCard;
using deck::DeckCardList;

/// What may stand against a variant, and the words for it.
using Obstacles = std::initializer_list<std::pair<bool, const char*>>;

// The text, or the first obstacle there is.
DeckVariant unless(Obstacles obstacles, const DeckCardList& text) {
  for (const auto& [there, reason] : obstacles) {
    if (there) {
      return make_refused_variant(reason);
    }
  }
  return {.text = text};
}

void drop_friction(DeckCardList& text) {
  constexpr std::array keys{std::pair{"CONTACT", "MU"}, std::pair{"CRACK", "MU"},
                            std::pair{"STEP", "SUBSTEPS"}, std::pair{"GROW", "HISTORY"}};
  for (const auto& [name, key] : keys) {
    for (DeckCard& card : cards_named(text, name)) {
      card.erase(key);
    }
  }
}

// Contacts of these names (upper case) are net: neither fits nor clearances.
DeckCardList with_net(DeckCardList text, const std::set<std::string>& contacts) {
  for (DeckCard& card : cards_named(text, "CONTACT")) {
    if (contacts.contains(card.word_value("NAME"))) {
      card.erase("INTERFERENCE");
      card.erase("DIAMETRAL");
      card.set_key("GAP", "0");
    }
  }
  filter_step_actions(text, [&](const std::string& action, const std::string& contact) {
    return action != "FIT" || !contacts.contains(contact);
  });
  return text;
}

DeckCardList with_bonds(DeckCardList text) {
  for (DeckCard& card : cards_named(text, "CONTACT")) {
    card.set_key("TYPE", "BONDED");
    card.erase("MU");
  }
  return text;
}

class VariantMaker {
public:
  VariantMaker(const StudiedDeck& deck, std::filesystem::path folder)
      : model_(*deck.ready->model), joint_(analyse_joint(model_)), folder_(std::move(folder)),
        given_(deck.text) {
    remove_checks_and_requests(given_);
    for (const auto& [name, value] : deck.defines) {
      deck::replace_parameter(given_, grammar::to_upper(name), value);
    }
    smooth_ = given_;
    drop_friction(smooth_);
    at_once_ = smooth_;
    remove_mount_actions(at_once_);
  }

  std::vector<DeckVariant> run() {
    const bool presses = has_contact([](const JointContact& c) { return c.presses; });
    const bool mounted = has_contact([](const JointContact& c) { return c.mounted; });
    const bool loose = has_contact([](const JointContact& c) { return !c.bonded && !c.rigid; });
    std::set<std::string> all;
    std::set<std::string> pressing;
    for (const JointContact& contact : joint_.contacts) {
      all.insert(contact.name);
      if (contact.presses) {
        pressing.insert(contact.name);
      }
    }
    add("as given", "the deck itself", {.text = given_});
    const DeckVariant part = reduce_by_symmetry(model_, given_);
    add(part.name, part.words, part);
    add("without friction", "all surfaces are smooth",
        unless({{!joint_.friction, "nothing rubs"}}, smooth_));
    add("all at once", "nothing is mounted later, all stands from the beginning",
        unless({{!mounted, "nothing is mounted later"}}, at_once_));
    add("bonded with its fits", "contacts can neither open nor slip; interferences press",
        unless({{!presses, "no contact has an interference"}, {!loose, "all contacts are bonded"}},
               with_bonds(at_once_)));
    add("without interference", "all fits are net",
        unless({{!presses, "no contact has an interference"}}, with_net(at_once_, pressing)));
    // Clearances are closed as well: a bonded pair that starts apart would be pulled together.
    add("bonded", "contacts can neither open nor slip; all fits are net",
        unless({{all.empty(), "there is no contact"},
                {!loose && !presses && !mounted, "all contacts are bonded"}},
               with_net(with_bonds(at_once_), all)));
    add("rigid pressing body", "what only presses is rigid",
        make_pressing_bodies_rigid(model_, joint_, at_once_, given_));
    add("cosine pressure", "a cosine pressure in place of what presses", bearing("COSINE"));
    add("uniform pressure", "a uniform pressure in place of what presses", bearing("UNIFORM"));
    if (model_.mesh.dim == 3) {
      add("axisymmetric", "the section of round bodies", make_section_deck(model_, given_, "AXI"));
      add("plane strain", "the section of the bodies in plane strain",
          make_section_deck(model_, given_, "STRAIN"));
      add("plane stress", "the section of the bodies in plane stress",
          make_section_deck(model_, given_, "STRESS"));
    } else {
      add("plane strain", "plane strain in place of plane stress", state("STRESS", "STRAIN"));
      add("plane stress", "plane stress in place of plane strain", state("STRAIN", "STRESS"));
    }
    return std::move(variants_);
  }

private:
  void add(const std::string& name, const std::string& words, DeckVariant made) {
    DeckVariant& variant = variants_.emplace_back(std::move(made));
    variant.name = name;
    std::string file = name + ".deck";
    std::ranges::replace(file, ' ', '_');
    variant.deck = folder_ / file;
    variant.words = words;
    variant.simpler = variant.section || !name.starts_with("plane");
    if (variant.text) {
      report::write_file(variant.deck, format_deck_card_list(*variant.text, folder_));
    }
  }

  template <class Condition> [[nodiscard]] bool has_contact(const Condition& condition) const {
    return std::ranges::any_of(joint_.contacts, condition);
  }

  [[nodiscard]] DeckVariant bearing(const char* shape) const {
    const std::set<std::string> nets = find_only_pressing_nets(joint_);
    if (nets.empty()) {
      return make_refused_variant(joint_.cracked.empty()
                                      ? "without a crack there is no body to keep"
                                      : "no body presses on that with the crack");
    }
    std::string surface;
    DeckCardList text = at_once_;
    for (const DeckCard& card : cards_named(text, "CONTACT")) {
      const bool slave = nets.contains(net_prefix(*card.find("SLAVE")));
      if (slave != nets.contains(net_prefix(*card.find("MASTER")))) {
        if (!surface.empty()) {
          return make_refused_variant("bodies press on more than one surface");
        }
        surface = *card.find(slave ? "MASTER" : "SLAVE");
      }
    }
    if (surface.empty()) {
      return make_refused_variant("the surface that is pressed on belongs to no net of its own");
    }
    std::vector<DeckCard> loads;
    if (const std::string reason = bearing_loads(nets, surface, shape, loads); !reason.empty()) {
      return make_refused_variant(reason);
    }
    remove_nets_with_dependents(text, nets);
    for (DeckCard& load : loads) {
      append_card(text, std::move(load));
    }
    drop_undefined_loads(text);
    return {.text = std::move(text)};
  }

  // One load for each case that presses; why not, in words.
  [[nodiscard]] std::string bearing_loads(const std::set<std::string>& nets,
                                          const std::string& surface, const char* shape,
                                          std::vector<DeckCard>& loads) const {
    for (const DeckCard& card : cards_named(at_once_, "LOAD")) {
      std::vector<DataFields> lines = split_data_line_fields(card);
      std::erase_if(lines, [&](const DataFields& fields) {
        return !nets.contains(net_prefix(fields.front()));
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

  [[nodiscard]] DeckVariant state(const std::string& from, const std::string& to) const {
    DeckCardList text = given_;
    bool changed = false;
    for (DeckCard& card : text) {
      const bool body = card.name == "PROPERTY";
      if ((body || card.name == "CRACK") && card.word_value("STATE") == from) {
        card.set_key("STATE", to);
        changed = changed || body;
      }
    }
    return changed ? DeckVariant{.text = std::move(text)}
                   : make_refused_variant(fmt::format("no body is in plane {}",
                                                      from == "STRESS" ? "stress" : "strain"));
  }

  const model::Model& model_;
  Joint joint_;
  std::filesystem::path folder_;
  DeckCardList given_;
  DeckCardList smooth_;
  DeckCardList at_once_;
  std::vector<DeckVariant> variants_;
};

} // namespace

DeckVariant reduce_by_symmetry(const model::Model& model, const DeckCardList& text) {
  DeckVariant part;
  DeckCardList changed = text;
  for (const results::SymmetryPlanePreview& mirror : sense::find_symmetry_planes(model)) {
    const bool there = std::ranges::any_of(
        model.mirrors, [&](const model::MirrorPlane& plane) { return plane.axis == mirror.axis; });
    const char axis = "xyz"[mirror.axis];
    std::string against = mirror.against;
    if (against.empty() && !there) {
      against = sense::half_model_obstacle(model, mirror);
    }
    if (there || !against.empty()) {
      if (!there) {
        part.reason = fmt::format("{} = {:.4g}: {}", axis, mirror.at, against);
      }
      continue;
    }
    append_card(changed,
                deck::make_card("SYMMETRY", {{"NORMAL", std::string(1, "XYZ"[mirror.axis])}}));
    part.mirrored += "XYZ"[mirror.axis];
    part.words += fmt::format("{}{} >= {:.4g}", part.words.empty() ? "" : ", ", axis, mirror.at);
  }
  if (part.mirrored.empty()) {
    part.reason = part.reason.empty() ? "the bodies have no plane of symmetry" : part.reason;
    part.name = "half by symmetry";
    return part;
  }
  constexpr std::array names{"half", "quarter", "eighth"};
  part.name = fmt::format("{} by symmetry", names.at(part.mirrored.size() - 1));
  part.words += " alone";
  part.text = std::move(changed);
  part.reason.clear();
  return part;
}

std::vector<DeckVariant> make_simpler_models(const StudiedDeck& deck,
                                             const std::filesystem::path& folder) {
  return VariantMaker(deck, folder).run();
}

} // namespace spricka::program
