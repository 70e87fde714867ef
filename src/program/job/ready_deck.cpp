// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/job/ready_deck.hpp"

#include "fe/law.hpp"
#include "model/model.hpp"
#include "sense/contact_sense.hpp"
#include "sense/flaws.hpp"
#include "sense/half_model.hpp"
#include "sense/held_places.hpp"
#include "sense/k_consistency.hpp"
#include "sense/unjoined_bodies.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

// Cards that are understood but not available: each with its place.
base::Diagnostics unavailable(const model::Model& model) {
  base::Diagnostics list;
  for (const model::OutputFileRequest& output : model.outputs) {
    if (output.format == model::OutputFormat::json) {
      list.error(output.span, "E500", "FORMAT=JSON is not available in this version");
    }
  }
  for (const model::UnimplementedAnalysis& u : model.unavailable) {
    list.error(u.span, "E500", fmt::format("{} is not available in this version", u.what));
  }
  return list;
}

// Where a material hardly changes its volume the dilatation is projected, but linear triangles,
// tetrahedra and wedges have too few freedoms for that: they lock, more the nearer nu is to 0.5.
bool locks(base::ElementType type) {
  return type == base::ElementType::trim3 || type == base::ElementType::tet4 ||
         type == base::ElementType::penta6;
}

void warn_of_locking(const model::Model& model, base::Diagnostics& list) {
  std::vector<bool> reported(model.properties.size(), false);
  for (std::size_t e = 0; e < model.mesh.element_count(); ++e) {
    const base::ElementType type = model.mesh.type[e];
    const std::size_t p = model.mesh.property[e].index();
    if (reported[p] || !locks(type) ||
        !fe::constitutive_law(model, model.mesh, base::ElementId(e)).projected) {
      continue;
    }
    reported[p] = true;
    const model::ElasticMaterial& material = model.materials[model.properties[p].material.index()];
    list.warning(material.span, "W501",
                 fmt::format("material {}: nu = {:.6g} is nearly incompressible and {} elements "
                             "lock; results may be far off",
                             material.name, material.nu, base::element_info(type).name),
                 "use quadratic elements or quadrilaterals and hexahedra");
  }
}

} // namespace

base::Diagnostics find_news(const base::Diagnostics& list, const base::Diagnostics* reported) {
  if (reported == nullptr) {
    return list;
  }
  base::Diagnostics news;
  for (const base::Diagnostic& d : list.messages()) {
    const bool old = std::ranges::any_of(reported->messages(), [&](const base::Diagnostic& t) {
      return t.code == d.code && t.text == d.text;
    });
    if (!old && d.severity == base::Severity::error) {
      news.error(d.span, d.code, d.text, d.hint);
    } else if (!old && d.severity == base::Severity::warning) {
      news.warning(d.span, d.code, d.text, d.hint);
    } else if (!old) {
      news.note(d.span, d.code, d.text, d.hint);
    }
  }
  return news;
}

std::string first_error_text(const base::SourceTexts& sources,
                             const base::Diagnostics& diagnostics) {
  for (const base::Diagnostic& d : diagnostics.messages()) {
    if (d.severity != base::Severity::error) {
      continue;
    }
    if (!d.span.valid()) {
      return fmt::format("{}: {}", d.code, d.text);
    }
    const base::SourceLocation at = sources.locate(d.span.file, d.span.begin);
    return fmt::format("{}:{}:{}: {}: {}", sources.file_name(d.span.file), at.line, at.column,
                       d.code, d.text);
  }
  return {};
}

RunOutcomeWithResults report_refusal(const base::SourceTexts& sources,
                                     const base::Diagnostics& list, base::ProgramOutcome kind,
                                     const Log& log, const base::Diagnostics* reported) {
  log.report_diagnostics(sources, find_news(list, reported));
  return {kind, first_error_text(sources, list), {}};
}

CheckedDeck read_and_check_deck(const std::filesystem::path& deck,
                                const deck::DeckReadOptions& options, const Log& log,
                                const base::Diagnostics* reported) {
  CheckedDeck ready;
  ready.options = options;
  std::optional<model::Model> model =
      deck::read_deck(deck, options, ready.sources, ready.diagnostics, &ready.imported);
  if (model) {
    sense::reduce_to_half_model(*model, ready.diagnostics);
    warn_of_locking(*model, ready.diagnostics);
    sense::warn_of_implausible_contacts(*model, ready.diagnostics);
    sense::warn_of_unjoined_bodies(*model, ready.diagnostics);
    sense::warn_of_loads_on_supports(*model, ready.diagnostics);
    sense::warn_of_misplaced_crack_mouths(*model, ready.diagnostics);
    if (!ready.diagnostics.has_errors()) {
      ready.flaws = sense::describe_solid_cracks(*model, ready.diagnostics);
    }
  }
  if (model && !ready.diagnostics.has_errors()) {
    // After the mistakes: a deck with both is to be mended first.
    base::Diagnostics missing = unavailable(*model);
    if (missing.has_errors()) {
      ready.refusal =
          report_refusal(ready.sources, missing, base::ProgramOutcome::not_solvable, log, reported);
      return ready;
    }
    if (model->steps.empty()) {
      ready.diagnostics.error({0, 0, 0}, "E405",
                              "the deck has no $STEP, so there is nothing to solve");
    }
  }
  if (!model || ready.diagnostics.has_errors()) {
    ready.refusal = report_refusal(ready.sources, ready.diagnostics,
                                   base::ProgramOutcome::deck_error, log, reported);
    return ready;
  }
  log.report_diagnostics(ready.sources, find_news(ready.diagnostics, reported));
  ready.model = std::move(model);
  return ready;
}

CheckedDeck read_deck_silently(const std::filesystem::path& deck,
                               const deck::DeckReadOptions& options) {
  CheckedDeck ready;
  ready.options = options;
  std::optional<model::Model> model =
      deck::read_deck(deck, options, ready.sources, ready.diagnostics);
  if (model) {
    sense::reduce_to_half_model(*model, ready.diagnostics);
  }
  if (!model || ready.diagnostics.has_errors()) {
    ready.refusal.error = first_error_text(ready.sources, ready.diagnostics);
  } else {
    ready.model = std::move(model);
  }
  return ready;
}

} // namespace spricka::program
