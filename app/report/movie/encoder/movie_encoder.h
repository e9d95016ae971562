#pragma once

// The folder app/report/movie/encoder is a library of its own, noonmark-movie-encoder, which is loaded when
// the first movie is written (../movie_writer.cpp): FFmpeg brings 76 libraries, which would take every
// command 20 ms to load. It links FFmpeg and nothing else.

#include <cstdint>

namespace noonmark {

struct MovieTrack {
    int width = 0, height = 0;  ///< pixels, even
    double framesPerSecond = 8;
    bool gif = false;  ///< else H.264 in MP4
};

/// Encodes frames into a file. Every function returns null, or what went wrong, a text that is never freed.
class MovieEncoder {
public:
    virtual ~MovieEncoder() = default;
    MovieEncoder() = default;
    MovieEncoder(const MovieEncoder&) = delete;
    MovieEncoder& operator=(const MovieEncoder&) = delete;

    /// Appends a frame of an MP4. `pixels`: 4 bytes each, blue, green, red and one unused; row 0 at the top.
    virtual const char* addPixels(const std::uint8_t* pixels, int bytesPerRow) = 0;
    /// Appends a frame of a GIF. `indices`: a byte each, of `colours`, which are 256 times 0xAARRGGBB.
    virtual const char* addIndices(const std::uint8_t* indices, int bytesPerRow,
                                   const std::uint32_t* colours) = 0;
    /// Completes the file.
    virtual const char* finish() = 0;
};

/// One of the two.
struct MadeMovieEncoder {
    MovieEncoder* encoder = nullptr;  ///< the caller deletes it
    const char* problem = nullptr;
};

/// Creates the file. What noonmarkMakeMovieEncoder, the only function of the library, is.
using MakeMovieEncoder = MadeMovieEncoder (*)(const char* file, const MovieTrack& track);
inline constexpr const char* makeMovieEncoderName = "noonmarkMakeMovieEncoder";

}  // namespace noonmark
