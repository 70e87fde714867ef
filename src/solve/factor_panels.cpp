// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/factor_panels.hpp"
#include "base/index.hpp"

#include <algorithm>

namespace spricka::solve {

using base::at;

namespace {

// Columns of a panel: products as wide as this run at the speed of large ones.
constexpr int panel_columns = 512;
// Rows of a tile: as few as products bear, so that many threads have work at the root.
constexpr int tile_rows = 2048;
// Subtrees with a smaller part of all flops are one piece: enough of them for tens of threads.
constexpr double subtree_share = 1.0 / 128.0;
// Below so many flops, a few milliseconds, more pieces than one cost more than they gain.
constexpr double least_piece_flops = 1e7;

// Elimination of the columns, and what the panel takes off the later ones.
double flops_of(const FactorPanel& p) {
  const double c = p.columns;
  const double below = p.rows - p.columns;
  return p.external ? 0.0 : c * c * c / 3.0 + c * c * below + c * below * below;
}

} // namespace

FactorPanels::FactorPanels(const SupernodalFactor& L) {
  cut(L);
  find_updates();
  make_pieces();
  link_pieces();
}

void FactorPanels::cut(const SupernodalFactor& L) {
  panel_of_.resize(at(L.n));
  for (std::int64_t s = 0; s < L.count; ++s) {
    const std::int64_t* const row = L.row + L.row_start[s];
    const auto rows = static_cast<int>(L.row_start[s + 1] - L.row_start[s]);
    for (std::int64_t first = L.column[s]; first < L.column[s + 1];) {
      // Where locals end a panel ends: externals are not eliminated.
      const bool external = first >= L.locals;
      const std::int64_t limit = external ? L.column[s + 1] : std::min(L.column[s + 1], L.locals);
      const std::int64_t end = std::min(limit, first + panel_columns);
      const auto above = static_cast<int>(first - L.column[s]);
      FactorPanel p{.first = first,
                    .columns = static_cast<int>(end - first),
                    .rows = rows - above,
                    .row = row + above,
                    .value = L.value_start[s] + above + static_cast<std::int64_t>(above) * rows,
                    .stride = rows,
                    .supernode = s,
                    .external = external};
      std::fill(panel_of_.begin() + first, panel_of_.begin() + end,
                static_cast<std::int32_t>(panels_.size()));
      cost_.push_back(flops_of(p));
      flops_ += cost_.back();
      panels_.push_back(p);
      first = end;
    }
  }
}

void FactorPanels::find_updates() {
  // Calls use(updated panel, update) for each pair, earlier panels first.
  const auto for_pairs = [&](const auto& use) {
    for (std::size_t d = 0; d < panels_.size(); ++d) {
      const FactorPanel& p = panels_[d];
      for (int begin = p.columns; begin < p.rows && !p.external;) {
        const std::int32_t above = panel_of_[at(p.row[begin])];
        const std::int64_t limit = panels_[at(above)].first + panels_[at(above)].columns;
        const auto end =
            static_cast<int>(std::lower_bound(p.row + begin, p.row + p.rows, limit) - p.row);
        use(at(above), PanelUpdate{static_cast<std::int32_t>(d), begin, end});
        begin = end;
      }
    }
  };
  first_update_.assign(panels_.size() + 1, 0);
  parent_.assign(panels_.size(), -1);
  for_pairs([&](std::size_t above, const PanelUpdate& u) {
    ++first_update_[above + 1];
    if (parent_[at(u.panel)] < 0) {
      parent_[at(u.panel)] = static_cast<std::int32_t>(above);
    }
  });
  for (std::size_t i = 0; i < panels_.size(); ++i) {
    first_update_[i + 1] += first_update_[i];
  }
  updates_.resize(first_update_.back());
  std::vector<std::size_t> next(first_update_.begin(), first_update_.end() - 1);
  for_pairs([&](std::size_t above, const PanelUpdate& u) { updates_[next[above]++] = u; });
}

void FactorPanels::make_pieces() {
  const auto count = static_cast<std::int32_t>(panels_.size());
  std::vector<double> subtree = cost_;
  std::vector<std::int32_t> first(at(count)); // panel of the subtree
  std::vector<double> path(at(count), 0.0);
  for (std::int32_t i = 0; i < count; ++i) {
    first[at(i)] = i;
  }
  for (std::int32_t i = 0; i < count; ++i) {
    if (const std::int32_t up = parent_[at(i)]; up >= 0) {
      subtree[at(up)] += subtree[at(i)];
      first[at(up)] = std::min(first[at(up)], first[at(i)]);
    }
  }
  for (std::int32_t i = count; i-- > 0;) {
    path[at(i)] = cost_[at(i)] + (parent_[at(i)] < 0 ? 0.0 : path[at(parent_[at(i)])]);
  }
  const double limit = std::max(least_piece_flops, subtree_share * flops_);
  const auto is_small = [&](std::int32_t i) {
    return subtree[at(i)] <= limit && !panels_[at(i)].external;
  };
  piece_of_.resize(at(count));
  for (std::int32_t i = 0; i < count;) {
    // The largest small subtree that begins here is a run of panels, as they are postordered.
    std::int32_t top = i;
    while (is_small(top) && parent_[at(top)] >= 0 && is_small(parent_[at(top)]) &&
           first[at(parent_[at(top)])] == i) {
      top = parent_[at(top)];
    }
    Piece piece{.first = i, .last = top, .path = path[at(top)]};
    if (!is_small(i) || first[at(i)] != i) {
      add_tiles(i, piece);
    }
    std::fill(piece_of_.begin() + i, piece_of_.begin() + top + 1,
              static_cast<std::int32_t>(pieces_.size()));
    pieces_.push_back(std::move(piece));
    i = top + 1;
  }
}

void FactorPanels::add_tiles(std::int32_t panel, Piece& piece) {
  const FactorPanel& p = panels_[at(panel)];
  piece.tile_begin = static_cast<std::int32_t>(tiles_.size());
  const bool one = p.rows <= tile_rows + tile_rows / 2;
  // The first tile is the block on the diagonal, which the others wait for.
  int end = one ? p.rows : p.columns;
  tiles_.push_back({panel, 0, end});
  while (end < p.rows) {
    const int rows = p.rows - end;
    // Of two tiles that would be left none is tiny.
    const int taken = rows <= tile_rows ? rows : std::min(tile_rows, (rows + 1) / 2);
    tiles_.push_back({panel, end, end + taken});
    end += taken;
  }
  piece.tile_end = static_cast<std::int32_t>(tiles_.size());
}

void FactorPanels::link_pieces() {
  for (std::size_t i = 0; i < panels_.size(); ++i) {
    const std::int32_t own = piece_of_[i];
    for (const PanelUpdate* u = updates_begin(i); u != updates_end(i); ++u) {
      std::vector<std::int32_t>& updated = pieces_[at(piece_of(u->panel))].updated;
      if (piece_of(u->panel) != own && (updated.empty() || updated.back() != own)) {
        updated.push_back(own);
      }
    }
  }
  for (Piece& piece : pieces_) {
    std::ranges::sort(piece.updated);
    piece.updated.erase(std::unique(piece.updated.begin(), piece.updated.end()),
                        piece.updated.end());
  }
}

} // namespace spricka::solve
