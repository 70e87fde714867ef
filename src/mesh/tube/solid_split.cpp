// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/solid_split.hpp"

#include "mesh/cut/crack_node_fan.hpp"

#include <algorithm>
#include <map>

namespace spricka::mesh {
namespace {

using Tetrahedron = std::array<int, 4>;

/// Corners of the sides of a TET4, and the corner opposite.
constexpr std::array<std::array<std::size_t, 3>, 4> side_corners{
    {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
constexpr std::array<std::size_t, 4> opposite{3, 2, 0, 1};

PatchTriangle in_order(PatchTriangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

PatchTriangle corners_of(const Tetrahedron& t, std::size_t side) {
  const auto& c = side_corners[side];
  return {t[c[0]], t[c[1]], t[c[2]]};
}

class Splitter {
public:
  Splitter(const PatchMeshBuilder& net, const std::vector<PatchTriangle>& crack,
           const std::unordered_map<int, int>& lower, std::vector<Tetrahedron>& tetrahedra)
      : net_(net), crack_(crack), lower_(lower), tetrahedra_(tetrahedra) {}

  OpenedFill split() {
    find_sides();
    find_faces();
    // All nodes are told before any is replaced: sides are known by the nodes they have.
    std::vector<std::pair<std::size_t, int>> below;
    for (const auto& [node, around] : around_) {
      tell(node, around, below);
    }
    for (const auto& [t, node] : below) {
      std::replace(tetrahedra_[t].begin(), tetrahedra_[t].end(), node, lower_.at(node));
    }
    return std::move(result_);
  }

private:
  struct Sheet {
    std::vector<FillTetrahedronSide> sides;
    bool crack = false;
  };

  void find_sides() {
    for (std::size_t t = 0; t < tetrahedra_.size(); ++t) {
      for (const int n : tetrahedra_[t]) {
        if (lower_.contains(n)) {
          around_[n].push_back(t);
        }
      }
      for (std::size_t s = 0; s < 4; ++s) {
        const PatchTriangle corners = corners_of(tetrahedra_[t], s);
        if (std::ranges::any_of(corners, [&](int n) { return lower_.contains(n); })) {
          sheets_[in_order(corners)].sides.push_back({t, static_cast<int>(s)});
        }
      }
    }
  }

  void find_faces() {
    for (const PatchTriangle& triangle : crack_) {
      Sheet& sheet = sheets_[in_order(triangle)];
      sheet.crack = true;
      FillTetrahedronSide upper;
      FillTetrahedronSide lower;
      bool both = sheet.sides.size() == 2;
      for (const FillTetrahedronSide& side : sheet.sides) {
        const Tetrahedron& t = tetrahedra_[side.tetrahedron];
        const int apex = t[opposite[static_cast<std::size_t>(side.side)]];
        (net_.six_times_volume(triangle[0], triangle[1], triangle[2], apex) > 0.0 ? upper : lower) =
            side;
      }
      both = both && upper.tetrahedron != lower.tetrahedron;
      result_.upper.push_back(upper);
      result_.lower.push_back(lower);
      if (!both) {
        result_.trouble = "a crack's face has elements on one side only";
        continue;
      }
      for (const int n : triangle) {
        level_[{n, upper.tetrahedron}] = CrackSide::left;
        level_[{n, lower.tetrahedron}] = CrackSide::right;
      }
    }
  }

  /// Which of the tetrahedra round a node are below the crack.
  void tell(int node, const std::vector<std::size_t>& around,
            std::vector<std::pair<std::size_t, int>>& below) {
    CrackNodeFan fan(around.size());
    const auto number = [&](std::size_t t) {
      return static_cast<std::size_t>(std::ranges::lower_bound(around, t) - around.begin());
    };
    for (std::size_t i = 0; i < around.size(); ++i) {
      if (const auto at = level_.find({node, around[i]}); at != level_.end()) {
        fan.mark(i, at->second);
      }
      for (std::size_t s = 0; s < 4; ++s) {
        const PatchTriangle corners = corners_of(tetrahedra_[around[i]], s);
        if (std::ranges::find(corners, node) == corners.end()) {
          continue;
        }
        const Sheet& sheet = sheets_.at(in_order(corners));
        for (const FillTetrahedronSide& side :
             sheet.crack ? std::vector<FillTetrahedronSide>() : sheet.sides) {
          fan.join(i, number(side.tetrahedron));
        }
      }
    }
    const std::vector<CrackSide> sides = fan.sides();
    const auto any = [&](CrackSide side) { return std::ranges::count(sides, side) > 0; };
    if (any(CrackSide::both)) {
      result_.trouble = "the two sides of a crack hang together";
    }
    if (any(CrackSide::unknown)) {
      result_.trouble = "an element at a crack lies on neither side of it";
    }
    for (std::size_t i = 0; i < around.size(); ++i) {
      if (sides[i] == CrackSide::right) {
        below.emplace_back(around[i], node);
      }
    }
  }

  const PatchMeshBuilder& net_;
  const std::vector<PatchTriangle>& crack_;
  const std::unordered_map<int, int>& lower_;
  std::vector<Tetrahedron>& tetrahedra_;
  std::map<int, std::vector<std::size_t>> around_; ///< [crack node] tetrahedra
  std::map<PatchTriangle, Sheet> sheets_;          ///< sides that have a crack node
  /// Of a node's tetrahedra those with sides on the crack; left is above.
  std::map<std::pair<int, std::size_t>, CrackSide> level_;
  OpenedFill result_;
};

} // namespace

OpenedFill open_crack_in_fill(const PatchMeshBuilder& net, const std::vector<PatchTriangle>& crack,
                              const std::unordered_map<int, int>& lower,
                              std::vector<Tetrahedron>& tetrahedra) {
  return Splitter(net, crack, lower, tetrahedra).split();
}

} // namespace spricka::mesh
