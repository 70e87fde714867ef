// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/load_points.hpp"

#include "fe/bearing.hpp"
#include "fe/load_rule.hpp"
#include "fe/set_shares.hpp"
#include "model/loads.hpp"

#include <array>
#include <utility>
#include <vector>

namespace spricka::fe {

namespace {

using base::Vec3;

/// Force at x with the area vector a: value(x) |a| is a traction, -p a a pressure.
using FaceDensity = std::function<Vec3(const Vec3& x, const Vec3& a)>;
using BodyDensity = std::function<Vec3(const Vec3& x)>;

/// A load, where it acts, and where what its rules cannot follow goes.
struct Spread {
  const model::Model& model;
  const model::Mesh& mesh;
  const model::Load& load;
  UnresolvedLoad* missed = nullptr;
};

// Degree [dimension] of constants over whole elements: in the plane a function of degree 3, the
// Jacobian 2, the radius 2. Where the rim of a set cuts an element its share is no polynomial.
constexpr std::array<int, 4> constant_degree{0, load_degree, 7, load_degree};

/// The points of an element for a load, and its functions there.
template <int dim> struct BodyLoadRule {
  FieldAdaptedRule<dim> rule;
  /// [point] of a rule that other elements have, too; else empty
  std::span<const shape::ShapeFunctionValues<dim>> functions;

  [[nodiscard]] shape::ShapeFunctionValues<dim> at(const AnyElement<dim>& element,
                                                   std::size_t i) const {
    const shape::Point<dim>& r = rule.points[i].r;
    return functions.empty() ? shape::ShapeFunctionValues<dim>{element.N(r), element.dN(r)}
                             : functions[i];
  }
};

template <int dim>
BodyLoadRule<dim> body_rule(const AnyElement<dim>& element, const AnyNodeVectors<dim>& X,
                            const model::Load& load, const FieldMagnitude& scale, bool cut_by_rim) {
  if (cut_by_rim || !is_constant(load)) {
    return {body_load_rule<dim>(element, X, load, scale), {}};
  }
  const int degree = constant_degree.at(dim);
  const auto usual = shape::quadrature<dim>(element.domain, degree);
  return {{{usual.begin(), usual.end()}, 0.0, 0.0, false},
          shape::shape_functions_at_quadrature_points<dim>(element, degree)};
}

void for_face_points(const Spread& spread, const FaceDensity& density,
                     const LoadPointVisitor::FaceVisit& visit) {
  const auto& [model, mesh, load, missed] = spread;
  const FieldMagnitude scale = load_scale(mesh, load);
  std::vector<LoadPoint> points;
  for (const model::Face& face : mesh.set_with_id(load.faces).faces) {
    const geometry::ElementSide side = model::element_side(mesh, face);
    const ConstitutiveLaw law = constitutive_law(model, mesh, face.element);
    const FieldAdaptedRule<2> rule = load_rule(side, load, scale);
    points.clear();
    for (const auto& [r, weight] : rule.points) {
      const Vec3 x = side.position(r);
      LoadPoint& at = points.emplace_back();
      at.r.head<2>() = r;
      // The density has the area; what stands behind it is (fe.5).
      at.force = weight * law.depth(x.x()) * density(x, side.area_vector(r));
    }
    visit(face, points);
    if (missed != nullptr) {
      // Rules count by the reference side: its area and depth at the centre stand for all of it.
      const auto centre = map_from_unit_cube<2>(side.domain(), {0.5, 0.5, 0.5}).r;
      const double depth = law.depth(side.position(centre).x());
      missed->add(rule.missed, rule.amount, depth * side.area_vector(centre).norm());
    }
  }
}

// The density counts by the elements' shares where the rim of the set cuts them.
void for_body_points(const Spread& spread, const BodyDensity& density,
                     const LoadPointVisitor::BodyVisit& visit) {
  const model::Mesh& mesh = spread.mesh;
  const ElementSetCoverage shares = find_set_coverage(spread.model, mesh, spread.load.elements);
  const FieldMagnitude scale = load_scale(mesh, spread.load, shares.elements);
  std::vector<LoadPoint> points;
  for (const base::ElementId e : shares.elements) {
    with_any_element(mesh, e, [&]<int dim>(const AnyElement<dim>& element) {
      const AnyNodeVectors<dim> X = element_coordinates(element, mesh, e);
      const ConstitutiveLaw law = constitutive_law(spread.model, mesh, e);
      const CutElementShareFunction* share = shares.find_cut_share_function(e);
      const BodyLoadRule<dim> own =
          body_rule<dim>(element, X, spread.load, scale, share != nullptr);
      const FieldAdaptedRule<dim>& rule = own.rule;
      points.clear();
      for (std::size_t i = 0; i < rule.points.size(); ++i) {
        const auto& point = rule.points[i];
        const shape::ShapeFunctionValues<dim> functions = own.at(element, i);
        const Eigen::Matrix<double, dim, dim> J = X.lazyProduct(functions.dN);
        Vec3 x = Vec3::Zero();
        x.template head<dim>() = X * functions.N;
        const double part = share == nullptr ? 1.0 : (*share)(x);
        LoadPoint& at = points.emplace_back();
        at.r.template head<dim>() = point.r;
        at.force = point.weight * J.determinant() * part * law.depth(x.x()) * density(x);
      }
      visit(e, points);
      if (spread.missed != nullptr) {
        const auto centre = map_from_unit_cube<dim>(element.domain, {0.5, 0.5, 0.5}).r;
        const Eigen::Matrix<double, dim, dim> J = X.lazyProduct(element.dN(centre));
        const double depth = law.depth(X.row(0) * element.N(centre));
        spread.missed->add(rule.missed, rule.amount, depth * J.determinant());
      }
    });
  }
}

// A total spreads evenly over the area: a density of 1, put into the first component, adds up to it
// (fe.18).
void for_total_on_faces(const Spread& spread, const Vec3& total,
                        const LoadPointVisitor::FaceVisit& visit) {
  double area = 0.0;
  for_face_points(
      spread, [](const Vec3& /*x*/, const Vec3& a) { return Vec3(a.norm(), 0.0, 0.0); },
      [&](const model::Face& /*face*/, std::span<const LoadPoint> points) {
        for (const LoadPoint& p : points) {
          area += p.force.x();
        }
      });
  if (area > 0.0) {
    for_face_points(
        spread, [&](const Vec3& /*x*/, const Vec3& a) { return Vec3((a.norm() / area) * total); },
        visit);
  }
}

// The same over the volume of a body. Its points are many: they are found once and kept.
void for_total_on_body(const Spread& spread, const Vec3& total,
                       const LoadPointVisitor::BodyVisit& visit) {
  double volume = 0.0;
  std::vector<LoadPoint> kept;
  std::vector<std::pair<base::ElementId, std::size_t>> counts; // of points, of each element
  for_body_points(
      spread, [](const Vec3& /*x*/) { return Vec3(1.0, 0.0, 0.0); },
      [&](base::ElementId e, std::span<const LoadPoint> points) {
        counts.emplace_back(e, points.size());
        for (const LoadPoint& p : points) {
          volume += p.force.x();
          kept.push_back(p);
        }
      });
  if (!(volume > 0.0)) {
    return;
  }
  const Vec3 density = total / volume;
  for (LoadPoint& p : kept) {
    p.force = p.force.x() * density;
  }
  const LoadPoint* begin = kept.data();
  for (const auto& [e, count] : counts) {
    visit(e, {begin, count});
    begin += count;
  }
}

} // namespace

void for_load_points(const model::Model& model, const model::Mesh& mesh, const model::Load& load,
                     const LoadPointVisitor& visit, UnresolvedLoad* missed) {
  const Spread spread{model, mesh, load, missed};
  switch (load.type) {
  case model::LoadType::resultant:
    if (const Vec3 total = load_value(load, Vec3::Zero()); load.faces.valid()) {
      for_total_on_faces({model, mesh, load, nullptr}, total, visit.on_face);
    } else {
      for_total_on_body({model, mesh, load, nullptr}, total, visit.on_body);
    }
    return;
  case model::LoadType::traction:
    for_face_points(
        spread, [&](const Vec3& x, const Vec3& a) { return Vec3(a.norm() * load_value(load, x)); },
        visit.on_face);
    return;
  case model::LoadType::pressure:
    for_face_points(
        spread, [&](const Vec3& x, const Vec3& a) { return Vec3(-load_value(load, x)[0] * a); },
        visit.on_face);
    return;
  case model::LoadType::body:
    for_body_points(
        spread, [&](const Vec3& x) { return load_value(load, x); }, visit.on_body);
    return;
  case model::LoadType::bearing:
    for_bearing_points(model, mesh, load, visit.on_face);
    return;
  case model::LoadType::force:
  case model::LoadType::displacement:
  case model::LoadType::temperature:
    return;
  }
}

} // namespace spricka::fe
