// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/mesh_limits.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

constexpr base::Label k_highest_label = 1'000'000'000'000'000; // exact in double precision

const base::ElementInfo& info_of(std::string_view name) {
  return *std::find_if(base::element_infos.begin(), base::element_infos.end(),
                       [&](const base::ElementInfo& i) { return i.name == name; });
}

// Elements of one cell of the generator's grid.
double per_cell(const base::ElementInfo& info) {
  const bool simplex = info.corners == info.dim + 1;
  return simplex ? (info.dim == 3 ? 6.0 : 2.0) : 1.0;
}

} // namespace

bool mesh_is_handy(Context& context, const BoundCard& card) {
  const base::ElementInfo& info = info_of(card.word("TYPE"));
  const bool block = card.is("SHAPE", "BLOCK");
  double cells =
      block ? card.number("NX") * card.number("NY") : card.number("NR") * card.number("NT");
  cells *= block && info.dim == 3 ? card.number("NZ") : 1.0;
  const double elements = cells * per_cell(info);
  const double present = static_cast<double>(context.model.mesh.nodes.size());
  const double room = static_cast<double>(context.largest_mesh) - present;
  if (elements * info.nodes > room) {
    context.error(card.span, "E321",
                  fmt::format("{:.0f} elements of type {} are too many; there is room for {:.0f}",
                              elements, info.name, std::max(0.0, room / info.nodes)),
                  block ? "see NX, NY and NZ" : "see NR and NT");
    return false;
  }
  const std::size_t net = card.net_id.index();
  if (std::max(context.node_labels[net].highest(), context.element_labels[net].highest()) >
      k_highest_label) {
    context.error(card.span, "E321", "the numbers of this net are too high to number a mesh on",
                  "put the mesh into a $NET of its own");
    return false;
  }
  return true;
}

} // namespace spricka::deck
