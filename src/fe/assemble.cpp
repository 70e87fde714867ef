// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/assemble.hpp"

#include "base/parallel.hpp"
#include "fe/element.hpp"
#include "fe/pattern.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace spricka::fe {

namespace {

constexpr std::size_t max_element_freedoms = 81; // HEXEC27

// Freedoms of an element, node by node.
std::span<const std::int32_t>
element_freedoms(const model::Mesh& mesh, base::ElementId e,
                 std::array<std::int32_t, max_element_freedoms>& freedoms) {
  std::size_t count = 0;
  for (const base::NodeId n : mesh.element_nodes(e)) {
    for (int c = 0; c < mesh.dim; ++c) {
      freedoms[count++] = static_cast<std::int32_t>(n.index()) * mesh.dim + c;
    }
  }
  return std::span<const std::int32_t>(freedoms).first(count);
}

// What a block of coefficients acts on, with dependent freedoms replaced.
std::optional<ConstraintTransformation::BlockTransformation>
reduced(const DofMap& dofs, std::span<const std::int32_t> freedoms) {
  return dofs.ties ? dofs.ties->find_block_transformation(freedoms) : std::nullopt;
}

void add_rows(std::span<const std::int32_t> freedoms, const DofMap& dofs, RowsByBlock& blocks) {
  const std::optional<ConstraintTransformation::BlockTransformation> block =
      reduced(dofs, freedoms);
  std::vector<std::int32_t> rows;
  rows.reserve(freedoms.size());
  for (const std::int32_t freedom :
       block ? std::span<const std::int32_t>(block->freedom) : freedoms) {
    rows.push_back(dofs.row[static_cast<std::size_t>(freedom)]);
  }
  blocks.add(rows);
}

// Adds the coefficients `Ke` on some freedoms, given column-major.
template <class Block>
void add_coefficients(std::span<const std::int32_t> freedoms, const DofMap& dofs, const Block& Ke,
                      std::span<const SystemRowOfBlock> rows, base::SymmetricCsc& K) {
  if (const std::optional<ConstraintTransformation::BlockTransformation> block =
          reduced(dofs, freedoms)) {
    // (fe.34).
    const base::Matrix half = Ke * block->T;
    base::Matrix reduced = block->T.transpose() * half;
    reduced = (0.5 * (reduced + reduced.transpose())).eval(); // symmetric to the last bit
    add_block(K, rows, reduced.data(), reduced.rows());
  } else {
    add_block(K, rows, Ke.data(), Ke.rows());
  }
}

// The rows of each element.
RowsByBlock element_rows(const model::Mesh& mesh, std::span<const base::ElementId> elements,
                         const DofMap& dofs) {
  RowsByBlock blocks;
  std::array<std::int32_t, max_element_freedoms> freedoms{};
  for (const base::ElementId e : elements) {
    add_rows(element_freedoms(mesh, e, freedoms), dofs, blocks);
  }
  return blocks;
}

// Element matrices that are made side by side before they are added, one after the other.
constexpr std::size_t batch_bytes = std::size_t{1} << 24U;

// Calls add(element, matrix) for some elements of one shape in their order; the matrices are made
// on several threads.
template <shape::ElementShape S, class Add>
void for_element_matrices(const model::Model& model, const model::Mesh& mesh,
                          std::span<const base::ElementId> elements, const Add& add) {
  const auto matrix_of = [&](base::ElementId e) {
    return element_stiffness<S>(element_coordinates<S>(mesh, e), constitutive_law(model, mesh, e));
  };
  base::make_and_take_in_order(
      elements.size(), batch_bytes / sizeof(ElementMatrix<S>),
      [&](std::size_t i) { return matrix_of(elements[i]); },
      [&](std::size_t i, const ElementMatrix<S>& matrix) { add(elements[i], matrix); });
}

} // namespace

base::SymmetricCsc stiffness_pattern(const model::Mesh& mesh,
                                     std::span<const base::ElementId> elements,
                                     std::span<const std::vector<std::int32_t>> super_freedoms,
                                     const DofMap& dofs) {
  RowsByBlock blocks = element_rows(mesh, elements, dofs);
  for (const std::vector<std::int32_t>& super : super_freedoms) {
    add_rows(super, dofs, blocks);
  }
  return make_matrix_pattern(dofs.size(), blocks);
}

base::SymmetricCsc assemble_stiffness(const model::Model& model, const model::Mesh& mesh,
                                      std::span<const base::ElementId> elements,
                                      std::span<const Superelement> supers, const DofMap& dofs) {
  RowsByBlock blocks = element_rows(mesh, elements, dofs);
  for (const Superelement& super : supers) {
    add_rows(super.freedom, dofs, blocks);
  }
  base::SymmetricCsc K = make_matrix_pattern(dofs.size(), blocks);

  std::array<std::int32_t, max_element_freedoms> freedoms{};
  // Blocks must come in the order in which their rows were added.
  std::size_t block_number = 0;
  for_shape_blocks(mesh, elements,
                   [&]<shape::ElementShape S>(S, std::span<const base::ElementId> block) {
                     for_element_matrices<S>(
                         model, mesh, block, [&](base::ElementId e, const ElementMatrix<S>& Ke) {
                           add_coefficients(element_freedoms(mesh, e, freedoms), dofs, Ke,
                                            blocks.rows_of_block(block_number), K);
                           ++block_number;
                         });
                   });
  for (const Superelement& super : supers) {
    add_coefficients(super.freedom, dofs, *super.stiffness, blocks.rows_of_block(block_number), K);
    ++block_number;
  }
  return K;
}

} // namespace spricka::fe
