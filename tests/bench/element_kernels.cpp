// SPDX-License-Identifier: GPL-3.0-or-later
// Time of one element stiffness, type by type: kernels alone, nothing is assembled.
#include "base/clock.hpp"
#include "fe/element.hpp"
#include "shape/solid.hpp"

#include <cmath>

#include <fmt/format.h>

namespace {

using namespace spricka;

// An element a little off its regular form, so that nothing cancels.
template <shape::ElementShape S> fe::NodeVectors<S> distorted() {
  fe::NodeVectors<S> X;
  for (int n = 0; n < S::nodes; ++n) {
    for (int c = 0; c < S::dim; ++c) {
      X(c, n) = 3.0 + shape::node_local_coordinates<S>(n)[c] + 0.02 * std::sin(1.0 + 3.0 * n + c);
    }
  }
  return X;
}

template <shape::ElementShape S> void measure(model::StressState state) {
  model::ElasticMaterial material;
  material.E = 210e3;
  material.nu = 0.3;
  model::ElementProperty property;
  property.state = state;
  const fe::ConstitutiveLaw law = fe::constitutive_law(material, property, S::type);
  fe::NodeVectors<S> X = distorted<S>();
  constexpr int rounds = 20000;
  double best = 1e300;
  double kept = 0.0; // so that nothing is optimised away
  for (int repeat = 0; repeat < 5; ++repeat) {
    const base::Stopwatch watch;
    for (int i = 0; i < rounds; ++i) {
      X(0, 0) += 1e-12;
      kept += fe::element_stiffness<S>(X, law)(0, 0);
    }
    best = std::min(best, watch.cpu_time() / rounds);
  }
  fmt::print("{:<10} {:>3} points {:8.2f} us   ({:.3g})\n", base::element_info(S::type).name,
             fe::stiffness_rule<S>(law).size(), 1e6 * best, kept / rounds);
}

template <class... Shapes> void measure_all(model::StressState state) {
  (measure<Shapes>(state), ...);
}

} // namespace

int main() {
  using namespace shape;
  measure_all<Trim3, Trimc6, Quam4, Quamc8, Quamc9>(model::StressState::plane_strain);
  measure_all<Tet4, Tet10, Penta6, Pentac15, Hexe8, Hexec20, Hexec27>(model::StressState::solid);
  return 0;
}
