#include "core/io/osm/read_osm_footprints.h"

#include <fmt/format.h>

#include "core/base/gdal_calls.h"
#include "core/base/progress_share.h"
#include "core/io/files/plain_file.h"
#include "core/io/footprints/build_footprints.h"
#include "core/io/footprints/map_remarks.h"
#include "core/io/layers/feature_stream.h"
#include "core/io/osm/read_osm_buildings.h"

namespace noonmark {

namespace {

using Path = std::filesystem::path;

/// Reading's share of the progress.
class ReadingProgress final : public Progress {
public:
    explicit ReadingProgress(Progress& whole) : whole_(whole) {}
    void report(double fraction, std::string_view stage) override {
        whole_.report(shareOfReading * fraction, stage);
    }

private:
    Progress& whole_;
};

// Files from GDAL's driver have one layer of areas by this name.
Result<void> checkLayer(const Path& file, const ReadSettings& settings) {
    if (settings.layer.empty() || settings.layer == "multipolygons") return {};
    return failure(fmt::format("There is no layer \"{}\"", settings.layer), file.string(),
                   "OpenStreetMap has one layer of buildings: name none");
}

Result<OsmBuildings> readChecked(const Path& file, OsmFormat format, const ReadSettings& settings,
                                 Progress& progress, const std::stop_token& stop) {
    if (auto plain = checkPlainFile(file); !plain) return tl::make_unexpected(plain.error());
    ReadingProgress reading(progress);
    const GdalCalls calls;
    auto buildings = checkLayer(file, settings).and_then([&] {
        return readOsmBuildings(file, format, settings, reading, stop);
    });
    if (!buildings) return buildings;
    if (buildings->areas == 0)
        return failure("It holds no polygons", file.string(), "Export the building footprints as polygons");
    if (buildings->features.empty())
        return failure(fmt::format("None of its {} polygons can be used as a building", buildings->areas),
                       file.string(), findCommonest(buildings->warnings));
    addMapRemarks(calls.complaints(), file.filename().string(), buildings->warnings);
    return buildings;
}

// A beginning that tells neither form is that of XML with long comments.
OsmFormat formatOf(const Path& file) { return findOsmFormat(file).value_or(OsmFormat::xml); }

tl::unexpected<Error> notRead(const std::exception& exception, const Path& file) {
    return failure(fmt::format("The map cannot be read ({})", exception.what()), file.string(),
                   "Check that it is complete, or export it again");
}

}  // namespace

Result<FilePiece> readOsmFootprints(const Path& file, const ReadSettings& settings, Progress& progress,
                                    std::stop_token stop) try {
    const OsmFormat format = formatOf(file);
    auto buildings = readChecked(file, format, settings, progress, stop);
    if (!buildings) return tl::make_unexpected(buildings.error());
    FilePiece piece{.warnings = std::move(buildings->warnings),
                    .format = format == OsmFormat::pbf ? "OpenStreetMap PBF" : "OpenStreetMap XML",
                    .features = buildings->areas,
                    .attribution = osmCredit,
                    .heights = std::move(buildings->heights),
                    .crs = describeCrs("WGS 84", CrsSource::file)};
    piece.trees = std::move(buildings->trees);
    if (auto built = buildFootprints(piece, std::move(buildings->features), settings, progress, stop); !built)
        return tl::make_unexpected(built.error());
    if (!piece.buildings.empty()) return piece;
    return failure("None of its polygons can be used as a building", file.string(),
                   findCommonest(piece.warnings));
} catch (const std::exception& exception) {
    return notRead(exception, file);
}

Result<FootprintScan> scanOsmFootprints(const Path& file, const ReadSettings& settings, Progress& progress,
                                        std::stop_token stop) try {
    const auto buildings = readChecked(file, formatOf(file), settings, progress, stop);
    if (!buildings) return tl::make_unexpected(buildings.error());
    FootprintScan scan;
    scan.indexed = false;
    FeatureCentres centres;
    for (const UnplacedFeature& feature : buildings->features) {
        centres.add(feature);
        scan.add(feature);
    }
    scan.frame = centres.frame(settings.farAwayM);
    return scan;
} catch (const std::exception& exception) {
    return notRead(exception, file);
}

}  // namespace noonmark
