#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include "core/base/gdal_calls.h"
#include "core/io/files/readable_text.h"
#include "core/io/footprints/field_aliases.h"

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

}  // namespace noonmark
