// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/patch_sizes.hpp"

#include "mesh/cut/patch_gaps.hpp"

#include <algorithm>
#include <array>

namespace spricka::mesh {
namespace {

using base::Vec2;

/// Size wanted at the mouth, in crack lengths; the host's own size if that is smaller. Where the
/// mouth is pressed K2 of short cracks hangs on the peaks of pressure beside it.
constexpr double mouth_size = 0.25;
constexpr double pressed_mouth_size = 0.05;

double finest(const std::vector<PatchCrack>& cracks) {
  double finer = 0.0;
  for (const PatchCrack& crack : cracks) {
    finer = std::max(finer, crack.tip->finer);
  }
  return finer;
}

/// Puts the sizes of one patch together.
class CurveSizes {
public:
  CurveSizes(const HostMesh& host, const std::vector<PatchCrack>& cracks, const Cavity& cavity,
             double fineness)
      : mesh_(host.mesh()), cracks_(cracks), cavity_(cavity), fineness_(fineness),
        frame_(cracks.front().place.frame), half_(cracks.front().place.half),
        size_(patch_grading_without_sources(cracks)) {}

  Grading take(const PatchMeshBuilder& net) {
    for (const PatchCrack& crack : cracks_) {
      add_rosettes(crack, net);
      add_mouth(crack);
    }
    const bool transition =
        std::ranges::any_of(cracks_, [](const PatchCrack& crack) { return crack.tip->transition; });
    for (const auto& loop : cavity_.loops) {
      for (const CavityOutlineEdge& edge : loop) {
        add_edge(edge, transition);
      }
    }
    add_gaps();
    return std::move(size_);
  }

private:
  [[nodiscard]] Vec2 local(const EdgeEndAndMidNodes& edge, double xi) const {
    return point_on_edge(mesh_, frame_, edge, xi);
  }

  void add_rosettes(const PatchCrack& crack, const PatchMeshBuilder& net) {
    for (const Rosette& rosette : crack.rosettes) {
      const std::size_t rim = rosette.rim.size();
      // The rim of a half is open: no edge leads from its last node to the first.
      for (std::size_t j = 0; j + (half_ != 0 ? 1 : 0) < rim; ++j) {
        add_edge_size(size_, net, rosette.rim[j], rosette.rim[(j + 1) % rim]);
      }
    }
  }

  void add_mouth(const PatchCrack& crack) {
    if (crack.place.mouth) {
      const double finer = finest(cracks_);
      const double part =
          crack.tip->pressed ? pressed_mouth_size / std::max(finer, 1.0) : mouth_size / finer;
      size_.add_size_source(crack.place.line.front(),
                            part * crack_length_in_frame(crack.place) / fineness_);
    }
  }

  void add_edge(const CavityOutlineEdge& edge, bool transition) {
    const double length = (local(edge.edge, 1.0) - local(edge.edge, -1.0)).norm();
    if (edge.free || !transition) { // an edge that is tied asks for nothing
      size_.add_size_source(local(edge.edge, 0.0), edge.free ? length / fineness_ : length);
    }
    std::vector<double> ends{-1.0};
    // A mouth cuts the edge: both parts ask for their own length, the shorter one for less than the
    // edge.
    for (const auto& [xi, crack] : mouths_on_edge(edge, cracks_)) {
      ends.push_back(xi);
    }
    ends.push_back(1.0);
    for (std::size_t i = 1; i < ends.size() && ends.size() > 2; ++i) {
      const double part = 0.5 * (ends[i] - ends[i - 1]); // may be short indeed
      size_.add_size_source(local(edge.edge, 0.5 * (ends[i - 1] + ends[i])), part * length);
    }
  }

  /// Between cracks and what runs beside them elements are no longer than the gap is wide.
  void add_gaps() {
    std::vector<const CrackPlacement*> places;
    for (const PatchCrack& crack : cracks_) {
      places.push_back(&crack.place);
    }
    std::vector<std::array<Vec2, 3>> boundary;
    for (const auto& loop : cavity_.loops) {
      for (const CavityOutlineEdge& edge : loop) {
        if (edge.free && half_ == 0) {
          boundary.push_back(
              {local(edge.edge, -1.0), local(edge.edge, 0.0), local(edge.edge, 1.0)});
        }
      }
    }
    add_gap_sizes(places, boundary, size_);
  }

  const model::Mesh& mesh_;
  const std::vector<PatchCrack>& cracks_;
  const Cavity& cavity_;
  double fineness_;
  CrackFrame frame_;
  int half_;
  Grading size_;
};

} // namespace

Grading patch_grading_without_sources(const std::vector<PatchCrack>& cracks) {
  return Grading(Grading::usual_growth / finest(cracks));
}

Grading patch_curve_sizes(const HostMesh& host, const std::vector<PatchCrack>& cracks,
                          const Cavity& cavity, const PatchMeshBuilder& net, double fineness) {
  return CurveSizes(host, cracks, cavity, fineness).take(net);
}

void add_edge_size(Grading& grading, const PatchMeshBuilder& net, int a, int b) {
  const Vec2 p = net.local_position(a).head<2>();
  const Vec2 q = net.local_position(b).head<2>();
  grading.add_size_source(0.5 * (p + q), (q - p).norm());
}

} // namespace spricka::mesh
