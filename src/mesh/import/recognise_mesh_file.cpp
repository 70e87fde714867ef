// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/recognise_mesh_file.hpp"

#include "base/input_file.hpp"
#include "mesh/import/nastran_elements.hpp"
#include "mesh/import/step_check.hpp"
#include "mesh/set_name.hpp"

#include <algorithm>
#include <array>

namespace spricka::mesh {
namespace {

constexpr MeshFileKind gmsh_mesh{"a gmsh mesh", "MSH", ""};
constexpr MeshFileKind abaqus_input{"an input file of Abaqus or CalculiX", "INP", ""};
constexpr MeshFileKind nastran_bulk{"Nastran bulk data", "NASTRAN", ""};
constexpr MeshFileKind step_file{"a STEP file", "STEP", ""};
constexpr MeshFileKind universal_file{
    "a universal file (UNV) of I-DEAS or Salome", "",
    "gmsh makes a mesh with its groups of it: gmsh FILE.unv -save -o FILE.msh, then FORMAT=MSH"};
constexpr MeshFileKind med_file{
    "a MED file of Salome", "",
    "let Salome export the mesh as UNV, which keeps its groups, then gmsh FILE.unv -save -o "
    "FILE.msh; or, without groups, meshio convert --output-format gmsh FILE.med FILE.msh; then "
    "FORMAT=MSH"};
constexpr std::string_view file_word = "FILE";
constexpr std::size_t looked_through = std::size_t{1} << 16U; ///< bytes

std::string_view trim_line(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t\r");
  return first == std::string_view::npos
             ? std::string_view()
             : line.substr(first, line.find_last_not_of(" \t\r") + 1 - first);
}

/// Calls f with each line, without blanks at its ends, until it returns true.
template <class F> bool any_line(std::string_view text, F&& f) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    if (f(trim_line(text.substr(at, end - at)))) {
      return true;
    }
    at = end + 1;
  }
  return false;
}

/// The first line that is none of the format's comments.
std::string first_line(std::string_view text, std::string_view comment) {
  std::string first;
  any_line(text, [&](std::string_view line) {
    first = line.starts_with(comment) ? "" : upper_case(line.substr(0, 80));
    return !first.empty();
  });
  return first;
}

bool is_abaqus_input(std::string_view text) {
  static constexpr std::array<std::string_view, 8> keywords{
      "*HEADING", "*NODE", "*PART", "*INCLUDE", "*PREPRINT", "*ELEMENT", "*MATERIAL", "*SURFACE"};
  const std::string first = first_line(text, "**");
  return std::any_of(keywords.begin(), keywords.end(),
                     [&](std::string_view word) { return first.starts_with(word); });
}

/// Entries of a mesh, each alone in its first field.
bool is_nastran_entry(std::string_view line) {
  const std::size_t end = std::min({line.find_first_of(" \t,*"), line.size(), std::size_t{8}});
  const std::string name = upper_case(line.substr(0, end));
  const bool data = line.find_first_of("0123456789", end) != std::string_view::npos;
  return data && (name == "GRID" || name == "PSOLID" || name == "PSHELL" || name == "MAT1" ||
                  find_nastran_element(name) != nullptr);
}

bool is_nastran_bulk(std::string_view text) {
  return !first_line(text, "!").starts_with("$DECK") && any_line(text, [](std::string_view line) {
    const std::string word = upper_case(line.substr(0, 80));
    return word == "CEND" ||
           (word.starts_with("BEGIN") && word.find("BULK") != std::string::npos) ||
           is_nastran_entry(line);
  });
}

/// Datasets stand between lines of -1; the line after the first one has the number of a dataset.
bool is_universal_file(std::string_view text) {
  int line_number = 0;
  bool holds = true;
  any_line(text, [&](std::string_view line) {
    ++line_number;
    holds = line_number == 1 ? line == "-1"
                             : !line.empty() && line.size() <= 6 &&
                                   line.find_first_not_of("0123456789") == std::string_view::npos;
    return !holds || line_number == 2;
  });
  return holds && line_number == 2;
}

/// HDF5 with the groups that the library MED makes.
bool is_med_file(std::string_view text) {
  return text.starts_with("\x89HDF\r\n") && (text.find("INFOS_GENERALES") != std::string::npos ||
                                             text.find("ENS_MAA") != std::string::npos);
}

} // namespace

const MeshFileKind* recognise_mesh_file(const std::filesystem::path& file) {
  std::string text;
  try {
    text = base::read_file_beginning(file, looked_through);
  } catch (const base::UnreadableFile&) {
    return nullptr;
  }
  const std::string ending = upper_case(file.extension().string());
  if (text.starts_with("$MeshFormat")) {
    return &gmsh_mesh;
  }
  if (is_step_text(text)) {
    return &step_file;
  }
  if (ending == ".UNV" || is_universal_file(text)) {
    return &universal_file;
  }
  if (ending == ".MED" || is_med_file(text)) {
    return &med_file;
  }
  if (is_abaqus_input(text)) {
    return &abaqus_input;
  }
  return is_nastran_bulk(text) ? &nastran_bulk : nullptr;
}

std::string mesh_file_remedy(const MeshFileKind& kind, const std::filesystem::path& file) {
  std::string remedy(kind.remedy);
  const std::string stem = file.stem().string();
  for (std::size_t at = remedy.find(file_word); at != std::string::npos;
       at = remedy.find(file_word, at + stem.size())) {
    remedy.replace(at, file_word.size(), stem);
  }
  return remedy;
}

} // namespace spricka::mesh
