#include "plugin_checks/exercises/exercises.h"
#include "plugin_checks/genome_inputs.h"

#include <lacuna/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr int kMostParts = 400;            // generations, after which a search counts as too long for this check
constexpr std::size_t kMostAsked = 20000;  // individuals
constexpr double kInvalid = std::numeric_limits<double>::infinity();

std::vector<double> numbers_of(const ScoredIndividual& one) {
  std::vector<double> numbers = {one.score, static_cast<double>(one.individual.number)};
  numbers.insert(numbers.end(), one.individual.genome.begin(), one.individual.genome.end());
  return numbers;
}

class SearchExercise : public Exercise {
 public:
  explicit SearchExercise(const SearchStrategy& strategy) : strategy_(strategy) {}

  ParameterDeclarations declared() const override { return strategy_.parameters(); }
  /// Upper bounds of populations and generations are never reached in practice.
  std::vector<Setting> settings() const override {
    const ParameterDeclarations declared = strategy_.parameters();
    std::vector<Setting> all = {settings_of(declared).front()};
    for (std::size_t i = 0; i < declared.size(); ++i) {
      all.push_back(all.front());
      all.back()[i] = declared[i].lower;
    }
    return all;
  }

  void go(const Setting& setting, Transcript& transcript) const override {
    const std::unique_ptr<Search> search = begin(setting);
    std::size_t asked = 0;
    for (int part = 0; part < kMostParts && asked < kMostAsked && !search->finished(); ++part) {
      const std::vector<Individual> individuals = search->ask();
      for (const Individual& one : individuals) transcript.add("ask", one.genome);
      asked += individuals.size();
      search->tell(scores_of(individuals));
    }
    transcript.add("save", search->save(), Transcript::May::be_infinite);
    for (const ScoredIndividual& one : search->best())
      transcript.add("best", numbers_of(one), Transcript::May::be_infinite);
  }

  std::vector<std::string> broken_promises() const override;

  std::vector<RepeatedCall> repeated_calls() const override {
    const Setting setting = settings().front();
    std::unique_ptr<Search> search = begin(setting);
    std::vector<double> scores;
    return {repeated_call("ask and tell, a generation", true, 1, [&] {
      if (search->finished()) search = begin(setting);
      search->tell(scores = scores_of(search->ask()));
    })};
  }

 private:
  std::unique_ptr<Search> begin(const Setting& setting, std::uint64_t key = 1) const {
    std::unique_ptr<Search> search = strategy_.begin({layout_, breeder_, {key, 2, 3}, {}}, setting);
    if (search == nullptr) throw Error("begin returned nothing; return a new search");
    return search;
  }
  /// A tenth of all genomes cannot be evaluated.
  std::vector<double> scores_of(const std::vector<Individual>& individuals) const {
    std::vector<double> scores;
    for (const Individual& one : individuals)
      scores.push_back(one.genome.empty() || one.genome[0] > 6.4 ? kInvalid : distance(layout_, one.genome));
    return scores;
  }
  std::string fault_of_course(Search& search) const;
  bool goes_on(const Setting& setting) const;

  const SearchStrategy& strategy_;
  const GenomeLayout layout_ = layout_in_rows();
  const PlainBreeder breeder_{layout_};
};

/// The first fault of a search in progress; empty: none.
std::string SearchExercise::fault_of_course(Search& search) const {
  std::uint64_t next = 0;
  double least = kInvalid;
  int last = 0;
  for (int part = 0; part < kMostParts && next < kMostAsked && !search.finished(); ++part) {
    const std::vector<Individual> asked = search.ask();
    if (asked.empty()) return "ask() returns no individual before the search has finished; return at least one";
    for (const Individual& one : asked) {
      if (one.number != next++) return "individuals are not numbered consecutively; derive from GenerationalSearch";
      if (const std::string fault = genome_fault(layout_, one.genome); !fault.empty())
        return "a genome does not match the layout: " + fault;
    }
    const std::vector<double> scores = scores_of(asked);
    search.tell(scores);
    least = std::min(least, *std::min_element(scores.begin(), scores.end()));
    const std::vector<ScoredIndividual> best = search.best();
    if (best.empty() || best.front().score != least)
      return "best() loses the best individual that tell() passed; keep it";
    if (search.generation() < last || search.generation() > search.generations())
      return "generation() does not count from 0 to generations()";
    last = search.generation();
  }
  return {};
}

/// Whether a search that was saved and loaded asks for the same individuals as before.
bool SearchExercise::goes_on(const Setting& setting) const {
  const std::unique_ptr<Search> whole = begin(setting), resumed = begin(setting);
  for (int part = 0; part < 3 && !whole->finished(); ++part) whole->tell(scores_of(whole->ask()));
  resumed->load(whole->save());
  for (int part = 0; part < 3 && !whole->finished(); ++part) {
    const std::vector<Individual> of_whole = whole->ask(), of_resumed = resumed->ask();
    if (of_whole.size() != of_resumed.size()) return false;
    for (std::size_t i = 0; i < of_whole.size(); ++i)
      if (of_whole[i].genome != of_resumed[i].genome || of_whole[i].number != of_resumed[i].number) return false;
    whole->tell(scores_of(of_whole));
    resumed->tell(scores_of(of_resumed));
  }
  return true;
}

std::vector<std::string> SearchExercise::broken_promises() const {
  std::vector<std::string> broken;
  const Setting setting = settings().front();
  if (const std::string fault = fault_of_course(*begin(setting)); !fault.empty()) broken.push_back(fault);
  if (!goes_on(setting))
    broken.emplace_back(
        "a search that was saved and loaded continues differently; save its whole memory, and draw only from "
        "stream(index)");
  const std::unique_ptr<Search> one = begin(setting, 1), other = begin(setting, 2);
  const std::vector<Individual> of_one = one->ask(), of_other = other->ask();
  const bool same = of_one.size() == of_other.size() &&
                    std::equal(of_one.begin(), of_one.end(), of_other.begin(),
                               [](const Individual& a, const Individual& b) { return a.genome == b.genome; });
  if (same) broken.emplace_back("two keys give the same search; take random numbers from the task's key");
  return broken;
}

}  // namespace

std::unique_ptr<Exercise> exercise_of(const SearchStrategy& strategy, const ExerciseInputs&) {
  return std::make_unique<SearchExercise>(strategy);
}

}  // namespace lacuna
