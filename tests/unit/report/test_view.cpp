// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/model.hpp"
#include "report/report.hpp"
#include "report/view/encoded_array.hpp"
#include "report/view/merged_surface.hpp"
#include "report/view/packed_text.hpp"
#include "report/view/view.hpp"
#include "report/view/view_data.hpp"
#include "sample.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using namespace spricka;
using namespace spricka::report;

TEST(Base64, IsThatOfRfc4648) {
  EXPECT_EQ(base64_text(""), "");
  EXPECT_EQ(base64_text("f"), "Zg==");
  EXPECT_EQ(base64_text("fo"), "Zm8=");
  EXPECT_EQ(base64_text("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64_text(std::string_view("\xff\xff\x00", 3)), "//8A");
}

TEST(ShownSurface, OfAPlaneMeshAreItsElements) {
  const test::Sample sample = test::make_sample();
  const results::CrackLengthResult& length = sample.run.increments.back();
  const ShownSurface surface = make_shown_surface(length);
  EXPECT_EQ(surface.kind.size(), length.mesh.element_count());
  EXPECT_EQ(surface.body.front(), 0U);
  EXPECT_EQ(surface.body.back(), 1U);
  // the mouth at radius 36, ring boundaries 39, 42, 48 and the nodes in the middle of edges; the
  // tip at 54 has one node
  EXPECT_EQ(surface.coincident.size(), 2 * 2 * 8U);
  for (std::size_t i = 0; i < surface.coincident.size(); i += 2) {
    const base::NodeId a = surface.node[surface.coincident[i]];
    const base::NodeId b = surface.node[surface.coincident[i + 1]];
    EXPECT_NE(a, b);
    EXPECT_LT((length.mesh.x[a.index()] - length.mesh.x[b.index()]).norm(), 1e-12);
  }
}

TEST(MergedSurface, KeepsTheFacesOfCracksAndLosesOthers) {
  const test::Sample sample = test::make_sample();
  const model::Mesh& mesh = sample.run.increments.back().mesh;
  const ShownSurface surface = make_shown_surface(sample.run.increments.back());
  const ShownSurface straight = without_straight_mid_nodes(mesh, surface);
  EXPECT_LT(straight.node.size(), surface.node.size());
  EXPECT_EQ(straight.kind.size(), surface.kind.size());
  const ShownSurface merged = merge_points(mesh, straight, 12);
  EXPECT_LT(merged.kind.size(), straight.kind.size() / 2);
  EXPECT_EQ(merged.coincident.size(), straight.coincident.size());
  EXPECT_GT(merged.coincident.size(), 0U);
}

TEST(ViewData, StartsWithTheShownStep) {
  const test::Sample sample = test::make_sample();
  const ViewData data = make_view_data(sample.model, sample.run);
  EXPECT_NE(data.json.find("\"startStep\":\"LOAD\""), std::string::npos);
}

TEST(ViewData, LeavesOutStepsThenLengthsThenDetailAndSaysSo) {
  const test::Sample sample = test::make_sample();
  const ViewData all = make_view_data(sample.model, sample.run);
  EXPECT_EQ(all.left_out, "");
  std::size_t size = all.json.size();
  const std::vector<std::string> order{"all steps but one of each length before the last",
                                       "all steps but the worst of each length",
                                       "1 of 2 crack lengths", "mid nodes", "merged into"};
  std::size_t met = 0;
  for (std::size_t budget = 2 * size; met < order.size() && budget > 3000;
       budget = budget * 9 / 10) {
    const ViewData some = make_view_data(sample.model, sample.run, budget);
    EXPECT_LE(some.json.size(), size) << budget << ": " << some.left_out;
    size = some.json.size();
    met += some.left_out.find(order[met]) != std::string::npos ? 1 : 0;
  }
  EXPECT_EQ(met, order.size()) << "not said: " << order[std::min(met, order.size() - 1)];
}

TEST(ViewSection, HasNoNameThatEndsAScript) {
  test::Sample sample = test::make_sample();
  sample.model.nets[0].name = "</SCRIPT><B>";
  const std::string section = view_section(sample.model, sample.run);
  EXPECT_NE(section.find("id=\"view-data\""), std::string::npos);
  EXPECT_EQ(section.find("SCRIPT>"), std::string::npos);
  EXPECT_NE(make_view_data(sample.model, sample.run).json.find("</SCRIPT>"), std::string::npos);
}

} // namespace
