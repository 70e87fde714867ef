// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/make_scene.hpp"
#include "base/diagnostics.hpp"
#include "base/messages.hpp"
#include "deck/read_deck.hpp"
#include "growth/crack_lines.hpp"
#include "model/model.hpp"

#include <cstdio>
#include <optional>
#include <vector>

#include <fmt/format.h>

namespace spricka::bench {

/// A deck with its cracks at their first length.
class DiscretisedDeck {
public:
  /// What is wrong goes to stderr, with `usage` where the deck (null: none is given) cannot be
  /// read.
  DiscretisedDeck(const char* deck, const char* usage)
      : model_(deck != nullptr ? deck::read_deck(deck, {}, sources_, diagnostics_) : std::nullopt) {
    if (!model_) {
      fmt::print(stderr, "usage: {}\n", usage);
    } else {
      const std::vector<double> lengths = growth::growth_loop_crack_lengths(*model_);
      scene_ = analysis::discretise(*model_, lengths.front(),
                                    analysis::plan_crack_region(*model_, lengths, diagnostics_),
                                    diagnostics_);
    }
    if (!scene_) {
      fmt::print(stderr, "{}", base::format_messages(sources_, diagnostics_));
    }
  }

  /// Of the program: 0, 2 where the deck cannot be read, 3 where there is no mesh of it.
  [[nodiscard]] int exit_code() const { return scene_ ? 0 : model_ ? 3 : 2; }
  [[nodiscard]] const model::Model& model() const { return *model_; }
  [[nodiscard]] const analysis::Discretisation& scene() const { return *scene_; }

private:
  base::SourceTexts sources_;
  base::Diagnostics diagnostics_;
  std::optional<model::Model> model_;
  std::optional<analysis::Discretisation> scene_;
};

} // namespace spricka::bench
