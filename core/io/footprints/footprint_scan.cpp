#include "core/io/footprints/footprint_scan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cmath>

#include "core/base/safe_text.h"
#include "core/io/files/plain_file.h"
#include "core/io/heights/height_facts.h"
#include "core/io/pieces/read_part.h"

namespace noonmark {

namespace {

Result<FootprintScan> scanWhole(const std::filesystem::path& file, const Format& format,
                                const ReadSettings& settings, Progress& progress, std::stop_token stop) {
    const auto piece = format.reader.read(file, settings, progress, std::move(stop), nullptr);
    if (!piece) return tl::make_unexpected(piece.error());
    FootprintScan scan;
    scan.frame = piece->frame.value_or(settings.frame.value_or(Frame()));
    scan.indexed = false;
    scan.hasTerrain = piece->terrain != nullptr;
    for (const auto& building : piece->buildings) scan.add(*building, scan.frame);
    return scan;
}

// A building is too small for the curve of a parallel to reach out of this margin.
LonLatBox boxOf(const Building& building, const Frame& frame) {
    constexpr double marginDeg = 1e-5;  // a metre
    const Box2 local = bounds(building);
    LonLatBox box = emptyLonLatBox;
    for (const glm::vec2 corner :
         {local.low, local.high, glm::vec2(local.low.x, local.high.y), glm::vec2(local.high.x, local.low.y)})
        box.add(frame.lonLatFromLocal(glm::dvec2(corner)));
    const double eastDeg = marginDeg / std::max(std::cos(Degrees{box.northDeg}.radians().value), 0.01);
    return {box.westDeg - eastDeg, box.southDeg - marginDeg, box.eastDeg + eastDeg, box.northDeg + marginDeg};
}

}  // namespace

Result<FootprintScan> scanBuildings(const std::filesystem::path& file, const Format& format,
                                    const ReadSettings& settings, Progress& progress, std::stop_token stop) {
    if (format.reader.scan == nullptr) return scanWhole(file, format, settings, progress, std::move(stop));
    auto scan = format.reader.scan(file, settings, progress, std::move(stop));
    if (scan) scan->indexed = scan->indexed && format.readsExtent;
    return scan;
}

void FootprintScan::add(const UnplacedFeature& feature) {
    LonLatBox own = emptyLonLatBox;
    for (const LonLatPolygon& polygon : feature.polygons)
        for (const LonLat place : polygon.front()) own.add(place);
    const HeightReading& heights = feature.facts.heights;
    add(own, heights.roof ? std::max(heights.topM, heights.roof->elevationM) : heights.topM);
}

void FootprintScan::add(const Building& building, const Frame& frame) {
    if (building.parts.empty()) return;
    float lowestM = building.parts.front().bottomM;
    for (const Part& part : building.parts) lowestM = std::min(lowestM, part.bottomM);
    add(boxOf(building, frame), topM(building) - lowestM);
}

void FootprintScan::add(const LonLatBox& own, double heightM) {
    box.add({own.westDeg, own.southDeg});
    box.add({own.eastDeg, own.northDeg});
    ++features;
    const auto cellOf = [](double degrees) { return int(std::floor(degrees / cellDeg)); };
    for (int row = cellOf(own.southDeg); row <= cellOf(own.northDeg); ++row)
        for (int column = cellOf(own.westDeg); column <= cellOf(own.eastDeg); ++column) {
            double& tallest = tallestM[{column, row}];
            tallest = std::max(tallest, heightM);
        }
}

Result<std::vector<ListedLayer>> listLayers(const std::filesystem::path& file, const std::stop_token& stop,
                                            Formats formats) {
    const auto format = detectFormat(file, formats);
    if (!format) return tl::make_unexpected(format.error());
    const auto list = (*format)->reader.list;
    if (list == nullptr) return std::vector<ListedLayer>{};
    return list(file, stop);
}

std::string describeValues(const ListedField& field, std::size_t sampled) {
    const std::string of = countOf(sampled, "feature");
    if (field.values == 0) return fmt::format("no value in the first {}", of);
    const std::string range = field.low ? fmt::format("{:g} to {:g} in ", *field.low, *field.high) : "";
    return fmt::format("{} ({}{} of {})", fmt::join(field.samples, ", "), range,
                       formatThousands(field.values), of);
}

std::string_view nameOfRole(std::optional<FieldRole> role) {
    if (!role) return {};
    switch (*role) {
        case FieldRole::height:
            return "height";
        case FieldRole::levels:
            return "storeys";
        case FieldRole::name:
            return "name";
        case FieldRole::topElevation:
            return "elevation of the roof";
        case FieldRole::groundElevation:
            return "elevation of the ground";
        case FieldRole::bottomElevation:
            return "elevation of the underside";
        default:
            return {};
    }
}

}  // namespace noonmark
