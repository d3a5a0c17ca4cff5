# Writes OUTPUT, a header with the source revision of FOLDER, only when it has changed.
execute_process(COMMAND git -C ${FOLDER} describe --always --dirty --abbrev=40 --exclude=*
  OUTPUT_VARIABLE revision ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed)
if(failed OR revision STREQUAL "")
  set(revision unknown)
endif()
set(line "#define LACUNA_SOURCE_REVISION \"${revision}\"\n")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} old)
endif()
if(NOT "${old}" STREQUAL "${line}")
  file(WRITE ${OUTPUT} "${line}")
endif()
