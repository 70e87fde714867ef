// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/inp_left_out.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

namespace spricka::mesh {
namespace {

/// Keywords that join bodies, hold them or change what they are made of, by their first word or
/// words; further ones say how.
constexpr std::array<std::string_view, 31> of_the_model{"TIE",
                                                        "COUPLING",
                                                        "KINEMATIC",
                                                        "DISTRIBUTING",
                                                        "RIGID BODY",
                                                        "MPC",
                                                        "TRANSFORM",
                                                        "EQUATION",
                                                        "CONTACT",
                                                        "CLEARANCE",
                                                        "CYCLIC",
                                                        "PRE-TENSION",
                                                        "EMBEDDED",
                                                        "SPRING",
                                                        "DASHPOT",
                                                        "MASS",
                                                        "GAP",
                                                        "SHELL",
                                                        "BEAM",
                                                        "MEMBRANE",
                                                        "PLASTIC",
                                                        "CREEP",
                                                        "HYPERELASTIC",
                                                        "HYPERFOAM",
                                                        "VISCOELASTIC",
                                                        "USER MATERIAL",
                                                        "DEFORMATION",
                                                        "CONNECTOR",
                                                        "MODEL CHANGE",
                                                        "ELASTIC",
                                                        "SOLID SECTION COMPOSITE"};

/// What InpJointCards hold of a file; parts of it that they do not have names of their own.
constexpr std::array<std::string_view, 12> of_the_joint{"CONTACT PAIR",
                                                        "SURFACE INTERACTION",
                                                        "SURFACE BEHAVIOR",
                                                        "FRICTION",
                                                        "TIE",
                                                        "CLEARANCE",
                                                        "BOUNDARY",
                                                        "CLOAD",
                                                        "DLOAD",
                                                        "DSLOAD",
                                                        "STEP",
                                                        "STATIC"};

/// What prints or measures contact has no say.
constexpr std::array<std::string_view, 4> exceptions{"CONTACT OUTPUT", "CONTACT PRINT",
                                                     "CONTACT FILE", "CONTACT CONTROLS"};

bool is_of_the_model(std::string_view keyword) {
  const auto begins = [&](std::string_view words) {
    return keyword.starts_with(words) &&
           (keyword.size() == words.size() || keyword[words.size()] == ' ');
  };
  return std::ranges::any_of(of_the_model, begins) && std::ranges::none_of(exceptions, begins);
}

void append(std::string& list, const InpData& data, std::string_view what, std::size_t count,
            InpLocation at) {
  const std::string file =
      at.file == 0 ? "" : std::filesystem::path(data.files[at.file]).filename().string() + " ";
  list += fmt::format("{}{} ({}, {}line {})", list.empty() ? "" : ", ", what, count, file, at.line);
}

} // namespace

InpLeftOutText describe_left_out(const InpData& data, const ImportRequest& request) {
  InpLeftOutText text;
  for (const auto& [keyword, left] : data.left_out) {
    if (request.joint_taken && std::ranges::find(of_the_joint, keyword) != of_the_joint.end()) {
      continue;
    }
    const bool said = request.contact_elsewhere && (keyword == "TIE" || keyword == "CONTACT PAIR");
    append(is_of_the_model(keyword) && !said ? text.of_the_model : text.of_no_say, data,
           "*" + keyword, left.count, left.first);
  }
  for (const InpData::InpElementKind& kind : data.connectors) {
    append(text.of_the_model, data, "elements " + kind.name, kind.count, kind.first);
  }
  return text;
}

} // namespace spricka::mesh
