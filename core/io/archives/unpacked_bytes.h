#pragma once

#include <filesystem>
#include <fstream>
#include <span>
#include <stop_token>
#include <string>

#include "core/io/archives/unpack_archive.h"

namespace noonmark {

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
