// Whatever a file holds, reading it ends in trials or in `BadInput`: no crash, no hang, no other exception.

#include "measurement/guesses/file_sample.h"
#include "measurement/rig_guess.h"
#include "measurement_fixture.h"

#include <cstdint>
#include <string>

namespace lacuna {
namespace {

using namespace std::string_literals;

constexpr int kMutants = 1000;

/// The same numbers everywhere.
class Dice {
 public:
  std::size_t below(std::size_t bound) {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return static_cast<std::size_t>(state_ % bound);
  }

 private:
  std::uint64_t state_ = 0x2545f4914f6cdd1du;
};

std::string mutated(std::string text, Dice& dice) {
  static const std::string kPieces[] = {",", ";",    "\t",  "\n", "\r\n", "\"",   "#",        "nan", "inf",     "-",
                                        ".", "1e99", "\0"s, " ",  "sep=", "\xff", "\xc3\xa9", "1,5", "t,q,u\n", "e"};
  for (std::size_t changes = 1 + dice.below(3); changes > 0; --changes) {
    const std::size_t at = dice.below(text.size() + 1);
    const std::size_t length = std::min(dice.below(12), text.size() - at);
    switch (dice.below(4)) {
      case 0: text.erase(at, length); break;
      case 1: text.insert(at, text.substr(at, length)); break;
      case 2: text.insert(at, kPieces[dice.below(std::size(kPieces))]); break;
      default: text.replace(at, length, kPieces[dice.below(std::size(kPieces))]); break;
    }
  }
  return text;
}

TEST(MutatedFiles, AreReadOrRefused) {
  const TestFolder folder;
  const std::string kSeeds[] = {"t,q,u\n0,1,2\n0.1,1.5,2.5\n0.2,2,3\n0.3,2,1\n",
                                "# run 7\nt;q;u\ns;rad;Nm\n0,0;1,0;2\n0,1;1,5;2,5\n0,2;2;3\n",
                                "t q u\n0 1 2\n0.1 \"1.5\" 2.5\n0.2 nan 3\n"};
  Dice dice;
  int read = 0, refused = 0;
  for (int i = 0; i < kMutants; ++i) {
    const std::filesystem::path file = folder.write("run.csv", mutated(kSeeds[dice.below(std::size(kSeeds))], dice));
    try {
      EXPECT_FALSE(read_pendulum(pendulum_source(file)).trials.empty());
      ++read;
    } catch (const BadInput& error) {
      EXPECT_FALSE(error.problems().empty());
      ++refused;
    }
    try {
      guess_rig({sample_file(file)}, {});
    } catch (const Error&) {
    }
  }
  EXPECT_GT(read, kMutants / 10);
  EXPECT_GT(refused, kMutants / 10);
}

}  // namespace
}  // namespace lacuna
