#include "core/io/footprints/footprint_scan.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>
#include <algorithm>

#include "core/base/gdal_calls.h"
#include "core/base/safe_text.h"
#include "core/io/files/open_dataset.h"
#include "core/io/files/plain_file.h"
#include "core/io/files/readable_text.h"
#include "core/io/footprints/building_layers.h"
#include "core/io/heights/height_text.h"

namespace noonmark {

namespace {

std::string quoted(const std::string& text) {
    std::string sql = "'";
    for (const char c : text) sql += c == '\'' ? std::string("''") : std::string(1, c);
    return sql + "'";
}

// GDAL reads these from version 3.7 on.
void addGeoPackageNames(GDALDataset& dataset, OGRLayer& layer, std::vector<std::string>& aliases) {
    const GdalCalls quiet;  // most GeoPackages have no such table
    const std::string sql =
        "SELECT column_name, coalesce(name, title) AS alias FROM gpkg_data_columns WHERE "
        "lower(table_name) = lower(" +
        quoted(layer.GetName()) + ")";
    OGRLayer* const rows = dataset.ExecuteSQL(sql.c_str(), nullptr, nullptr);
    if (rows == nullptr) return;
    while (const OGRFeatureUniquePtr row{rows->GetNextFeature()}) {
        const int index = layer.GetLayerDefn()->GetFieldIndex(row->GetFieldAsString(0));
        if (index >= 0 && aliases[std::size_t(index)].empty())
            aliases[std::size_t(index)] = readableText(row->GetFieldAsString(1));
    }
    dataset.ReleaseResultSet(rows);
}

}  // namespace

std::vector<std::string> listFieldAliases(GDALDataset& dataset, OGRLayer& layer) {
    std::vector<std::string> aliases;
    for (int i = 0; i < layer.GetLayerDefn()->GetFieldCount(); ++i)
        aliases.push_back(readableText(layer.GetLayerDefn()->GetFieldDefn(i)->GetAlternativeNameRef()));
    if (dataset.GetDriverName() == std::string("GPKG")) addGeoPackageNames(dataset, layer, aliases);
    return aliases;
}

namespace {

constexpr std::size_t maxListed = 1000;  // features of a layer
constexpr std::size_t maxSamples = 4;    // values of a field
constexpr std::size_t maxListedBytes = 40;

// A name or value of a stranger, short enough for a list.
std::string listedText(const char* bytes) {
    std::string text = cleanText(readableText(bytes));
    if (text.size() <= maxListedBytes) return text;
    std::size_t end = maxListedBytes;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
    return text.substr(0, end) + "...";
}

std::optional<double> numberOf(const OGRFeature& feature, int index, const std::string& text) {
    const OGRFieldType type = feature.GetFieldDefnRef(index)->GetType();
    if (type == OFTInteger || type == OFTInteger64 || type == OFTReal) return feature.GetFieldAsDouble(index);
    return type == OFTString ? parseMetres(withDecimalPoint(text)) : std::nullopt;
}

// GDAL writes a real number with all decimals of its column.
std::string listedValue(const OGRFeature& feature, int index) {
    if (feature.GetFieldDefnRef(index)->GetType() == OFTReal)
        return fmt::format("{}", feature.GetFieldAsDouble(index));
    return listedText(feature.GetFieldAsString(index));
}

void addValue(ListedField& field, const OGRFeature& feature, int index) {
    if (feature.IsFieldSetAndNotNull(index) == FALSE) return;
    const std::string text = listedValue(feature, index);
    if (text.empty()) return;
    ++field.values;
    const bool isNew = std::ranges::find(field.samples, text) == field.samples.end();
    if (isNew && field.samples.size() < maxSamples) field.samples.push_back(text);
    if (const auto number = numberOf(feature, index, text)) {
        field.low = std::min(field.low.value_or(*number), *number);
        field.high = std::max(field.high.value_or(*number), *number);
    }
}

ListedLayer listFieldsOf(GDALDataset& dataset, OGRLayer& layer) {
    const OGRFeatureDefn& definition = *layer.GetLayerDefn();
    const bool cutShort = std::string_view(dataset.GetDriverName()) == "ESRI Shapefile";
    const std::vector<std::string> aliases = listFieldAliases(dataset, layer);
    ListedLayer listed{.name = listedText(layer.GetName()),
                       .features = std::size_t(std::max<GIntBig>(0, layer.GetFeatureCount())),
                       .fields = {}};
    for (int i = 0; i < definition.GetFieldCount(); ++i) {
        ListedField field{.name = readableText(definition.GetFieldDefn(i)->GetNameRef()),
                          .alias = aliases[std::size_t(i)]};
        auto meaning = findMeaning(field.name, cutShort);
        if (!meaning) meaning = findMeaning(field.alias);
        if (meaning) field.role = meaning->role;
        listed.fields.push_back(std::move(field));
    }
    return listed;
}

void sampleFields(OGRLayer& layer, ListedLayer& listed, const std::stop_token& stop) {
    layer.ResetReading();
    while (listed.sampled < maxListed && !stop.stop_requested()) {
        const OGRFeatureUniquePtr feature(layer.GetNextFeature());
        if (!feature) break;
        ++listed.sampled;
        for (std::size_t i = 0; i < listed.fields.size(); ++i) addValue(listed.fields[i], *feature, int(i));
    }
    layer.ResetReading();
}

bool isPointOrNone(OGRwkbGeometryType type) {
    return type == wkbNone || type == wkbPoint || type == wkbMultiPoint;
}

// A table's geometry is known by its first row.
bool mayHavePoints(OGRLayer& layer) {
    const auto stated = wkbFlatten(layer.GetGeomType());
    if (stated != wkbUnknown) return isPointOrNone(stated);
    layer.ResetReading();
    const OGRFeatureUniquePtr first(layer.GetNextFeature());
    layer.ResetReading();
    if (!first) return false;
    const OGRGeometry* geometry = first->GetGeometryRef();
    return geometry == nullptr || isPointOrNone(wkbFlatten(geometry->getGeometryType()));
}

// `wants` and `isRead`: of a layer.
template <class Wants, class IsRead>
Result<std::vector<ListedLayer>> listWanted(GDALDataset& dataset, Wants&& wants, IsRead&& isRead,
                                            const std::stop_token& stop) {
    std::vector<ListedLayer> layers;
    for (OGRLayer* layer : dataset.GetLayers()) {
        if (!wants(*layer)) continue;
        ListedLayer listed = listFieldsOf(dataset, *layer);
        listed.isRead = isRead(layer);
        sampleFields(*layer, listed, stop);
        if (stop.stop_requested()) return cancelled();
        layers.push_back(std::move(listed));
    }
    return layers;
}

}  // namespace

Result<std::vector<ListedLayer>> listMapLayers(const std::filesystem::path& file, std::stop_token stop) {
    if (auto plain = checkPlainFile(file); !plain) return tl::make_unexpected(plain.error());
    const GdalCalls calls(stop);
    const auto dataset = openDataset(file, DatasetContent::vectors);
    if (!dataset) return tl::make_unexpected(dataset.error());
    Warnings unheard;  // reading the file says which layers it leaves out
    const auto read = chooseBuildingLayers(**dataset, unheard);
    const auto isRead = [&](OGRLayer* layer) { return std::ranges::find(read, layer) != read.end(); };
    return listWanted(**dataset, mayHavePolygons, isRead, stop);
}

Result<std::vector<ListedLayer>> listPointLayers(const std::filesystem::path& file, std::stop_token stop) {
    if (auto plain = checkPlainFile(file); !plain) return tl::make_unexpected(plain.error());
    const GdalCalls calls(stop);
    const auto dataset = openDataset(file, DatasetContent::vectors);
    if (!dataset) return tl::make_unexpected(dataset.error());
    return listWanted(
        **dataset, mayHavePoints, [](OGRLayer*) { return true; }, stop);
}

}  // namespace noonmark
