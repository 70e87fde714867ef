// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solve/supernodes.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace spricka::solve {

/// Some neighbouring columns of one supernode, which are eliminated together.
struct FactorPanel {
  std::int64_t first = 0; ///< column
  int columns = 0;
  int rows = 0;                      ///< its own, and those below
  const std::int64_t* row = nullptr; ///< [rows] ascending, its own first
  std::int64_t value = 0;            ///< place of its first entry
  int stride = 0;
  std::int64_t supernode = 0;
  bool external = false; ///< updated, but not eliminated
};

/// What an earlier panel takes off a later one: its rows [begin, end) are columns of that.
struct PanelUpdate {
  std::int32_t panel = 0;
  int begin = 0, end = 0; ///< places in its row list
};

/// Rows [begin, end) of a panel, worked on by one thread at a time.
struct PanelTile {
  std::int32_t panel = 0;
  int begin = 0, end = 0;
  [[nodiscard]] bool has_diagonal() const { return begin == 0; }
};

/// A factor cut up for work on several threads, in a way that depends on the factor alone: every
/// sum is taken in one order whatever the threads. Supernodes are cut into panels of few columns,
/// and panels into tiles of few rows. Small subtrees of panels are one piece of work each, as a
/// substructure is; the panels above them, the separators of the dissection, are worked on tile by
/// tile.
class FactorPanels {
public:
  explicit FactorPanels(const SupernodalFactor& L);

  [[nodiscard]] const std::vector<FactorPanel>& panels() const { return panels_; }
  /// The updates of a panel, in the order in which they are taken off it.
  [[nodiscard]] const PanelUpdate* updates_begin(std::size_t panel) const {
    return updates_.data() + first_update_[panel];
  }
  [[nodiscard]] const PanelUpdate* updates_end(std::size_t panel) const {
    return updates_.data() + first_update_[panel + 1];
  }
  /// A piece of work whose end others wait for: the panels [first, last] of a subtree, or one panel
  /// above the subtrees, by its tiles.
  struct Piece {
    std::int32_t first = 0, last = 0;
    std::int32_t tile_begin = 0, tile_end = 0; ///< none: a subtree
    double path = 0.0;                         ///< flops from here to the last panel of the factor
    std::vector<std::int32_t> updated = {};    ///< later pieces that wait for this one
    [[nodiscard]] bool is_subtree() const { return tile_begin == tile_end; }
  };
  [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }
  [[nodiscard]] std::int32_t piece_of(std::int32_t panel) const {
    return piece_of_[static_cast<std::size_t>(panel)];
  }
  [[nodiscard]] const std::vector<PanelTile>& tiles() const { return tiles_; }
  [[nodiscard]] double flops() const { return flops_; } ///< of all panels
  [[nodiscard]] std::int64_t columns() const { return static_cast<std::int64_t>(panel_of_.size()); }

private:
  void cut(const SupernodalFactor& L);
  void find_updates();
  void make_pieces();
  void add_tiles(std::int32_t panel, Piece& piece);
  void link_pieces();

  std::vector<FactorPanel> panels_;
  std::vector<std::int32_t> panel_of_; ///< [n] of each column
  std::vector<std::int32_t> parent_;   ///< [panel] the next that it updates, -1: none
  std::vector<double> cost_;           ///< [panel] flops
  std::vector<std::size_t> first_update_;
  std::vector<PanelUpdate> updates_;
  std::vector<std::int32_t> piece_of_;
  std::vector<Piece> pieces_;
  std::vector<PanelTile> tiles_;
  double flops_ = 0.0;
};

} // namespace spricka::solve
