// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/mesh_limits.hpp"
#include "deck/mesh_shapes.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

constexpr base::Label k_highest_label = 1'000'000'000'000'000; // exact in double precision

constexpr double k_most_unknowns = 1e7; // some 50 GB of factor in the plane, far more in space

// Elements of one cell of the generator's grid.
double per_cell(const base::ElementInfo& info) {
  constexpr std::array<double, 4> simplices{1.0, 1.0, 2.0, 6.0}; // by the dimension: its factorial
  const bool simplex = info.corners == info.dim + 1;
  const bool prism = info.domain == base::ReferenceDomain::prism;
  return simplex ? simplices.at(static_cast<std::size_t>(info.dim)) : prism ? 2.0 : 1.0;
}

// Of a large grid: those at the corners, in the edges and in the middle that a cell adds.
double nodes_per_cell(const base::ElementInfo& info) {
  if (!info.quadratic) {
    return 1.0;
  }
  // Without nodes in sides and cells a cell adds a corner and an edge for each direction.
  const bool sparse = info.nodes == 8 || info.nodes == 20;
  return sparse ? 1.0 + info.dim : 1 << info.dim;
}

// Cells of the generator's grid in the plane: at least as many as it will make.
double plane_cells(const CheckedCard& card) {
  if (card.key_has_word("SHAPE", "BLOCK")) {
    return card.number_value("NX") * card.number_value("NY");
  }
  if (card.key_has_word("SHAPE", "PLATE")) {
    return mesh::plate_cell_count(plate_spec(card));
  }
  const double round = std::max(card.number_value("NT"), 8.0);
  double cells = card.number_value("NR") * round;
  if (card.key_has_word("SHAPE", "RING") && card.number_value("RI") == 0.0) {
    cells += 0.25 * round * round; // the core of a disc
  }
  if (card.key_has_word("SHAPE",
                        "LUG")) { // the shank, in squares as wide as those at the back of the eye
    const double across = 0.25 * round + 1.0;
    cells += across * (across * card.number_value("L") / card.number_value("W") + 1.0);
  }
  return cells;
}

double cells_of(const CheckedCard& card) {
  return plane_cells(card) * card.number_value("NZ"); // 1 in the plane
}

} // namespace

bool check_requested_mesh_size(DeckContext& context, const CheckedCard& card) {
  const base::ElementInfo& info =
      base::element_info(base::element_type_by_name(card.word_value("TYPE")));
  const double elements = cells_of(card) * per_cell(info);
  const auto present = static_cast<double>(context.model.mesh.nodes.size());
  const double room = static_cast<double>(context.largest_mesh) - present;
  if (!(elements * info.nodes <= room)) {
    const std::string_view hint = card.key_has_word("SHAPE", "BLOCK") ? "see NX and NY"
                                  : card.key_has_word("SHAPE", "LUG") ? "see NR, NT and L over W"
                                                                      : "see NR and NT";
    context.error(card.span, "E321",
                  fmt::format("about {:.3g} elements of type {} are too many, there is room for "
                              "{:.3g}",
                              elements, info.name, std::max(0.0, room / info.nodes)),
                  std::string(hint) + (card.has_key("NZ") ? ", and NZ" : ""));
    return false;
  }
  const double unknowns = cells_of(card) * nodes_per_cell(info) * info.dim;
  if (unknowns > k_most_unknowns) {
    context.error(
        card.span, "E321",
        fmt::format("about {:.3g} elements of type {} have {:.2g} unknowns, too many to be "
                    "solved: at most {:.2g} are taken",
                    elements, info.name, unknowns, k_most_unknowns),
        "make the mesh coarser, and fine only where it must be (BIAS, nets with a "
        "TRANSITION between them); round crack tips the program refines by itself");
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
