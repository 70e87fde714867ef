// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/trials/scratch_folder.hpp"

#include <cerrno>
#include <string>
#include <system_error>

#include <stdlib.h> // NOLINT(modernize-deprecated-headers): mkdtemp is of POSIX

namespace spricka::program {

ScratchFolder::ScratchFolder(const std::filesystem::path& prefix, bool keep) : keep_(keep) {
  std::string name = prefix.string() + ".XXXXXX";
  if (::mkdtemp(name.data()) == nullptr) {
    throw std::system_error(errno, std::generic_category(), name);
  }
  path_ = name;
}

void ScratchFolder::remove() const {
  std::error_code ignored;
  if (!keep_) {
    std::filesystem::remove_all(path_, ignored);
  }
}

} // namespace spricka::program
