// SPDX-License-Identifier: GPL-3.0-or-later
// Cracks in random places of many hosts: each is cut soundly or refused with the place.
#include "solid_cracks.hpp"
#include "surface_hosts.hpp"
#include "tests/places.hpp"

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
using test::axes;
using test::ellipse;
using test::faces_on_skin;
using test::flat_area;
using test::straight;

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

void expect_sound(const HostMesh& host, const mesh::CrackedMesh& cracked, bool shifted) {
  const model::Mesh& mesh = cracked.mesh;
  EXPECT_TRUE(mesh::find_mesh_faults(mesh).bad.empty());
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
  EXPECT_TRUE(cracked.unreplaced_set_nodes[0].empty());
  const double held = flat_area(host.mesh, faces_on_skin(host.mesh, host.mesh.node_sets[0].nodes));
  EXPECT_NEAR(flat_area(mesh, faces_on_skin(mesh, mesh.node_sets[0].nodes)), held,
              (shifted       ? 0.1
               : host.curved ? 1e-2
                             : 1e-9) *
                  held);
  for (const mesh::CrackFaceNodes& faces : cracked.faces) {
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

} // namespace
} // namespace spricka::test_solid_random
