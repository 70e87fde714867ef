// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever index, length or word of a stored increment is wrong, it is found before it is used.
#include "results/increment_flaw.hpp"

#include <functional>
#include <utility>

#include <gtest/gtest.h>

namespace spricka::results::test_increment_flaw {
namespace {

// A square of one element with a tip with a derivative, a contact and a path.
CrackLengthResult sound() {
  CrackLengthResult increment;
  model::Mesh& mesh = increment.mesh;
  std::vector<base::NodeId> nodes;
  for (const auto& [x, y] : {std::pair(0.0, 0.0), {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}) {
    const auto label = static_cast<base::Label>(nodes.size()) + 1;
    nodes.push_back(model::add_node(mesh, {x, y, 0.0}, label, base::NetId(std::size_t{0})));
  }
  model::add_element(mesh, base::ElementType::quam4, nodes, 1, base::NetId(std::size_t{0}));
  mesh.property[0] = base::PropertyId(std::size_t{0});
  mesh.node_sets.push_back({.name = "ALL", .nodes = nodes, .span = {}});
  mesh.face_sets.push_back(
      {.name = "LOW", .faces = {{base::ElementId(std::size_t{0}), 0}}, .span = {}});
  increment.kept = 1;
  LoadStepResult& step = increment.steps.emplace_back();
  step.u = base::Vector::Zero(8);
  step.stress.resize(4);
  step.element_stress.resize(1);
  FrontResult& front = step.fronts.emplace_back();
  front.points.emplace_back().bar[0].of_element = {0.5};
  front.sensitivities.by_parameter.emplace_back().below.resize(1); // above nothing holds a body
  ContactResult& contact = step.contacts.emplace_back();
  contact.points.resize(3);
  for (ContactPoint& point : contact.points) {
    point.node = nodes[0];
  }
  contact.corners = {0, 1, 2};
  step.errors.emplace_back().worst = {base::ElementId(std::size_t{0})};
  LoadPathResult& path = increment.paths.emplace_back();
  path.t = {0.0, 1.0};
  path.fronts.emplace_back().points.emplace_back();
  LoadPathContact& part = path.contacts.emplace_back();
  part.from = {0.0, 0.0};
  part.to = {1.0, 1.0};
  part.closed = {3, 3};
  return increment;
}

TEST(IncrementFlaw, OfASoundOneThereIsNone) {
  EXPECT_EQ(describe_increment_corruption(sound()), "");
}

TEST(IncrementFlaw, EachIsFound) {
  const std::vector<std::function<void(CrackLengthResult&)>> wrong{
      [](CrackLengthResult& i) { i.mesh.dim = -7; },
      [](CrackLengthResult& i) { i.mesh.nodes[2].value = -7; },
      [](CrackLengthResult& i) { i.mesh.nodes[2].value = 4; },
      [](CrackLengthResult& i) { i.mesh.type[0] = static_cast<base::ElementType>(200); },
      [](CrackLengthResult& i) { i.mesh.type[0] = base::ElementType::quamc8; },
      [](CrackLengthResult& i) { i.mesh.first[1] = 2147483647; },
      [](CrackLengthResult& i) { i.mesh.property.clear(); },
      [](CrackLengthResult& i) { i.mesh.node_label.pop_back(); },
      [](CrackLengthResult& i) { i.mesh.node_sets[0].nodes[0].value = 99; },
      [](CrackLengthResult& i) { i.mesh.face_sets[0].faces[0].side = 4; },
      [](CrackLengthResult& i) { i.mesh.face_sets[0].faces[0].element.value = -1; },
      [](CrackLengthResult& i) { i.kept = 2; },
      [](CrackLengthResult& i) {
        i.surface.push_back({base::ElementId(std::size_t{1}), {}});
      },
      [](CrackLengthResult& i) { i.steps[0].u.resize(6); },
      [](CrackLengthResult& i) { i.steps[0].stress.resize(3); },
      [](CrackLengthResult& i) { i.steps[0].element_stress.resize(2); },
      [](CrackLengthResult& i) { i.steps[0].fronts[0].single_point().bar[0].of_element.resize(2); },
      [](CrackLengthResult& i) { i.steps[0].fronts[0].single_point().bar[2].of_element.resize(3); },
      [](CrackLengthResult& i) { i.steps[0].contacts[0].points[1].node.value = 2147483647; },
      [](CrackLengthResult& i) {
        i.steps[0].contacts[0].points[1].state = static_cast<ContactState>(9);
      },
      [](CrackLengthResult& i) { i.steps[0].contacts[0].corners[2] = 3; },
      [](CrackLengthResult& i) { i.steps[0].contacts[0].corners.pop_back(); },
      [](CrackLengthResult& i) { i.steps[0].errors[0].worst[0].value = 1; },
      [](CrackLengthResult& i) { i.paths[0].contacts[0].to.pop_back(); },
      [](CrackLengthResult& i) { i.paths[0].changes.emplace_back().node.value = 4; },
  };
  for (std::size_t w = 0; w < wrong.size(); ++w) {
    CrackLengthResult increment = sound();
    wrong[w](increment);
    EXPECT_NE(describe_increment_corruption(increment), "") << w;
  }
}

// What reads a front takes its first point, and derivatives by the number of a point.
TEST(IncrementFlaw, FrontsHaveAllOfTheirPoints) {
  CrackLengthResult increment = sound();
  FrontResult& front = increment.steps[0].fronts[0];
  front.name = "C.1";
  front.points.clear();
  EXPECT_EQ(describe_increment_corruption(increment), "points of front C.1");
  front.sensitivities.by_parameter.clear();
  EXPECT_EQ(describe_increment_corruption(increment), "points of front C.1");
  increment = sound();
  increment.steps[0].fronts.emplace_back().name = "D"; // a second one
  EXPECT_EQ(describe_increment_corruption(increment), "points of front D");
  increment = sound();
  increment.paths[0].name = "UP";
  increment.paths[0].fronts[0].front_without_points.name = "C.1";
  increment.paths[0].fronts[0].points.clear();
  EXPECT_EQ(describe_increment_corruption(increment), "points of front C.1 on path UP");
}

TEST(IncrementFlaw, DerivativesAreOfThePointsThereAre) {
  for (const auto side : {&Sensitivity::below, &Sensitivity::above}) {
    for (const std::size_t points : {2U, 3U, 4U}) {
      CrackLengthResult increment = sound();
      FrontResult& front = increment.steps[0].fronts[0];
      front.name = "C";
      front.points.resize(3);
      Sensitivity& derivative = front.sensitivities.by_parameter[0];
      derivative.below.clear();
      (derivative.*side).resize(points);
      EXPECT_EQ(describe_increment_corruption(increment), points == 3 ? "" : "points of front C")
          << points;
    }
  }
  CrackLengthResult increment = sound();
  increment.steps[0].fronts[0].sensitivities.by_parameter[0].cause =
      static_cast<SensitivityParameter>(5);
  EXPECT_NE(describe_increment_corruption(increment), "");
}

} // namespace
} // namespace spricka::results::test_increment_flaw
