#pragma once

// The folder app/report/movie makes moving pictures. shadow_movie.h paints the frames of a day, of a year or
// of the change from one scenario to another; movie_writer.h (this file) writes frames as MP4 or GIF, with
// the library that encoder/ makes.

#include <QImage>
#include <filesystem>
#include <memory>

#include "core/base/result.h"

namespace noonmark {

/// The picture with a table of at most 256 colours: those that most of its pixels have and, where it has more
/// colours, 96 that are spread evenly. All others become the nearest of them; areas of maps stay flat.
/// O(pixels).
QImage reduceColours(const QImage& image);

struct MovieFormat {
    QSize size{1280, 720};       ///< pixels; even, 64 to 4096 each
    double framesPerSecond = 8;  ///< 0.5 to 60; a GIF rounds the time of a frame to 0.01 s
};

/// Error: a size or rate out of range.
Result<void> validate(const MovieFormat& format);

/// Writes frames one after the other into a file: H.264 in MP4, which every player opens, or an endless GIF
/// where the name ends with .gif. Memory does not grow with the number of frames. The first movie loads
/// FFmpeg.
class MovieWriter {
public:
    /// Creates the file, replacing what is there; write through PendingFile. Error: another ending, a format
    /// out of range, no encoder, the file cannot be created, or the library is missing. Needs a
    /// QCoreApplication.
    static Result<MovieWriter> create(const std::filesystem::path& file, const MovieFormat& format);
    MovieWriter(MovieWriter&&) noexcept;
    MovieWriter& operator=(MovieWriter&&) noexcept;
    ~MovieWriter();

    /// Appends a frame of the format's size. Error: the file cannot be written.
    Result<void> add(const QImage& frame);
    /// Completes the file. Without it, the file cannot be played.
    Result<void> finish();

private:
    struct Parts;
    explicit MovieWriter(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace noonmark
