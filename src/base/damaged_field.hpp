// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <stdexcept>
#include <string>

namespace spricka::base {

/// A field of a state that was kept in a file and is not what was kept: it is missing, has another
/// length, or names what is not there. Thrown by what is restored from named arrays, and caught
/// where the file is known (analysis/lengths/resume.hpp).
class CorruptStoredField : public std::runtime_error {
public:
  CorruptStoredField(const std::string& field, const std::string& why)
      : std::runtime_error(field + ": " + why) {}
};

} // namespace spricka::base
