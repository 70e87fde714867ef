// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "deck/names.hpp"

#include <functional>
#include <optional>

namespace spricka::deck {

/// How the reader of a card comes to the sets that the card names: by a reference; empty after an
/// error, which is reported already. Sets are made of other sets and each is built when it is first
/// named: who builds a set hands in the way to the others.
struct SetFinder {
  std::function<std::optional<base::NodeSetId>(const NameReference&)> nodes;
  std::function<std::optional<base::ElementSetId>(const NameReference&)> elements;
  std::function<std::optional<base::FaceSetId>(const NameReference&)> faces;
};

} // namespace spricka::deck
