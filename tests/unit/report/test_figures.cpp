// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/model.hpp"
#include "report/drawing/colour_scale.hpp"
#include "report/drawing/mesh_picture.hpp"
#include "report/drawing/plot.hpp"
#include "report/drawing/solid_picture.hpp"
#include "report/report.hpp"
#include "report/topics/figures.hpp"
#include "report/topics/notes.hpp"
#include "report/topics/result_tables.hpp"
#include "sample.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace spricka::report::test_of_figures {
namespace {

TEST(Ticks, AreRoundInsideAndAboutAsManyAsWanted) {
  for (const double scale : {1e-9, 3e-3, 0.7, 1.0, 42.0, 9.99e6}) {
    for (const double low : {0.0, -0.3, 0.21}) {
      const std::vector<AxisTick> ticks = round_axis_ticks(low * scale, scale, 6);
      ASSERT_GE(ticks.size(), 3U);
      ASSERT_LE(ticks.size(), 9U);
      const double step = ticks[1].value - ticks[0].value;
      const double lead = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
      EXPECT_LT(std::min({std::abs(lead - 1.0), std::abs(lead - 2.0), std::abs(lead - 5.0)}), 1e-6)
          << "step " << step;
      for (const AxisTick& tick : ticks) {
        EXPECT_GE(tick.value, (low - 1e-6) * scale);
        EXPECT_LE(tick.value, (1.0 + 1e-6) * scale);
      }
    }
  }
  ASSERT_EQ(round_axis_ticks(2.0, 2.0, 5).size(), 1U);
  EXPECT_EQ(round_axis_ticks(2.0, 2.0, 5).front().value, 2.0);
}

TEST(Ticks, ShowTheDigitsThatTellThemApart) {
  EXPECT_EQ(tick_text(0.30000000000000004, 0.1), "0.3");
  EXPECT_EQ(tick_text(0.0, 0.25), "0.0");
  EXPECT_EQ(tick_text(1500.0, 500.0), "1500");
  EXPECT_EQ(tick_text(0.05, 0.05), "0.05");
  EXPECT_EQ(tick_text(2e-7, 1e-7), "2e-07");
}

TEST(RoundDown, GivesTheLargestOneTwoOrFiveBelow) {
  EXPECT_DOUBLE_EQ(round_number_below(1.99), 1.0);
  EXPECT_DOUBLE_EQ(round_number_below(20.0), 20.0);
  EXPECT_DOUBLE_EQ(round_number_below(499.0), 200.0);
  EXPECT_DOUBLE_EQ(round_number_below(0.0072), 0.005);
}

TEST(PrintUnit, TurnsHalfPowersIntoRoots) {
  EXPECT_EQ(typeset_unit("MPa*mm^0.5"), "MPa √mm");
  EXPECT_EQ(typeset_unit("kN*m^0.5"), "kN √m");
  EXPECT_EQ(typeset_unit("N/mm^2"), "N/mm²");
  EXPECT_EQ(typeset_unit("psi"), "psi");
}

TEST(Nominal, IsFoundByNameInAnyCaseAndScalesK) {
  const test::Sample sample = test::make_sample();
  const std::optional<FigureReferenceValues> state = find_figure_reference_values(sample.model);
  ASSERT_TRUE(state);
  EXPECT_DOUBLE_EQ(state->radius, test::bore);
  EXPECT_DOUBLE_EQ(state->k0(6.0), test::sigma * std::sqrt(6.0 * std::numbers::pi));
  model::Model other = sample.model;
  other.parameters = {{"R", 36.0}};
  EXPECT_FALSE(find_figure_reference_values(other));
}

TEST(References, ComeFromTheChecksOnKAndMeetTheirIncrement) {
  test::Sample sample = test::make_sample();
  const std::vector<KCheckReference> references = k_references(sample.model, sample.run);
  ASSERT_EQ(references.size(), 2U);
  for (const KCheckReference& r : references) {
    EXPECT_EQ(r.tip, "C1");
    EXPECT_EQ(r.step, "LOAD");
    EXPECT_DOUBLE_EQ(r.found, test::k1(r.a));
    EXPECT_DOUBLE_EQ(r.wanted, 1.02 * r.found);
    EXPECT_EQ(r.source, "Handbook, Table 1");
  }
  EXPECT_EQ(k_reference_table(sample.model, sample.run).rows[1][6], "-1.96");
  sample.model.checks[0].quantity = "CPRESS.MAX";
  EXPECT_EQ(k_references(sample.model, sample.run).size(), 1U);
}

TEST(KFigure, NeedsTwoLengths) {
  test::Sample sample = test::make_sample();
  EXPECT_TRUE(k_over_crack_length_figure(sample.model, sample.run));
  EXPECT_TRUE(normalised_k_figure(sample.model, sample.run));
  sample.run.increments.pop_back();
  EXPECT_FALSE(k_over_crack_length_figure(sample.model, sample.run));
  EXPECT_FALSE(normalised_k_figure(sample.model, sample.run));
}

TEST(KFigure, NamesCurvesThatCoincideOnce) {
  test::Sample sample = test::make_sample();
  for (results::CrackLengthResult& increment : sample.run.increments) {
    increment.steps[2].fronts = increment.steps[0].fronts; // UNLOAD ends where PRESS did
  }
  const std::string drawing =
      k_over_crack_length_figure(sample.model, sample.run)->drawings.front();
  EXPECT_NE(drawing.find(">PRESS, UNLOAD<"), std::string::npos);
  EXPECT_NE(drawing.find(">LOAD<"), std::string::npos);
}

TEST(Increments, AreChosenEvenlyWithBothEnds) {
  results::RunResult run;
  for (int i = 0; i < 11; ++i) {
    run.increments.emplace_back().number = i;
  }
  std::vector<int> numbers;
  for (const results::CrackLengthResult* increment : sample_increments(run, 3)) {
    numbers.push_back(increment->number);
  }
  EXPECT_EQ(numbers, (std::vector<int>{0, 5, 10}));
  EXPECT_EQ(sample_increments(run, 1).size(), 1U);
  EXPECT_EQ(sample_increments(run, 99).size(), 11U);
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

TEST(MeshFigures, ShowTheWholeMeshAndEachTipOfAPlaneMesh) {
  test::Sample sample = test::make_sample();
  const std::vector<Figure> figures = mesh_figures(sample.model, sample.run);
  ASSERT_EQ(figures.size(), 3U);
  EXPECT_EQ(figures[1].drawings.size(), 3U) << "two stresses and displacement";
  EXPECT_EQ(figures[2].drawings.size(), 3U) << "two lengths and the tip";
  for (results::CrackLengthResult& increment : sample.run.increments) {
    increment.mesh.dim = 3;
  }
  EXPECT_TRUE(mesh_figures(sample.model, sample.run).empty());
}

TEST(MeshFigures, WithoutStressesTheFieldIsLeftOut) {
  test::Sample sample = test::make_sample();
  for (results::CrackLengthResult& increment : sample.run.increments) {
    for (results::LoadStepResult& step : increment.steps) {
      step.stress.clear();
    }
  }
  EXPECT_EQ(mesh_figures(sample.model, sample.run).size(), 2U);
}

TEST(ColourScale, ItsEndsTakeWhatLiesBeyondThem) {
  const ColourScale scale = make_colour_scale(-2.0, 4.0);
  EXPECT_EQ(scale.band_index(-5.0), 0U);
  EXPECT_EQ(scale.band_index(-1.9), 0U);
  EXPECT_EQ(scale.band_index(1.0), colour_bands / 2);
  EXPECT_EQ(scale.band_index(4.0), colour_bands - 1);
  EXPECT_EQ(scale.band_index(9.0), colour_bands - 1);
  EXPECT_EQ(make_colour_scale(100.0, 100.0 * (1.0 + 1e-12)).low, 0.0) << "round-off has no colours";
}

TEST(Notes, ThatDifferByNumbersAloneAreSaidOnce) {
  results::RunResult run;
  for (int i = 1; i <= 3; ++i) {
    results::CrackLengthResult increment;
    increment.number = i;
    increment.steps.emplace_back().step = "LOAD";
    increment.steps.back().notes = {
        results::less_exact_note(fmt::format("K1 = {:.3e} is doubtful", 1e-3 * i)),
        results::make_note(i == 2 ? "PIN slides" : "BUSH slides")};
    run.increments.push_back(increment);
  }
  const std::vector<RepeatedNote> notes = collect_notes(run);
  ASSERT_EQ(notes.size(), 3U);
  EXPECT_EQ(notes[0].first.kind, base::ResultConcern::less_exact);
  EXPECT_EQ(repeated_note_text(notes[0]),
            "increment 1, step LOAD: K1 = 1.000e-03 is doubtful (alike 2 more "
            "times, last in increment 3, step LOAD)");
  EXPECT_EQ(notes[1].times, 2);
  EXPECT_EQ(repeated_note_text(notes[2]), "increment 2, step LOAD: PIN slides");
}

TEST(MeshPicture, DrawsACurvedEdgeAsItsParabola) {
  model::Mesh mesh;
  std::vector<base::NodeId> nodes;
  for (const base::Vec3& x :
       {base::Vec3(0, 0, 0), base::Vec3(100, 0, 0), base::Vec3(0, 100, 0), base::Vec3(50, -10, 0),
        base::Vec3(50, 50, 0), base::Vec3(0, 50, 0)}) {
    nodes.push_back(model::add_node(mesh, x, 1, base::NetId(0)));
  }
  model::add_element(mesh, base::ElementType::trimc6, nodes, 1, base::NetId(0));
  MeshView view;
  view.mesh = &mesh;
  view.id = "one";
  view.low = {0, -20};
  view.high = {100, 100};
  view.width = 100.0;
  // Edge 1: control point 2 (50, -10) - (50, 0) = (50, -20); pixels: y = 22 + 100 - y.
  EXPECT_EQ(count(draw_svg(view), "M0 122Q50 142 100 122"), 2U) << "area and outline";
}

// A unit cube as one HEXE8 with its six faces, all under the same tension.
void add_cube(results::CrackLengthResult& increment, results::LoadStepResult& step,
              const base::Vec3& at, double tension) {
  model::Mesh& mesh = increment.mesh;
  mesh.dim = 3;
  std::vector<base::NodeId> nodes;
  for (const base::Vec3& x :
       {base::Vec3(0, 0, 0), base::Vec3(1, 0, 0), base::Vec3(1, 1, 0), base::Vec3(0, 1, 0),
        base::Vec3(0, 0, 1), base::Vec3(1, 0, 1), base::Vec3(1, 1, 1), base::Vec3(0, 1, 1)}) {
    nodes.push_back(model::add_node(mesh, at + x, 1, base::NetId(0)));
    step.stress.push_back({tension, 0, 0, 0, 0, 0});
  }
  const base::ElementId cube =
      model::add_element(mesh, base::ElementType::hexe8, nodes, 1, base::NetId(0));
  for (const std::array<std::size_t, 4>& side : {std::array<std::size_t, 4>{0, 3, 2, 1},
                                                 {4, 5, 6, 7},
                                                 {0, 1, 5, 4},
                                                 {2, 3, 7, 6},
                                                 {1, 2, 6, 5},
                                                 {0, 4, 7, 3}}) {
    results::OuterSurfaceFace face{cube, {}};
    for (const std::size_t n : side) {
      face.outline.push_back(nodes[n]);
    }
    increment.surface.push_back(std::move(face));
  }
}

// Of areas, in the order they are painted.
std::vector<std::string> fills_of_paths(const std::string& drawing) {
  std::vector<std::string> fills;
  for (std::size_t at = drawing.find("<path"); at != std::string::npos;
       at = drawing.find("<path", at + 1)) {
    const std::size_t fill = drawing.find("fill=\"", at) + 6;
    fills.push_back(drawing.substr(fill, drawing.find('"', fill) - fill));
    if (fills.back() == "none") {
      fills.pop_back(); // a line
    }
  }
  return fills;
}

TEST(SolidPicture, ShowsTheFacesTurnedToTheEyeTheNearestLast) {
  results::CrackLengthResult increment;
  results::LoadStepResult step;
  // From x, -y and z: the second cube stands before the first.
  add_cube(increment, step, {0.0, 0.0, 0.0}, 10.0);
  add_cube(increment, step, {2.0, -3.0, 1.8}, 30.0);
  const std::vector<std::string> fills =
      fills_of_paths(draw_svg(SolidView{.increment = &increment,
                                        .step = &step,
                                        .value = results::von_mises,
                                        .title = "Surface",
                                        .field_title = "von Mises, MPa",
                                        .width = 400.0}));
  ASSERT_EQ(fills.size(), 6U) << "three faces of each cube";
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(fills[i], fills[0]);
    EXPECT_EQ(fills[3 + i], fills[3]);
  }
  EXPECT_NE(fills[0], fills[3]);
  EXPECT_EQ(fills[3], "#fde725") << "the largest stress has the lightest colour";
}

TEST(SolidPicture, OfTooManyFacesIsLeftToOthers) {
  test::Sample sample = test::make_sample();
  results::CrackLengthResult increment;
  increment.steps.resize(1);
  increment.steps[0].step = "LOAD";
  add_cube(increment, increment.steps[0], base::Vec3::Zero(), 1.0);
  sample.run.increments = {increment};
  ASSERT_EQ(mesh_figures(sample.model, sample.run).size(), 1U);
  EXPECT_EQ(mesh_figures(sample.model, sample.run)[0].drawings.size(), 2U);
  sample.run.increments[0].surface.resize(most_drawn_faces + 1);
  const std::vector<Figure> figures = mesh_figures(sample.model, sample.run);
  ASSERT_EQ(figures.size(), 1U);
  EXPECT_TRUE(figures[0].drawings.empty());
  EXPECT_NE(figures[0].caption.find("ParaView"), std::string::npos);
}

TEST(PressureFigures, HaveOneDrawingForEachLengthAndCutTheCurveAtTheMouth) {
  const test::Sample sample = test::make_sample();
  const std::vector<Figure> figures = pressure_figures(sample.model, sample.run);
  ASSERT_EQ(figures.size(), 1U);
  EXPECT_EQ(figures[0].drawings.size(), 2U);
  EXPECT_NE(figures[0].caption.find("crack mouths"), std::string::npos);
  EXPECT_EQ(figures[0].caption.find("tension"), std::string::npos);
}

TEST(PressureFigures, DrawStraightSurfacesAlongTheirLength) {
  test::Sample sample = test::make_sample();
  for (results::CrackLengthResult& increment : sample.run.increments) {
    for (results::LoadStepResult& step : increment.steps) {
      for (results::ContactPoint& point : step.contacts[0].points) {
        point.theta = 0.0;
      }
    }
  }
  const std::vector<Figure> figures = pressure_figures(sample.model, sample.run);
  ASSERT_EQ(figures.size(), 1U);
  EXPECT_NE(figures[0].drawings[0].find("distance along the surface"), std::string::npos);
}

TEST(HtmlPage, IsSelfContainedAndAlwaysTheSame) {
  const test::Sample sample = test::make_sample();
  const std::string page = html_report(sample.sources, sample.model, sample.run);
  EXPECT_EQ(page, html_report(sample.sources, sample.model, sample.run));
  EXPECT_EQ(count(page, "<script"), count(page, "</script>"));
  for (const char* const loads : {"<script src", "<link", "<img", "@import", "url(http"}) {
    EXPECT_EQ(page.find(loads), std::string::npos) << loads;
  }
  EXPECT_NE(page.find("ring &lt;sample&gt;"), std::string::npos) << "text is escaped";
  EXPECT_EQ(count(page, "<svg"), count(page, "</svg>"));
}

TEST(HtmlPage, AndListingDoWithoutResults) {
  const base::SourceTexts sources;
  const model::Model model;
  const results::RunResult run;
  EXPECT_NE(html_report(sources, model, run).find("</html>"), std::string::npos);
  EXPECT_NE(listing_text(sources, model, run).find("Processor log"), std::string::npos);
}

TEST(LeadingStep, IsKmaxOrTheLast) {
  test::Sample sample = test::make_sample();
  EXPECT_EQ(leading_step_name(sample.model), "LOAD");
  sample.model.growth.reset();
  EXPECT_EQ(leading_step_name(sample.model), "UNLOAD");
}

} // namespace
} // namespace spricka::report::test_of_figures
