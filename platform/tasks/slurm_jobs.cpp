#include "tasks/slurm_jobs.h"

#include "foundation/processes/child_program.h"
#include "foundation/text/plain_text.h"
#include "foundation/text/shell_word.h"
#include "foundation/files/whole_file.h"

#include <lacuna/error.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace lacuna {
namespace {

constexpr double kLongestSubmission = 60.0;  // s
constexpr int kNoSuchProgram = 127;

/// The shell's place is taken by the program, so that signals reach it and nothing outlives it.
std::string script(const std::string& command) { return "#!/bin/bash\nexec " + command + "\n"; }

void write_scripts(const TaskFolder& folder, const std::filesystem::path& program,
                   const std::filesystem::path& database) {
  const std::string lacuna = shell_word(program.string()), plan = shell_word(folder.path().string());
  write_whole(folder.path() / "task.sh", script(lacuna + " task run " + plan + " \"$SLURM_ARRAY_TASK_ID\""),
              Link::replaced);
  write_whole(folder.path() / "merge.sh", script(lacuna + " merge " + shell_word(database.string()) + " " + plan),
              Link::replaced);
}

/// The number of the job.
std::string submit(std::vector<std::string> words) {
  CapturedOutput output("sbatch output"), errors("sbatch errors");
  words.insert(words.begin(), {"sbatch", "--parsable"});
  const std::string command = fmt::format("{}", fmt::join(words, " "));
  // Slurm passes the environment on; a job on this machine is not a child of this program.
  words.insert(words.begin(), {"env", "-u", kChildMark});
  ChildProgram sbatch(
      {.words = words, .folder = {}, .environment = {}, .output = output.file(), .errors = errors.file()});
  const auto ended = sbatch.ended_within(kLongestSubmission);
  if (!ended)
    throw Error(fmt::format("`{}` did not answer within {:g} s; check that Slurm's controller is running", command,
                            kLongestSubmission));
  if (ended->code() == kNoSuchProgram) throw Error("sbatch was not found; --executor slurm needs Slurm's commands");
  if (ended->code() != 0) throw Error(fmt::format("`{}` {}: {}", command, ended->phrase(), errors.end()));
  const std::string answer = output.end(), number = answer.substr(0, answer.find_first_of(";\n"));
  if (number.empty() || number.find_first_not_of("0123456789") != std::string::npos)
    throw Error(fmt::format("`{}` answered without the number of a job: {}", command, plain_text(answer)));
  return number;
}

/// Slurm replaces what begins with % in the names of such files.
std::string log_pattern(const std::filesystem::path& folder, const std::string& name) {
  std::string pattern;
  for (const char c : folder.string()) pattern += c == '%' ? "%%" : std::string(1, c);
  return pattern + "/" + name;
}

}  // namespace

std::string array_of(const std::vector<std::size_t>& numbers) {
  std::string ranges;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    ranges += (ranges.empty() ? "" : ",") + std::to_string(numbers[i]);
    if (last > i) ranges += "-" + std::to_string(numbers[last]);
    i = last + 1;
  }
  return ranges;
}

std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  bool inside = false;
  char quote = 0;
  for (const char c : line) {
    if (quote == 0 && (c == '"' || c == '\'')) {
      quote = c;
    } else if (c == quote) {
      quote = 0;
    } else if (quote == 0 && c == ' ') {
      inside = false;
      continue;
    } else {
      if (!inside) words.emplace_back();
      words.back() += c;
    }
    if (!inside && quote != 0) words.emplace_back();
    inside = true;
  }
  if (quote != 0) throw Error(line + ": a quote is not closed");
  return words;
}

SlurmJobs submit_to_slurm(const TaskFolder& folder, const std::filesystem::path& program,
                          const std::vector<std::string>& options, const std::filesystem::path& database) {
  write_scripts(folder, program, database);
  const std::filesystem::path logs = folder.path() / "logs";
  std::vector<std::string> array = {"--job-name=lacuna",
                                    "--requeue",
                                    "--open-mode=append",
                                    "--signal=B:USR1@60",
                                    "--array=" + array_of(folder.open_tasks()),
                                    "--output=" + log_pattern(logs, "%a.log")};
  std::vector<std::string> merge = {"--job-name=lacuna-merge", "--output=" + log_pattern(logs, "merge.log")};
  array.insert(array.end(), options.begin(), options.end());
  merge.insert(merge.end(), options.begin(), options.end());
  array.push_back((folder.path() / "task.sh").string());
  SlurmJobs jobs;
  jobs.array = submit(array);
  merge.push_back("--dependency=afterany:" + jobs.array);
  merge.push_back((folder.path() / "merge.sh").string());
  try {
    jobs.merge = submit(merge);
  } catch (const Error& refused) {
    throw Error(fmt::format("{}\nthe tasks are submitted as Slurm job {}; when it has ended: lacuna merge {} {}",
                            refused.what(), jobs.array, shell_word(database.string()),
                            shell_word(folder.path().string())));
  }
  return jobs;
}

}  // namespace lacuna
