// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/script_scan.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <set>
#include <system_error>
#include <utility>

namespace spricka::mesh {
namespace {

struct Token {
  enum class TokenKind { word, text, mark };
  TokenKind kind = TokenKind::mark;
  std::string_view text; ///< without quotes
  std::size_t line = 1;
  std::size_t at = 0; ///< in the script

  [[nodiscard]] bool is(std::string_view mark) const {
    return kind != TokenKind::text && text == mark;
  }
};

bool starts_word(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}
bool in_word(char c) {
  return starts_word(c) || std::isdigit(static_cast<unsigned char>(c)) != 0;
}

class Tokens {
public:
  explicit Tokens(std::string_view text) : text_(text) {}

  std::vector<Token> all() {
    std::vector<Token> tokens;
    while (skip_blank()) {
      tokens.push_back(next());
    }
    return tokens;
  }

private:
  [[nodiscard]] bool sees(std::string_view mark) const {
    return text_.substr(at_, mark.size()) == mark;
  }
  void go_to(std::size_t end) {
    end = std::min(end, text_.size());
    const std::string_view passed = text_.substr(at_, end - at_);
    line_ += static_cast<std::size_t>(std::count(passed.begin(), passed.end(), '\n'));
    at_ = end;
  }
  void go_behind(std::string_view mark) {
    const std::size_t found = text_.find(mark, at_);
    go_to(found == std::string_view::npos ? found : found + mark.size());
  }
  bool skip_blank() {
    while (at_ < text_.size()) {
      if (sees("//")) {
        go_to(text_.find('\n', at_));
      } else if (sees("/*")) {
        go_to(at_ + 2);
        go_behind("*/");
      } else if (std::isspace(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '\0') {
        go_to(at_ + 1);
      } else {
        return true;
      }
    }
    return false;
  }
  Token next() {
    Token token{Token::TokenKind::mark, {}, line_, at_};
    std::size_t end = at_ + 1;
    if (const char quote = text_[at_]; quote == '"' || quote == '\'') {
      token.kind = Token::TokenKind::text;
      end = text_.find(quote, end); // a backslash hides nothing from gmsh
      end = std::min(end, text_.size());
      token.text = text_.substr(at_ + 1, end - at_ - 1);
      go_to(end + 1);
      return token;
    }
    if (starts_word(text_[at_])) {
      token.kind = Token::TokenKind::word;
      while (end < text_.size() && in_word(text_[end])) {
        ++end;
      }
    } else if (std::isdigit(static_cast<unsigned char>(text_[at_])) != 0) {
      while (end < text_.size() && (in_word(text_[end]) || text_[end] == '.')) {
        ++end; // 1e3 is no word
      }
    } else if (sees("==")) {
      ++end;
    }
    token.text = text_.substr(at_, end - at_);
    go_to(end);
    return token;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

/// Statements of one kind that a script may not have: the mesher's sandbox stops all of them, but
/// gmsh would pass over some in silence and say of others what helps nobody.
struct ForbiddenKind {
  std::string_view does;
  std::array<std::string_view, 6> words; ///< the rest is empty
};

constexpr std::array forbidden{
    ForbiddenKind{
        "runs a command",
        {"SystemCall", "NonBlockingSystemCall", "OnelabRun", "ExternalProcess", "Plugin"}},
    ForbiddenKind{"reads another file",
                  {"Merge", "Include", "MergeWithBoundingBox", "ShapeFromFile", "ListFromFile",
                   "FileExists"}},
    ForbiddenKind{"reads the environment", {"GetEnv"}},
    ForbiddenKind{"ends gmsh", {"Exit", "Abort"}},
    ForbiddenKind{"works on results, not on a geometry", {"View", "Combine", "Alias"}},
};

/// Statements that write what nobody reads here.
constexpr std::array<std::string_view, 3> writing{"Save", "Print", "CreateDir"};

class Scanner {
public:
  explicit Scanner(std::string_view text) : text_(text), tokens_(Tokens(text).all()) {}

  ScriptScan run() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (tokens_[i].kind == Token::TokenKind::word) {
        scan_.words.emplace(tokens_[i].text);
        look_outside(i);
        look_at_writing(i);
        look_at_scale(i);
        look_at_block(i);
        if (tokens_[i].text == "DefineConstant" && token(i + 1).is("[") && i >= behind_constants_) {
          behind_constants_ = constants(i + 2);
        } else {
          assignment(i);
        }
      }
    }
    for (const ScriptBlock& block :
         open_) { // gmsh reads a script that is cut off as if it were whole
      scan_.outreach.push_back(
          {block.line, std::string(block.begin), "is not ended by " + std::string(block.end)});
    }
    return std::move(scan_);
  }

private:
  [[nodiscard]] const Token& token(std::size_t i) const {
    static const Token none;
    return i < tokens_.size() ? tokens_[i] : none;
  }

  void look_outside(std::size_t i) {
    if (token(i + 1).is(".") || i < behind_passed_) {
      return; // an option: View.Light, Print.Text
    }
    for (const ForbiddenKind& kind : forbidden) {
      if (std::ranges::find(kind.words, tokens_[i].text) != kind.words.end()) {
        scan_.outreach.push_back(
            {tokens_[i].line, std::string(tokens_[i].text), std::string(kind.does), remedy_of(i)});
      }
    }
  }

  [[nodiscard]] std::string remedy_of(std::size_t i) const {
    const std::string_view file = token(i + 1).text;
    const bool step = token(i + 1).kind == Token::TokenKind::text &&
                      (file.ends_with(".step") || file.ends_with(".stp") ||
                       file.ends_with(".STEP") || file.ends_with(".STP"));
    return tokens_[i].text == "Merge" && step ? "$IMPORT FILE='..' FORMAT=STEP reads such a file"
                                              : "";
  }

  [[nodiscard]] bool begins_statement(std::size_t i) const {
    return i == 0 || token(i - 1).is(";") || token(i - 1).is("}") || token(i - 1).is(")") ||
           token(i - 1).is("]") || token(i - 1).is("EndIf") || token(i - 1).is("EndFor") ||
           token(i - 1).is("Else");
  }

  /// A whole statement that writes a file is left out; what is no whole one is refused.
  void look_at_writing(std::size_t i) {
    if (token(i + 1).is(".") || i < behind_passed_) {
      return;
    }
    const Token& t = tokens_[i];
    if (t.text == "SaveAll" && i > 1 && token(i - 1).is(".") && token(i - 2).is("Mesh") &&
        token(i + 1).is("=") && token(i + 2).text != "0") {
      scan_.passed_over.push_back({t.line, "Mesh.SaveAll", "says what gmsh writes to a file"});
    }
    if (std::ranges::find(writing, t.text) == writing.end()) {
      return;
    }
    std::size_t end = i + 1;
    while (end < tokens_.size() && !tokens_[end].is(";") && !tokens_[end].is("{") &&
           !tokens_[end].is("}")) {
      ++end;
    }
    if (begins_statement(i) && token(end).is(";")) {
      scan_.passed_over.push_back({t.line, std::string(t.text), "writes a file"});
      scan_.passed_over_at.emplace_back(t.at, tokens_[end].at + 1);
      behind_passed_ = end;
    } else {
      scan_.outreach.push_back({t.line, std::string(t.text), "writes a file"});
    }
  }

  /// Coordinates are scaled where gmsh writes them to a file, not where they are read here: no
  /// other factor than a plain 1 is let through.
  void look_at_scale(std::size_t i) {
    if (tokens_[i].text != "ScalingFactor" || i == 0 || !token(i - 1).is(".")) {
      return;
    }
    const bool changed = std::string_view("+-*/").find(token(i + 1).text) != std::string_view::npos;
    const std::size_t equal = changed ? i + 2 : i + 1;
    if (!token(equal).is("=")) {
      return; // only read
    }
    const std::string_view value = token(equal + 1).text;
    double factor = 0.0;
    const auto [end, trouble] = std::from_chars(value.data(), value.data() + value.size(), factor);
    const bool plain = trouble == std::errc() && end == value.data() + value.size();
    if (changed || !plain || factor != 1.0 || !token(equal + 2).is(";")) {
      scan_.outreach.push_back(
          {tokens_[i].line, "Mesh.ScalingFactor",
           "scales what gmsh writes alone (SCALE of $IMPORT scales the mesh)"});
    }
  }

  struct ScriptBlock {
    std::string_view begin, end;
    std::size_t line = 0;
  };

  void look_at_block(std::size_t i) {
    constexpr std::array blocks{std::pair<std::string_view, std::string_view>{"For", "EndFor"},
                                std::pair<std::string_view, std::string_view>{"If", "EndIf"}};
    for (const auto& [begin, end] : blocks) {
      if (tokens_[i].text == begin) {
        open_.push_back({begin, end, tokens_[i].line});
      } else if (tokens_[i].text == end && !open_.empty() && open_.back().end == end) {
        open_.pop_back();
      }
    }
  }

  // Returns where it ends. a = 3, b = {4, Name "B"}, c[] = {..}, d
  std::size_t constants(std::size_t i) {
    int depth = 0;
    bool at_name = true;
    for (; i < tokens_.size(); ++i) {
      const Token& t = tokens_[i];
      if (depth == 0 && t.is("]")) {
        break;
      }
      if (depth == 0 && at_name && t.kind == Token::TokenKind::word &&
          (token(i + 1).is("=") || token(i + 1).is(",") || token(i + 1).is("]"))) {
        add(constants_, scan_.constants, {std::string(t.text), t.line, default_of(i + 1)});
      }
      at_name = depth == 0 && t.is(",");
      depth += t.is("(") || t.is("[") || t.is("{") ? 1 : 0;
      depth -= t.is(")") || t.is("]") || t.is("}") ? 1 : 0;
    }
    return i;
  }

  /// What stands behind the equals sign, up to the comma or bracket that ends it.
  [[nodiscard]] std::string default_of(std::size_t i) const {
    if (!token(i).is("=")) {
      return {};
    }
    int depth = 0;
    std::size_t end = i + 1;
    for (; end < tokens_.size(); ++end) {
      const Token& t = tokens_[end];
      if (depth == 0 && (t.is(",") || t.is("]"))) {
        break;
      }
      depth += t.is("(") || t.is("[") || t.is("{") ? 1 : 0;
      depth -= t.is(")") || t.is("]") || t.is("}") ? 1 : 0;
    }
    const std::size_t from = token(i + 1).at;
    const std::size_t to = end < tokens_.size() ? tokens_[end].at : text_.size();
    std::string written(text_.substr(from, std::min<std::size_t>(to - std::min(from, to), 40)));
    std::replace_if(
        written.begin(), written.end(),
        [](unsigned char c) { return std::isspace(c) != 0 || std::iscntrl(c) != 0; }, ' ');
    written.erase(written.find_last_not_of(' ') + 1);
    return written;
  }

  // name = ..;  at the begin of a statement
  void assignment(std::size_t i) {
    if (begins_statement(i) && token(i + 1).is("=")) {
      add(assigned_, scan_.assigned, {std::string(tokens_[i].text), tokens_[i].line, {}});
    }
  }

  static void add(std::set<std::string>& met, std::vector<ScriptAssignment>& names,
                  ScriptAssignment name) {
    if (met.insert(name.name).second) {
      names.push_back(std::move(name));
    }
  }

  std::string_view text_;
  std::vector<Token> tokens_;
  std::set<std::string> constants_, assigned_; ///< names met
  std::size_t behind_constants_ = 0;           ///< what was looked through as DefineConstant
  std::size_t behind_passed_ = 0;              ///< of a statement that is passed over
  std::vector<ScriptBlock> open_;              ///< not ended so far
  ScriptScan scan_;
};

} // namespace

ScriptScan scan_script(std::string_view text) {
  return Scanner(text).run();
}

} // namespace spricka::mesh
