// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/front_extension.hpp"

#include "crack/curvature_limit.hpp"
#include "crack/front_hats.hpp"
#include "crack/front_rule.hpp"
#include "crack/surface_motion.hpp"
#include "model/mesh_side.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace spricka::crack {

namespace {

using base::ElementId;
using base::NodeId;
using base::Vec3;

// Where a node goes that moves with the front.
struct Follower {
  FrontHatWeights hat;
  Vec3 along = Vec3::UnitX();
  bool stays = false; ///< no motion is possible
  const char* why = "";
};

class FrontExtensionsBuilder {
public:
  FrontExtensionsBuilder(const mesh::CrackedMesh& cracked, const mesh::CrackFront& front, int most,
                         const IntegrationDomainConstraints& limits)
      : cracked_(cracked), mesh_(cracked.mesh), front_(front), limits_(limits),
        elements_(cracked.mesh), line_(front_mid_nodes(mesh_, elements_, front)),
        layers_(find_layers_round_front(mesh_, elements_, front, line_, most + 1)),
        curve_(*front.curve), hats_(front, line_.closed), curvature_(mesh_, front, line_.closed),
        sides_(free_sides(mesh_, reached())), surface_(mesh_, sides_, off_own_front()) {
    out_.points.resize(front_.points.size());
    out_.closed = line_.closed;
    out_.middle = line_.middle;
    out_.station = hats_.stations();
    mark_others();
  }

  void add_domain(int rings) {
    const std::map<NodeId, std::vector<std::pair<std::size_t, double>>> q = amounts(rings);
    std::vector<VirtualExtensionField> fields(front_.points.size());
    std::vector<std::string> why(front_.points.size());
    for (const auto& [node, parts] : q) {
      const Follower& follower = follow(node);
      for (const auto& [point, amount] : parts) {
        if (amount == 0.0) {
          continue;
        }
        fields[point].motion.push_back({.node = node, .q = amount, .along = follower.along});
        if (follower.stays && why[point].empty()) {
          why[point] = follower.why;
        }
      }
    }
    for (std::size_t i = 0; i < fields.size(); ++i) {
      finish(fields[i], rings);
      if (why[i].empty() && leaves_material(i, fields[i])) {
        why[i] = "it meets elements of another material or state";
      }
      if (why[i].empty() && curvature_.is_exceeded(i, fields[i])) {
        why[i] = "it reaches as far as the front's centre of curvature";
      }
      if (why[i].empty() && !fields[i].motion.empty()) {
        out_.points[i].push_back(std::move(fields[i]));
      } else {
        out_.left_out.push_back({i, rings, why[i]});
      }
    }
  }

  FrontIntegralDomains take() {
    std::set<NodeId> moved;
    for (const std::vector<VirtualExtensionField>& domains : out_.points) {
      for (const VirtualExtensionField& field : domains) {
        for (const NodeMotion& motion : field.motion) {
          moved.insert(motion.node);
        }
      }
    }
    const mesh::CrackFaceNodes& own = cracked_.faces[front_.crack.index()];
    const std::set<model::Face> upper(own.left_sides.begin(), own.left_sides.end());
    const std::set<model::Face> lower(own.right_sides.begin(), own.right_sides.end());
    for (const model::Face& face : sides_) {
      if (std::ranges::any_of(model::side_nodes(mesh_, face),
                              [&](NodeId n) { return moved.contains(n); })) {
        out_.sides.push_back({face, upper.contains(face)   ? UpperOrLowerFace::upper
                                    : lower.contains(face) ? UpperOrLowerFace::lower
                                                           : UpperOrLowerFace::none});
      }
    }
    return std::move(out_);
  }

private:
  // The crack's own faces begin at its front: they are not in the way of that, however it bends
  // between the corners of elements.
  [[nodiscard]] SurfaceNodeMotion::ObstructionTest off_own_front() const {
    const mesh::CrackFaceNodes& own = cracked_.faces[front_.crack.index()];
    std::set<model::Face> faces(own.left_sides.begin(), own.left_sides.end());
    faces.insert(own.right_sides.begin(), own.right_sides.end());
    return [this, faces = std::move(faces)](NodeId n, const model::Face& face) {
      return layers_.of_node[n.index()] != 0 || !faces.contains(face);
    };
  }

  [[nodiscard]] std::vector<ElementId> reached() const {
    std::vector<ElementId> all;
    for (const std::vector<ElementId>& layer : layers_.elements) {
      all.insert(all.end(), layer.begin(), layer.end());
    }
    std::ranges::sort(all);
    return all;
  }

  void mark_others() {
    fixed_.assign(mesh_.node_count(), false);
    for (std::size_t n = 0; n < limits_.node.size(); ++n) {
      fixed_[n] = limits_.node[n];
    }
    for (const mesh::HangingNodeTie& tie : cracked_.ties) { // it goes with its masters
      fixed_[tie.slave.index()] = false;
    }
    for (const mesh::CrackFront& other : cracked_.fronts) {
      for (const mesh::FrontPoint& point : other.points) {
        const bool own = other.crack == front_.crack && other.number == front_.number;
        fixed_[point.node.index()] = fixed_[point.node.index()] || !own;
      }
    }
    for (std::size_t c = 0; c < cracked_.faces.size(); ++c) {
      for (const auto* nodes : {&cracked_.faces[c].left, &cracked_.faces[c].right}) {
        for (const NodeId n : *nodes) {
          fixed_[n.index()] = fixed_[n.index()] || c != front_.crack.index();
        }
      }
    }
  }

  const Follower& follow(NodeId n) {
    const auto [at, fresh] = followers_.try_emplace(n);
    Follower& f = at->second;
    if (!fresh) {
      return f;
    }
    const Vec3& x = mesh_.x[n.index()];
    const mesh::FrontFrame frame = curve_.at(curve_.nearest_length(x));
    f.hat = hats_.hat_weights_at(frame.s);
    f.along = frame.m;
    if (fixed_[n.index()]) {
      f.stays = true;
      f.why = "it reaches a node that is held or belongs to something else";
    } else if (const auto v = surface_.admissible_motion(n, frame.m, frame.t)) {
      f.along = *v;
    } else {
      f.stays = true;
      f.why = "it reaches the surface of the body";
    }
    return f;
  }

  using Amounts = std::map<NodeId, std::vector<std::pair<std::size_t, double>>>;

  static void add(std::vector<std::pair<std::size_t, double>>& to, std::size_t point,
                  double amount) {
    const auto at = std::ranges::find(to, point, &std::pair<std::size_t, double>::first);
    if (at != to.end()) {
      at->second += amount;
    } else if (amount != 0.0) {
      to.emplace_back(point, amount);
    }
  }

  // Of all nodes that move, for each point.
  Amounts amounts(int rings) {
    Amounts q;
    const auto corner = [&](NodeId n) -> const std::vector<std::pair<std::size_t, double>>& {
      const auto [at, fresh] = q.try_emplace(n);
      if (fresh && layers_.extension_factor(n, rings) > 0.0) {
        const FrontHatWeights hat = follow(n).hat;
        add(at->second, hat.low, 1.0 - hat.part);
        add(at->second, hat.high, hat.part);
      }
      return at->second;
    };
    for (std::size_t layer = 0; layer < static_cast<std::size_t>(rings) + 1; ++layer) {
      for (const ElementId e : layers_.elements[layer]) {
        const base::ElementType type = mesh_.type[e.index()];
        const base::ElementInfo& info = base::element_info(type);
        const std::span<const NodeId> nodes = mesh_.element_nodes(e);
        for (int i = 0; i < info.corners; ++i) {
          corner(nodes[static_cast<std::size_t>(i)]);
        }
        for (int m = 0; info.quadratic && m < shape::edge_count(type); ++m) {
          const NodeId middle = nodes[static_cast<std::size_t>(info.corners + m)];
          const auto [at, fresh] = q.try_emplace(middle);
          if (fresh) { // the mean of the ends
            for (const int end : shape::edge_corners(type, m)) {
              for (const auto& [point, amount] : corner(nodes[static_cast<std::size_t>(end)])) {
                add(at->second, point, 0.5 * amount);
              }
            }
          }
        }
        add_centres(type, nodes, q);
      }
    }
    std::erase_if(q, [](const auto& entry) { return entry.second.empty(); });
    return q;
  }

  // Middles of sides and of the element, the mean of the corners.
  void add_centres(base::ElementType type, std::span<const NodeId> nodes, Amounts& q) {
    if (type != base::ElementType::hexec27) {
      return;
    }
    const auto mean = [&](std::size_t i, std::span<const int> corners) {
      const auto [at, fresh] = q.try_emplace(nodes[i]);
      for (const int c : corners) {
        if (fresh) {
          for (const auto& [point, amount] : q[nodes[static_cast<std::size_t>(c)]]) {
            add(at->second, point, amount / static_cast<double>(corners.size()));
          }
        }
      }
    };
    for (int s = 0; s < 6; ++s) {
      mean(20 + static_cast<std::size_t>(s), shape::side_nodes(type, s).first(4));
    }
    constexpr std::array<int, 8> all{0, 1, 2, 3, 4, 5, 6, 7};
    mean(26, all);
  }

  // Nodes that rows tie to others move as the rows have it, so that the row still holds of the
  // moved mesh; then the elements.
  void finish(VirtualExtensionField& field, int rings) const {
    field.rings = rings;
    std::map<NodeId, std::pair<double, Vec3>> at;
    for (const NodeMotion& motion : field.motion) {
      at.emplace(motion.node, std::pair(motion.q, motion.along));
    }
    for (const mesh::HangingNodeTie& tie : cracked_.ties) {
      const bool near = at.contains(tie.slave) ||
                        std::ranges::any_of(tie.master, [&](NodeId n) { return at.contains(n); });
      if (!near) {
        continue;
      }
      double q = 0.0;
      Vec3 v = Vec3::Zero();
      for (std::size_t k = 0; k < tie.master.size(); ++k) {
        const auto found = at.find(tie.master[k]);
        if (found != at.end()) {
          q += tie.weight[k] * found->second.first;
          v += tie.weight[k] * found->second.first * found->second.second;
        }
      }
      at.erase(tie.slave);
      if (std::abs(q) > 1e-12) {
        at.emplace(tie.slave, std::pair(q, Vec3(v / q)));
      }
    }
    field.motion.clear();
    std::set<ElementId> touched;
    for (const auto& [node, moved] : at) {
      field.motion.push_back({.node = node, .q = moved.first, .along = moved.second});
      const std::span<const ElementId> around = elements_.elements_around(node);
      touched.insert(around.begin(), around.end());
    }
    field.elements.assign(touched.begin(), touched.end());
  }

  [[nodiscard]] std::int64_t zone(ElementId e) const {
    return limits_.zone.empty() ? mesh_.property[e.index()].value : limits_.zone[e.index()];
  }

  [[nodiscard]] bool leaves_material(std::size_t point, const VirtualExtensionField& field) const {
    const std::int64_t own = zone(elements_.elements_around(front_.points[point].node).front());
    return std::ranges::any_of(field.elements, [&](ElementId e) { return zone(e) != own; });
  }

  const mesh::CrackedMesh& cracked_;
  const model::Mesh& mesh_;
  const mesh::CrackFront& front_;
  const IntegrationDomainConstraints& limits_;
  mesh::NodeToElementsMap elements_;
  FrontMidNodes line_;
  ElementLayersRoundFront layers_;
  const mesh::FrontCurve& curve_;
  FrontHats hats_;
  DomainCurvatureLimit curvature_;
  std::vector<model::Face> sides_;
  SurfaceNodeMotion surface_;
  std::vector<bool> fixed_; ///< [node]
  std::map<NodeId, Follower> followers_;
  FrontIntegralDomains out_;
};

std::set<ElementId> strained_by(const std::vector<std::vector<VirtualExtensionField>>& points) {
  std::set<ElementId> all;
  for (const std::vector<VirtualExtensionField>& domains : points) {
    for (const VirtualExtensionField& field : domains) {
      all.insert(field.elements.begin(), field.elements.end());
    }
  }
  return all;
}

} // namespace

bool FrontIntegralDomains::empty() const {
  return std::ranges::all_of(points, [](const auto& domains) { return domains.empty(); });
}

std::vector<ElementId> FrontIntegralDomains::elements() const {
  std::vector<ElementId> all;
  all.reserve(degree.size());
  for (const auto& [element, rule] : degree) {
    all.push_back(element);
  }
  return all;
}

FrontIntegralDomains build_front_domains(const mesh::CrackedMesh& cracked,
                                         const mesh::CrackFront& front,
                                         const std::vector<int>& rings,
                                         const IntegrationDomainConstraints& limits) {
  if (rings.empty() || front.curve == nullptr) {
    return {};
  }
  FrontExtensionsBuilder builder(cracked, front, *std::ranges::max_element(rings), limits);
  for (const int count : rings) {
    builder.add_domain(count);
  }
  FrontIntegralDomains fields = builder.take();
  for (const ElementId e : strained_by(fields.points)) {
    fields.degree.emplace(e, front_quadrature_degree(cracked.mesh, e, *front.curve));
  }
  fields.auxiliary_cache = std::make_shared<AuxiliaryFieldCache>();
  return fields;
}

} // namespace spricka::crack
