// SPDX-License-Identifier: GPL-3.0-or-later
// The floor: plain assemble, factorise, solve of a cracked lug, all bodies in one matrix and no
// contact, by the same elements and CHOLMOD: called plainly, and with this program's ordering.
// Prints one line. Usage: bench_plain_lug DECK FINE COUNT
#include "analysis/bodies/whole_stiffness.hpp"
#include "analysis/scene/make_scene.hpp"
#include "base/clock.hpp"
#include "base/diagnostics.hpp"
#include "base/messages.hpp"
#include "deck/read_deck.hpp"
#include "growth/crack_lines.hpp"
#include "model/model.hpp"
#include "solve/cholmod_session.hpp"
#include "solve/condense.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace {

using namespace spricka;

struct Way {
  bool own;   ///< CHOLMOD by itself as it comes, or with this program's ordering
  bool metis; ///< else AMD
  double cpu = 0.0;
};

// One entry of the solution, so that nothing is left out.
double by_cholmod(base::SymmetricCsc K, bool metis) {
  solve::CholmodSession session;
  session->supernodal = CHOLMOD_SUPERNODAL;
  session->nmethods = 1;
  session->method[0].ordering = metis ? CHOLMOD_METIS : CHOLMOD_AMD;
  cholmod_sparse A = solve::cholmod_lower_view(K.n, K.start.data(), K.row.data(), K.value.data());
  cholmod_factor* L = cholmod_l_analyze(&A, session.get());
  cholmod_l_factorize(&A, L, session.get());
  cholmod_dense* f = cholmod_l_ones(static_cast<std::size_t>(K.n), 1, CHOLMOD_REAL, session.get());
  cholmod_dense* u = cholmod_l_solve(CHOLMOD_A, L, f, session.get());
  const double first = static_cast<const double*>(u->x)[0];
  cholmod_l_free_dense(&u, session.get());
  cholmod_l_free_dense(&f, session.get());
  cholmod_l_free_factor(&L, session.get());
  return first;
}

double once(const model::Model& model, const analysis::Discretisation& scene, Way& way) {
  const base::Stopwatch watch;
  base::SymmetricCsc K = analysis::regularised_global_stiffness(model, scene);
  const auto n = static_cast<Eigen::Index>(K.n);
  double first = 0.0;
  if (way.own) {
    const solve::Condensation plain(
        std::move(K), 0,
        {.ordering = way.metis ? solve::OrderingMethod::metis : solve::OrderingMethod::amd});
    first = plain.recover(base::Matrix(0, 1), base::Matrix::Ones(n, 1))(0, 0);
  } else {
    first = by_cholmod(std::move(K), way.metis);
  }
  way.cpu += watch.cpu_time();
  return first;
}

} // namespace

int main(int argc, char** argv) {
  base::SourceTexts sources;
  base::Diagnostics diagnostics;
  std::optional<model::Model> model;
  if (argc == 4) {
    model = deck::read_deck(argv[1], {.defines = {{"fine", argv[2]}}}, sources, diagnostics);
  }
  if (!model) {
    fmt::print(stderr, "usage: bench_plain_lug DECK FINE COUNT\n{}",
               base::format_messages(sources, diagnostics));
    return 2;
  }
  const std::vector<double> lengths = growth::growth_loop_crack_lengths(*model);
  const auto scene = analysis::discretise(*model, lengths[lengths.size() / 2], {}, diagnostics);
  if (!scene) {
    fmt::print(stderr, "{}", base::format_messages(sources, diagnostics));
    return 3;
  }
  const std::int64_t equations = analysis::regularised_global_stiffness(*model, *scene).n;
  std::array<Way, 4> ways{{{false, true}, {false, false}, {true, true}, {true, false}}};
  double sum = 0.0;
  for (int i = 0; i < std::atoi(argv[3]); ++i) {
    for (Way& way : ways) {
      sum += once(*model, *scene, way);
    }
  }
  fmt::print(
      "{} equations, {} times: CHOLMOD as it comes, METIS {:.3f} s, AMD {:.3f} s; ordered by "
      "nodes, METIS {:.3f} s, AMD {:.3f} s (sum {:.3g})\n",
      equations, argv[3], ways[0].cpu, ways[1].cpu, ways[2].cpu, ways[3].cpu, sum);
  return 0;
}
