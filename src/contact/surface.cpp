// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/surface.hpp"

#include "base/by_dimension.hpp"
#include "mesh/boundary.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/LU>

namespace spricka::contact {

namespace {

// Kasa's fit: |x|^2 = 2 c.x + (r^2 - |c|^2) in the least-squares sense, about the mean for
// accuracy.
std::optional<SurfaceCircle> fit_circle(const std::vector<Vec2>& points, double extent) {
  if (points.size() < 3) {
    return std::nullopt;
  }
  Vec2 mean = Vec2::Zero();
  for (const Vec2& p : points) {
    mean += p;
  }
  mean /= static_cast<double>(points.size());
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Eigen::Vector3d rhs = Eigen::Vector3d::Zero();
  for (const Vec2& p : points) {
    const Vec2 d = (p - mean) / extent;
    const Eigen::Vector3d row(2.0 * d.x(), 2.0 * d.y(), 1.0);
    A += row * row.transpose();
    rhs += row * d.squaredNorm();
  }
  const Eigen::FullPivLU<Eigen::Matrix3d> lu(A);
  // Points on a line, or all but on one: no circle.
  if (lu.rcond() < 1e-12) {
    return std::nullopt;
  }
  const Eigen::Vector3d s = lu.solve(rhs);
  const double radius = extent * std::sqrt(std::max(0.0, s[2] + s.head<2>().squaredNorm()));
  // Without the round-off of the sum: the same circle when a crack has put other nodes on it, so
  // that rows which it does not touch stay what they were.
  const double grid = std::ldexp(1.0, std::ilogb(extent) - 43);
  const auto snapped = [grid](double x) { return grid * std::round(x / grid); };
  const Vec2 centre = mean + extent * s.head<2>();
  SurfaceCircle circle{{snapped(centre.x()), snapped(centre.y())}, snapped(radius), true};
  for (const Vec2& p : points) {
    const double off = std::abs((p - circle.centre).norm() - radius);
    if (off > 1e-4 * radius) {
      return std::nullopt;
    }
    circle.exact = circle.exact && off <= 1e-6 * radius;
  }
  return radius < 1e3 * extent ? std::optional(circle) : std::nullopt;
}

// The circle's normal where a facet's own is n: it leaves the body on the same side.
template <class Vector>
Vector radial_normal(const SurfaceCircle& circle, const Vector& x, const Vector& n) {
  Vector radial = x;
  radial.template head<2>() -= circle.centre;
  radial.normalize();
  return radial.dot(n) > 0.0 ? radial : Vector(-radial);
}

// Edges chain by chain.
std::vector<model::Face> order_edges(const model::Mesh& mesh, const std::vector<model::Face>& faces,
                                     PlanarEdgeChains& plane) {
  std::vector<model::Face> ordered;
  for (const mesh::FaceChain& chain : mesh::build_face_chains(mesh, faces)) {
    plane.chains.push_back({ordered.size(), chain.faces.size(), chain.closed});
    for (const model::Face& face : chain.faces) {
      ordered.push_back(face);
      plane.edges.push_back(mesh::plane_edge(mesh, face));
    }
  }
  return ordered;
}

std::vector<model::Face> keep_order(const model::Mesh& /*mesh*/,
                                    const std::vector<model::Face>& faces,
                                    PlanarEdgeChains& /*plane*/) {
  return faces;
}

} // namespace

double out_of_plane_depth(const ContactSurface& contact, const ContactSurface& target,
                          const Vec2& x) {
  if (contact.axial) {
    return 2.0 * std::numbers::pi * std::max(0.0, x.x()); // round-off at the axis
  }
  return std::min(contact.thickness, target.thickness);
}

ContactSurface make_contact_surface(const model::Model& model, const model::Mesh& mesh,
                                    base::FaceSetId set) {
  return make_contact_surface(model, mesh, mesh.set_with_id(set).faces);
}

ContactSurface make_contact_surface(const model::Model& model, const model::Mesh& mesh,
                                    const std::vector<model::Face>& faces) {
  constexpr base::ByDimension order{order_edges, keep_order};
  ContactSurface surface;
  const std::vector<model::Face> ordered = order.at(mesh.dim)(mesh, faces, surface.plane);
  static_cast<FacetSurface&>(surface) = make_facet_surface(mesh, ordered, model.mesh.node_count());
  for (const model::Face& face : ordered) {
    const bool first = &face == &ordered.front();
    const double E = model.element_material(mesh, face.element).E;
    // The softest, by which the contact side is chosen (contact.6); the thinnest, as
    // out_of_plane_depth() takes the smaller.
    surface.stiffness = first ? E : std::min(surface.stiffness, E);
    const double t = model.element_property(mesh, face.element).thickness;
    surface.thickness = first ? t : std::min(surface.thickness, t);
  }
  std::vector<Vec2> points;
  for (const Edge& edge : surface.plane.edges) {
    points.insert(points.end(), edge.x.begin(), edge.x.begin() + edge.count);
  }
  surface.axial = model::is_axisymmetric(model);
  surface.circle = fit_circle(points, surface.extent);
  return surface;
}

Vec3 surface_normal(const ContactSurface& surface, std::size_t facet,
                    const geometry::SidePoint& at) {
  return surface.circle ? radial_normal(*surface.circle, at.x, at.normal())
                        : surface_normal(static_cast<const FacetSurface&>(surface), facet, at);
}

Vec2 surface_normal(const ContactSurface& surface, const Edge& edge, double xi) {
  const Vec2 n = outer_normal(edge, xi);
  return surface.circle ? radial_normal(*surface.circle, point_on_edge(edge, xi), n) : n;
}

} // namespace spricka::contact
