#pragma once

#include <sys/types.h>

#include <array>
#include <clocale>
#include <csignal>
#include <cstdint>
#include <exception>
#include <locale>
#include <new>
#include <optional>
#include <streambuf>
#include <string>
#include <vector>

namespace lacuna {

/// State of the process that a library may change unnoticed and on which results, files and messages depend:
/// floating-point arithmetic, locale, current folder, file mode mask, signals, timers, descriptors, the buffers of
/// standard streams, the handlers of `std::terminate` and of a lack of memory.
class ProcessState {
 public:
  /// The part of the state that is compared.
  enum class Extent {
    quick,     ///< in nanoseconds: arithmetic and locale of this thread
    at_work,   ///< in microseconds: also state that the program never changes after its start
    complete,  ///< everything; only while the process has one thread
  };

  /// As it is now.
  ProcessState();
  ~ProcessState();
  ProcessState(const ProcessState&) = delete;
  ProcessState& operator=(const ProcessState&) = delete;

  /// Restores the parts that have changed, and names them, as in "the current folder (/tmp)". A closed descriptor above
  /// the standard ones stays closed.
  std::vector<std::string> set_back(Extent extent) const;

 private:
  struct Descriptor {
    int number = -1;
    std::optional<std::pair<dev_t, ino_t>> file;  ///< none: closed
    bool operator==(const Descriptor&) const = default;
  };
  static Descriptor descriptor(int number);

  void set_back_arithmetic(std::vector<std::string>& changes) const;
  void set_back_locale(std::vector<std::string>& changes) const;
  void set_back_folder(std::vector<std::string>& changes) const;
  void set_back_mode_mask(std::vector<std::string>& changes, Extent extent) const;
  void set_back_signal_mask(std::vector<std::string>& changes) const;
  void set_back_handlers(std::vector<std::string>& changes) const;
  void set_back_timers(std::vector<std::string>& changes) const;
  void set_back_streams(std::vector<std::string>& changes) const;
  void find_closed(std::vector<std::string>& changes) const;
  void set_back_library(std::vector<std::string>& changes) const;

  static constexpr std::size_t kSignals = 32;  // the numbers below are the classical signals

  std::uint32_t arithmetic_;
  std::uint16_t long_arithmetic_;
  std::string locale_name_;
  const char* locale_pointer_;
  locale_t thread_locale_;
  std::locale locale_;
  std::string folder_;
  mode_t mode_mask_;
  sigset_t signal_mask_{};
  std::array<struct sigaction, kSignals> handlers_{};
  std::array<Descriptor, 3> streams_;
  std::array<int, 3> stream_copies_{-1, -1, -1};
  std::vector<Descriptor> descriptors_;  // above the standard ones
  std::streambuf* output_;
  std::streambuf* errors_;
  std::terminate_handler terminate_;
  std::new_handler out_of_memory_;
};

}  // namespace lacuna
