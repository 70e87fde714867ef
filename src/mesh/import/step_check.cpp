// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/step_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace spricka::mesh {
namespace {

constexpr std::string_view first_word = "ISO-10303-21;";

std::string_view behind_blanks(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) {
    text.remove_prefix(3);
  }
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos ? std::string_view() : text.substr(first);
}

/// IGES: lines of 80 columns, the 73rd of the first ones an S with a number behind it.
bool is_iges_text(std::string_view text) {
  constexpr std::size_t section = 72;
  const std::size_t line = text.find_first_of("\r\n");
  return line != std::string_view::npos && line > section && text[section] == 'S' &&
         std::isdigit(static_cast<unsigned char>(text[line - 1])) != 0;
}

/// The text between the first two quotes behind a place.
std::string_view quoted(std::string_view text, std::size_t from) {
  const std::size_t begin = text.find('\'', from);
  const std::size_t end = begin == std::string_view::npos ? begin : text.find('\'', begin + 1);
  return end == std::string_view::npos ? std::string_view()
                                       : text.substr(begin + 1, end - begin - 1);
}

} // namespace

bool is_step_text(std::string_view text) {
  return behind_blanks(text).starts_with(first_word);
}

std::string find_step_format_error(std::string_view text) {
  const std::string_view whole = behind_blanks(text);
  if (whole.empty()) {
    return "it is empty";
  }
  if (!whole.starts_with(first_word)) {
    return is_iges_text(text) ? "it is an IGES file, which holds surfaces; export the part as STEP"
                              : "it is no STEP file: it does not begin with ISO-10303-21";
  }
  std::size_t at = 0;
  for (const std::string_view section :
       {"HEADER;", "ENDSEC;", "DATA", "ENDSEC;", "END-ISO-10303-21;"}) {
    const std::size_t found = whole.find(section, at);
    if (found == std::string_view::npos) {
      return fmt::format("there is no {}: is it truncated?", section);
    }
    at = found + section.size();
  }
  const std::size_t schema = whole.find("FILE_SCHEMA");
  if (schema != std::string_view::npos && schema < whole.find("ENDSEC;")) {
    const std::string_view name = quoted(whole, schema);
    if (name.starts_with("IFC")) {
      return fmt::format("its schema {} describes buildings, not parts",
                         name.substr(0, std::min<std::size_t>(name.find(' '), 40)));
    }
  }
  return {};
}

std::vector<std::string> files_named_by_step(std::string_view text) {
  std::vector<std::string> files;
  constexpr std::string_view entity = "DOCUMENT_FILE";
  for (std::size_t at = text.find(entity); at != std::string_view::npos;
       at = text.find(entity, at + entity.size())) {
    std::string name(quoted(text, at).substr(0, 80));
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
    if (!name.empty() && std::ranges::find(files, name) == files.end()) {
      files.push_back(std::move(name));
    }
  }
  return files;
}

int count_solids_in_step(std::string_view text) {
  int count = 0;
  constexpr std::string_view blanks = " \t\r\n";
  for (std::size_t at = text.find('='); at != std::string_view::npos; at = text.find('=', at + 1)) {
    const std::size_t word = text.find_first_not_of(blanks, at + 1);
    for (const std::string_view kind : {"MANIFOLD_SOLID_BREP", "BREP_WITH_VOIDS", "FACETED_BREP"}) {
      count += word != std::string_view::npos && text.substr(word, kind.size()) == kind ? 1 : 0;
    }
  }
  return count;
}

} // namespace spricka::mesh
