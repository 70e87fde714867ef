// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/hidden_search.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace spricka::fe {

namespace {

class HiddenSearch {
public:
  HiddenSearch(std::size_t dim, const HiddenBound& bounds, const UnitCubeField& value,
               const SeenValues& seen, const SearchSettings& settings)
      : dim_(dim), bounds_(bounds), value_(value), seen_(seen), set_(settings) {
    // what lies beyond the last points of a rule leaves the values seen by a part of their change
    constexpr double beyond = 0.1;
    set_.little += beyond * (seen.high - seen.low).maxCoeff();
  }

  SearchResult run(const UnitBox& all) {
    push(all, excess(all));
    while (!heap_.empty() && open_mass() > set_.room) {
      std::ranges::pop_heap(heap_, less);
      const Doubt doubt = heap_.back();
      heap_.pop_back();
      std::array<double, 3> middle{};
      double size = 0.0;
      for (std::size_t k = 0; k < dim_; ++k) {
        middle[k] = 0.5 * (doubt.box.low[k] + doubt.box.high[k]);
        size = std::max(size, doubt.box.high[k] - doubt.box.low[k]);
      }
      const base::Vec3 v = value_(middle);
      if (std::max((v - seen_.high).maxCoeff(), (seen_.low - v).maxCoeff()) > set_.little) {
        return {true, doubt.box, 0.0};
      }
      if (count_ > set_.most_bounds) {
        heap_.push_back(doubt);
        break;
      }
      if (size > least_size) {
        halve(doubt.box, middle);
      }
    }
    return {false, {}, open_mass()};
  }

private:
  static constexpr double least_size = 1e-12;
  struct Doubt {
    UnitBox box;
    double mass;
  };

  static bool less(const Doubt& a, const Doubt& b) { return a.mass < b.mass; }
  double excess(const UnitBox& box) {
    ++count_;
    return bounds_(box, seen_);
  }
  void push(const UnitBox& box, double over) {
    if (!(over > set_.little)) {
      return;
    }
    double mass = std::min(over, anything);
    for (std::size_t k = 0; k < dim_; ++k) {
      mass *= std::max(box.high[k] - box.low[k], box.high[k] == box.low[k] ? 1.0 : 0.0);
    }
    heap_.push_back({box, mass});
    std::ranges::push_heap(heap_, less);
  }
  [[nodiscard]] double open_mass() const {
    double sum = 0.0;
    for (const Doubt& d : heap_) {
      sum += d.mass < 1e-30 * anything ? d.mass : 0.0;
    }
    const bool unbounded =
        std::ranges::any_of(heap_, [](const Doubt& d) { return d.mass >= 1e-30 * anything; });
    return count_ <= set_.most_bounds && unbounded ? anything : sum;
  }
  void halve(const UnitBox& box, const std::array<double, 3>& middle) {
    std::array<UnitBox, 2> best;
    std::array<double, 2> over{};
    double least = -1.0;
    for (std::size_t k = 0; k < dim_; ++k) {
      if (box.high[k] == box.low[k]) {
        continue;
      }
      std::array<UnitBox, 2> half{box, box};
      half[0].high[k] = half[1].low[k] = middle[k];
      const std::array<double, 2> here{excess(half[0]), excess(half[1])};
      const auto doubt = [&](double v) { return v > set_.little ? std::min(v, anything) : 0.0; };
      // of equals the longer side
      const double sum =
          (doubt(here[0]) + doubt(here[1])) * (1.0 - 1e-3 * (box.high[k] - box.low[k]));
      if (least < 0.0 || sum < least) {
        least = sum;
        best = half;
        over = here;
      }
    }
    push(best[0], over[0]);
    push(best[1], over[1]);
  }

  static constexpr double anything = 1e200;
  std::size_t dim_;
  const HiddenBound& bounds_;
  const UnitCubeField& value_;
  SeenValues seen_;
  SearchSettings set_;
  std::vector<Doubt> heap_;
  int count_ = 0;
};

} // namespace

SearchResult search_hidden(std::size_t dim, const HiddenBound& bounds, const UnitCubeField& value,
                           const UnitBox& box, const SeenValues& seen,
                           const SearchSettings& settings) {
  return HiddenSearch(dim, bounds, value, seen, settings).run(box);
}

} // namespace spricka::fe
