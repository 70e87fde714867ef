// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/ordering.hpp"
#include "base/index.hpp"
#include "solve/cholmod_session.hpp"
#include "solve/dissection.hpp"

#include <algorithm>
#include <memory>
#include <new>
#include <numeric>

namespace spricka::solve {

using base::at;

namespace {

using Indices = std::vector<std::int64_t>;

struct LocalPattern {
  std::int64_t n = 0;
  Indices start;
  Indices row;
};

void demand(bool done) {
  if (!done) {
    throw std::bad_alloc(); // the calls below can fail for memory only
  }
}

LocalPattern local_pattern(const base::SymmetricCsc& K, std::int64_t locals) {
  LocalPattern A{locals, Indices(at(locals) + 1, 0), {}};
  A.row.reserve(at(K.start[at(locals)]));
  for (std::int64_t j = 0; j < locals; ++j) {
    for (std::int64_t p = K.start[at(j)]; p < K.start[at(j) + 1] && K.row[at(p)] < locals; ++p) {
      A.row.push_back(K.row[at(p)]);
    }
    A.start[at(j) + 1] = static_cast<std::int64_t>(A.row.size());
  }
  return A;
}

/// A number that is as good as random for each index (splitmix64, Steele, Lea and Flood 2014).
std::uint64_t mark(std::int64_t i) {
  std::uint64_t z = static_cast<std::uint64_t>(i + 1) * 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31U);
}

/// Group [n] of each row: neighbouring rows whose rows of the full matrix have the same pattern.
/// The part of a row left of the diagonal is compared by a sum of marks; a chance agreement would
/// only make a poorer order.
Indices groups_of(const LocalPattern& A) {
  std::vector<std::uint64_t> left(at(A.n), 0);
  for (std::int64_t j = 0; j < A.n; ++j) {
    for (std::int64_t p = A.start[at(j)] + 1; p < A.start[at(j) + 1]; ++p) {
      left[at(A.row[at(p)])] += mark(j);
    }
  }
  Indices group(at(A.n), 0);
  for (std::int64_t j = 1; j < A.n; ++j) {
    const auto previous = A.row.begin() + A.start[at(j) - 1];
    const auto current = A.row.begin() + A.start[at(j)];
    const auto end = A.row.begin() + A.start[at(j) + 1];
    const bool same = left[at(j)] == left[at(j) - 1] + mark(j - 1) &&
                      std::equal(previous + 1, current, current, end);
    group[at(j)] = group[at(j) - 1] + (same ? 0 : 1);
  }
  return group;
}

LocalPattern compressed(const LocalPattern& A, const Indices& group) {
  LocalPattern C{A.n == 0 ? 0 : group.back() + 1, {0}, {}};
  for (std::int64_t j = 0; j < A.n; ++j) {
    if (j > 0 && group[at(j)] == group[at(j) - 1]) {
      continue;
    }
    for (std::int64_t p = A.start[at(j)]; p < A.start[at(j) + 1]; ++p) {
      const std::int64_t g = group[at(A.row[at(p)])];
      if (static_cast<std::int64_t>(C.row.size()) == C.start.back() || C.row.back() != g) {
        C.row.push_back(g);
      }
    }
    C.start.push_back(static_cast<std::int64_t>(C.row.size()));
  }
  return C;
}

VertexGraph whole_graph(const LocalPattern& C) {
  VertexGraph graph{Indices(at(C.n) + 1, 0), {}};
  for (std::int64_t j = 0; j < C.n; ++j) {
    for (std::int64_t p = C.start[at(j)]; p < C.start[at(j) + 1]; ++p) {
      if (const std::int64_t i = C.row[at(p)]; i != j) {
        ++graph.start[at(i) + 1];
        ++graph.start[at(j) + 1];
      }
    }
  }
  std::partial_sum(graph.start.begin(), graph.start.end(), graph.start.begin());
  graph.neighbour.resize(at(graph.start.back()));
  Indices next(graph.start.begin(), graph.start.end() - 1);
  for (const bool lower : {true, false}) { // smaller neighbours first
    for (std::int64_t j = 0; j < C.n; ++j) {
      for (std::int64_t p = C.start[at(j)]; p < C.start[at(j) + 1]; ++p) {
        if (const std::int64_t i = C.row[at(p)]; i != j) {
          const std::int64_t own = lower ? i : j;
          graph.neighbour[at(next[at(own)]++)] = lower ? j : i;
        }
      }
    }
  }
  return graph;
}

/// Which groups [n] have an external among their neighbours.
std::vector<bool> beside_externals(const base::SymmetricCsc& K, std::int64_t locals,
                                   const Indices& group) {
  std::vector<bool> beside(group.empty() ? 0 : at(group.back()) + 1, false);
  for (std::int64_t j = 0; j < locals; ++j) {
    if (K.row[at(K.start[at(j) + 1] - 1)] >= locals) { // rows ascend
      beside[at(group[at(j)])] = true;
    }
  }
  return beside;
}

Indices by_amd(const LocalPattern& C, CholmodSession& session) {
  Indices order(at(C.n));
  cholmod_sparse graph = cholmod_lower_view(C.n, C.start.data(), C.row.data(), nullptr);
  demand(cholmod_l_amd(&graph, nullptr, 0, order.data(), session.get()) != 0);
  return order;
}

Indices expanded(const Indices& order, const Indices& group) {
  Indices first(order.size() + 1, static_cast<std::int64_t>(group.size()));
  for (std::size_t j = group.size(); j-- > 0;) {
    first[at(group[j])] = static_cast<std::int64_t>(j);
  }
  Indices rows;
  rows.reserve(group.size());
  for (const std::int64_t g : order) {
    for (std::int64_t j = first[at(g)]; j < first[at(g) + 1]; ++j) {
      rows.push_back(j);
    }
  }
  return rows;
}

/// The same elimination with the columns of each subtree next to each other, the largest child
/// last, so that supernodes form.
Indices postordered(const LocalPattern& A, Indices order, CholmodSession& session) {
  cholmod_sparse lower = cholmod_lower_view(A.n, A.start.data(), A.row.data(), nullptr);
  const auto release = [&session](cholmod_sparse* m) { cholmod_l_free_sparse(&m, session.get()); };
  const std::unique_ptr<cholmod_sparse, decltype(release)> upper(
      cholmod_l_ptranspose(&lower, 0, order.data(), nullptr, 0, session.get()), release);
  demand(upper != nullptr);
  const std::unique_ptr<cholmod_sparse, decltype(release)> permuted(
      cholmod_l_ptranspose(upper.get(), 0, nullptr, nullptr, 0, session.get()), release);
  demand(permuted != nullptr);
  Indices parent(order.size());
  Indices post(order.size());
  demand(cholmod_l_etree(upper.get(), parent.data(), session.get()) != 0);
  demand(cholmod_l_postorder(parent.data(), order.size(), nullptr, post.data(), session.get()) ==
         A.n);
  Indices count(order.size());
  Indices first(order.size());
  Indices level(order.size());
  demand(cholmod_l_rowcolcounts(permuted.get(), nullptr, 0, parent.data(), post.data(), nullptr,
                                count.data(), first.data(), level.data(), session.get()) != 0);
  demand(cholmod_l_postorder(parent.data(), order.size(), count.data(), post.data(),
                             session.get()) == A.n);
  Indices result(order.size());
  std::transform(post.begin(), post.end(), result.begin(),
                 [&order](std::int64_t k) { return order[at(k)]; });
  return result;
}

} // namespace

std::vector<std::int64_t> elimination_order(const base::SymmetricCsc& K, std::int64_t locals,
                                            OrderingMethod ordering) {
  Indices order(at(K.n));
  std::iota(order.begin(), order.end(), std::int64_t{0});
  if (locals == 0) {
    return order;
  }
  CholmodSession session;
  const LocalPattern A = local_pattern(K, locals);
  const Indices group = groups_of(A);
  if (ordering == OrderingMethod::automatic) {
    // entries of a full row: about 23 in plane quadratic triangles, 80 and more in solids
    const double row_entries = 2.0 * static_cast<double>(A.row.size()) / static_cast<double>(A.n);
    ordering = row_entries < 45.0 ? OrderingMethod::amd : OrderingMethod::metis;
  }
  const LocalPattern C = compressed(A, group);
  const Indices vertices =
      ordering == OrderingMethod::amd
          ? by_amd(C, session)
          : nested_dissection_order(whole_graph(C), beside_externals(K, locals, group), session);
  // Rows of a group follow each other in any order: the groups are put in postorder.
  const Indices rows = expanded(postordered(C, vertices, session), group);
  std::copy(rows.begin(), rows.end(), order.begin());
  return order;
}

base::SymmetricCsc reorder(const base::SymmetricCsc& K, const std::vector<std::int64_t>& order,
                           std::int64_t full_column) {
  std::vector<std::int64_t> position(at(K.n));
  for (std::int64_t k = 0; k < K.n; ++k) {
    position[at(order[at(k)])] = k;
  }
  base::SymmetricCsc A;
  A.n = K.n;
  A.start.assign(at(K.n) + 1, 0);
  const auto for_entries = [&](const auto& use) {
    for (std::int64_t j = 0; j < K.n; ++j) {
      const std::int64_t own = position[at(j)];
      for (std::int64_t p = K.start[at(j)]; p < K.start[at(j) + 1]; ++p) {
        const std::int64_t other = position[at(K.row[at(p)])];
        use(std::min(own, other), std::max(own, other), p);
      }
    }
  };
  for_entries([&](std::int64_t column, std::int64_t, std::int64_t) { ++A.start[at(column) + 1]; });
  if (full_column < K.n) {
    A.start[at(full_column) + 1] = K.n - full_column;
  }
  std::partial_sum(A.start.begin(), A.start.end(), A.start.begin());
  const bool valued = !K.value.empty();
  A.row.resize(at(A.start.back()));
  A.value.resize(valued ? A.row.size() : 0);
  std::vector<std::int64_t> next(A.start.begin(), A.start.end() - 1);
  for (std::int64_t row = full_column; row < K.n; ++row) {
    A.row[at(next[at(full_column)] + row - full_column)] = row;
  }
  for_entries([&](std::int64_t column, std::int64_t row, std::int64_t p) {
    const std::int64_t to =
        column == full_column ? next[at(column)] + row - full_column : next[at(column)]++;
    A.row[at(to)] = row;
    if (valued) {
      A.value[at(to)] = K.value[at(p)];
    }
  });
  return A;
}

} // namespace spricka::solve
