// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/output_unit.hpp"
#include "results/results.hpp"

#include <string>

namespace spricka::report {

/// "630.68": as many decimals as a bar has meaning, six digits without a bar.
std::string k_by_bar_text(double K, double size);

/// "630.68 +- 0.21": as many decimals as the bar has meaning.
std::string k_and_bar_text(double K, double size);

/// "630.68 +- 0.21 (mesh 0.16, contact edge 0.02, floor 0.03); raw 630.44": as many decimals as the
/// bar has meaning. `raw`: K as the mesh has it; without its estimated error taken out the text
/// ends in words that say so.
std::string k_with_bar_text(double K, double raw, const results::KErrorBar& bar);

/// Half width of an error bar, two digits that count: "290", "0.053", "1.2e-05".
std::string format_error_bar(double size);

/// A line for K1 and one for K2 of every tip and step, in that unit; empty without bars and in
/// space.
std::string k_error_bar_lines(const results::CrackLengthResult& increment,
                              const base::OutputUnit& unit);

} // namespace spricka::report
