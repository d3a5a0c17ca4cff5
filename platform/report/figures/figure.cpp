#include "report/figures/figure.h"

#include "foundation/processes/child_program.h"
#include "foundation/text/plain_text.h"
#include "foundation/files/whole_file.h"
#include "report/figures/figure_script.h"
#include "report/figures/figure_series.h"

#include <lacuna/error.h>

#include <fmt/format.h>

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <optional>

namespace lacuna {
namespace {

/// A file in memory, by which a child is given its input or leaves its output.
class MemoryFile {
 public:
  explicit MemoryFile(const std::string& content = {}) : descriptor_(memfd_create("gnuplot", MFD_CLOEXEC)) {
    std::size_t written = 0;
    while (descriptor_ >= 0 && written < content.size()) {
      const ssize_t count = write(descriptor_, content.data() + written, content.size() - written);
      if (count <= 0)
        throw Error(std::string("not enough memory for the commands of a picture: ") + std::strerror(errno));
      written += static_cast<std::size_t>(count);
    }
    if (descriptor_ < 0 || lseek(descriptor_, 0, SEEK_SET) != 0)
      throw Error(std::string("not enough memory for a picture: ") + std::strerror(errno));
  }
  ~MemoryFile() { close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  int descriptor() const { return descriptor_; }
  std::string content() const {
    std::string text(static_cast<std::size_t>(lseek(descriptor_, 0, SEEK_END)), '\0');
    const ssize_t got = pread(descriptor_, text.data(), text.size(), 0);
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    return text;
  }

 private:
  int descriptor_;
};

/// gnuplot with its own settings: none of the user's files and variables counts. It is given no file name.
ChildBeginning gnuplot(const MemoryFile& script, const MemoryFile& picture, const MemoryFile& complaints) {
  return {.words = {"gnuplot", "--default-settings", "-"},
          .folder = {},
          .environment = {{"GNUTERM", "svg"}, {"LC_ALL", "C.UTF-8"}},
          .input = script.descriptor(),
          .output = picture.descriptor(),
          .errors = complaints.descriptor()};
}

std::unique_ptr<ChildProgram> started(const ChildBeginning& beginning) {
  try {
    return std::make_unique<ChildProgram>(beginning);
  } catch (const Error& error) {
    throw Error(std::string("pictures are drawn by gnuplot, but ") + error.what() +
                "; install the package gnuplot-nox");
  }
}

ChildEnding end_of(ChildProgram& child, const Stop& stop) {
  constexpr double kLook = 0.1;  // s
  for (;;) {
    if (const std::optional<ChildEnding> ending = child.ended_within(kLook)) return *ending;
    stop.throw_if_due();
  }
}

void check(const Figure& figure) {
  for (const Panel& panel : figure.panels)
    for (const Series& series : panel.series) {
      const bool sized =
          series.mark == Mark::level
              ? series.y.size() == 1
              : series.x.size() == series.y.size() && (!reaches(series.mark) || series.y2.size() == series.y.size());
      if (!sized)
        throw Error("figure \"" + figure.title + "\": series \"" + series.label + "\" has columns of different length");
    }
}

}  // namespace

std::string svg_of(const Figure& figure, const Stop& stop) {
  check(figure);
  const MemoryFile script(gnuplot_script(figure)), picture, complaints;
  const ChildEnding ending = end_of(*started(gnuplot(script, picture, complaints)), stop);
  std::string svg = picture.content();
  if (ending.code() != 0 || svg.find("</svg>") == svg.npos)
    throw Error(fmt::format("figure \"{}\": gnuplot {} and could not draw it: {}", plain_text(figure.title),
                            ending.phrase(), complaints.content()));
  return svg;
}

void write_svg(const Figure& figure, const std::filesystem::path& file, const Stop& stop) {
  const std::string svg = svg_of(figure, stop);
  if (!file.parent_path().empty()) std::filesystem::create_directories(file.parent_path());
  write_whole(file, svg, Link::replaced);
}

}  // namespace lacuna
