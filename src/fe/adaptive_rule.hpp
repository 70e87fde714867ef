// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/adaptive_domain.hpp"

/// Quadrature rules that follow a field which bends, kinks or jumps within an element: for loads
/// and temperatures given as expressions of the place.
namespace spricka::fe {

/// The usual rule where it agrees with the finer one as to the integrals of the field and its first
/// moments, and where no value at some places between their points leaves those seen; else a rule
/// by pieces, with a bound on the number of evaluations. What lies between all places, as a spot of
/// a twentieth of an element may, is not seen. Compiled in adaptive_rule.cpp for each dimension.
template <int dim>
FieldAdaptedRule<dim> make_adapted_rule(const AdaptiveDomain<dim>& domain,
                                        const ReferenceField<dim>& value,
                                        const AdaptiveSettings& settings);

} // namespace spricka::fe
