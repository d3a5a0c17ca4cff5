#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace hidden_effects {

/// What the database keeps of a case, as plain data. Numbers are SI; NaN stands for what is not known.
inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// An effect of the library at a place of the experiment's file, "joint.hinge"; "world" where it stands on nothing.
struct EffectAt {
  std::string effect;
  std::string place;
  bool operator==(const EffectAt&) const = default;
};

struct NamedValue {
  std::string name;
  double value = kUnknown;
};

/// What is really there.
struct HiddenLawRecord {
  std::string law;  ///< of `all_laws`, or of a rig with contacts
  EffectAt answer;  ///< what the library calls it
  bool library_form = true;
  std::vector<NamedValue> parameters;
};

/// The plan of a case and how it came out.
struct CaseRecord {
  std::string version;  ///< of the method
  std::string set;
  int number = 0;
  std::string group, rig, noise;
  double planned_strength = 1.0;
  double strength = kUnknown;  ///< measured
  bool absorbed = false;
  std::string seed;  ///< 64 bits without sign, as decimal digits
  std::vector<HiddenLawRecord> hidden;
};

struct IntervalRecord {
  std::string parameter;  ///< a parameter's name, or the address of a free value
  double value = kUnknown, lower = kUnknown, upper = kUnknown;
};

struct RankedEffectRecord {
  EffectAt what;
  std::vector<IntervalRecord> parameters;
};

struct RankedModelRecord {
  double probability = kUnknown, gain = kUnknown, times_floor = kUnknown;
  std::vector<RankedEffectRecord> effects;
  std::vector<EffectAt> look_alikes;  ///< of the last effect
};

/// One diagnosis, as the program told it.
struct DiagnosisRecord {
  int round = 1;
  std::string verdict;
  double probability = kUnknown, p_by_chance = kUnknown, times_floor = kUnknown;
  double seconds = kUnknown, processor_seconds = kUnknown;
  std::string json;
  std::string next_test;  ///< that would tell the answer from its closest look-alike; empty: none is proposed
  std::vector<RankedModelRecord> ranking;
  std::vector<IntervalRecord> values;  ///< of the model's own, beside the answer
  std::vector<EffectAt> added;         ///< to the model because of it
};

/// RMSE of a free run over the held-out trials, by channel.
struct HeldOutRecord {
  std::string stage;  ///< "base", "found" or "truth"
  std::string channel;
  double rmse = kUnknown;
};

/// A fitted value of the last model whose true value is known.
struct FreeValueRecord {
  IntervalRecord interval;
  double truth = kUnknown;
};

/// What the oracle says of an effect in the place of a hidden law.
struct OracleRival {
  int law = 0;     ///< the hidden law that it stands for, from 0
  EffectAt rival;  ///< no effect: the law left out
  double non_centrality = kUnknown;
  bool told_apart = true;  ///< from the truth, by these data
};

/// The sharpness of the refitted truth.
struct OracleWidth {
  std::string parameter;    ///< an address of the base, or "coulomb_friction.torque"
  double width = kUnknown;  ///< of the 95 % interval
};

struct OracleRecord {
  std::vector<OracleRival> rivals;
  std::vector<OracleWidth> widths;
};

/// What another method says of the same data.
struct BaselineRecord {
  std::string method;
  int chosen = 0;             ///< the first so many of the ranking are there, it says; 0: nothing is missing
  double seconds = kUnknown;  ///< of processor time
  std::vector<EffectAt> ranking;
  std::vector<double> scores;  ///< by rank; what they mean depends on the method
};

/// A test that was carried out to settle which of two effects is there, and what the program said then.
struct SettlingTest {
  std::string line;  ///< as `lacuna trial --test` takes it
  std::string verdict;
  double processor_seconds = kUnknown;  ///< of the diagnosis
};

inline constexpr int kMostSettlingTests = 6;

/// Tests one after the other, until the program tells the two apart or there were `kMostSettlingTests`.
struct SettlingRun {
  std::string choice;  ///< of the tests: "chosen" by the program, or "random"; "none": the two are asked about alone
  std::vector<SettlingTest> tests;
  EffectAt remaining;   ///< no effect: not settled
  std::string failure;  ///< the sentence with which it ended early; empty: it did not
};

/// How the answer of the first diagnosis is told from its closest look-alike by further tests.
struct SettlingRecord {
  EffectAt answer, rival;
  std::string left_out;  ///< why no test was carried out; empty: they were
  std::vector<SettlingRun> runs;
};

/// One thing that is not as the owner of a dirty case believes.
struct DirtyEffectRecord {
  std::string what;                   ///< the law, or "value body.arm.mass" of the robot file
  EffectAt answer;                    ///< what the library calls it, and where it is
  std::string role;                   ///< "main", "small", "misstated" or "reading"
  bool library_form = true;           ///< false: a law of another form than the library's
  double share = kUnknown;            ///< of the owner's error that it explains
  std::vector<std::string> accepted;  ///< "effect @ place" of each answer that names it, or "value body.arm.mass"
  std::vector<NamedValue> values;
};

/// All that is kept of a case.
struct CaseResult {
  CaseRecord about;
  std::string failure;  ///< the sentence with which it ended early; empty: it did not
  std::vector<DiagnosisRecord> diagnoses;
  std::vector<HeldOutRecord> held_out;
  std::vector<FreeValueRecord> free_values;
  OracleRecord oracle;
  std::vector<BaselineRecord> baselines;
  std::optional<SettlingRecord> settling;
  std::vector<DirtyEffectRecord> dirty;  ///< of a dirty case, whose strength is the owner's error over the noise
};

}  // namespace hidden_effects
