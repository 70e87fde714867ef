// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/bind.hpp"
#include "deck/imported_step.hpp"
#include "deck/labels.hpp"
#include "deck/names.hpp"
#include "deck/read_options.hpp"
#include "deck/set_border.hpp"
#include "grammar/compile.hpp"
#include "mesh/import/imported_physics.hpp"
#include "model/model.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace spricka::deck {

/// Elements that one card made, for messages about them.
struct ElementOrigin {
  std::size_t first = 0; ///< element index
  std::size_t count = 0;
  base::SourceSpan card;
  base::SourceSpan data; ///< of an $ELEMENT table, an element in each row; invalid for a mesh
};

/// Everything the stages of reading share: what is being built and what is known about names.
struct DeckContext {
  base::SourceTexts& sources;
  base::Diagnostics& diagnostics;
  grammar::ExpressionScope scope{};
  std::vector<std::pair<std::string, double>> parameters{}; ///< as written
  std::set<std::string> overridden{};                       ///< by -D, upper case
  NameTable names{};
  std::vector<CheckedCard> cards{};
  model::Model model{};

  std::vector<ImportedScript> scripts{};      ///< of $IMPORT FORMAT=GEO, in their order
  std::vector<ImportedStepFile> step_files{}; ///< of $IMPORT FORMAT=STEP, in their order
  std::map<std::string, std::shared_ptr<const mesh::StepFileContents>>
      step_contents{}; ///< by file, read once; null: it is refused
  std::vector<mesh::ImportedMaterialsAndEquations>
      imported{}; ///< by $IMPORT FORMAT=INP, in their order

  std::vector<LabelMap> node_labels{};                          ///< [net]
  std::vector<LabelMap> element_labels{};                       ///< [net]
  std::vector<ElementOrigin> origins{};                         ///< ascending
  std::size_t largest_mesh = 0;                                 ///< see DeckReadOptions
  const std::map<std::string, NetRefinement>* refine = nullptr; ///< see DeckReadOptions
  const std::set<std::string>* own_lengths = nullptr;           ///< see DeckReadOptions
  std::set<std::string> remeshed{};          ///< nets whose cards took their refinement themselves
  std::set<std::size_t> default_thickness{}; ///< plane properties whose card has no THICK
  bool mesh_sound = true;                    ///< no mistake while nodes and elements were made
  bool property_sound = true;                ///< no mistake in $PROPERTY and what it names
  bool freedom_sound = true;                 ///< no mistake in $FREEDOM
  std::optional<std::vector<model::Face>> boundary{}; ///< of the finished mesh, found once
  std::vector<std::size_t> building{}; ///< cards of sets being built, outermost first
  std::map<std::size_t, FaceSetConditionAreas>
      set_borders{};                                       ///< of face sets whose WHERE cuts faces
  std::vector<model::GrowthLawDefinition> growth_laws{};   ///< of $LAW, in their order
  std::map<std::size_t, base::NodeSetId> nodes_of_faces{}; ///< face sets that stood for node sets
  std::map<std::size_t, base::FaceSetId> faces_of_nodes{}; ///< and the reverse

  /// Reports a mistake of the deck at its place: code "E...", text, and a hint how to mend it.
  void error(base::SourceSpan span, std::string code, std::string text, std::string hint = {}) {
    diagnostics.error(span, std::move(code), std::move(text), std::move(hint));
  }
  /// Says what the deck hardly means at its place: code "W...", text, and a hint how to mend it.
  void warning(base::SourceSpan span, std::string code, std::string text, std::string hint = {}) {
    diagnostics.warning(span, std::move(code), std::move(text), std::move(hint));
  }
  /// Reports that a name is defined although it has a meaning already.
  void report_duplicate_name(const NameDefinition& second, std::string_view name,
                             const NameDefinition& first);
  /// Number of a field in a data line, see read_field_number.
  std::optional<double> read_number(const grammar::CardField& field, grammar::QuantityKind quantity,
                                    std::string_view what) {
    return read_field_number(field, quantity, what, scope, diagnostics);
  }
  /// One unit of a key, as KUNIT, in those of the deck; 1 where it is not given.
  [[nodiscard]] double key_unit_factor(const CheckedCard& card, std::string_view key) const;
  /// The line of its file, from 1, that a place begins in.
  [[nodiscard]] std::size_t line_number(base::SourceSpan span) const {
    return sources.locate(span.file, span.begin).line;
  }
  /// The first card of a name; null: the deck has none.
  [[nodiscard]] const CheckedCard* find_first_card(std::string_view name) const;
  /// Whether the header of some card of a name is refused.
  [[nodiscard]] bool has_bad_card(std::string_view name) const;
  /// The first sound card of a name whose NAME is this; null: there is none.
  [[nodiscard]] const CheckedCard* find_sound_card_named(std::string_view card,
                                                         std::string_view name) const;
  /// Calls f with each sound card of a name, in deck order.
  template <class F> void for_each_sound_card(std::string_view name, F&& f) const {
    for (const CheckedCard& card : cards) {
      if (card.spec->name == name && !card.bad) {
        f(card);
      }
    }
  }
  /// The net of a name; the number of nets where there is none.
  [[nodiscard]] base::NetId find_net(std::string_view name) const;
  /// Of the net that a card stands in; null: as the deck has it.
  [[nodiscard]] const NetRefinement* net_refinement(const std::string& net) const {
    const auto found = refine == nullptr ? std::map<std::string, NetRefinement>::const_iterator()
                                         : refine->find(net);
    return refine == nullptr || found == refine->end() ? nullptr : &found->second;
  }
  /// Elements of the plane, without doubt: a mesh whose card is refused may have been a solid one.
  [[nodiscard]] bool is_certainly_plane() const {
    return mesh_sound && model.mesh.element_count() > 0 && model.mesh.dim == 2;
  }
  /// Notes an analysis that the deck asks for and the program does not have.
  void record_unavailable_analysis(std::string what, base::SourceSpan span) {
    model.unavailable.push_back({std::move(what), span});
  }
};

/// The definition a reference means. Empty after an error, which is reported unless the name is
/// poisoned.
const NameDefinition* find_referenced_definition(DeckContext& context, EntityKind kind,
                                                 const NameReference& reference);

/// Whether a reference means a contact, or with CRACK.FACES the faces of a crack; else an error is
/// reported as by find_referenced_definition.
bool check_contact_or_crack_faces(DeckContext& context, const NameReference& reference);

// The stages, in their order. Each takes its cards from the context and leaves its part of the
// model there; mistakes go to the diagnostics.

/// Passes 2 and 3: parameters, headers and rows of all cards; nets; names defined.
void check_cards_and_define_names(DeckContext& context,
                                  const std::vector<grammar::CardHeader>& cards,
                                  const DeckReadOptions& options);
/// Parameters and names of a deck that has been read before, for cards and lines behind it; NOW is
/// a step.
void define_names_of_model(DeckContext& context, const model::Model& model);
/// $COOR, $ELEMENT, $MESH, $IMPORT.
/// Whether all conditions of $REQUIRE hold; those that do not are reported with the values of their
/// parameters.
bool check_requirements(DeckContext& context);
void build_mesh(DeckContext& context);
/// Parameters that reach no script, though they seem to be meant to.
void warn_of_unused_script_parameters(DeckContext& context);
/// $NSET, $ESET, $FSET.
void build_sets(DeckContext& context);
/// $MATERIAL, $PROPERTY, $FREEDOM.
void build_properties(DeckContext& context);
/// Ties and equations between freedoms, from $MPC.
void build_mpcs(DeckContext& context);
/// $LOAD and the cases.
void build_loads(DeckContext& context);
/// $RIGID, $CONTACT, $CRACK, $TIPNET, $VCE.
void build_contacts(DeckContext& context);
/// Cracks, nets round their tips and virtual extensions: $CRACK, $TIPNET, $VCE.
void build_cracks(DeckContext& context);
/// $STEP, $LOADPATH, $GROW.
void build_steps(DeckContext& context);
/// One data line of $STEP: its action goes behind those of the step; mistakes are reported.
void read_step_row(DeckContext& context, const grammar::DataRow& row, model::Step& step);
/// $SPECTRUM, once its load paths are there.
void build_spectra(DeckContext& context);
/// Whether a name stands for cycles that do not act on each other.
inline bool is_no_interaction(EntityKind kind, const NameReference& name) {
  return kind == EntityKind::interaction && name.name == "NONE";
}
/// $INTERACTION.
void build_interactions(DeckContext& context);
/// What $GROW says of the interaction of cycles: which ones, and whether its law serves them.
void read_growth_interactions(DeckContext& context, const CheckedCard& card,
                              model::CrackGrowthSettings& growth);
/// $TEST, once $GROW is there.
void build_growth_tests(DeckContext& context);
/// $OUTPUT, $CHECK, $CONTROL, $RESTART, $SWEEP, $TASK.
void build_requests(DeckContext& context);
/// Names that cards with bad headers use: the stages above leave these cards out.
void check_references_of_bad_cards(DeckContext& context);
/// Elements without a property, bad elements, mixed dimensions.
void check_elements(DeckContext& context);
/// Elements that stand twice; sides that touch and nothing joins.
void check_double_and_unjoined_elements(DeckContext& context);
/// What no card can say alone: symmetry, cracks and loads that reach the mesh, heat without
/// expansion, thickness. Nothing where the deck has errors.
void check_model_consistency(DeckContext& context);
/// Values that the language allows and hardly anybody means.
void check_plausibility(DeckContext& context);
/// Surfaces that two cards hold or load.
void check_conflicting_surfaces(DeckContext& context);
/// Numbers that are allowed and that hardly any material, law, fit or check has.
void check_implausible_values(DeckContext& context);
/// What nothing uses or moves, and what stands twice.
void check_unused_entities(DeckContext& context);
/// Thickness and state of plane bodies.
void check_thickness(DeckContext& context);
/// Constants of $LAW that are allowed and hardly meant.
void check_growth_laws(DeckContext& context);
/// Steps that do nothing and growths that cannot be meant.
void check_steps_and_growth(DeckContext& context);

} // namespace spricka::deck
