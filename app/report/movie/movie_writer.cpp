#include "app/report/movie/movie_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/report/files/helper_library.h"
#include "app/report/movie/encoder/movie_encoder.h"
#include "app/report/movie/frame_colours.h"

namespace noonmark {

namespace {

constexpr int minSide = 64, maxSide = 4096;
constexpr double minRate = 0.5, maxRate = 60;

bool isGif(const std::filesystem::path& file) { return file.extension() == ".gif"; }

Error cannotWrite(const std::string& file, const char* what) {
    return {std::string("The movie cannot be written: ") + what, file,
            "Check that the folder exists, is writable and has space"};
}

}  // namespace

struct MovieWriter::Parts {
    std::string file;
    MovieFormat format;
    bool gif = false;
    std::unique_ptr<MovieEncoder> encoder;

    [[nodiscard]] Result<void> resultOf(const char* problem) const {
        if (problem == nullptr) return {};
        return tl::make_unexpected(cannotWrite(file, problem));
    }
    const char* addIndices(const QImage& image) {
        const QImage indices = reduceColours(image);
        std::array<std::uint32_t, 256> colours{};
        std::ranges::copy(indices.colorTable(), colours.begin());
        return encoder->addIndices(indices.constBits(), int(indices.bytesPerLine()), colours.data());
    }
    const char* addPixels(const QImage& image) {
        const QImage pixels = image.convertToFormat(QImage::Format_RGB32);
        return encoder->addPixels(pixels.constBits(), int(pixels.bytesPerLine()));
    }
};

MovieWriter::MovieWriter(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
MovieWriter::MovieWriter(MovieWriter&&) noexcept = default;
MovieWriter& MovieWriter::operator=(MovieWriter&&) noexcept = default;
MovieWriter::~MovieWriter() = default;

Result<void> validate(const MovieFormat& format) {
    const auto fits = [](int side) { return side >= minSide && side <= maxSide && side % 2 == 0; };
    if (!fits(format.size.width()) || !fits(format.size.height()))
        return failure(
            fmt::format("The size {} x {} is not possible", format.size.width(), format.size.height()),
            "size", fmt::format("Give even numbers of {} to {}", minSide, maxSide));
    if (format.framesPerSecond >= minRate && format.framesPerSecond <= maxRate) return {};
    return failure("The number of frames per second is out of range", "fps",
                   fmt::format("Give {} to {}", minRate, maxRate));
}

Result<MovieWriter> MovieWriter::create(const std::filesystem::path& file, const MovieFormat& format) {
    if (auto valid = validate(format); !valid) return tl::make_unexpected(valid.error());
    if (!isGif(file) && file.extension() != ".mp4")
        return failure("The name of a movie ends with .mp4 or .gif", file.string(), "Give such a name");
    const auto make = loadHelper("noonmark-movie-encoder", makeMovieEncoderName, "writes movies");
    if (!make) return tl::make_unexpected(make.error());
    const MadeMovieEncoder made =
        reinterpret_cast<MakeMovieEncoder>(*make)(file.c_str(), {.width = format.size.width(),
                                                                 .height = format.size.height(),
                                                                 .framesPerSecond = format.framesPerSecond,
                                                                 .gif = isGif(file)});
    if (made.encoder == nullptr) return tl::make_unexpected(cannotWrite(file.string(), made.problem));
    return MovieWriter(std::make_unique<Parts>(
        Parts{file.string(), format, isGif(file), std::unique_ptr<MovieEncoder>(made.encoder)}));
}

Result<void> MovieWriter::add(const QImage& frame) {
    Parts& parts = *parts_;
    const QImage image =
        frame.size() == parts.format.size
            ? frame
            : frame.scaled(parts.format.size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    return parts.resultOf(parts.gif ? parts.addIndices(image) : parts.addPixels(image));
}

Result<void> MovieWriter::finish() { return parts_->resultOf(parts_->encoder->finish()); }

}  // namespace noonmark
