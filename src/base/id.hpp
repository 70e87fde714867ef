// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <compare>
#include <cstddef>
#include <cstdint>

namespace spricka::base {

/// A strong index: the tag says what is counted, so that a node never stands where an element is
/// meant. The default is "none".
template <class Tag> struct Id {
  std::int32_t value = -1;

  constexpr Id() = default;
  constexpr explicit Id(std::size_t i) : value(static_cast<std::int32_t>(i)) {}
  [[nodiscard]] constexpr std::size_t index() const { return static_cast<std::size_t>(value); }
  [[nodiscard]] constexpr bool valid() const { return value >= 0; }
  constexpr auto operator<=>(const Id&) const = default;
};

using NodeId = Id<struct NodeTag>;
using ElementId = Id<struct ElementTag>;
using NetId = Id<struct NetTag>;
using PropertyId = Id<struct PropertyTag>;
using MaterialId = Id<struct MaterialTag>;
using NodeSetId = Id<struct NodeSetTag>;
using ElementSetId = Id<struct ElementSetTag>;
using FaceSetId = Id<struct FaceSetTag>;
using CaseId = Id<struct CaseTag>;
using ContactId = Id<struct ContactTag>;
using CrackId = Id<struct CrackTag>;
using StepId = Id<struct StepTag>;
using RigidId = Id<struct RigidTag>;

/// The number a deck gives to a node or an element; unique within its net, never an array index.
using Label = std::int64_t;

} // namespace spricka::base
