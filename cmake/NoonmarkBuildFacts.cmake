# What --version states besides the version (app/input/build_facts.h). Two small generated sources hold it, so that a new commit or
# library compiles these and links the programs again, and compiles nothing else.
set(NOONMARK_COMMIT "" CACHE STRING "Commit that --version states, for sources without a repository; empty: ask git at each build")
set(NOONMARK_LIBRARY_VERSIONS
    "Qt ${Qt6_VERSION}, GDAL ${GDAL_VERSION}, GEOS ${GEOS_VERSION}, Embree ${embree_VERSION}, CGAL ${CGAL_VERSION}, oneTBB ${TBB_VERSION}")

configure_file(${CMAKE_SOURCE_DIR}/app/input/build_facts.cpp.in ${CMAKE_BINARY_DIR}/generated/build_facts.cpp @ONLY)

# Writes the file only if the commit is another one.
set(NOONMARK_COMMIT_FILE ${CMAKE_BINARY_DIR}/generated/source_commit.cpp)
add_custom_target(noonmark_source_commit
  COMMAND ${CMAKE_COMMAND} -D SOURCE=${CMAKE_SOURCE_DIR} -D OUT=${NOONMARK_COMMIT_FILE} -D COMMIT=${NOONMARK_COMMIT}
          -P ${CMAKE_SOURCE_DIR}/cmake/write_source_commit.cmake
  BYPRODUCTS ${NOONMARK_COMMIT_FILE}
  COMMENT "Looking up the commit")

set(NOONMARK_BUILD_FACTS ${CMAKE_BINARY_DIR}/generated/build_facts.cpp ${NOONMARK_COMMIT_FILE})
set_source_files_properties(${NOONMARK_BUILD_FACTS} PROPERTIES GENERATED ON SKIP_AUTOMOC ON SKIP_UNITY_BUILD_INCLUSION ON)
