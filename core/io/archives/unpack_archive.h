#pragma once

// The folder core/io/archives reads cities in .zip, .kmz and .gz: unpack_archive.h (this file) unpacks them
// into a private folder, and finds the files in them that hold a city.

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/working_files.h"

namespace noonmark {

/// Limits on what an untrusted archive unpacks to.
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

/// What is left of the limits while an archive is unpacked, with all archives in it.
struct UnpackBudget {
    UnpackLimits limits;
    std::uintmax_t packedBytes = 0;  ///< of the outermost archive
    std::uintmax_t bytes = 0;        ///< unpacked so far
    std::size_t files = 0;
};

/// Writes one file of an archive. `name`: its path in `folder`, as the archive says; it may not lead out of
/// it.
class UnpackedFile {
public:
    static Result<UnpackedFile> create(const std::filesystem::path& folder, const std::string& name,
                                       UnpackBudget& budget);
    /// Error: beyond a limit, or the disk is full.
    Result<void> write(std::span<const char> bytes);
    Result<void> close();

private:
    UnpackedFile(std::filesystem::path path, UnpackBudget& budget);
    std::filesystem::path path_;
    std::ofstream stream_;
    UnpackBudget* budget_;
};

/// Unpacks all files of one archive into a folder. Backends: unpack_minizip.cpp and unpack_zlib.cpp.
Result<void> unpackZip(const std::filesystem::path& file, const std::filesystem::path& folder,
                       UnpackBudget& budget, const std::stop_token& stop);
Result<void> unpackGzip(const std::filesystem::path& file, const std::filesystem::path& folder,
                        UnpackBudget& budget, const std::stop_token& stop);

}  // namespace noonmark
