// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/script_size_request.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace spricka::deck {

/// How much finer than its cards say a net is meshed, in the plane.
struct NetRefinement {
  /// Size of elements wanted at a point [length], for $IMPORT FORMAT=GEO; empty: as its script has.
  mesh::ScriptSizeMap size = {};
  int counts = 1; ///< numbers of elements of $MESH times this
  int splits = 0; ///< how often all other elements are divided into four
};

/// What the command line adds to a deck, and what is too large to try.
struct DeckReadOptions {
  std::vector<std::pair<std::string, std::string>> defines = {}; ///< -D NAME=expression
  /// Nodes of all elements together, counted for each element, that $MESH may make.
  std::size_t largest_mesh = 500'000'000;
  /// One point of the deck's $SWEEP: these parameters take these values.
  std::vector<std::pair<std::string, double>> sweep_values = {};
  std::map<std::string, NetRefinement> refine = {}; ///< by net; "" is what stands in no net
  /// Names of cracks whose own cards say how long they are, whatever lengths $GROW has.
  std::set<std::string> own_lengths = {};
  /// The deck as it was changed since its file was read, its includes in it; empty: as in the file.
  std::optional<std::string> text = {};
};

} // namespace spricka::deck
