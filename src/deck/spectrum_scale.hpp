// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/context.hpp"
#include "model/model.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace spricka::deck {

/// From the loads that $SPECTRUM lists to places t on its load path: keys FACTOR, OFFSET, AT0, AT1,
/// VALUES.
class SpectrumScale {
public:
  /// Mistakes are reported.
  SpectrumScale(DeckContext& context, const CheckedCard& card);

  [[nodiscard]] bool sound() const { return sound_; }
  /// Where the loads are no places t.
  [[nodiscard]] const std::optional<model::SpectrumValues>& values() const { return values_; }
  /// The place t of a number as it is listed.
  [[nodiscard]] double place(double listed) const { return slope_ * listed + start_; }
  /// The place t of a load, without FACTOR and OFFSET.
  [[nodiscard]] double place_of_load(double load) const {
    return values_ ? values_->place_of(load) : load;
  }
  /// The range of t of a range of loads, > 0.
  [[nodiscard]] double range_of_loads(double range) const;
  /// "load 150 MPa (t = 1.25)", or "t = 1.25".
  [[nodiscard]] std::string describe(double t) const;
  /// The number of a key that counts as the loads do; empty: it is not there.
  std::optional<double> load_of_key(std::string_view key);

private:
  [[nodiscard]] std::string unit_label() const;

  DeckContext& context_;
  const CheckedCard& card_;
  std::optional<model::SpectrumValues> values_;
  double slope_ = 1.0, start_ = 0.0; ///< of t over a listed number
  bool sound_ = true;
};

} // namespace spricka::deck
