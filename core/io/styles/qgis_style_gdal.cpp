#include "core/io/styles/qgis_style.h"

#include <ogrsf_frmts.h>

namespace noonmark {

void writeLayerStyle(GDALDataset& geoPackage, OGRLayer& layer, const LayerStyle& style) {
    if (style.qml.empty()) return;
    std::vector<std::string> statements = styleTableSql();
    statements.push_back(addStyleSql(layer.GetName(), layer.GetGeometryColumn(), style));
    for (const LayerStyle& other : style.others)
        statements.push_back(addStyleSql(layer.GetName(), layer.GetGeometryColumn(), other, false));
    for (const std::string& sql : statements)
        geoPackage.ReleaseResultSet(geoPackage.ExecuteSQL(sql.c_str(), nullptr, nullptr));
}

}  // namespace noonmark
