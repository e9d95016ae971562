#include "core/study/tile_tasks/plan/find_districts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "core/base/progress.h"
#include "core/io/files/plain_file.h"
#include "core/io/read_region.h"

namespace noonmark {

namespace {

constexpr double metresPerDegree = 111'200;  // of latitude

std::uintmax_t bytesOf(const std::filesystem::path& file) {
    std::error_code error;
    const auto bytes = std::filesystem::file_size(file, error);
    return error ? 0 : bytes;
}

Result<void> checkReadWhole(std::uintmax_t bytes, const std::string& file) {
    if (bytes <= maxBytesReadWhole) return {};
    return failure(fmt::format("Every task would have to read {:.1f} GB, because a format cannot be read by "
                               "window; {:.1f} GB is the limit",
                               double(bytes) / 1e9, double(maxBytesReadWhole) / 1e9),
                   file, "Convert the footprints to FlatGeobuf: ogr2ogr -f FlatGeobuf city.fgb FILE");
}

Result<void> checkWholeSize(const std::vector<std::string>& files) {
    std::uintmax_t bytes = 0;
    for (const std::string& file : files) bytes += bytesOf(file);
    return checkReadWhole(bytes, files.front());
}

Result<void> checkFileSizes(const InputsScan& scan) {
    for (std::size_t i = 0; i < scan.buildings.size(); ++i)
        if (!scan.indexed[i])
            if (auto sound = checkReadWhole(bytesOf(scan.buildings[i]), scan.buildings[i].string()); !sound)
                return sound;
    return {};
}

// What has to be read whole is divided only by files; meshes state no place.
bool mayBeDivided(const std::vector<const Format*>& formats) {
    const auto isReadable = [&](const Format* format) {
        return format->reader.scan != nullptr ||
               (format->reader.kind != FileKind::mesh && formats.size() > 1);
    };
    return !formats.empty() && std::ranges::all_of(formats, isReadable);
}

void join(FootprintScan& all, FootprintScan piece) {
    if (all.features == 0) {
        all = std::move(piece);
        return;
    }
    all.box.add({piece.box.westDeg, piece.box.southDeg});
    all.box.add({piece.box.eastDeg, piece.box.northDeg});
    all.features += piece.features;
    all.indexed = all.indexed && piece.indexed;
    for (const auto& [cell, tallest] : piece.tallestM)
        all.tallestM[cell] = std::max(all.tallestM[cell], tallest);
}

std::optional<LonLatBox> parseBox(const std::string& text) {
    LonLatBox box;
    int end = 0;
    const int count = std::sscanf(text.c_str(), " %lf , %lf , %lf , %lf %n", &box.westDeg, &box.southDeg,
                                  &box.eastDeg, &box.northDeg, &end);
    if (count != 4 || std::size_t(end) != text.size() || box.westDeg >= box.eastDeg) return std::nullopt;
    return box;
}

struct DistrictCounts {
    int columns, rows;
};

DistrictCounts countDistricts(const LonLatBox& box, double sideM) {
    const double middle = Degrees{(box.southDeg + box.northDeg) / 2}.radians().value;
    const double widthM = (box.eastDeg - box.westDeg) * metresPerDegree * std::cos(middle);
    const double heightM = (box.northDeg - box.southDeg) * metresPerDegree;
    return {std::max(1, int(std::ceil(widthM / sideM))), std::max(1, int(std::ceil(heightM / sideM)))};
}

LonLat middleOf(const LonLatBox& box) {
    return {(box.westDeg + box.eastDeg) / 2, (box.southDeg + box.northDeg) / 2};
}

// The whole city gets its region when its buildings are known.
Result<std::vector<District>> oneDistrict(const TaskPlanRequest& request, const Frame& frame) {
    if (request.region == "city") return std::vector<District>{{.frame = frame}};
    return readRegion(request.region, frame).map([&](Region region) {
        return std::vector<District>{{.frame = frame, .region = std::move(region)}};
    });
}

Result<std::vector<District>> divide(const LonLatBox& box, DistrictCounts counts) {
    std::vector<District> districts;
    const double width = (box.eastDeg - box.westDeg) / counts.columns;
    const double height = (box.northDeg - box.southDeg) / counts.rows;
    for (int row = 0; row < counts.rows; ++row)
        for (int column = 0; column < counts.columns; ++column) {
            const LonLatBox own{box.westDeg + column * width, box.southDeg + row * height,
                                box.westDeg + (column + 1) * width, box.southDeg + (row + 1) * height};
            District district{.name = fmt::format("d-{:03}-", districts.size()),
                              .frame = Frame(middleOf(own))};
            auto region =
                makeRegionFromLonLatBox(district.frame, own.westDeg, own.southDeg, own.eastDeg, own.northDeg);
            if (!region) return tl::make_unexpected(region.error());
            district.region = *std::move(region);
            districts.push_back(std::move(district));
        }
    return districts;
}

// Whether each building gets its ground without regard to the others.
bool isPlacedByItself(const ReadSettings& reading) {
    return reading.stand != Stand::automatic && reading.terrainShows == TerrainShows::ground;
}

}  // namespace

std::vector<std::filesystem::path> pathsOf(const std::vector<std::string>& files) {
    return {files.begin(), files.end()};
}

Result<InputsScan> scanInputs(const TaskPlanRequest& request, Progress& progress,
                              const std::stop_token& stop) {
    InputsScan scan;
    std::vector<const Format*> formats;
    for (const std::string& file : request.files) {
        const auto format = detectFormat(file);
        if (!format) return tl::make_unexpected(format.error());
        const bool terrain = (*format)->reader.kind == FileKind::terrain;
        (terrain ? scan.terrain : scan.buildings).emplace_back(file);
        if (!terrain) formats.push_back(*format);
    }
    bool divisible = mayBeDivided(formats) && (scan.terrain.empty() || isPlacedByItself(request.reading));
    for (std::size_t i = 0; divisible && i < formats.size(); ++i) {
        ProgressShare share(progress, i, formats.size());
        auto piece = scanBuildings(scan.buildings[i], *formats[i], request.reading, share, stop);
        if (!piece) return tl::make_unexpected(piece.error());
        divisible = !piece->hasTerrain;
        scan.boxes.push_back(piece->box);
        scan.indexed.push_back(piece->indexed);
        join(scan.footprints, *std::move(piece));
    }
    scan.byExtent = divisible && (scan.footprints.indexed || formats.size() > 1);
    const auto sizes = scan.byExtent ? checkFileSizes(scan) : checkWholeSize(request.files);
    return sizes.map([&] { return std::move(scan); });
}

std::vector<LonLatBox> InputsScan::boxesOf(const std::vector<std::string>& files) const {
    std::vector<LonLatBox> all;
    std::size_t next = 0;  // of `buildings`, which has the order of `files`
    for (const std::string& file : files) {
        const bool isNext = byExtent && next < buildings.size() && buildings[next] == file;
        all.push_back(isNext ? boxes[next++] : LonLatBox{-180, -90, 180, 90});
    }
    return all;
}

Result<std::vector<District>> findDistricts(const TaskPlanRequest& request, const InputsScan& scan) {
    const FootprintScan& all = scan.footprints;
    const auto box = request.region == "city" ? std::optional(all.box) : parseBox(request.region);
    if (!box) return oneDistrict(request, all.frame);
    const DistrictCounts counts = countDistricts(*box, request.districtM);
    if (counts.columns * counts.rows > 1) return divide(*box, counts);
    const DistrictCounts inputs = countDistricts(all.box, 2 * request.districtM);
    const bool small = inputs.columns * inputs.rows == 1;
    return oneDistrict(request, small ? all.frame : Frame(middleOf(*box)));
}

}  // namespace noonmark
