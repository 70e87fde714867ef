// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/verify/decks_folder.hpp"

#include "program/trials/child_run.hpp"

#include <algorithm>
#include <system_error>

namespace spricka::program {

std::filesystem::path shipped_decks() {
  namespace fs = std::filesystem;
  const fs::path self = own_program();
  const fs::path built = fs::path(SPRICKA_BUILD_TREE);
  const bool in_build =
      std::mismatch(built.begin(), built.end(), self.begin(), self.end()).first == built.end();
  const fs::path decks = in_build
                             ? fs::path(SPRICKA_SOURCE_TREE) / "decks"
                             : self.parent_path().parent_path() / "share" / "spricka" / "decks";
  std::error_code unknown;
  return fs::is_directory(decks, unknown) ? decks : fs::path();
}

} // namespace spricka::program
