// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/nastran_fields.hpp"

#include "mesh/import/inp_text.hpp"
#include "mesh/set_name.hpp"

#include <fmt/format.h>

namespace spricka::mesh {

std::string_view NastranFields::text(std::size_t at) const {
  return at < card_.fields.size() ? std::string_view(card_.fields[at].text) : std::string_view();
}

void NastranFields::complain(const std::string& words) {
  sound_ = false;
  complain_(card_.place, fmt::format("{}: {}", card_.name, words));
}

void NastranFields::complain_of(std::size_t at, std::string_view what, std::string_view wanted) {
  sound_ = false;
  if (is_blank(at)) {
    complain_(card_.place, fmt::format("{}: {} is not given", card_.name, what));
    return;
  }
  const NastranField& field = card_.fields[at];
  complain_(field.place, fmt::format("{}: {} in column {} is '{}', which is no {}", card_.name,
                                     what, field.column, field.text, wanted));
}

base::Label NastranFields::label(std::size_t at, std::string_view what) {
  const auto value = parse_inp_integer(text(at));
  if (value && *value > 0) {
    return *value;
  }
  complain_of(at, what, "positive whole number");
  return 0;
}

base::Label NastranFields::label_or(std::size_t at, std::string_view what, base::Label otherwise) {
  if (is_blank(at)) {
    return otherwise;
  }
  const auto value = parse_inp_integer(text(at));
  if (value && *value >= 0) {
    return *value;
  }
  complain_of(at, what, "whole number");
  return otherwise;
}

double NastranFields::real_or(std::size_t at, std::string_view what, double otherwise) {
  if (is_blank(at)) {
    return otherwise;
  }
  if (const auto value = parse_nastran_real(text(at))) {
    return *value;
  }
  complain_of(at, what, "number");
  return otherwise;
}

std::vector<NastranBulk::LabelRange> NastranFields::ranges(std::size_t from,
                                                           std::string_view what) {
  std::vector<NastranBulk::LabelRange> ranges;
  bool through = false;
  for (std::size_t at = from; at < count() && sound_; ++at) {
    if (is_blank(at)) {
      continue;
    }
    if (upper_case(text(at)) == "THRU" && !ranges.empty() && !through) {
      through = true;
      continue;
    }
    const base::Label number = label(at, what);
    if (through && sound_ && number < ranges.back().first) {
      complain(fmt::format("{} THRU {} runs downwards", ranges.back().first, number));
    }
    if (through) {
      ranges.back().second = number;
    } else {
      ranges.emplace_back(number, number);
    }
    through = false;
  }
  if (through && sound_) {
    complain("THRU ends the list");
  }
  return ranges;
}

} // namespace spricka::mesh
