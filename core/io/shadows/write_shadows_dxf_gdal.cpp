#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>

#include "core/base/gdal_calls.h"
#include "core/io/shadows/ogr_drawing.h"
#include "core/io/shadows/shadow_drawing.h"
#include "core/io/shadows/write_shadows.h"

namespace noonmark {

namespace {

/// GDAL's template with metres instead of its inches, as a file in memory.
class MetreHeader {
public:
    MetreHeader() {
        const char* found = CPLFindFile("gdal", "header.dxf");
        if (found == nullptr) return;
        std::ifstream stream(found, std::ios::binary);
        text_.assign(std::istreambuf_iterator<char>(stream), {});
        text_ = std::regex_replace(text_, std::regex("(\\$INSUNITS\\r?\\n *70\\r?\\n *)1"), "$016");
        text_ = std::regex_replace(text_, std::regex("(\\$MEASUREMENT\\r?\\n *70\\r?\\n *)0"), "$011");
        VSILFILE* file =
            VSIFileFromMemBuffer(name_.c_str(), reinterpret_cast<GByte*>(text_.data()), text_.size(), FALSE);
        if (file != nullptr) VSIFCloseL(file);
    }
    MetreHeader(const MetreHeader&) = delete;
    MetreHeader& operator=(const MetreHeader&) = delete;
    ~MetreHeader() { VSIUnlink(name_.c_str()); }
    [[nodiscard]] const std::string& name() const { return name_; }

private:
    std::string text_;
    std::string name_ = fmt::format("/vsimem/noonmark_{}.dxf", static_cast<const void*>(this));
};

struct DxfStyle {
    const char* line;  // colours as #rrggbb
    const char* fill;  // null: no hatch
};
constexpr DxfStyle buildingStyle{"#505050", nullptr}, proposedStyle{"#c00000", nullptr},
    removedStyle{"#a0a0a0", nullptr}, placeStyle{"#2e7d32", nullptr}, fanStyle{"#6a1b9a", nullptr},
    isochroneStyle{"#1565c0", nullptr}, distanceStyle{"#2e7d32", nullptr}, areaStyle{"#a0a0a0", nullptr};

DxfStyle styleOfShadow(std::string_view kind) {
    if (kind == "incremental") return {"#c62828", "#ef9a9a"};
    return kind == "gained" ? DxfStyle{"#f9a825", "#fff59d"} : DxfStyle{"#757575", "#cfcfcf"};
}

const char* layerOfState(BuildingState state) {
    switch (state) {
        case BuildingState::unchanged:
            return "buildings";
        case BuildingState::proposed:
            return "buildings_proposed";
        case BuildingState::removed:
            break;
    }
    return "buildings_removed";
}

const DxfStyle& styleOfState(BuildingState state) {
    if (state == BuildingState::proposed) return proposedStyle;
    return state == BuildingState::removed ? removedStyle : buildingStyle;
}

/// Writes entities one by one; false once GDAL has refused one.
class DxfWriter {
public:
    DxfWriter(OGRLayer& layer, const OgrDrawing& shapes) : layer_(layer), shapes_(shapes) {}

    void addPolygons(const std::string& name, const std::vector<Footprint>& polygons, DxfStyle style) {
        for (const Footprint& polygon : polygons) {
            if (style.fill != nullptr)
                add(name, shapes_.polygon(polygon), fmt::format("BRUSH(fc:{})", style.fill));
            addRing(name, polygon.outer, style);
            for (const Ring& hole : polygon.holes) addRing(name, hole, style);
        }
    }

    void addLine(const std::string& name, const std::vector<glm::vec2>& points, DxfStyle style) {
        add(name, shapes_.line(points), fmt::format("PEN(c:{})", style.line));
    }

    void addText(const std::string& name, glm::dvec2 at, const std::string& text, double heightM) {
        std::string quoted;
        for (const char letter : text) {
            if (letter == '"') quoted += '\\';
            quoted += static_cast<unsigned char>(letter) < ' ' ? ' ' : letter;
        }
        const glm::dvec2 placed = shapes_.place(at);
        add(name, std::make_unique<OGRPoint>(placed.x, placed.y),
            fmt::format("LABEL(f:\"Arial\",t:\"{}\",s:{:g}g,c:#202020)", quoted, heightM));
    }

    [[nodiscard]] bool isGood() const { return good_; }

private:
    void addRing(const std::string& name, const Ring& ring, DxfStyle style) {
        std::vector<glm::vec2> points = ring;
        points.push_back(ring.front());
        addLine(name, points, style);
    }

    void add(const std::string& name, std::unique_ptr<OGRGeometry> shape, const std::string& style) {
        OGRFeature feature(layer_.GetLayerDefn());
        feature.SetField("Layer", name.c_str());
        feature.SetStyleString(style.c_str());
        feature.SetGeometryDirectly(shape.release());
        good_ = good_ && layer_.CreateFeature(&feature) == OGRERR_NONE;
    }

    OGRLayer& layer_;
    const OgrDrawing& shapes_;
    bool good_ = true;
};

glm::dvec2 middleOf(const Place& place) {
    Box2 box;
    for (const Footprint& polygon : place.polygons) box.add(bounds(polygon));
    return glm::dvec2(box.low + box.high) / 2.0;
}

/// The parts of a drawing on their layers.
class DxfDrawing {
public:
    DxfDrawing(const ShadowDrawing& drawing, DxfWriter& writer)
        : drawing_(drawing), writer_(writer), textM_(textHeight(drawing.area)) {
        for (const char* taken : {"0", "buildings", "buildings_proposed", "buildings_removed", "places",
                                  "place_names", "area", "notes"})
            names_.add(taken);
    }

    void write(const std::string& plane) {
        for (const DrawnMoment& moment : drawing_.moments) writeMoment(moment);
        for (const DrawnFan& fan : drawing_.fans) writeFan(fan);
        writeIsochrones();
        for (const DrawnPart& part : drawing_.buildings)
            writer_.addPolygons(layerOfState(part.state), {part.outline}, styleOfState(part.state));
        for (const Place& place : drawing_.places) {
            writer_.addPolygons("places", place.polygons, placeStyle);
            writer_.addText("place_names", middleOf(place), place.name, textM_);
        }
        writeArea(plane);
    }

private:
    static double textHeight(const Box2& area) {
        return std::clamp(double(area.high.x - area.low.x) / 150, 0.5, 20.0);
    }

    void writeMoment(const DrawnMoment& moment) {
        for (const auto& [kind, polygons] : listShadows(moment.outlines))
            if (!polygons->empty())
                writer_.addPolygons(names_.add(moment.time.name + "_" + kind), *polygons,
                                    styleOfShadow(kind));
    }

    void writeFan(const DrawnFan& fan) {
        for (const DrawnFanStep& step : fan.steps)
            if (!step.outlines.empty())
                writer_.addPolygons(names_.add("fan_" + step.time.name), step.outlines, fanStyle);
        if (!fan.all.empty()) writer_.addPolygons(names_.add("fan_" + fan.name), fan.all, fanStyle);
    }

    void writeIsochrones() {
        for (const DrawnIsochrones& day : drawing_.isochrones) {
            std::map<double, std::string> layers;  // by level
            for (const Isochrone& line : day.lines) {
                std::string& layer = layers[line.level];
                if (layer.empty()) layer = names_.add(fmt::format("isochrones_{}_{:g}", day.day, line.level));
                writer_.addLine(layer, pointsToDraw(line), isochroneStyle);
            }
        }
        for (const DrawnDistance& distance : drawing_.distances)
            writer_.addPolygons(names_.add(fmt::format("distance_{:g}m", distance.metres)), distance.outlines,
                                distanceStyle);
    }

    void writeArea(const std::string& plane) {
        const Box2& area = drawing_.area;
        const Ring outline{area.low, {area.high.x, area.low.y}, area.high, {area.low.x, area.high.y}};
        writer_.addPolygons("area", {{outline, {}}}, areaStyle);
        std::vector<std::string> lines{"Coordinates: " + plane};
        for (const DrawnMoment& moment : drawing_.moments)
            lines.push_back(fmt::format("{}: {}, sun at azimuth {:.1f}, altitude {:.1f} deg",
                                        moment.time.name, moment.time.clock, moment.time.sun.azimuthDeg,
                                        moment.time.sun.altitudeDeg));
        lines.insert(lines.end(), drawing_.notes.begin(), drawing_.notes.end());
        glm::dvec2 at(area.low);
        for (const std::string& line : lines)
            writer_.addText("notes", at -= glm::dvec2(0, 2 * textM_), line, textM_);
    }

    const ShadowDrawing& drawing_;
    DxfWriter& writer_;
    double textM_;
    LayerNames names_;
};

}  // namespace

Result<void> writeShadowsDxf(const std::filesystem::path& file, const ShadowDrawing& drawing,
                             DrawingPlane plane) {
    const auto shapes = OgrDrawing::inPlane(drawing.frame, plane);
    if (!shapes) return tl::make_unexpected(shapes.error());
    const GdalCalls calls;
    const MetreHeader header;
    CPLStringList options;
    options.SetNameValue("HEADER", header.name().c_str());
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("DXF");
    GDALDatasetUniquePtr dataset(
        driver == nullptr ? nullptr : driver->Create(file.c_str(), 0, 0, 0, GDT_Unknown, options.List()));
    OGRLayer* layer = dataset ? dataset->CreateLayer("entities", nullptr, wkbUnknown, nullptr) : nullptr;
    bool written = false;
    if (layer != nullptr) {
        DxfWriter writer(*layer, *shapes);
        DxfDrawing(drawing, writer).write(describePlane(drawing.frame, plane).value());
        written = writer.isGood();
    }
    dataset.reset();
    if (written && !calls.failed()) return {};
    return failure("The DXF file could not be written: " + calls.why(), file.string(),
                   "Check that the folder exists, is writable and has space");
}

}  // namespace noonmark
