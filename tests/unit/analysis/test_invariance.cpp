// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/generate/generate.hpp"
#include "shape/topology.hpp"
#include "tests/unit/support/run_text.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::test_invariance {
namespace {

using test::column;
using test::Folder;

// The hub as a gmsh file (MSH 2.2) in mm: surface BODY and curve INNER.
void write_hub(const std::filesystem::path& file) {
  model::Mesh mesh;
  mesh::RingSpec spec;
  spec.ri = 20.0;
  spec.ro = 50.0;
  spec.nr = 8;
  spec.nt = 48;
  mesh::generate_ring(mesh, base::NetId(std::size_t{0}), "", spec);
  std::ofstream out(file);
  out.precision(17);
  out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n1 1 \"INNER\"\n2 2 "
         "\"BODY\"\n$EndPhysicalNames\n$Nodes\n"
      << mesh.node_count() << "\n";
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    out << n + 1 << " " << mesh.x[n].x() << " " << mesh.x[n].y() << " 0\n";
  }
  const auto inner = std::find_if(mesh.face_sets.begin(), mesh.face_sets.end(),
                                  [](const model::FaceSet& s) { return s.name == "INNER"; });
  out << "$EndNodes\n$Elements\n" << mesh.element_count() + inner->faces.size() << "\n";
  std::size_t label = 0;
  for (const model::Face& face : inner->faces) {
    out << ++label << " 8 2 1 1";
    for (const int n : shape::side_nodes(mesh.type[face.element.index()], face.side)) {
      out << " " << mesh.element_nodes(face.element)[static_cast<std::size_t>(n)].index() + 1;
    }
    out << "\n";
  }
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    out << ++label << " 16 2 2 2";
    for (const base::NodeId n : mesh.element_nodes(base::ElementId(e))) {
      out << " " << n.index() + 1;
    }
    out << "\n";
  }
  out << "$EndElements\n";
}

// A cracked ring with a pin pressed in and loaded, with lengths and forces in any units: l and f
// are the sizes of mm and N in those.
std::string ring(const std::string& units, double l, double f) {
  const auto length = [&](double mm) { return std::to_string(mm) + "*l"; };
  std::string deck = "$DECK VERSION=1 " + units + "\n$PARAMETER\n";
  char number[64];
  std::snprintf(number, sizeof number, "  l = %.17g\n  f = %.17g\n", l, f);
  deck += number;
  deck += "$NET NAME=HUB\n  $IMPORT FILE='hub.msh' FORMAT=MSH SCALE=(l)\n$ENDNET\n";
  deck += "$NET NAME=PIN\n  $MESH SHAPE=RING TYPE=QUAMC8 RI=0 RO=(" + length(20) +
          ") NR=6 NT=44\n$ENDNET\n";
  deck += R"($MATERIAL NAME=S E=(210000*f/l^2) NU=0.3
$PROPERTY ESET=HUB.BODY MATERIAL=S STATE=STRESS THICK=(10*l)
$PROPERTY ESET=PIN.BODY MATERIAL=S STATE=STRESS THICK=(10*l)
$NSET NAME=HELD WHERE=(x < -44*l)
$FREEDOM CLASS=SUPPRESSED DOF=XY
  HELD
$CONTACT NAME=FIT SLAVE=PIN.OUTER MASTER=HUB.INNER INTERFERENCE=(0.01*l)
$CRACK NAME=C NET=HUB ANGLE=90[deg] A0=(4*l)
  0 (20*l)
$LOAD CASE=PULL TYPE=RESULTANT
  PIN.BODY (20000*f) 0
$STEP NAME=PRESS
  FIT FIT 1
$STEP NAME=LOAD
  LOAD PULL 1
$GROW LAW=INCREMENT KMAX=LOAD
  (4*l) (7*l)
$END
)";
  return deck;
}

test::Outcome run_ring(const Folder& folder, const std::string& deck, int threads = 1) {
  write_hub(folder.path() / "hub.msh");
  return run_text(folder, deck, threads);
}

std::vector<double> k1(const Folder& folder) {
  return column(folder.path() / "out" / "k.csv", "K1");
}

TEST(Invariance, KDoesNotKnowTheUnits) {
  const Folder mm;
  const Folder metre;
  const Folder inch;
  ASSERT_EQ(run_ring(mm, ring("LENGTH=mm FORCE=N", 1.0, 1.0)).exit_code, 0);
  ASSERT_EQ(run_ring(metre, ring("LENGTH=m FORCE=N", 1e-3, 1.0)).exit_code, 0);
  const double pound = 4.4482216152605;
  ASSERT_EQ(run_ring(inch, ring("LENGTH=in FORCE=lbf", 1.0 / 25.4, 1.0 / pound)).exit_code, 0);
  const std::vector<double> a = k1(mm);
  const std::vector<double> b = k1(metre);
  const std::vector<double> c = k1(inch);
  ASSERT_EQ(a.size(), 4U);
  ASSERT_EQ(b.size(), a.size());
  ASSERT_EQ(c.size(), a.size());
  const double metres = std::pow(1e-3, -1.5);
  const double inches = std::pow(1.0 / 25.4, -1.5) / pound;
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_NEAR(b[i] / (a[i] * metres), 1.0, 1e-10);
    EXPECT_NEAR(c[i] / (a[i] * inches), 1.0, 1e-10);
  }
}

TEST(Invariance, SameBitsForOneAndTwoThreads) {
  const Folder one;
  const Folder two;
  ASSERT_EQ(run_ring(one, ring("LENGTH=mm FORCE=N", 1.0, 1.0), 1).exit_code, 0);
  ASSERT_EQ(run_ring(two, ring("LENGTH=mm FORCE=N", 1.0, 1.0), 2).exit_code, 0);
  for (const char* file : {"k.csv", "pressure.csv"}) {
    EXPECT_EQ(test::slurp(one.path() / "out" / file), test::slurp(two.path() / "out" / file));
  }
}

} // namespace
} // namespace spricka::test_invariance
