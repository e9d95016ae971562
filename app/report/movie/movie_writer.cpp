#include "app/report/movie/movie_writer.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <unordered_map>
#include <vector>

#include "app/report/files/helper_library.h"
#include "app/report/movie/encoder/movie_encoder.h"

namespace noonmark {

namespace {

constexpr std::size_t maxColours = 256;
constexpr int reds = 4, greens = 6, blues = 4;  // of the even spread for pictures of many colours

// Five bits a channel: colours that differ less are one.
std::uint32_t roughly(QRgb colour) {
    return std::uint32_t(qRed(colour) >> 3 << 10 | qGreen(colour) >> 3 << 5 | qBlue(colour) >> 3);
}

struct ColourCount {
    QRgb colour = 0;  ///< the first of its group
    std::size_t pixels = 0;
};

int distance(QRgb a, QRgb b) {
    const int red = qRed(a) - qRed(b), green = qGreen(a) - qGreen(b), blue = qBlue(a) - qBlue(b);
    return 2 * red * red + 4 * green * green + 3 * blue * blue;  // the eye sees green best
}

std::uint8_t nearest(const std::vector<QRgb>& table, QRgb colour) {
    const auto found = std::ranges::min_element(table, {}, [&](QRgb one) { return distance(one, colour); });
    return std::uint8_t(found - table.begin());
}

std::unordered_map<std::uint32_t, ColourCount> countColours(const QImage& image) {
    std::unordered_map<std::uint32_t, ColourCount> counts;
    for (int y = 0; y < image.height(); ++y) {
        const auto* row = reinterpret_cast<const QRgb*>(image.constScanLine(y));
        for (int x = 0; x < image.width(); ++x) {
            ColourCount& count = counts[roughly(row[x])];
            if (count.pixels++ == 0) count.colour = row[x];
        }
    }
    return counts;
}

std::vector<QRgb> spreadColours() {
    std::vector<QRgb> table;
    for (int r = 0; r < reds; ++r)
        for (int g = 0; g < greens; ++g)
            for (int b = 0; b < blues; ++b)
                table.push_back(qRgb(255 * r / (reds - 1), 255 * g / (greens - 1), 255 * b / (blues - 1)));
    return table;
}

std::vector<QRgb> makeTable(const std::unordered_map<std::uint32_t, ColourCount>& counts) {
    std::vector<std::pair<ColourCount, std::uint32_t>> all;
    for (const auto& [rough, count] : counts) all.emplace_back(count, rough);
    // The same picture always gets the same table.
    std::ranges::sort(all, [](const auto& a, const auto& b) {
        return a.first.pixels != b.first.pixels ? a.first.pixels > b.first.pixels : a.second < b.second;
    });
    std::vector<QRgb> table = all.size() <= maxColours ? std::vector<QRgb>() : spreadColours();
    for (const auto& [count, rough] : all)
        if (table.size() < maxColours) table.push_back(count.colour | 0xff000000U);
    return table;
}

}  // namespace

QImage reduceColours(const QImage& given) {
    const QImage image = given.convertToFormat(QImage::Format_RGB32);
    const auto counts = countColours(image);
    const std::vector<QRgb> table = makeTable(counts);
    std::unordered_map<std::uint32_t, std::uint8_t> places;
    for (const auto& [rough, count] : counts) places.emplace(rough, nearest(table, count.colour));
    QImage reduced(image.size(), QImage::Format_Indexed8);
    reduced.setColorTable({table.begin(), table.end()});
    for (int y = 0; y < image.height(); ++y) {
        const auto* row = reinterpret_cast<const QRgb*>(image.constScanLine(y));
        uchar* to = reduced.scanLine(y);
        for (int x = 0; x < image.width(); ++x) to[x] = places.at(roughly(row[x]));
    }
    return reduced;
}

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
