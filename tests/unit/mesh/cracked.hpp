// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/boundary.hpp"
#include "mesh/cut/patch.hpp"
#include "mesh/cut/tip_mesh.hpp"
#include "mesh/generate/generate.hpp"
#include "mesh/quality.hpp"
#include "meshes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <optional>
#include <set>

/// Hosts with cracks, and what must hold for every cracked mesh.
namespace spricka::test {

inline const base::NetId net0 = base::NetId(std::size_t{0});

inline model::Mesh block(double lx, double ly, int nx, int ny,
                         base::ElementType type = base::ElementType::quamc8) {
  model::Mesh mesh;
  mesh::BlockSpec spec;
  spec.type = type;
  spec.size = {lx, ly, 1.0};
  spec.nx = nx;
  spec.ny = ny;
  mesh::generate_block(mesh, net0, "", spec);
  return mesh;
}

inline model::Mesh lug(int nr = 12, int nt = 72) {
  model::Mesh mesh;
  mesh::LugSpec spec;
  spec.ri = 36.0;
  spec.ro = 86.5;
  spec.width = 173.0;
  spec.length = 232.5;
  spec.nr = nr;
  spec.nt = nt;
  mesh::generate_lug(mesh, net0, "", spec);
  return mesh;
}

inline mesh::CrackLine crack(std::vector<base::Vec3> points, std::size_t number = 0) {
  mesh::CrackLine line;
  line.crack = base::CrackId(number);
  line.net = net0;
  line.points = std::move(points);
  return line;
}

inline std::vector<base::NodeId> nodes_where(const model::Mesh& mesh, auto&& predicate,
                                             auto&& order) {
  std::vector<base::NodeId> result;
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    if (predicate(mesh.x[n])) {
      result.emplace_back(n);
    }
  }
  std::sort(result.begin(), result.end(), [&](base::NodeId a, base::NodeId b) {
    return order(mesh.x[a.index()]) < order(mesh.x[b.index()]);
  });
  return result;
}

inline std::optional<mesh::CrackedMesh> insert(const model::Mesh& host,
                                               const std::vector<mesh::CrackLine>& lines,
                                               base::Diagnostics& diagnostics,
                                               const model::TipMeshSettings* wishes = nullptr) {
  std::vector<mesh::TipMeshParameters> tips;
  tips.reserve(lines.size());
  for (const mesh::CrackLine& line : lines) {
    tips.push_back(mesh::choose_tip_mesh(host, line, wishes, lines));
  }
  return mesh::insert_cracks(host, lines, tips, std::vector<base::SourceSpan>(lines.size()),
                             diagnostics);
}

inline mesh::CrackedMesh insert(const model::Mesh& host, const std::vector<mesh::CrackLine>& lines,
                                const model::TipMeshSettings* wishes = nullptr) {
  base::Diagnostics diagnostics;
  auto result = insert(host, lines, diagnostics, wishes);
  for (const base::Diagnostic& d : diagnostics.messages()) {
    ADD_FAILURE() << d.code << ": " << d.text;
  }
  if (!result) {
    throw std::runtime_error("no cracked mesh");
  }
  return std::move(*result);
}

using Ends = std::pair<base::NodeId, base::NodeId>;

/// Each edge lies between two elements that run along it in opposite directions and share its mid
/// node, or on the boundary; the crack faces are on the boundary from end to end.
inline void expect_conforming(const mesh::CrackedMesh& cracked) {
  const model::Mesh& mesh = cracked.mesh;
  std::map<Ends, base::NodeId> mid;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (int s = 0; s < base::element_info(mesh.type[e]).sides; ++s) {
      const auto n = nodes_of(mesh, {base::ElementId(e), s});
      EXPECT_TRUE(mid.try_emplace({n[0], n[1]}, n.size() == 3 ? n[2] : base::NodeId()).second);
    }
  }
  std::set<Ends> crack_faces;
  double expected = 0.0;
  for (const auto& crack_face : cracked.faces) {
    for (const auto* side : {&crack_face.left, &crack_face.right}) {
      for (std::size_t i = 0; i + 1 < side->size(); ++i) {
        for (const std::size_t j : {i + 1, std::min(i + 2, side->size() - 1)}) {
          crack_faces.insert({(*side)[i], (*side)[j]});
          crack_faces.insert({(*side)[j], (*side)[i]});
        }
        expected += (mesh.x[(*side)[i].index()] - mesh.x[(*side)[i + 1].index()]).norm();
      }
    }
  }
  double crack_face_length = 0.0;
  for (const auto& [ends, m] : mid) {
    const auto other = mid.find({ends.second, ends.first});
    if (other != mid.end()) {
      EXPECT_EQ(other->second, m);
    } else if (crack_faces.contains(ends)) {
      crack_face_length += (mesh.x[ends.first.index()] - mesh.x[ends.second.index()]).norm();
    }
  }
  EXPECT_NEAR(crack_face_length, expected, 1e-9 * expected);
}

/// Every node that an element of the result has is in one piece of the body: labels unique, host
/// nodes unmoved unless they are quarter points.
inline void expect_sound(const model::Mesh& host, const mesh::CrackedMesh& cracked) {
  const model::Mesh& mesh = cracked.mesh;
  EXPECT_TRUE(mesh::find_invalid_elements(mesh).empty());
  expect_conforming(cracked);
  ASSERT_EQ(cracked.host.size(), mesh.element_count());
  EXPECT_NEAR(area(mesh), area(host), 1e-12 * area(host));
  const std::set<base::Label> labels(mesh.node_label.begin(), mesh.node_label.end());
  EXPECT_EQ(labels.size(), mesh.node_count());
  const std::set<base::Label> elements(mesh.element_label.begin(), mesh.element_label.end());
  EXPECT_EQ(elements.size(), mesh.element_count());
  ASSERT_EQ(mesh.node_sets.size(), host.node_sets.size());
  ASSERT_EQ(mesh.element_sets.size(), host.element_sets.size());
  ASSERT_EQ(mesh.face_sets.size(), host.face_sets.size());
  const auto boundary = mesh::boundary_faces(mesh);
  for (std::size_t i = 0; i < mesh.face_sets.size(); ++i) {
    EXPECT_EQ(mesh.face_sets[i].name, host.face_sets[i].name);
    for (const model::Face& face : mesh.face_sets[i].faces) {
      EXPECT_TRUE(std::binary_search(boundary.begin(), boundary.end(), face));
    }
  }
  EXPECT_EQ(mesh.element_sets[0].elements.size(), mesh.element_count());
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    if (cracked.host[e].valid()) {
      EXPECT_EQ(mesh.element_label[e], host.element_label[cracked.host[e].index()]);
    }
  }
}

/// Arc length of some faces by Simpson's rule of many points.
inline double curve_length(const model::Mesh& mesh, const std::vector<model::Face>& some) {
  double sum = 0.0;
  for (const model::Face& face : some) {
    const auto n = nodes_of(mesh, face);
    const base::Vec3 a = mesh.x[n[0].index()];
    const base::Vec3 b = mesh.x[n[1].index()];
    const base::Vec3 m = mesh.x[n[2].index()];
    for (const auto& q : shape::line_rule(21)) {
      const Eigen::Vector3d d = shape::Line3::dN(q.r);
      const base::Vec3 tangent = d[0] * a + d[1] * b + d[2] * m;
      sum += q.weight * tangent.norm();
    }
  }
  return sum;
}

/// Crack faces from mouth to tip: same places on both sides, ends of length a, ordered.
inline void expect_crack_faces(const mesh::CrackedMesh& cracked, std::size_t i, double a) {
  const auto& crack_faces = cracked.faces[i];
  const auto& x = cracked.mesh.x;
  ASSERT_EQ(crack_faces.left.size(), crack_faces.right.size());
  EXPECT_EQ(crack_faces.left.back(), crack_faces.right.back());
  EXPECT_EQ(crack_faces.left.back(), cracked.fronts[i].tip_point().node);
  double length = 0.0;
  for (std::size_t k = 0; k < crack_faces.left.size(); ++k) {
    EXPECT_EQ(x[crack_faces.left[k].index()], x[crack_faces.right[k].index()]);
    if (k > 0) {
      EXPECT_NE(crack_faces.left[k - 1], crack_faces.right[k - 1]);
      length += (x[crack_faces.left[k].index()] - x[crack_faces.left[k - 1].index()]).norm();
    }
  }
  EXPECT_NEAR(length, a, 1e-12 * a);
}

/// Mid nodes of all edges that leave the tip are at exactly a quarter.
inline int expect_quarter_points(const mesh::CrackedMesh& cracked, base::NodeId tip) {
  const model::Mesh& mesh = cracked.mesh;
  int count = 0;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (int s = 0; s < base::element_info(mesh.type[e]).sides; ++s) {
      const auto n = nodes_of(mesh, {base::ElementId(e), s});
      if (n[0] == tip || n[1] == tip) {
        const base::Vec3& x = mesh.x[tip.index()];
        const base::Vec3& end = mesh.x[n[n[0] == tip ? 1 : 0].index()];
        const double size = (end - x).norm();
        EXPECT_NEAR((mesh.x[n[2].index()] - (x + 0.25 * (end - x))).norm(), 0.0, 1e-14 * size);
        ++count;
      }
    }
  }
  return count;
}

} // namespace spricka::test
