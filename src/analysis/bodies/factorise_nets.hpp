// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/bodies/condensation_request.hpp"
#include "fe/assemble.hpp"

#include <memory>
#include <string>
#include <vector>

/// The matrices of nets and their factors.
namespace spricka::analysis {

/// A net that is to have its factor.
struct NetTask {
  Substructure* net = nullptr;
  results::NetCost work;                ///< its name is given, what it took is found
  std::vector<fe::Superelement> supers; ///< condensed nets that stand in it
  HashKey key;                          ///< in the cache
  bool layered = false;                 ///< its externals may stay a factor
  std::shared_ptr<const solve::FirstBlockFactor> early; ///< of its part, given or made
  double stiffness_wall = 0.0;                          ///< [s]
};

/// Gives nets their factors: those that the cache has, or new ones, of several nets at once on the
/// threads and ranks of the request, which the cache keeps then. No bit depends on either.
void factorise_nets(const CondensationRequest& request, std::vector<NetTask>& tasks,
                    CondensationCache& cache, CondensationStatistics& log);

/// Why the net of a body has no factor, if it has none.
base::OptionalFailure factorisation_failure(const model::Mesh& mesh, const std::string& body,
                                            const Substructure& net);

} // namespace spricka::analysis
