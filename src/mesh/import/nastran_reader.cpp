// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/nastran_reader.hpp"

#include "mesh/import/nastran_fields.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace spricka::mesh {
namespace {

/// A file that is wrong everywhere is not worth more words.
constexpr std::size_t most_nastran_complaints = 50;

/// Entries without a say in statics: what is printed, sets of numbers, control of eigenvalues.
constexpr std::array<std::string_view, 10> harmless_entries{
    "EIGRL", "EIGR", "EIGB", "EIGC", "SET1", "PLOTEL", "NLPARM", "TSTEP", "MDLPRM", "DTI"};

} // namespace

NastranBulk read_nastran_bulk(const std::filesystem::path& file,
                              std::vector<NastranIssue>& complaints) {
  const NastranFields::Complain complain = [&](InpLocation at, std::string words) {
    if (complaints.size() < most_nastran_complaints) {
      complaints.push_back({at, std::move(words), {}});
    }
  };
  NastranBulk bulk;
  NastranCardReader reader(file, complain);
  while (reader.next_card()) {
    const NastranCard& card = reader.card();
    NastranFields fields(card, complain);
    const std::size_t before = bulk.properties.size();
    bool known = false;
    for (const auto read :
         {read_nastran_mesh_card, read_nastran_property_card, read_nastran_load_card}) {
      known = known || read(fields, bulk);
    }
    if (bulk.properties.size() > before && !card.title.empty()) {
      bulk.property_names.try_emplace(fields.label(0, "PID"), card.title);
    }
    if (!known && std::ranges::find(harmless_entries, card.name) == harmless_entries.end()) {
      bulk.refused[card.name].add(card.place);
    }
  }
  for (const auto& [label, name] : reader.property_names()) {
    bulk.property_names.insert_or_assign(label, name);
  }
  bulk.set_names = reader.set_names();
  bulk.files = reader.file_paths();
  return bulk;
}

} // namespace spricka::mesh
