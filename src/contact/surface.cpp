// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/surface.hpp"

#include "mesh/boundary.hpp"
#include "model/mesh_side.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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

ContactSurface solid_surface(const model::Model& model, const model::Mesh& mesh,
                             const std::vector<model::Face>& faces) {
  ContactSurface surface;
  surface.space = make_space_surface(mesh, faces);
  surface.extent = surface.space.extent;
  surface.mean_length = surface.space.mean_size;
  for (const model::Face& face : faces) {
    const double E = model.element_material(mesh, face.element).E;
    surface.stiffness = surface.facets.empty() ? E : std::min(surface.stiffness, E);
    surface.facets.push_back(model::element_side(mesh, face));
  }
  return surface;
}

} // namespace

double out_of_plane_depth(const ContactSurface& contact, const ContactSurface& target,
                          const Vec2& x) {
  if (contact.axial) {
    return 2.0 * std::numbers::pi * std::max(0.0, x.x()); // round-off at the axis
  }
  return std::min(contact.thickness, target.thickness);
}

ContactSurface make_surface(const model::Model& model, const model::Mesh& mesh,
                            base::FaceSetId set) {
  return make_surface(model, mesh, mesh.set_with_id(set).faces);
}

ContactSurface make_surface(const model::Model& model, const model::Mesh& mesh,
                            const std::vector<model::Face>& faces) {
  if (mesh.dim == 3) {
    return solid_surface(model, mesh, faces);
  }
  ContactSurface surface;
  surface.axial = model::axisymmetric(model);
  std::vector<Vec2> points;
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 high = -low;
  std::size_t count = 0;
  for (const mesh::FaceChain& chain : mesh::build_chains(mesh, faces)) {
    surface.plane.chains.push_back({count, chain.faces.size(), chain.closed});
    for (const model::Face face : chain.faces) {
      const Edge edge = mesh::plane_edge(mesh, face);
      for (int i = 0; i < edge.count; ++i) {
        const Vec2& p = edge.x[static_cast<std::size_t>(i)];
        points.push_back(p);
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      }
      surface.mean_length += edge.length;
      const double E = model.element_material(mesh, face.element).E;
      // The softest, by which the contact side is chosen (contact.6); the thinnest, as
      // out_of_plane_depth() takes the smaller.
      surface.stiffness = count == 0 ? E : std::min(surface.stiffness, E);
      const double t = model.element_property(mesh, face.element).thickness;
      surface.thickness = count == 0 ? t : std::min(surface.thickness, t);
      ++count;
      surface.facets.push_back(model::element_side(mesh, face));
      surface.plane.edges.push_back(edge);
    }
  }
  if (count > 0) {
    surface.mean_length /= static_cast<double>(count);
    surface.extent = (high - low).norm();
    surface.circle = fit_circle(points, surface.extent);
  }
  return surface;
}

Vec2 surface_normal(const ContactSurface& surface, const Edge& edge, double xi) {
  Vec2 n = outer_normal(edge, xi);
  if (!surface.circle) {
    return n;
  }
  const Vec2 radial = (point_on(edge, xi) - surface.circle->centre).normalized();
  return radial.dot(n) > 0.0 ? radial : Vec2(-radial);
}

} // namespace spricka::contact
