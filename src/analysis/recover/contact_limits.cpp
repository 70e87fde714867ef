// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/contact_limits.hpp"

#include "contact/slide.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

constexpr double most_lost = 0.01;   // of the force
constexpr double most_slide = 0.01;  // of the pressed length
constexpr double most_misfit = 0.25; // of what the pressure moves the surfaces by
constexpr double no_strain = 1e-12;  // pressure over modulus: nothing but round-off

// How far pressure moves the surfaces: p L / E of both.
double elastic_way(const contact::PairRows& pair, double pressure, double pressed) {
  const auto soft = [](const contact::Surface& s) {
    return s.stiffness > 0.0 ? 1.0 / s.stiffness : 0.0;
  };
  return pressure * pressed * (soft(pair.contact) + soft(pair.target));
}

double largest_pressure(const contact::PairRows& pair, const base::Vector& lambda) {
  const auto normals = static_cast<Eigen::Index>(pair.normal.size());
  return normals > 0 ? lambda.head(normals).maxCoeff() : 0.0;
}

// What straight edges on circles leave of the circle; nothing worth telling on curved ones.
double facets(const contact::PairRows& pair, double facet) {
  const contact::SpaceSurface& space = pair.contact.space;
  if (!space.faces.empty()) {
    const bool flat = static_cast<int>(space.faces.front().nodes.size()) ==
                      base::info(space.faces.front().shape).corners;
    const std::optional<contact::Round>& round = space.rounds.front();
    const bool curved = round && round->kind != contact::RoundKind::plane;
    return flat && curved ? facet * facet / (4.0 * round->radius) : 0.0;
  }
  const bool straight = !pair.contact.plane.edges.empty() &&
                        pair.contact.plane.edges.front().count == 2 && pair.contact.circle;
  return straight ? facet * facet / (4.0 * pair.contact.circle->radius) : 0.0;
}

} // namespace

void tell_slides(const Scene& scene, const StepState& state, results::StepResult& out) {
  for (std::size_t c = 0; c < scene.pairs.size(); ++c) {
    const contact::PairRows& pair = scene.pairs[c];
    const bool bonded = scene.contacts[c].type == model::ContactType::bonded;
    if (!state.mounted[c] || bonded || pair.faces || !pair.found || pair.contact.facets.empty()) {
      continue;
    }
    const double pressure = largest_pressure(pair, state.pair_lambda[c]);
    if (!(pressure > no_strain * pair.contact.stiffness)) {
      continue;
    }
    const contact::Slide slide = contact::slide_of(pair, state.pair_lambda[c], state.u);
    const bool far = slide.way > slide.facet && slide.way > most_slide * slide.pressed;
    const bool turned = slide.misfit - facets(pair, slide.facet) >
                        most_misfit * elastic_way(pair, pressure, slide.pressed);
    if (slide.lost <= most_lost && !far && !turned) {
      continue;
    }
    std::string text =
        fmt::format("contact {}: the bodies slide by {:.3g} ({:.2g} element "
                    "lengths) along {:.3g} that is pressed",
                    scene.contacts[c].name, slide.way,
                    slide.facet > 0.0 ? slide.way / slide.facet : 0.0, slide.pressed);
    if (slide.lost > most_lost) {
      text += fmt::format(", and {:.0f} % of the force acts where nothing stands opposite any more",
                          100.0 * slide.lost);
    }
    if (turned) {
      text += fmt::format(", and their gap changes by {:.2g} that small displacements do not see",
                          slide.misfit);
    }
    out.notes.push_back(results::warning(
        text + ": contact pairs bodies as drawn, so this state is not to be trusted"));
  }
}

} // namespace spricka::analysis
