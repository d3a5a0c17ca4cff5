// What comes from a worker process, or goes to one, is a message or refused; one that is read is written as it was.
// The first byte chooses the message.

#include "fuzzing.h"
#include "isolation/carried.h"

namespace {

template <class Message>
void read(const std::string& bytes) {
  lacuna::fuzz::is_done([&] {
    const std::string written = lacuna::to_bytes(lacuna::from_bytes<Message>(bytes));
    lacuna::fuzz::require(bytes.starts_with(written), "a message that is read is written as it was");
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string bytes = lacuna::fuzz::text_of(data + 1, size - 1);
  switch (data[0] % 5) {
    case 0: read<lacuna::Request>(bytes); break;
    case 1: read<std::vector<lacuna::ModelScore>>(bytes); break;
    case 2: read<std::vector<lacuna::JudgedTest>>(bytes); break;
    case 3: read<lacuna::PredictedTrial>(bytes); break;
    default: read<lacuna::LostWork>(bytes); break;
  }
  return 0;
}
