// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/bearing.hpp"
#include "fe/face.hpp"
#include "fe/load_rule.hpp"
#include "fe/set_shares.hpp"

/// Distributed loads as forces at integration points, for any functions that they shall work on.
namespace spricka::fe {

/// What rules could not follow of a load, and its magnitude, over all sides or elements.
struct Unresolved {
  double missed = 0.0;
  double amount = 0.0;

  /// Of one, by its reference size; `unit`: the size of that.
  void add(double missed_here, double amount_here, double unit) {
    missed += missed_here * unit;
    amount += amount_here * unit;
  }
  [[nodiscard]] double share() const {
    return missed > 0.0 ? missed / std::max(missed, amount) : 0.0;
  }
};

/// Calls visit(Side{}, face, r, force) at the points of the load's faces with density(x, a), where
/// a is the area vector: a density of value(x) |a| is a traction, one of -p a a pressure. The
/// points follow the load's values (load_rule); what they could not follow adds to `missed`.
template <class Density, class Visit>
void for_face_points(const model::Model& model, const model::Mesh& mesh, const model::Load& load,
                     Density&& density, Visit&& visit, Unresolved* missed = nullptr) {
  const FieldScale scale = load_scale(mesh, load);
  for_faces(mesh, mesh.set(load.faces).faces,
            [&]<shape::Shape Side>(Side side, const model::Face& face) {
              const SideNodes<Side> X = side_coordinates<Side>(mesh, face);
              const Law law = law_of(model, mesh, face.element);
              const AdaptedRule<Side::dim> rule = load_rule<Side>(X, load, scale);
              for (const auto& point : rule.points) {
                const base::Vec3 x = X * Side::N(point.r);
                const base::Vec3 force =
                    point.weight * law.depth(x.x()) * density(x, area_vector<Side>(X, point.r));
                visit(side, face, point.r, force);
              }
              if (missed != nullptr) {
                const auto centre = unit_cube_point<Side>({0.5, 0.5, 0.5}).r;
                const double depth = law.depth((X * Side::N(centre)).x());
                missed->add(rule.missed, rule.amount, depth * area_vector<Side>(X, centre).norm());
              }
            });
}

/// Calls visit(S{}, element, r, force) at the points of the load's elements with density(x), which
/// counts by their shares where the rim of the set cuts them.
template <class Density, class Visit>
void for_body_points(const model::Model& model, const model::Mesh& mesh, const model::Load& load,
                     Density&& density, Visit&& visit, Unresolved* missed = nullptr) {
  const SetShares shares = set_shares(model, mesh, load.elements);
  const FieldScale scale = load_scale(mesh, load, shares.elements);
  for_blocks(mesh, shares.elements,
             [&]<shape::ElementShape S>(S shape, std::span<const base::ElementId> block) {
               for (const base::ElementId e : block) {
                 const NodeVectors<S> X = coordinates<S>(mesh, e);
                 const Law law = law_of(model, mesh, e);
                 const ElementShare* share = shares.of(e);
                 const AdaptedRule<S::dim> rule = body_load_rule<S>(X, load, scale);
                 for (const auto& point : rule.points) {
                   const Eigen::Matrix<double, S::dim, S::dim> J = X * S::dN(point.r);
                   base::Vec3 x = base::Vec3::Zero();
                   x.template head<S::dim>() = X * S::N(point.r);
                   const double part = share == nullptr ? 1.0 : (*share)(x);
                   const base::Vec3 force =
                       point.weight * J.determinant() * part * law.depth(x.x()) * density(x);
                   visit(shape, e, point.r, force);
                 }
                 if (missed != nullptr) {
                   const auto centre = unit_cube_point<S>({0.5, 0.5, 0.5}).r;
                   const Eigen::Matrix<double, S::dim, S::dim> J = X * S::dN(centre);
                   const double depth = law.depth((X * S::N(centre))[0]);
                   missed->add(rule.missed, rule.amount, depth * J.determinant());
                 }
               }
             });
}

/// Forces at points of a load that is spread over faces or elements; others (at nodes, given
/// displacements, temperatures, bearings in space) have none. on_face and on_body as above. What
/// the rules could not follow goes to `missed`.
template <class OnFace, class OnBody>
void for_load_points(const model::Model& model, const model::Mesh& mesh, const model::Load& load,
                     OnFace&& on_face, OnBody&& on_body, Unresolved* missed = nullptr) {
  using base::Vec3;
  switch (load.type) {
  case model::LoadType::resultant: {
    // A total spreads evenly over area or volume.
    double total = 0.0;
    const Vec3 F = load_value(load, Vec3::Zero());
    const auto add = [&](auto /*shape*/, const auto& /*where*/, const auto& /*r*/,
                         const Vec3& force) { total += force.x(); };
    const auto area = [](const Vec3& /*x*/, const Vec3& a) { return Vec3(a.norm(), 0.0, 0.0); };
    const auto unit = [](const Vec3& /*x*/) { return Vec3(1.0, 0.0, 0.0); };
    if (load.faces.valid()) {
      for_face_points(model, mesh, load, area, add);
    } else {
      for_body_points(model, mesh, load, unit, add);
    }
    if (!(total > 0.0)) {
      return;
    }
    if (load.faces.valid()) {
      for_face_points(
          model, mesh, load,
          [&](const Vec3& /*x*/, const Vec3& a) { return Vec3((a.norm() / total) * F); }, on_face);
    } else {
      for_body_points(
          model, mesh, load, [&](const Vec3& /*x*/) { return Vec3(F / total); }, on_body);
    }
    return;
  }
  case model::LoadType::traction:
    for_face_points(
        model, mesh, load,
        [&](const Vec3& x, const Vec3& a) { return Vec3(a.norm() * load_value(load, x)); }, on_face,
        missed);
    return;
  case model::LoadType::pressure:
    for_face_points(
        model, mesh, load,
        [&](const Vec3& x, const Vec3& a) { return Vec3(-load_value(load, x)[0] * a); }, on_face,
        missed);
    return;
  case model::LoadType::body:
    for_body_points(
        model, mesh, load, [&](const Vec3& x) { return load_value(load, x); }, on_body, missed);
    return;
  case model::LoadType::bearing:
    if (mesh.dim == 2) {
      for_bearing_points(model, mesh, load,
                         [&](const model::Face& face, double t, const base::Vec2& force) {
                           for_edges(mesh, {face}, [&]<shape::Shape Side>(Side side, const auto&) {
                             on_face(side, face, shape::Point<Side::dim>::Constant(t),
                                     Vec3(force.x(), force.y(), 0.0));
                           });
                         });
    }
    return;
  case model::LoadType::force:
  case model::LoadType::displacement:
  case model::LoadType::temperature:
    return;
  }
}

} // namespace spricka::fe
