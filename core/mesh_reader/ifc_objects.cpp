#include "core/mesh_reader/ifc_objects.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "core/io/meshes/stated_axes.h"

namespace noonmark {

namespace {

// The name between the class and the id of 22 letters, "FZK-Haus" of
// "IfcBuilding_FZK-Haus_2hQBAVPOr5VxhS3Jl0O47h"; all of it if there is none. Ids may hold underscores.
std::string plainName(const std::string& name) {
    constexpr std::size_t idLength = 22;
    const auto first = name.find('_');
    if (first == name.npos) return name;
    const bool hasId = name.size() > idLength && name[name.size() - idLength - 1] == '_';
    const auto last = hasId ? name.size() - idLength - 1 : name.rfind('_');
    return last <= first + 1 ? name : name.substr(first + 1, last - first - 1);
}

}  // namespace

bool isIfc(const std::string& file) {
    std::string head(4096, '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.read(head.data(), std::streamsize(head.size()));
    return beginsIfc(head);
}

std::string_view IfcObjects::classOf(std::string_view name) {
    if (!name.starts_with("Ifc")) return {};
    return name.substr(0, std::min(name.find('_'), name.size()));
}

bool IfcObjects::isLeftOut(std::string_view className) {
    constexpr std::array<std::string_view, 17> others{"IfcSite",
                                                      "IfcGeographicElement",
                                                      "IfcFurnishingElement",
                                                      "IfcFurniture",
                                                      "IfcVehicle",
                                                      "IfcPlant",
                                                      "IfcVirtualElement",
                                                      "IfcSpace",
                                                      "IfcAnnotation",
                                                      "IfcGrid",
                                                      "IfcOpeningElement",
                                                      "IfcZone",
                                                      "IfcSpatialZone",
                                                      "IfcSign",
                                                      "IfcProxy",
                                                      "IfcCivilElement",
                                                      "IfcSystemFurnitureElement"};
    return std::ranges::find(others, className) != others.end();
}

void IfcLocation::enter(const std::string& node, double elevationM) {
    const std::string_view className = IfcObjects::classOf(node);
    if (className == "IfcBuilding") {
        building = node, buildingM = elevationM;
        storey.clear();
    }
    if (className == "IfcBuildingStorey") storey = node, storeyM = elevationM;
    if (!className.empty() && className != "IfcMappedItem") element = node;
}

void IfcObjects::add(MeshObject object, const IfcLocation& within) {
    if (classOf(object.name) == "IfcMappedItem") object.name = within.element;
    const std::string_view className = classOf(object.name);
    if (isLeftOut(className)) {
        if (lastLeftOut_ != object.name) ++leftOut_[std::string(className)];
        lastLeftOut_ = object.name;
        return;
    }
    if (within.building.empty()) {
        outside_.push_back(std::move(object));
        return;
    }
    addOpening(object, within);
    MeshObject& whole = buildings_[within.building];
    whole.name = plainName(within.building);
    whole.kind = MeshObject::Kind::building;
    std::ranges::move(object.pieces, std::back_inserter(whole.pieces));
}

void IfcObjects::addOpening(const MeshObject& object, const IfcLocation& within) {
    const double storeyM = within.storeyM - within.buildingM;
    if (!within.storey.empty()) {
        auto& storeys = storeys_[within.building];
        if (std::ranges::find(storeys, storeyM) == storeys.end()) storeys.push_back(storeyM);
    }
    const std::string_view className = classOf(object.name);
    const bool isWindow = className.starts_with("IfcWindow"), isDoor = className.starts_with("IfcDoor");
    if (!isWindow && !isDoor) return;
    Opening& opening = openings_[object.name];
    opening.building = within.building;
    opening.storeyM = storeyM;
    opening.object.name = plainName(object.name);
    opening.object.parent = plainName(within.building);
    opening.object.kind = isWindow ? MeshObject::Kind::window : MeshObject::Kind::door;
    std::ranges::copy(object.pieces, std::back_inserter(opening.object.pieces));
}

// Storeys are counted from the one whose elevation is nearest to that of the building.
void IfcObjects::addOpeningsTo(std::vector<MeshObject>& objects) {
    const auto nearZero = [](double a, double b) { return std::abs(a) < std::abs(b); };
    for (auto& [name, storeys] : storeys_) std::ranges::sort(storeys);
    for (auto& [name, opening] : openings_) {
        if (const auto found = storeys_.find(opening.building); found != storeys_.end()) {
            const auto& storeys = found->second;
            const auto own = std::ranges::find(storeys, opening.storeyM);
            if (own != storeys.end())
                opening.object.floor = std::int32_t(own - std::ranges::min_element(storeys, nearZero));
        }
        objects.push_back(std::move(opening.object));
    }
}

std::vector<MeshObject> IfcObjects::take() {
    std::vector<MeshObject> objects;
    for (auto& [name, building] : buildings_) objects.push_back(std::move(building));
    for (MeshObject& object : outside_) {
        if (buildings_.empty())
            objects.push_back(std::move(object));
        else
            ++leftOut_[std::string(classOf(object.name))];
    }
    addOpeningsTo(objects);
    std::string note;
    for (const auto& [name, count] : leftOut_)
        note += fmt::format("{}{} ({})", note.empty() ? "" : ", ", name.empty() ? "others" : name, count);
    if (!note.empty()) objects.push_back({.name = {}, .pieces = {}, .note = note});
    return objects;
}

namespace {

using Words = std::vector<std::string>;
using Id = std::uint64_t;

constexpr std::size_t maxFaces = 20'000'000;

// "#12=IFCSITE('a',$)" in its parts.
struct IfcStatement {
    Id id = 0;
    std::string name;  // "IFCSITE"
    Words arguments;
};

std::optional<Id> idOf(std::string_view word) {
    if (!word.starts_with('#')) return std::nullopt;
    Id id = 0;
    const auto [end, error] = std::from_chars(word.data() + 1, word.data() + word.size(), id);
    if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return id;
}

std::optional<IfcStatement> parseStatement(const std::string& text) {
    const std::string plain = withoutIfcBlanks(text);
    const auto equals = plain.find('='), opens = plain.find('(');
    if (equals == plain.npos || opens == plain.npos || opens < equals) return std::nullopt;
    const auto id = idOf(std::string_view(plain).substr(0, equals));
    if (!id) return std::nullopt;
    std::string name = plain.substr(equals + 1, opens - equals - 1);
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return char(std::toupper(c)); });
    return IfcStatement{*id, std::move(name), ifcArguments(std::string_view(plain).substr(equals + 1))};
}

std::string textOf(const IfcStatement& statement) {
    std::string text = fmt::format("#{}={}(", statement.id, statement.name);
    for (std::size_t i = 0; i < statement.arguments.size(); ++i)
        text += (i == 0 ? "" : ",") + statement.arguments[i];
    return text + ");\n";
}

// Numbers of "(1,2,3)", counted from 1.
std::vector<std::size_t> indicesOf(const std::string& list) {
    std::vector<std::size_t> indices;
    for (const std::string& word : ifcArguments(list)) {
        std::size_t index = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
        if (error == std::errc()) indices.push_back(index);
    }
    return indices;
}

std::optional<glm::dvec3> pointOf(const std::string& list) {
    glm::dvec3 point(0);
    glm::length_t axis = 0;
    for (const std::string& word : ifcArguments(list)) {
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), point[axis]);
        if (error != std::errc() || !std::isfinite(point[axis]) || ++axis == 3) break;
    }
    return axis >= 2 ? std::optional(point) : std::nullopt;
}

// The points of the arc from `a` by `b` to `c` without its ends, at most 10 degrees apart: "(1.,2.)" with as
// many numbers as they have. Only `b` where the three lie on a line.
std::vector<std::string> arcThrough(const std::string& a, const std::string& b, const std::string& c) {
    constexpr double maxRad = std::numbers::pi / 18;
    const auto start = pointOf(a), middle = pointOf(b), end = pointOf(c);
    if (!start || !middle || !end) return {b};
    const glm::dvec3 u = *middle - *start, v = *end - *start, normal = glm::cross(u, v);
    const double square = glm::dot(normal, normal);
    if (square <= 1e-18 * glm::dot(u, u) * glm::dot(v, v)) return {b};
    const glm::dvec3 centre =
        *start +
        (glm::dot(u, u) * glm::cross(v, normal) + glm::dot(v, v) * glm::cross(normal, u)) / (2 * square);
    const glm::dvec3 x = *start - centre, y = glm::cross(glm::normalize(normal), x);
    double angle = std::atan2(glm::dot(*end - centre, y), glm::dot(*end - centre, x));
    if (angle <= 0) angle += 2 * std::numbers::pi;
    const int steps = int(std::ceil(angle / maxRad));
    const bool isFlat = ifcArguments(a).size() < 3;
    std::vector<std::string> points;
    for (int i = 1; i < steps; ++i) {
        const glm::dvec3 at = centre + std::cos(angle * i / steps) * x + std::sin(angle * i / steps) * y;
        points.push_back(isFlat ? fmt::format("({:.12e},{:.12e})", at.x, at.y)
                                : fmt::format("({:.12e},{:.12e},{:.12e})", at.x, at.y, at.z));
    }
    return points;
}

/// What the second reading needs of the first.
struct IfcLists {
    bool isIfc4 = false;
    Id last = 0;                                  // the highest id
    std::map<Id, Words> points;                   // of lists of points: "(0.,1.,2.)"
    std::map<Id, std::vector<std::size_t>> face;  // outer loops of IfcIndexedPolygonalFace
};

template <class Use>
void forEachStatement(const std::filesystem::path& file, Use use) {
    std::filebuf bytes;
    if (bytes.open(file, std::ios::in | std::ios::binary) == nullptr) return;
    for (std::string text; takeIfcStatement(bytes, text, std::numeric_limits<std::size_t>::max());)
        if (!use(text)) return;
}

IfcLists collectLists(const std::filesystem::path& file) {
    IfcLists lists;
    forEachStatement(file, [&](const std::string& text) {
        if (text.find("FILE_SCHEMA") != text.npos) {
            lists.isIfc4 = text.find("IFC4") != text.npos;
            return lists.isIfc4;
        }
        const auto statement = parseStatement(text);
        if (!statement) return true;
        lists.last = std::max(lists.last, statement->id);
        if (statement->name.starts_with("IFCCARTESIANPOINTLIST"))
            lists.points[statement->id] = ifcArguments(statement->arguments.front());
        if (statement->name.starts_with("IFCINDEXEDPOLYGONALFACE"))
            lists.face[statement->id] = indicesOf(statement->arguments.front());
        return true;
    });
    return lists;
}

class IfcRewriter {
public:
    explicit IfcRewriter(IfcLists lists) : lists_(std::move(lists)), next_(lists_.last + 1) {}

    // False where there are too many faces.
    bool add(const std::string& text) {
        const auto statement = parseStatement(text);
        if (!statement)
            out_.append(text).append(";\n");
        else if (statement->name == "IFCTRIANGULATEDFACESET")
            addFaces(*statement, facesOfTriangles(*statement));
        else if (statement->name == "IFCPOLYGONALFACESET")
            addFaces(*statement, facesOfPolygons(*statement));
        else if (statement->name == "IFCINDEXEDPOLYCURVE")
            addCurve(*statement);
        else
            out_ += textOf(completed(*statement));
        return faces_ <= maxFaces;
    }
    std::string take() { return std::move(out_); }

private:
    using Loops = std::vector<std::vector<std::size_t>>;

    [[nodiscard]] static Loops facesOfTriangles(const IfcStatement& set) {
        Loops loops;
        if (set.arguments.size() > 3)
            for (const std::string& triangle : ifcArguments(set.arguments[3]))
                loops.push_back(indicesOf(triangle));
        return loops;
    }
    [[nodiscard]] Loops facesOfPolygons(const IfcStatement& set) const {
        Loops loops;
        if (set.arguments.size() < 3) return loops;
        for (const std::string& reference : ifcArguments(set.arguments[2])) {
            const auto id = idOf(reference);
            const auto found = id ? lists_.face.find(*id) : lists_.face.end();
            if (found != lists_.face.end()) loops.push_back(found->second);
        }
        return loops;
    }
    // The points of a list as statements of their own, or null.
    const std::vector<Id>* addPoints(const std::string& reference) {
        const auto id = idOf(reference);
        const auto list = id ? lists_.points.find(*id) : lists_.points.end();
        if (list == lists_.points.end()) return nullptr;
        std::vector<Id>& ids = pointIds_[*id];
        if (ids.empty())
            for (const std::string& point : list->second) ids.push_back(addNew("IFCCARTESIANPOINT", point));
        return &ids;
    }
    Id addNew(std::string_view name, std::string_view arguments) {
        fmt::format_to(std::back_inserter(out_), "#{}={}({});\n", next_, name, arguments);
        return next_++;
    }
    static std::string referencesTo(const std::vector<Id>& points, const std::vector<std::size_t>& indices) {
        std::string list;
        for (const std::size_t index : indices)
            if (index >= 1 && index <= points.size())
                fmt::format_to(std::back_inserter(list), "{}#{}", list.empty() ? "" : ",", points[index - 1]);
        return "(" + list + ")";
    }
    void addFaces(const IfcStatement& set, const Loops& loops) {
        const std::vector<Id>* points = addPoints(set.arguments.front());
        std::string faces;
        for (const auto& loop : loops) {
            if (points == nullptr || loop.size() < 3 || ++faces_ > maxFaces) continue;
            const Id ring = addNew("IFCPOLYLOOP", referencesTo(*points, loop));
            const Id bound = addNew("IFCFACEOUTERBOUND", fmt::format("#{},.T.", ring));
            const Id face = addNew("IFCFACE", fmt::format("(#{})", bound));
            fmt::format_to(std::back_inserter(faces), "{}#{}", faces.empty() ? "" : ",", face);
        }
        const Id shell = addNew("IFCCLOSEDSHELL", "(" + faces + ")");
        out_ += fmt::format("#{}=IFCFACETEDBREP(#{});\n", set.id, shell);
    }
    void addCurve(const IfcStatement& curve) {
        const std::vector<Id>* points = addPoints(curve.arguments.front());
        std::vector<Id> path;
        const bool hasSegments = curve.arguments.size() > 1 && curve.arguments[1].starts_with('(');
        if (points != nullptr && hasSegments)
            for (const std::string& segment : ifcArguments(curve.arguments[1]))
                addSegment(segment, *idOf(curve.arguments.front()), *points, path);
        if (points != nullptr && !hasSegments) path = *points;
        std::string list;
        for (const Id point : path)
            fmt::format_to(std::back_inserter(list), "{}#{}", list.empty() ? "" : ",", point);
        out_ += fmt::format("#{}=IFCPOLYLINE(({}));\n", curve.id, list);
    }

    // IFCLINEINDEX((1,2,3)) or IFCARCINDEX((1,2,3)), whose middle point is on the arc.
    void addSegment(const std::string& segment, Id list, const std::vector<Id>& points,
                    std::vector<Id>& path) {
        std::vector<std::size_t> indices = indicesOf(ifcArguments(segment).front());
        std::erase_if(indices, [&](std::size_t index) { return index < 1 || index > points.size(); });
        const auto add = [&](Id point) {
            if (path.empty() || path.back() != point) path.push_back(point);
        };
        if (!segment.starts_with("IFCARCINDEX") || indices.size() != 3) {
            for (const std::size_t index : indices) add(points[index - 1]);
            return;
        }
        add(points[indices[0] - 1]);
        const Words& all = lists_.points.at(list);
        for (const std::string& point :
             arcThrough(all[indices[0] - 1], all[indices[1] - 1], all[indices[2] - 1]))
            add(addNew("IFCCARTESIANPOINT", point));
        add(points[indices[2] - 1]);
    }

    // Whether it begins with a global id, and not with a name of 22 letters, as properties may.
    static bool isRooted(const IfcStatement& statement) {
        constexpr std::size_t lengthOfGuid = 24;  // with its quotes
        constexpr std::array<std::string_view, 4> named{"IFCPROPERTY", "IFCQUANTITY", "IFCMATERIAL",
                                                        "IFCCOMPLEXPROPERTY"};
        if (statement.arguments.size() < 4 || statement.arguments[0].size() != lengthOfGuid) return false;
        if (statement.name == "IFCPROPERTYSET") return true;
        const auto isNamed = [&](std::string_view begin) { return statement.name.starts_with(begin); };
        return statement.arguments[0][0] == '\'' && std::ranges::none_of(named, isNamed);
    }

    // What 2x3 asks for, and IFC4 does not.
    static IfcStatement completed(IfcStatement statement) {
        struct Needed {
            std::string_view name;
            std::size_t argument;
            std::string_view value;
        };
        constexpr std::array needed{
            Needed{"IFCSITE", 8, ".ELEMENT."},           Needed{"IFCBUILDING", 8, ".ELEMENT."},
            Needed{"IFCBUILDINGSTOREY", 8, ".ELEMENT."}, Needed{"IFCSPACE", 8, ".ELEMENT."},
            Needed{"IFCSPACE", 9, ".INTERNAL."},         Needed{"IFCSTAIR", 8, ".NOTDEFINED."},
            Needed{"IFCRAMP", 8, ".NOTDEFINED."},        Needed{"IFCROOF", 8, ".NOTDEFINED."}};
        Words& words = statement.arguments;
        for (const Needed& one : needed)
            if (statement.name == one.name && words.size() > one.argument && words[one.argument] == "$")
                words[one.argument] = one.value;
        if (isRooted(statement) && words[1] == "$")
            words[1] = fmt::format("#{}", statement.id);  // never looked at
        return statement;
    }

    IfcLists lists_;
    Id next_;
    std::map<Id, std::vector<Id>> pointIds_;
    std::size_t faces_ = 0;
    std::string out_;
};

}  // namespace

std::string ifcAs2x3(const std::filesystem::path& file) {
    IfcLists lists = collectLists(file);
    if (!lists.isIfc4) return {};
    IfcRewriter rewriter(std::move(lists));
    bool isWhole = true;
    forEachStatement(file, [&](const std::string& text) { return isWhole = rewriter.add(text); });
    return isWhole ? rewriter.take() : std::string();
}

}  // namespace noonmark
