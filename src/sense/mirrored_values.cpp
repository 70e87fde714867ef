// SPDX-License-Identifier: GPL-3.0-or-later
#include "sense/mirrored_values.hpp"

#include "model/loads.hpp"

#include <cmath>

namespace spricka::sense {

bool load_values_are_mirrored(const Reflection& mirror, const model::Load& one,
                              const model::Load& other,
                              const std::vector<fe::LoadEvaluationPoint>& places) {
  constexpr double round_off = 1e-9;
  if (one.value.size() != other.value.size()) {
    return false;
  }
  // A pressure and a temperature have no direction.
  const bool scalar =
      one.type == model::LoadType::pressure || one.type == model::LoadType::temperature;
  double size = 0.0;
  double off = 0.0;
  for (const fe::LoadEvaluationPoint& place : places) {
    for (std::size_t c = 0; c < one.value.size(); ++c) {
      const double sign = !scalar && static_cast<int>(c) == mirror.axis ? -1.0 : 1.0;
      const double here = one.value[c](place.x);
      size += place.size * std::abs(here);
      off += place.size * std::abs(sign * here - other.value[c](mirror(place.x)));
    }
  }
  return off <= round_off * size;
}

std::optional<std::size_t>
find_item_without_image(std::size_t count,
                        const std::function<bool(std::size_t, std::size_t)>& answers) {
  std::vector<bool> paired(count, false);
  for (std::size_t i = 0; i < count; ++i) {
    paired[i] = answers(i, i);
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count && !paired[i]; ++j) {
      if (!paired[j] && answers(i, j)) {
        paired[i] = paired[j] = true;
      }
    }
    if (!paired[i]) {
      return i;
    }
  }
  return std::nullopt;
}

} // namespace spricka::sense
