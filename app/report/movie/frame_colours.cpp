#include "app/report/movie/frame_colours.h"

#include <algorithm>
#include <unordered_map>
#include <vector>

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

}  // namespace noonmark
