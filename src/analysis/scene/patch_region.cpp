// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/scene/patch_region.hpp"

#include "mesh/node_elements.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <vector>

namespace spricka::analysis {

namespace {

// How far round the patches the region reaches, as a part of a crack's size. Wider regions last for
// more fronts, each of which takes longer.
constexpr double foreseen_advance = 0.5;

std::vector<bool> replaced_elements(const model::Mesh& host, const mesh::CrackedMesh& cracked) {
  std::vector<bool> replaced(host.element_count(), true);
  for (const base::ElementId e : cracked.host) {
    if (e.valid()) {
      replaced[e.index()] = false;
    }
  }
  return replaced;
}

// Half the diagonal of the box round the faces of the largest crack.
double largest_crack_size(const mesh::CrackedMesh& cracked) {
  double size = 0.0;
  for (const mesh::CrackFaceNodes& faces : cracked.faces) {
    Eigen::AlignedBox3d box;
    for (const base::NodeId n : faces.meshed_face_nodes()) {
      box.extend(cracked.mesh.x[n.index()]);
    }
    size = std::max(size, box.isEmpty() ? 0.0 : 0.5 * box.diagonal().norm());
  }
  return size;
}

/// Takes in the elements round a region, neighbour by neighbour, while they have a node within
/// `reach` of the node of the region that they were found from.
class RegionGrowth {
public:
  RegionGrowth(const model::Mesh& host, double reach, std::vector<bool>& region)
      : host_(host), reach_(reach), region_(region), elements_(host), source_(host.node_count()) {
    for (std::size_t e = 0; e < host.element_count(); ++e) {
      for (const base::NodeId n : host.element_nodes(base::ElementId(e))) {
        if (region[e] && !source_[n.index()].valid()) {
          source_[n.index()] = n;
          front_.push_back(n);
        }
      }
    }
  }

  void grow() {
    for (std::size_t k = 0; k < front_.size(); ++k) {
      const base::NodeId n = front_[k];
      for (const base::ElementId e : elements_.elements_around(n)) {
        if (!region_[e.index()]) {
          take_in(e, source_[n.index()]);
        }
      }
    }
  }

private:
  void take_in(base::ElementId e, base::NodeId source) {
    const auto distance = [&](base::NodeId n) {
      return (host_.x[n.index()] - host_.x[source.index()]).norm();
    };
    const auto nodes = host_.element_nodes(e);
    if (std::ranges::none_of(nodes, [&](base::NodeId n) { return distance(n) <= reach_; })) {
      return;
    }
    region_[e.index()] = true;
    for (const base::NodeId n : nodes) {
      if (!source_[n.index()].valid()) {
        source_[n.index()] = source;
        front_.push_back(n);
      }
    }
  }

  const model::Mesh& host_;
  double reach_;
  std::vector<bool>& region_;
  mesh::NodeToElementsMap elements_;
  std::vector<base::NodeId> source_; ///< [node] of the first region, whence it was reached
  std::vector<base::NodeId> front_;
};

} // namespace

bool follow_patches(const model::Mesh& host, const mesh::CrackedMesh& cracked,
                    CrackRegionPlan& plan) {
  if (!plan.follows_patches) {
    return false;
  }
  std::vector<bool> replaced = replaced_elements(host, cracked);
  if (plan.covers(replaced)) {
    return false;
  }
  plan.region = std::move(replaced);
  RegionGrowth(host, foreseen_advance * largest_crack_size(cracked), plan.region).grow();
  return true;
}

} // namespace spricka::analysis
