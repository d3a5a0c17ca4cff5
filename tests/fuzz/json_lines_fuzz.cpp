// Whatever a file of the format holds, it is read in whole rows or refused with sentences.

#include "json_rows.h"
#include "recording_format_fuzzing.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  lacuna::fuzz::read_bytes_as("run.jsonl", lacuna::fuzz::text_of(data, size), lacuna::json_lines::contents_of,
                              lacuna::json_lines::rows_of);
  return 0;
}
