// SPDX-License-Identifier: GPL-3.0-or-later
// The sentences a report opens with, the step they speak of, and the places of a front.
#include "report/drawing/label_placer.hpp"
#include "report/report.hpp"
#include "report/topics/answer.hpp"
#include "report/topics/contact_words.hpp"
#include "report/topics/front_places.hpp"
#include "results/shown_step.hpp"
#include "sample.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <regex>

namespace spricka::report::test_of_answer {
namespace {

results::LoadStepResult loaded_step(const std::string& name, double K, double pressure,
                                    double energy) {
  results::LoadStepResult step;
  step.step = name;
  step.energy = energy;
  step.fronts.resize(1);
  step.fronts[0].points.resize(1);
  step.fronts[0].points[0].K1 = K;
  step.contacts.resize(1);
  step.contacts[0].max_pressure = pressure;
  return step;
}

TEST(ShownStep, IsTheMostLoadedOneUnlessTheDeckNamesAnother) {
  model::Model model;
  model.steps.resize(3);
  model.steps[0].name = "PRESS";
  model.steps[1].name = "LOAD";
  model.steps[2].name = "UNLOAD";
  results::CrackLengthResult length;
  length.steps = {loaded_step("PRESS", 10.0, 90.0, 1.0), loaded_step("LOAD", 50.0, 80.0, 5.0),
                  loaded_step("UNLOAD", 50.0 * (1.0 + 1e-12), 70.0, 9.0)};
  EXPECT_EQ(results::shown_step_name(model, {&length, 1}), "LOAD") << "the first of equals";
  for (results::LoadStepResult& step : length.steps) {
    step.fronts.clear();
  }
  EXPECT_EQ(results::shown_step_name(model, {&length, 1}), "PRESS") << "by pressure";
  for (results::LoadStepResult& step : length.steps) {
    step.contacts.clear();
  }
  EXPECT_EQ(results::shown_step_name(model, {&length, 1}), "UNLOAD") << "by energy";
  EXPECT_EQ(results::shown_step_name(model, {}), "UNLOAD") << "nothing is known";
  model.growth.emplace();
  model.growth->kmax = base::StepId(std::size_t{1});
  EXPECT_EQ(results::shown_step_name(model, {&length, 1}), "LOAD");
  model.control.shown_step = base::StepId(std::size_t{0});
  EXPECT_EQ(results::shown_step_name(model, {&length, 1}), "PRESS");
  EXPECT_EQ(results::shown_step_result(model, {&length, 1}, length), length.steps.data());
}

std::string text_of(const std::vector<AnswerLine>& lines, const std::string& subject) {
  const auto found = std::ranges::find(lines, subject, &AnswerLine::subject);
  return found == lines.end() ? std::string() : found->text;
}

TEST(Answer, TellsKContactChecksAndCost) {
  const test::Sample sample = test::make_sample();
  const std::vector<AnswerLine> lines = answer_lines(sample.model, sample.run);
  const std::string K = text_of(lines, "C1");
  EXPECT_NE(K.find("K1 = "), std::string::npos) << K;
  EXPECT_NE(K.find(" +- "), std::string::npos) << K;
  EXPECT_NE(K.find("a = 18"), std::string::npos) << K;
  EXPECT_NE(K.find("first length"), std::string::npos) << K;
  const std::string bush = text_of(lines, "BUSH");
  EXPECT_NE(bush.find("touches from -120.0 to 120.0 deg"), std::string::npos) << bush;
  EXPECT_NE(bush.find("largest pressure 90 "), std::string::npos) << bush; // 60 (1 + 18/36)
  EXPECT_NE(bush.find("at 0.0 deg"), std::string::npos) << bush;
  EXPECT_NE(text_of(lines, "Checks").find("2 of the deck's 2"), std::string::npos);
  EXPECT_NE(text_of(lines, "Cost").find("123 MB"), std::string::npos);
  // listing and page have the same words
  const std::string listing = listing_text(sample.sources, sample.model, sample.run);
  EXPECT_NE(listing.find(K), std::string::npos);
  const std::string page = html_report(sample.sources, sample.model, sample.run);
  EXPECT_LT(page.find("class=\"answer\""), page.find("<h2"));
  EXPECT_NE(page.find("touches from -120.0 to 120.0°"), std::string::npos);
}

TEST(Answer, OfRoundOffIsNothing) {
  test::Sample sample = test::make_sample();
  sample.model.control.shown_step = base::StepId(std::size_t{2});
  for (results::CrackLengthResult& increment : sample.run.increments) {
    results::ContactResult& unloaded = increment.steps[2].contacts[0];
    unloaded.mounted = true;
    unloaded.closed = 3;
    unloaded.max_pressure = 1e-13;
  }
  const std::string words = contact_words(sample.model, sample.run, sample.model.contacts.front());
  EXPECT_EQ(words.find("carries nothing; in step "), 0U) << words;
}

// A quarter of a circle from the y axis to the x axis, on the faces of a cube of one element.
results::FrontResult quarter(int points) {
  results::FrontResult front;
  front.name = "C1";
  for (int i = 0; i < points; ++i) {
    const double angle = 0.5 * std::numbers::pi * (points - 1 - i) / (points - 1);
    results::FrontPointResult& point = front.points.emplace_back();
    point.number = i + 1;
    point.x = {std::cos(angle), std::sin(angle), 0.0};
    point.s = 0.5 * std::numbers::pi * i / (points - 1);
    point.K1 = 10.0 + i;
    point.at_surface = i == 0 || i + 1 == points;
  }
  return front;
}

TEST(FrontPlaces, AreTheEndsByTheirFacesTheMiddleAndTheLargest) {
  model::Mesh mesh;
  mesh.dim = 3;
  mesh.first = {0};
  std::vector<base::NodeId> nodes;
  for (const base::Vec3& x :
       {base::Vec3(0, 0, 0), base::Vec3(1, 0, 0), base::Vec3(1, 1, 0), base::Vec3(0, 1, 0),
        base::Vec3(0, 0, 1), base::Vec3(1, 0, 1), base::Vec3(1, 1, 1), base::Vec3(0, 1, 1)}) {
    nodes.push_back(model::add_node(mesh, x, 1, base::NetId(std::size_t{0})));
  }
  model::add_element(mesh, base::ElementType::hexe8, nodes, 1, base::NetId(std::size_t{0}));
  for (int side = 0; side < 6; ++side) {
    const model::Face face{base::ElementId(std::size_t{0}), side};
    mesh.face_sets.push_back({"BODY.S" + std::to_string(side), {face}, {}});
  }
  mesh.face_sets.push_back({"C1.LEFT", mesh.face_sets.front().faces, {}});
  const FaceNames faces(mesh);
  EXPECT_FALSE(faces.at({1, 0, 0}).empty());
  EXPECT_EQ(faces.at({1, 0, 0}).front(), 'S') << "without its net";
  const std::vector<FrontPlace> places = front_places(quarter(9), faces);
  ASSERT_EQ(places.size(), 4U);
  EXPECT_EQ(places[0].name.substr(0, 4), "at S");
  EXPECT_EQ(places[1].name, "middle");
  EXPECT_EQ(places[1].point->number, 5);
  EXPECT_EQ(places[2].name, "largest") << "within the body";
  EXPECT_EQ(places[2].point->number, 8);
  results::FrontResult loop = quarter(9);
  loop.is_loop = true;
  EXPECT_EQ(front_places(loop, faces).size(), 2U);
}

TEST(FrontPlaces, OfManyPointsThatGrowThreeAreTold) {
  results::GrowthResult growth;
  for (int i = 1; i <= 34; ++i) {
    growth.point_names.push_back("C1." + std::to_string(i));
  }
  growth.point_names.insert(growth.point_names.end(), {"C2.1", "C2.2"});
  EXPECT_EQ(reported_growth_points(growth), (std::vector<std::size_t>{0, 17, 33, 34, 35}));
}

TEST(LabelPlacer, WritesNoLabelOverAnother) {
  SvgDrawing svg(200.0, 200.0, "labels");
  LabelPlacer placer({0.0, 0.0}, {200.0, 200.0});
  for (int i = 0; i < 8; ++i) {
    placer.write(svg, {100.0 + i, 100.0}, "C1.10", {});
  }
  const std::string text = svg.svg_text();
  const std::regex place("<text x=\"([0-9.]+)\" y=\"([0-9.]+)\"");
  std::vector<std::pair<double, double>> at;
  for (std::sregex_iterator m(text.begin(), text.end(), place); m != std::sregex_iterator(); ++m) {
    at.emplace_back(std::stod((*m)[1]), std::stod((*m)[2]));
  }
  ASSERT_EQ(at.size(), 8U);
  const double width = text_width("C1.10", {});
  for (std::size_t i = 0; i < at.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_TRUE(std::abs(at[i].first - at[k].first) >= width ||
                  std::abs(at[i].second - at[k].second) >= 12.0);
    }
  }
}

} // namespace
} // namespace spricka::report::test_of_answer
