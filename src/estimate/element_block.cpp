// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/element_block.hpp"

#include <array>
#include <cstddef>
#include <cstring>

namespace spricka::estimate {

namespace {

using FourLanes [[gnu::vector_size(32)]] = double;

// Of gradients G = dU/dr in reference coordinates at a point the forces weight det D(G J^-1) J^-T,
// in place, of four lanes from the first of them on. [component][lane] by [coordinate]. Products
// may not be contracted with sums: bits would depend on the processor.
[[gnu::always_inline]] inline void gradients_to_forces_at(const ElementBlock& block,
                                                          const BlockGeometry& geometry,
                                                          Eigen::Index point, Eigen::Index lane,
                                                          Eigen::Index stride, double* G) {
  constexpr Eigen::Index lanes = operator_lanes;
  const auto load = [](const double* from, FourLanes& to) __attribute__((always_inline)) {
    std::memcpy(&to, from, sizeof to);
  };
  std::array<FourLanes, 9> inverse; // [reference coordinate, coordinate]
  for (std::size_t k = 0; k < 9; ++k) {
    load(geometry.inverse.data() + (9 * point + static_cast<Eigen::Index>(k)) * lanes + lane,
         inverse[k]);
  }
  std::array<FourLanes, 9> H; // [component, coordinate]
  for (std::size_t i = 0; i < 3; ++i) {
    const double* at = G + static_cast<Eigen::Index>(i) * lanes;
    std::array<FourLanes, 3> by;
    for (std::size_t j = 0; j < 3; ++j) {
      load(at + static_cast<Eigen::Index>(j) * stride, by[j]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      H[3 * i + k] = by[0] * inverse[k] + by[1] * inverse[3 + k] + by[2] * inverse[6 + k];
    }
  }
  FourLanes volume{};
  FourLanes lambda{};
  FourLanes mu{};
  load(geometry.volume.data() + point * lanes + lane, volume);
  load(block.lambda.data() + lane, lambda);
  load(block.mu.data() + lane, mu);
  const FourLanes m = mu * volume;
  const FourLanes pressure = lambda * volume * (H[0] + H[4] + H[8]);
  const FourLanes xy = m * (H[1] + H[3]);
  const FourLanes xz = m * (H[2] + H[6]);
  const FourLanes yz = m * (H[5] + H[7]);
  const std::array<FourLanes, 9> stress{pressure + 2.0 * m * H[0],
                                        xy,
                                        xz, //
                                        xy,
                                        pressure + 2.0 * m * H[4],
                                        yz, //
                                        xz,
                                        yz,
                                        pressure + 2.0 * m * H[8]};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const FourLanes force = stress[3 * i] * inverse[3 * j] +
                              stress[3 * i + 1] * inverse[3 * j + 1] +
                              stress[3 * i + 2] * inverse[3 * j + 2];
      std::memcpy(G + static_cast<Eigen::Index>(j) * stride + static_cast<Eigen::Index>(i) * lanes,
                  &force, sizeof force);
    }
  }
}

[[gnu::always_inline]] inline void
all_gradients_to_forces(const ElementBlock& block, const BlockGeometry& geometry, base::Matrix& G) {
  for (Eigen::Index p = 0; p < G.cols() / 3; ++p) {
    for (Eigen::Index lane = 0; lane < operator_lanes; lane += 4) {
      gradients_to_forces_at(block, geometry, p, lane, G.rows(),
                             G.data() + 3 * p * G.rows() + lane);
    }
  }
}

void gradients_to_forces_on_any(const ElementBlock& block, const BlockGeometry& geometry,
                                base::Matrix& G) {
  all_gradients_to_forces(block, geometry, G);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void gradients_to_forces_on_avx2(const ElementBlock& block,
                                                         const BlockGeometry& geometry,
                                                         base::Matrix& G) {
  all_gradients_to_forces(block, geometry, G);
}
#endif

auto gradients_to_forces_for_processor() {
#if defined(__x86_64__)
  __builtin_cpu_init();
  return __builtin_cpu_supports("avx2") != 0 ? gradients_to_forces_on_avx2
                                             : gradients_to_forces_on_any;
#else
  return gradients_to_forces_on_any;
#endif
}

} // namespace

void gradients_to_forces(const ElementBlock& block, const BlockGeometry& geometry,
                         base::Matrix& G) {
  static const auto turn = gradients_to_forces_for_processor();
  turn(block, geometry, G);
}

} // namespace spricka::estimate
