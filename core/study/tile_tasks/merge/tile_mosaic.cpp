#include "core/study/tile_tasks/merge/tile_mosaic.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/xml_text.h"

namespace noonmark {

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
                text += sourceOf(plan, tile, std::filesystem::relative(*file, folder).string(),
                                 map.firstBand + number);
        text += "  </VRTRasterBand>\n";
    }
    return text + "</VRTDataset>\n";
}

}  // namespace noonmark
