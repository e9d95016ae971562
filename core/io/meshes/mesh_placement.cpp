#include "core/io/meshes/mesh_placement.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <numbers>

#include "core/io/pieces/read_part.h"
#include "core/io/settings/read_settings.h"

namespace noonmark {

namespace {

bool isFinite(glm::vec3 point) {
    return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

// The finite points of a scene, in metres. Those in map coordinates are exact to some centimetres.
struct MeshPoints {
    const MeshScene& scene;
    double metresPerUnit = 1;

    template <class Use>
    void forEach(Use use) const {
        for (const MeshObject& object : scene)
            for (const MeshPiece& piece : object.pieces)
                for (const glm::vec3 own : piece.points) {
                    const glm::vec3 point((piece.origin + glm::dvec3(own)) * metresPerUnit);
                    if (isFinite(point)) use(point);
                }
    }
};

struct MeshExtent {
    glm::vec3 low{std::numeric_limits<float>::max()}, high{std::numeric_limits<float>::lowest()};
    std::size_t points = 0;
    [[nodiscard]] glm::vec3 size() const { return high - low; }
};

MeshExtent measureExtent(const MeshPoints& points) {
    MeshExtent extent;
    points.forEach([&](glm::vec3 point) {
        extent.low = glm::min(extent.low, point), extent.high = glm::max(extent.high, point);
        ++extent.points;
    });
    return extent;
}

// Sizes along an axis that could be up and along the two others.
struct UpSizes {
    UpAxis axis;
    float up, narrow, wide;
};

UpSizes sizesFor(UpAxis axis, glm::vec3 size) {
    const float up = axis == UpAxis::z ? size.z : size.y, other = axis == UpAxis::z ? size.y : size.z;
    return {axis, up, std::min(size.x, other), std::max(size.x, other)};
}

const char* letterOf(UpAxis axis) { return axis == UpAxis::z ? "z" : "y"; }

std::string sizeText(float size) {
    return size < 100 ? fmt::format("{:.3g}", size) : fmt::format("{:.0f}", size);
}

std::optional<UpAxisGuess> guessCity(const UpSizes& sizes) {
    constexpr float minWidth = 100;
    if (sizes.narrow < minWidth || sizes.up >= sizes.narrow / 2) return std::nullopt;
    return UpAxisGuess{sizes.axis,
                       fmt::format("the mesh is {} x {} and only {} in {}", sizeText(sizes.wide),
                                   sizeText(sizes.narrow), sizeText(sizes.up), letterOf(sizes.axis))};
}

std::optional<UpAxisGuess> guessTower(const UpSizes& sizes) {
    if (sizes.up <= 1.5F * sizes.wide) return std::nullopt;
    return UpAxisGuess{sizes.axis,
                       fmt::format("the mesh is {} x {} and {} in {}, as a tower is", sizeText(sizes.wide),
                                   sizeText(sizes.narrow), sizeText(sizes.up), letterOf(sizes.axis))};
}

std::optional<UpAxisGuess> guessByFeet(const MeshPoints& points, const MeshExtent& extent) {
    const glm::vec3 lowest = extent.low + 1e-3F * extent.size();
    std::size_t y = 0, z = 0;
    points.forEach([&](glm::vec3 point) {
        y += point.y <= lowest.y ? 1 : 0;
        z += point.z <= lowest.z ? 1 : 0;
    });
    const auto [fewer, more] = std::minmax(y, z);
    if (5 * more < extent.points || 4 * more < 5 * fewer) return std::nullopt;
    const UpAxis axis = z > y ? UpAxis::z : UpAxis::y;
    return UpAxisGuess{axis, fmt::format("most of its points are lowest in {}", letterOf(axis))};
}

// A flat bottom at 0.
bool standsAtZero(const MeshPoints& points, const MeshExtent& extent, UpAxis axis) {
    const auto along = [&](glm::vec3 point) { return axis == UpAxis::z ? point.z : point.y; };
    const float tolerance = 1e-3F * along(extent.size());
    if (std::abs(along(extent.low)) > tolerance) return false;
    std::size_t feet = 0;
    points.forEach([&](glm::vec3 point) { feet += along(point) <= tolerance ? 1 : 0; });
    return 5 * feet >= extent.points;
}

// Who exchanges the axes of a plan that begins at 0 gets a negative z, which leaves only y at 0.
std::optional<UpAxisGuess> guessByZero(const MeshPoints& points, const MeshExtent& extent) {
    const bool y = standsAtZero(points, extent, UpAxis::y), z = standsAtZero(points, extent, UpAxis::z);
    if (z && !y) return UpAxisGuess{UpAxis::z, "its flat bottom is at 0 in z"};
    if (y && !z) return UpAxisGuess{UpAxis::y, "its flat bottom is at 0 in y"};
    if (y && z) return UpAxisGuess{UpAxis::z, "it begins at 0 in y and z, as a plan with heights does"};
    return std::nullopt;
}

std::optional<UpAxisGuess> guessLower(const MeshPoints&, const MeshExtent& extent) {
    const glm::vec3 size = extent.size();
    if (size.y == size.z) return std::nullopt;
    const UpAxis axis = size.z < size.y ? UpAxis::z : UpAxis::y;
    return UpAxisGuess{
        axis,
        fmt::format("nothing else in its shape tells, and it is lower in {}: {} instead of {}",
                    letterOf(axis), sizeText(std::min(size.y, size.z)), sizeText(std::max(size.y, size.z)))};
}

}  // namespace

UpAxisGuess guessUpAxis(const MeshScene& scene, double metresPerUnit) {
    const MeshPoints points{scene, metresPerUnit};
    const MeshExtent extent = measureExtent(points);
    const UpAxisGuess standard{UpAxis::y, "nothing in its shape says otherwise"};
    if (extent.points == 0) return standard;
    for (const auto guess : {guessCity, guessTower})
        for (const UpAxis axis : {UpAxis::y, UpAxis::z})
            if (auto found = guess(sizesFor(axis, extent.size()))) return *std::move(found);
    for (const auto guess : {guessByFeet, guessByZero, guessLower})
        if (auto found = guess(points, extent)) return *std::move(found);
    return standard;
}

std::optional<UpAxisGuess> guessUpAxisOnMap(const MeshScene& scene, double metresPerUnit) {
    constexpr float minOnMap = 10'000;  // metres
    const MeshExtent extent = measureExtent({scene, metresPerUnit});
    if (extent.points == 0) return std::nullopt;
    const auto isHeight = [&](float low, float high) { return std::max(-low, high) < minOnMap; };
    const bool y = isHeight(extent.low.y, extent.high.y), z = isHeight(extent.low.z, extent.high.z);
    if (y == z) return std::nullopt;
    return UpAxisGuess{z ? UpAxis::z : UpAxis::y,
                       fmt::format("its coordinates along {} are those of a map", z ? "y" : "z")};
}

namespace {

constexpr const char* gltfFormat = "glTF";
constexpr double nearOriginM = 10'000;

// Metres per unit that the file or the user states; nothing where neither does.
std::optional<double> statedUnit(const MeshFile& file, const ReadSettings& settings) {
    if (file.stated && file.stated->metresPerUnit) return file.stated->metresPerUnit;
    if (settings.meshUnit == LengthUnit::metres) return std::nullopt;
    return metresPer(settings.meshUnit);
}

// The finite points of a mesh, thinned out to some thousand, in its own axes and unit.
std::vector<glm::dvec3> somePoints(const MeshScene& scene) {
    constexpr std::size_t about = 4096;
    std::size_t all = 0, next = 0;
    for (const MeshObject& object : scene)
        for (const MeshPiece& piece : object.pieces) all += piece.points.size();
    const std::size_t step = 1 + all / about;
    std::vector<glm::dvec3> points;
    for (const MeshObject& object : scene)
        for (const MeshPiece& piece : object.pieces)
            for (const glm::vec3 own : piece.points) {
                const glm::dvec3 point = piece.origin + glm::dvec3(own);
                if (next++ % step == 0 && std::isfinite(point.x + point.y + point.z)) points.push_back(point);
            }
    return points;
}

double middleOf(const std::vector<glm::dvec3>& points, int axis) {
    std::vector<double> values;
    for (const glm::dvec3& point : points) values.push_back(point[axis]);
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

// glTF has y up; other meshes that state none are judged by their numbers and
// their shape.
UpAxis decideUpAxis(const MeshScene& scene, const MeshFile& file, const ReadSettings& settings, bool onMap,
                    Warnings& warnings) {
    if (file.stated) return file.stated->yUp ? UpAxis::y : UpAxis::z;
    if (settings.upAxis != UpAxis::automatic) return settings.upAxis;
    const double metres = statedUnit(file, settings).value_or(1) * settings.meshScale;
    std::optional<UpAxisGuess> guess = onMap ? guessUpAxisOnMap(scene, metres) : std::nullopt;
    if (file.format == gltfFormat && (!guess || guess->axis == UpAxis::y)) return UpAxis::y;
    if (!guess) guess = guessUpAxis(scene, metres);
    const bool states = file.format == gltfFormat;
    warnings.push_back(
        {WarningKind::assumed,
         fmt::format("{}; {} was taken, since {} ({} states it)",
                     states ? "y should be up in glTF" : "the file does not state which axis is up",
                     guess->axis == UpAxis::z ? "z" : "y", guess->why, readOption("up")),
         file.name});
    return guess->axis;
}

// No town is as high as this, unless its unit is a smaller one than the metre.
void doubtUnit(const std::vector<glm::dvec3>& points, bool yUp, const MeshFile& file,
               const ReadSettings& settings, Warnings& warnings) {
    constexpr double doubtedM = 700;
    if (statedUnit(file, settings) || settings.meshScale != 1) return;
    const auto height = [&](const glm::dvec3& point) { return yUp ? point.y : point.z; };
    const auto [low, high] = std::ranges::minmax(points, {}, height);
    const double units = height(high) - height(low);
    if (units < doubtedM) return;
    std::vector<std::string> others;
    for (const LengthUnit unit :
         {LengthUnit::feet, LengthUnit::inches, LengthUnit::centimetres, LengthUnit::millimetres})
        if (const double heightM = units * metresPer(unit); heightM > 2 && heightM < doubtedM)
            others.push_back(fmt::format("{}: {:.1f} m", entryOf(unit).key, heightM));
    warnings.push_back(
        {WarningKind::assumed,
         fmt::format("the file states no unit; in metres the mesh is {:.0f} m high ({}; {} states it)", units,
                     fmt::join(others, ", "), readOption("mesh_unit")),
         file.name});
}

bool isNearOrigin(const std::vector<glm::dvec3>& points, double metresPerUnit) {
    double maxM = 0;
    for (const int axis : {0, 1, 2}) maxM = std::max(maxM, std::abs(middleOf(points, axis)) * metresPerUnit);
    return maxM < nearOriginM;
}

void warnOfRounding(const MeshScene& scene, double metresPerUnit, const MeshFile& file, Warnings& warnings) {
    constexpr double mattersM = 0.01;
    double rounding = 0;
    for (const MeshObject& object : scene)
        for (const MeshPiece& piece : object.pieces) rounding = std::max(rounding, piece.rounding);
    if (rounding * metresPerUnit < mattersM) return;
    warnings.push_back(
        {WarningKind::assumed,
         fmt::format("the file stores its points as float32, which rounds them to {:.2g} m so far from zero; "
                     "export it with an origin near the buildings, or with the offset in its node",
                     rounding * metresPerUnit),
         file.name});
}

}  // namespace

Result<MeshPlacement> MeshPlacement::of(const MeshScene& scene, const MeshFile& file,
                                        const ReadSettings& settings, Warnings& warnings) {
    MeshPlacement placement;
    const std::vector<glm::dvec3> points = somePoints(scene);
    const double metres = statedUnit(file, settings).value_or(1) * settings.meshScale;
    if (points.empty()) return failure("The file holds no triangles", file.path, trianglesAdvice);
    std::optional<CrsToLonLat> crs;
    if (settings.crs && !settings.meshAnchor) {
        auto system = CrsToLonLat::of(*settings.crs);
        if (!system) return failure(system.error().what, file.path, system.error().advice);
        system->removeZoneNumber();
        const auto unit = system->metresPerUnit();
        const bool isLocal = unit && isNearOrigin(points, statedUnit(file, settings).value_or(*unit));
        if (isLocal && !settings.frame)
            return failure("The mesh lies near its own origin, and not in map coordinates", file.path,
                           anchorAdvice());
        if (!isLocal) crs = *std::move(system);
    }
    placement.yUp_ = decideUpAxis(scene, file, settings, crs.has_value(), warnings) == UpAxis::y;
    placement.across_ = placement.up_ = metres;
    if (settings.frame) placement.frame_ = *settings.frame;
    if (crs) {
        placement.crs_ = std::make_shared<const CrsToLonLat>(*std::move(crs));
        if (const auto placed = placement.placeOnMap(scene, file, settings, warnings); !placed)
            return tl::make_unexpected(placed.error());
        return placement;
    }
    if (!settings.frame && !settings.meshAnchor)
        return failure("The mesh has no position", file.path, anchorAdvice());
    doubtUnit(points, placement.yUp_, file, settings, warnings);
    placement.placeAboutOrigin(settings);
    placement.zeroM_ = file.zeroM;
    return placement;
}

void MeshPlacement::placeAboutOrigin(const ReadSettings& settings) {
    if (!settings.frame) frame_ = Frame(*settings.meshAnchor);
    if (settings.meshAnchor) origin_ = frame_.localFromLonLat(*settings.meshAnchor);
    const double north = settings.meshNorthDeg * std::numbers::pi / 180;
    sin_ = std::sin(north);
    cos_ = std::cos(north);
}

// Feet of a map are those of its system, whichever feet a drawing names: 0.6 m in a million.
Result<void> MeshPlacement::placeOnMap(const MeshScene& scene, const MeshFile& file,
                                       const ReadSettings& settings, Warnings& warnings) {
    constexpr double sameUnit = 1e-5;
    const auto stated = statedUnit(file, settings);
    const auto unit = crs_->metresPerUnit();
    const double ratio = stated && unit ? *stated / *unit : 1;
    const bool isUnitOfMap = std::abs(ratio - 1) < sameUnit;
    across_ = isUnitOfMap ? 1 : ratio;
    std::optional<LonLat> middle = middleOnMap(scene);
    const bool takesUnitOfMap = !isUnitOfMap && !(middle && crs_->isPlausible(*middle));
    if (takesUnitOfMap) across_ = 1, middle = middleOnMap(scene);
    if (!middle || !crs_->isPlausible(*middle))
        return failure(fmt::format("The coordinates cannot belong to {}", crs_->name()), file.path,
                       fmt::format("Check which coordinate reference system ({}) and which unit ({}) they "
                                   "are in",
                                   readOption("crs"), readOption("mesh_unit")));
    const bool ownUnit = stated && !isUnitOfMap && !takesUnitOfMap;
    up_ = ownUnit ? *stated : crs_->metresPerElevationUnit();
    across_ *= settings.meshScale;
    up_ *= settings.meshScale;
    if (takesUnitOfMap)
        warnings.push_back(
            {WarningKind::assumed,
             fmt::format("the stated unit puts the mesh outside of {}; its own unit is taken", crs_->name()),
             file.name});
    else if (!stated)
        warnings.push_back(
            {WarningKind::assumed,
             fmt::format("the coordinates are taken in the unit of {}, {:.8g} m, heights in {:.8g} m",
                         crs_->name(), unit.value_or(0), up_),
             file.name});
    if (crs_->hasRemovedZoneNumber())
        warnings.push_back({WarningKind::assumed, std::string(zoneNumberRemoved), file.name});
    warnOfRounding(scene, unit ? across_ * *unit : 0, file, warnings);
    if (!settings.frame) frame_ = Frame(*middle);
    return {};
}

std::optional<LonLat> MeshPlacement::middleOnMap(const MeshScene& scene) const {
    std::vector<glm::dvec3> points;
    for (const glm::dvec3& point : somePoints(scene)) {
        const double north = yUp_ ? -point.z : point.y;
        points.emplace_back(point.x * across_, north * across_, 0);
    }
    const glm::dvec2 middle(middleOf(points, 0), middleOf(points, 1));
    const LonLat place = crs_->lonLat(std::vector{middle}).front();
    return std::isfinite(place.lonDeg + place.latDeg) ? std::optional(place) : std::nullopt;
}

glm::dvec3 MeshPlacement::turned(const MeshPiece& piece, glm::vec3 own) const {
    const glm::dvec3 point = piece.origin + glm::dvec3(own);
    return {point.x * across_, (yUp_ ? -point.z : point.y) * across_, (yUp_ ? point.y : point.z) * up_};
}

std::vector<glm::dvec3> MeshPlacement::local(const MeshPiece& piece) const {
    std::vector<glm::dvec3> points;
    points.reserve(piece.points.size());
    for (const glm::vec3 own : piece.points) points.push_back(turned(piece, own));
    if (!crs_) {
        // The mesh's north axis points along its azimuth (sin, cos), its east axis a right angle clockwise of
        // it.
        for (glm::dvec3& point : points)
            point = {origin_.x + point.x * cos_ + point.y * sin_, origin_.y - point.x * sin_ + point.y * cos_,
                     point.z + zeroM_};
        return points;
    }
    const std::vector<LonLat> places = crs_->lonLat(std::vector<glm::dvec2>(points.begin(), points.end()));
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i] = {frame_.localFromLonLat(places[i]), points[i].z};
    return points;
}

}  // namespace noonmark
