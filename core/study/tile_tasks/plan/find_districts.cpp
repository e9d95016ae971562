#include "core/study/tile_tasks/plan/find_districts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "core/io/files/file_kind.h"
#include "core/io/read_region.h"

namespace noonmark {

namespace {

constexpr double metresPerDegree = 111'200;  // of latitude

Result<void> checkWholeSize(const std::vector<std::string>& files) {
    std::uintmax_t bytes = 0;
    for (const std::string& file : files) {
        std::error_code error;
        const auto own = std::filesystem::file_size(file, error);
        bytes += error ? 0 : own;
    }
    if (bytes <= mostBytesReadWhole) return {};
    return failure(fmt::format("Every task would have to read {:.1f} GB, because a format cannot be read by "
                               "window; {:.1f} GB is the limit",
                               double(bytes) / 1e9, double(mostBytesReadWhole) / 1e9),
                   files.front(),
                   "Convert the footprints to FlatGeobuf: ogr2ogr -f FlatGeobuf city.fgb FILE");
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

struct Counts {
    int columns, rows;
};

Counts countDistricts(const LonLatBox& box, double sideM) {
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

Result<std::vector<District>> divide(const LonLatBox& box, Counts counts) {
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

}  // namespace

std::vector<std::filesystem::path> pathsOf(const std::vector<std::string>& files) {
    return {files.begin(), files.end()};
}

Result<InputsScan> scanInputs(const TaskPlanRequest& request, Progress& progress,
                              const std::stop_token& stop) {
    InputsScan scan;
    bool footprintsOnly = true;
    for (const std::string& file : request.files) {
        const auto kind = detectFileKind(file);
        if (!kind) return tl::make_unexpected(kind.error());
        (*kind == FileKind::terrain ? scan.terrain : scan.buildings).emplace_back(file);
        footprintsOnly = footprintsOnly && (*kind == FileKind::footprints || *kind == FileKind::terrain);
    }
    for (std::size_t i = 0; footprintsOnly && i < scan.buildings.size(); ++i) {
        auto piece = scanFootprints(scan.buildings[i], request.reading, progress, stop);
        if (!piece) return tl::make_unexpected(piece.error());
        join(scan.footprints, *std::move(piece));
    }
    scan.byWindow = footprintsOnly && !scan.buildings.empty() && scan.footprints.indexed;
    if (scan.byWindow) return scan;
    return checkWholeSize(request.files).map([&] { return std::move(scan); });
}

Result<std::vector<District>> findDistricts(const TaskPlanRequest& request, const InputsScan& scan) {
    const FootprintScan& all = scan.footprints;
    const auto box = request.region == "city" ? std::optional(all.box) : parseBox(request.region);
    if (!box) return oneDistrict(request, all.frame);
    const Counts counts = countDistricts(*box, request.districtM);
    if (counts.columns * counts.rows > 1) return divide(*box, counts);
    const Counts inputs = countDistricts(all.box, 2 * request.districtM);
    const bool small = inputs.columns * inputs.rows == 1;
    return oneDistrict(request, small ? all.frame : Frame(middleOf(*box)));
}

}  // namespace noonmark
