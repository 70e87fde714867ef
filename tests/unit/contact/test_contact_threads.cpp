// SPDX-License-Identifier: GPL-3.0-or-later
// Contact integration on any number of threads: the same bits.
#include "base/parallel.hpp"
#include "contact/pairing.hpp"
#include "contact/slide.hpp"
#include "contact/space/opposite.hpp"
#include "contact/space_tractions.hpp"
#include "contact/survey.hpp"
#include "model/model.hpp"
#include "stacked_solids.hpp"

#include <bit>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace spricka::test_contact_threads {
namespace {

/// Two blocks that rub, the upper one lifted and tilted, whose surfaces are larger than a batch.
model::Model rubbing_blocks() {
  test::StackSpec spec;
  spec.upper_cells = 10;
  spec.lower_cells = 13;
  model::Model model = test::stacked_solids(spec);
  model.contacts[0].gap.reset();
  model.contacts[0].mu = 0.3;
  for (std::size_t n = 0; n < model.mesh.node_count(); ++n) {
    base::Vec3& x = model.mesh.x[n];
    x.z() += model.mesh.node_net[n] == base::NetId(std::size_t{0}) ? 0.05 + 0.01 * x.x() : 0.0;
  }
  return model;
}

/// Numbers in the order of their making, to be compared bit by bit.
class Bits {
public:
  void add(double x) { bits_.push_back(std::bit_cast<std::uint64_t>(x)); }
  void add(const base::Vec3& x) {
    for (const double c : x) {
      add(c);
    }
  }
  bool operator==(const Bits&) const = default;
  [[nodiscard]] std::size_t count() const { return bits_.size(); }

private:
  std::vector<std::uint64_t> bits_;
};

void add_rows(const std::vector<contact::ConstraintRow>& rows, Bits& bits) {
  for (const contact::ConstraintRow& row : rows) {
    bits.add(row.gap);
    bits.add(row.round_gap);
    bits.add(row.area);
    for (const contact::RowEntry& entry : row.entries) {
      bits.add(static_cast<double>(entry.node.index()));
      bits.add(entry.weight);
    }
  }
}

Bits rows_of(const contact::PairConstraints& pair) {
  Bits bits;
  add_rows(pair.normal, bits);
  add_rows(pair.tangent, bits);
  for (const contact::MultiplierFunction& function : pair.functions) {
    bits.add(function.whole);
    bits.add(function.area);
    bits.add(function.row);
  }
  return bits;
}

Bits surveys_of(const contact::PairConstraints& pair) {
  Bits bits;
  for (const contact::GapSurvey& seen : {contact::survey_gaps(pair.contact, pair.target),
                                         contact::survey_gaps(pair.target, pair.contact)}) {
    for (const double x :
         {seen.seen, seen.gap_mean, seen.gap_low, seen.gap_high, seen.angle_high}) {
      bits.add(x);
    }
  }
  return bits;
}

Bits slide_of(const contact::PairConstraints& pair, const base::Vector& lambda,
              const base::Vector& u) {
  Bits bits;
  const contact::SlideMeasures slide = contact::measure_slide(pair, lambda, u);
  for (const double x : {slide.thrust, slide.unsupported_part, slide.way, slide.facet,
                         slide.pressed, slide.misfit}) {
    bits.add(x);
  }
  for (const contact::DisplacedContactPoint& place : slide.places) {
    bits.add(place.x);
    bits.add(place.thrust);
    bits.add(place.unseen.value_or(1e300));
  }
  return bits;
}

Bits tractions_of(const contact::PairConstraints& pair, const base::Vector& lambda) {
  Bits bits;
  for (const contact::FaceTraction& on_face :
       contact::solid_pair_tractions(pair, lambda, [](const model::Face&) { return true; })) {
    for (const contact::FacePointForce& point : on_face.points) {
      bits.add(point.force);
    }
  }
  return bits;
}

TEST(ContactThreads, SameBitsOfRowsSurveysSlidesAndTractions) {
  const model::Model model = rubbing_blocks();
  std::vector<Bits> first;
  for (const int threads : {1, 2, 3, 4}) {
    const base::ThreadShare share(threads);
    const contact::PairConstraints pair =
        contact::build_pair_constraints(model, model.mesh, model.contacts[0]);
    ASSERT_TRUE(pair.trouble.empty()) << pair.trouble;
    ASSERT_GE(pair.contact.elements.size(), 2 * contact::elements_at_a_time);
    ASSERT_EQ(pair.tangent.size(), 2 * pair.normal.size());
    base::Vector lambda(static_cast<Eigen::Index>(3 * pair.normal.size()));
    base::Vector u(static_cast<Eigen::Index>(3 * model.mesh.node_count()));
    for (Eigen::Index i = 0; i < lambda.size(); ++i) {
      lambda[i] = 1.0 + std::sin(0.37 * static_cast<double>(i));
    }
    for (Eigen::Index i = 0; i < u.size(); ++i) {
      u[i] = 0.01 * std::cos(0.11 * static_cast<double>(i));
    }
    const std::vector<Bits> found{rows_of(pair), surveys_of(pair), slide_of(pair, lambda, u),
                                  tractions_of(pair, lambda)};
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_GE(found[i].count(), 10U) << i;
    }
    first = first.empty() ? found : first;
    EXPECT_TRUE(found == first) << threads;
  }
}

// What the first element in order says is told, whichever thread comes to its own first.
TEST(ContactThreads, TheSameTrouble) {
  model::Model model = rubbing_blocks();
  std::vector<model::Face>& lower = model.mesh.face_sets[model.contacts[0].master.index()].faces;
  const std::vector<model::Face> once = lower;
  lower.insert(lower.end(), once.begin(), once.end()); // two layers
  std::string first;
  for (const int threads : {1, 4}) {
    const base::ThreadShare share(threads);
    const contact::PairConstraints pair =
        contact::build_pair_constraints(model, model.mesh, model.contacts[0]);
    EXPECT_FALSE(pair.trouble.empty());
    first = first.empty() ? pair.trouble : first;
    EXPECT_EQ(pair.trouble, first);
    EXPECT_TRUE(pair.normal.empty());
  }
}

} // namespace
} // namespace spricka::test_contact_threads
