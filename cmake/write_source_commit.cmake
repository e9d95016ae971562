# Writes OUT, the definition of sourceCommit(): COMMIT if it is given, else what git says about SOURCE.
cmake_minimum_required(VERSION 3.25)
set(commit "${COMMIT}")
if(commit STREQUAL "")
  find_program(GIT git)
  if(GIT)
    execute_process(COMMAND ${GIT} -C ${SOURCE} describe --always --dirty --abbrev=12 --match=
                    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  endif()
endif()
if(commit STREQUAL "")
  set(commit unknown)
endif()
file(CONFIGURE OUTPUT ${OUT} @ONLY CONTENT
"#include \"app/input/build_facts.h\"

namespace noonmark {

std::string_view sourceCommit() { return \"@commit@\"; }

}  // namespace noonmark
")
