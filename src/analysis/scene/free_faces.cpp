// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/scene/free_faces.hpp"

#include "model/model.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::analysis {

namespace {

// A jump of K becomes a ramp over this part of the path: functions of a path are continuous.
constexpr double ramp = 1e-9;
// Differences below this part of the largest K are none.
constexpr double same_K = 1e-9;

/// Pieces of a function from left to right, each linear; put together in the end.
class Pieces {
public:
  Pieces(double first, double last, double size) : width_(ramp * (last - first)), size_(size) {
    knots_.push_back(first);
  }

  // The function from the last knot on to `to`, from one value to the other.
  void add(double to, double begin, double end) {
    const double from = knots_.back();
    if (!(to > from)) {
      return;
    }
    const double slope = (end - begin) / (to - from);
    const bool jumps = !values_.empty() && std::abs(begin - end_) > same_K * size_;
    // No more than half of the piece, which keeps its own slope behind the ramp.
    const double width = std::min(width_, 0.5 * (to - from));
    if (jumps && from + width > from) {
      values_.push_back(end_);
      slopes_.push_back((begin + slope * width - end_) / width);
      knots_.push_back(from + width);
      begin += slope * width;
    }
    values_.push_back(begin);
    slopes_.push_back(slope);
    knots_.push_back(to);
    end_ = end;
  }

  base::PiecewiseLinear take() {
    return {std::move(knots_), std::move(values_), std::move(slopes_)};
  }

private:
  std::vector<double> knots_, values_, slopes_;
  double width_, size_;
  double end_ = 0.0; ///< value where the pieces end so far
};

// Of one segment, which holds `inside`, extended to t.
double on_segment(const base::PiecewiseLinear& f, double inside, double t) {
  const std::size_t s = f.find_segment(inside);
  return f.segment_start_values()[s] + (t - f.knots()[s]) * f.slope(s);
}

} // namespace

bool continues_K_below_closing(const model::Model& model) {
  return model.growth && model.growth->knows_negative_ratio() &&
         std::ranges::any_of(model.cracks, &model::CrackDefinition::faces_in_contact);
}

const results::FrontResult*
find_tip_overlap_result(const std::optional<OverlappingFaceResults>& free, std::size_t step,
                        const std::string& name) {
  if (!free || step >= free->steps.size()) {
    return nullptr;
  }
  const std::vector<results::FrontResult>& tips = free->steps[step];
  const auto found = std::ranges::find(tips, name, &results::FrontResult::name);
  return found == tips.end() || found->two_materials ? nullptr : &*found;
}

std::optional<base::PiecewiseLinear>
continue_K_with_overlapping_faces(const base::PiecewiseLinear& K, const base::PiecewiseLinear& free,
                                  double to) {
  if (free.empty() || free.knots().back() < std::min(to, K.knots().back())) {
    return std::nullopt;
  }
  // Both paths may end early, where nothing holds a body.
  const double last = std::min(K.knots().back(), free.knots().back());
  std::vector<double> knots = K.knots();
  knots.insert(knots.end(), free.knots().begin(), free.knots().end());
  std::ranges::sort(knots);
  knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
  const double size = std::max(
      {std::abs(K.smallest_value()), std::abs(K.largest_value()), std::abs(free.smallest_value())});
  Pieces pieces(knots.front(), last, size);
  for (std::size_t i = 0; i + 1 < knots.size() && knots[i] < last; ++i) {
    const double from = knots[i];
    const double end = knots[i + 1];
    const double inside = 0.5 * (from + end);
    const auto add = [&](double t0, double t1) { // on which `free` keeps its sign
      const bool below = on_segment(free, inside, 0.5 * (t0 + t1)) < 0.0;
      const base::PiecewiseLinear& f = below ? free : K;
      pieces.add(t1, on_segment(f, inside, t0), on_segment(f, inside, t1));
    };
    const double free0 = on_segment(free, inside, from);
    const double free1 = on_segment(free, inside, end);
    if (free0 * free1 < 0.0) {
      // The sign changes within: K of overlapping faces counts on the negative side only.
      const double zero = from + free0 / (free0 - free1) * (end - from);
      add(from, zero);
      add(zero, end);
    } else {
      add(from, end);
    }
  }
  return pieces.take();
}

} // namespace spricka::analysis
