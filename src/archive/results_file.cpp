// SPDX-License-Identifier: GPL-3.0-or-later
#include "archive/results_file.hpp"

#include "archive/deck_digest.hpp"
#include "archive/version.hpp"
#include "model/model.hpp"
#include "report/drawing/file.hpp"
#include "results/store_run.hpp"

#include <algorithm>
#include <system_error>
#include <vector>

namespace spricka::archive {

namespace {

constexpr std::int64_t format_version = 2;

// Stations of a growth by a law are the program's choice, and many: of those between the first and
// the last fields are kept only where the deck asks for fields of each.
std::vector<bool> kept_fields(const model::Model& model, const results::RunResult& run) {
  const bool law = model.growth && model.growth->law != model::CrackGrowthLaw::increment;
  const bool asked = std::ranges::any_of(model.outputs, [](const model::OutputFileRequest& output) {
    return output.format == model::OutputFormat::vtu && output.every != model::OutputFrequency::end;
  });
  std::vector<bool> kept(run.increments.size(), !law || asked);
  if (!kept.empty()) {
    kept.front() = true;
    kept.back() = true;
  }
  return kept;
}

} // namespace

void write_provenance(const results::StoreGroup& given, const model::Model& model) {
  results::StoreGroup group = given;
  group.set_attribute("program", "spricka " SPRICKA_VERSION);
  group.set_attribute("libraries", version_text());
  group.set_attribute("title", model.title);
  group.set_attribute("length_unit", model.units.length_name);
  group.set_attribute("force_unit", model.units.force_name);
  group.set_attribute("stress_unit", model.units.stress_name());
  group.set_attribute("K_unit", model.units.stress_intensity_name());
}

void store_deck_texts(const results::StoreGroup& given, const base::SourceTexts& sources,
                      const model::Model& model) {
  results::StoreGroup group = given.group("deck");
  std::vector<std::string> names;
  std::vector<std::string> texts;
  for (std::int32_t f = 0; f < static_cast<std::int32_t>(sources.count()); ++f) {
    names.emplace_back(std::filesystem::path(sources.file_name(f)).filename().string());
    texts.emplace_back(sources.text(f));
  }
  results::ColumnTable files{{{"file", names}}};
  group.write("files", files);
  for (std::size_t f = 0; f < texts.size(); ++f) {
    group.write("text_" + std::to_string(f + 1), std::span(&texts[f], 1));
  }
  std::vector<std::string> parameter;
  std::vector<double> value;
  for (const auto& [name, number] : model.parameters) {
    parameter.push_back(name);
    value.push_back(number);
  }
  if (!parameter.empty()) {
    group.write("parameters", results::ColumnTable{{{"name", parameter}, {"value", value}}});
  }
  group.set_attribute("hash", compute_deck_digest(sources, model, {}));
}

void write_results_file(const std::filesystem::path& file, const base::SourceTexts& sources,
                        const model::Model& model, const results::RunResult& run) {
  try {
    results::Store store = results::Store::in_memory();
    {
      results::StoreGroup root = store.root();
      root.set_attribute("format", std::string_view("spricka results"));
      root.set_attribute("format_version", format_version);
      write_provenance(root, model);
      store_deck_texts(root, sources, model);
      results::write_summary_tables(root, run);
      // Without times: the same deck makes the same bytes.
      results::write_run(root, run, results::TimeRecording::left_out, kept_fields(model, run));
    }
    report::write_file(file, store.finish_bytes());
  } catch (const results::StoreError& trouble) {
    throw std::system_error(std::make_error_code(std::errc::io_error),
                            file.string() + ": " + trouble.what());
  }
}

} // namespace spricka::archive
