#include "app/terminal/plain_streams.h"

#include <ext/stdio_sync_filebuf.h>
#include <sys/types.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <iostream>

namespace lacuna {
namespace {

using StdioBuffer = __gnu_cxx::stdio_sync_filebuf<char>;

/// A standard stream as it was, and what becomes of the text that it is given from now on.
struct Stream {
  Stream(int number, std::FILE* file) : descriptor(number), exact_buffer(file), exact(&exact_buffer) {}
  const int descriptor;
  StdioBuffer exact_buffer;
  std::ostream exact;
  PlainPieces pieces;
};

// Standard streams are flushed when nearly everything else has ended, so that these never do.
Stream& output() {
  static auto* const stream = new Stream(STDOUT_FILENO, stdout);
  return *stream;
}

Stream& errors() {
  static auto* const stream = new Stream(STDERR_FILENO, stderr);
  return *stream;
}

/// How many bytes arrived; `errno` says why not all.
std::size_t write_all(int descriptor, const std::string& text) {
  std::size_t written = 0;
  while (written < text.size()) {
    const ssize_t count = ::write(descriptor, text.data() + written, text.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    written += static_cast<std::size_t>(count);
  }
  return written;
}

ssize_t write_plain(void* cookie, const char* text, std::size_t size) {
  auto& stream = *static_cast<Stream*>(cookie);
  std::string piece(text, size);
  stream.pieces.make_plain(piece);
  return static_cast<ssize_t>(write_all(stream.descriptor, piece));
}

/// Nothing where there is no memory for it.
std::FILE* open_plain(Stream& stream, int buffering) {
  std::FILE* const plain = fopencookie(&stream, "w", {nullptr, write_plain, nullptr, nullptr});
  if (plain != nullptr) std::setvbuf(plain, nullptr, buffering, BUFSIZ);
  return plain;
}

void replace(std::FILE*& c_stream, std::ostream& cpp_stream, std::FILE* plain) {
  if (plain == nullptr) return;
  c_stream = plain;
  cpp_stream.rdbuf(new StdioBuffer(plain));
}

}  // namespace

void make_streams_plain() {
  replace(stdout, std::cout, open_plain(output(), isatty(STDOUT_FILENO) == 1 ? _IOLBF : _IOFBF));
  replace(stderr, std::cerr, open_plain(errors(), _IONBF));
}

std::ostream& exact_output() { return output().exact; }
std::ostream& exact_errors() { return errors().exact; }

void PlainPieces::make_plain(std::string& piece) {
  for (char& c : piece) {
    const auto byte = static_cast<unsigned char>(c);
    if (after_c2_ && byte >= 0x80 && byte < 0xA0)
      c = '\xA0';
    else if ((byte < 0x20 && c != '\n' && c != '\t') || byte == 0x7F)
      c = ' ';
    after_c2_ = byte == 0xC2;
  }
}

}  // namespace lacuna
