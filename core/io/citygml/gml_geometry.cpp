#include "core/io/citygml/gml_object.h"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/matrix.hpp>
#include <iterator>

namespace noonmark {

namespace {

bool isBetween(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == ','; }

}  // namespace

bool readGmlNumbers(std::string_view text, std::vector<double>& numbers) {
    numbers.clear();
    const char* at = text.data();
    const char* const end = at + text.size();
    while (true) {
        while (at != end && isBetween(*at)) ++at;
        if (at == end) return true;
        if (*at == '+') ++at;
        double number = 0;
        const auto [after, error] = std::from_chars(at, end, number);
        if (error != std::errc() || !std::isfinite(number)) return false;
        numbers.push_back(number);
        at = after;
        if (at != end && !isBetween(*at)) return false;
    }
}

glm::dmat4 readGmlMatrix(std::string_view text) {
    std::vector<double> numbers;
    glm::dmat4 matrix(1);
    if (!readGmlNumbers(text, numbers) || numbers.size() != 16) return matrix;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            matrix[column][row] = numbers[std::size_t(4 * row + column)];
    return matrix;
}

namespace {

bool isPolygon(std::string_view name) {
    return name == "Polygon" || name == "PolygonPatch" || name == "Triangle" || name == "Rectangle";
}

bool isRing(std::string_view name) { return name == "LinearRing" || name == "Ring"; }

bool isPosition(std::string_view name) { return name == "posList" || name == "pos" || name == "coordinates"; }

bool isSame(glm::dvec3 a, glm::dvec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

void flip(Surface& surface) {
    for (auto& ring : surface) std::ranges::reverse(ring);
}

}  // namespace

void GmlGeometryReader::open(const XmlElement& property) {
    geometry_ = {};
    loose_.clear();
    open_.clear();
    constexpr int defaultDimension = 3;
    open_.push_back({"", members_.size(), defaultDimension, false});
    solidDepth_ = polygonDepth_ = ringDepth_ = shellDepth_ = implicitDepth_ = 0;
    wantsText_ = false;
    if (const auto target = property.attribute("href"); !target.empty()) addReference(target, false);
}

Result<void> GmlGeometryReader::begin(const XmlElement& element) {
    Open next{std::string(element.attribute("id")), members_.size(), open_.back().dimension,
              open_.back().flipped};
    if (const auto stated = element.attribute("srsDimension"); !stated.empty())
        std::from_chars(stated.data(), stated.data() + stated.size(), next.dimension);
    if (element.name == "OrientableSurface" && element.attribute("orientation") == "-")
        next.flipped = !next.flipped;
    open_.push_back(std::move(next));
    beginPart(element.name);
    const std::string_view target = element.attribute("href");
    if (implicitDepth_ > 0 && element.name == "relativeGMLGeometry") {
        implicit_.isReference = !target.empty();
        implicit_.templateId = target;
    } else if (!target.empty() && polygonDepth_ == 0) {
        addReference(target, element.name == "solidMember");
    }
    if (points_.size() > maxPoints)
        return limitReached(fmt::format("An object has more than {} corners", maxPoints), {},
                            "Divide the file");
    return {};
}

// Notes where the parts of a geometry begin, by their depth.
void GmlGeometryReader::beginPart(std::string_view name) {
    const std::size_t depth = open_.size();
    const bool inPolygon = polygonDepth_ > 0;
    if (inPolygon && ringDepth_ == 0 && isRing(name)) {
        ringDepth_ = depth;
        ring_.clear();
        ringIsBroken_ = false;
    } else if (!inPolygon && isPolygon(name)) {
        polygonDepth_ = depth;
        surface_.clear();
    } else if (!inPolygon && solidDepth_ == 0 && name == "Solid") {
        solidDepth_ = depth;
        geometry_.solid = true;
        geometry_.bodies.emplace_back();
    } else if (!inPolygon && solidDepth_ > 0 && shellDepth_ == 0 &&
               (name == "exterior" || name == "interior")) {
        shellDepth_ = depth;
        shellFirst_ = members_.size();
    } else if (implicitDepth_ == 0 && name == "ImplicitGeometry") {
        implicitDepth_ = depth;
        implicit_ = {points_.size(), members_.size(), {}, false, false, glm::dmat4(1), glm::dvec3(0)};
    } else if (implicitDepth_ > 0 && name == "referencePoint") {
        implicit_.inReference = true;
    }
    wantsText_ = (ringDepth_ > 0 && isPosition(name)) ||
                 (implicitDepth_ > 0 && (name == "transformationMatrix" || name == "libraryObject" ||
                                         (implicit_.inReference && isPosition(name))));
}

Result<void> GmlGeometryReader::end(std::string_view name, std::string_view text) {
    const std::size_t depth = open_.size();
    const Open open = std::move(open_.back());
    open_.pop_back();
    if (ringDepth_ > 0 && isPosition(name)) {
        addCorners(text, open.dimension);
    } else if (implicitDepth_ > 0 && name == "transformationMatrix") {
        implicit_.matrix = readGmlMatrix(text);
    } else if (implicitDepth_ > 0 && name == "libraryObject") {
        ++foreignShapes;
    } else if (implicitDepth_ > 0 && implicit_.inReference && isPosition(name)) {
        readGmlNumbers(text, numbers_);
        if (numbers_.size() >= 3) implicit_.at = {numbers_[0], numbers_[1], numbers_[2]};
    } else if (implicitDepth_ > 0 && name == "referencePoint") {
        implicit_.inReference = false;
    }
    if (depth == ringDepth_) ringDepth_ = 0, finishRing();
    if (depth == polygonDepth_) polygonDepth_ = 0, finishPolygon();
    if (depth == shellDepth_) {
        shellDepth_ = 0;
        geometry_.bodies.back().push_back({{shellFirst_, members_.size()}});
    }
    if (depth == solidDepth_) solidDepth_ = 0;
    if (depth == implicitDepth_) implicitDepth_ = 0, finishImplicit();
    if (!open.id.empty() && members_.size() > open.first && polygonDepth_ == 0) {
        ids_.try_emplace(open.id, GmlRange{open.first, members_.size()});
        if (implicitDepth_ > 0 && !implicit_.isReference) implicit_.templateId = open.id;
    }
    wantsText_ = false;
    return {};
}

GmlGeometry GmlGeometryReader::close() {
    if (!loose_.empty()) geometry_.bodies.push_back({std::move(loose_)});
    std::erase_if(geometry_.bodies, [](const GmlBody& body) { return body.empty(); });
    loose_.clear();
    return std::move(geometry_);
}

void GmlGeometryReader::clear() {
    points_.clear();
    offsets_.clear();
    polygons_.clear();
    references_.clear();
    members_.clear();
    ids_.clear();
    flatOutlines = brokenRings = foreignShapes = 0;
}

void GmlGeometryReader::addReference(std::string_view target, bool ofSolid) {
    references_.emplace_back(target);
    const std::size_t at = members_.size();
    const Member member{std::uint32_t(references_.size() - 1), true, open_.back().flipped};
    if (!ofSolid) return addMember(member);
    members_.push_back(member);
    geometry_.solid = true;
    geometry_.bodies.push_back({{{at, at + 1}}});
}

void GmlGeometryReader::addMember(Member member) {
    const std::size_t at = members_.size();
    members_.push_back(member);
    if (solidDepth_ > 0 && shellDepth_ > 0) return;
    if (!loose_.empty() && loose_.back().end == at)
        ++loose_.back().end;
    else
        loose_.push_back({at, at + 1});
}

void GmlGeometryReader::addCorners(std::string_view text, int dimension) {
    ringIsBroken_ = !readGmlNumbers(text, numbers_) || ringIsBroken_;
    const std::size_t step = dimension == 2 ? 2 : 3;
    if (step == 2) ++flatOutlines;
    ringIsBroken_ = ringIsBroken_ || numbers_.size() % step != 0;
    for (std::size_t i = 0; i + step <= numbers_.size(); i += step) {
        const glm::dvec3 corner{numbers_[i], numbers_[i + 1], step == 3 ? numbers_[i + 2] : 0};
        if (!ring_.empty() && isSame(points_[ring_.back()], corner)) continue;
        ring_.push_back(std::uint32_t(points_.size()));
        points_.push_back(corner);
    }
}

void GmlGeometryReader::finishRing() {
    if (ring_.size() > 1 && isSame(points_[ring_.front()], points_[ring_.back()])) ring_.pop_back();
    const bool usable = ring_.size() >= 3 && !ringIsBroken_;
    if (!usable) ++brokenRings;
    // A hole that is broken leaves the polygon whole; a broken outline ends it.
    if (usable)
        surface_.push_back(std::move(ring_));
    else if (surface_.empty())
        surface_.emplace_back();
    ring_.clear();
}

void GmlGeometryReader::finishPolygon() {
    if (surface_.empty() || surface_.front().empty()) return;
    polygons_.push_back(std::move(surface_));
    surface_.clear();
    addMember({std::uint32_t(polygons_.size() - 1), false, open_.back().flipped});
}

void GmlGeometryReader::finishImplicit() {
    const std::string id = std::move(implicit_.templateId);
    if (implicit_.isReference) {
        useTemplate(id.starts_with('#') ? id.substr(1) : id);
    } else if (!id.empty()) {
        GmlTemplate made{{points_.begin() + std::ptrdiff_t(implicit_.firstPoint), points_.end()}, {}};
        GmlReferences ignored;
        made.surfaces = surfacesOf({{implicit_.firstMember, members_.size()}}, ignored);
        for (Surface& surface : made.surfaces)
            for (auto& ring : surface)
                for (auto& index : ring) index -= std::uint32_t(implicit_.firstPoint);
        templates_.try_emplace(id, std::move(made));
    }
    for (std::size_t i = implicit_.firstPoint; i < points_.size(); ++i)
        points_[i] = glm::dvec3(implicit_.matrix * glm::dvec4(points_[i], 1));
    offsets_.push_back({implicit_.firstPoint, points_.size(), implicit_.at});
}

void GmlGeometryReader::useTemplate(const std::string& id) {
    const auto found = templates_.find(id);
    if (found == templates_.end()) return addReference("#" + id, false);
    const GmlRange copied = copyPolygons(found->second);
    for (std::size_t i = copied.first; i < copied.end; ++i) addMember({std::uint32_t(i), false, false});
}

// Returns the range in polygons_.
GmlRange GmlGeometryReader::copyPolygons(const GmlTemplate& from) {
    const auto firstPoint = std::uint32_t(points_.size());
    const std::size_t first = polygons_.size();
    points_.insert(points_.end(), from.points.begin(), from.points.end());
    for (Surface surface : from.surfaces) {
        for (auto& ring : surface)
            for (auto& index : ring) index += firstPoint;
        polygons_.push_back(std::move(surface));
    }
    return {first, polygons_.size()};
}

std::vector<std::string> GmlGeometryReader::unresolved() const {
    std::vector<std::string> ids;
    for (const std::string& target : references_)
        if (target.starts_with('#') && !ids_.contains(target.substr(1))) ids.push_back(target.substr(1));
    return ids;
}

void GmlGeometryReader::share(const std::unordered_set<std::string>& ids, GmlShared& shared) const {
    for (const auto& [id, range] : ids_) {
        if (!ids.contains(id) || shared.contains(id)) continue;
        GmlTemplate made;
        GmlReferences ignored;
        made.surfaces = surfacesOf({range}, ignored);
        for (Surface& surface : made.surfaces)
            for (auto& ring : surface)
                for (auto& index : ring) {
                    made.points.push_back(points_[index]);
                    index = std::uint32_t(made.points.size() - 1);
                }
        shared.emplace(id, std::move(made));
    }
}

void GmlGeometryReader::adopt(const GmlShared& shared) {
    for (const std::string& id : unresolved()) {
        const auto found = shared.find(id);
        if (found == shared.end() || ids_.contains(id)) continue;
        const GmlRange copied = copyPolygons(found->second);
        const std::size_t first = members_.size();
        for (std::size_t i = copied.first; i < copied.end; ++i)
            members_.push_back({std::uint32_t(i), false, false});
        ids_.emplace(id, GmlRange{first, members_.size()});
    }
}

std::vector<Surface> GmlGeometryReader::surfacesOf(const GmlShell& shell, GmlReferences& references) const {
    std::vector<Surface> surfaces;
    for (const GmlRange& range : shell) expand(range, false, 0, surfaces, references);
    return surfaces;
}

// References may lead in circles, or to twice as many at each step: no object needs more than a few steps for
// each of its polygons.
void GmlGeometryReader::expand(const GmlRange& range, bool flipped, int depth, std::vector<Surface>& surfaces,
                               GmlReferences& references) const {
    constexpr int deepest = 8;
    const std::size_t maxSteps = 8 * members_.size() + 64;
    for (std::size_t i = range.first; i < range.end; ++i) {
        if (++references.steps > maxSteps) return void(++references.missing);
        const Member& member = members_[i];
        const bool turned = member.flipped != flipped;
        if (!member.isReference) {
            surfaces.push_back(polygons_[member.index]);
            if (turned) flip(surfaces.back());
            continue;
        }
        const std::string& target = references_[member.index];
        const auto found = target.starts_with('#') ? ids_.find(target.substr(1)) : ids_.end();
        if (found != ids_.end() && depth < deepest)
            expand(found->second, turned, depth + 1, surfaces, references);
        else
            ++(target.starts_with('#') ? references.missing : references.foreign);
    }
}

}  // namespace noonmark
