// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "base/vec.hpp"
#include "model/forward.hpp"
#include "program/trials/child_run.hpp"
#include "results/stress_invariants.hpp"

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

/// CalculiX (ccx), where it is installed: runs of converted decks, and what they answer.
namespace spricka::program {

/// The file of `ccx` that a shell would start; empty where there is none.
std::filesystem::path find_calculix();

/// A run on one thread of an input file made by abaqus_input_text(); it writes its results, a .frd,
/// beside the input.
ChildRun make_calculix_run(const std::filesystem::path& program, const std::filesystem::path& inp);

/// The input as CalculiX answers it by the nodes of the deck: plane elements are not shown as the
/// layer of solids that it makes of them.
std::string adapt_input_for_calculix(std::string inp, int dim);

/// Displacements and stresses as a program gives them at nodes.
struct NodalFields {
  base::Vector u;                      ///< nodal vector [dim * node]; not a number: not given
  std::vector<results::Stress> stress; ///< mean of the elements at the node [node]
};

/// Reads the last displacements and stresses of a .frd as text, six digits each; `numbers` are
/// those of the nodes there [node]. Empty where it has not both.
std::optional<NodalFields> read_calculix_results(std::string_view text,
                                                 const std::vector<base::Label>& numbers, int dim);

} // namespace spricka::program
