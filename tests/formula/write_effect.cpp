#include "formula/effect_source.h"

#include <filesystem>
#include <fstream>

/// Writes the folder of an effect as `lacuna plugins new effect` does, without the rest of the program:
/// write_effect NAME FORMULA FOLDER.
int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const std::string name = argv[1];
  const std::filesystem::path folder = argv[3];
  const lacuna::ForceLaw law = lacuna::read_force_law(argv[2], {});
  std::filesystem::create_directories(folder);
  std::ofstream(folder / (name + ".cpp")) << lacuna::effect_source(name, law);
  std::ofstream(folder / "README.md") << lacuna::effect_readme(name, law);
  return 0;
}
