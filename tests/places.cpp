// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/places.hpp"

#include <cstdlib>

namespace spricka::test {

// The only object of the tests that knows the folder it was built in: a compiler's cache can give
// all others to a clone elsewhere.
std::string source_folder() {
  return SOURCE_FOLDER;
}

std::string decks_folder() {
  return SOURCE_FOLDER "/decks";
}

std::string program_file() {
  return PROGRAM;
}

bool full_size() {
  return std::getenv("SPRICKA_FULL") != nullptr; // NOLINT(concurrency-mt-unsafe)
}

} // namespace spricka::test
