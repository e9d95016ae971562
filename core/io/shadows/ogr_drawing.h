#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/io/shadows/write_shadows.h"

class OGRGeometry;
class OGRSpatialReference;

namespace noonmark {

/// Makes GDAL's shapes of polygons and lines of a frame in a plane, or in longitude and latitude. Backend:
/// ogr_drawing_gdal.cpp.
class OgrDrawing {
public:
    static Result<OgrDrawing> inPlane(const Frame& frame, DrawingPlane plane);
    static Result<OgrDrawing> inLonLat(const Frame& frame);
    OgrDrawing(OgrDrawing&&) noexcept;
    OgrDrawing& operator=(OgrDrawing&&) noexcept;
    ~OgrDrawing();

    [[nodiscard]] const OGRSpatialReference& system() const;
    [[nodiscard]] glm::dvec2 place(glm::dvec2 local) const;
    [[nodiscard]] std::unique_ptr<OGRGeometry> polygon(const Footprint& footprint) const;
    [[nodiscard]] std::unique_ptr<OGRGeometry> multiPolygon(const std::vector<Footprint>& footprints) const;
    [[nodiscard]] std::unique_ptr<OGRGeometry> line(const std::vector<glm::vec2>& points) const;

private:
    struct Parts;
    explicit OgrDrawing(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace noonmark
