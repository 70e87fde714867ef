// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/load_jumps.hpp"

#include "model/mesh_side.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace spricka::crack {

namespace {

// Square of what a load on a side has beyond a linear one, and of the load, integrated over it.
struct Roughness {
  double discontinuous = 0.0, all = 0.0;
};

Roughness roughness(const ActingLoad& acting, const fe::FieldMagnitude& scale,
                    const geometry::ElementSide& side) {
  const fe::FieldAdaptedRule<2> rule = fe::load_rule(side, *acting.load, scale);
  // by Legendre's polynomials of the arc length that a straight side has, twice over it -1 .. 1
  const base::Vec2 from = side.X.col(0).head<2>();
  const base::Vec2 chord = side.X.col(1).head<2>() - from;
  const base::Vec3 normal = base::Vec3(chord.y(), -chord.x(), 0.0).normalized();
  base::Vec2 mean = base::Vec2::Zero();
  base::Vec2 slope = base::Vec2::Zero();
  double square = 0.0;
  for (const auto& point : rule.points) {
    const base::Vec3 x = side.position(point.r);
    const double s = 2.0 * (x.head<2>() - from).dot(chord) / chord.squaredNorm() - 1.0;
    const double w = 2.0 * point.weight * side.tangents(point.r).col(0).norm() / chord.norm();
    const base::Vec2 t = load_force_on_face(acting, x, normal).head<2>();
    mean += 0.5 * w * t;
    slope += 1.5 * w * s * t;
    square += w * t.squaredNorm();
  }
  // Over -1 .. 1 the linear part mean + slope s has the square 2 mean^2 + 2/3 slope^2.
  const double discontinuous = square - 2.0 * mean.squaredNorm() - slope.squaredNorm() * 2.0 / 3.0;
  const double half = 0.5 * chord.norm();
  return {half * std::max(discontinuous, 0.0), half * square};
}

// Calls visit(face, roughness) for loaded sides with nodes that q moves.
template <class Visit>
void for_discontinuous_sides(const TipContext& set, const VirtualExtensionField& field,
                             Visit&& visit) {
  std::vector<base::NodeId> moved;
  for (const NodeMotion& m : field.motion) {
    moved.push_back(m.node);
  }
  for (const ActingLoad& acting : set.loads.loads) {
    if (acting.faces.empty() || fe::is_constant(*acting.load)) {
      continue;
    }
    const fe::FieldMagnitude scale = face_load_scale(set.mesh, acting);
    for (const model::Face& face : acting.faces) {
      const geometry::ElementSide side = model::element_side(set.mesh, face);
      if (std::ranges::any_of(
              side.nodes, [&](base::NodeId n) { return std::ranges::binary_search(moved, n); })) {
        visit(face, roughness(acting, scale, side));
      }
    }
  }
}

// Whether tractions jump within sides of the elements where q varies.
bool faces_jump(const TipContext& set, const VirtualExtensionField& field) {
  constexpr double little = 1e-3;
  bool jumps = false;
  for_discontinuous_sides(set, field, [&](const model::Face& face, const Roughness& r) {
    jumps = jumps || (r.discontinuous > little * r.all &&
                      std::ranges::binary_search(field.elements, face.element));
  });
  return jumps;
}

// The largest jump of the temperature inside elements or between them.
double largest_jump(const TipContext& set, const VirtualExtensionField& field) {
  if (set.loads.temperature.size() == 0) {
    return 0.0;
  }
  double most = 0.0;
  std::map<base::NodeId, double> of_node;
  for (const std::vector<base::ElementId>* elements : {&field.elements, &field.inside}) {
    for (const base::ElementId e : *elements) {
      const auto nodes = set.mesh.element_nodes(e);
      for (int c = 0; c < base::element_info(set.mesh.type[e.index()]).corners; ++c) {
        const double T = set.loads.temperature[set.mesh.first[e.index()] + c];
        const auto [met, fresh] = of_node.try_emplace(nodes[static_cast<std::size_t>(c)], T);
        most = std::max(most, std::abs(met->second - T));
      }
      for (const fe::ScaledTemperature& acting : set.loads.heat) {
        if (!acting.heat->discontinuous.empty() && acting.heat->discontinuous[e.index()]) {
          for (const fe::ResidualTemperaturePoint& p : acting.heat->residual_points_in_element(e)) {
            // What an element does not take of a jump is about half of it on either side.
            most = std::max(most, 2.0 * std::abs(acting.factor * p.T));
          }
        }
      }
    }
  }
  return most;
}

double size_of(const TipContext& set, const VirtualExtensionField& field) {
  double most = 0.0;
  for (const NodeMotion& m : field.motion) {
    most = std::max(most, (set.mesh.x[m.node.index()].head<2>() - set.tip.x).norm());
  }
  return most;
}

// Estimates of size, no bounds: they tell the steps of tests/unit/analysis/test_load_jumps.cpp, of
// which G was 0.1 to 1 % off.
constexpr double of_faces = 0.5;
constexpr double of_heat = 0.05;

double heat_invalid_reason(const TipContext& set, const VirtualExtensionField& field) {
  const double E = fe::effective_modulus(set.material, set.state());
  const double stress = E * set.section_expansion_coefficient() * largest_jump(set, field);
  return of_heat * stress * stress * size_of(set, field) / E;
}

} // namespace

double load_jump_G_uncertainty(const TipContext& set, const VirtualExtensionField& field) {
  double sum = 0.0;
  for_discontinuous_sides(
      set, field, [&](const model::Face& /*face*/, const Roughness& r) { sum += r.discontinuous; });
  return of_faces * sum / fe::effective_modulus(set.material, set.state()) +
         heat_invalid_reason(set, field);
}

std::vector<bool> domains_with_load_jumps(const TipContext& set,
                                          const std::vector<VirtualExtensionField>& fields,
                                          double K) {
  std::vector<bool> discontinuous;
  discontinuous.reserve(fields.size());
  const double G = K * K / fe::effective_modulus(set.material, set.state());
  const bool heated = !fields.empty() &&
                      heat_invalid_reason(set, fields.back()) > largest_relative_G_uncertainty * G;
  for (const VirtualExtensionField& field : fields) {
    discontinuous.push_back(heated || faces_jump(set, field));
  }
  return discontinuous;
}

} // namespace spricka::crack
