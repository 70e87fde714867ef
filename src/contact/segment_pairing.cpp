// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/segment_pairing.hpp"

#include "contact/make_rows.hpp"
#include "contact/pair_points.hpp"

namespace spricka::contact {

void fill_mortar_rows(PairConstraints& pair, std::optional<double> declared_gap, bool tangents) {
  const MortarPoints points = pair.rigid ? mortar_points(pair.contact, *pair.rigid, declared_gap)
                                         : mortar_points(pair.contact, pair.target, declared_gap);
  pair.found = points.found;
  pair.segments = points.trouble.empty() || points.found;
  pair.trouble = points.trouble;
  if (!points.trouble.empty()) {
    return;
  }
  const int slips = tangents ? 1 : 0; // a curve has one direction along it
  RowsByNode rows = integrate_mortar_rows(points, pair.contact.facets, pair.target.facets, slips);
  for (const EdgeChain& chain : pair.contact.plane.chains) {
    const NodeOrder order{ordered_nodes(pair.contact.plane.edges_of_chain(chain), chain.closed),
                          chain.closed};
    pair.merged += merge_slivers(order, rows);
    append_rows(order, rows, slips, pair);
  }
}

} // namespace spricka::contact
