# Warnings, sanitizers and the compiler cache: everything that is the same for every target of the house.
find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
      CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${CCACHE})
  add_compile_options(-fpch-preprocess)
endif()

add_library(noonmark_flags INTERFACE)
target_compile_options(noonmark_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                       -Wno-sign-conversion -Wno-float-conversion -Wnon-virtual-dtor -Wno-missing-field-initializers)
if(NOONMARK_WERROR)
  target_compile_options(noonmark_flags INTERFACE -Werror)
endif()
if(NOONMARK_SANITIZE)
  target_compile_options(noonmark_flags INTERFACE -fsanitize=${NOONMARK_SANITIZE} -fno-omit-frame-pointer
                         -fno-sanitize-recover=all -Wno-maybe-uninitialized)
  target_link_options(noonmark_flags INTERFACE -fsanitize=${NOONMARK_SANITIZE})
endif()
target_compile_definitions(noonmark_flags INTERFACE GLM_FORCE_EXPLICIT_CTOR GLM_ENABLE_EXPERIMENTAL)
target_include_directories(noonmark_flags INTERFACE ${CMAKE_SOURCE_DIR})
# Floating point: results may not depend on how the compiler contracts a*b+c.
target_compile_options(noonmark_flags INTERFACE -ffp-contract=off)

# Fails the build when a header of DIR does not compile alone.
function(noonmark_check_headers target)
  set_target_properties(${target} PROPERTIES VERIFY_INTERFACE_HEADER_SETS ON)
endfunction()
