# Every third-party library that Noonmark uses, found in one place. All are Debian packages (packaging/packages.txt).
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(TBB REQUIRED)
find_package(fmt REQUIRED)
find_package(glm REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(tl-expected REQUIRED)
find_package(CLI11 REQUIRED)
find_package(hwy REQUIRED)
find_package(GDAL REQUIRED)
find_package(SQLite3 REQUIRED)
find_package(embree 3 REQUIRED)
find_package(CGAL REQUIRED)
find_package(assimp REQUIRED)
find_package(date REQUIRED)
# GDAL's own library of coordinate systems, confined to its own files.
pkg_check_modules(PROJ REQUIRED IMPORTED_TARGET proj)
pkg_check_modules(ERFA REQUIRED IMPORTED_TARGET erfa)
pkg_check_modules(GEOGRAPHICLIB REQUIRED IMPORTED_TARGET geographiclib)
pkg_check_modules(GEOS REQUIRED IMPORTED_TARGET geos)
# libosmium, which reads OpenStreetMap, consists of headers; these are the libraries that they need.
find_path(OSMIUM_INCLUDE_DIR osmium/version.hpp REQUIRED)
find_package(ZLIB REQUIRED)
# Reads cities in .zip and .kmz.
pkg_check_modules(MINIZIP REQUIRED IMPORTED_TARGET minizip)
find_package(PNG REQUIRED)
find_package(EXPAT REQUIRED)
# Reads filed reports again.
pkg_check_modules(POPPLER REQUIRED IMPORTED_TARGET poppler-qt6)
# Bookmarks, language and page labels of PDFs.
pkg_check_modules(QPDF REQUIRED IMPORTED_TARGET libqpdf)
# Writes movies as MP4 and GIF.
pkg_check_modules(LIBAV REQUIRED IMPORTED_TARGET libavcodec libavformat libavutil libswscale)
# Writes buildings as faces in DXF, which GDAL's driver cannot.
pkg_check_modules(DXFLIB REQUIRED IMPORTED_TARGET dxflib)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(OpenCL REQUIRED)
# Cities with their time zones; without it the window guesses a zone from the tz database's cities alone.
pkg_check_modules(GEONAMES IMPORTED_TARGET geonames)
# Allocates memory for the command line, where many threads free what others allocated. Sanitizers have allocators of their own.
if(NOT NOONMARK_SANITIZE)
  pkg_check_modules(JEMALLOC REQUIRED IMPORTED_TARGET jemalloc)
endif()
