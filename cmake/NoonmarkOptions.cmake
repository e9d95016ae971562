# Warnings, sanitizers and the compiler cache: everything that is the same for every target.
find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
      CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${CCACHE})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options(-fpch-preprocess)
  endif()
endif()

# GCC frees memory seldom: it takes 1.9 instead of 1.3 GB for the largest unit, and 12 to 15 % less time.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options("SHELL:--param ggc-min-expand=300" "SHELL:--param ggc-min-heapsize=1000000")
endif()

add_library(noonmark_flags INTERFACE)
target_compile_options(noonmark_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                       -Wno-sign-conversion -Wno-float-conversion -Wnon-virtual-dtor -Wno-missing-field-initializers)
if(NOONMARK_WERROR)
  target_compile_options(noonmark_flags INTERFACE -Werror)
endif()
if(NOONMARK_SANITIZE)
  target_compile_options(noonmark_flags INTERFACE -fsanitize=${NOONMARK_SANITIZE} -fno-omit-frame-pointer
                         -fno-sanitize-recover=all $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(noonmark_flags INTERFACE -fsanitize=${NOONMARK_SANITIZE})
endif()
if(NOONMARK_FUZZ)
  target_compile_options(noonmark_flags INTERFACE -fsanitize=fuzzer-no-link)
  target_link_options(noonmark_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()
target_compile_definitions(noonmark_flags INTERFACE GLM_FORCE_EXPLICIT_CTOR GLM_ENABLE_EXPERIMENTAL)
target_include_directories(noonmark_flags INTERFACE ${CMAKE_SOURCE_DIR})
# Floating point: results may not depend on how the compiler contracts a*b+c.
target_compile_options(noonmark_flags INTERFACE -ffp-contract=off)

# Fails the build when a header of DIR does not compile alone.
function(noonmark_check_headers target)
  set_target_properties(${target} PROPERTIES VERIFY_INTERFACE_HEADER_SETS ON)
endfunction()

# Compiles `target` in half the time: what waits for people, files and libraries need not be optimised further. The shadows are counted in
# core, the pictures made in render and report.
function(noonmark_optimise_lightly target)
  target_compile_options(${target} PRIVATE $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:-Og -Wno-maybe-uninitialized>)
endfunction()

# Precompiles what most sources of `target` include: the standard library and core's own libraries, and the headers in ARGN.
function(noonmark_precompile_headers target)
  if(NOONMARK_PCH)
    target_precompile_headers(${target} PRIVATE
      <algorithm> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <optional> <string> <vector>
      <fmt/format.h> <glm/glm.hpp> <nlohmann/json.hpp> <tl/expected.hpp> ${ARGN})
  endif()
endfunction()

# Those of `other`, which must be compiled with the same options.
function(noonmark_reuse_precompiled_headers target other)
  if(NOONMARK_PCH)
    target_precompile_headers(${target} REUSE_FROM ${other})
  endif()
endfunction()

# Kernels among these sources are compiled for SSE4.2, AVX2 and AVX-512, or for NEON (core/simd/kernel.h), and for no other sets: AVX3
# is Highway's name of AVX-512, the two above it are later extensions. Highway's file includes itself once a set, so these files stay
# out of unity groups. Call it where the library is made: source properties belong to a folder.
function(noonmark_compile_kernels)
  list(FILTER ARGN INCLUDE REGEX "_hwy\\.cpp$")
  set(definitions HWY_SHARED_DEFINE "HWY_DISABLED_TARGETS=(HWY_SVE|HWY_SVE2|HWY_SVE_256|HWY_SVE2_128|HWY_AVX3_DL)")
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    list(APPEND definitions HWY_BASELINE_TARGETS=HWY_SSE4)
  endif()
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "aarch64|arm64")
    # Highway's NEON functions state that they need these extensions, though kernels use none of their instructions.
    set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS -march=armv8-a+crypto)
  endif()
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON COMPILE_DEFINITIONS "${definitions}")
endfunction()

# A unity build compiles neighbouring sources of a target together, about 400 kB of them: their headers and templates, which take most of
# the time, are compiled once. Names in
# anonymous namespaces are therefore unique within a target.
if(CMAKE_UNITY_BUILD)
  target_compile_options(noonmark_flags INTERFACE -Wno-shadow)
endif()
set(NOONMARK_UNITY_BYTES 400000)  # a target's property of this name counts before it

# Groups the sources of this folder's targets for the unity build. Call it last in a CMakeLists.txt: source properties belong to a folder.
function(noonmark_group_for_unity)
  if(NOT CMAKE_UNITY_BUILD)
    return()
  endif()
  get_property(targets DIRECTORY PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(type MATCHES "STATIC_LIBRARY|OBJECT_LIBRARY|EXECUTABLE")
      set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
      get_target_property(sources ${target} SOURCES)
      noonmark_group_sources(${target} ${sources})
    endif()
  endforeach()
endfunction()

function(noonmark_group_sources target)
  list(FILTER ARGN INCLUDE REGEX "\\.cpp$")
  foreach(source IN LISTS ARGN)
    get_filename_component(path ${source} ABSOLUTE)
    file(RELATIVE_PATH path ${CMAKE_SOURCE_DIR} ${path})
    get_source_file_property(alone ${CMAKE_SOURCE_DIR}/${path} SKIP_UNITY_BUILD_INCLUSION)
    if(alone OR NOT EXISTS ${CMAKE_SOURCE_DIR}/${path})
      continue()
    endif()
    list(APPEND together ${path})
  endforeach()
  get_target_property(bytes ${target} NOONMARK_UNITY_BYTES)
  if(bytes)
    set(NOONMARK_UNITY_BYTES ${bytes})
  endif()
  noonmark_cut_into_groups(${target} ${together})
endfunction()

function(noonmark_cut_into_groups name)
  list(SORT ARGN)
  set(bytes 0)
  foreach(path IN LISTS ARGN)
    math(EXPR group "${bytes} / ${NOONMARK_UNITY_BYTES}")
    set_source_files_properties(${CMAKE_SOURCE_DIR}/${path} PROPERTIES UNITY_GROUP ${name}_${group})
    file(SIZE ${CMAKE_SOURCE_DIR}/${path} size)
    math(EXPR bytes "${bytes} + ${size}")
  endforeach()
endfunction()
