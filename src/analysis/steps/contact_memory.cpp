// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/steps/contact_memory.hpp"

#include <algorithm>

namespace spricka::analysis {

namespace {

// Nodes that only elements have which no crack of the run touches.
std::vector<bool> lasting_nodes(const Discretisation& scene) {
  const model::Mesh& mesh = scene.cracked.mesh;
  std::vector<bool> lasting(mesh.node_count(), true);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    if (!scene.rest_element[e]) {
      for (const base::NodeId n : mesh.element_nodes(base::ElementId(e))) {
        lasting[n.index()] = false;
      }
    }
  }
  return lasting;
}

} // namespace

contact::PersistentRowSet
ContactDataForNextLength::find_persistent_rows(const Discretisation& scene,
                                               const std::vector<SubstructuredBody>& bodies,
                                               const std::vector<std::size_t>& condensed) {
  contact::PersistentRowSet lasting;
  // Without elements that no crack touches nothing lasts from length to length.
  const bool several = std::ranges::find(scene.rest_element, true) != scene.rest_element.end();
  if (!several) {
    return lasting;
  }
  const std::vector<bool> node = lasting_nodes(scene);
  for (const contact::ConstraintRow* row : scene.reduced_contact_rows()) {
    lasting.row.push_back(std::ranges::all_of(
        row->entries, [&](const contact::RowEntry& e) { return node[e.node.index()]; }));
  }
  bodies_.resize(bodies.size());
  for (const std::size_t b : condensed) {
    // A body with elements of the region is condensed anew for each length, but for early rows.
    const bool stays = std::ranges::all_of(
        bodies[b].body.elements, [&](base::ElementId e) { return scene.rest_element[e.index()]; });
    const solve::FactoredSchurComplement* factor = bodies[b].condensed->external_block_factor();
    const solve::SubstructuredFactor* in_parts =
        bodies[b].condensed->is_uncondensed() ? &bodies[b].condensed->factor() : nullptr;
    if (!stays && factor == nullptr && (in_parts == nullptr || bodies[b].parts.size() != 1)) {
      lasting.kept.push_back(nullptr);
      continue;
    }
    // What the kept rows were made of: another factor makes them worthless.
    const std::shared_ptr<const void> of =
        factor != nullptr     ? std::shared_ptr<const void>(factor->L.first_block())
        : in_parts != nullptr ? in_parts->lasting_factor()
                              : bodies[b].condensed;
    std::unique_ptr<PersistentBodyCompliance>& kept = bodies_[b];
    if (!kept || kept->of != of) {
      kept = std::make_unique<PersistentBodyCompliance>(PersistentBodyCompliance{of, {}});
    }
    lasting.kept.push_back(&kept->rows);
  }
  return lasting;
}

// Calls use(row, place) for all normal rows. Nodes of patches may be others at the next length: a
// start is not more than that.
template <class Use>
void ContactDataForNextLength::for_rows(const Discretisation& scene, Use&& use) {
  for (std::size_t c = 0; c < scene.pairs.size(); ++c) {
    std::map<std::int64_t, std::int64_t> met;
    const std::vector<contact::ConstraintRow>& rows = scene.pairs[c].normal;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const std::int64_t node = rows[r].node.value;
      use(scene.table.first[c] + r, Place{static_cast<std::int64_t>(c), node, met[node]++});
    }
  }
}

std::vector<bool>
ContactDataForNextLength::guess_closed_rows(const Discretisation& scene, std::size_t step,
                                            const std::vector<bool>& before) const {
  if (step >= closed_.size() || closed_[step].empty()) {
    return {};
  }
  std::vector<bool> closed = before;
  closed.resize(scene.table.size(), true);
  for_rows(scene, [&](std::size_t row, const Place& place) {
    if (const auto known = closed_[step].find(place); known != closed_[step].end()) {
      closed[row] = known->second;
    }
  });
  return closed;
}

void ContactDataForNextLength::store_closed_rows(const Discretisation& scene, std::size_t step,
                                                 const std::vector<bool>& closed) {
  if (closed_.size() <= step) {
    closed_.resize(step + 1);
  }
  closed_[step].clear();
  for_rows(scene, [&](std::size_t row, const Place& place) {
    if (row < closed.size()) { // where nothing can move no row was asked
      closed_[step][place] = closed[row];
    }
  });
}

void ContactDataForNextLength::save_state(results::NamedArrays& arrays) const {
  for (std::size_t s = 0; s < closed_.size(); ++s) {
    std::vector<std::int64_t>& list = arrays.integers["closed.of_step"];
    for (const auto& [place, closed] : closed_[s]) {
      list.push_back(static_cast<std::int64_t>(s));
      list.insert(list.end(), place.begin(), place.end());
      list.push_back(closed ? 1 : 0);
    }
  }
}

ContactDataForNextLength ContactDataForNextLength::restore_state(const results::NamedArrays& arrays,
                                                                 std::size_t steps) {
  ContactDataForNextLength memory;
  const auto found = arrays.integers.find("closed.of_step");
  if (found == arrays.integers.end()) {
    return memory;
  }
  const std::vector<std::int64_t>& list = found->second;
  for (std::size_t i = 0; i + 4 < list.size(); i += 5) {
    const auto step = static_cast<std::size_t>(list[i]);
    if (step >= steps) {
      throw base::CorruptStoredField("closed.of_step", "rows closed in a step that there is not");
    }
    if (memory.closed_.size() <= step) {
      memory.closed_.resize(step + 1);
    }
    memory.closed_[step][{list[i + 1], list[i + 2], list[i + 3]}] = list[i + 4] != 0;
  }
  return memory;
}

} // namespace spricka::analysis
