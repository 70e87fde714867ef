// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/growth_measure.hpp"
#include "analysis/lengths/path_correction.hpp"
#include "crack/k_layout.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

/// Growth by K at places of fronts in space.
namespace spricka::analysis {

namespace {

/// K2 or K3 beyond this part of K1 is worth a word: the crack would not stay in its plane.
constexpr double much_shear = 0.25;

/// A place between two points of a front, or nothing.
struct PlaceOnFront {
  std::size_t front = 0, from = 0, to = 0;
  double part = 0.0; ///< of the way from one to the other
  double away = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool found() const { return std::isfinite(away); }
};

// No name: of any.
bool is_of(const std::string& front, const std::string& crack) {
  return crack.empty() || front == crack || front.starts_with(crack + ".");
}

// The place of a crack's fronts that is nearest to x; `front_of` and `x_of` read the records.
template <class Front, class FrontOf, class XOf>
PlaceOnFront nearest_place(const std::vector<Front>& fronts, const std::string& crack,
                           const base::Vec3& x, const std::pair<FrontOf, XOf>& read) {
  PlaceOnFront best;
  for (std::size_t f = 0; f < fronts.size(); ++f) {
    const results::FrontResult& is = read.first(fronts[f]);
    const std::size_t n = fronts[f].points.size();
    if (!is_of(is.name, crack)) {
      continue;
    }
    for (std::size_t i = 0; i + (is.closed ? 0 : 1) < n; ++i) {
      const std::size_t j = (i + 1) % n;
      const base::Vec3& a = read.second(fronts[f].points[i]);
      const base::Vec3 edge = read.second(fronts[f].points[j]) - a;
      const double part = std::clamp((x - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
      const double away = (x - a - part * edge).norm();
      if (away < best.away) {
        best = {.front = f, .from = i, .to = j, .part = part, .away = away};
      }
    }
  }
  return best;
}

PlaceOnFront place_in_step(const results::StepResult& step, const std::string& crack,
                           const base::Vec3& x) {
  const auto front_of = [](const results::FrontResult& f) -> const results::FrontResult& {
    return f;
  };
  const auto x_of = [](const results::FrontPointResult& p) -> const base::Vec3& { return p.x; };
  return nearest_place(step.fronts, crack, x, std::pair(front_of, x_of));
}

PlaceOnFront place_on_path(const results::LoadPathResult& path, const std::string& crack,
                           const base::Vec3& x) {
  const auto front_of = [](const results::LoadPathFront& f) -> const results::FrontResult& {
    return f.is;
  };
  const auto x_of = [](const results::LoadPathFrontPoint& p) -> const base::Vec3& {
    return p.is.x;
  };
  return nearest_place(path.fronts, crack, x, std::pair(front_of, x_of));
}

/// What of a front's point counts at a place.
struct PointWeight {
  std::size_t point = 0;
  double weight = 0.0;
};

// The cubic through the four points about a place (`s_of` [point] the length up to it), as K along
// a front bends between two of them; a line where the faces touch at one of them.
template <class SOf, class ClosedOf>
std::vector<PointWeight> weights_at(const results::FrontResult& front, std::size_t count,
                                    const PlaceOnFront& at, const std::pair<SOf, ClosedOf>& read) {
  constexpr std::size_t four = 4;
  std::vector<PointWeight> found{{at.from, 1.0 - at.part}, {at.to, at.part}};
  if (count < four) {
    return found;
  }
  // From the one before the two on; at an open end the first or the last four.
  const std::size_t first = front.closed
                                ? (at.from + count - 1) % count
                                : std::min(std::max<std::size_t>(at.from, 1) - 1, count - four);
  std::vector<double> s;
  std::vector<PointWeight> all;
  double place = 0.0;
  for (std::size_t k = first; k < first + four; ++k) {
    const std::size_t i = k % count;
    const double round = k < count ? 0.0 : front.length;
    s.push_back(read.first(i) + round);
    all.push_back({i, 1.0});
    if (read.second(i)) {
      return found;
    }
    if (i == at.from) {
      const std::size_t next = (i + 1) % count;
      const double after = read.first(next) + (next == 0 ? front.length : 0.0) - read.first(i);
      place = s.back() + at.part * after;
    }
  }
  for (std::size_t k = 0; k < four; ++k) {
    for (std::size_t j = 0; j < four; ++j) {
      all[k].weight *= j == k ? 1.0 : (place - s[j]) / (s[k] - s[j]);
    }
  }
  return all;
}

// By the points of a front in the results of a step.
std::vector<PointWeight> weights_at(const results::FrontResult& front, const PlaceOnFront& at) {
  const auto s_of = [&](std::size_t i) { return front.points[i].s; };
  const auto closed = [&](std::size_t i) { return front.points[i].closed; };
  return weights_at(front, front.points.size(), at, std::pair(s_of, closed));
}

// K1, K2, K3 as smooth functions along the front; `corrected`: with the estimated error of K taken
// out.
base::Vec3 smooth_K(const results::FrontResult& front, const PlaceOnFront& at, bool corrected) {
  base::Vec3 K = base::Vec3::Zero();
  for (const auto& [i, weight] : weights_at(front, at)) {
    K += weight * base::Vec3::Map(front.points[i].smooth.data());
    K[0] += corrected ? weight * estimated_error(front, i) : 0.0;
  }
  return K;
}

// A place on the curve through the points, not on its chords.
base::Vec3 place_on_curve(const results::FrontResult& front, const PlaceOnFront& at) {
  base::Vec3 x = base::Vec3::Zero();
  for (const auto& [i, weight] : weights_at(front, at)) {
    x += weight * front.points[i].x;
  }
  return x;
}

// Smooth K1 on the path, or K1 and K2 by parts.
base::PiecewiseLinear K_on_path(const results::LoadPathFront& front, const PlaceOnFront& at,
                                const base::Vec2& part) {
  const base::PiecewiseLinear& from = front.points[at.from].smooth[0];
  const auto s_of = [&](std::size_t i) { return front.points[i].is.s; };
  // Where faces touch under a load K bends by t: no cubic.
  const auto closed = [&](std::size_t i) { return front.points[i].is.closed; };
  std::vector<double> value(from.segments(), 0.0);
  std::vector<double> slope(from.segments(), 0.0);
  for (const auto& [i, weight] :
       weights_at(front.is, front.points.size(), at, std::pair(s_of, closed))) {
    for (std::size_t mode = 0; mode < 2; ++mode) {
      const double share = weight * part[static_cast<Eigen::Index>(mode)];
      const base::PiecewiseLinear& K = front.points[i].smooth[mode];
      for (std::size_t k = 0; k < value.size() && share != 0.0; ++k) {
        value[k] += share * K.at_knot(k);
        slope[k] += share * K.slope(k);
      }
    }
  }
  return {from.knots(), std::move(value), std::move(slope)};
}

// K1 or K2 there out of the K of all points of all fronts [crack::KLayout].
std::function<double(const base::Vector&)> K_at(const results::StepResult& step,
                                                const PlaceOnFront& place, int mode) {
  std::size_t first = 0;
  for (std::size_t f = 0; f < place.front; ++f) {
    first += step.fronts[f].points.size();
  }
  std::vector<PointWeight> weights = weights_at(step.fronts[place.front], place);
  return [first, mode, weights = std::move(weights)](const base::Vector& K) {
    double at = 0.0;
    for (const auto& [point, weight] : weights) {
      at += weight * K[crack::KLayout(first + point + 1, 3).at(first + point, mode)];
    }
    return at;
  };
}

} // namespace

std::optional<base::PiecewiseLinear> nearest_K1(const results::LoadPathResult& path,
                                                const base::Vec3& x) {
  const PlaceOnFront place = place_on_path(path, "", x);
  return place.found() ? std::optional(K_on_path(path.fronts[place.front], place, {1.0, 0.0}))
                       : std::nullopt;
}

bool GrowthRateEvaluator::by_front(const SolvedCrackState& at, const growth::TrackedTip& tip,
                                   const base::Vec3& aim, growth::TipStation& found) {
  const std::string& crack = at.cracks.solids[tip.line].name;
  const results::StepResult& high = at.increment.steps[largest_load_step(model_)];
  const PlaceOnFront place = place_in_step(high, crack, aim);
  if (!place.found()) {
    return no_rate(fmt::format("crack {} has no front to grow from", crack));
  }
  const results::FrontResult& front = high.fronts[place.front];
  const bool corrected = model_.growth->corrected;
  const base::Vec3 K = smooth_K(front, place, corrected);
  const base::Vec3 x = place_on_curve(front, place);
  found.x = x.x();
  found.y = x.y();
  found.z = x.z();
  found.K2_max = K[1];
  if (!at.plastic.empty()) {
    assert(at.plastic.size() == high.fronts.size());
    found.plastic = at.plastic[place.front];
  }
  if (corrected) {
    warn_of_no_bar(front.name, front.no_bar);
  }
  if (!front.invalid_reason.empty() && K[0] > 0.0) {
    warnings_.insert(
        {"W508", fmt::format("{}: K at KMAX is in doubt: {}", front.name, front.invalid_reason)});
  }
  look_at_shear(crack, K);
  const base::Vec2 part = turn(K.head<2>(), false, found);
  if (at.followed && at.followed->none.empty()) {
    const LoadHistoryResult& loads = *at.followed;
    found.K2_max = K_at(high, place, 2)(loads.last.marks[loads.grow_at]);
    const auto K1 = K_at(high, place, 1);
    const auto K2 = K_at(high, place, 2);
    return by_front_history(
        loads, tip.name, front.a,
        [part, K1, K2](const base::Vector& all) {
          return part[1] == 0.0 ? K1(all) : part[0] * K1(all) + part[1] * K2(all);
        },
        found);
  }
  if (spectrum_) {
    return by_front_spectrum(at, crack, aim, found);
  }
  const results::StepResult& low = at.increment.steps[model_.growth->kmin.index()];
  const PlaceOnFront there = place_in_step(low, crack, aim);
  if (!there.found()) {
    return no_rate(fmt::format("crack {} has no front to grow from", crack));
  }
  found.K_max = std::max(0.0, part.dot(K.head<2>()));
  found.K_min = part.dot(smooth_K(low.fronts[there.front], there, corrected).head<2>());
  const results::FrontPointResult& nearest = low.fronts[there.front].points[there.from];
  if (nearest.closed && continues_below_closing(model_)) {
    warn_of_closing(tip.name, low.fronts[there.front].a);
  }
  found.rate = found.K_max > found.K_min ? law_.growth_rate(found.K_max, found.K_min) : 0.0;
  note_order(tip.name, found.K_min > K[0] && found.K_min > 0.0);
  return true;
}

void GrowthRateEvaluator::look_at_shear(const std::string& crack, const base::Vec3& K) {
  const bool stays = model_.growth->direction == model::GrowthDirection::path;
  const double K2 = stays ? std::abs(K[1]) : 0.0;
  const double part = std::max(K2, std::abs(K[2])) / K[0];
  if (K[0] > 0.0 && part > std::max(much_shear, shear_[crack].part)) {
    shear_[crack] = {K2 > std::abs(K[2]) ? "K2" : "K3", part};
  }
}

std::set<results::Warning> GrowthRateEvaluator::warnings() const {
  std::set<results::Warning> all = warnings_;
  const bool stays = model_.growth->direction == model::GrowthDirection::path;
  for (const auto& [crack, shear] : shear_) {
    if (shear.part > 0.0) {
      all.insert(
          {"W456", fmt::format("{} grows {} although {} is up to {:.2f} of K1; the law is given K1 "
                               "{}",
                               crack, stays ? "in its plane" : "as K1 and K2 turn it", shear.what,
                               shear.part, stays ? "alone" : "of the turned crack alone")});
    }
  }
  return all;
}

bool GrowthRateEvaluator::by_front_spectrum(const SolvedCrackState& at, const std::string& crack,
                                            const base::Vec3& aim, growth::TipStation& found) {
  const model::SpectrumDefinition& card = model_.spectra[*model_.growth->spectrum];
  const results::LoadPathResult& path = *at.path;
  if (model_.growth->corrected) {
    for (const results::FrontResult& front :
         at.increment.steps[model_.load_paths[card.path].from.index()].fronts) {
      warn_of_no_bar(front.name, front.no_bar);
    }
  }
  const PlaceOnFront place = place_on_path(path, crack, aim);
  if (!place.found() || path.t.empty() || path.t.back() < spectrum_->highest()) {
    return no_rate(
        fmt::format("spectrum {}: there is no K up to t = {:.6g}, load path {} ends before: {}",
                    card.name, spectrum_->highest(), path.name, path.stopped));
  }
  const results::LoadPathFront& front = path.fronts[place.front];
  // The way on is that at the largest load; K of the whole path is that at the tip of the kink.
  const base::PiecewiseLinear K1 = K_on_path(front, place, {1.0, 0.0});
  const base::PiecewiseLinear K2 = K_on_path(front, place, {0.0, 1.0});
  const double peak = locate_maximum(K1, spectrum_->lowest(), spectrum_->highest());
  const base::PiecewiseLinear K = K_on_path(front, place, turn({K1(peak), K2(peak)}, false, found));
  if (continues_below_closing(model_) && faces_touch(front.points[place.from].smooth[0])) {
    warn_of_closing(front.is.name, front.is.a);
  }
  const auto [low, high] = spectrum_->extreme_K(K);
  found.K_min = low;
  found.K_max = std::max(0.0, high);
  found.rate = spectrum_->growth_per_pass(law_, K);
  counted_on_K_ = counted_on_K_ || spectrum_->counts_on_K(K);
  if (std::isnan(found.rate)) {
    return no_rate(fmt::format("spectrum {}: the growth of a pass is not a number on crack {}",
                               card.name, crack));
  }
  return true;
}

} // namespace spricka::analysis
