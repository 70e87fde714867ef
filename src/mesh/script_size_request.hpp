// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/size_map.hpp"

#include <memory>

namespace spricka::mesh {

/// Element sizes wanted in a geometry script, in its own coordinates: those of a map that counts in
/// lengths of the deck, one unit of the script being `scale` of them. Where the script asks for
/// less, its request stands. False without a map: as the script has it.
struct ScriptSizeMap {
  std::shared_ptr<const SizeMap> map = nullptr;
  double scale = 1.0;

  explicit operator bool() const { return map != nullptr; }
  [[nodiscard]] double operator()(double x, double y) const {
    return (*map)({x * scale, y * scale}) / scale;
  }
};

} // namespace spricka::mesh
