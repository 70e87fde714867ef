// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "base/vec.hpp"
#include "contact/condensed_body.hpp"
#include "contact/constraint.hpp"
#include "fe/dof_map.hpp"
#include "model/forward.hpp"
#include "results/run_profile.hpp"
#include "solve/condense.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// What condensation is asked for and what it keeps, net by net.
namespace spricka::analysis {

/// A factorised piece of a body: some elements, possibly with a condensed neighbour in it.
struct Substructure {
  std::vector<base::ElementId> elements;
  fe::DofMap map;
  /// Of the region of a body that is not condensed: the unknowns of its contact_freedoms() that
  /// rows weigh.
  std::vector<Eigen::Index> weighed;
  std::shared_ptr<solve::Condensation> factor;
};

/// Keyed by a 128-bit hash of geometry, connectivity, materials, classes and externals.
using HashKey = std::pair<std::uint64_t, std::uint64_t>;
struct CondensationCache {
  std::map<HashKey, std::shared_ptr<solve::Condensation>> nets;
  std::map<HashKey, std::shared_ptr<const contact::CondensedBody>> bodies;
  std::map<HashKey, std::shared_ptr<const solve::FirstBlockFactor>>
      early; ///< by the part they are of
};

/// Figures for the listing.
struct CondensationStatistics {
  double analysis_cpu = 0.0, numeric_cpu = 0.0; ///< [s], summed over nets condensed now
  double stiffness_cpu = 0.0;
  double flops = 0.0;
  int condensed = 0, reused = 0;
  std::vector<results::NetCost> nets; ///< what each took, parts before the regions that they are in
  /// Of nets whose solution is less exact than that of a direct engine: which, and by how much.
  std::vector<std::string> inexact;
  base::OptionalFailure trouble; ///< a singular local block, named, or too little memory
};

/// Whether bodies are condensed to the freedoms that rows weigh, or the rows are eliminated with
/// their sparse factor. Automatic: by rows in space, where surfaces have many nodes.
enum class CondensationMode { automatic, to_freedoms };

struct CondensationRequest {
  const model::Model& model;
  const model::Mesh& mesh;
  std::vector<model::FreedomRole> cls; ///< [dim * node], contact nodes external
  std::shared_ptr<const fe::ConstraintTransformation> ties;
  std::vector<bool> rest_element; ///< [element] belongs to what no crack will touch
  base::Matrix case_load;         ///< [dim * node, case] consistent loads, supports' pull in
  int threads = 1;
  std::vector<const contact::ConstraintRow*> rows = {}; ///< that will be asked for
  CondensationMode condensing = CondensationMode::automatic;
  solve::EquationEngine engine = solve::EquationEngine::automatic;
};

/// What a solution needs for dense matrices of these rows [bytes]: compliances, those in force and
/// a factor, and with friction the scaled ones.
double contact_solution_memory(const std::vector<const contact::ConstraintRow*>& rows);
/// How the nets of a request are condensed.
solve::CondensationSettings condensation_settings(const CondensationRequest& request);

/// The rows of a net's system that some freedoms have, -1: none.
std::vector<std::int64_t> equation_numbers(const fe::DofMap& map,
                                           std::span<const std::int32_t> freedom);
/// Whether the condensed parts of a net stay out of its sparse matrix. Ties need them in it.
bool keeps_parts_as_dense_blocks(const fe::DofMap& map,
                                 std::span<const solve::CondensedNetBlock> blocks);

/// Rows of a nodal matrix [dim * node, k] by freedom, those before `from` left out.
base::Matrix rows_of_freedoms(const base::Matrix& nodal, const std::vector<std::int32_t>& freedom,
                              std::size_t from = 0);

} // namespace spricka::analysis
