// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "results/results.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace spricka::sense {

/// A warning about a run as a whole.
struct RunWarning {
  std::string_view code;
  std::string text;
};

/// What only the whole run shows: contacts that press nowhere in any step (W571), lives that no
/// machine sees (W572), tests whose readings all lie outside the computed lengths (W573), cracks
/// at a contact whose faces touch all along the front in every step (W575). Takes
/// the tests as they are in `run`.
std::vector<RunWarning> find_run_warnings(const model::Model& model, const results::RunResult& run);

} // namespace spricka::sense
