#include "app/terminal/progress_line.h"

#include "app/terminal/json_messages.h"
#include "app/terminal/plain_streams.h"
#include "foundation/text/plain_text.h"

#include <fmt/format.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace lacuna {
namespace {

constexpr const char* kWiped = "\r\033[K";

/// As many characters as the terminal is wide, so that they can be wiped; all of them where that is not known.
std::string fitted_to_terminal(const std::string& line) {
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col < 2) return line;
  return first_characters(line, size.ws_col - 1U);  // the cursor needs the last column
}

}  // namespace

bool LinePacer::take(Clock::time_point now) {
  if (now - last_ < interval_) return false;
  last_ = now;
  return true;
}

LinePacer& progress_pacer() {
  static LinePacer pacer(std::chrono::seconds(10));
  return pacer;
}

LinePacer& json_progress_pacer() {
  static LinePacer pacer(std::chrono::milliseconds(200));
  return pacer;
}

ProgressLine::ProgressLine(bool quiet, LinePacer& pacer, LinePacer& json_pacer)
    : json_(!quiet && messages_are_json()),
      live_(!quiet && !json_ && isatty(STDERR_FILENO) == 1),
      plain_(!quiet && !json_ && !live_),
      pacer_(pacer),
      json_pacer_(json_pacer) {}

ProgressLine::~ProgressLine() {
  if (shown_) wipe_live_line();
}

void ProgressLine::show(const Progress& progress) {
  using namespace std::chrono_literals;
  const auto now = std::chrono::steady_clock::now();
  if (json_ && json_pacer_.take(now)) exact_errors() << progress_message(progress) << std::flush;
  if (plain_ && pacer_.take(now)) fmt::print(stderr, "{}\n", progress_text(progress));
  if (!live_ || now - last_ < 100ms) return;
  last_ = now;
  shown_ = true;
  show_live_line(progress_text(progress));
}

ProgressCallback ProgressLine::callback() {
  return [this](const Progress& progress) { show(progress); };
}

std::string progress_text(const Progress& progress) {
  const std::string done = fmt::format("{} · {:.0f} %", progress.what, 100.0 * progress.fraction);
  return std::isfinite(progress.seconds_left) ? done + " · " + format_duration(progress.seconds_left) + " left" : done;
}

std::string first_characters(const std::string& text, std::size_t width) {
  std::size_t characters = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins = (static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U;  // otherwise a byte goes on
    if (begins && characters++ == width) return text.substr(0, i);
  }
  return text;
}

void show_live_line(const std::string& line) {
  exact_errors() << kWiped << fitted_to_terminal(plain_text(line)) << std::flush;
}

void wipe_live_line() { exact_errors() << kWiped << std::flush; }

std::string format_duration(double seconds) {
  if (seconds < 9.95) return fmt::format("{:.1f} s", seconds);
  const long whole = std::lround(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace lacuna
