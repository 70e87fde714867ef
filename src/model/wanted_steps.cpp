// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/wanted_steps.hpp"

#include "model/model.hpp"

#include <numeric>

namespace spricka::model {

std::vector<std::size_t> output_step_indices(const Model& model, const OutputFileRequest& output,
                                             bool last_increment) {
  std::vector<std::size_t> steps;
  if (output.every == OutputFrequency::step) {
    steps.resize(model.steps.size());
    std::iota(steps.begin(), steps.end(), std::size_t{0});
  } else if (output.every == OutputFrequency::increment || last_increment) {
    const bool growing = model.growth && model.growth->kmax.valid();
    steps.push_back(growing ? model.growth->kmax.index() : model.steps.size() - 1);
  }
  return steps;
}

} // namespace spricka::model
