#pragma once

// The folder core/io/archives reads cities in .zip, .kmz and .gz: unpack_archive.h (this file) unpacks them
// into a private folder, and finds the files in them that hold a city.

#include <cstdint>
#include <filesystem>
#include <stop_token>
#include <vector>

#include "core/base/private_folder.h"
#include "core/base/result.h"

namespace noonmark {

/// What an untrusted archive may grow to.
struct UnpackLimits {
    std::uintmax_t bytes = std::uintmax_t(8) << 30U;      ///< of all files together
    std::uintmax_t anyRatio = std::uintmax_t(64) << 20U;  ///< bytes up to which the ratio is not looked at
    double ratio = 200;                                   ///< of unpacked to packed bytes
    std::size_t files = 10'000;
    int nesting = 2;  ///< archives in archives
};

/// An archive in a folder of its own, which is removed with it.
struct UnpackedArchive {
    PrivateFolder folder;
    std::vector<std::filesystem::path> cities;  ///< files in it, or geodatabases: one, or 3D city models
};

/// Unpacks a file that is ZIP or gzip. Of what is in it, the file whose format is read is the city;
/// companions of it lie beside it. Several 3D city models are the tiles of one city. Nothing is written
/// outside of the private folder, and no links are made. Error: damaged, encrypted, beyond a limit, a name
/// that leads out of the folder, no file that is read, or several that are no tiles; cancelled().
Result<UnpackedArchive> unpackArchive(const std::filesystem::path& file, const std::stop_token& stop,
                                      const UnpackLimits& limits = {});

}  // namespace noonmark
