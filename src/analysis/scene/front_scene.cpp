// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/scene/front_scene.hpp"

#include "analysis/scene/domain_rings.hpp"
#include "analysis/scene/front_surroundings.hpp"
#include "model/mesh_side.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace spricka::analysis {

namespace {

using base::Vec3;

std::string why_none(const crack::FrontIntegralDomains& fields) {
  std::set<std::string> reasons;
  for (const crack::OmittedDomain& out : fields.left_out) {
    reasons.insert(out.why);
  }
  return fmt::format("{}", fmt::join(reasons, "; "));
}

// The node sets that hold nodes near a point of a front, by their names.
std::string remedy_at(const model::Model& model, const Discretisation& scene,
                      const mesh::FrontPoint& point) {
  constexpr double near = 3.0; // radii of the tube
  std::set<std::string> names;
  for (const model::NodeSetFreedomRole& freedom : model.freedoms) {
    const model::NodeSet& set = scene.cracked.mesh.set_with_id(freedom.nodes);
    if (std::ranges::any_of(set.nodes, [&](base::NodeId n) {
          return (scene.cracked.mesh.x[n.index()] - point.x).norm() < near * point.radius;
        })) {
      names.insert(set.name.empty() ? "a set" : set.name);
    }
  }
  const std::string smaller = "give a smaller RADIUS or SIZE on $TIPNET or other DOMAINS on $VCE";
  return names.empty() ? smaller
                       : fmt::format("{} of $FREEDOM holds nodes there: is that body the one to be "
                                     "held? Else {}",
                                     fmt::join(names, ", "), smaller);
}

// Points inside the body that no domain belongs to.
std::vector<std::size_t> points_without(const mesh::CrackFront& front,
                                        const crack::FrontIntegralDomains& fields) {
  std::vector<std::size_t> without;
  for (std::size_t i = 0; i < front.points.size(); ++i) {
    if (fields.points.empty() || (fields.points[i].empty() && !front.points[i].at_surface)) {
      without.push_back(i);
    }
  }
  return without;
}

// Layers of tetrahedra reach unevenly far, and wide ones of a tube where the front turns sharply:
// where those of the usual domains have no room the first one is a domain, too. Where that has none
// a smooth curve through the others would be no K.
crack::FrontIntegralDomains fields_of(const model::Model& model, const Discretisation& scene,
                                      const mesh::CrackFront& front,
                                      base::Diagnostics& diagnostics) {
  std::vector<int> rings = domain_ring_counts(model, front.crack);
  const crack::IntegrationDomainConstraints limits = find_domain_exclusions(model, scene, front);
  crack::FrontIntegralDomains fields =
      crack::build_front_domains(scene.cracked, front, rings, limits);
  const bool given =
      std::ranges::any_of(model.vces, [&](const model::VirtualCrackExtensionSettings& vce) {
        return vce.crack == front.crack && !vce.domains.empty();
      });
  if (!points_without(front, fields).empty() && !given) {
    rings.insert(rings.begin(), 1);
    fields = crack::build_front_domains(scene.cracked, front, rings, limits);
  }
  const std::vector<std::size_t> without = points_without(front, fields);
  const model::CrackDefinition& crack = model.cracks[front.crack.index()];
  const std::string remedy =
      without.empty() ? "" : remedy_at(model, scene, front.points[without.front()]);
  if (fields.empty()) {
    diagnostics.error(
        crack.span, "E412",
        fmt::format("crack {}: no domain fits round its front: {}", crack.name, why_none(fields)),
        remedy);
  } else if (!without.empty()) {
    const Vec3& x = front.points[without.front()].x;
    diagnostics.error(
        crack.span, "E412",
        fmt::format("crack {}: no domain fits round {} of {} points of its front, the "
                    "first at ({:.6g}, {:.6g}, {:.6g}): {}",
                    crack.name, without.size(), front.points.size(), x.x(), x.y(), x.z(),
                    why_none(fields)),
        remedy);
  }
  return fields;
}

// How deep a crack reaches behind an open front: the area of a face over the chord of the front's
// ends.
double mean_depth(const mesh::CrackedMesh& cracked, const mesh::CrackFront& front) {
  Vec3 area = Vec3::Zero();
  for (const model::Face& face : cracked.faces[front.crack.index()].left_sides) {
    const geometry::ElementSide side = model::element_side(cracked.mesh, face);
    side.for_quadrature_points(
        2, [&](const base::Vec2& r, double weight) { area += weight * side.area_vector(r); });
  }
  const double chord = (front.points.back().x - front.points.front().x).norm();
  return chord > 0.0 ? area.norm() / chord : front.a;
}

// The size of a crack in space.
double crack_size(const model::Model& model, const mesh::CrackedMesh& cracked,
                  const mesh::CrackFront& front) {
  const model::CrackDefinition& crack = model.cracks[front.crack.index()];
  if (crack.kind == model::CrackDefinitionKind::ellipse) {
    return crack.plane.a;
  }
  return front.points.front().at_surface && !crack.plane.closed ? mean_depth(cracked, front)
                                                                : front.a;
}

crack::FrontIntegralDomains tip_domains(const model::Model& model, Discretisation& scene,
                                        const mesh::CrackFront& front,
                                        const crack::TipNeighbourhood& around,
                                        base::Diagnostics& diagnostics) {
  std::vector<int> left_out;
  const crack::IntegrationDomainConstraints limits = find_domain_exclusions(model, scene, front);
  crack::FrontIntegralDomains domains = crack::wrap_tip_domains(around.extension_fields(
      scene.cracked, front, domain_ring_counts(model, front.crack), left_out, limits));
  const std::vector<crack::VirtualExtensionField>& fields = domains.points.front();
  if (!fields.empty()) {
    std::vector<int> ignored;
    // One ring more carries all domains along as one (sensitivity.9).
    std::vector<crack::VirtualExtensionField> wider =
        around.extension_fields(scene.cracked, front, {fields.back().rings + 1}, ignored, limits);
    if (!wider.empty()) {
      domains.beyond = std::move(wider.front());
    }
  }
  const model::CrackDefinition& crack = model.cracks[front.crack.index()];
  if (fields.empty()) {
    diagnostics.error(crack.span, "E412",
                      fmt::format("crack {}: no ring domain fits round the tip at a = {:.6g} (it "
                                  "would leave the body, or reach another tip, another "
                                  "material, a support, a force or the rim of what is heated)",
                                  crack.name, front.a),
                      "give a smaller RADIUS on $TIPNET or other DOMAINS on $VCE");
  }
  for (const int rings : left_out) {
    scene.notes.push_back(
        fmt::format("{}: domain of {} rings left out, it would leave the body", crack.name, rings));
  }
  return domains;
}

} // namespace

bool assign_front_domains(const model::Model& model, Discretisation& scene,
                          base::Diagnostics& diagnostics) {
  const std::size_t errors = diagnostics.error_count();
  std::optional<crack::TipNeighbourhood> around;
  if (scene.has_tips()) {
    around.emplace(scene.cracked.mesh);
  }
  for (mesh::CrackFront& front : scene.cracked.fronts) {
    if (front.is_tip()) {
      scene.domains.push_back(tip_domains(model, scene, front, *around, diagnostics));
    } else {
      front.a = crack_size(model, scene.cracked, front);
      scene.domains.push_back(fields_of(model, scene, front, diagnostics));
    }
  }
  return diagnostics.error_count() == errors;
}

} // namespace spricka::analysis
