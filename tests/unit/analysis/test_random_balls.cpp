// SPDX-License-Identifier: GPL-3.0-or-later
// Balls on balls, on flats and in sockets, of random radii, materials and meshes, rolled so that
// the contact lies elsewhere on the meshes: the pressure is that of Hertz (1882), less by less than
// a quarter over the number of elements in its radius.
#include "tests/places.hpp"
#include "tests/unit/support/solved_text.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <random>
#include <string>

#include <fmt/format.h>

namespace spricka::test_random_balls {
namespace {

constexpr double pi = std::numbers::pi;

struct Body {
  double R; // 0: flat
  double E, nu, h, off, turn;
};

struct Balls {
  std::array<Body, 2> body; // above and below
  double a = 0.0;           // radius of contact
  double modulus = 0.0;     // 1 / ((1 - nu^2)/E + (1 - nu^2)/E)
  double radius = 0.0;      // 1 / (1/R + 1/R)
  std::string deck;
};

class BallDice {
public:
  explicit BallDice(unsigned seed) : engine_(seed) {}
  double real(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(engine_);
  }
  // even in its logarithm
  double ratio(double from, double to) { return std::exp(real(std::log(from), std::log(to))); }

private:
  std::mt19937 engine_;
};

// The field of a point force (Boussinesq) at a place `sign` times z within the half space, of which
// that of Hertz differs at 8 contact radii by a percent.
std::string far_field(int body, const char* sign) {
  return fmt::format(
      "  FAR{0}  (k{0}*x*({1}z/sqrt(x^2+y^2+z^2)^3 - m{0}/(sqrt(x^2+y^2+z^2)*(sqrt(x^2+y^2+z^2) "
      "{1} z))))\n"
      "      & (k{0}*y*({1}z/sqrt(x^2+y^2+z^2)^3 - m{0}/(sqrt(x^2+y^2+z^2)*(sqrt(x^2+y^2+z^2) "
      "{1} z))))\n"
      "      & ({1}k{0}*(z^2/sqrt(x^2+y^2+z^2)^3 + 2*(1 - nu{0})/sqrt(x^2+y^2+z^2)){2})\n",
      body, sign, body == 1 ? " - a^2/rs" : "");
}

void format_deck_card_list(Balls& balls, unsigned seed, BallDice& dice) {
  static constexpr std::array methods{1, 5, 6};
  std::string deck = "$DECK VERSION=1 LENGTH=mm FORCE=N\n$PARAMETER\n";
  for (int b = 1; b <= 2; ++b) {
    const Body& body = balls.body[static_cast<std::size_t>(b - 1)];
    deck += fmt::format("  R{0} = {1}\n  E{0} = {2}\n  nu{0} = {3}\n  h{0} = {4}\n  off{0} = {5}\n"
                        "  turn{0} = {6}\n  m{0} = 1 - 2*nu{0}\n",
                        b, body.R, body.E, body.nu, body.h, body.off, body.turn);
  }
  deck += fmt::format("  a = {}\n  es = {}\n  rs = {}\n  seed = {}\n  method = {}\n", balls.a,
                      balls.modulus, balls.radius, seed,
                      methods[static_cast<std::size_t>(dice.real(0.0, 2.999))]);
  const bool turned = dice.real(0.0, 1.0) < 0.5;
  deck += fmt::format(R"(  P = 4*es*a^3/(3*rs)
  k1 = P*(1 + nu1)/(2*pi*E1)
  k2 = P*(1 + nu2)/(2*pi*E2)
$IMPORT FILE='{}/tests/unit/analysis/balls.geo' FORMAT=GEO
$MATERIAL NAME=M1 E=(E1) NU=(nu1)
$MATERIAL NAME=M2 E=(E2) NU=(nu2)
$PROPERTY ESET=UP MATERIAL=M1 STATE=SOLID
$PROPERTY ESET=DOWN MATERIAL=M2 STATE=SOLID
$FREEDOM CLASS=PRESCRIBED DOF=XYZ
  FAR1 FAR2
$CONTACT NAME=C SLAVE={} MASTER={}
$LOAD CASE=PRESS TYPE=DISP
{}{}$STEP NAME=PRESS
  LOAD PRESS 1
$END
)",
                      test::source_folder(), turned ? "CAP2" : "CAP1", turned ? "CAP1" : "CAP2",
                      far_field(1, "+"), far_field(2, "-"));
  balls.deck = std::move(deck);
}

// The smaller radius is 20, the contact 2 % of it: what the half space leaves out is a percent.
Balls random_balls(unsigned seed) {
  BallDice dice(seed);
  const double kind = dice.real(0.0, 1.0);
  const double R = 20.0;
  const double other = kind < 0.2   ? 0.0
                       : kind < 0.6 ? R * dice.ratio(0.2, 5.0)
                                    : -R * dice.ratio(1.2, 5.0); // a socket
  Balls balls;
  balls.a = 0.02 * (other != 0.0 ? std::min(R, std::abs(other)) : R);
  const double n = dice.real(2.8, 4.8);
  const double coarser = dice.ratio(0.55, 1.8);
  for (std::size_t b = 0; b < balls.body.size(); ++b) {
    const double elements = b == 0 ? n : std::clamp(n / coarser, 2.5, 5.0);
    balls.body[b] = {.R = b == 0 ? R : other,
                     .E = dice.ratio(70e3, 400e3),
                     .nu = dice.real(0.1, 0.4),
                     .h = balls.a / elements,
                     .off = dice.real(0.0, 0.4) * balls.a,
                     .turn = dice.real(0.0, 2.0 * pi)};
    balls.modulus += (1.0 - balls.body[b].nu * balls.body[b].nu) / balls.body[b].E;
    balls.radius += balls.body[b].R != 0.0 ? 1.0 / balls.body[b].R : 0.0;
  }
  balls.modulus = 1.0 / balls.modulus;
  balls.radius = 1.0 / balls.radius;
  format_deck_card_list(balls, seed, dice);
  return balls;
}

struct Found {
  double error = 0.0;    // of the multipliers, root mean square over the surface over Hertz' own
  double elements = 0.0; // of the contact side in the radius of contact, by the area of faces
  double force = 0.0;    // over Hertz' for the approach
};

// Hertz' pressure for the force that is found: what a body of finite size does to the force for a
// given approach is not an error of the pressure.
Found compare(const Balls& balls, const results::ContactResult& contact) {
  const double P = std::abs(contact.force_on_slave.z());
  const double a = std::cbrt(3.0 * P * balls.radius / (4.0 * balls.modulus));
  const double p0 = 1.5 * P / (pi * a * a);
  double wrong = 0.0;
  double all = 0.0;
  double area = 0.0;
  int triangles = 0;
  for (std::size_t t = 0; t + 2 < contact.corners.size(); t += 3) {
    std::array<const results::ContactPoint*, 3> at{};
    base::Vec3 middle = base::Vec3::Zero();
    for (std::size_t k = 0; k < at.size(); ++k) {
      at[k] = &contact.points[static_cast<std::size_t>(contact.corners[t + k])];
      middle += at[k]->x / 3.0;
    }
    const double A = 0.5 * (at[1]->x - at[0]->x).cross(at[2]->x - at[0]->x).norm();
    if (middle.head<2>().norm() < a) {
      area += A;
      ++triangles;
    }
    for (const results::ContactPoint* point : at) {
      const double r = point->x.head<2>().norm() / a;
      const double exact = r < 1.0 ? p0 * std::sqrt(1.0 - r * r) : 0.0;
      wrong += A * std::pow(point->p_consistent - exact, 2);
      all += A * exact * exact;
    }
  }
  // four triangles a face, which is as good as equilateral
  const double side = std::sqrt(4.0 * area / triangles * 4.0 / std::sqrt(3.0));
  return {std::sqrt(wrong / all), a / side,
          P / (4.0 * balls.modulus * std::pow(balls.a, 3)) * 3.0 * balls.radius};
}

TEST(RandomBalls, PressHertzPressure) {
  const unsigned tries = test::full_size() ? 200U : 3U;
  double worst = 0.0;
  double sum = 0.0;
  for (unsigned seed = 1; seed <= tries; ++seed) {
    const Balls balls = random_balls(seed);
    SCOPED_TRACE(fmt::format("seed {}\n{}", seed, balls.deck));
    const std::optional<test::Solved> solved = test::solve_text(balls.deck);
    if (!solved) {
      continue; // a failure
    }
    const results::LoadStepResult& step = solved->step();
    const results::ContactResult& contact = step.contacts.front();
    const Found found = compare(balls, contact);
    const double n = balls.a / std::min(balls.body[0].h, balls.body[1].h);
    EXPECT_LT(found.error * n, 0.25);
    EXPECT_LT(found.error * found.elements, 0.3); // gmsh makes faces up to a third smaller
    EXPECT_NEAR(found.force, 1.0, 0.03);
    EXPECT_GE(contact.min_pressure, 0.0);
    EXPECT_LE(step.iterations, 12);
    EXPECT_EQ(step.pivots, 0);
    worst = std::max(worst, found.error * n);
    sum += found.error * n;
    std::printf("seed %u: R %.3g, E %.2f, n %.2f of %.2f and %.2f: error %.2f %% = %.1f %% / n, "
                "force %.4f, %d iterations, %d pivots\n",
                seed, balls.body[1].R / balls.body[0].R, balls.body[1].E / balls.body[0].E,
                found.elements, balls.a / balls.body[0].h, balls.a / balls.body[1].h,
                100.0 * found.error, 100.0 * found.error * n, found.force, step.iterations,
                step.pivots);
    std::fflush(stdout);
  }
  std::printf("mean %.1f %%, worst %.1f %% over the number of elements\n", 100.0 * sum / tries,
              100.0 * worst);
}

} // namespace
} // namespace spricka::test_random_balls
