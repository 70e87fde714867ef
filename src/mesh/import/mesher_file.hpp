// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "mesh/import/import_request.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spricka::mesh {

/// The file of an $IMPORT card on its way to the mesher process; what is wrong is reported at the
/// card.
class MesherFile {
public:
  MesherFile(const ImportRequest& request, base::Diagnostics& diagnostics)
      : request_(request), diagnostics_(diagnostics) {}

  /// Reports an error at the card: code "E..", text behind the file's name, hint.
  void report_error(std::string code, std::string_view text, std::string hint = {});
  /// The file's text; empty after an error, as where it has more than `most` bytes.
  std::optional<std::string> read_text(std::size_t most);
  /// The file's name as gmsh may see it, as its messages hold it; `ending` as ".geo".
  [[nodiscard]] std::string plain_name(std::string_view ending) const;
  /// The mesher's answer to a request; empty after an error. `remedy` is the hint where gmsh
  /// crashed.
  std::optional<std::string> ask(std::string_view request, const char* remedy);
  /// Reports an answer that holds no mesh, and ends the mesher, as nobody knows why.
  void refuse_answer();
  /// Reports what gmsh itself calls errors, each once; true if there are none. Else the mesher is
  /// ended, as nobody knows what they left behind.
  bool report_gmsh_errors(const std::vector<std::string>& errors, bool gave_up);
  /// Reports gmsh's warnings at the card, the first few of them.
  void report_gmsh_warnings(const std::vector<std::string>& warnings);

private:
  const ImportRequest& request_;
  base::Diagnostics& diagnostics_;
};

} // namespace spricka::mesh
