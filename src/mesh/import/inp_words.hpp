// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "mesh/import/import_request.hpp"
#include "mesh/import/inp_data.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace spricka::mesh {

/// Says what is wrong with an Abaqus input file: at the card that imports it, with the file's line.
class InpMessages {
public:
  InpMessages(const ImportRequest& request, const InpData& data, base::Diagnostics& diagnostics)
      : request_(request), data_(data), diagnostics_(diagnostics) {}

  /// An error at a line of the file, reported at the card that imports it.
  void error(InpLocation at, std::string code, const std::string& text, std::string hint = {}) {
    diagnostics_.error(request_.span, std::move(code),
                       fmt::format("{}: {}", place(at), shown(at, text)), std::move(hint));
  }
  /// A warning at a line of the file, reported at the first card that imports it.
  void warning(InpLocation at, std::string code, const std::string& text, std::string hint = {}) {
    if (!request_.reported) {
      diagnostics_.warning(request_.span, std::move(code), fmt::format("{}: {}", place(at), text),
                           std::move(hint));
    }
  }

private:
  /// An included file may be any that this user can read, named by somebody else's input: what its
  /// lines hold is not repeated.
  static std::string shown(InpLocation at, const std::string& text) {
    const std::size_t first = text.find('\'');
    const std::size_t last = text.rfind('\'');
    return at.file == 0 || first == last
               ? text
               : fmt::format("{}'..'{}", text.substr(0, first), text.substr(last + 1));
  }
  [[nodiscard]] std::string place(InpLocation at) const {
    const std::string own = request_.file.filename().string();
    const std::string name = at.file < data_.files.size()
                                 ? std::filesystem::path(data_.files[at.file]).filename().string()
                                 : own;
    return at.line > 0 ? fmt::format("{}:{}", name, at.line) : own;
  }

  const ImportRequest& request_;
  const InpData& data_;
  base::Diagnostics& diagnostics_;
};

} // namespace spricka::mesh
