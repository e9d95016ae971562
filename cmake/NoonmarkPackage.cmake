# CPack: one .deb with all components. packaging/package builds, checks and lists it.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME noonmark)
set(CPACK_PACKAGE_VENDOR "The Noonmark authors")
set(CPACK_PACKAGE_CONTACT "Noonmark maintainers <noonmark@users.noreply.github.com>" CACHE STRING "Maintainer of the packages")
set(CPACK_PACKAGE_HOMEPAGE_URL https://noonmark.github.io)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "measure the shadows of buildings on a city")
set(CPACK_PACKAGE_DESCRIPTION
"Noonmark measures the shadows that buildings cast on a city over hours, days
and years, and what a proposed building would change. It reads footprints,
3D city models and terrain, compares scenarios, shapes towers on their lots,
evaluates the rules of review boards, and writes maps, tables and reports
that state how each figure was made and how exact it is.

The package holds the window (noonmark) and the command line (noonmark-cli).")
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/../package)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# Loaded at run time, so dpkg-shlibdeps does not see them: time zones, the fonts of maps and reports, and OpenGL in software where there
# is no graphics card. Recommended: OpenCL on the processor (engine iam), Wayland.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "tzdata, fonts-dejavu-core, libgl1-mesa-dri")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "fonts-roboto-unhinted, pocl-opencl-icd, qt6-translations-l10n, qt6-wayland")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "qgis")

# Debian's own changelog, beside the project's.
set(maintainer "${CPACK_PACKAGE_CONTACT}")
set(NOONMARK_DEBIAN_VERSION ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})
execute_process(COMMAND date --utc --rfc-email --date=${NOONMARK_RELEASE_DATE} OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE
                ERROR_QUIET)
file(CONFIGURE OUTPUT ${generated}/changelog.Debian @ONLY CONTENT
"noonmark (@NOONMARK_DEBIAN_VERSION@) bookworm; urgency=medium

  * Version @PROJECT_VERSION@: see changelog.gz.

 -- @maintainer@  @date@
")
execute_process(COMMAND ${GZIP} -9 --no-name --force --keep ${generated}/changelog.Debian)
install(FILES ${generated}/changelog.Debian.gz DESTINATION ${NOONMARK_DOC_DIR} COMPONENT documentation)

include(CPack)
