#include "core/io/elements/read_glazing.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/geo/crs.h"
#include "core/geo/frame.h"
#include "core/geo/lon_lat.h"
#include "core/io/citygml/citygml_load.h"
#include "core/io/cityjson/cityjson_load.h"
#include "core/io/files/json_nesting.h"
#include "core/io/files/plain_file.h"
#include "core/io/settings/read_settings.h"
#include "core/receivers/place_names.h"

namespace noonmark {

namespace {

constexpr const char* openingAdvice =
    "Give CityGML or CityJSON of level of detail 3, whose surfaces are marked as Window, or windows as "
    "points "
    "or polygons with heights";

// Whether an opening is too far away is told by its first corner.
void addOpenings(const std::vector<FileOpening>& openings, const CrsToLonLat& crs, const City& city,
                 const GlazingFileSettings& settings, GlazingRead& read) {
    std::vector<glm::dvec2> flat;
    for (const FileOpening& opening : openings)
        for (const glm::dvec3 corner : opening.corners) flat.emplace_back(corner);
    const std::vector<LonLat> places = crs.lonLat(flat);
    std::size_t next = 0;
    for (const FileOpening& opening : openings) {
        const LonLat first = places[next];
        GlazingShape window{.id = opening.id};
        for (const glm::dvec3 corner : opening.corners) {
            const glm::dvec2 local = city.frame.localFromLonLat(places[next++]);
            window.corners.emplace_back(local, corner.z * crs.metresPerElevationUnit() -
                                                   city.frame.originElevationM() -
                                                   (city.terrain ? earthDropM(local) : 0));
        }
        if (std::isfinite(first.lonDeg) && std::isfinite(first.latDeg) &&
            computeGreatCircleM(first, city.frame.origin()) <= settings.farAwayM)
            read.windows.push_back(std::move(window));
        else
            read.warnings.push_back(
                {WarningKind::leftOut, "the window is too far from the city", opening.id});
    }
}

/// Adds the openings of a city model to `read`, in the frame of the city; those too far away give a warning.
/// `crs`: of the file; empty: that of the settings. `file`: for messages. Error: there are none or too many,
/// no reference system is known, or all are too far away.
Result<void> placeOpenings(const std::vector<FileOpening>& openings, const std::string& crs,
                           const std::string& file, const GlazingFileSettings& settings, const City& city,
                           GlazingRead& read) {
    if (openings.empty())
        return failure("No surface of the city is marked as a window or a door", file, openingAdvice);
    if (openings.size() > GlazingFileSettings::maxWindows)
        return limitReached(fmt::format("It holds more than {} windows", GlazingFileSettings::maxWindows),
                            file, "Divide the file");
    const std::string stated = crs.empty() ? settings.crs.value_or("") : crs;
    if (stated.empty()) return failure("The city has no coordinate reference system", file, crsAdvice());
    const auto system = CrsToLonLat::of(stated);
    if (!system) return failure(system.error().what, file, system.error().advice);
    addOpenings(openings, *system, city, settings, read);
    if (!read.windows.empty()) return {};
    return failure("All windows are too far from the city", file,
                   "Check the coordinate reference system of both files");
}

}  // namespace

Result<GlazingRead> readCityGmlGlazing(const std::filesystem::path& file, const GlazingFileSettings& settings,
                                       const City& city, Progress& progress, const std::stop_token& stop) {
    ReadSettings reading;
    reading.crs = settings.crs;
    auto data = loadCityGml(file, reading, progress, stop, GmlContent::openings);
    if (!data) return tl::make_unexpected(data.error());
    if (auto settled = settleReference(*data, reading, file); !settled)
        return tl::make_unexpected(settled.error());
    GlazingRead read{.features = data->city.features};
    if (auto placed =
            placeOpenings(data->openings, data->city.crs, file.filename().string(), settings, city, read);
        !placed)
        return tl::make_unexpected(placed.error());
    return read;
}

namespace {

constexpr const char* surfaceAdvice = "Give CityJSON whose first value is of type CityJSON";

double numberOrNan(const nlohmann::json& value) {
    return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

glm::dvec3 tripleOr(const nlohmann::json& value, glm::dvec3 otherwise) {
    if (!value.is_array() || value.size() < 3) return otherwise;
    return {numberOrNan(value[0]), numberOrNan(value[1]), numberOrNan(value[2])};
}

/// How many lists lie around the surfaces of a geometry; -1 for other types.
int depthOf(const std::string& type) {
    if (type == "MultiSurface" || type == "CompositeSurface") return 0;
    if (type == "Solid") return 1;
    return type == "MultiSolid" || type == "CompositeSolid" ? 2 : -1;
}

/// Collects the openings of a file.
class OpeningFinder {
public:
    OpeningFinder(std::string file, GlazingRead& read) : file_(std::move(file)), read_(read) {}

    void readHeader(const nlohmann::json& root) {
        const nlohmann::json& transform = memberIn(root, "transform");
        scale_ = tripleOr(memberIn(transform, "scale"), glm::dvec3(1));
        translate_ = tripleOr(memberIn(transform, "translate"), glm::dvec3(0));
        crs_ = textIn(memberIn(memberIn(root, "metadata"), "referenceSystem"));
    }

    void addObjects(const nlohmann::json& root) {
        const nlohmann::json& objects = memberIn(root, "CityObjects");
        if (!objects.is_object()) return;
        vertices_ = &memberIn(root, "vertices");
        for (const auto& [id, object] : objects.items()) addObject(id, object);
    }

    [[nodiscard]] const std::string& crs() const { return crs_; }
    [[nodiscard]] const std::vector<FileOpening>& openings() const { return openings_; }

private:
    void addObject(const std::string& id, const nlohmann::json& object) {
        ++read_.features;
        const nlohmann::json& geometries = memberIn(object, "geometry");
        if (!geometries.is_array()) return;
        std::vector<const nlohmann::json*> sorted;
        for (const nlohmann::json& geometry : geometries) sorted.push_back(&geometry);
        std::ranges::stable_sort(
            sorted, [](const nlohmann::json* a, const nlohmann::json* b) { return lodIn(*a) > lodIn(*b); });
        counts_ = {};
        for (const nlohmann::json* geometry : sorted) {
            const std::size_t before = openings_.size();
            addGeometry(id, *geometry);
            if (openings_.size() > before) return;
        }
    }

    void addGeometry(const std::string& id, const nlohmann::json& geometry) {
        const nlohmann::json& semantics = memberIn(geometry, "semantics");
        const int depth = depthOf(textIn(memberIn(geometry, "type")));
        if (depth < 0 || !semantics.is_object()) return;
        surfaces_ = &memberIn(semantics, "surfaces");
        addLists(id, memberIn(geometry, "boundaries"), memberIn(semantics, "values"), depth);
    }

    void addLists(const std::string& id, const nlohmann::json& boundaries, const nlohmann::json& values,
                  int depth) {
        if (!boundaries.is_array() || !values.is_array()) return;
        for (std::size_t i = 0; i < std::min(boundaries.size(), values.size()); ++i) {
            if (depth > 0)
                addLists(id, boundaries[i], values[i], depth - 1);
            else
                addSurface(id, boundaries[i], values[i]);
        }
    }

    void addSurface(const std::string& id, const nlohmann::json& surface, const nlohmann::json& value) {
        if (!value.is_number_unsigned() || !surfaces_->is_array() ||
            value.get<std::size_t>() >= surfaces_->size())
            return;
        const nlohmann::json& semantic = (*surfaces_)[value.get<std::size_t>()];
        const std::string type = textIn(memberIn(semantic, "type"));
        if (type != "Window" && type != "Door") return;
        FileOpening opening{idOf(id, semantic, type == "Window"), {}};
        if (!surface.is_array() || surface.empty() || !addCorners(surface[0], opening.corners)) {
            read_.warnings.push_back(
                {WarningKind::dropped, "the window's surface has no usable corners", opening.id});
            return;
        }
        openings_.push_back(std::move(opening));
    }

    std::string idOf(const std::string& object, const nlohmann::json& semantic, bool isWindow) {
        std::size_t& count = counts_[isWindow ? 0 : 1];
        ++count;
        for (const char* key : {"id", "name"})
            if (std::string id = cleanName(textIn(memberIn(semantic, key))); !id.empty()) return id;
        return fmt::format("{} {} {}", cleanName(object), isWindow ? "window" : "door", count);
    }

    bool addCorners(const nlohmann::json& ring, std::vector<glm::dvec3>& corners) const {
        if (!ring.is_array() || ring.size() < 3 || !vertices_->is_array()) return false;
        for (const nlohmann::json& index : ring) {
            if (!index.is_number_unsigned() || index.get<std::size_t>() >= vertices_->size()) return false;
            const glm::dvec3 vertex = tripleOr((*vertices_)[index.get<std::size_t>()],
                                               glm::dvec3(std::numeric_limits<double>::quiet_NaN())) *
                                          scale_ +
                                      translate_;
            if (!std::isfinite(vertex.x + vertex.y + vertex.z)) return false;
            corners.push_back(vertex);
        }
        return true;
    }

    std::string file_, crs_;
    GlazingRead& read_;
    glm::dvec3 scale_{1}, translate_{0};
    const nlohmann::json* vertices_ = nullptr;
    const nlohmann::json* surfaces_ = nullptr;
    std::array<std::size_t, 2> counts_{};  // of an object: windows, doors
    std::vector<FileOpening> openings_;
};

/// The file's objects: one, or one a line of a sequence.
Result<void> parseInto(OpeningFinder& finder, const std::filesystem::path& file,
                       const std::stop_token& stop) {
    if (const auto plain = checkPlainFile(file); !plain) return tl::make_unexpected(plain.error());
    StoppableStream stream(file, stop);
    if (!stream.opened()) return failure("The file cannot be read", file.string());
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (stop.stop_requested()) return cancelled();
    if (!JsonNesting().take(text))
        return limitReached(fmt::format("Its values are nested more than {} deep", JsonNesting::maxLevels),
                            file.string());
    bool isFirst = true;
    for (std::size_t at = 0; at < text.size();) {
        if (stop.stop_requested()) return cancelled();
        nlohmann::json root =
            nlohmann::json::parse(text.begin() + std::ptrdiff_t(at), text.end(), nullptr, false);
        std::size_t end = text.size();
        if (root.is_discarded()) {
            end = std::min(text.size(), text.find('\n', at));
            root = nlohmann::json::parse(text.begin() + std::ptrdiff_t(at),
                                         text.begin() + std::ptrdiff_t(end), nullptr, false);
        }
        if (isFirst && textIn(memberIn(root, "type")) != "CityJSON")
            return failure("This is not CityJSON", file.filename().string(), surfaceAdvice);
        if (isFirst) finder.readHeader(root);
        isFirst = false;
        finder.addObjects(root);
        at = end + 1;
    }
    return {};
}

}  // namespace

Result<GlazingRead> readCityJsonGlazing(const std::filesystem::path& file,
                                        const GlazingFileSettings& settings, const City& city,
                                        const std::stop_token& stop) {
    const std::string name = file.filename().string();
    GlazingRead read;
    OpeningFinder finder(name, read);
    if (auto parsed = parseInto(finder, file, stop); !parsed) return tl::make_unexpected(parsed.error());
    if (auto placed = placeOpenings(finder.openings(), finder.crs(), name, settings, city, read); !placed)
        return tl::make_unexpected(placed.error());
    return read;
}

}  // namespace noonmark
