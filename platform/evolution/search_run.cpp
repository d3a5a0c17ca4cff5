#include "evolution/search_run.h"

namespace lacuna {

void run_search(Search& search, const ComponentOrigin& origin, const ScoreGenomes& score,
                const std::function<void()>& generation_done) {
  const auto call = [&](const char* what, auto&& ask) { return guarded_call(origin, what, ask); };
  while (!call("finished", [&] { return search.finished(); })) {
    const std::vector<Individual> individuals = call("ask", [&] { return search.ask(); });
    const std::optional<double> bar = call("abandon_above", [&] { return search.abandon_above(); });
    const std::vector<double> scores = score(individuals, bar);
    call("tell", [&] { search.tell(scores); });
    generation_done();
  }
}

}  // namespace lacuna
