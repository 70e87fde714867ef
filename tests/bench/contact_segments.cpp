// SPDX-License-Identifier: GPL-3.0-or-later
// What the integrals of contact between solids cost, against condensing its bodies. Usage:
// bench_contact_segments DECK [REPEATS]: the pairs of the deck's first length.
#include "analysis/lengths/length.hpp"
#include "base/clock.hpp"
#include "base/diagnostics.hpp"
#include "contact/make_rows.hpp"
#include "contact/pair_points.hpp"
#include "contact/space/clip.hpp"
#include "deck/read_deck.hpp"
#include "growth/crack_lines.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace {

using namespace spricka;
using base::Vec3;

// How many polygons the triangles of both surfaces have in common, as Sighting clips them.
class Segments {
public:
  Segments(const contact::FacetSurface& own, const contact::FacetSurface& target)
      : own_(own), target_(target) {}

  [[nodiscard]] std::size_t count() const {
    std::size_t sum = 0;
    const double reach = 0.2 * own_.extent;
    for (const contact::HatElement& t : own_.elements) {
      const std::array<Vec3, 3> x = corners(own_, t);
      const Vec3 n = (x[1] - x[0]).cross(x[2] - x[0]).normalized();
      const Vec3 e = (x[1] - x[0]).normalized();
      const auto flat = [&](const Vec3& y) {
        return base::Vec2((y - x[0]).dot(e), (y - x[0]).dot(n.cross(e)));
      };
      const contact::PlaneTriangle here{flat(x[0]), flat(x[1]), flat(x[2])};
      for (const contact::HatElement& s : target_.elements) {
        const std::array<Vec3, 3> y = corners(target_, s);
        const contact::PlaneTriangle there{flat(y[0]), flat(y[2]), flat(y[1])};
        sum += std::abs((y[0] - x[0]).dot(n)) < reach && contact::twice_area(there) > 0.0 &&
                       area(contact::intersect_triangles(here, there)) >
                           1e-12 * contact::twice_area(here)
                   ? 1U
                   : 0U;
      }
    }
    return sum;
  }

private:
  static std::array<Vec3, 3> corners(const contact::FacetSurface& surface,
                                     const contact::HatElement& t) {
    const geometry::SidePositions& X = surface.facets[t.facet].X;
    return {X.col(t.node[0]), X.col(t.node[1]), X.col(t.node[2])};
  }
  static double area(const std::vector<base::Vec2>& polygon) {
    double twice = 0.0;
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
      twice += contact::twice_area({polygon[0], polygon[k], polygon[k + 1]});
    }
    return twice;
  }

  const contact::FacetSurface& own_;
  const contact::FacetSurface& target_;
};

std::size_t points_of(const contact::PairConstraints& pair) {
  const auto see = contact::make_target_projector(pair);
  std::size_t sum = 0;
  for (const contact::HatElement& t : pair.contact.elements) {
    sum += see(t).points.size();
  }
  return sum;
}

// CPU seconds of one pair's rows, the best of several.
double time_rows(const contact::PairConstraints& pair, const model::Contact& card, int repeats) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repeats; ++i) {
    contact::PairConstraints again = pair;
    again.functions.clear();
    again.normal.clear();
    again.tangent.clear();
    const base::Stopwatch watch;
    contact::fill_mortar_rows(again, contact::make_target_projector(again),
                              {.declared_gap = card.gap, .tangents = !pair.tangent.empty()});
    best = std::min(best, watch.cpu_time());
  }
  return best;
}

} // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "usage: bench_contact_segments DECK [REPEATS]\n");
    return 2;
  }
  const int repeats = argc > 2 ? std::atoi(argv[2]) : 5;
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  const std::optional<model::Model> model = deck::read_deck(argv[1], {}, sources, diagnostics);
  if (!model || diagnostics.has_errors()) {
    fmt::print(stderr, "the deck has mistakes\n");
    return 2;
  }
  const std::vector<double> lengths = growth::growth_loop_crack_lengths(*model);
  analysis::CrackRegionPlan plan = analysis::plan_crack_region(*model, lengths, diagnostics);
  analysis::CondensationCache cache;
  const auto length = analysis::CrackLengthAnalysis::create({.model = *model, .cache = cache},
                                                            lengths.front(), plan, diagnostics);
  if (!length) {
    fmt::print(stderr, "the deck has mistakes\n");
    return 2;
  }
  double all = 0.0;
  for (std::size_t c = 0; c < length->discretisation().pairs.size(); ++c) {
    const contact::PairConstraints& pair = length->discretisation().pairs[c];
    if (pair.contact.dim == 2 || pair.rigid_shape) {
      continue;
    }
    const double time = time_rows(pair, model->contacts[c], repeats);
    const std::size_t segments = Segments(pair.contact, pair.target).count();
    const std::size_t points = points_of(pair);
    fmt::print("{}: {} triangles on {}, {} segments, {} points, {} rows, {:.2f} ms: {:.2f} us a "
               "segment, {:.2f} us a point\n",
               model->contacts[c].name, pair.contact.elements.size(), pair.target.elements.size(),
               segments, points, pair.normal.size(), 1e3 * time,
               1e6 * time / static_cast<double>(segments),
               1e6 * time / static_cast<double>(points));
    all += time;
  }
  analysis::CondensationStatistics log;
  const base::Stopwatch watch;
  if (!length->condense(log)) {
    fmt::print(stderr, "a net is singular\n");
    return 2;
  }
  const double condensing = watch.cpu_time();
  fmt::print("condensing {:.1f} ms: the rows take {:.2f} % of it\n", 1e3 * condensing,
             100.0 * all / condensing);
  return 0;
}
