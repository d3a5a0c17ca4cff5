// Whatever an array or an archive of arrays holds, it is read in whole rows or refused with sentences. The reader tells
// the two by the bytes that they begin with.

#include "numpy_file.h"
#include "recording_format_fuzzing.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  lacuna::fuzz::read_bytes_as("run.npz", lacuna::fuzz::text_of(data, size), lacuna::numpy::contents_of,
                              lacuna::numpy::rows_of);
  return 0;
}
