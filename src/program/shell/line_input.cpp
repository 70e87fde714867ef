// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/shell/line_input.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <utility>

// readline.h needs stdio.h before it.
#include <readline/history.h>
#include <readline/readline.h>

namespace spricka::program {

namespace {

constexpr int lines_kept = 1000;

// readline calls plain functions without an argument of ours, and a signal handler reaches nothing
// but what is static: these two are all they share with the one LineEditor.
volatile std::sig_atomic_t pressed = 0; // NOLINT
LineEditor::Complete completer;         // NOLINT

void on_interrupt(int /*signal*/) {
  pressed = 1;
}

// Called by readline while it waits for a key, and when a signal ended that.
int clear_line() {
  if (pressed != 0) {
    pressed = 0;
    std::fputs("^C\n", rl_outstream);
    rl_replace_line("", 0);
    rl_on_new_line();
    rl_redisplay();
  }
  return 0;
}

// malloc'ed copies, as readline frees them.
char** as_matches(const std::vector<std::string>& found) {
  std::string common = found.front();
  for (const std::string& word : found) {
    std::size_t same = 0;
    while (same < common.size() && same < word.size() && common[same] == word[same]) {
      ++same;
    }
    common.resize(same);
  }
  auto** matches = static_cast<char**>(std::calloc(found.size() + 2, sizeof(char*))); // NOLINT
  matches[0] = strdup(common.c_str());
  for (std::size_t i = 0; i < found.size(); ++i) {
    matches[i + 1] = strdup(found[i].c_str());
  }
  if (found.size() == 1) {
    std::free(matches[1]); // NOLINT
    matches[1] = nullptr;
  }
  return matches;
}

char** complete_word(const char* /*typed*/, int start, int end) {
  rl_completion_append_character = ' ';
  if (!completer) {
    return nullptr;
  }
  const std::string_view line(rl_line_buffer, static_cast<std::size_t>(end));
  const std::vector<std::string> found = completer(line, static_cast<std::size_t>(start));
  if (found.empty()) { // readline's own completion: names of files, for commands that take one
    const bool file = line.starts_with("save ") || line.starts_with("plot ");
    rl_attempted_completion_over = file ? 0 : 1;
    return nullptr;
  }
  if (line.find('(') != std::string_view::npos) {
    rl_completion_append_character = '\0';
  }
  return as_matches(found);
}

std::filesystem::path history_file() {
  const char* state = std::getenv("XDG_STATE_HOME");
  const char* home = std::getenv("HOME");
  std::filesystem::path folder;
  if (state != nullptr && *state != '\0') {
    folder = state;
  } else if (home != nullptr && *home != '\0') {
    folder = std::filesystem::path(home) / ".local" / "state";
  } else {
    return {};
  }
  folder /= "spricka";
  std::error_code trouble;
  std::filesystem::create_directories(folder, trouble);
  return trouble ? std::filesystem::path() : folder / "shell_history";
}

} // namespace

LineEditor::LineEditor() : history_(history_file()) {
  rl_readline_name = "spricka";
  rl_outstream = stderr;
  rl_catch_signals = 0; // ours, which stops a computation as well
  rl_signal_event_hook = clear_line;
  rl_event_hook = clear_line; // ten times a second: a signal may come while no key is waited for
  rl_attempted_completion_function = complete_word;
  rl_completer_word_break_characters = " \t=(,'";
  using_history();
  stifle_history(lines_kept);
  if (!history_.empty()) {
    read_history(history_.c_str());
  }
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  sigemptyset(&action.sa_mask);
  action.sa_flags = 0; // no SA_RESTART: reading a key has to end
  sigaction(SIGINT, &action, &old_int_);
}

LineEditor::~LineEditor() {
  sigaction(SIGINT, &old_int_, nullptr);
  rl_signal_event_hook = nullptr;
  rl_event_hook = nullptr;
  completer = nullptr;
  if (!history_.empty()) {
    write_history(history_.c_str());
  }
}

void LineEditor::set_completion_function(Complete complete) {
  completer = std::move(complete);
}

bool LineEditor::was_ctrl_c_pressed() {
  return pressed != 0;
}

bool LineEditor::read(const std::string& prompt, std::string& line) {
  pressed = 0;
  char* typed = readline(prompt.c_str());
  if (typed == nullptr) {
    std::fputc('\n', stderr);
    return false;
  }
  line = typed;
  std::free(typed); // NOLINT: malloc'ed by readline
  if (line.find_first_not_of(" \t") != std::string::npos) {
    add_history(line.c_str());
  }
  return true;
}

} // namespace spricka::program
