// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/halves.hpp"

#include "model/model.hpp"
#include "sense/half_model.hpp"
#include "sense/mirrors.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace spricka::program {

PartOfModel part_of_model(const model::Model& model, const deck::DeckText& text) {
  PartOfModel part;
  deck::DeckText changed = text;
  for (const results::MirrorPreview& mirror : sense::find_mirrors(model)) {
    const bool there = std::ranges::any_of(
        model.mirrors, [&](const model::MirrorPlane& plane) { return plane.axis == mirror.axis; });
    const char axis = "xyz"[mirror.axis];
    std::string against = mirror.against;
    if (against.empty() && !there) {
      against = sense::against_half(model, mirror.axis);
    }
    if (there || !against.empty()) {
      if (!there) {
        part.reason = fmt::format("{} = {:.4g}: {}", axis, mirror.at, against);
      }
      continue;
    }
    deck::DeckCard card;
    card.name = "SYMMETRY";
    card.set("NORMAL", std::string(1, "XYZ"[mirror.axis]));
    append(changed, std::move(card));
    part.parts *= 2;
    part.words += fmt::format("{}{} >= {:.4g}", part.words.empty() ? "" : ", ", axis, mirror.at);
  }
  if (part.parts == 1) {
    part.reason = part.reason.empty() ? "the bodies have no plane of symmetry" : part.reason;
    part.name = "half by symmetry";
    return part;
  }
  constexpr std::array names{"half", "quarter", "eighth"};
  const std::size_t planes = part.parts == 2 ? 0 : part.parts == 4 ? 1 : 2;
  part.name = fmt::format("{} by symmetry", names.at(planes));
  part.words += " alone";
  part.text = std::move(changed);
  part.reason.clear();
  return part;
}

void tell_of_whole(std::vector<Reading>& readings, const std::vector<Answer>& answers, int parts) {
  for (std::size_t i = 0; i < readings.size() && parts > 1; ++i) {
    if (answers[i].group == AnswerGroup::energy) {
      readings[i].value *= parts;
    } else if (answers[i].group == AnswerGroup::arc) {
      readings[i] = Reading();
    }
  }
}

} // namespace spricka::program
