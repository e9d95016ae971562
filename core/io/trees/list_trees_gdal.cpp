#include "core/io/trees/list_trees.h"

#include <gdal_priv.h>
#include <algorithm>
#include <cmath>

#include "core/base/gdal_calls.h"
#include "core/io/files/open_dataset.h"
#include "core/io/files/plain_file.h"
#include "core/io/osm/read_osm_buildings.h"

namespace noonmark {

namespace {

// Names that only trees have: heights, places and states are known of other things, too.
bool saysTrees(const std::vector<KnownTreeField>& fields) {
    return std::ranges::any_of(fields, [](const KnownTreeField& field) {
        switch (field.meaning.role) {
            case TreeRole::crownDiameter:
            case TreeRole::stemDiameter:
            case TreeRole::stemGirth:
            case TreeRole::genus:
            case TreeRole::species:
            case TreeRole::leafCycle:
                return true;
            default:
                return false;
        }
    });
}

std::vector<KnownTreeField> findFieldsOf(const ListedLayer& layer) {
    std::vector<std::string> names;
    for (const ListedField& field : layer.fields) names.push_back(field.name);
    return findTreeFields(names);
}

// Some cells of the whole raster: a fifth and more have no canopy, the others as much as trees have.
// Elevations of a shore may look so, too.
TreeContent findContent(GDALDataset& dataset) {
    constexpr int side = 256;
    constexpr float openM = 0.5F, lowestM = -0.5F, highestM = 120, treeM = 2;
    if (dataset.GetRasterCount() < 1) return TreeContent::raster;
    GDALRasterBand& band = *dataset.GetRasterBand(1);
    const int columns = std::min(side, band.GetXSize()), rows = std::min(side, band.GetYSize());
    std::vector<float> cells(std::size_t(columns) * std::size_t(rows));
    if (band.RasterIO(GF_Read, 0, 0, band.GetXSize(), band.GetYSize(), cells.data(), columns, rows,
                      GDT_Float32, 0, 0) != CE_None)
        return TreeContent::raster;
    int hasNone = 0;
    const auto none = float(band.GetNoDataValue(&hasNone));
    std::size_t open = 0, trees = 0, others = 0;
    for (const float cell : cells)
        if (!std::isfinite(cell) || (hasNone != 0 && cell == none) || (cell >= lowestM && cell <= openM))
            ++open;
        else
            ++(cell >= treeM && cell <= highestM ? trees : others);
    const bool isCanopy = 5 * open >= cells.size() && trees > 0 && others <= trees;
    return isCanopy ? TreeContent::canopy : TreeContent::raster;
}

}  // namespace

Result<ListedTrees> listTrees(const std::filesystem::path& file, const std::stop_token& stop) {
    if (const auto plain = checkPlainFile(file); !plain) return tl::make_unexpected(plain.error());
    if (findOsmFormat(file)) return ListedTrees{.content = TreeContent::map};
    auto layers = listPointLayers(file, stop);
    if (!layers && isUnknownFormat(layers.error())) {
        const GdalCalls calls(stop);
        if (const auto raster = openDataset(file, DatasetContent::elevations))
            return ListedTrees{.content = findContent(**raster)};
    }
    if (!layers) return tl::make_unexpected(layers.error());
    ListedTrees listed{.content = layers->empty() ? TreeContent::none : TreeContent::points,
                       .layers = *std::move(layers)};
    for (const ListedLayer& layer : listed.layers) {
        listed.fields = findFieldsOf(layer);
        if (!saysTrees(listed.fields)) continue;
        listed.content = TreeContent::inventory;
        break;
    }
    return listed;
}

}  // namespace noonmark
