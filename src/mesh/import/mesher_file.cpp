// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/mesher_file.hpp"

#include "mesh/link/mesher_link.hpp"
#include "mesh/link/mesher_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <set>
#include <utility>

namespace spricka::mesh {
namespace {

constexpr std::size_t most_errors = 20;

} // namespace

void MesherFile::report_error(std::string code, std::string_view text, std::string hint) {
  diagnostics_.error(request_.span, std::move(code),
                     fmt::format("{}: {}", request_.file.filename().string(), text),
                     std::move(hint));
}

std::optional<std::string> MesherFile::read_text(std::size_t most) {
  std::string text;
  std::ifstream in(request_.file, std::ios::binary);
  constexpr std::size_t chunk = std::size_t{1} << 20U;
  while (in && text.size() <= most) {
    const std::size_t filled = text.size();
    text.resize(filled + chunk);
    in.read(text.data() + filled, chunk);
    text.resize(filled + static_cast<std::size_t>(in.gcount()));
  }
  if (in.eof()) {
    return text;
  }
  if (text.size() > most) {
    report_error("E482", fmt::format("more than {} MiB are too long", most >> 20U));
  } else {
    diagnostics_.error(request_.span, "E330",
                       fmt::format("the file '{}' cannot be read", request_.file.string()));
  }
  return std::nullopt;
}

std::string MesherFile::plain_name(std::string_view ending) const {
  std::string name = request_.file.stem().string().substr(0, 100);
  std::replace_if(
      name.begin(), name.end(),
      [](unsigned char c) { return std::isalnum(c) == 0 && c != '-' && c != '_' && c != '.'; },
      '_');
  return name.append(ending);
}

std::optional<std::string> MesherFile::ask(std::string_view request, const char* remedy) {
  const MesherAnswer answer = request_from_mesher(request);
  if (answer.end == MesherOutcome::answered) {
    if (ByteReader(answer.frame).read_value<MesherFrameKind>() != MesherFrameKind::no_sandbox) {
      return answer.frame;
    }
    report_error("E484", "this system has no seccomp filters, by which gmsh is kept from all other "
                         "files; without them no file is given to it");
    return std::nullopt;
  }
  // what gmsh had said so far; of a lack of memory each of its parts says something
  std::size_t reported = answer.end == MesherOutcome::no_memory ? most_errors : 0;
  for (const std::string& line : answer.words) {
    for (const std::string_view mark : {"Error   : ", "Fatal   : "}) {
      if (const std::size_t at = line.find(mark);
          at != std::string::npos && reported < most_errors) {
        ++reported;
        report_error("E331", "gmsh says: " + line.substr(at + mark.size()));
      }
    }
  }
  switch (answer.end) {
  case MesherOutcome::no_time:
    report_error("E481", answer.trouble, "fewer or larger elements; --mesh-time allows more");
    break;
  case MesherOutcome::no_memory:
    report_error("E482", answer.trouble, "fewer or larger elements; --mesh-memory allows more");
    break;
  default:
    report_error("E483", answer.trouble, remedy);
  }
  return std::nullopt;
}

void MesherFile::refuse_answer() {
  end_mesher_process();
  report_error("E331", "gmsh makes no mesh of it");
}

bool MesherFile::report_gmsh_errors(const std::vector<std::string>& errors, bool gave_up) {
  std::set<std::string_view> reported; // gmsh says some for every point that it meshes
  for (const std::string& line : errors) {
    if (reported.insert(line).second) {
      report_error("E331", "gmsh says: " + line);
    }
  }
  if (gave_up && errors.empty()) {
    report_error("E331", "gmsh gave up");
  }
  const bool sound = !gave_up && errors.empty();
  if (!sound) {
    end_mesher_process();
  }
  return sound;
}

void MesherFile::report_gmsh_warnings(const std::vector<std::string>& warnings) {
  static constexpr std::size_t most = 5;
  for (std::size_t i = 0; i < std::min(most, warnings.size()); ++i) {
    const std::size_t more = i + 1 == most ? warnings.size() - most : 0;
    diagnostics_.warning(request_.span, "W331",
                         fmt::format("{}: gmsh says: {}{}", request_.file.filename().string(),
                                     warnings[i],
                                     more > 0 ? fmt::format(" (and {} more)", more) : ""));
  }
}

} // namespace spricka::mesh
