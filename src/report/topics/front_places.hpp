// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/mesh.hpp"
#include "results/results.hpp"

#include <cstddef>
#include <string>
#include <vector>

/// The places by which a front in space is reported: its ends, its middle, where K is largest.
namespace spricka::report {

/// Sets of faces, else of nodes, by name.
class FaceNames {
public:
  /// The mesh must outlive it.
  explicit FaceNames(const model::Mesh& mesh) : mesh_(mesh) {}
  /// The smallest set, but for faces of cracks, that a node at this place belongs to, without the
  /// name of its net where the mesh has one net only; where there is none the end of the mesh along
  /// an axis that the place lies at, "z = 5"; empty: neither.
  [[nodiscard]] std::string at(const base::Vec3& x) const;

private:
  const model::Mesh& mesh_;
};

/// One of these places.
struct FrontPlace {
  std::string name; ///< "at BORE", "middle", "largest"; of several that are one "middle, largest"
  const results::FrontPointResult* point = nullptr;
};

/// The ends of a front that is open, its middle, and the point within the body with the largest K1;
/// of a closed front those with the largest and the smallest one. In the order of the points. Of
/// a tip the tip alone.
std::vector<FrontPlace> front_places(const results::FrontResult& front, const FaceNames& faces);

/// The point within the body with the largest K1, where all are at the surface of all. The front
/// has points.
const results::FrontPointResult& worst_point(const results::FrontResult& front);

/// Which of the points that grow are reported in figures and tables: of a crack with more than four
/// the first, the middle and the last one.
std::vector<std::size_t> reported_growth_points(const results::GrowthResult& growth);

} // namespace spricka::report
