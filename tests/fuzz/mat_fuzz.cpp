// Whatever a file of the format holds, it is read in whole rows or refused with sentences.

#include "mat_file.h"
#include "recording_format_fuzzing.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  lacuna::fuzz::read_bytes_as("run.mat", lacuna::fuzz::text_of(data, size), lacuna::mat::contents_of,
                              lacuna::mat::rows_of);
  return 0;
}
