// SPDX-License-Identifier: GPL-3.0-or-later
#include "distorted.hpp"
#include "mesh/boundary.hpp"
#include "mesh/export/write_msh.hpp"
#include "mesh/import/gmsh_import.hpp"
#include "mesh/quality.hpp"
#include "mesher/gmsh_session.hpp"
#include "meshes.hpp"

#include <fmt/format.h>
#include <gmsh.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <random>
#include <set>

namespace spricka::test_msh_files {
namespace {

namespace fs = std::filesystem;

constexpr int k_runs = 4;

/// The volume (in the plane: the area) by gmsh's own shape functions.
double gmsh_volume(int dim) {
  std::vector<int> types;
  gmsh::model::mesh::getElementTypes(types, dim);
  double sum = 0.0;
  for (const int type : types) {
    std::vector<double> local;
    std::vector<double> weights;
    gmsh::model::mesh::getIntegrationPoints(type, "Gauss6", local, weights);
    std::vector<double> jacobians;
    std::vector<double> determinants;
    std::vector<double> points;
    gmsh::model::mesh::getJacobians(type, local, jacobians, determinants, points);
    for (std::size_t i = 0; i < determinants.size(); ++i) {
      sum += weights[i % weights.size()] * determinants[i];
    }
  }
  return sum;
}

class MshFiles : public testing::TestWithParam<base::ElementType> {
protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("spricka-msh-" + std::to_string(::getpid()) + "-" +
                                           std::string(base::element_info(GetParam()).name));
    fs::create_directories(folder_);
    mesh_ = test::distorted_block(GetParam());
    std::ofstream(folder_ / "own.msh") << mesh::write_msh(mesh_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] mesh::ImportRequest request(const std::string& name) const {
    mesh::ImportRequest request;
    request.file = folder_ / name;
    request.format = mesh::ImportFormat::msh;
    request.net = base::NetId(std::size_t{0});
    return request;
  }

  /// Same elements, nodes in the same places within `tolerance`, same sets.
  void expect_same(const std::string& name, double tolerance) {
    model::Mesh found;
    base::Diagnostics diagnostics;
    mesh::import_gmsh_mesh_or_script(found, request(name), diagnostics);
    ASSERT_TRUE(diagnostics.messages().empty()) << diagnostics.messages()[0].text;
    ASSERT_EQ(found.element_count(), mesh_.element_count());
    ASSERT_EQ(found.node_count(), mesh_.node_count());
    EXPECT_NEAR(test::area(found), test::area(mesh_), 1e-14);
    std::vector<base::ElementId> twin; // [element of mesh_], gmsh renumbers
    for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
      twin.push_back(twin_of(found, base::ElementId(e), tolerance));
      ASSERT_TRUE(twin.back().valid()) << e;
    }
    for (const model::ElementSet& set : mesh_.element_sets) {
      const auto at = std::find_if(found.element_sets.begin(), found.element_sets.end(),
                                   [&](const auto& s) { return s.name == set.name; });
      ASSERT_NE(at, found.element_sets.end()) << set.name;
      std::vector<base::ElementId> wanted;
      for (const base::ElementId e : set.elements) {
        wanted.push_back(twin[e.index()]);
      }
      std::sort(wanted.begin(), wanted.end());
      EXPECT_EQ(at->elements, wanted) << set.name;
    }
    for (const model::FaceSet& set : mesh_.face_sets) {
      std::vector<model::Face> faces = test::faces(found, set.name).faces;
      std::vector<model::Face> wanted;
      for (const model::Face& face : set.faces) {
        wanted.push_back({twin[face.element.index()], face.side});
      }
      std::sort(faces.begin(), faces.end());
      std::sort(wanted.begin(), wanted.end());
      EXPECT_EQ(faces, wanted) << set.name;
    }
    ASSERT_EQ(found.node_sets.size(), 1U);
    EXPECT_EQ(found.node_sets[0].name, "LINE");
    ASSERT_EQ(found.node_sets[0].nodes.size(), 3U);
    for (const base::NodeId n : mesh_.node_sets[0].nodes) {
      EXPECT_TRUE(std::any_of(found.node_sets[0].nodes.begin(), found.node_sets[0].nodes.end(),
                              [&](base::NodeId m) {
                                return (found.x[m.index()] - mesh_.x[n.index()]).norm() <= 2e-15;
                              }));
    }
  }

  /// The element all of whose nodes, in their order, lie where those of element e do.
  [[nodiscard]] base::ElementId twin_of(const model::Mesh& found, base::ElementId e,
                                        double tolerance) const {
    const auto wanted = mesh_.element_nodes(e);
    for (std::size_t f = 0; f < found.element_count(); ++f) {
      const auto nodes = found.element_nodes(base::ElementId(f));
      if (found.type[f] == mesh_.type[e.index()] &&
          std::equal(nodes.begin(), nodes.end(), wanted.begin(),
                     [&](base::NodeId m, base::NodeId n) {
                       const base::Vec3 off = found.x[m.index()] - mesh_.x[n.index()];
                       return off.cwiseAbs().maxCoeff() <= tolerance;
                     })) {
        return base::ElementId(f);
      }
    }
    return {};
  }

  fs::path folder_;
  model::Mesh mesh_;
};

INSTANTIATE_TEST_SUITE_P(Types, MshFiles, testing::ValuesIn(test::all_types), [](const auto& type) {
  return std::string(base::element_info(type.param).name);
});

TEST_P(MshFiles, OwnFileComesBackBitForBit) {
  EXPECT_TRUE(mesh::find_invalid_elements(mesh_).empty());
  expect_same("own.msh", 0.0);
}

// gmsh reads our file, agrees on the volume, and writes it anew in every form it has.
TEST_P(MshFiles, GmshAgreesAndItsFilesComeBack) {
  for (const double version : {2.2, 4.1}) {
    for (const int binary : {0, 1}) {
      const std::string name = fmt::format("v{}-{}.msh", version, binary);
      {
        const mesher::GmshSession session;
        gmsh::open((folder_ / "own.msh").string());
        EXPECT_TRUE(mesher::GmshSession::errors().empty());
        EXPECT_NEAR(gmsh_volume(mesh_.dim), test::area(mesh_), 1e-12);
        gmsh::option::setNumber("Mesh.MshFileVersion", version);
        gmsh::option::setNumber("Mesh.Binary", binary);
        gmsh::write((folder_ / name).string());
      }
      SCOPED_TRACE(name);
      expect_same(name, binary == 1 ? 0.0 : 1e-15); // gmsh writes 16 digits
    }
  }
}

TEST_P(MshFiles, RaisedToQuadratic) {
  mesh::ImportRequest quadratic = request("own.msh");
  quadratic.quadratic = true;
  quadratic.scale = 2.0;
  model::Mesh found;
  base::Diagnostics diagnostics;
  mesh::import_gmsh_mesh_or_script(found, quadratic, diagnostics);
  ASSERT_FALSE(diagnostics.has_errors());
  EXPECT_TRUE(std::all_of(found.type.begin(), found.type.end(),
                          [](base::ElementType t) { return base::element_info(t).quadratic; }));
  EXPECT_NEAR(test::area(found), test::area(mesh_) * std::pow(2.0, mesh_.dim), 1e-12);
  EXPECT_EQ(test::faces(found, "XMAX").faces.size(), test::faces(mesh_, "XMAX").faces.size());
}

TEST_P(MshFiles, DamagedFilesAreRefusedInWords) {
  std::ifstream in(folder_ / "own.msh");
  const std::string whole{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  const auto refused = [&](const std::string& text, const std::string& words) {
    std::ofstream(folder_ / "bad.msh", std::ios::binary) << text;
    model::Mesh found;
    base::Diagnostics diagnostics;
    mesh::import_gmsh_mesh_or_script(found, request("bad.msh"), diagnostics);
    ASSERT_TRUE(diagnostics.has_errors()) << words;
    EXPECT_NE(diagnostics.messages()[0].text.find(words), std::string::npos)
        << diagnostics.messages()[0].text;
    EXPECT_EQ(found.element_count(), 0U);
  };
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = whole;
    return text.replace(text.find(from), from.size(), to);
  };
  refused("", "empty");
  refused("solid\nfacet\n", "no gmsh mesh");
  refused(with("4.1 0 8", "1.0 0 8"), "version 1");
  refused(with("4.1 0 8", "4.1 0 4"), "4 bytes");
  refused(with("4.1 0 8\n", std::string("4.1 1 8\n\0\0\0\1", 12)), "byte order");
  for (const double part : {0.1, 0.4, 0.8, 0.99}) {
    const auto size = static_cast<std::size_t>(part * static_cast<double>(whole.size()));
    refused(whole.substr(0, size), "truncated");
  }
}

// Bytes changed anywhere: a mesh or words, never a crash.
TEST_P(MshFiles, ChangedBytesDoNoHarm) {
  for (const double version : {2.2, 4.1}) {
    for (const int binary : {0, 1}) {
      {
        const mesher::GmshSession session;
        gmsh::open((folder_ / "own.msh").string());
        gmsh::option::setNumber("Mesh.MshFileVersion", version);
        gmsh::option::setNumber("Mesh.Binary", binary);
        gmsh::write((folder_ / "whole.msh").string());
      }
      std::ifstream in(folder_ / "whole.msh", std::ios::binary);
      const std::string whole{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
      std::minstd_rand random(7);
      for (int run = 0; run < k_runs; ++run) {
        std::string text = whole;
        for (int k = 0; k < 3; ++k) {
          text[random() % text.size()] =
              binary ? static_cast<char>(random() % 256) : "0123456789 .-$\n"[random() % 15];
        }
        std::ofstream(folder_ / "changed.msh", std::ios::binary) << text;
        model::Mesh found;
        base::Diagnostics diagnostics;
        mesh::import_gmsh_mesh_or_script(found, request("changed.msh"), diagnostics);
        EXPECT_TRUE(diagnostics.has_errors() || found.element_count() > 0);
        EXPECT_EQ(found.first.empty() ? 0 : found.first.size() - 1, found.element_count());
      }
    }
  }
}

} // namespace
} // namespace spricka::test_msh_files
