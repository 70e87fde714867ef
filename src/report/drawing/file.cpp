// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/file.hpp"

#include "base/output_file.hpp"

namespace spricka::report {

void write_file(const std::filesystem::path& file, std::string_view bytes) {
  base::write_atomically(file, bytes);
}

} // namespace spricka::report
