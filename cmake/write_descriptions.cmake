# Writes manual pages and completions into OUT/man, OUT/bash, OUT/zsh and OUT/fish by asking PROGRAM, and compresses the pages with
# GZIP, without times, so that they are the same at each build; and the changelog, likewise.
cmake_minimum_required(VERSION 3.25)
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${OUT})
foreach(format man bash zsh fish)
  file(MAKE_DIRECTORY ${OUT}/${format})
  run(${PROGRAM} describe ${format} --out ${OUT}/${format})
endforeach()
file(GLOB pages ${OUT}/man/*.1)
file(COPY_FILE ${CMAKE_CURRENT_LIST_DIR}/../CHANGELOG.md ${OUT}/changelog)
run(${GZIP} -9 --no-name ${pages} ${OUT}/changelog)
file(TOUCH ${OUT}/written)
