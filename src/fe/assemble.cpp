// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/assemble.hpp"

#include "fe/element.hpp"
#include "fe/pattern.hpp"

#include <array>

namespace spricka::fe {

namespace {

constexpr std::size_t max_element_freedoms = 81; // HEXEC27

BlockRows element_rows(const model::Mesh& mesh, std::span<const base::ElementId> elements,
                       const DofMap& dofs) {
  BlockRows blocks;
  const auto dim = static_cast<std::size_t>(mesh.dim);
  std::array<std::int32_t, max_element_freedoms> rows{};
  for (const base::ElementId e : elements) {
    std::size_t count = 0;
    for (const base::NodeId n : mesh.nodes_of(e)) {
      for (std::size_t c = 0; c < dim; ++c) {
        rows[count++] = dofs.row[dim * n.index() + c];
      }
    }
    blocks.add(std::span<const std::int32_t>(rows).first(count));
  }
  return blocks;
}

void add_super_rows(BlockRows& blocks, std::span<const std::int32_t> freedoms, const DofMap& dofs) {
  std::vector<std::int32_t> rows;
  rows.reserve(freedoms.size());
  for (const std::int32_t freedom : freedoms) {
    rows.push_back(dofs.row[static_cast<std::size_t>(freedom)]);
  }
  blocks.add(rows);
}

} // namespace

base::SymmetricCsc stiffness_pattern(const model::Mesh& mesh,
                                     std::span<const base::ElementId> elements,
                                     std::span<const std::vector<std::int32_t>> super_freedoms,
                                     const DofMap& dofs) {
  BlockRows blocks = element_rows(mesh, elements, dofs);
  for (const std::vector<std::int32_t>& freedoms : super_freedoms) {
    add_super_rows(blocks, freedoms, dofs);
  }
  return make_pattern(dofs.size(), blocks);
}

base::SymmetricCsc assemble_stiffness(const model::Model& model, const model::Mesh& mesh,
                                      std::span<const base::ElementId> elements,
                                      std::span<const Superelement> supers, const DofMap& dofs) {
  BlockRows blocks = element_rows(mesh, elements, dofs);
  for (const Superelement& super : supers) {
    add_super_rows(blocks, super.freedom, dofs);
  }
  base::SymmetricCsc K = make_pattern(dofs.size(), blocks);

  std::size_t block_number = 0;
  for_blocks(mesh, elements, [&]<shape::ElementShape S>(S, std::span<const base::ElementId> block) {
    for (const base::ElementId e : block) {
      const ElementMatrix<S> Ke =
          element_stiffness<S>(coordinates<S>(mesh, e), law_of(model, mesh, e));
      add_block(K, blocks.of(block_number), Ke.data(), Ke.rows());
      ++block_number;
    }
  });
  for (const Superelement& super : supers) {
    add_block(K, blocks.of(block_number), super.stiffness.data(), super.stiffness.rows());
    ++block_number;
  }
  return K;
}

} // namespace spricka::fe
