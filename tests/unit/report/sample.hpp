// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/source.hpp"
#include "model/model.hpp"
#include "results/results.hpp"

/// A made-up run for the tests of the writers: a sleeve in a ring with an edge crack at the top,
/// curved elements of three types, two lengths, three steps. Its fields are formulas, so that a
/// reader can compute what every file must hold.
namespace spricka::test {

inline constexpr double bore = 36.0;  ///< radius between sleeve and ring
inline constexpr double rim = 80.0;   ///< outer radius
inline constexpr double sigma = 70.0; ///< nominal stress

/// u = (1e-3 x + 2e-5 x y, -5e-4 y + 1e-5 x^2), times the step's factor.
base::Vec2 displacement(const base::Vec3& x);

/// Nodal stress (x, y, 0, x y / 10, 0, 0), times the step's factor.
std::array<double, 6> stress(const base::Vec3& x);

/// K1 = sigma sqrt(pi a) (1 + 1 / (1 + a / bore)), K2 = -0.05 K1.
double k1(double a);

/// Pressure at the bore, times the step's factor; positive for |theta| < 120 degrees.
double pressure(double theta);

struct Sample {
  base::SourceTexts sources;
  model::Model model;
  results::RunResult run;
};
Sample make_sample();

} // namespace spricka::test
