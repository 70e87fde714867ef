// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/lexeme.hpp"
#include "program/study/deck_edits.hpp"
#include "program/study/mesh_parameters.hpp"
#include "program/study/study.hpp"
#include "report/drawing/file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>

#include <fmt/format.h>

namespace spricka::program {

namespace {

namespace fs = std::filesystem;
using deck::DeckCard;
using deck::DeckCardList;

// Cracks whose tips the program meshes.
std::vector<std::string> cut_cracks(const DeckCardList& text) {
  std::vector<std::string> names;
  for (const DeckCard& card : cards_named(text, "CRACK")) {
    const std::string name = card.word_value("NAME");
    const bool own = std::ranges::any_of(text, [&](const DeckCard& net) {
      return net.name == "TIPNET" && net.word_value("CRACK") == name &&
             net.word_value("PATCH") == "NO";
    });
    if (!own && !card.has_key("FRONT")) {
      names.push_back(name);
    }
  }
  return names;
}

/// Every crack's $TIPNET gets a key.
template <class Set> void set_tip_nets(DeckCardList& text, const Set& set) {
  for (const std::string& crack : cut_cracks(text)) {
    if (find_card_with_key_value(text, "TIPNET", "CRACK", crack) == nullptr) {
      append_card(text, deck::make_card("TIPNET", {{"CRACK", crack}}));
    }
    set(*find_card_with_key_value(text, "TIPNET", "CRACK", crack));
  }
}

void make_tips_finer(DeckCardList& text, double fineness) {
  if (fineness == 1.0) {
    return;
  }
  set_tip_nets(text, [&](DeckCard& card) {
    const std::string* own = card.find("FINER");
    card.set_key("FINER", own == nullptr ? fmt::format("{:.6g}", fineness)
                                         : fmt::format("({}*{:.6g})", *own, fineness));
  });
}

// An edit that gives every crack's $TIPNET a key.
auto tip_key(const char* key, const std::string& value) {
  return [=](DeckCardList& text) {
    set_tip_nets(text, [&](DeckCard& card) { card.set_key(key, value); });
  };
}

// Element types of $MESH and the linear ones they stand beside; false: there is nothing to change.
bool make_linear(DeckCardList& text, const fs::path& folder) {
  const std::map<std::string, const char*> linear{{"TRIMC6", "TRIM3"},
                                                  {"QUAMC8", "QUAM4"},
                                                  {"QUAMC9", "QUAM4"},
                                                  {"HEXEC20", "HEXE8"},
                                                  {"HEXEC27", "HEXE8"}};
  bool changed = false;
  for (DeckCard& card : text) {
    const auto linear_type = linear.find(card.word_value("TYPE"));
    if (card.name == "MESH" && linear_type != linear.end()) {
      card.set_key("TYPE", linear_type->second);
      changed = true;
    } else if (imports_geometry_script(card)) {
      import_script_with_added_line(card, "linear", "Mesh.ElementOrder = 1;", folder);
      card.erase("TYPE");
      changed = true;
    }
  }
  return changed;
}

class Planner {
public:
  Planner(const StudiedDeck& deck, fs::path folder, std::vector<std::string>& notes)
      : deck_(deck), folder_(std::move(folder)), notes_(notes) {
    base_ = deck.text;
    std::erase_if(base_, [](const DeckCard& card) { // of long runs, not of a study of one state
      return card.name == "SWEEP" || card.name == "RESTART" || card.name == "OUTPUT";
    });
    sizes_ = base_;
    for (DeckCard& card : cards_named(sizes_, "TIPNET")) {
      card.erase("TOL");
    }
    cracks_ = !cut_cracks(base_).empty();
    dim_ = deck.ready->model->mesh.dim;
  }

  std::vector<DeckVariant> run(const std::vector<ParameterVariation>& requests) {
    varied_ = find_mesh_parameters(deck_, folder_);
    notes_ = varied_.fixed;
    add("as given", SettingFamily::given, 1.0, base_, {});
    for (const ParameterVariation& request : requests) {
      add_request(request);
    }
    if (requests.empty()) {
      add_series();
      add_routes();
    }
    return std::move(settings_);
  }

private:
  void add(const std::string& name, SettingFamily family, double fineness, const DeckCardList& text,
           const ParameterDefinitions& defines) {
    const fs::path deck = folder_ / fmt::format("{:02}.deck", settings_.size() + 1);
    report::write_file(deck, format_deck_card_list(text, folder_, {name}));
    settings_.push_back({.name = name,
                         .deck = deck,
                         .defines = merge_defines(deck_.defines, defines),
                         .family = family,
                         .fineness = fineness});
  }

  void add_request(const ParameterVariation& request) {
    const auto is_it = [&](const std::string& name) {
      return grammar::to_upper(name) == grammar::to_upper(request.parameter);
    };
    const auto& parameters = deck_.ready->model->parameters;
    const auto known = std::ranges::find_if(
        parameters, [&](const auto& parameter) { return is_it(parameter.first); });
    const bool larger_is_finer =
        std::ranges::none_of(varied_.parameters, [&](const MeshParameter& parameter) {
          return is_it(parameter.name) && !parameter.larger_is_finer;
        });
    for (const std::string& value : request.values) {
      double fineness = 1.0;
      double number = 0.0;
      const auto read = std::from_chars(value.data(), value.data() + value.size(), number);
      if (read.ec == std::errc() && known != parameters.end() && known->second > 0.0) {
        fineness = larger_is_finer ? number / known->second : known->second / number;
      }
      add(fmt::format("{}={}", request.parameter, value), SettingFamily::asked, fineness, sizes_,
          {{request.parameter, value}});
    }
  }

  // The deck with its bodies' meshes so much finer.
  DeckVariant bodies(double fineness) {
    return refine_deck_mesh(deck_, varied_, fineness, sizes_, folder_);
  }

  bool is_readable(double fineness) {
    const DeckVariant finer = bodies(fineness);
    return read_trial_deck(*finer.text, merge_defines(deck_.defines, finer.defines), folder_)
        .model.has_value();
  }

  // Coarse to fine, without the deck's own: those that are wanted, or one that may stand for it.
  std::vector<double> finenesses() {
    if (varied_.empty()) {
      return {0.5, 0.7, 1.4, 2.0};
    }
    std::vector<std::vector<double>> wanted{
        {0.5, 0.6, 0.625}, {0.7, 0.75, 2.0 / 3.0, 0.8}, {1.4, 1.5, 1.25, 4.0 / 3.0}};
    if (dim_ == 2) {
      wanted.push_back({2.0, 1.75});
    }
    const bool never_broken = varied_.parameters.empty() && varied_.constants.empty();
    std::vector<double> found;
    for (const std::vector<double>& several : wanted) {
      const auto sound =
          std::ranges::find_if(several, [&](double f) { return never_broken || is_readable(f); });
      if (sound != several.end()) {
        found.push_back(*sound);
      }
    }
    return found;
  }

  enum class Tips { finer, as_given };

  // The bodies with elements of 1/fineness of their size, the deck changed by `edit` as well.
  template <class Edit>
  void add_route(SettingFamily family, double fineness, Tips tips, const std::string& word,
                 const Edit& edit) {
    DeckVariant finer = bodies(fineness);
    edit(*finer.text);
    std::string name = finer.words;
    if (tips == Tips::finer && cracks_ && fineness != 1.0) {
      name += fmt::format(" FINER={:.4g}", fineness);
    }
    if (tips == Tips::finer) {
      make_tips_finer(*finer.text, fineness);
    }
    add(word.empty() ? name : name + " " + word, family, fineness, *finer.text, finer.defines);
  }

  void add_series() {
    if (varied_.empty()) {
      notes_.emplace_back("no mesh of a body can be varied: the nets round tips alone");
    }
    sizes_of_bodies_ = finenesses();
    if (varied_.empty() && !cracks_) {
      notes_.emplace_back("without cracks nothing is left to vary; name a parameter: --vary");
      return;
    }
    const auto as_it_is = [](DeckCardList& /*text*/) {};
    for (const double f : sizes_of_bodies_) {
      add_route(SettingFamily::whole, f, Tips::finer, "", as_it_is);
    }
    if (!cracks_ || varied_.empty()) {
      return;
    }
    for (const double f : sizes_of_bodies_) {
      add_route(SettingFamily::host, f, Tips::as_given, "", as_it_is);
    }
    for (const double f : {0.5, 2.0}) {
      DeckCardList text = sizes_;
      make_tips_finer(text, f);
      add(fmt::format("FINER={:g}", f), SettingFamily::tip, f, text, {});
    }
  }

  // Other ways at some of the sizes.
  void add_routes() {
    std::vector<double> some{1.0};
    if (!sizes_of_bodies_.empty()) {
      some = {sizes_of_bodies_.front(), 1.0, sizes_of_bodies_.back()};
    }
    add_parts(some);
    if (cracks_) {
      add_tip_routes(some);
    }
    DeckCardList linear = sizes_;
    if (cracks_) {
      notes_.emplace_back("no linear elements: a crack is cut into quadratic ones");
    } else if (make_linear(linear, folder_)) {
      for (const double f : some) {
        add_route(SettingFamily::linear, f, Tips::finer, "linear",
                  [&](DeckCardList& text) { make_linear(text, folder_); });
      }
    } else {
      notes_.emplace_back("the deck's elements have no linear partners");
    }
    DeckCardList steps = sizes_;
    if (replace_load_paths_by_steps(steps, *deck_.ready->model)) {
      add("steps for paths", SettingFamily::path, 1.0, steps, {});
    }
  }

  void add_parts(const std::vector<double>& sizes) {
    const model::Model& model = *deck_.ready->model;
    const DeckVariant part = reduce_by_symmetry(model, sizes_);
    if (!part.text) {
      notes_.push_back("no part by symmetry: " + part.reason);
      return;
    }
    for (const double f : sizes) {
      add_route(SettingFamily::part, f, Tips::finer, part.name,
                [&](DeckCardList& text) { text = *reduce_by_symmetry(model, text).text; });
      settings_.back().mirrored = part.mirrored;
    }
  }

  void add_tip_routes(const std::vector<double>& some) {
    for (const double tolerance : {1e-2, 1e-3, 3e-4}) {
      add_route(SettingFamily::tolerance, some.front(), Tips::as_given,
                fmt::format("TOL={:g}", tolerance), tip_key("TOL", fmt::format("{:g}", tolerance)));
      settings_.back().fineness = 1.0; // what it ends with is not known
    }
    for (const double f : some) {
      add_route(SettingFamily::quarter, f, Tips::finer, "QUARTER=NO", tip_key("QUARTER", "NO"));
    }
    for (const double f : {some.front(), 1.0}) {
      add_route(SettingFamily::transition, f, Tips::as_given, "JOIN=TRANSITION",
                tip_key("JOIN", "TRANSITION"));
    }
    if (dim_ == 3) {
      DeckCardList text = sizes_;
      set_tip_nets(text, [](DeckCard& card) {
        card.erase("SECTORS");
        card.erase("JOIN");
        card.set_key("TUBE", "NO");
      });
      add("TUBE=NO", SettingFamily::tube, 1.0, text, {});
    }
  }

  const StudiedDeck& deck_;
  fs::path folder_;
  DeckCardList base_;
  DeckCardList sizes_; ///< without TOL, which would undo what is varied
  bool cracks_ = false;
  int dim_ = 2;
  std::vector<double> sizes_of_bodies_;
  std::vector<std::string>& notes_;
  MeshRefinementControls varied_;
  std::vector<DeckVariant> settings_;
};

} // namespace

const char* display_name(SettingFamily family) {
  constexpr std::array names{"as given",
                             "all sizes",
                             "meshes of bodies alone",
                             "nets of tips alone",
                             "without quarter points",
                             "linear elements",
                             "JOIN=TRANSITION",
                             "TUBE=NO",
                             "part by symmetry",
                             "to a tolerance",
                             "steps in place of load paths",
                             "as asked for",
                             "CalculiX, same meshes"};
  return names.at(static_cast<std::size_t>(family));
}

std::vector<DeckVariant> plan_study_settings(const StudiedDeck& deck,
                                             const std::vector<ParameterVariation>& requests,
                                             const fs::path& folder,
                                             std::vector<std::string>& notes) {
  return Planner(deck, folder, notes).run(requests);
}

} // namespace spricka::program
