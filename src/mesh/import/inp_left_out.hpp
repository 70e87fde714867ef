// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/import/import_request.hpp"
#include "mesh/import/inp_data.hpp"

#include <string>

namespace spricka::mesh {

/// The cards of a file that are passed over, each kind with how many there are and the first one's
/// line, without those that the request takes otherwise: "*TIE (2, line 7261), *AMPLITUDE (1, line
/// 12)".
struct InpLeftOutText {
  std::string of_no_say;    ///< loads, output, heat, numerics
  std::string of_the_model; ///< what joins or holds bodies, materials that are not elastic
};
InpLeftOutText describe_left_out(const InpData& data, const ImportRequest& request);

} // namespace spricka::mesh
