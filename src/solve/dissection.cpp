// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/dissection.hpp"
#include "base/index.hpp"

#include <algorithm>
#include <array>
#include <mutex>
#include <new>
#include <numeric>

namespace spricka::solve {

using base::at;

namespace {

using Indices = std::vector<std::int64_t>;

// Separators found with weights, one below the other: further down METIS goes on by itself.
constexpr int weighted_levels = 4;
constexpr std::int64_t fewest = 200; // vertices that are worth a separator of their own

class Dissection {
public:
  Dissection(const VertexGraph& graph, const std::vector<bool>& beside, CholmodSession& session)
      : graph_(graph), session_(session), weight_(beside.size(), 1), place_(beside.size(), -1) {
    const auto count = static_cast<std::int64_t>(std::ranges::count(beside, true));
    for (std::size_t i = 0; i < beside.size() && count > 0; ++i) {
      // Together as heavy as the whole graph: a separator that halves the weight cuts through the
      // vertices beside externals.
      weight_[i] += beside[i] ? std::max<std::int64_t>(1, graph.size() / count) : 0;
    }
    levels_ = count > 0 ? weighted_levels : 0;
  }

  Indices run() {
    Indices all(at(graph_.size()));
    std::iota(all.begin(), all.end(), std::int64_t{0});
    take(all, levels_);
    return std::move(order_);
  }

private:
  void take(const Indices& vertices, int levels) {
    const VertexGraph part = subgraph(vertices);
    std::array<Indices, 3> sides; // two halves and what separates them
    if (levels > 0 && part.size() >= fewest) {
      const Indices side = bisect(part, vertices);
      for (std::size_t i = 0; i < side.size(); ++i) {
        sides[at(side[i])].push_back(vertices[i]);
      }
    }
    if (sides[0].empty() || sides[1].empty()) {
      for (const std::int64_t i : by_metis(part)) {
        order_.push_back(vertices[at(i)]);
      }
      return;
    }
    take(sides[0], levels - 1);
    take(sides[1], levels - 1);
    // The separator last: its halves do not fill in between each other.
    order_.insert(order_.end(), sides[2].begin(), sides[2].end());
  }

  // vertices ascend
  VertexGraph subgraph(const Indices& vertices) {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      place_[at(vertices[i])] = static_cast<std::int64_t>(i);
    }
    VertexGraph part{{0}, {}};
    for (const std::int64_t v : vertices) {
      for (std::int64_t p = graph_.start[at(v)]; p < graph_.start[at(v) + 1]; ++p) {
        if (const std::int64_t other = place_[at(graph_.neighbour[at(p)])]; other >= 0) {
          part.neighbour.push_back(other);
        }
      }
      part.start.push_back(static_cast<std::int64_t>(part.neighbour.size()));
    }
    for (const std::int64_t v : vertices) {
      // Cleared for the next part, whose size alone it should cost.
      place_[at(v)] = -1;
    }
    return part;
  }

  static cholmod_sparse view(const VertexGraph& graph) {
    cholmod_sparse A =
        cholmod_lower_view(graph.size(), graph.start.data(), graph.neighbour.data(), nullptr);
    A.stype = 0;
    return A;
  }

  Indices bisect(const VertexGraph& part, const Indices& vertices) {
    Indices weight;
    for (const std::int64_t v : vertices) {
      weight.push_back(weight_[at(v)]);
    }
    Indices edges(part.neighbour.size(), 1);
    Indices side(vertices.size(), 0);
    cholmod_sparse A = view(part);
    const std::lock_guard<std::mutex> guard(metis());
    if (cholmod_l_metis_bisector(&A, weight.data(), edges.data(), side.data(), session_.get()) <
        0) {
      throw std::bad_alloc();
    }
    return side;
  }

  Indices by_metis(const VertexGraph& part) {
    // CHOLMOD wants one triangle, with the diagonal
    Indices start{0};
    Indices row;
    for (std::int64_t j = 0; j < part.size(); ++j) {
      row.push_back(j);
      for (std::int64_t p = part.start[at(j)]; p < part.start[at(j) + 1]; ++p) {
        if (part.neighbour[at(p)] > j) {
          row.push_back(part.neighbour[at(p)]);
        }
      }
      start.push_back(static_cast<std::int64_t>(row.size()));
    }
    Indices order(at(part.size()), 0);
    cholmod_sparse A = cholmod_lower_view(part.size(), start.data(), row.data(), nullptr);
    const std::lock_guard<std::mutex> guard(metis());
    if (cholmod_l_metis(&A, nullptr, 0, 0, order.data(), session_.get()) == 0) {
      throw std::bad_alloc();
    }
    return order;
  }

  // METIS draws from the random numbers of the C library, seeded anew at each call: one at a time,
  // or the order would depend on what the other threads do.
  static std::mutex& metis() {
    static std::mutex one_at_a_time;
    return one_at_a_time;
  }

  const VertexGraph& graph_;
  CholmodSession& session_;
  Indices weight_;
  Indices place_;
  Indices order_;
  int levels_ = 0;
};

} // namespace

std::vector<std::int64_t> nested_dissection_order(const VertexGraph& graph,
                                                  const std::vector<bool>& beside,
                                                  CholmodSession& session) {
  return Dissection(graph, beside, session).run();
}

} // namespace spricka::solve
