// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/growth_rules.hpp"

#include "growth/crack_lines.hpp"
#include "growth/elliptical_front.hpp"
#include "growth/free_front_shape.hpp"
#include "growth/planar_tips.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

// What SFLOW cannot be asked for; `no` tells it.
template <class No> bool ligament_can_yield(const model::Model& model, const No& no) {
  const bool heated = std::ranges::any_of(model.cases, [](const model::LoadCase& c) {
    return std::ranges::any_of(
        c.loads, [](const model::Load& load) { return load.type == model::LoadType::temperature; });
  });
  return !model.growth->flow_stress || (!heated && !model::is_axisymmetric(model)) ||
         no("SFLOW: the plastic limit of a ligament is not known with temperatures, nor round an "
            "axis");
}

// A front of the deck's nodes, or a tip in the plane with PATCH=NO.
bool keeps_own_mesh(const model::Model& model, std::size_t crack) {
  const model::CrackDefinition& definition = model.cracks[crack];
  return definition.kind == model::CrackDefinitionKind::front ||
         (definition.is_line() &&
          std::ranges::any_of(model.tip_nets, [&](const model::TipMeshSettings& tip) {
            return !tip.patch && tip.crack.index() == crack;
          }));
}

// Whether the cracks as they are at first can grow by the law of $GROW; why not is an error at the
// card.
bool growth_can_begin(const model::Model& model, const growth::CrackKinematics& kinematics,
                      base::Diagnostics& diagnostics) {
  const auto no = [&](const std::string& why) {
    diagnostics.error(model.growth->span, "E431", why);
    return false;
  };
  for (std::size_t c = 0; c < model.cracks.size(); ++c) {
    const model::CrackDefinition& crack = model.cracks[c];
    if (!growth::is_growing_crack(model, c)) {
      continue;
    }
    if (keeps_own_mesh(model, c)) {
      return no(fmt::format("crack {} keeps the deck's own mesh (PATCH=NO): its {} can only stand "
                            "at nodes, so that no law can move it",
                            crack.name,
                            crack.kind == model::CrackDefinitionKind::front ? "front" : "tip"));
    }
    if (model.growth->shape == model::FrontShapeRule::ellipse &&
        crack.kind == model::CrackDefinitionKind::drawn) {
      return no(fmt::format("SHAPE=ELLIPSE: crack {} is drawn by points", crack.name));
    }
    if (std::ranges::none_of(kinematics.tips(),
                             [&](const growth::TrackedTip& tip) { return tip.line == c; })) {
      const bool turns = model.growth->direction != model::GrowthDirection::path;
      return no(fmt::format("crack {} has no front in the body{}", crack.name,
                            turns ? ", or several, of which only DIRECTION=PATH can move more "
                                    "than one"
                                  : ""));
    }
  }
  if (kinematics.tips().empty()) {
    return no("$GROW: no crack grows");
  }
  for (std::size_t tip = 0; tip < kinematics.tips().size(); ++tip) {
    if (model.growth->last_length &&
        kinematics.initial_tip_extent(tip) >= *model.growth->last_length) {
      return no(fmt::format("AMAX = {:.6g} is not longer than {} is at first, {:.6g}",
                            *model.growth->last_length, kinematics.tips()[tip].name,
                            kinematics.initial_tip_extent(tip)));
    }
  }
  return ligament_can_yield(model, no);
}

// A rate at which a single cycle is no small part of the crack any more.
constexpr double much_of_length = 0.01;

constexpr double same_load = 1e-9;

bool has_a_range(const results::GrownPointResult& tip) {
  return tip.K_max > 0.0 && tip.K_max - tip.K_min > same_load * tip.K_max;
}

bool has_a_range(const results::GrowthResult& growth) {
  return std::ranges::any_of(growth.stations.front().points,
                             [](const results::GrownPointResult& tip) { return has_a_range(tip); });
}

bool has_no_range(const results::GrowthResult& growth) {
  return std::ranges::all_of(
      growth.stations.front().points,
      [](const results::GrownPointResult& tip) { return tip.K_max > 0.0 && !has_a_range(tip); });
}

// The crack ends at once by where it lies, whatever its law.
bool drawn_at_an_end(const results::GrowthResult& growth) {
  return growth.ended == "EDGE" || growth.ended == "LINK-UP" || growth.ended == "PATH END";
}

void look_at_beginning(const results::GrowthResult& growth, std::vector<std::string>& warnings) {
  const results::GrowthStation& first = growth.stations.front();
  for (const results::GrownPointResult& tip : first.points) {
    if (std::isfinite(tip.rate) && tip.rate > much_of_length * tip.a) {
      warnings.push_back(fmt::format(
          "{} grows by {:.2g} of its length in the first {}: a law adds up cycles that are many "
          "and small. Are C, KUNIT and AUNIT those you mean?",
          tip.name, tip.rate / tip.a, growth.unit));
    }
  }
}

// "12 % at delta K below 30 (down to 12)"; nothing of a part that is 0.
void add_part(double part, std::string_view side, const std::optional<double>& limit,
              std::string_view row, double reached, std::vector<std::string>& parts) {
  if (part > 0.0) {
    const bool below = side.ends_with("below");
    parts.push_back(fmt::format("{:.3g} % at {} {} ({} {:.4g})", 100.0 * part, side,
                                limit ? fmt::format("{:.4g}", *limit) : std::string(row),
                                below ? "down to" : "up to", reached));
  }
}

} // namespace

std::string describe_use_outside_data(const results::GrowthResult& growth,
                                      const model::Model& model) {
  const model::LawUse& use = growth.law_use;
  const model::GrowthLawData& data = model.growth->data;
  if (!(use.outside > 0.0)) {
    return {};
  }
  std::vector<std::string> parts;
  add_part(use.below_delta_k, "delta K below", data.lowest_delta_k, "the first row",
           use.lowest_delta_k, parts);
  add_part(use.above_delta_k, "delta K above", data.highest_delta_k, "the last row",
           use.highest_delta_k, parts);
  add_part(use.below_ratio, "R below", data.lowest_ratio, "the first column", use.lowest_ratio,
           parts);
  add_part(use.above_ratio, "R above", data.highest_ratio, "the last column", use.highest_ratio,
           parts);
  return fmt::format(
      "{:.3g} % of the cycles that grow, with {:.3g} % of the growth, lie outside the data of the "
      "law: {}; delta K in {}. There the law goes on {}, and nobody has measured it",
      100.0 * use.outside, 100.0 * use.growth_outside, fmt::join(parts, ", "),
      model.units.stress_intensity_name(),
      model.growth->law == model::CrackGrowthLaw::table
          ? "straight in its logarithms beyond the rows, by the exponent of the nearest two "
            "columns beyond these"
          : "by its formula");
}

std::vector<std::string> describe_life_concerns(const results::GrowthResult& growth) {
  std::vector<std::string> warnings;
  const bool nothing = growth.final_cycles() == 0.0;
  const bool grew = growth.stations.size() > 1;
  if (nothing && !grew && drawn_at_an_end(growth)) {
    warnings.push_back(fmt::format("the life is over before it begins: {}. Are the first lengths "
                                   "and the places of the cracks those you mean?",
                                   growth.reason));
    return warnings;
  }
  look_at_beginning(growth, warnings);
  if (nothing && !grew && growth.ended == "THRESHOLD" && has_a_range(growth)) {
    return warnings; // a crack below its threshold does not grow: that is the answer
  }
  if (nothing && !grew && growth.ended == "THRESHOLD" && has_no_range(growth)) {
    warnings.push_back(fmt::format("N = 0 is no life: K does not change in a {}: {}", growth.unit,
                                   growth.unit == "pass"
                                       ? "the load path leads between steps with the same loads"
                                       : "the steps KMAX and KMIN have the same loads"));
  } else if (nothing && !grew && (growth.ended == "THRESHOLD" || growth.ended == "CLOSED")) {
    warnings.push_back(fmt::format("N = 0 is no life: {}", growth.reason));
  } else if (nothing && !grew) {
    warnings.push_back(fmt::format("the life is over before it begins: {}. Are KC, SFLOW and the "
                                   "units those you mean?",
                                   growth.reason));
  } else if (growth.final_cycles() < 1.0) {
    warnings.push_back(
        fmt::format("the life is {:.3g} of a {}: a law adds up cycles that are many and small",
                    growth.final_cycles(), growth.unit));
  }
  return warnings;
}

std::unique_ptr<growth::CrackKinematics> make_crack_kinematics(const model::Model& model,
                                                               base::Diagnostics& diagnostics) {
  std::optional<std::vector<mesh::CrackLine>> lines = growth::crack_lines(model, 0.0, diagnostics);
  if (!lines) {
    return nullptr;
  }
  std::unique_ptr<growth::CrackKinematics> kinematics;
  if (!lines->empty()) {
    kinematics = std::make_unique<growth::PlanarTips>(model, std::move(*lines));
  } else if (model.growth->shape == model::FrontShapeRule::ellipse) {
    kinematics = std::make_unique<growth::EllipticalFront>(model);
  } else {
    kinematics = std::make_unique<growth::FreeFrontShape>(model);
  }
  return growth_can_begin(model, *kinematics, diagnostics) ? std::move(kinematics) : nullptr;
}

} // namespace spricka::analysis
