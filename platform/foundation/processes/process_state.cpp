#include "foundation/processes/process_state.h"

#include "foundation/processes/floating_point.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <climits>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <string_view>

namespace lacuna {
namespace {

using Changes = std::vector<std::string>;

/// Settings of `long double` where the processor has a separate unit for it.
std::uint16_t long_arithmetic() {
  std::uint16_t control = 0;
#if defined(__x86_64__)
  asm volatile("fnstcw %0" : "=m"(control));
#endif
  return control;
}

void set_long_arithmetic([[maybe_unused]] std::uint16_t control) {
#if defined(__x86_64__)
  asm volatile("fldcw %0" : : "m"(control));
#endif
}

void set_floating_point_control(std::uint32_t control) {
#if defined(__x86_64__)
  _mm_setcsr(control);
#else
  asm volatile("msr fpcr, %0" : : "r"(static_cast<std::uint64_t>(control)));
#endif
}

/// The meaning of the bits of the control word.
#if defined(__x86_64__)
constexpr std::uint32_t kRounding = 0x6000, kNearZero = 0x8040;
#else
constexpr std::uint32_t kRounding = 0xC00000, kNearZero = 0x1000000;
#endif

std::string current_folder() {
  std::error_code lost;
  return std::filesystem::current_path(lost).string();
}

/// Between the two calls another thread may make a file with wrong permissions.
mode_t mode_mask_of_process() {
  const mode_t mask = umask(077);
  umask(mask);
  return mask;
}

/// The same without changing it for a moment; none: the system does not give it. Allocates nothing, because it is
/// called between simulations.
std::optional<mode_t> told_mode_mask() {
  const int status = open("/proc/self/status", O_RDONLY | O_CLOEXEC);
  if (status < 0) return std::nullopt;
  std::array<char, 512> head{};  // the mask is the second line
  const ssize_t length = read(status, head.data(), head.size());
  close(status);
  constexpr std::string_view kName = "\nUmask:\t";
  const std::string_view text(head.data(), length > 0 ? static_cast<std::size_t>(length) : 0);
  const std::size_t at = text.find(kName);
  mode_t mask = 0;
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view digits = text.substr(at + kName.size());
  if (std::from_chars(digits.data(), digits.data() + digits.size(), mask, 8).ec != std::errc()) return std::nullopt;
  return mask;
}

std::vector<int> open_descriptors() {
  std::vector<int> numbers;
  std::error_code unreadable;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", unreadable)) {
    const std::string name = entry.path().filename().string();
    int number = 0;
    if (std::from_chars(name.data(), name.data() + name.size(), number).ec == std::errc()) numbers.push_back(number);
  }
  return numbers;
}

std::string name_of_signal(int signal) {
  const char* const name = sigabbrev_np(signal);
  return name == nullptr ? std::to_string(signal) : fmt::format("SIG{}", name);
}

bool same_signals(const sigset_t& a, const sigset_t& b) {
  for (int signal = 1; signal < NSIG; ++signal)
    if (sigismember(&a, signal) != sigismember(&b, signal)) return false;
  return true;
}

sigset_t blocked_signals() {
  sigset_t mask;
  sigemptyset(&mask);
  pthread_sigmask(SIG_BLOCK, nullptr, &mask);
  return mask;
}

constexpr std::array kStreamNames = {"the standard input", "the standard output", "the standard error"};
constexpr std::array kTimers = {ITIMER_REAL, ITIMER_VIRTUAL, ITIMER_PROF};

}  // namespace

ProcessState::Descriptor ProcessState::descriptor(int number) {
  struct stat file {};
  if (fstat(number, &file) != 0) return {number, std::nullopt};
  return {number, std::pair(file.st_dev, file.st_ino)};
}

ProcessState::ProcessState()
    : arithmetic_(floating_point_control()),
      long_arithmetic_(long_arithmetic()),
      locale_name_(std::setlocale(LC_ALL, nullptr)),
      locale_pointer_(std::setlocale(LC_ALL, nullptr)),
      thread_locale_(uselocale(static_cast<locale_t>(nullptr))),
      folder_(current_folder()),
      mode_mask_(mode_mask_of_process()),
      signal_mask_(blocked_signals()),
      output_(std::cout.rdbuf()),
      errors_(std::cerr.rdbuf()),
      terminate_(std::get_terminate()),
      out_of_memory_(std::get_new_handler()) {
  for (std::size_t signal = 1; signal < kSignals; ++signal)
    sigaction(static_cast<int>(signal), nullptr, &handlers_[signal]);
  for (std::size_t i = 0; i < streams_.size(); ++i) {
    streams_[i] = descriptor(static_cast<int>(i));
    if (streams_[i].file) stream_copies_[i] = fcntl(static_cast<int>(i), F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  }
  for (const int number : open_descriptors())
    if (const Descriptor open = descriptor(number); number > STDERR_FILENO && open.file) descriptors_.push_back(open);
}

ProcessState::~ProcessState() {
  for (const int copy : stream_copies_)
    if (copy >= 0) close(copy);
}

Changes ProcessState::set_back(Extent extent) const {
  Changes changes;
  set_back_arithmetic(changes);
  set_back_locale(changes);
  if (extent == Extent::quick) return changes;
  set_back_folder(changes);
  set_back_mode_mask(changes, extent);
  set_back_signal_mask(changes);
  set_back_timers(changes);
  set_back_streams(changes);
  set_back_library(changes);
  if (extent == Extent::at_work) return changes;
  set_back_handlers(changes);
  find_closed(changes);
  return changes;
}

void ProcessState::set_back_arithmetic(Changes& changes) const {
  if (const std::uint32_t changed = floating_point_control() ^ arithmetic_; changed != 0) {
    set_floating_point_control(arithmetic_);
    if ((changed & kRounding) != 0) changes.emplace_back("the rounding of floating-point numbers (fesetround)");
    if ((changed & kNearZero) != 0)
      changes.emplace_back("the arithmetic near zero (denormal numbers count as 0, as with -ffast-math or -Ofast)");
    if ((changed & ~(kRounding | kNearZero)) != 0)
      changes.emplace_back("which floating-point errors raise a signal (feenableexcept)");
  }
  if (long_arithmetic() != long_arithmetic_) {
    set_long_arithmetic(long_arithmetic_);
    if (changes.empty()) changes.emplace_back("the rounding or precision of long double");
  }
}

void ProcessState::set_back_locale(Changes& changes) const {
  const char* const name = std::setlocale(LC_ALL, nullptr);
  const locale_t of_thread = uselocale(static_cast<locale_t>(nullptr));
  const bool is_same = name == locale_pointer_ || name == locale_name_;
  if (is_same && of_thread == thread_locale_ && std::locale() == locale_) return;
  changes.push_back(is_same ? "the locale" : fmt::format("the locale ({})", name));
  std::locale::global(locale_);
  std::setlocale(LC_ALL, locale_name_.c_str());
  uselocale(thread_locale_);
}

void ProcessState::set_back_folder(Changes& changes) const {
  std::array<char, PATH_MAX> buffer;  // allocates nothing where nothing has changed
  const char* const found = getcwd(buffer.data(), buffer.size());
  const std::string_view folder = found == nullptr ? std::string_view() : found;
  if (folder == folder_) return;
  changes.push_back(fmt::format("the current folder ({})", folder));
  if (chdir(folder_.c_str()) != 0) changes.back() += ", which could not be set back";
}

void ProcessState::set_back_mode_mask(Changes& changes, Extent extent) const {
  const mode_t mask = extent == Extent::complete ? mode_mask_of_process() : told_mode_mask().value_or(mode_mask_);
  if (mask == mode_mask_) return;
  umask(mode_mask_);
  changes.push_back(fmt::format("the file mode mask ({:03o})", mask));
}

void ProcessState::set_back_signal_mask(Changes& changes) const {
  if (same_signals(blocked_signals(), signal_mask_)) return;
  pthread_sigmask(SIG_SETMASK, &signal_mask_, nullptr);
  changes.emplace_back("which signals are blocked");
}

void ProcessState::set_back_handlers(Changes& changes) const {
  std::string names;
  for (std::size_t i = 1; i < kSignals; ++i) {
    const int signal = static_cast<int>(i);
    struct sigaction present {};
    if (sigaction(signal, nullptr, &present) != 0 || present.sa_handler == handlers_[i].sa_handler) continue;
    sigaction(signal, &handlers_[i], nullptr);
    names += (names.empty() ? "" : ", ") + name_of_signal(signal);
  }
  if (!names.empty()) changes.push_back(fmt::format("what signals do ({})", names));
}

void ProcessState::set_back_timers(Changes& changes) const {
  bool armed = false;
  for (const auto timer : kTimers) {
    itimerval present{};
    if (getitimer(timer, &present) != 0 || (present.it_value.tv_sec == 0 && present.it_value.tv_usec == 0)) continue;
    const itimerval none{};
    setitimer(timer, &none, nullptr);
    armed = true;
  }
  if (armed) changes.emplace_back("a timer that raises a signal (alarm, setitimer)");
}

void ProcessState::set_back_streams(Changes& changes) const {
  for (std::size_t i = 0; i < streams_.size(); ++i) {
    const int number = static_cast<int>(i);
    const Descriptor present = descriptor(number);
    if (present == streams_[i]) continue;
    changes.push_back(fmt::format("{} ({})", kStreamNames[i], present.file ? "another file" : "closed"));
    if (stream_copies_[i] >= 0)
      dup2(stream_copies_[i], number);
    else
      close(number);
  }
}

void ProcessState::find_closed(Changes& changes) const {
  for (const Descriptor& before : descriptors_) {
    if (descriptor(before.number) == before) continue;
    changes.emplace_back("a file that the program has open (closed)");
    return;
  }
}

void ProcessState::set_back_library(Changes& changes) const {
  if (std::cout.rdbuf() != output_ || std::cerr.rdbuf() != errors_) {
    std::cout.rdbuf(output_);
    std::cerr.rdbuf(errors_);
    changes.emplace_back("the buffers of std::cout or std::cerr");
  }
  if (std::get_terminate() != terminate_ || std::get_new_handler() != out_of_memory_) {
    std::set_terminate(terminate_);
    std::set_new_handler(out_of_memory_);
    changes.emplace_back("the handler of std::terminate or of a lack of memory");
  }
}

}  // namespace lacuna
