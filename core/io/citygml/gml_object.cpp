#include "core/io/citygml/gml_object.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <iterator>
#include <numbers>
#include <unordered_map>

#include "core/receivers/place_names.h"

namespace noonmark {

namespace {

using namespace std::string_view_literals;

template <std::size_t count>
bool isAmong(const std::array<std::string_view, count>& names, std::string_view name) {
    return std::ranges::find(names, name) != names.end();
}

constexpr std::array gmlBuildings{"Building"sv, "BuildingPart"sv, "BuildingInstallation"sv,
                                  "BuildingConstructiveElement"sv};
constexpr std::array gmlContainers{"ReliefFeature"sv, "CityObjectGroup"sv};
constexpr std::array gmlMembers{"cityObjectMember"sv, "featureMember"sv,   "featureMembers"sv,
                                "member"sv,           "reliefComponent"sv, "groupMember"sv};
// Openings stand in the holes of walls and roofs. Surfaces of rooms are not among them.
constexpr std::array gmlBoundaries{
    "WallSurface"sv,       "RoofSurface"sv, "GroundSurface"sv,  "Window"sv,        "OuterCeilingSurface"sv,
    "OuterFloorSurface"sv, "Door"sv,        "ClosureSurface"sv, "WindowSurface"sv, "DoorSurface"sv};
constexpr std::array gmlAsides{"address"sv,           "externalReference"sv,
                               "appearance"sv,        "appearanceMember"sv,
                               "interiorRoom"sv,      "interiorBuildingInstallation"sv,
                               "interiorFurniture"sv, "buildingRoom"sv,
                               "buildingFurniture"sv, "buildingSubdivision"sv,
                               "generalizesTo"sv,     "relatedTo"sv,
                               "dynamizer"sv,         "occupancy"sv,
                               "metaDataProperty"sv};

}  // namespace

GmlObjectKind findGmlObjectKind(std::string_view name) {
    if (isAmong(gmlBuildings, name)) return GmlObjectKind::building;
    if (name == "TINRelief") return GmlObjectKind::terrain;
    if (name == "SolitaryVegetationObject" || name == "PlantCover") return GmlObjectKind::plants;
    return isAmong(gmlContainers, name) ? GmlObjectKind::container : GmlObjectKind::other;
}

bool isGmlMember(std::string_view name) { return isAmong(gmlMembers, name); }
bool isGmlBoundary(std::string_view name) { return isAmong(gmlBoundaries, name); }
bool isGmlOpening(std::string_view name) { return name.starts_with("Window") || name.starts_with("Door"); }
bool isGmlAside(std::string_view name) { return isAmong(gmlAsides, name); }

std::optional<LodProperty> findLodProperty(std::string_view name) {
    using Shape = LodProperty::Shape;
    if (name == "tin") return LodProperty{1, Shape::body};
    if (!name.starts_with("lod") || name.size() < 5 || name[3] < '0' || name[3] > '4') return std::nullopt;
    const double lod = name[3] - '0';
    const std::string_view shape = name.substr(4);
    if (shape == "FootPrint") return LodProperty{lod, Shape::footprint};
    if (shape == "RoofEdge") return LodProperty{lod, Shape::roofEdge};
    constexpr std::array bodies{
        "Solid"sv, "MultiSolid"sv, "MultiSurface"sv, "Geometry"sv, "ImplicitRepresentation"sv, "Surface"sv};
    if (!isAmong(bodies, shape)) return std::nullopt;
    return LodProperty{lod, lod < 1 ? Shape::footprint : Shape::body};
}

namespace {

struct SameCorner {
    bool operator()(glm::dvec3 a, glm::dvec3 b) const { return a.x == b.x && a.y == b.y && a.z == b.z; }
};

struct HashCorner {
    std::size_t operator()(glm::dvec3 at) const {
        std::size_t hash = 0;
        for (const double number : {at.x, at.y, at.z})
            hash = (hash ^ std::bit_cast<std::size_t>(number + 0.0)) * 0x9E3779B97F4A7C15ULL;
        return hash ^ (hash >> 29U);
    }
};

/// Collects the used points of an object, each once, so that neighbouring surfaces share them.
class UsedPoints {
public:
    UsedPoints(const GmlGeometryReader& reader, bool areDegrees) : reader_(reader), areDegrees_(areDegrees) {}

    void adopt(Surface& surface) {
        for (auto& ring : surface)
            for (auto& index : ring) index = indexOf(index);
    }
    std::vector<glm::dvec3> take() { return std::move(points_); }

private:
    std::uint32_t indexOf(std::uint32_t raw) {
        const glm::dvec3 point = placeOf(raw);
        const auto [at, isNew] = index_.try_emplace(point, std::uint32_t(points_.size()));
        if (isNew) points_.push_back(point);
        return at->second;
    }

    [[nodiscard]] glm::dvec3 placeOf(std::uint32_t raw) const {
        const glm::dvec3 point = reader_.points()[raw];
        const auto& offsets = reader_.offsets();
        const auto after =
            std::ranges::upper_bound(offsets, std::size_t(raw), {}, &GmlGeometryReader::Offsets::first);
        if (after == offsets.begin() || raw >= std::prev(after)->end) return point;
        const glm::dvec3 at = std::prev(after)->at;
        return areDegrees_ ? at + toDegrees(point, at) : at + point;
    }

    // Systems in degrees have the latitude first.
    static glm::dvec3 toDegrees(glm::dvec3 offsetM, glm::dvec3 at) {
        constexpr double metresPerDegree = 111320;
        const double shrink = std::max(0.01, std::cos(at.x * std::numbers::pi / 180));
        return {offsetM.y / metresPerDegree, offsetM.x / (metresPerDegree * shrink), offsetM.z};
    }

    const GmlGeometryReader& reader_;
    bool areDegrees_;
    std::vector<glm::dvec3> points_;
    std::unordered_map<glm::dvec3, std::uint32_t, HashCorner, SameCorner> index_;
};

using Shape = LodProperty::Shape;
using Owner = GmlObject::Owner;

bool isBetter(const GmlObject::Lod& a, const GmlObject::Lod& b, const LodChoice& choice) {
    const LodRank first{a.property.lod, a.geometry.solid}, second{b.property.lod, b.geometry.solid};
    if (isBetter(first, second, choice)) return true;
    return !isBetter(second, first, choice) && a.owner < b.owner;
}

/// Chooses the geometries of the objects of a block.
class BlockMaker {
public:
    BlockMaker(const GmlGeometryReader& reader, const LodChoice& choice, bool areDegrees, std::string file,
               Warnings& warnings)
        : reader_(reader),
          choice_(choice),
          used_(reader, areDegrees),
          file_(std::move(file)),
          warnings_(warnings) {}

    CityJsonBlock make(std::vector<GmlObject>& objects) {
        for (GmlObject& object : objects) choose(object);
        leaveOutOtherLods(objects);
        CityJsonBlock block;
        for (GmlObject& object : objects) {
            for (auto* geometry : {&object.object.body, &object.object.footprint}) adopt(*geometry);
            block.objects.push_back(std::move(object.object));
        }
        block.vertices = used_.take();
        return block;
    }

private:
    void choose(GmlObject& object) {
        references_ = {};
        object.object.body = chooseBody(object);
        if (!object.object.body) object.object.footprint = chooseFootprint(object);
        warnOfReferences(object.object.id);
    }

    std::optional<CityJsonGeometry> chooseBody(GmlObject& object) {
        if (choice_.wished && *choice_.wished < 1) return std::nullopt;
        std::vector<GmlObject::Lod*> bodies;
        for (GmlObject::Lod& lod : object.lods)
            if (lod.property.shape == Shape::body && lod.owner != Owner::opening) bodies.push_back(&lod);
        std::ranges::stable_sort(bodies,
                                 [&](const auto* a, const auto* b) { return isBetter(*a, *b, choice_); });
        constexpr std::size_t mostTried = 8;
        bodies.resize(std::min(bodies.size(), mostTried));
        for (const GmlObject::Lod* lod : bodies)
            if (auto made = geometryOf(*lod); !made.bodies.empty()) {
                warnOfOtherLod(lod->property.lod, object.object.id);
                return made;
            }
        return std::nullopt;
    }

    // The outline on the ground before that of the roof.
    std::optional<CityJsonGeometry> chooseFootprint(const GmlObject& object) {
        for (const Shape shape : {Shape::footprint, Shape::roofEdge})
            for (const GmlObject::Lod& lod : object.lods) {
                if (lod.property.shape != shape || lod.owner != Owner::object) continue;
                CityJsonGeometry made = geometryOf(lod);
                made.isAtRoof = shape == Shape::roofEdge;
                if (!made.bodies.empty()) return made;
            }
        return std::nullopt;
    }

    CityJsonGeometry geometryOf(const GmlObject::Lod& lod) {
        CityJsonGeometry made{lod.property.lod, lod.geometry.solid, {}};
        for (const GmlBody& body : lod.geometry.bodies) {
            CityJsonBody shells;
            for (const GmlShell& shell : body) shells.push_back(reader_.surfacesOf(shell, references_));
            if (!shells.empty() && !shells.front().empty()) made.bodies.push_back(std::move(shells));
        }
        return made;
    }

    // A building may have a solid of its own beside finer ones of its parts, or the other way round.
    void leaveOutOtherLods(std::vector<GmlObject>& objects) const {
        auto& whole = objects.front().object;
        std::optional<LodRank> best;
        for (const GmlObject& part : objects)
            if (part.object.type == "BuildingPart" && part.object.body) {
                const LodRank rank{part.object.body->lod};
                if (!best || isBetter(rank, *best, choice_)) best = rank;
            }
        if (!best || !whole.body || whole.type != "Building" || best->lod == whole.body->lod) return;
        if (isBetter(*best, LodRank{whole.body->lod}, choice_)) return whole.body.reset();
        for (GmlObject& part : objects)
            if (part.object.type == "BuildingPart") part.object.body.reset();
    }

    void adopt(std::optional<CityJsonGeometry>& geometry) {
        if (!geometry) return;
        for (CityJsonBody& body : geometry->bodies)
            for (auto& shell : body)
                for (Surface& surface : shell) used_.adopt(surface);
    }

    void warn(WarningKind kind, std::string what, const std::string& id, std::size_t count) {
        if (count == 0) return;
        warnings_.push_back({kind, std::move(what), fmt::format("{}: {} ({})", file_, id, count)});
    }

    void warnOfReferences(const std::string& id) {
        warn(WarningKind::dropped, "surfaces that refer to ids that the object does not have", id,
             references_.missing);
        warn(WarningKind::leftOut, "surfaces that refer to other files, which are not opened", id,
             references_.foreign);
    }

    void warnOfOtherLod(double lod, const std::string& id) {
        if (choice_.wished && lod != *choice_.wished)
            warnings_.push_back({WarningKind::assumed,
                                 "the wanted level of detail is missing; the next one is used",
                                 fmt::format("{}: {} ({:g})", file_, id, lod)});
    }

    const GmlGeometryReader& reader_;
    const LodChoice& choice_;
    UsedPoints used_;
    GmlReferences references_;
    std::string file_;
    Warnings& warnings_;
};

std::optional<double> wholeNumber(std::string_view text) {
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool whole = error == std::errc() && end == text.data() + text.size() && std::isfinite(number);
    return whole ? std::optional(number) : std::nullopt;
}

// "urn:adv:uom:m", "#m", "ft"; nothing for units that are no length.
std::optional<LengthUnit> unitOf(std::string_view uom) {
    const std::size_t start = uom.find_last_of(":#/");
    const std::string_view unit = start == uom.npos ? uom : uom.substr(start + 1);
    if (unit == "m" || unit == "metre" || unit == "meter") return LengthUnit::metres;
    if (unit == "ft" || unit == "foot" || unit == "feet") return LengthUnit::feet;
    if (unit == "cm") return LengthUnit::centimetres;
    return unit == "mm" ? std::optional(LengthUnit::millimetres) : std::nullopt;
}

}  // namespace

void GmlObject::add(const LodProperty& property, Owner owner, GmlGeometry geometry) {
    if (geometry.bodies.empty()) return;
    const auto same = std::ranges::find_if(lods, [&](const Lod& lod) {
        return owner != Owner::object && lod.owner != Owner::object && lod.property.lod == property.lod;
    });
    if (same == lods.end()) return void(lods.push_back({property, owner, std::move(geometry)}));
    same->owner = std::min(same->owner, owner);
    GmlShell& all = same->geometry.bodies.front().front();
    for (const GmlBody& body : geometry.bodies)
        for (const GmlShell& shell : body) all.insert(all.end(), shell.begin(), shell.end());
}

void GmlObject::add(std::string name, std::string_view text, std::string_view unit) {
    constexpr std::size_t longest = 256, maximum = 200;
    const bool isThere = std::ranges::find(attributes, name, &ObjectAttribute::name) != attributes.end();
    if (isThere || text.size() > longest || attributes.size() >= maximum) return;
    attributes.push_back({std::move(name), std::string(text), wholeNumber(text), unitOf(unit)});
}

std::vector<FileOpening> findOpenings(const GmlObject& object, const GmlGeometryReader& reader) {
    double highest = 0;
    for (const GmlObject::Opening& opening : object.openings) highest = std::max(highest, opening.lod);
    std::vector<FileOpening> openings;
    std::array<std::size_t, 2> counts{};  // windows, doors
    GmlReferences references;
    for (const GmlObject::Opening& opening : object.openings) {
        if (opening.lod != highest) continue;
        for (const GmlBody& body : opening.geometry.bodies)
            for (const Surface& surface : reader.surfacesOf(body.front(), references)) {
                const std::size_t count = ++counts[opening.isWindow ? 0 : 1];
                const std::string numbered =
                    fmt::format("{} {} {}", object.object.id, opening.isWindow ? "window" : "door", count);
                FileOpening made{cleanName(opening.id.empty() ? numbered : opening.id), {}};
                for (const auto index : surface.front()) made.corners.push_back(reader.points()[index]);
                openings.push_back(std::move(made));
            }
    }
    return openings;
}

CityJsonBlock makeBlock(std::vector<GmlObject>& objects, const GmlGeometryReader& reader,
                        const LodChoice& choice, bool areDegrees, const std::string& file,
                        Warnings& warnings) {
    return BlockMaker(reader, choice, areDegrees, file, warnings).make(objects);
}

}  // namespace noonmark
