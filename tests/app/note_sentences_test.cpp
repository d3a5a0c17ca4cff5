#include "app/workspace/note_sentences.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

using testing::ElementsAre;

TEST(NoteSentences, NameAllPlacesOfWhatIsNoticedInSeveral) {
  EXPECT_THAT(note_sentences({{{"sine.csv", 3, 0}, "the header is found here", false},
                              {{"sine.csv", 0, 0}, "is UTF-16 text", false},
                              {{"steps.csv", 5, 0}, "the header is found here", true},
                              {{"sine.csv", 3, 0}, "the header is found here", false}}),
              ElementsAre("sine.csv:3, steps.csv:5: the header is found here", "sine.csv: is UTF-16 text"));
}

}  // namespace
}  // namespace lacuna
