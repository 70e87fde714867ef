// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/contacts.hpp"
#include "model/forward.hpp"
#include "report/drawing/plot.hpp"
#include "report/drawing/table.hpp"
#include "results/results.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The figures of the page, made from the results.
namespace spricka::report {

/// Drawings (or tables) that stand side by side over one caption; the caption is plain text.
struct Figure {
  std::vector<std::string> drawings; ///< HTML or SVG elements
  std::string legend;                ///< one more drawing, below the others; may be empty
  std::string caption;
};

/// Adds a figure where there is one.
void add_figure(std::vector<Figure>& figures, std::optional<Figure> figure);

/// A value of K1 that a $CHECK compares with.
struct KCheckReference {
  std::string tip;
  std::string step;
  double a = 0.0;
  double wanted = 0.0;
  double found = 0.0; ///< what the run has at this place
  std::string source;
  double bar = 0.0; ///< error bar of `found`; 0: none
};
/// K1 of $CHECK lines with crack tip and step that the run has, in deck order; without a length at
/// the first one. In the plane only.
std::vector<KCheckReference> k_references(const model::Model& model, const results::RunResult& run);

/// The nominal state that a deck names by its parameters R and SIGMA: K0 = SIGMA sqrt(pi a).
struct FigureReferenceValues {
  double radius = 0.0; ///< [length]
  double sigma = 0.0;  ///< [stress]
  /// Nominal stress intensity SIGMA sqrt(pi a) of a length a.
  [[nodiscard]] double k0(double a) const;
};
/// Empty unless the deck has both parameters, positive, in any case of letters.
std::optional<FigureReferenceValues> find_figure_reference_values(const model::Model& model);

/// How a length and a K stand in a figure: as they are, or over R and SIGMA sqrt(pi a).
struct KFigureScale {
  std::optional<FigureReferenceValues> state;
  /// The point of a length [length] and a K [stress * length^0.5].
  [[nodiscard]] DrawingPoint operator()(double a, double K) const {
    return state ? DrawingPoint{a / state->radius, K / state->k0(a)} : DrawingPoint{a, K};
  }
  /// A plot of K1 over the length, with its axes and no curves.
  [[nodiscard]] Plot plot(const model::Model& model, const std::string& label) const;
};

/// The wanted values of references as marks, one series for each source with the shapes in turn.
/// Those of other steps are left out unless `step` is empty.
void add_reference_marks(Plot& plot, const std::vector<KCheckReference>& references,
                         std::string_view step, std::span<const MarkerShape> shapes,
                         const KFigureScale& scale);

/// K1 over a for every step and tip, references as marks. Empty if no crack has two lengths.
std::optional<Figure> k_over_crack_length_figure(const model::Model& model,
                                                 const results::RunResult& run);

/// K1/K0 over a/R at the end of the leading step, beside the table of its references. Empty
/// without two lengths or a nominal state.
std::optional<Figure> normalised_k_figure(const model::Model& model, const results::RunResult& run);

/// K1 beside its references, for every step. No rows without references.
ReportTable k_reference_table(const model::Model& model, const results::RunResult& run);

/// In the plane the whole mesh with its cracks, then for each tip the mesh round the crack; of
/// solids the outer surface with its stresses.
std::vector<Figure> mesh_figures(const model::Model& model, const results::RunResult& run);

/// Pressure of each contact: polar plots on bores, plots along the surface elsewhere; one drawing
/// for each crack length, at most nine.
std::vector<Figure> pressure_figures(const model::Model& model, const results::RunResult& run);

/// Pressure of a contact between solids round an axis at the steps of the last length: maps of the
/// unrolled surface, curves along the axis, the line of force. Empty where it has no axis.
std::optional<Figure> unrolled_pressure_figure(const model::Model& model,
                                               const results::RunResult& run,
                                               const model::Contact& contact);

/// The deck's contacts, and the faces of its cracks where they touch.
std::vector<model::Contact> shown_contacts(const model::Model& model,
                                           const results::RunResult& run);

/// The point of a contact with the largest pressure, but for those next to a crack's mouth or the
/// edge of a surface, where it has no bound; null: there is none.
const results::ContactPoint* find_peak_pressure(const model::Contact& contact,
                                                const results::ContactResult& result);

/// The pressure at a node by the recovery that the deck asks for.
double recovered_pressure(const model::Contact& contact, const results::ContactPoint& point);
/// "consistent" or "lumped".
const char* pressure_recovery_word(const model::Contact& contact);

/// Lengths over cycles, K of the law over the length, the way of the tips; none without growth by a
/// law.
std::vector<Figure> growth_figures(const model::Model& model, const results::RunResult& run);

/// Half width of the error bar of K1 in the plane, as plots have it; none of null.
double k1_bar_for_plot(const results::FrontResult* front);

/// At most `limit` increments, evenly chosen, first and last among them.
std::vector<const results::CrackLengthResult*> sample_increments(const results::RunResult& run,
                                                                 std::size_t limit);

} // namespace spricka::report
