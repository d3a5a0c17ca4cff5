#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <set>
#include <sstream>
#include <string>

namespace lacuna::test {
namespace {

/// Lines of `nm` for the library: "member.o:", or "address type name".
std::string symbols() {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(LACUNA_NM " --defined-only " LACUNA_KERNELS_LIBRARY, "r"),
                                                   pclose);
  std::string all;
  char part[4096];
  while (std::fgets(part, sizeof part, pipe.get()) != nullptr) all += part;
  return all;
}

/// The linker may take any of several weak symbols of one name. One that needs a newer processor must never be taken
/// for the program's own.
TEST(Kernels, ShowTheLinkerNothingButOneFunctionOfEachLevel) {
  std::istringstream lines(symbols());
  std::string line, member;
  std::set<std::string> seen, levels;
  while (std::getline(lines, line)) {
    if (line.ends_with(".o:")) member = line;
    std::istringstream words(line);
    std::string address, type, name;
    if (!(words >> address >> type >> name) || member.starts_with("choose_kernels")) continue;
    levels.insert(member);
    if (type != "d" && type != "b" && type != "r" && type != "t" && type != "n")
      seen.insert(type.append(" ").append(name));
  }
  std::set<std::string> expected = {"T lacuna_kernels_portable"};
#ifdef __x86_64__
  expected.insert("T lacuna_kernels_x86_64_v3");
#endif
  EXPECT_EQ(levels.size(), expected.size());
  EXPECT_EQ(seen, expected);
}

}  // namespace
}  // namespace lacuna::test
