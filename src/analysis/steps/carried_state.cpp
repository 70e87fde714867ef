// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/steps/carried_state.hpp"

#include "base/hasher.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

// Host nodes keep their numbers from length to length, so that rows can be told by them.
std::vector<std::int64_t> key_of(const Discretisation& scene, std::size_t contact) {
  base::Hasher hash;
  for (std::size_t r = scene.table.first[contact]; r < scene.table.first[contact + 1]; ++r) {
    const contact::ConstraintRow& row = scene.contact_row(r);
    hash.value(row.node.value);
    hash.value(row.tangential);
    hash.value(row.area);
    hash.value(row.entries.size());
    for (const contact::RowEntry& entry : row.entries) {
      hash.value(entry.node.value);
      for (const double w : entry.weight) {
        hash.value(w);
      }
    }
  }
  const auto [high, low] = hash.digest();
  return {static_cast<std::int64_t>(high), static_cast<std::int64_t>(low)};
}

std::string name_of(std::size_t contact, const std::string& what) {
  return fmt::format("carried.{}.{}", contact, what);
}

std::vector<double> as_list(const base::Vector& v) {
  return {v.data(), v.data() + v.size()};
}

base::Vector as_vector(const std::vector<double>& v) {
  return Eigen::Map<const base::Vector>(v.data(), static_cast<Eigen::Index>(v.size()));
}

} // namespace

void InheritedContactState::store_state(const Discretisation& scene, const StepSolverState& place) {
  contacts_.clear();
  for (std::size_t c = 0; c < scene.contacts.size(); ++c) {
    // Faces of a crack are other nodes at each length: what they did is not carried.
    if (std::ranges::any_of(scene.crack_face_pairs, [&](const auto& crack_face) {
          return crack_face && crack_face->pair == c;
        })) {
      continue;
    }
    InheritedContactPair& pair = contacts_.emplace_back();
    pair.key = key_of(scene, c);
    pair.fit = place.factors.fit[c];
    pair.mounted = place.factors.mounted[c];
    pair.work = place.friction.work[c];
    for (std::size_t r = scene.table.first[c]; r < scene.table.first[c + 1]; ++r) {
      pair.offset.push_back(place.offset[static_cast<Eigen::Index>(r)]);
      pair.slip.push_back(place.friction.slip[r]);
      pair.path.push_back(place.friction.path[r]);
      pair.pressure.push_back(place.friction.pressure[r]);
      pair.touch.push_back(static_cast<std::int64_t>(place.friction.touch[r]));
    }
  }
  case_factor_ = as_list(place.factors.case_factor);
  alpha_ = as_list(place.friction.alpha);
}

std::optional<StepSolverState> InheritedContactState::put(const Discretisation& scene,
                                                          const StepSolverState& now,
                                                          base::OptionalFailure& trouble) const {
  StepSolverState place = now;
  // Rows may have other numbers here: the next solution begins without closed ones.
  place.closed.clear();
  if (static_cast<Eigen::Index>(case_factor_.size()) == now.factors.case_factor.size()) {
    place.factors.case_factor = as_vector(case_factor_);
  }
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    const InheritedContactPair& pair = contacts_[c];
    const bool is_there = c < scene.contacts.size();
    if (!is_there || pair.key != key_of(scene, c) ||
        pair.offset.size() != scene.table.first[c + 1] - scene.table.first[c]) {
      trouble = base::OperationFailure{
          .kind = base::ProgramOutcome::not_solvable,
          .why = fmt::format("HISTORY=CONTINUE: the surfaces of contact {} are meshed differently "
                             "at this length, so that what slipped at the last one cannot be "
                             "carried over",
                             is_there ? scene.contacts[c].name : std::to_string(c + 1))};
      return std::nullopt;
    }
    place.factors.fit[c] = pair.fit;
    place.factors.mounted[c] = pair.mounted;
    place.friction.work[c] = pair.work;
    const std::size_t first = scene.table.first[c];
    for (std::size_t r = 0; r < pair.offset.size(); ++r) {
      place.offset[static_cast<Eigen::Index>(first + r)] = pair.offset[r];
      place.friction.slip[first + r] = pair.slip[r];
      place.friction.path[first + r] = pair.path[r];
      place.friction.pressure[first + r] = pair.pressure[r];
      place.friction.touch[first + r] = static_cast<solve::SlipState>(pair.touch[r]);
    }
  }
  // Where the modes are others the anchor of loose ones (solve.24) stays that of this length.
  if (static_cast<Eigen::Index>(alpha_.size()) == now.friction.alpha.size()) {
    place.friction.alpha = as_vector(alpha_);
  }
  return place;
}

void InheritedContactState::save_state(results::NamedArrays& arrays) const {
  if (empty()) {
    return;
  }
  arrays.integers["carried.contacts"] = {static_cast<std::int64_t>(contacts_.size())};
  arrays.reals["carried.case_factor"] = case_factor_;
  arrays.reals["carried.alpha"] = alpha_;
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    const InheritedContactPair& pair = contacts_[c];
    arrays.integers[name_of(c, "key")] = pair.key;
    arrays.integers[name_of(c, "touch")] = pair.touch;
    arrays.reals[name_of(c, "offset")] = pair.offset;
    arrays.reals[name_of(c, "slip")] = pair.slip;
    arrays.reals[name_of(c, "path")] = pair.path;
    arrays.reals[name_of(c, "pressure")] = pair.pressure;
    arrays.reals[name_of(c, "state")] = {pair.work, pair.fit, pair.mounted ? 1.0 : 0.0};
  }
}

InheritedContactState InheritedContactState::restore_state(const results::NamedArrays& arrays) {
  InheritedContactState state;
  if (!arrays.integers.contains("carried.contacts")) {
    return state;
  }
  // what is empty may have been left out
  const auto reals = [&](const std::string& name) {
    const auto found = arrays.reals.find(name);
    return found == arrays.reals.end() ? std::vector<double>() : found->second;
  };
  const auto integers = [&](const std::string& name) {
    const auto found = arrays.integers.find(name);
    return found == arrays.integers.end() ? std::vector<std::int64_t>() : found->second;
  };
  state.case_factor_ = reals("carried.case_factor");
  state.alpha_ = reals("carried.alpha");
  for (std::size_t c = 0;
       c <
       static_cast<std::size_t>(results::required_array(arrays.integers, "carried.contacts", 1)[0]);
       ++c) {
    const std::vector<double>& of_pair =
        results::required_array(arrays.reals, name_of(c, "state"), 3);
    state.contacts_.push_back({.key = integers(name_of(c, "key")),
                               .offset = reals(name_of(c, "offset")),
                               .slip = reals(name_of(c, "slip")),
                               .path = reals(name_of(c, "path")),
                               .pressure = reals(name_of(c, "pressure")),
                               .touch = integers(name_of(c, "touch")),
                               .work = of_pair[0],
                               .fit = of_pair[1],
                               .mounted = of_pair[2] != 0.0});
    InheritedContactPair& pair = state.contacts_.back();
    pair.pressure.resize(pair.slip.size()); // all zeros may have been left out
    const std::size_t rows = pair.offset.size();
    const bool known = std::ranges::all_of(pair.touch, [](std::int64_t touch) {
      return touch >= 0 && touch <= static_cast<std::int64_t>(solve::SlipState::backward);
    });
    if (pair.slip.size() != rows || pair.path.size() != rows || pair.touch.size() != rows ||
        !known) {
      throw base::CorruptStoredField(name_of(c, "slip"), "it is incomplete");
    }
  }
  return state;
}

} // namespace spricka::analysis
