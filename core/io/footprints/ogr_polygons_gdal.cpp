#include "core/io/footprints/ogr_polygons.h"

#include <cpl_minixml.h>
#include <fmt/format.h>
#include <ogr_geometry.h>
#include <ogrsf_frmts.h>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string_view>

#include "core/base/gdal_calls.h"
#include "core/city/footprints/repair_footprint.h"
#include "core/geo/lon_lat.h"

namespace noonmark {

namespace {

std::vector<glm::dvec2> pointsOf(const OGRLinearRing& ring) {
    std::vector<glm::dvec2> points;
    for (int i = 0; i < ring.getNumPoints(); ++i) points.emplace_back(ring.getX(i), ring.getY(i));
    return points;
}

void collect(const OGRPolygon& polygon, std::vector<CrsPolygon>& polygons) {
    const OGRLinearRing* outer = polygon.getExteriorRing();
    if (outer == nullptr || outer->getNumPoints() == 0) return;
    CrsPolygon& rings = polygons.emplace_back();
    rings.push_back(pointsOf(*outer));
    for (int i = 0; i < polygon.getNumInteriorRings(); ++i)
        if (polygon.getInteriorRing(i)->getNumPoints() > 0)
            rings.push_back(pointsOf(*polygon.getInteriorRing(i)));
}

void collect(const OGRGeometry& geometry, std::vector<CrsPolygon>& polygons);

// Of a solid those faces that show in plan.
template <class Faces>
void collectFaces(const Faces& faces, std::vector<CrsPolygon>& polygons) {
    const bool anyInPlan = std::any_of(faces.begin(), faces.end(),
                                       [](const OGRGeometry* face) { return !isUprightFace(*face); });
    for (const OGRGeometry* face : faces)
        if (!anyInPlan || !isUprightFace(*face)) collect(*face, polygons);
}

void collect(const OGRGeometry& geometry, std::vector<CrsPolygon>& polygons) {
    const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
    if (type == wkbPolygon || type == wkbTriangle)
        collect(*geometry.toPolygon(), polygons);
    else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection))
        collectFaces(*geometry.toGeometryCollection(), polygons);
    else if (OGR_GT_IsSubClassOf(type, wkbPolyhedralSurface))
        collectFaces(*geometry.toPolyhedralSurface(), polygons);
}

}  // namespace

bool isUprightFace(const OGRGeometry& face) {
    const OGRwkbGeometryType type = wkbFlatten(face.getGeometryType());
    if (face.Is3D() == FALSE || (type != wkbPolygon && type != wkbTriangle)) return false;
    OGREnvelope3D box;
    face.getEnvelope(&box);
    const double width = box.MaxX - box.MinX, depth = box.MaxY - box.MinY;
    constexpr double lowest = 0.5;  // metres or feet: less is a level face, rounded
    return box.MaxZ - box.MinZ > lowest &&
           face.toSurface()->get_Area() <= 1e-6 * (width * width + depth * depth);
}

std::vector<CrsPolygon> readPolygons(const OGRGeometry& geometry) {
    std::vector<CrsPolygon> polygons;
    if (geometry.hasCurveGeometry() != FALSE) {
        const std::unique_ptr<OGRGeometry> straight(geometry.getLinearGeometry());
        if (straight) collect(*straight, polygons);
    } else {
        collect(geometry, polygons);
    }
    return polygons;
}

namespace {

constexpr double farthestM = 200000;
constexpr double longestSideM = 500;  // a straight side of this length deviates by some 5 mm at most
constexpr double metresPerDegree = 111320;

std::vector<glm::dvec2> ringPoints(const OGRLinearRing& ring) {
    std::vector<glm::dvec2> points;
    for (const OGRPoint& point : ring) points.emplace_back(point.getX(), point.getY());
    return points;
}

std::size_t countPoints(const OGRPolygon& polygon) {
    std::size_t points = 0;
    for (const OGRLinearRing* ring : polygon) points += std::size_t(ring->getNumPoints());
    return points;
}

// Unwraps longitudes, so that no side goes round the globe where a ring crosses the antimeridian.
void unwrap(OGRPolygon& polygon, double nearDeg) {
    for (OGRLinearRing* ring : polygon)
        for (int i = 0; i < ring->getNumPoints(); ++i)
            if (std::abs(ring->getX(i)) <= 360)  // otherwise it is not a longitude, which is reported later
                ring->setPoint(i, wrapLongitudeNear(ring->getX(i), nearDeg), ring->getY(i));
}

bool isInDegrees(const OGRSpatialReference& crs) {
    constexpr double degree = 0.017453292519943295;
    return crs.IsGeographic() != 0 && std::abs(crs.GetAngularUnits() / degree - 1) < 1e-9;
}

}  // namespace

Result<void> checkedNear(LonLat place, const Frame& frame, const std::string& where) {
    const double metres = computeGreatCircleM(place, frame.origin());
    if (metres <= farthestM) return {};
    return failure(fmt::format("The position is {:.0f} km from the city", metres / 1000), where,
                   "Check the order of the numbers (west,south,east,north) and the CRS of the file");
}

PolygonLayer::PolygonLayer(CrsToLonLat toLonLat, double longestSide, const Frame& frame, std::string where)
    : toLonLat_(std::move(toLonLat)), longestSide_(longestSide), frame_(frame), where_(std::move(where)) {}

Result<PolygonLayer> PolygonLayer::of(const OGRSpatialReference* crs, const Frame& frame,
                                      const std::string& where) {
    const std::string wkt = wktOf(crs);
    if (wkt.empty())
        return failure("The file does not state its coordinate reference system", where,
                       "Save it with its CRS, or as GeoJSON");
    auto toLonLat = CrsToLonLat::of(wkt);
    if (!toLonLat) return tl::make_unexpected(Error{toLonLat.error().what, where, toLonLat.error().advice});
    const double metresPerUnit = crs->IsGeographic() != 0 ? metresPerDegree : crs->GetLinearUnits();
    PolygonLayer layer(*std::move(toLonLat), longestSideM / metresPerUnit, frame, where);
    layer.inDegrees_ = isInDegrees(*crs);
    return layer;
}

Result<std::vector<Footprint>> PolygonLayer::polygons(const OGRGeometry& geometry) const {
    std::vector<Footprint> pieces;
    return add(geometry, pieces).map([&] { return std::move(pieces); });
}

Result<void> PolygonLayer::add(const OGRGeometry& geometry, std::vector<Footprint>& pieces) const {
    const std::unique_ptr<OGRGeometry> straight(geometry.getLinearGeometry());
    const OGRwkbGeometryType type = wkbFlatten(straight->getGeometryType());
    if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection)) {
        for (const OGRGeometry* member : *straight->toGeometryCollection())
            if (auto added = add(*member, pieces); !added) return added;
        return {};
    }
    if (type != wkbPolygon) return {};
    OGRPolygon& polygon = *straight->toPolygon();
    if (const std::size_t points = countPoints(polygon); points > maxOutlinePoints)
        return limitReached(fmt::format("A polygon has {} points, more than {}", points, maxOutlinePoints),
                            where_, "Simplify it");
    if (inDegrees_) unwrap(polygon, frame_.origin().lonDeg);
    // Checked before its sides are divided: a distant point would give millions of pieces.
    for (const OGRLinearRing* ring : polygon)
        if (const auto near = localRing(ringPoints(*ring)); !near) return tl::make_unexpected(near.error());
    polygon.segmentize(longestSide_);
    std::vector<RawRing> rings;
    for (const OGRLinearRing* ring : polygon) {
        auto local = localRing(ringPoints(*ring));
        if (!local) return tl::make_unexpected(local.error());
        rings.push_back(*std::move(local));
    }
    for (Footprint& piece : repairFootprint(rings).pieces) pieces.push_back(std::move(piece));
    return {};
}

Result<PolygonLayer::LocalRing> PolygonLayer::localRing(const std::vector<glm::dvec2>& points) const {
    const std::vector<LonLat> places = toLonLat_.lonLat(points);
    LocalRing local;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (std::isnan(places[i].lonDeg) || !toLonLat_.isPlausible(places[i]))
            return failure(fmt::format("A point at {}, {} is outside the range of {}", points[i].x,
                                       points[i].y, toLonLat_.name()),
                           where_, "Check the CRS of the file");
        if (auto near = checkedNear(places[i], frame_, where_); !near)
            return tl::make_unexpected(near.error());
        local.push_back(frame_.localFromLonLat(places[i]));
    }
    return local;
}

bool PolygonLayer::mayReach(const OGRGeometry& geometry, const Box2& box) const {
    constexpr float marginM = 1;  // sides deviate by less within 1 km
    OGREnvelope envelope;
    geometry.getEnvelope(&envelope);
    const std::array corners{
        glm::dvec2{envelope.MinX, envelope.MinY}, glm::dvec2{envelope.MaxX, envelope.MinY},
        glm::dvec2{envelope.MaxX, envelope.MaxY}, glm::dvec2{envelope.MinX, envelope.MaxY}};
    Box2 reached;
    for (const LonLat place : toLonLat_.lonLat(corners)) {
        if (std::isnan(place.lonDeg) || computeGreatCircleM(place, frame_.origin()) > farthestM) return false;
        reached.add(glm::vec2(frame_.localFromLonLat(place)));
    }
    return reached.low.x - marginM < box.high.x && box.low.x < reached.high.x + marginM &&
           reached.low.y - marginM < box.high.y && box.low.y < reached.high.y + marginM;
}

namespace {

constexpr std::uintmax_t maxBytes = std::uintmax_t(256) << 20;  // some 2.5 GB of memory

struct TreeRelease {
    void operator()(CPLXMLNode* tree) const { CPLDestroyXMLNode(tree); }
};

// "-122.08,37.42,17 -122.09,...": its first corner; the third number may be absent.
std::optional<KmlPolygons::Corner> firstCorner(std::string_view text) {
    double numbers[3] = {0, 0, 0};
    for (double& number : numbers) {
        if (&number == &numbers[2] && !text.starts_with(',')) break;
        const auto start = text.find_first_not_of(" \t\r\n,");
        if (start == text.npos) return std::nullopt;
        text.remove_prefix(start);
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (error != std::errc()) return std::nullopt;
        text.remove_prefix(std::size_t(end - text.data()));
    }
    return KmlPolygons::Corner{numbers[0], numbers[1], numbers[2]};
}

KmlStanding standingOf(const CPLXMLNode& polygon) {
    const std::string_view mode = CPLGetXMLValue(&polygon, "altitudeMode", "clampToGround");
    const std::string_view extrude = CPLGetXMLValue(&polygon, "extrude", "0");
    if (mode == "absolute") return KmlStanding::absolute;
    if (mode != "relativeToGround") return KmlStanding::onGround;
    return extrude == "1" || extrude == "true" ? KmlStanding::extruded : KmlStanding::floating;
}

bool isElement(const CPLXMLNode& node, const char* name) {
    return node.eType == CXT_Element && std::strcmp(node.pszValue, name) == 0;
}

const OGRPolygon* firstPolygon(const OGRGeometry& geometry) {
    const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
    if (type == wkbPolygon) return geometry.toPolygon();
    if (!OGR_GT_IsSubClassOf(type, wkbGeometryCollection)) return nullptr;
    for (const OGRGeometry* part : *geometry.toGeometryCollection())
        if (const OGRPolygon* polygon = firstPolygon(*part)) return polygon;
    return nullptr;
}

}  // namespace

/// Walks through the elements of a KML file.
class KmlCollector {
public:
    explicit KmlCollector(KmlPolygons& found) : found_(found) {}

    void collect(const CPLXMLNode* node, const std::shared_ptr<const KmlPolygons::Data>& data = {}) {
        for (; node != nullptr; node = node->psNext)
            if (isElement(*node, "Polygon"))
                add(*node, data);
            else if (isElement(*node, "Placemark"))
                collect(node->psChild, dataOf(*node));
            else if (node->eType == CXT_Element)
                collect(node->psChild, data);
    }

private:
    static constexpr std::size_t maxFields = 200;

    void add(const CPLXMLNode& polygon, const std::shared_ptr<const KmlPolygons::Data>& data) {
        const auto corner =
            firstCorner(CPLGetXMLValue(&polygon, "outerBoundaryIs.LinearRing.coordinates", ""));
        if (!corner) return;
        found_.standing_.try_emplace(*corner, standingOf(polygon));
        if (data && !data->empty()) found_.data_.try_emplace(*corner, data);
    }

    // <Data name="height"><value>9</value></Data>, or <SimpleData name="height">9</SimpleData> in SchemaData.
    std::shared_ptr<const KmlPolygons::Data> dataOf(const CPLXMLNode& placemark) {
        auto data = std::make_shared<KmlPolygons::Data>();
        const CPLXMLNode* const extended = CPLGetXMLNode(&placemark, "ExtendedData");
        for (const CPLXMLNode* one = extended == nullptr ? nullptr : extended->psChild; one != nullptr;
             one = one->psNext)
            if (isElement(*one, "Data"))
                take(*one, CPLGetXMLValue(one, "value", ""), *data);
            else if (isElement(*one, "SchemaData"))
                for (const CPLXMLNode* item = one->psChild; item != nullptr; item = item->psNext)
                    if (isElement(*item, "SimpleData")) take(*item, CPLGetXMLValue(item, nullptr, ""), *data);
        return data;
    }

    void take(const CPLXMLNode& item, const char* value, KmlPolygons::Data& data) {
        const std::string name = CPLGetXMLValue(&item, "name", "");
        if (name.empty() || (found_.fields_.size() >= maxFields && !found_.fields_.contains(name))) return;
        found_.fields_.insert(name);
        data.try_emplace(name, value);
    }

    KmlPolygons& found_;
};

KmlPolygons KmlPolygons::of(const std::filesystem::path& file) {
    const GdalCalls quiet;
    KmlPolygons polygons;
    std::error_code error;
    if (std::filesystem::file_size(file, error) > maxBytes || error) return polygons;
    const std::unique_ptr<CPLXMLNode, TreeRelease> tree(CPLParseXMLFile(file.c_str()));
    if (!tree) return polygons;
    CPLStripXMLNamespace(tree.get(), nullptr, TRUE);
    KmlCollector(polygons).collect(tree.get());
    return polygons;
}

std::optional<KmlPolygons::Corner> KmlPolygons::firstCornerOf(const OGRGeometry& geometry) {
    const OGRPolygon* const polygon = firstPolygon(geometry);
    const OGRLinearRing* const ring = polygon != nullptr ? polygon->getExteriorRing() : nullptr;
    if (ring == nullptr || ring->getNumPoints() == 0) return std::nullopt;
    return Corner{ring->getX(0), ring->getY(0), ring->getZ(0)};
}

std::optional<KmlStanding> KmlPolygons::findStanding(const Corner& firstCorner) const {
    const auto found = standing_.find(firstCorner);
    return found == standing_.end() ? std::nullopt : std::optional(found->second);
}

const KmlPolygons::Data* KmlPolygons::findData(const Corner& firstCorner) const {
    const auto found = data_.find(firstCorner);
    return found == data_.end() ? nullptr : found->second.get();
}

}  // namespace noonmark
