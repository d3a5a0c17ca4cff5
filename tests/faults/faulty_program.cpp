#include "faults/faulty_program.h"

#include "faults/failing_calls.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace lacuna {
namespace {

namespace fs = std::filesystem;

/// The two numbers of a `FailureCount`.
std::pair<std::uint64_t, std::uint64_t> counted_in(const Program& program, const std::string& file) {
  const std::string bytes = program.read(file);
  std::uint64_t calls = 0, failures = 0;
  if (bytes.size() < sizeof(FailureCount)) return {0, 0};
  std::memcpy(&calls, bytes.data(), sizeof calls);
  std::memcpy(&failures, bytes.data() + sizeof calls, sizeof failures);
  return {calls, failures};
}

void remove_content(const fs::path& folder) {
  std::vector<fs::path> all;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) all.push_back(entry.path());
  for (const fs::path& one : all) fs::remove_all(one);
}

}  // namespace

std::string text_of(const Fault& fault) {
  return (fault.allocation ? "allocation " : "call ") + std::to_string(fault.at) +
         (fault.lasting ? " and all after it" : "");
}

FaultyProgram::FaultyProgram(const Program& prepared)
    : prepared_(kept_.folder() / "prepared"), count_(kept_.folder() / "count") {
  fs::copy(prepared.folder(), prepared_, fs::copy_options::recursive);
}

void FaultyProgram::put_back() const {
  remove_content(program_.folder());
  fs::copy(prepared_, program_.folder(), fs::copy_options::recursive);
}

FaultyOutcome FaultyProgram::run_in_folder(const std::string& command, const std::string& variables) {
  put_back();
  kept_.write("count", std::string(sizeof(FailureCount), '\0'));
  const Outcome outcome =
      program_.shell("LD_PRELOAD='" LACUNA_FAILING_CALLS "' LACUNA_FAIL_FOLDER='" + program_.folder().string() +
                     "' LACUNA_FAIL_COUNT='" + count_.string() + "' " + variables + command);
  return {outcome, counted_in(kept_, "count").second > 0};
}

std::uint64_t FaultyProgram::count(const std::string& command, bool allocations) {
  run_in_folder(command, allocations ? "LACUNA_FAIL_WHAT=allocations " : "");
  return counted_in(kept_, "count").first;
}

FaultyOutcome FaultyProgram::run(const std::string& command, const Fault& fault) {
  return run_in_folder(command, "LACUNA_FAIL_AT=" + std::to_string(fault.at) +
                                    (fault.lasting ? " LACUNA_FAIL_LASTING=yes" : "") +
                                    (fault.allocation ? " LACUNA_FAIL_WHAT=allocations " : " "));
}

std::set<std::string> FaultyProgram::new_names() const {
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(program_.folder()))
    if (const std::string name = entry.path().filename();
        !fs::exists(prepared_ / name) && !name.ends_with("-wal") && !name.ends_with("-shm"))
      names.insert(name);
  return names;
}

std::vector<Fault> faults_to_try(std::uint64_t count, bool allocations, std::uint64_t most) {
  const char* const seed = std::getenv("LACUNA_FAULTS_SEED");
  const std::uint64_t shift = seed != nullptr ? std::strtoull(seed, nullptr, 10) : 0;
  if (std::getenv("LACUNA_ALL_FAULTS") != nullptr) most = count;
  const std::uint64_t tried = std::min(count, most);
  std::vector<Fault> faults;
  for (std::uint64_t i = 0; i < tried; ++i)
    for (const bool lasting : {false, true})
      faults.push_back({allocations, lasting, 1 + (i * count / tried + shift) % count});
  return faults;
}

}  // namespace lacuna
