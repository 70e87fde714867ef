// SPDX-License-Identifier: GPL-3.0-or-later
#include "archive/deck_digest.hpp"

#include "base/hasher.hpp"
#include "base/input_file.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>

namespace spricka::archive {

namespace {

namespace fs = std::filesystem;

std::string slurp(const fs::path& file) {
  try {
    return base::read_file(file, base::largest_mesh_file);
  } catch (const base::UnreadableFile&) {
    return {};
  }
}

// Include "a.geo"; Merge "b.msh"; ShapeFromFile("c.step"): every quoted name of a file that is
// there, relative to the script.
std::vector<fs::path> named_files(const fs::path& script, std::string_view text) {
  std::vector<fs::path> files;
  for (std::size_t open = text.find('"'); open != std::string_view::npos;) {
    const std::size_t close = text.find('"', open + 1);
    if (close == std::string_view::npos) {
      break;
    }
    const std::string_view name = text.substr(open + 1, close - open - 1);
    std::error_code none;
    const fs::path file = script.parent_path() / fs::path(name);
    if (!name.empty() && name.find('\n') == std::string_view::npos &&
        fs::is_regular_file(file, none)) {
      files.push_back(file);
    }
    open = text.find('"', close + 1);
  }
  return files;
}

void add_texts(const fs::path& file, std::vector<fs::path>& seen, std::vector<std::string>& texts) {
  const fs::path canonical = fs::weakly_canonical(file);
  // Scripts may include each other.
  if (std::find(seen.begin(), seen.end(), canonical) != seen.end()) {
    return;
  }
  seen.push_back(canonical);
  const std::string& text = texts.emplace_back(slurp(file));
  // Scripts name further files.
  if (file.extension() == ".geo") {
    for (const fs::path& named : named_files(file, std::string(text))) {
      add_texts(named, seen, texts);
    }
  }
}

} // namespace

std::string compute_deck_digest(const base::SourceTexts& sources, const model::Model& model,
                                const std::vector<std::pair<std::string, double>>& sweep_values) {
  base::Hasher hash;
  hash.add_text(SPRICKA_VERSION);
  for (std::int32_t f = 0; f < static_cast<std::int32_t>(sources.count()); ++f) {
    const std::string& name = sources.file_name(f);
    hash.add_text(name.starts_with("-D ") ? name : std::string());
    hash.add_text(sources.text(f));
  }
  std::vector<fs::path> seen;
  std::vector<std::string> texts;
  for (const std::string& file : model.imported_files) {
    add_texts(file, seen, texts);
  }
  for (const std::string& text : texts) {
    hash.add_text(text);
  }
  for (const auto& [name, value] : sweep_values) {
    hash.add_text(name);
    hash.value(value);
  }
  const auto [high, low] = hash.digest();
  return fmt::format("{:016x}{:016x}", high, low);
}

std::uintmax_t count_deck_input_bytes(const base::SourceTexts& sources, const model::Model& model) {
  std::uintmax_t bytes = 0;
  for (std::int32_t f = 0; f < static_cast<std::int32_t>(sources.count()); ++f) {
    bytes += sources.file_name(f).starts_with("-D ") ? 0 : sources.text(f).size();
  }
  std::vector<fs::path> seen;
  std::vector<std::string> texts;
  for (const std::string& file : model.imported_files) {
    add_texts(file, seen, texts);
  }
  for (const std::string& text : texts) {
    bytes += text.size();
  }
  return bytes;
}

std::string read_imported_file_texts(const std::string& file) {
  std::vector<fs::path> seen;
  std::vector<std::string> texts;
  add_texts(file, seen, texts);
  std::string all;
  for (const std::string& text : texts) {
    all += text + '\n';
  }
  return all;
}

} // namespace spricka::archive
