// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/gmsh_read.hpp"

#include "mesh/import/msh_check.hpp"
#include "mesh/import/script_text.hpp"
#include "mesh/link/mesher_limits.hpp"
#include "mesh/link/mesher_link.hpp"
#include "mesh/link/mesher_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace spricka::mesh {
namespace {

/// No script that a person or a program writes is longer [bytes].
constexpr std::size_t longest_script = std::size_t{64} << 20U;
constexpr std::size_t most_messages = 20;

class GmshFileReader {
public:
  GmshFileReader(const ImportRequest& request, base::Diagnostics& diagnostics)
      : request_(request), diagnostics_(diagnostics) {}

  GmshReadResult run() {
    GmshReadResult result;
    if (prepare() && ask()) {
      result.model = std::move(from_);
    }
    result.constants = std::move(constants_);
    return result;
  }

private:
  void error(std::string code, std::string text, std::string hint = {}) {
    diagnostics_.error(request_.span, std::move(code), std::move(text), std::move(hint));
  }
  [[nodiscard]] std::string file_name() const { return request_.file.filename().string(); }

  /// What is sent to the mesher; false if there is no need to.
  bool prepare() {
    import_.script = request_.format == ImportFormat::geo;
    const std::size_t most = import_.script ? longest_script : mesher_limits().memory / 4;
    if (!read_text(most)) {
      return false;
    }
    import_.name = plain_name();
    import_.quadratic = request_.quadratic;
    import_.size = request_.size;
    if (!import_.script) {
      const std::string trouble = find_msh_format_error(import_.text);
      if (!trouble.empty()) {
        error("E331", fmt::format("{}: {}", file_name(), trouble));
      }
      return trouble.empty();
    }
    return prepare_script();
  }

  bool read_text(std::size_t most) {
    std::ifstream in(request_.file, std::ios::binary);
    constexpr std::size_t chunk = std::size_t{1} << 20U;
    while (in && import_.text.size() <= most) {
      const std::size_t filled = import_.text.size();
      import_.text.resize(filled + chunk);
      in.read(import_.text.data() + filled, chunk);
      import_.text.resize(filled + static_cast<std::size_t>(in.gcount()));
    }
    if (!in.eof()) {
      error(import_.text.size() > most ? "E482" : "E330",
            import_.text.size() > most
                ? fmt::format("{}: more than {} MiB are too long", file_name(), most >> 20U)
                : fmt::format("the file '{}' cannot be read", request_.file.string()));
    }
    return in.eof();
  }

  bool prepare_script() {
    const ScriptScan scan = scan_script(import_.text);
    for (std::size_t i = 0; i < std::min(most_messages, scan.outreach.size()); ++i) {
      const ForbiddenStatement& o = scan.outreach[i];
      error("E480", fmt::format("{}:{}: {} {}, which a script may not do here", file_name(), o.line,
                                o.word, o.does));
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

  /// The file's name as gmsh may see it: its messages hold it.
  [[nodiscard]] std::string plain_name() const {
    std::string name = request_.file.stem().string().substr(0, 100);
    std::replace_if(
        name.begin(), name.end(),
        [](unsigned char c) { return std::isalnum(c) == 0 && c != '-' && c != '_' && c != '.'; },
        '_');
    return name + (import_.script ? ".geo" : ".msh");
  }

  /// The model that gmsh makes of the file.
  bool ask() {
    const MesherAnswer answer = request_from_mesher(encode_import_request(import_));
    if (answer.end != MesherOutcome::answered) {
      report(answer);
      return false;
    }
    ByteReader in(answer.frame);
    const auto kind = in.read_value<MesherFrameKind>();
    if (kind == MesherFrameKind::no_sandbox) {
      error("E484",
            fmt::format("{}: this system has no seccomp filters, by which gmsh is kept from "
                        "all other files; without them no file is given to it",
                        file_name()));
      return false;
    }
    if (kind != MesherFrameKind::model || !decode_model_answer(in, from_)) {
      from_ = {};
      end_mesher_process();
      error("E331", fmt::format("{}: gmsh makes no mesh of it", file_name()));
      return false;
    }
    take_values();
    std::set<std::string_view> reported; // gmsh says some for every point that it meshes
    for (const std::string& line : from_.errors) {
      if (reported.insert(line).second) {
        error("E331", fmt::format("{}: gmsh says: {}", file_name(), line));
      }
    }
    if (from_.gave_up && from_.errors.empty()) {
      error("E331", fmt::format("{}: gmsh gave up", file_name()));
    }
    if (from_.gave_up || !from_.errors.empty()) {
      end_mesher_process(); // who knows what it left behind
      return false;
    }
    return true;
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

  /// Why there is no answer, with what gmsh had said so far.
  void report(const MesherAnswer& answer) {
    std::size_t reported = 0;
    for (const std::string& line : answer.words) {
      for (const std::string_view mark : {"Error   : ", "Fatal   : "}) {
        if (const std::size_t at = line.find(mark);
            at != std::string::npos && reported < most_messages) {
          ++reported;
          error("E331",
                fmt::format("{}: gmsh says: {}", file_name(), line.substr(at + mark.size())));
        }
      }
    }
    const auto say = [&](const char* code, const char* hint) {
      error(code, fmt::format("{}: {}", file_name(), answer.trouble), hint);
    };
    switch (answer.end) {
    case MesherOutcome::no_time:
      say("E481", "fewer or larger elements; --mesh-time allows more");
      break;
    case MesherOutcome::no_memory:
      say("E482", "fewer or larger elements; --mesh-memory allows more");
      break;
    default:
      say("E483", import_.script ? "is the geometry sound for all values of its constants?"
                                 : "the file is damaged");
    }
  }

  const ImportRequest& request_;
  base::Diagnostics& diagnostics_;
  MesherImportRequest import_;
  GmshModel from_;
  std::vector<GeometryScriptConstant> constants_;
};

} // namespace

GmshReadResult read_by_gmsh(const ImportRequest& request, base::Diagnostics& diagnostics) {
  return GmshFileReader(request, diagnostics).run();
}

} // namespace spricka::mesh
