// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/trials/run_record.hpp"

#include "base/exit_codes.hpp"
#include "base/input_file.hpp"
#include "program/job/point_record.hpp"
#include "program/job/run_folder.hpp"

#include <csignal>

#include <nlohmann/json.hpp>

namespace spricka::program {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* run_record_name = "run.json";

} // namespace

fs::path record_folder(const fs::path& run_folder) {
  fs::path folder = run_folder;
  folder += ".end";
  return folder;
}

void write_run_record(const fs::path& run_folder, const ChildProcessResult& end,
                      const std::string& digest) {
  const json record{{"digest", digest},
                    {"exit_code", end.exit_code},
                    {"signal", end.signal},
                    {"late", end.late},
                    {"cpu", end.cpu},
                    {"wall", end.wall},
                    {"memory", end.peak_memory},
                    {"machine", machine_description()},
                    {"messages", end.messages}};
  RunFolder folder(record_folder(run_folder));
  folder.add_file(run_record_name,
                  record.dump(-1, ' ', false, json::error_handler_t::replace) + "\n");
  folder.commit();
}

std::optional<ChildProcessResult> read_run_record(const fs::path& run_folder,
                                                  const std::string& digest) {
  try {
    const json record = json::parse(
        base::read_file(record_folder(run_folder) / run_record_name, base::largest_number_file));
    if (record.at("digest").get<std::string>() != digest) {
      return std::nullopt;
    }
    ChildProcessResult end;
    end.exit_code = record.at("exit_code").get<int>();
    end.signal = record.at("signal").get<int>();
    end.late = record.at("late").get<bool>();
    end.cpu = record.at("cpu").get<double>();
    end.wall = record.at("wall").get<double>();
    end.peak_memory = record.at("memory").get<std::size_t>();
    end.machine = record.at("machine").get<std::string>();
    end.messages = record.at("messages").get<std::string>();
    return end;
  } catch (const json::exception&) {
    return std::nullopt; // not whole: as good as none
  } catch (const base::UnreadableFile&) {
    return std::nullopt;
  }
}

bool ended_with_results(const ChildProcessResult& end) {
  const std::optional<base::ProgramOutcome> outcome = base::outcome_of_exit_code(end.exit_code);
  return !end.late && outcome && has_results(*outcome);
}

bool ended_by_itself(const ChildProcessResult& end) {
  if (end.late) {
    return true;
  }
  if (end.signal != 0) {
    return end.signal == SIGSEGV || end.signal == SIGABRT || end.signal == SIGFPE ||
           end.signal == SIGILL || end.signal == SIGBUS;
  }
  const std::optional<base::ProgramOutcome> outcome = base::outcome_of_exit_code(end.exit_code);
  const bool taken = outcome == base::ProgramOutcome::file_trouble &&
                     end.messages.find("E465") != std::string::npos;
  return outcome && outcome != base::ProgramOutcome::stopped && !taken;
}

} // namespace spricka::program
