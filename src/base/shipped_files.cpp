// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/shipped_files.hpp"

#include <system_error>

#include <dlfcn.h>
#include <link.h>

namespace spricka::base {

namespace {

namespace fs = std::filesystem;

// The program, or the shared library that this is part of.
fs::path file_of_this_code() {
  std::error_code unknown;
  Dl_info info{};
  void* map = nullptr;
  const auto* const here = reinterpret_cast<const void*>(&file_of_this_code);
  if (dladdr1(here, &info, &map, RTLD_DL_LINKMAP) != 0 && map != nullptr) {
    const std::string library = static_cast<const link_map*>(map)->l_name;
    if (!library.empty()) { // the program itself has no name there
      return fs::canonical(library, unknown);
    }
  }
  return fs::read_symlink("/proc/self/exe", unknown);
}

} // namespace

fs::path find_shipped_file(const fs::path& relative) {
  fs::path folder = file_of_this_code().parent_path();
  while (!folder.empty()) {
    std::error_code unknown;
    fs::path found = fs::canonical(folder / relative, unknown);
    if (!unknown) {
      return found;
    }
    if (folder == folder.parent_path()) {
      break;
    }
    folder = folder.parent_path();
  }
  return {};
}

} // namespace spricka::base
