// SPDX-License-Identifier: GPL-3.0-or-later
#include "distorted.hpp"
#include "mesh/boundary.hpp"
#include "meshes.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

// A deck for each element type: a distorted block whose rim follows a linear displacement field, as
// a patch test wants it, and its volume by our own shapes. Usage: write_blocks FOLDER.
namespace spricka {
namespace {

std::string deck_of(const model::Mesh& mesh) {
  const base::ElementInfo& info = base::element_info(mesh.type[0]);
  const bool solid = info.dim == 3;
  std::string text;
  const auto put = [&](auto form, const auto&... values) {
    fmt::format_to(std::back_inserter(text), fmt::runtime(form), values...);
  };
  put("$DECK VERSION=1 LENGTH=mm FORCE=N TITLE='{} block'\n$COOR DIM={}\n", info.name, info.dim);
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    put(" {} {} {}", mesh.node_label[n], mesh.x[n].x(), mesh.x[n].y());
    put(solid ? " {}\n" : "\n", mesh.x[n].z());
  }
  put("$ELEMENT TYPE={} ESET=BODY\n", info.name);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    put(" {}", mesh.element_label[e]);
    for (const base::NodeId n : mesh.element_nodes(base::ElementId(e))) {
      put(" {}", mesh.node_label[n.index()]);
    }
    put("\n");
  }
  put("$NSET NAME=RIM\n");
  for (const base::NodeId n : mesh::nodes_of_faces(mesh, mesh::boundary_faces(mesh))) {
    put(" {}\n", mesh.node_label[n.index()]);
  }
  put("$FSET NAME=SKIN FROM=RIM\n$MATERIAL NAME=STEEL E=210000 NU=0.3\n");
  put("$PROPERTY ESET=BODY MATERIAL=STEEL STATE={} {}\n", solid ? "SOLID" : "STRESS",
      solid ? "" : "THICK=0.4");
  put("$FREEDOM CLASS=PRESCRIBED DOF={}\n RIM\n$LOAD CASE=LINEAR TYPE=DISP\n",
      solid ? "XYZ" : "XY");
  put(" RIM (1e-3*(x+0.4*y{})) (1e-3*(0.2*x-0.5*y{})) {}\n", solid ? "-0.3*z" : "",
      solid ? "+0.6*z" : "", solid ? "(1e-3*(0.1*x+0.7*y+0.8*z))" : "");
  put("$STEP NAME=PULL\n LOAD LINEAR 1\n$END\n");
  return text;
}

} // namespace
} // namespace spricka

int main(int argc, char** argv) {
  if (argc != 2) {
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  std::ofstream volumes(folder / "volumes.txt");
  for (const spricka::base::ElementType type : spricka::test::all_types) {
    const auto mesh = spricka::test::distorted_block(type);
    const std::string name(spricka::base::element_info(type).name);
    std::ofstream(folder / (name + ".deck")) << spricka::deck_of(mesh);
    volumes << fmt::format("{} {} {}\n", name, spricka::base::element_info(type).dim,
                           spricka::test::area(mesh));
  }
  return volumes ? 0 : 1;
}
