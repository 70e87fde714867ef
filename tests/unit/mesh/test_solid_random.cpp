// SPDX-License-Identifier: GPL-3.0-or-later
// Cracks in random places of many hosts: each is cut soundly or refused with the place.
#include "mesh/boundary.hpp"
#include "mesh/quality.hpp"
#include "mesh/tube/insert_solid.hpp"
#include "shape/quadrature.hpp"
#include "shape/solid.hpp"
#include "surface_hosts.hpp"
#include "tests/places.hpp"

#include "tests/unit/mesh/meshes.hpp"
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <random>
#include <set>

namespace spricka::test_solid_random {
namespace {

using base::ElementId;
using base::ElementType;
using base::NodeId;
using base::Vec3;

constexpr double pi = std::numbers::pi;

/// A body and what cracks are measured by.
struct HostMesh {
  std::string name;
  model::Mesh mesh;
  double scale = 1.0;   ///< of its smallest ligament
  bool curved = false;  ///< its surface: then new facets are others
  double bore = 0.0;    ///< radius of a bore about z, 0: none
  double height = 8.0;  ///< in z, from 0
  double reentrant = 0; ///< 1: an L, its inner edge along z through the origin
};

void add_sets(model::Mesh& mesh) {
  mesh.face_sets.push_back({"SKIN", mesh::boundary_faces(mesh), {}});
  // Parts of smooth faces, by faces and, others, by nodes.
  model::FaceSet part{"PART", {}, {}};
  model::NodeSet nodes{"NODES", {}, {}};
  const auto chosen = [&](const Vec3& x) { return x.x() > 0.3 && x.z() < 5.1; };
  for (const model::Face& face : mesh.face_sets.back().faces) {
    const mesh::FaceNodes of = mesh::face_nodes(mesh, face);
    if (std::ranges::all_of(of.all, [&](NodeId n) { return chosen(mesh.x[n.index()]); })) {
      part.faces.push_back(face);
    }
  }
  std::vector<model::Face> other; // no face set has these
  for (const model::Face& face : mesh.face_sets.back().faces) {
    const mesh::FaceNodes of = mesh::face_nodes(mesh, face);
    if (std::ranges::all_of(of.all, [&](NodeId n) {
          return mesh.x[n.index()].x() < 0.6 && mesh.x[n.index()].z() > 0.4;
        })) {
      other.push_back(face);
    }
  }
  nodes.nodes = mesh::nodes_of_faces(mesh, other);
  mesh.face_sets.push_back(std::move(part));
  mesh.node_sets.push_back(std::move(nodes));
}

/// x and y from -4 to 4, z from 0 to 8.
HostMesh box(ElementType type, int n) {
  HostMesh host{"box", test::box_host(type, Vec3::Constant(8.0), n), 4.0};
  for (Vec3& x : host.mesh.x) {
    x -= Vec3(4, 4, 0);
  }
  return host;
}

HostMesh plate(ElementType type, int around) {
  const test::HolePlate plate{1.0, 4.0, 2.0, around, around / 4, 2};
  return {"bore", test::hole_plate(type, plate), 2.0, true, 1.0, 2.0};
}

/// A box without the quarter x, y > 0.
HostMesh corner(ElementType type, int n) {
  HostMesh host = box(type, n);
  host.name = "L";
  host.reentrant = 1;
  model::Mesh kept;
  kept.dim = 3;
  kept.x = host.mesh.x;
  kept.node_label = host.mesh.node_label;
  kept.node_net = host.mesh.node_net;
  for (std::size_t e = 0; e < host.mesh.element_count(); ++e) {
    Vec3 low = Vec3::Constant(1e9);
    for (const NodeId node : host.mesh.element_nodes(ElementId(e))) {
      low = low.cwiseMin(host.mesh.x[node.index()]);
    }
    if (low.x() < -1e-9 || low.y() < -1e-9) {
      model::add_element(kept, host.mesh.type[e], host.mesh.element_nodes(ElementId(e)),
                         host.mesh.element_label[e], base::NetId(0));
    }
  }
  host.mesh = std::move(kept);
  return host;
}

std::vector<HostMesh> hosts() {
  std::vector<HostMesh> all;
  all.push_back(box(ElementType::tet10, 4));
  all.push_back(box(ElementType::hexec20, 8));
  all.push_back(plate(ElementType::hexec20, 16));
  all.push_back(corner(ElementType::tet10, 4));
  all.push_back(box(ElementType::hexe8, 7));
  all.push_back(plate(ElementType::tet10, 16));
  all.push_back(box(ElementType::tet4, 9));
  all.push_back(corner(ElementType::hexec20, 8));
  all.push_back(plate(ElementType::hexec20, 32));
  for (HostMesh& host : all) {
    add_sets(host.mesh);
  }
  return all;
}

class Dice {
public:
  explicit Dice(unsigned seed) : random_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * std::generate_canonical<double, 53>(random_);
  }
  double logarithmic(double low, double high) {
    return std::exp(uniform(std::log(low), std::log(high)));
  }
  Eigen::Matrix3d turn(double most) {
    const Vec3 axis(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
    return Eigen::AngleAxisd(uniform(-most, most), axis.normalized()).toRotationMatrix();
  }

private:
  std::mt19937 random_;
};

mesh::SolidCrack ellipse(const Vec3& centre, const Eigen::Matrix3d& turn, double c, double a) {
  constexpr int points = 160;
  mesh::SolidCrack crack;
  crack.crack = base::CrackId(std::size_t{0});
  crack.net = base::NetId(std::size_t{0});
  crack.normal = turn.col(2);
  for (int i = 0; i < points; ++i) {
    const double t = -2.0 * pi * i / points;
    crack.front.emplace_back(centre + c * std::cos(t) * turn.col(0) +
                             a * std::sin(t) * turn.col(1));
  }
  return crack;
}

mesh::SolidCrack straight(const Vec3& from, const Vec3& to, const Vec3& normal) {
  mesh::SolidCrack crack = ellipse(from, Eigen::Matrix3d::Identity(), 1.0, 1.0);
  crack.normal = normal;
  crack.closed = false;
  crack.front.clear();
  for (int i = 0; i <= 20; ++i) {
    crack.front.emplace_back(from + i / 20.0 * (to - from));
  }
  return crack;
}

Eigen::Matrix3d axes(const Vec3& first, const Vec3& second) {
  Eigen::Matrix3d turn;
  turn << first, second, first.cross(second);
  return turn;
}

struct Case {
  std::string kind;
  std::vector<mesh::SolidCrack> cracks;
};

using Maker = Case (*)(const HostMesh&, Dice&);

/// Half axes: of the ligament at the crack, and as slender as a fifth.
std::pair<double, double> half_axes(const HostMesh& host, Dice& dice) {
  const double large = host.scale * dice.logarithmic(0.01, 0.9);
  const double small = large * dice.uniform(0.2, 1.0);
  return {large, small};
}

Case embedded(const HostMesh& host, Dice& dice) {
  const Eigen::Matrix3d turn = dice.turn(3.0);
  const double c = 0.5 * host.scale * dice.logarithmic(0.01, 0.9);
  const double a = c * dice.uniform(0.2, 1.0);
  const double room = 0.5 * host.scale - 1.1 * c; // of the place
  const Vec3 middle = host.bore > 0.0 ? Vec3(-2.5, 0.5, 1.0) : Vec3(-2, -2, 4);
  return {"embedded", {ellipse(middle + room * dice.uniform(-1, 1) * turn.col(0), turn, c, a)}};
}

/// On the face y = -4.
Case surface(const HostMesh& host, Dice& dice) {
  const auto [c, a] = half_axes(host, dice);
  const double z = 0.5 * host.height;
  const bool along = host.height < 4.0 || dice.uniform(0, 1) < 0.5;
  const Vec3 first = along ? Vec3::UnitX() : Vec3::UnitZ();
  const Eigen::Matrix3d lean = Eigen::AngleAxisd(dice.uniform(-0.6, 0.6), first).toRotationMatrix();
  const double wide = std::min(c, 0.4 * host.height * (along ? 10 : 1));
  return {"surface",
          {ellipse({dice.uniform(-0.3, 0.3), -4.0 + dice.uniform(-0.3, 0.3) * a, z},
                   lean * axes(first, Vec3::UnitY()), wide, std::min(a, 3.0))}};
}

/// At the edge x = y = -4.
Case at_edge(const HostMesh& host, Dice& dice) {
  const auto [c, a] = half_axes(host, dice);
  const bool swap = dice.uniform(0, 1) < 0.5;
  const Eigen::Matrix3d flat = axes(Vec3::UnitX(), Vec3::UnitY());
  return {"corner",
          {ellipse({-4, -4, host.height * dice.uniform(0.4, 0.6)}, dice.turn(0.35) * flat,
                   swap ? c : a, swap ? a : c)}};
}

/// Straight through, from the face y = -4 to the next face or to the bore's side.
Case through(const HostMesh& host, Dice& dice) {
  const double depth = host.scale * dice.logarithmic(0.02, 0.9);
  const double lean = dice.uniform(-0.4, 0.4);
  const double skew = dice.uniform(-0.3, 0.3) * depth;
  if (host.bore > 0.0) { // all through the plate, from its side
    const double x = dice.uniform(-2, 2);
    const Vec3 normal = Vec3(std::cos(lean), std::sin(lean), 0);
    const Vec3 along(-std::sin(lean), std::cos(lean), 0);
    const Vec3 tip = Vec3(x, -4, 0) + depth * along;
    return {"through", {straight(tip + Vec3(0, 0, 2), tip + skew * along, normal)}};
  }
  const Vec3 normal = Vec3(0, std::sin(lean), std::cos(lean));
  const double z = 4.0 + dice.uniform(-1, 1);
  const auto at = [&](double x, double y) { return Vec3(x, y, z - (y + 4) * std::tan(lean)); };
  return {"through", {straight(at(-4, -4 + depth), at(4, -4 + depth + skew), normal)}};
}

/// At the bore or at the inner edge of the L, between faces; else a second surface crack.
Case special(const HostMesh& host, Dice& dice) {
  auto [c, a] = half_axes(host, dice);
  if (host.bore > 0.0) {
    const double angle = dice.uniform(-pi, pi);
    const Vec3 out(std::cos(angle), std::sin(angle), 0);
    const bool in_corner = dice.uniform(0, 1) < 0.5;
    const Vec3 place = out + Vec3(0, 0, in_corner ? 2.0 : dice.uniform(0.9, 1.1));
    const double most = in_corner ? 1.8 : 0.8;
    const double lean = dice.uniform(-0.35, 0.35);
    const Vec3 up = Eigen::AngleAxisd(lean, out).toRotationMatrix() * Vec3::UnitZ();
    return {in_corner ? "bore corner" : "bore surface",
            {ellipse(place, axes(out, up), std::min(c, 1.8), std::min(a, most))}};
  }
  if (host.reentrant > 0) {
    const Eigen::Matrix3d flat = axes(Vec3::UnitX(), Vec3::UnitY());
    return {"inner edge",
            {ellipse({0, 0, 4.0 + dice.uniform(-1, 1)}, dice.turn(0.35) * flat, std::min(c, 3.0),
                     std::min(a, 3.0))}};
  }
  c = std::min(c, 1.2);
  a = std::min(a, 1.2);
  Case made{"two",
            {ellipse({-1.4, -4, 4}, dice.turn(0.3) * axes(Vec3::UnitX(), Vec3::UnitY()), c, a),
             ellipse({1.4, -4, 4.0 + dice.uniform(-1, 1)},
                     dice.turn(0.3) * axes(Vec3::UnitX(), Vec3::UnitY()), a, c)}};
  made.cracks[1].crack = base::CrackId(std::size_t{1});
  return made;
}

/// Across the edge x = y = -4 with its centre beside it: both faces, one front.
Case across_edge(const HostMesh& host, Dice& dice) {
  const auto [c, a] = half_axes(host, dice);
  const double off = 0.6 * std::min(c, a);
  return {"off corner",
          {ellipse({-4 + dice.uniform(-0.6, 1.0) * off, -4 + dice.uniform(-0.6, 1.0) * off,
                    0.5 * host.height},
                   dice.turn(0.35) * axes(Vec3::UnitX(), Vec3::UnitY()), std::min(c, 3.0),
                   std::min(a, 3.0))}};
}

double flat_area(const model::Mesh& mesh, const std::vector<model::Face>& sides) {
  double sum = 0.0;
  for (const model::Face& side : sides) {
    const mesh::FaceNodes nodes = mesh::face_nodes(mesh, side);
    Vec3 twice = Vec3::Zero();
    for (std::size_t i = 2; i < nodes.corners; ++i) {
      const Vec3& a = mesh.x[nodes.all[0].index()];
      twice += (mesh.x[nodes.all[i - 1].index()] - a).cross(mesh.x[nodes.all[i].index()] - a);
    }
    sum += 0.5 * twice.norm();
  }
  return sum;
}

double crack_area(const model::Mesh& mesh, const std::vector<model::Face>& sides) {
  double sum = 0.0;
  for (const model::Face& side : sides) {
    const mesh::FaceNodes nodes = mesh::face_nodes(mesh, side);
    std::vector<Vec3> rim;
    for (std::size_t i = 0; i < nodes.corners; ++i) {
      rim.push_back(mesh.x[nodes.all[i].index()]);
      rim.push_back(mesh.x[nodes.mid_node(i).index()]);
    }
    Vec3 twice = Vec3::Zero();
    for (std::size_t i = 2; i < rim.size(); ++i) {
      twice += (rim[i - 1] - rim[0]).cross(rim[i] - rim[0]);
    }
    sum += 0.5 * twice.norm();
  }
  return sum;
}

/// Faces of the body's surface whose nodes a set has.
std::vector<model::Face> on_skin(const model::Mesh& mesh, const std::vector<NodeId>& nodes) {
  const auto at = std::ranges::find(mesh.face_sets, "SKIN", &model::FaceSet::name);
  const std::set<model::Face> skin(at->faces.begin(), at->faces.end());
  std::vector<model::Face> faces = mesh::faces_within(mesh, nodes);
  std::erase_if(faces, [&](const model::Face& face) { return !skin.contains(face); });
  return faces;
}

void expect_sound(const HostMesh& host, const mesh::CrackedMesh& cracked, bool shifted) {
  const model::Mesh& mesh = cracked.mesh;
  EXPECT_TRUE(mesh::mesh_faults(mesh).bad.empty());
  const double v = test::area(host.mesh);
  EXPECT_NEAR(test::area(mesh), v, (host.curved ? 2e-3 : 1e-5) * v);
  for (std::size_t s = 0; s < host.mesh.face_sets.size(); ++s) {
    const double area = flat_area(host.mesh, host.mesh.face_sets[s].faces);
    EXPECT_NEAR(flat_area(mesh, mesh.face_sets[s].faces), area,
                (shifted       ? 0.1
                 : host.curved ? 1e-2
                               : 1e-9) *
                    area)
        << host.mesh.face_sets[s].name;
  }
  // The same by nodes.
  EXPECT_TRUE(cracked.removed_nodes[0].empty());
  const double held = flat_area(host.mesh, on_skin(host.mesh, host.mesh.node_sets[0].nodes));
  EXPECT_NEAR(flat_area(mesh, on_skin(mesh, mesh.node_sets[0].nodes)), held,
              (shifted       ? 0.1
               : host.curved ? 1e-2
                             : 1e-9) *
                  held);
  for (const mesh::CrackFaces& faces : cracked.faces) {
    const double upper = crack_area(mesh, faces.left_sides);
    EXPECT_GT(upper, 0.0);
    EXPECT_NEAR(crack_area(mesh, faces.right_sides), upper, 1e-9 * upper);
    for (std::size_t i = 0; i < faces.left.size(); ++i) {
      EXPECT_EQ(mesh.x[faces.left[i].index()], mesh.x[faces.right[i].index()]);
    }
  }
  for (const mesh::HangingNodeTie& tie : cracked.ties) {
    Vec3 x = Vec3::Zero();
    for (std::size_t i = 0; i < tie.master.size(); ++i) {
      x += tie.weight[i] * mesh.x[tie.master[i].index()];
    }
    EXPECT_NEAR((x - mesh.x[tie.slave.index()]).norm(), 0.0, 1e-12);
  }
}

struct Count {
  int tried = 0, refused = 0, moved = 0;
};

TEST(SolidRandom, CracksAreCutSoundlyOrRefusedWithThePlace) {
  const bool full = test::full_size();
  const int tries = full ? 300 : 12;
  const std::vector<HostMesh> all = hosts();
  const std::vector<Maker> makers{embedded, surface, at_edge, through, special, across_edge};
  std::map<std::string, Count> counts;
  int free = 0;
  for (int i = 0; i < tries; ++i) {
    Dice dice(static_cast<unsigned>(1000 + i));
    const HostMesh& host = all[static_cast<std::size_t>(i * 7 + i / 9) % all.size()];
    const Case made = makers[static_cast<std::size_t>(i) % makers.size()](host, dice);
    const std::string name = std::to_string(i) + " " + made.kind + " in " + host.name + " of " +
                             std::string(base::element_info(host.mesh.type[0]).name);
    SCOPED_TRACE(name);
    base::Diagnostics diagnostics;
    const auto cracked = mesh::insert_solid_cracks(
        host.mesh, made.cracks, std::vector<mesh::TubeMeshParameters>(made.cracks.size()),
        std::vector<base::SourceSpan>(made.cracks.size()), diagnostics);
    Count& count = counts[made.kind];
    ++count.tried;
    if (cracked) {
      const bool shifted = std::ranges::any_of(diagnostics.messages(),
                                               [](const auto& d) { return d.code == "W425"; });
      free += std::ranges::any_of(diagnostics.messages(),
                                  [](const auto& d) { return d.code == "W423"; })
                  ? 1
                  : 0;
      count.moved += shifted ? 1 : 0;
      expect_sound(host, *cracked, shifted);
      continue;
    }
    ++count.refused;
    ASSERT_FALSE(diagnostics.messages().empty());
    for (const auto& d : diagnostics.messages()) {
      GTEST_LOG_(INFO) << name << ": " << d.code << " " << d.text;
      EXPECT_NE(d.text.find('('), std::string::npos) << d.text; // the place
    }
  }
  int refused = 0;
  for (const auto& [kind, count] : counts) {
    refused += count.refused;
    GTEST_LOG_(INFO) << kind << ": " << count.refused << " of " << count.tried << " refused, "
                     << count.moved << " with borders of sets moved";
  }
  GTEST_LOG_(INFO) << free << " without a tube";
  EXPECT_LE(refused, std::max(1, tries / 20));
}

/// What a node set has of the face y = -4 of a box, held or loaded: z above a line of nodes.
model::Mesh with_upper_part(double from) {
  model::Mesh mesh = box(ElementType::hexec20, 8).mesh;
  mesh.face_sets.clear();
  mesh.face_sets.push_back({"SKIN", mesh::boundary_faces(mesh), {}});
  model::NodeSet part{"PART", {}, {}};
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    if (mesh.x[n].y() < -4.0 + 1e-9 && mesh.x[n].z() > from - 1e-9) {
      part.nodes.emplace_back(n);
    }
  }
  mesh.node_sets.push_back(std::move(part));
  return mesh;
}

// The crack, half an ellipse at z = 3.7, takes away the surface round it; the border of the set at
// z = 5 lies within, that at z = 4 goes through the ends of its tube.
TEST(SolidSets, NodeSetsOfAPartOfAFaceKeepTheirBorders) {
  const mesh::SolidCrack crack =
      ellipse({0.1, -4, 3.7}, axes(Vec3::UnitX(), Vec3::UnitY()), 1.2, 0.9);
  for (const double border : {5.0, 4.0, 3.0}) {
    const model::Mesh host = with_upper_part(border);
    base::Diagnostics diagnostics;
    const auto cracked = mesh::insert_solid_cracks(host, std::vector{crack},
                                                   std::vector<mesh::TubeMeshParameters>(1),
                                                   std::vector<base::SourceSpan>(1), diagnostics);
    ASSERT_TRUE(cracked);
    EXPECT_TRUE(diagnostics.messages().empty());
    const model::Mesh& mesh = cracked->mesh;
    double lowest = 8.0;
    for (const NodeId n : mesh.node_sets[0].nodes) {
      lowest = std::min(lowest, mesh.x[n.index()].z());
    }
    EXPECT_DOUBLE_EQ(lowest, border);
    EXPECT_NEAR(flat_area(mesh, on_skin(mesh, mesh.node_sets[0].nodes)), 8.0 * (8.0 - border),
                1e-9);
  }
}

/// Nodes that an element has, on the segment from a to b of a straight line.
std::set<NodeId> on_line(const model::Mesh& mesh, const Vec3& a, const Vec3& b) {
  std::set<NodeId> found;
  for (const NodeId n : mesh.nodes) {
    const Vec3& x = mesh.x[n.index()];
    const Vec3 d = (b - a).normalized();
    const double s = d.dot(x - a);
    if ((x - a - s * d).norm() < 1e-9 && s > -1e-9 && s < (b - a).norm() + 1e-9) {
      found.insert(n);
    }
  }
  return found;
}

// Nodes are held along a sharp edge, a part of it, a line on a smooth face; the crack, half an
// ellipse at z = 3.7 of the face y = -4 or a corner at x = -4, takes their elements, and its mouth
// runs across the lines.
TEST(SolidSets, NodesHeldAlongEdgesAreHeldAlongNewOnes) {
  const Vec3 corner(-4, -4, 3.7);
  const mesh::SolidCrack at_corner = ellipse(corner, axes(Vec3::UnitX(), Vec3::UnitY()), 1.2, 0.9);
  const mesh::SolidCrack at_face =
      ellipse({0.1, -4, 3.7}, axes(Vec3::UnitX(), Vec3::UnitY()), 1.2, 0.9);
  struct Line {
    const mesh::SolidCrack* crack;
    Vec3 from, to;
  };
  const std::vector<Line> lines{
      {&at_corner, {-4, -4, 0}, {-4, -4, 8}}, {&at_corner, {-4, -4, 3}, {-4, -4, 5}},
      {&at_corner, {-4, -4, 4}, {-4, -4, 8}}, {&at_face, {0, -4, 0}, {0, -4, 8}},
      {&at_face, {-4, -4, 5}, {4, -4, 5}},    {&at_face, {0, -4, 4}, {0, -4, 6}},
      {&at_face, {0, -4, 3}, {0, -4, 5}}};
  for (const ElementType type : {ElementType::hexec20, ElementType::tet10, ElementType::hexe8}) {
    for (const Line& line : lines) {
      model::Mesh host = box(type, 8).mesh;
      host.node_sets.clear();
      const std::set<NodeId> before = on_line(host, line.from, line.to);
      host.node_sets.push_back({"LINE", {before.begin(), before.end()}, {}});
      mesh::SetUsage use;
      use.held.emplace_back(std::size_t{0});
      base::Diagnostics diagnostics;
      const auto cracked = mesh::insert_solid_cracks(
          mesh::SolidHost(host, use), std::vector{*line.crack},
          std::vector<mesh::TubeMeshParameters>(1), std::vector<base::SourceSpan>(1), diagnostics);
      ASSERT_TRUE(cracked);
      EXPECT_TRUE(diagnostics.messages().empty());
      EXPECT_TRUE(cracked->removed_nodes[0].empty())
          << base::element_info(type).name << line.from.transpose();
      const std::vector<NodeId>& now = cracked->mesh.node_sets[0].nodes;
      std::set<NodeId> there = on_line(cracked->mesh, line.from, line.to);
      for (const mesh::HangingNodeTie& tie : cracked->ties) { // between linear elements' nodes
        there.erase(tie.slave);
      }
      EXPECT_EQ(std::set<NodeId>(now.begin(), now.end()), there)
          << base::element_info(type).name << " " << line.from.transpose();
    }
  }
}

// Three nodes hold a body: those at its corners and on its edges stay, whatever is meshed anew.
TEST(SolidSets, SingleNodesHeldOnEdgesStay) {
  model::Mesh host = box(ElementType::tet10, 4).mesh;
  host.node_sets.clear();
  mesh::SetUsage use;
  for (const Vec3& x : {Vec3(-4, -4, 0), Vec3(-4, -4, 2), Vec3(-2, -4, 0)}) {
    const std::set<NodeId> found = on_line(host, x, x + 1e-3 * Vec3::UnitX());
    ASSERT_EQ(found.size(), 1U);
    use.held.emplace_back(host.node_sets.size());
    host.node_sets.push_back({"", {found.begin(), found.end()}, {}});
  }
  const mesh::SolidCrack crack =
      ellipse({-4, -4, 1.1}, axes(Vec3::UnitX(), Vec3::UnitY()), 0.9, 0.8);
  base::Diagnostics diagnostics;
  const auto cracked = mesh::insert_solid_cracks(mesh::SolidHost(host, use), std::vector{crack},
                                                 std::vector<mesh::TubeMeshParameters>(1),
                                                 std::vector<base::SourceSpan>(1), diagnostics);
  ASSERT_TRUE(cracked);
  const std::vector<bool> used = model::nodes_in_use(cracked->mesh);
  for (std::size_t s = 0; s < 3; ++s) {
    EXPECT_TRUE(cracked->removed_nodes[s].empty()) << s;
    EXPECT_EQ(cracked->mesh.node_sets[s].nodes, host.node_sets[s].nodes) << s;
    EXPECT_TRUE(used[host.node_sets[s].nodes.front().index()]) << s;
  }
}

TEST(SolidSets, ABorderThroughTheEndOfATubeIsTold) {
  const mesh::SolidCrack crack =
      ellipse({0.1, -4, 4.03}, axes(Vec3::UnitX(), Vec3::UnitY()), 1.2, 0.9);
  const model::Mesh host = with_upper_part(4.0);
  base::Diagnostics diagnostics;
  const auto cracked =
      mesh::insert_solid_cracks(host, std::vector{crack}, std::vector<mesh::TubeMeshParameters>(1),
                                std::vector<base::SourceSpan>(1), diagnostics);
  ASSERT_TRUE(cracked);
  ASSERT_EQ(diagnostics.messages().size(), 1U);
  EXPECT_EQ(diagnostics.messages()[0].code, "W425");
  EXPECT_NE(diagnostics.messages()[0].text.find("PART"), std::string::npos);
  // Moved, but no further than an element's length, some 0.3.
  const double area =
      flat_area(cracked->mesh, on_skin(cracked->mesh, cracked->mesh.node_sets[0].nodes));
  EXPECT_NEAR(area, 32.0, 0.5);
  // A group that nothing uses may move unsaid; the skin goes all round and has no border.
  mesh::SetUsage use;
  use.nodes = {false};
  use.faces = {true};
  base::Diagnostics quiet;
  EXPECT_TRUE(mesh::insert_solid_cracks(mesh::SolidHost(host, use), std::vector{crack},
                                        std::vector<mesh::TubeMeshParameters>(1),
                                        std::vector<base::SourceSpan>(1), quiet));
  EXPECT_TRUE(quiet.messages().empty());
}

} // namespace
} // namespace spricka::test_solid_random
