#pragma once

// The folder core/io/files holds what all readers and writers share. Inputs are untrusted: this file detects
// a file's format (formats/format.h) from its content and refuses pipes and devices,
// core/base/gdal_calls_gdal.cpp restricts GDAL, open_dataset.h is the only way from a file to GDAL,
// geopackage_check.h refuses databases that would run SQL. Outputs: check_output.h names their kinds and
// protects existing files, write_text.h replaces a file in one step.

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <istream>
#include <stop_token>
#include <streambuf>

#include "core/base/result.h"
#include "core/io/formats/format.h"

namespace noonmark {

/// Detects the format from the content; the name only matters if the content is ambiguous. Reads the
/// beginning of the file; of JSON as far as the first key that identifies it. A GeoPackage or a folder is
/// opened with GDAL: it holds footprints if it has vector layers. Never returns a null pointer. Error:
/// missing, empty, unreadable, or of a format that is not read; the advice says what to do or lists the
/// formats.
Result<const Format*> detectFormat(const std::filesystem::path& file, Formats formats = coreFormats());

/// What a file of that format holds.
Result<FileKind> detectFileKind(const std::filesystem::path& file);

/// The format of a file that GDAL can open but whose beginning does not identify it; the same Error. Backend:
/// plain_file_gdal.cpp.
Result<const Format*> detectFormatWithGdal(const std::filesystem::path& file, Formats formats);

/// Checks that an input is a plain file, or a folder that is a data set: opening a pipe can block for ever,
/// and a device such as /dev/zero has no end. Links are followed. Error: it does not exist, or is something
/// else.
Result<void> checkPlainFile(const std::filesystem::path& file);

/// Checks that what the program writes by itself, in a folder that a stranger may have packed, does not lead
/// elsewhere: it is a plain file or folder and no link, or is not there yet.
Result<void> checkNoLink(const std::filesystem::path& fileOrFolder);

/// A file that is at its end after a stop request, so that a parser which cannot be stopped gives up. Whoever
/// reads it asks the token whether the end was the file's own. It cannot be rewound.
class StoppableStream : private std::streambuf, public std::istream {
public:
    /// Without a token it ends with the StopScope of this thread.
    explicit StoppableStream(const std::filesystem::path& file, std::stop_token stop = {});

    [[nodiscard]] bool opened() const { return file_.is_open(); }
    /// The share of the file that has been read, 0 to 1.
    [[nodiscard]] double share() const { return double(taken_) / double(bytes_); }

private:
    std::streambuf::int_type underflow() override;

    std::ifstream file_;
    std::stop_token stop_;
    std::uintmax_t bytes_ = 1, taken_ = 0;
    std::array<char, 1U << 16U> piece_{};
};

}  // namespace noonmark
