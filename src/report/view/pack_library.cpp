// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/view/packed_text.hpp"

#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <string>

/// pack_library SOURCE FILE ..: the C++ source in which the files, one after the other, are the
/// string embedded::packed_library of embedded.hpp. The build runs it.
int main(int argc, char** argv) {
  try {
    std::string library;
    for (int i = 2; i < argc; ++i) {
      std::ifstream file(argv[i], std::ios::binary);
      library.append(std::istreambuf_iterator<char>(file), {}).append("\n");
      if (!file) {
        std::fprintf(stderr, "pack_library: cannot read %s\n", argv[i]);
        return 1;
      }
    }
    std::ofstream source(argc > 1 ? argv[1] : "");
    source << "#include \"report/view/embedded.hpp\"\n\n"
              "namespace spricka::report::embedded {\n\n"
              "const std::string_view packed_library = \""
           << spricka::report::packed_text(library, spricka::base::RepetitionSearch::thorough)
           << "\";\n\n} // namespace spricka::report::embedded\n";
    return source.flush() ? 0 : 1;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "pack_library: %s\n", e.what());
    return 1;
  }
}
