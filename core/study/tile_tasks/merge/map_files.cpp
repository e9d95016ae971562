#include "core/study/tile_tasks/merge/merge_tiles.h"

#include <fmt/format.h>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/safe_text.h"
#include "core/base/version.h"
#include "core/describe/figure_text.h"
#include "core/geo/lon_lat.h"
#include "core/measures/shadow_figures.h"
#include "core/sun/civil_time.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

namespace {

std::string formatUtc(Instant instant) {
    const auto seconds = std::chrono::floor<std::chrono::seconds>(instant);
    const auto day = std::chrono::floor<std::chrono::days>(seconds);
    const std::chrono::year_month_day date(day);
    const std::chrono::hh_mm_ss time(seconds - day);
    return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z", int(date.year()), unsigned(date.month()),
                       unsigned(date.day()), time.hours().count(), time.minutes().count(),
                       time.seconds().count());
}

Json outlineOf(const Grid& grid, const Frame& frame) {
    Json ring = Json::array();
    for (const glm::dvec2 corner :
         {glm::dvec2(grid.westM, grid.southM), glm::dvec2(grid.eastM(), grid.southM),
          glm::dvec2(grid.eastM(), grid.northM()), glm::dvec2(grid.westM, grid.northM()),
          glm::dvec2(grid.westM, grid.southM)}) {
        const LonLat place = frame.lonLatFromLocal(corner);
        ring.push_back({place.lonDeg, place.latDeg});
    }
    return {{"type", "Polygon"}, {"coordinates", Json::array({ring})}};
}

Json asset(const std::string& file, const char* type, const std::string& title) {
    return {{"href", "./" + file}, {"type", type}, {"title", title}, {"roles", {"data"}}};
}

Json propertiesOf(const District& district, const SunSteps& sun, const Period& period,
                  const ShadowStatistics& statistics) {
    const Grid& grid = district.tiles.whole;
    Json properties{{"datetime", nullptr},
                    {"start_datetime", formatUtc(sun.steps.front().at)},
                    {"end_datetime", formatUtc(sun.steps.back().at)},
                    {"title", "Shadow: " + formatText(period)},
                    {"processing:software", {{"Noonmark", std::string(version())}}},
                    {"gsd", grid.cellM},
                    {"proj:epsg", nullptr},
                    {"proj:shape", {grid.rows, grid.columns}},
                    {"proj:transform", {grid.cellM, 0.0, grid.westM, 0.0, -grid.cellM, grid.northM()}},
                    {"noonmark:proj_string", district.frame.projString()}};
    const Json figures = figuresJson(shadowFigures().of(statistics));
    for (const auto& [key, value] : figures.items())
        properties["noonmark:" + key] = value.is_number() && std::isnan(value.get<double>()) ? Json() : value;
    return properties;
}

}  // namespace

std::string makeStacItem(const TaskPlan& plan, const District& district, const std::vector<TileMap>& maps,
                         const SunSteps& sun, const Period& period, const ShadowStatistics& statistics) {
    const Grid& grid = district.tiles.whole;
    const LonLatBox box =
        makeLonLatBox(district.frame, {grid.westM, grid.southM}, {grid.eastM(), grid.northM()});
    const std::size_t number = std::size_t(&district - plan.districts.data());
    Json item{{"type", "Feature"},
              {"stac_version", "1.0.0"},
              {"stac_extensions",
               {"https://stac-extensions.github.io/projection/v1.1.0/schema.json",
                "https://stac-extensions.github.io/processing/v1.1.0/schema.json"}},
              {"id", fmt::format("noonmark-{}", plan.studyHash(number).substr(0, 16))},
              {"bbox", {box.westDeg, box.southDeg, box.eastDeg, box.northDeg}},
              {"geometry", outlineOf(grid, district.frame)},
              {"properties", propertiesOf(district, sun, period, statistics)},
              {"links", Json::array()}};
    for (const TileMap& map : maps) {
        const std::string file = district.name + map.name;
        item["assets"][map.name] =
            asset(file + ".tif", "image/tiff; application=geotiff; profile=cloud-optimized", map.title);
        item["assets"][map.firstBand == 0 ? "tiles" : map.name + "_tiles"] =
            asset(file + ".vrt", "application/xml", map.title + ": virtual raster of the tiles");
    }
    return item.dump(2) + "\n";
}

namespace {

std::string sourceOf(const TilePlan& plan, std::size_t number, const std::string& file, std::size_t band) {
    const Grid& whole = plan.whole;
    const Grid tile = plan.tile(number);
    const long column = std::lround((tile.westM - whole.westM) / whole.cellM);
    const long row = std::lround((whole.northM() - tile.northM()) / whole.cellM);
    return fmt::format(
        "    <SimpleSource>\n"
        "      <SourceFilename relativeToVRT=\"1\">{}</SourceFilename>\n"
        "      <SourceBand>{}</SourceBand>\n"
        "      <SrcRect xOff=\"0\" yOff=\"0\" xSize=\"{}\" ySize=\"{}\"/>\n"
        "      <DstRect xOff=\"{}\" yOff=\"{}\" xSize=\"{}\" ySize=\"{}\"/>\n"
        "    </SimpleSource>\n",
        escapeXml(file), band, tile.columns, tile.rows, column, row, tile.columns, tile.rows);
}

}  // namespace

std::string makeMosaic(const TilePlan& plan, const TileFiles& tiles, const Frame& frame, const TileMap& map,
                       const std::filesystem::path& folder) {
    const Grid& whole = plan.whole;
    std::string text = fmt::format(
        "<VRTDataset rasterXSize=\"{}\" rasterYSize=\"{}\">\n  <SRS>{}</SRS>\n"
        "  <GeoTransform>{}, {}, 0, {}, 0, {}</GeoTransform>\n",
        whole.columns, whole.rows, escapeXml(frame.projString()), whole.westM, whole.cellM, whole.northM(),
        -whole.cellM);
    std::size_t number = 0;
    for (const RasterBand& band : map.bands) {
        text += fmt::format(
            "  <VRTRasterBand dataType=\"Float32\" band=\"{}\">\n"
            "    <Description>{}</Description>\n    <UnitType>{}</UnitType>\n"
            "    <NoDataValue>nan</NoDataValue>\n",
            ++number, band.name, band.unit);
        for (const auto& [tile, file] : tiles)
            if (file)
                text += sourceOf(plan, tile, std::filesystem::relative(file->path, folder).string(),
                                 file->firstBandOf(map) + number);
        text += "  </VRTRasterBand>\n";
    }
    return text + "</VRTDataset>\n";
}

}  // namespace noonmark
