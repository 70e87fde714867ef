// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/read_deck.hpp"

#include "deck/context.hpp"
#include "deck/load.hpp"
#include "mesh/subdivide.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <utility>

namespace spricka::deck {

namespace {

void divide_elements(DeckContext& context) {
  model::Model& model = context.model;
  for (int round = 0;; ++round) {
    std::vector<bool> nets(model.nets.size(), false);
    for (std::size_t n = 0; n < nets.size(); ++n) {
      const std::string& name = model.nets[n].name;
      const NetRefinement* request = context.net_refinement(name);
      nets[n] = request != nullptr && request->splits > round && !context.remeshed.contains(name);
    }
    if (std::ranges::none_of(nets, [](bool divided) { return divided; })) {
      return;
    }
    mesh::subdivide_plane_elements(model.mesh, nets);
  }
}

} // namespace

std::optional<model::Model> read_deck(const std::filesystem::path& deck,
                                      const DeckReadOptions& options, base::SourceTexts& sources,
                                      base::Diagnostics& diagnostics, ImportedGeometry* imported) {
  const DeckFileCards loaded = read_deck_and_includes(deck, sources, diagnostics, options.text);
  DeckContext context{sources, diagnostics};
  context.largest_mesh = options.largest_mesh;
  context.refine = &options.refine;
  context.own_lengths = &options.own_lengths;
  if (loaded.incomplete) {
    context.names.poison_everything();
    context.scope.incomplete = true;
    context.mesh_sound = false;
    context.property_sound = false;
  }
  check_cards_and_define_names(context, loaded.cards, options);
  if (!check_requirements(context)) { // what would follow from such numbers is no news
    return std::nullopt;
  }
  build_mesh(context);
  warn_of_unused_script_parameters(context);
  build_sets(context);
  build_properties(context);
  build_mpcs(context);
  build_contacts(context);
  build_cracks(context);
  build_loads(context);
  build_steps(context);
  build_requests(context);
  check_references_of_bad_cards(context);
  check_elements(context);
  check_double_and_unjoined_elements(context);
  check_model_consistency(context);
  check_plausibility(context);
  check_conflicting_surfaces(context);
  check_implausible_values(context);
  check_unused_entities(context);
  check_steps_and_growth(context);
  if (imported != nullptr) {
    *imported = {std::move(context.scripts), std::move(context.step_files),
                 context.scope.units.length_name};
  }
  if (diagnostics.has_errors()) {
    return std::nullopt;
  }
  divide_elements(context);
  return std::move(context.model);
}

} // namespace spricka::deck
