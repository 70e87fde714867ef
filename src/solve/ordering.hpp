// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/sparse.hpp"

#include <cstdint>
#include <vector>

namespace spricka::solve {

/// How the locals are ordered. Automatic: AMD for graphs as thin as those of plane problems (its
/// analysis is four times cheaper), METIS nested dissection for the others (a third of the flops).
enum class OrderingMethod { automatic, amd, metis };

/// Elimination order [n] of K (row of K at each position): the locals by a fill-reducing order of
/// their own graph, postordered, then the externals as they are. Externals must not be mixed into
/// the locals by a postorder of the whole tree, hence by hand.
/// Neighbouring rows with the same pattern (the freedoms of a node) are ordered as one vertex.
/// Throws std::bad_alloc.
std::vector<std::int64_t> elimination_order(const base::SymmetricCsc& K, std::int64_t locals,
                                            OrderingMethod ordering);

/// K with its rows and columns in another order ([n] row of K at each position), each entry in the
/// column that comes first there; rows of a column as they come. From its diagonal on the column at
/// the place `full_column` has all rows, zeros where K has no entry; none has where it is n.
/// Without values in K the pattern alone.
base::SymmetricCsc reorder(const base::SymmetricCsc& K, const std::vector<std::int64_t>& order,
                           std::int64_t full_column);

} // namespace spricka::solve
