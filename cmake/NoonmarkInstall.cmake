# What `cmake --install` puts where. Components: application (the window), command-line, documentation. Programs need no data
# files: rules, shaders and kernels are inside them. Names follow freedesktop.org, folders GNUInstallDirs.
# Packaging builds the programs only, not all tests first.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
set(NOONMARK_APP_ID io.github.noonmark.Noonmark)
set(desktop ${CMAKE_SOURCE_DIR}/resources/desktop)
set(generated ${CMAKE_BINARY_DIR}/generated/install)
if(EXISTS /etc/debian_version)
  set(zsh_folder vendor-completions)
else()
  set(zsh_folder site-functions)
endif()
set(NOONMARK_ZSH_DIR ${CMAKE_INSTALL_DATADIR}/zsh/${zsh_folder} CACHE STRING "Folder of completions for zsh")

# Manual pages and completions are written by the program itself from its command line, and compressed.
set(descriptions ${generated}/descriptions)
find_program(GZIP gzip REQUIRED)
file(MAKE_DIRECTORY ${descriptions})
add_custom_command(OUTPUT ${descriptions}/written
  COMMAND ${CMAKE_COMMAND} -D PROGRAM=$<TARGET_FILE:noonmark-commands> -D GZIP=${GZIP} -D OUT=${descriptions}
          -P ${CMAKE_SOURCE_DIR}/cmake/write_descriptions.cmake
  DEPENDS noonmark-commands ${CMAKE_SOURCE_DIR}/cmake/write_descriptions.cmake
  COMMENT "Writing manual pages and completions")
add_custom_target(noonmark_descriptions ALL DEPENDS ${descriptions}/written)

function(noonmark_install_descriptions component name pages)
  install(DIRECTORY ${descriptions}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT ${component}
          FILES_MATCHING REGEX "/${pages}\\.1\\.gz$")
  install(FILES ${descriptions}/bash/${name} DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT ${component})
  install(FILES ${descriptions}/zsh/_${name} DESTINATION ${NOONMARK_ZSH_DIR} COMPONENT ${component})
  install(FILES ${descriptions}/fish/${name}.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT ${component})
endfunction()

# Both programs start the mesh reader and load the movie encoder, so each component brings them.
function(noonmark_install_program component target)
  install(TARGETS ${target} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ${component})
  install(TARGETS noonmark-mesh-reader RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/noonmark COMPONENT ${component})
  install(TARGETS noonmark-movie-encoder noonmark-body-writer LIBRARY DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/noonmark COMPONENT ${component})
endfunction()

noonmark_install_program(command-line noonmark-cli)
# noonmark-cli starts it.
install(TARGETS noonmark-commands RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/noonmark COMPONENT command-line)
noonmark_install_descriptions(command-line noonmark-cli "noonmark-cli(-[a-z-]+)?")

if(NOONMARK_GUI)
  noonmark_install_program(application noonmark)
  noonmark_install_descriptions(application noonmark noonmark)
  set(data ${CMAKE_INSTALL_DATADIR})
  configure_file(${desktop}/${NOONMARK_APP_ID}.metainfo.xml.in ${generated}/${NOONMARK_APP_ID}.metainfo.xml @ONLY)
  install(FILES ${desktop}/${NOONMARK_APP_ID}.desktop DESTINATION ${data}/applications COMPONENT application)
  install(FILES ${generated}/${NOONMARK_APP_ID}.metainfo.xml DESTINATION ${data}/metainfo COMPONENT application)
  install(FILES ${desktop}/${NOONMARK_APP_ID}.xml DESTINATION ${data}/mime/packages COMPONENT application)
  install(FILES ${desktop}/${NOONMARK_APP_ID}.svg DESTINATION ${data}/icons/hicolor/scalable/apps COMPONENT application)
  # The pictures follow from the SVG, so the repository holds none.
  find_program(RSVG_CONVERT rsvg-convert)
  if(RSVG_CONVERT)
    foreach(size 16 22 24 32 48 64 128 256 512)
      set(icon ${generated}/icons/${size}x${size}/apps/${NOONMARK_APP_ID}.png)
      add_custom_command(OUTPUT ${icon} DEPENDS ${desktop}/${NOONMARK_APP_ID}.svg
        COMMAND ${CMAKE_COMMAND} -E make_directory ${generated}/icons/${size}x${size}/apps
        COMMAND ${RSVG_CONVERT} --width ${size} --height ${size} --output ${icon} ${desktop}/${NOONMARK_APP_ID}.svg
        COMMENT "Drawing the icon, ${size} px")
      list(APPEND icons ${icon})
    endforeach()
    add_custom_target(noonmark_icons ALL DEPENDS ${icons})
    install(DIRECTORY ${generated}/icons/ DESTINATION ${data}/icons/hicolor COMPONENT application)
  endif()
endif()

set(NOONMARK_DOC_DIR ${CMAKE_INSTALL_DATADIR}/doc/noonmark)
install(FILES README.md DESTINATION ${NOONMARK_DOC_DIR} COMPONENT documentation)
install(FILES packaging/copyright DESTINATION ${NOONMARK_DOC_DIR} COMPONENT documentation)
install(DIRECTORY docs DESTINATION ${NOONMARK_DOC_DIR} COMPONENT documentation)
install(FILES ${descriptions}/changelog.gz DESTINATION ${NOONMARK_DOC_DIR} COMPONENT documentation)

include(NoonmarkPackage)
