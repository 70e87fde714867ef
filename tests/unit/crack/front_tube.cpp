// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/crack/front_tube.hpp"
#include "crack/front_intensity.hpp"

#include "mesh/boundary.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>

#include <Eigen/Geometry>

namespace spricka::test {

using base::ElementType;
using base::NodeId;
using base::Vec3;

namespace {

constexpr double pi = std::numbers::pi;

// A place of the lattice of half steps: along the front, away from it, round it.
using Key = std::array<int, 3>;

class Lattice {
public:
  Lattice(model::Mesh& mesh, const mesh::FrontCurve& curve, const TubeSpec& spec)
      : mesh_(mesh), curve_(curve), spec_(spec) {}

  NodeId node(Key key) {
    if (curve_.closed()) {
      key[0] %= 2 * spec_.segments;
    }
    key[2] = key[1] == 0 ? 0 : key[2]; // the front itself
    const auto [at, fresh] = nodes_.try_emplace(key);
    if (fresh) {
      at->second = model::add_node(mesh_, place(key), base::Label(), base::NetId(std::size_t{0}));
    }
    return at->second;
  }

  [[nodiscard]] const std::map<Key, NodeId>& nodes() const { return nodes_; }

private:
  [[nodiscard]] Vec3 place(const Key& key) const {
    const double s = curve_.length() * key[0] / (2.0 * spec_.segments);
    // Mid nodes round the front lie on chords.
    const Vec3 low = on_ray(s, key[1], key[2] - key[2] % 2);
    return key[2] % 2 == 0 ? low : Vec3(0.5 * (low + on_ray(s, key[1], key[2] + 1)));
  }

  [[nodiscard]] double radius(int level) const {
    const auto ring = [&](int i) {
      return i == 0 ? 0.0 : spec_.radii[static_cast<std::size_t>(i - 1)];
    };
    if (level % 2 == 0) {
      return ring(level / 2);
    }
    const double low = ring(level / 2);
    const double high = ring(level / 2 + 1);
    return level == 1 && spec_.quarter_point ? 0.25 * high : 0.5 * (low + high);
  }

  [[nodiscard]] Vec3 on_ray(double s, int level, int ray) const {
    const mesh::FrontFrame frame = curve_.at(s);
    const double theta = -pi + pi * ray / spec_.sectors;
    const double y = radius(level) * std::cos(theta);
    // The crack's faces are plane.
    const bool on_face = ray == 0 || ray == 2 * spec_.sectors;
    const double z = on_face ? 0.0 : radius(level) * std::sin(theta);
    return frame.x + y * frame.m + z * frame.b + spec_.shear * y * frame.t;
  }

  model::Mesh& mesh_;
  const mesh::FrontCurve& curve_;
  const TubeSpec& spec_;
  std::map<Key, NodeId> nodes_;
};

void add_wedge(model::Mesh& mesh, Lattice& at, int j, int k) {
  const auto n = [&](int dj, int level, int dk) {
    return at.node({2 * j + dj, level, 2 * k + dk});
  };
  const std::array<NodeId, 15> nodes{n(0, 0, 0), n(0, 2, 0), n(0, 2, 2), n(2, 0, 0), n(2, 2, 0),
                                     n(2, 2, 2), n(0, 1, 0), n(0, 2, 1), n(0, 1, 2), n(2, 1, 0),
                                     n(2, 2, 1), n(2, 1, 2), n(1, 0, 0), n(1, 2, 0), n(1, 2, 2)};
  model::add_element(mesh, ElementType::pentac15, nodes, base::Label(),
                     base::NetId(std::size_t{0}));
}

void add_brick(model::Mesh& mesh, Lattice& at, const Key& cell) {
  const auto n = [&](int dj, int di, int dk) {
    return at.node({2 * cell[0] + dj, 2 * cell[1] + di, 2 * cell[2] + dk});
  };
  const std::array<NodeId, 20> nodes{n(0, 0, 0), n(0, 2, 0), n(0, 2, 2), n(0, 0, 2), n(2, 0, 0),
                                     n(2, 2, 0), n(2, 2, 2), n(2, 0, 2), n(0, 1, 0), n(0, 2, 1),
                                     n(0, 1, 2), n(0, 0, 1), n(2, 1, 0), n(2, 2, 1), n(2, 1, 2),
                                     n(2, 0, 1), n(1, 0, 0), n(1, 2, 0), n(1, 2, 2), n(1, 0, 2)};
  model::add_element(mesh, ElementType::hexec20, nodes, base::Label(), base::NetId(std::size_t{0}));
}

mesh::CrackFront make_front(const mesh::FrontCurve& curve, const TubeSpec& spec, Lattice& at) {
  mesh::CrackFront front;
  front.crack = base::CrackId(std::size_t{0});
  front.a = 1.0;
  front.size = spec.radii.front();
  front.radius = spec.radii.back();
  front.curve = std::make_shared<const mesh::FrontCurve>(curve);
  front.points.clear();
  const int last = curve.closed() ? spec.segments - 1 : spec.segments;
  const double step = curve.length() / spec.segments;
  for (int j = 0; j <= last; ++j) {
    mesh::FrontPoint point;
    point.node = at.node({2 * j, 0, 0});
    const mesh::FrontFrame frame = curve.at(j * step);
    point.x = frame.x;
    point.growth = frame.m;
    point.s = j * step;
    point.at_surface = !curve.closed() && (j == 0 || j == last);
    point.weight = point.at_surface ? 0.5 * step : step;
    point.size = front.size;
    point.radius = front.radius;
    front.points.push_back(point);
  }
  return front;
}

} // namespace

Tube::Tube(const mesh::FrontCurve& curve, const TubeSpec& spec) {
  model.nets = {{"", {}}};
  model.materials = {{"M", 1000.0, spec.nu, 0.0, 1e-3, {}}};
  model.properties = {{base::ElementSetId(std::size_t{0}),
                       base::MaterialId(std::size_t{0}),
                       model::StressState::solid,
                       1.0,
                       {}}};
  model::Mesh& mesh = model.mesh;
  mesh.dim = 3;
  mesh.first = {0};
  Lattice lattice(mesh, curve, spec);
  for (int j = 0; j < spec.segments; ++j) {
    for (int k = 0; k < spec.sectors; ++k) {
      add_wedge(mesh, lattice, j, k);
      for (int i = 1; i < static_cast<int>(spec.radii.size()); ++i) {
        add_brick(mesh, lattice, {j, i, k});
      }
    }
  }
  mesh.property.assign(mesh.element_count(), base::PropertyId(std::size_t{0}));
  cracked.fronts = {make_front(curve, spec, lattice)};
  mesh::CrackFaceNodes faces;
  for (const auto& [key, node] : lattice.nodes()) {
    if (key[1] == 0 || key[2] == 2 * spec.sectors) {
      faces.left.push_back(node);
    }
    if (key[1] == 0 || key[2] == 0) {
      faces.right.push_back(node);
    }
  }
  faces.left_sides = mesh::boundary_faces_with_all_nodes_in(mesh, faces.left);
  faces.right_sides = mesh::boundary_faces_with_all_nodes_in(mesh, faces.right);
  cracked.faces = {faces};
  cracked.mesh = mesh;
}

base::Vector Tube::at_nodes(const CardField& u) const {
  std::vector<crack::UpperOrLowerFace> side(mesh().node_count(), crack::UpperOrLowerFace::none);
  for (const NodeId n : cracked.faces.front().left) {
    side[n.index()] = crack::UpperOrLowerFace::upper;
  }
  for (const NodeId n : cracked.faces.front().right) {
    side[n.index()] = crack::UpperOrLowerFace::lower;
  }
  base::Vector values(3 * static_cast<Eigen::Index>(mesh().node_count()));
  for (std::size_t n = 0; n < mesh().node_count(); ++n) {
    values.segment<3>(3 * static_cast<Eigen::Index>(n)) = u(mesh().x[n], side[n]);
  }
  return values;
}

base::Vector Tube::rough() const {
  base::Vector values(3 * static_cast<Eigen::Index>(mesh().node_count()));
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    values[i] = 1e-2 * std::sin(1.7 * static_cast<double>(i * i % 97));
  }
  return values;
}

crack::FrontIntegralDomains Tube::fields(const std::vector<int>& rings) const {
  return crack::build_front_domains(cracked, front(), rings);
}

std::vector<crack::StressIntensity> Tube::K(const base::Vector& u,
                                            const crack::FrontLoads& loads) const {
  crack::FrontIntensityOptions request;
  request.opening = true;
  return crack::front_intensity(model, cracked, front(), fields(), request, u, loads);
}

mesh::FrontCurve straight_front(double length) {
  return {{Vec3::Zero(), length * Vec3::UnitZ()}, {Vec3::UnitY(), Vec3::UnitY()}, false};
}

mesh::FrontCurve ellipse_front(double p, double q, double part) {
  constexpr int count = 96;
  const bool closed = part == 1.0;
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) { // clockwise seen from b: m = b x t points outwards
    const double angle = 2.0 * pi * part * i / (closed ? count : count - 1);
    points.emplace_back(p * std::cos(angle), -q * std::sin(angle), 0.0);
  }
  return {points, std::vector<Vec3>(points.size(), Vec3::UnitZ()), closed};
}

mesh::FrontCurve penny_front(double a, double part) {
  return ellipse_front(a, a, part);
}

namespace {

// The harmonic function phi whose derivative by z is -4 sqrt(1 - r^2) on the disc and zero beside
// it, at z >= 0, with the derivatives that displacements need.
struct Penny {
  double z_ = 0.0, zz = 0.0, x_ = 0.0, y_ = 0.0, xz = 0.0, yz = 0.0, xx = 0.0, xy = 0.0;

  Penny(double x, double y, double z) {
    using C = std::complex<double>;
    const double q = x * x + y * y;
    const C s(z, 1.0);
    const C i(0.0, 1.0);
    const C R = std::sqrt(q + s * s);
    const C L = std::log(s + R);
    const double E = 1.0 + z * z;
    const double h = 2.0 * (-L - E / q * s / R + (s - 2.0 * z) / R).imag();
    const double dh = 2.0 * (-0.5 / (R * (s + R)) + E / (q * q) * s / R +
                             (E / q * s - s + 2.0 * z) / (2.0 * R * R * R))
                                .imag();
    const double across = -4.0 * ((i + R) / (R * (s + R))).imag();
    z_ = 4.0 * (z * L - R).imag();
    zz = 4.0 * (L - i / R).imag();
    x_ = x * h;
    y_ = y * h;
    xz = x * across;
    yz = y * across;
    xx = h + 2.0 * x * x * dh;
    xy = 2.0 * x * y * dh;
  }
};

bool below(const Vec3& x, crack::UpperOrLowerFace side) {
  return side == crack::UpperOrLowerFace::lower ||
         (side == crack::UpperOrLowerFace::none && x.z() < 0.0);
}

// The edge of the disc itself: nothing moves by the singular part there.
bool on_edge(const Vec3& x) {
  return std::abs(x.head<2>().norm() - 1.0) < 1e-6 && std::abs(x.z()) < 1e-6;
}

Vec3 off_edge(const Vec3& x) {
  return on_edge(x) ? Vec3(x * (1.0 + 1e-12)) : x;
}

} // namespace

// Kassir and Sih (1975): 2 mu u = (1 - 2 nu) grad phi along the plane + z grad phi,z, and across it
// -2 (1 - nu) phi,z + z phi,zz.
Vec3 pressed_penny(const Vec3& at, crack::UpperOrLowerFace side, double mu, double nu) {
  const Vec3 x = off_edge(at);
  const double z = std::abs(x.z());
  const Penny p(x.x(), x.y(), z);
  const double scale = 1.0 / (4.0 * pi * mu);
  const double up = -2.0 * (1.0 - nu) * p.z_ + z * p.zz;
  return scale * Vec3((1.0 - 2.0 * nu) * p.x_ + z * p.xz, (1.0 - 2.0 * nu) * p.y_ + z * p.yz,
                      below(x, side) ? -up : up);
}

Vec3 sheared_penny(const Vec3& at, crack::UpperOrLowerFace side, double mu, double nu) {
  const Vec3 x = off_edge(at);
  const double z = std::abs(x.z());
  const Penny p(x.x(), x.y(), z);
  const double scale = 1.0 / (2.0 * pi * mu * (2.0 - nu));
  Vec3 u = scale *
           Vec3(-2.0 * (1.0 - nu) * p.z_ + z * p.xx, z * p.xy, -(1.0 - 2.0 * nu) * p.x_ + z * p.xz);
  if (below(x, side)) { // along the plane it is odd, across it even
    u.head<2>() *= -1.0;
  }
  u.x() += x.z() / mu; // the remote shear
  return u;
}

} // namespace spricka::test
