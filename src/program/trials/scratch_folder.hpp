// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <filesystem>

namespace spricka::program {

/// A new folder PREFIX.XXXXXX for decks and run folders, removed at the end, whole. Throws
/// std::system_error where none can be made.
class ScratchFolder {
public:
  /// `keep`: it stays at the end.
  explicit ScratchFolder(const std::filesystem::path& prefix, bool keep = false);
  ~ScratchFolder() { remove(); }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Removes it now, unless it is kept.
  void remove() const;

private:
  std::filesystem::path path_;
  bool keep_;
};

} // namespace spricka::program
