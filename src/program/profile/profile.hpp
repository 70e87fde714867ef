// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/lengths/recorder.hpp"
#include "base/clock.hpp"
#include "base/source.hpp"
#include "model/forward.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace spricka::program {

inline constexpr const char* profile_name = "profile.csv";
inline constexpr const char* trace_name = "trace.json";

/// Takes down from now on what a run costs, the requests to its mesher with it; of a run that began
/// with the process what was before this, too.
std::shared_ptr<analysis::ProfileRecorder> begin_profile();
/// The same for a run that began with the process: what was before `since` counts too.
std::shared_ptr<analysis::ProfileRecorder> begin_profile_of_process(const base::Stopwatch& since);

/// What a profile comes to.
struct ProfileTexts {
  std::string table; ///< for a terminal
  std::string csv, trace;
};
/// The run is over: `written` [bytes] stand in its folder. Finds the floor of the deck, which takes
/// its time.
ProfileTexts end_profile(analysis::ProfileRecorder& recorder, const base::SourceTexts& sources,
                         const model::Model& model, std::uintmax_t written);

} // namespace spricka::program
