#pragma once

#include <memory>
#include <optional>
#include <string>

class OGRFeature;
class OGRGeometry;
class OGRLayer;

namespace noonmark {

/// The system that the first geometry of a table names as PostGIS writes it ("SRID=25833;POINT (...)"):
/// "EPSG:25833". Nothing: none. Backend: written_crs_gdal.cpp.
std::optional<std::string> findWrittenCrs(OGRLayer& layer);

/// The geometry in such a text of a feature, which GDAL does not read; null: none.
std::unique_ptr<OGRGeometry> readWrittenGeometry(const OGRFeature& feature);

}  // namespace noonmark
