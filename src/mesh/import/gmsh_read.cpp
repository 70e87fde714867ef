// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/gmsh_read.hpp"

#include "mesh/import/mesher_file.hpp"
#include "mesh/import/msh_check.hpp"
#include "mesh/import/script_text.hpp"
#include "mesh/import/step_check.hpp"
#include "mesh/link/mesher_limits.hpp"
#include "mesh/link/mesher_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

namespace spricka::mesh {
namespace {

/// No script that a person or a program writes is longer [bytes].
constexpr std::size_t longest_script = std::size_t{64} << 20U;
constexpr std::size_t most_messages = 20;

class GmshFileReader {
public:
  GmshFileReader(const ImportRequest& request, base::Diagnostics& diagnostics)
      : request_(request), diagnostics_(diagnostics), file_(request, diagnostics) {}

  GmshReadResult run() {
    GmshReadResult result;
    if (prepare() && ask()) {
      result.model = std::move(from_);
    }
    result.constants = std::move(constants_);
    return result;
  }

private:
  [[nodiscard]] std::string file_name() const { return request_.file.filename().string(); }

  /// What is sent to the mesher; false if there is no need to.
  bool prepare() {
    import_.script = request_.format == ImportFormat::geo;
    std::optional<std::string> text =
        file_.read_text(import_.script ? longest_script : mesher_limits().memory / 4);
    if (!text) {
      return false;
    }
    import_.text = *std::move(text);
    import_.quadratic = request_.quadratic;
    import_.size = request_.size;
    if (request_.format == ImportFormat::step) { // its text was looked through with its solids
      import_.name = file_.plain_name(".step");
      import_.quadratic = true;
      import_.step = request_.step;
      return true;
    }
    if (is_step_text(import_.text)) {
      file_.report_error("E331", "it is a STEP file", "FORMAT=STEP");
      return false;
    }
    import_.name = file_.plain_name(import_.script ? ".geo" : ".msh");
    if (!import_.script) {
      const std::string trouble = find_msh_format_error(import_.text);
      if (!trouble.empty()) {
        file_.report_error("E331", trouble);
      }
      return trouble.empty();
    }
    return prepare_script();
  }

  bool prepare_script() {
    const ScriptScan scan = scan_script(import_.text);
    for (std::size_t i = 0; i < std::min(most_messages, scan.outreach.size()); ++i) {
      const ForbiddenStatement& o = scan.outreach[i];
      diagnostics_.error(request_.span, "E480",
                         fmt::format("{}:{}: {} {}, which a script may not do here", file_name(),
                                     o.line, o.word, o.does),
                         o.remedy);
    }
    for (std::size_t i = 0; i < std::min(most_messages, scan.passed_over.size()); ++i) {
      const ForbiddenStatement& o = scan.passed_over[i];
      diagnostics_.warning(
          request_.span, "W482",
          fmt::format("{}:{}: {} {}, and is passed over", file_name(), o.line, o.word, o.does));
    }
    const std::size_t errors = diagnostics_.error_count();
    PreparedScript script =
        prepare_script_with_parameters(import_.text, scan, request_, diagnostics_);
    import_.text = std::move(script.text);
    constants_ = std::move(script.constants);
    for (const GeometryScriptConstant& constant : constants_) {
      import_.constants.push_back(constant.name);
    }
    return scan.outreach.empty() && diagnostics_.error_count() == errors;
  }

  /// The model that gmsh makes of the file.
  bool ask() {
    const std::optional<std::string> answer =
        file_.ask(encode_import_request(import_),
                  import_.script ? "is the geometry sound for all values of its constants?"
                                 : "the file is damaged");
    if (!answer) {
      return false;
    }
    ByteReader in(*answer);
    if (in.read_value<MesherFrameKind>() != MesherFrameKind::model ||
        !decode_model_answer(in, from_)) {
      from_ = {};
      file_.refuse_answer();
      return false;
    }
    take_values();
    return file_.report_gmsh_errors(from_.errors, from_.gave_up);
  }

  void take_values() {
    for (const auto& [name, value] : from_.constants) {
      for (GeometryScriptConstant& constant : constants_) {
        if (constant.name == name) {
          constant.value = value;
        }
      }
    }
  }

  const ImportRequest& request_;
  base::Diagnostics& diagnostics_;
  MesherFile file_;
  MesherImportRequest import_;
  GmshModel from_;
  std::vector<GeometryScriptConstant> constants_;
};

} // namespace

GmshReadResult read_by_gmsh(const ImportRequest& request, base::Diagnostics& diagnostics) {
  return GmshFileReader(request, diagnostics).run();
}

} // namespace spricka::mesh
