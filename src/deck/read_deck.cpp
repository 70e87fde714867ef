// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/read_deck.hpp"

#include "deck/context.hpp"
#include "deck/load.hpp"

#include <utility>

namespace spricka::deck {

std::optional<model::Model> read_deck(const std::filesystem::path& deck, const ReadOptions& options,
                                      base::Sources& sources, base::Diagnostics& diagnostics) {
  const LoadedDeck loaded = load_deck(deck, sources, diagnostics);
  Context context{sources, diagnostics};
  context.largest_mesh = options.largest_mesh;
  if (loaded.incomplete) {
    context.names.poison_everything();
    context.scope.incomplete = true;
    context.mesh_sound = false;
    context.property_sound = false;
  }
  bind_all(context, loaded.cards, options);
  build_mesh(context);
  build_sets(context);
  build_properties(context);
  build_mpcs(context);
  build_contacts(context);
  build_cracks(context);
  build_loads(context);
  build_steps(context);
  build_requests(context);
  check_references(context);
  check_mesh(context);
  check_scope(context);
  if (diagnostics.has_errors()) {
    return std::nullopt;
  }
  return std::move(context.model);
}

} // namespace spricka::deck
