// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace spricka::results {

/// A constant of a geometry script as a deck imports it.
struct ReportedScriptConstant {
  std::string file;  ///< without its folder; with the net, if it stands in one
  std::string name;  ///< as the script writes it
  std::string value; ///< a number, or the words of the script
  std::string from;  ///< "deck" or "file"
};

} // namespace spricka::results
