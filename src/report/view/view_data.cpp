// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/view/view_data.hpp"

#include "model/model.hpp"
#include "report/drawing/colour_scale.hpp"
#include "report/drawing/table.hpp"
#include "report/view/encoded_array.hpp"
#include "report/view/merged_surface.hpp"
#include "report/view/step_fields.hpp"
#include "results/result_unit.hpp"
#include "results/shown_step.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <numeric>
#include <utility>

namespace spricka::report {
namespace {

using Json = nlohmann::ordered_json;

/// One length as it is shown.
struct ShownLength {
  const results::CrackLengthResult* increment = nullptr;
  ShownSurface surface;
  std::vector<std::size_t> steps;
};

bool can_be_shown(const results::CrackLengthResult& increment) {
  const auto freedoms = static_cast<Eigen::Index>(increment.mesh.node_count()) * increment.mesh.dim;
  return !increment.steps.empty() && increment.mesh.element_count() > 0 &&
         std::ranges::all_of(increment.steps, [&](const results::LoadStepResult& step) {
           return step.u.size() == freedoms;
         });
}

std::size_t bytes_of_one(std::size_t largest) {
  return largest < 256 ? 1 : largest < 65536 ? 2 : 4;
}

/// Letters that a length takes, about.
std::size_t letters_of(const ShownLength& length) {
  const auto dim = static_cast<std::size_t>(length.increment->mesh.dim);
  const ShownSurface& s = length.surface;
  const std::size_t points = s.node.size();
  std::size_t bytes = points * (2 * dim + 4) + s.outline.size() * bytes_of_one(points) +
                      2 * s.kind.size() + s.coincident.size() * bytes_of_one(points);
  for (const std::size_t i : length.steps) {
    const results::LoadStepResult& step = length.increment->steps[i];
    bytes += points * (2 * dim + (step.stress.empty() ? 0 : 4));
    for (const results::ContactResult& contact : step.contacts) {
      bytes += contact.points.size() * 16; // with mid nodes
    }
  }
  return bytes * 4 / 3;
}

std::size_t letters_of(const std::vector<ShownLength>& lengths) {
  return std::accumulate(
      lengths.begin(), lengths.end(), std::size_t{0},
      [](std::size_t sum, const ShownLength& length) { return sum + letters_of(length); });
}

std::vector<std::size_t> all_steps(const results::CrackLengthResult& increment) {
  std::vector<std::size_t> steps(increment.steps.size());
  std::iota(steps.begin(), steps.end(), std::size_t{0});
  return steps;
}

/// About every other one, first and last among them; of two the last.
void halve(std::vector<ShownLength>& lengths) {
  std::vector<ShownLength> kept;
  const std::size_t wanted = (lengths.size() + 1) / 2;
  for (std::size_t k = 0; k < wanted; ++k) {
    const std::size_t at =
        wanted == 1 ? lengths.size() - 1 : k * (lengths.size() - 1) / (wanted - 1);
    kept.push_back(std::move(lengths[at]));
  }
  lengths = std::move(kept);
}

/// Merges points until a length alone fits; false: it never does.
bool merge_into(ShownLength& length, std::size_t budget) {
  const model::Mesh& mesh = length.increment->mesh;
  length.surface = without_straight_mid_nodes(mesh, length.surface);
  constexpr std::size_t finest = 1024;
  constexpr std::size_t coarsest = 16;
  const ShownSurface fine = length.surface;
  for (std::size_t cubes = finest; letters_of(length) > budget; cubes = cubes * 3 / 4) {
    if (cubes < coarsest) {
      return false;
    }
    length.surface = merge_points(mesh, fine, cubes);
  }
  return true;
}

/// What fits, and what was left out for it.
struct ChosenLengths {
  std::vector<ShownLength> lengths;
  std::vector<std::string> without;
};

/// The number of the shown step in an increment.
std::size_t shown_step_index(const model::Model& model, const results::RunResult& run,
                             const results::CrackLengthResult& increment) {
  return static_cast<std::size_t>(results::shown_step_result(model, run.increments, increment) -
                                  increment.steps.data());
}

ChosenLengths choose_lengths(const model::Model& model, const results::RunResult& run,
                             std::size_t budget) {
  ChosenLengths chosen;
  std::vector<ShownLength>& lengths = chosen.lengths;
  for (const results::CrackLengthResult& increment : run.increments) {
    if (can_be_shown(increment)) {
      lengths.push_back({&increment, make_shown_surface(increment), all_steps(increment)});
    }
  }
  const std::size_t all = lengths.size();
  const auto keep_start_step = [&](ShownLength& length) {
    length.steps = {shown_step_index(model, run, *length.increment)};
  };
  const bool steps = std::ranges::any_of(
      lengths, [](const ShownLength& length) { return length.steps.size() > 1; });
  if (steps && letters_of(lengths) > budget) {
    std::for_each(lengths.begin(), lengths.end() - 1, keep_start_step);
    if (all == 1 || letters_of(lengths) > budget) {
      keep_start_step(lengths.back());
    }
    chosen.without.push_back(lengths.back().steps.size() > 1
                                 ? "all steps but one of each length before the last"
                                 : "all steps but the worst of each length");
  }
  while (lengths.size() > 1 && letters_of(lengths) > budget) {
    halve(lengths);
  }
  if (lengths.size() < all) {
    chosen.without.push_back(fmt::format("{} of {} crack lengths", all - lengths.size(), all));
  }
  if (letters_of(lengths) > budget) {
    const std::size_t faces = lengths.back().surface.kind.size();
    if (!merge_into(lengths.back(), budget)) {
      lengths.clear();
    } else {
      const std::size_t left = lengths.back().surface.kind.size();
      chosen.without.push_back(
          left < faces ? fmt::format("detail of the surface, whose {} faces were merged into {}",
                                     faces, left)
                       : std::string("mid nodes of straight edges"));
    }
  }
  return chosen;
}

Json coordinates(const base::Vec3& x, const base::OutputUnit& unit = {}) {
  return Json::array({unit.from_deck(x[0]), unit.from_deck(x[1]), unit.from_deck(x[2])});
}

Json encode_front(const results::FrontResult& front, const base::OutputUnit& length) {
  Json points = Json::array();
  base::Vec3 way = base::Vec3::Zero();
  for (const results::FrontPointResult& point : front.points) {
    points.push_back(coordinates(point.x, length));
    way += point.direction / static_cast<double>(front.points.size());
  }
  return {{"name", front.name},
          {"loop", front.is_loop},
          {"way", coordinates(front.is_loop ? base::Vec3(base::Vec3::Zero()) : way)},
          {"x", std::move(points)}};
}

Json encode_fronts(const results::CrackLengthResult& increment, const base::OutputUnit& length) {
  Json fronts = Json::array();
  for (const results::FrontResult& front : increment.steps.back().fronts) {
    fronts.push_back(encode_front(front, length));
  }
  return fronts;
}

std::string length_name(const model::Model& model, const results::CrackLengthResult& increment) {
  return increment.a > 0.0 ? "a = " + model.units.output_length().text(increment.a, 4)
                           : std::string();
}

Json encode_length(const model::Model& model, const ShownLength& length) {
  const model::Mesh& mesh = length.increment->mesh;
  const ShownSurface& surface = length.surface;
  const base::OutputUnit unit = model.units.output_length();
  Json x = Json::array();
  for (int c = 0; c < mesh.dim; ++c) {
    std::vector<double> values;
    for (const base::NodeId n : surface.node) {
      values.push_back(unit.from_deck(mesh.x[n.index()][c]));
    }
    x.push_back(encode_numbers(values));
  }
  std::vector<std::uint32_t> labels;
  for (const base::NodeId n : surface.node) {
    labels.push_back(static_cast<std::uint32_t>(mesh.node_label[n.index()]));
  }
  Json steps = Json::array();
  for (const std::size_t i : length.steps) {
    steps.push_back(encode_step(model, *length.increment, length.increment->steps[i], surface));
  }
  return {{"name", length_name(model, *length.increment)},
          {"x", std::move(x)},
          {"label", encode_counts(labels)},
          {"kind", encode_counts(surface.kind)},
          {"outline", encode_counts(surface.outline)},
          {"body", encode_counts(surface.body)},
          {"coincident", encode_counts(surface.coincident)},
          {"fronts", encode_fronts(*length.increment, unit)},
          {"steps", std::move(steps)}};
}

/// Fronts of all lengths, with their cycles where there is a law; of one length none.
Json encode_marks(const model::Model& model, const results::RunResult& run) {
  const base::OutputUnit length = model.units.output_length();
  Json marks = Json::array();
  for (const results::CrackLengthResult& increment : run.increments) {
    if (increment.steps.empty() || increment.steps.back().fronts.empty()) {
      continue;
    }
    Json mark{{"a", length.from_deck(increment.a)}, {"fronts", encode_fronts(increment, length)}};
    if (run.growth) {
      const auto station = std::ranges::find(run.growth->stations, increment.number,
                                             &results::GrowthStation::increment);
      if (station == run.growth->stations.end()) {
        continue;
      }
      mark["N"] = results::life_unit(model.units, *run.growth).from_deck(station->cycles);
    }
    marks.push_back(std::move(mark));
  }
  return marks.size() > 1 ? marks : Json::array();
}

Json encode_field_names(const model::Model& model) {
  Json fields = Json::array();
  for (const ShownField& field : step_fields) {
    fields.push_back({{"key", field.key},
                      {"name", field.name},
                      {"unit", typeset_unit(base::output_unit(model.units, field.kind).name)}});
  }
  return fields;
}

} // namespace

ViewData make_view_data(const model::Model& model, const results::RunResult& run,
                        std::size_t budget) {
  const ChosenLengths chosen = choose_lengths(model, run, budget);
  if (chosen.lengths.empty()) {
    return {};
  }
  const ShownLength& last = chosen.lengths.back();
  Json colours = Json::array();
  for (std::size_t band = 0; band < colour_bands; ++band) {
    colours.push_back(band_colour(band));
  }
  Json bodies = Json::array();
  for (const model::NetDefinition& net : model.nets) {
    bodies.push_back(net.name);
  }
  Json lengths = Json::array();
  for (const ShownLength& length : chosen.lengths) {
    lengths.push_back(encode_length(model, length));
  }
  const std::size_t start = shown_step_index(model, run, *last.increment);
  const Json data{{"dim", last.increment->mesh.dim},
                  {"lengthUnit", model.units.output_length().name},
                  {"kUnit", typeset_unit(model.units.output_stress_intensity().name)},
                  {"cycleUnits", run.growth ? results::life_unit_words(
                                                  results::life_unit(model.units, *run.growth).name)
                                            : "cycles"},
                  {"colours", std::move(colours)},
                  {"bodies", std::move(bodies)},
                  {"fields", encode_field_names(model)},
                  {"startStep", last.increment->steps[start].step},
                  {"marks", encode_marks(model, run)},
                  {"lengths", std::move(lengths)}};
  return {.json = data.dump(-1, ' ', false, Json::error_handler_t::replace),
          .left_out = chosen.without.empty()
                          ? std::string()
                          : fmt::format("To keep the page small the view is without {}.",
                                        fmt::join(chosen.without, ", and without "))};
}

} // namespace spricka::report
