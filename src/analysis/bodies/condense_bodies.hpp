// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "contact/system.hpp"
#include "fe/assemble.hpp"
#include "fe/dof_map.hpp"
#include "model/forward.hpp"
#include "results/run_profile.hpp"
#include "solve/condense.hpp"

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// Processors STIFFNESS and CONDENSE: every body becomes a small dense system on its external
/// freedoms. What did not change since the last increment is taken from the cache.
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

/// A body ready for contact: what elements and ties hold together. Its `parts` are condensed first,
/// to their rims, tied and external nodes, and enter the `region` as big elements. Where a crack
/// grows, what no length touches is a part; where several nets of the deck are tied to a body, each
/// is one. A plain body is all region. A body that stays uncondensed has only what holds it
/// external, and contact sees all of its unknowns: the locals of its parts, then the region's.
struct SubstructuredBody {
  std::string name; ///< "LUG", "LUG/2", "COARSE+FINE"
  fe::Body body;    ///< all pieces together
  std::vector<fe::Body> pieces;
  std::vector<std::unique_ptr<Substructure>> parts;
  Substructure region;
  base::Matrix free_rigid_modes; ///< [dim * node, r] rigid modes that supports leave free
  std::shared_ptr<const contact::CondensedBody> condensed; ///< null when there are no externals
  std::vector<base::Matrix> part_load;                     ///< [part][unknowns of the part, case]
  base::Matrix region_load;   ///< [unknowns of region, case], part_load added in
  base::Matrix external_load; ///< [unknowns that contact sees, case] condensed
  /// The same of an uncondensed body: what each case alone moves, without rigid motions.
  base::Matrix case_motion;

  [[nodiscard]] bool is_uncondensed() const { return !region.weighed.empty(); }
  /// Freedoms of the unknowns that contact sees.
  [[nodiscard]] std::vector<std::int32_t> contact_freedoms() const;
  [[nodiscard]] std::int64_t contact_unknown_count() const;
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

/// The bodies of the mesh with their rigid modes, split into nets whose freedoms are numbered;
/// nothing is assembled or factorised. Floating bodies get carriers among their externals.
std::vector<SubstructuredBody> partition_bodies(const CondensationRequest& request);

/// The rows of a net's system that some freedoms have, -1: none.
std::vector<std::int64_t> equation_numbers(const fe::DofMap& map,
                                           std::span<const std::int32_t> freedom);
/// Whether the condensed parts of a net stay out of its sparse matrix. Ties need them in it.
bool keeps_parts_as_dense_blocks(const fe::DofMap& map,
                                 std::span<const solve::CondensedNetBlock> blocks);

/// Whether the externals of a body may stay a factor, in which what its one part has for itself is
/// eliminated first: not where rigid modes are free.
bool externals_can_stay_factorised(const SubstructuredBody& body);

/// What tells a body's nets from others.
struct SubstructureHashes {
  std::vector<HashKey> parts;
  HashKey region;
};
/// Hash keys of all bodies: one of each part, and one of the region, into which those of the parts
/// go.
std::vector<SubstructureHashes> hash_bodies(const CondensationRequest& request,
                                            const std::vector<SubstructuredBody>& bodies);

/// Builds all bodies of the mesh, nets in parallel, results in body order whatever the threads.
std::vector<SubstructuredBody> condense_bodies(const CondensationRequest& request,
                                               CondensationCache& cache,
                                               CondensationStatistics& log);

/// Loads on the unknowns of a body's nets, and what they come to at its externals.
struct CondensedLoad {
  std::vector<base::Matrix> part; ///< [part][unknowns of the part, k]
  base::Matrix region;            ///< [unknowns of the region, k], the parts' added in
  base::Matrix external;          ///< [externals, k]
};
/// nodal [dim * node, k], on independent freedoms. Any other linear functional of the displacements
/// is condensed by the same.
CondensedLoad condense_load(const SubstructuredBody& body, const fe::ConstraintTransformation& ties,
                            const base::Matrix& nodal);

/// Writes what a load moves in one body into u [dim * node, k]: from its external displacements
/// [externals, k]. u holds the prescribed displacements; constants of ties count `constant` times.
void recover_body_displacements(const SubstructuredBody& body, const base::Matrix& u_external,
                                const CondensedLoad& load, double constant, base::Matrix& u);

/// Writes the displacements of one body into a nodal vector that holds the prescribed ones: from
/// its external displacements and the case factors.
void recover_body_displacements(const SubstructuredBody& body, const base::Vector& u_external,
                                const base::Vector& case_factors, base::Vector& u);

} // namespace spricka::analysis
