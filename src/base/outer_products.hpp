// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

namespace spricka::base {

/// Adds factor A B^T to C [m, n], A [m, k], B [n, k], 1 <= k <= 4. What each entry gets is summed
/// up over the columns of A in their order and then scaled; processors with AVX2 take four numbers
/// at once and come to the same bits. For sums over the points of an element, where Eigen would
/// look up an entry of A again for every column of C.
void add_outer_products(double factor, const Eigen::Ref<const Matrix>& A,
                        const Eigen::Ref<const Matrix>& B, Eigen::Ref<Matrix> C);

} // namespace spricka::base
