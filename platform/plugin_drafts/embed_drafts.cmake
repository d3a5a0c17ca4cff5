# Writes OUTPUT, a C++ source that holds FILES of FOLDER, each under its name without ".in":
# cmake "-DFILES=...;..." -DFOLDER=... -DOUTPUT=... -P embed_drafts.cmake
set(entries "")
foreach(file ${FILES})
  file(READ ${FOLDER}/${file} text)
  get_filename_component(name ${file} NAME)
  string(REGEX REPLACE "\\.in$" "" name ${name})
  string(APPEND entries "      {\"${name}\", R\"~draft~(${text})~draft~\"},\n")
endforeach()
file(WRITE ${OUTPUT} "// Made from drafts/ by embed_drafts.cmake.
#include \"plugin_drafts/draft_texts.h\"

namespace lacuna {

const std::map<std::string, std::string>& draft_texts() {
  static const std::map<std::string, std::string> all = {
${entries}  };
  return all;
}

}  // namespace lacuna
")
