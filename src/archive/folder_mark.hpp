// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What is ours in a folder. A folder that the program makes holds a file .spricka that names, one
/// a line, the files that it wrote there. They are all that is ever replaced or removed; a folder
/// without that file is somebody else's, whatever it holds.
namespace spricka::archive {

inline constexpr const char* mark_name = ".spricka";
/// Who writes the folder at this moment; gone when it is finished.
inline constexpr const char* owner_name = ".spricka.owner";

enum class RunOrSweepFolder { run, sweep };

struct FolderManifest {
  RunOrSweepFolder kind = RunOrSweepFolder::run;
  std::vector<std::string> files; ///< plain names, each once
};

/// The mark of a folder; empty if there is none, or none that the program wrote.
std::optional<FolderManifest> read_folder_manifest(const std::filesystem::path& folder);

/// Marks a folder as ours, with these files. Throws std::system_error.
void write_folder_manifest(const std::filesystem::path& folder, const FolderManifest& mark);
/// Adds a file, before it is written. Throws std::system_error.
void add_to_folder_manifest(const std::filesystem::path& folder, const std::string& name);

/// Names in a folder that the mark does not know. Throws std::system_error.
std::vector<std::string> find_foreign_files(const std::filesystem::path& folder,
                                            const FolderManifest& mark);

/// Removes the files that the mark of a folder names, the mark, and the folder if nothing else is
/// in it. Without a mark nothing is touched.
void remove_manifest_files(const std::filesystem::path& folder);

} // namespace spricka::archive
