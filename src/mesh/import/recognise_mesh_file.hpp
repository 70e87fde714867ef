// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace spricka::mesh {

/// What another program's file is.
struct MeshFileKind {
  std::string_view name;   ///< "an Abaqus or CalculiX input file"
  std::string_view format; ///< the word of $IMPORT FORMAT; empty: it is not read
  std::string_view remedy; ///< how to come to a mesh that is read, with FILE for its name
};

/// Tells a mesh file by what it begins with, and UNV and MED files by their ending as well. Null
/// for anything else: decks, scripts, files that cannot be read.
const MeshFileKind* recognise_mesh_file(const std::filesystem::path& file);

/// The remedy with the name of a file.
std::string mesh_file_remedy(const MeshFileKind& kind, const std::filesystem::path& file);

} // namespace spricka::mesh
