// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/bodies/condensation_request.hpp"
#include "contact/system.hpp"
#include "fe/assemble.hpp"

#include <memory>
#include <string>
#include <vector>

/// Processors STIFFNESS and CONDENSE: every body becomes a small dense system on its external
/// freedoms. What did not change since the last increment is taken from the cache.
namespace spricka::analysis {

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

/// The bodies of the mesh with their rigid modes, split into nets whose freedoms are numbered;
/// nothing is assembled or factorised. Floating bodies get carriers among their externals.
std::vector<SubstructuredBody> partition_bodies(const CondensationRequest& request);

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
