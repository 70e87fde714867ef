// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/halves.hpp"

#include "model/model.hpp"
#include "sense/half_model.hpp"
#include "sense/mirrors.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace spricka::program {

namespace {

// The largest "U.Y" of a whole that y mirrors is that of a part, or minus its smallest.
bool is_odd_extreme(const AnswerRequest& answer, const std::string& mirrored) {
  const std::string& word = answer.check.quantity;
  const bool directed =
      answer.group == AnswerGroup::displacement || answer.group == AnswerGroup::stress;
  const std::size_t from = word.find('.');
  const std::size_t to = word.rfind('.');
  if (!directed || from == to || (!word.ends_with(".MIN") && !word.ends_with(".MAX"))) {
    return false;
  }
  const std::string component = word.substr(from, to - from);
  return std::ranges::any_of(
      mirrored, [&](char axis) { return std::ranges::count(component, axis) % 2 == 1; });
}

} // namespace

SymmetricPart reduce_by_symmetry(const model::Model& model, const deck::DeckCardList& text) {
  SymmetricPart part;
  deck::DeckCardList changed = text;
  for (const results::SymmetryPlanePreview& mirror : sense::find_symmetry_planes(model)) {
    const bool there = std::ranges::any_of(
        model.mirrors, [&](const model::MirrorPlane& plane) { return plane.axis == mirror.axis; });
    const char axis = "xyz"[mirror.axis];
    std::string against = mirror.against;
    if (against.empty() && !there) {
      against = sense::half_model_obstacle(model, mirror.axis);
    }
    if (there || !against.empty()) {
      if (!there) {
        part.reason = fmt::format("{} = {:.4g}: {}", axis, mirror.at, against);
      }
      continue;
    }
    append_card(changed,
                deck::make_card("SYMMETRY", {{"NORMAL", std::string(1, "XYZ"[mirror.axis])}}));
    part.mirrored += "XYZ"[mirror.axis];
    part.words += fmt::format("{}{} >= {:.4g}", part.words.empty() ? "" : ", ", axis, mirror.at);
  }
  if (part.mirrored.empty()) {
    part.reason = part.reason.empty() ? "the bodies have no plane of symmetry" : part.reason;
    part.name = "half by symmetry";
    return part;
  }
  constexpr std::array names{"half", "quarter", "eighth"};
  part.name = fmt::format("{} by symmetry", names.at(part.mirrored.size() - 1));
  part.words += " alone";
  part.text = std::move(changed);
  part.reason.clear();
  return part;
}

void convert_answers_to_whole_model(std::vector<AnswerReading>& readings,
                                    const std::vector<AnswerRequest>& answers,
                                    const std::string& mirrored) {
  for (std::size_t i = 0; i < readings.size() && !mirrored.empty(); ++i) {
    if (answers[i].group == AnswerGroup::energy) {
      readings[i].value *= mirror_image_count(mirrored);
    } else if (answers[i].group == AnswerGroup::arc || is_odd_extreme(answers[i], mirrored)) {
      readings[i] = AnswerReading();
    }
  }
}

} // namespace spricka::program
