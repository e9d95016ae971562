#include <fmt/format.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "core/base/gdal_calls.h"
#include "core/describe/text.h"
#include "core/geo/crs.h"
#include "core/io/citygml/citygml_load.h"
#include "core/io/pieces/read_part.h"
#include "core/io/settings/read_settings.h"

namespace noonmark {

namespace {

struct SurveyName {
    std::string_view name;
    int epsg;
};

// Registry of the AdV, the German surveys: https://repository.gdi-de.org/schemas/adv/citygml
constexpr std::array surveyNames{
    SurveyName{"ETRS89_UTM31", 25831},  SurveyName{"ETRS89_UTM32", 25832},  SurveyName{"ETRS89_UTM33", 25833},
    SurveyName{"DE_DHDN_3GK2", 31466},  SurveyName{"DE_DHDN_3GK3", 31467},  SurveyName{"DE_DHDN_3GK4", 31468},
    SurveyName{"DE_DHDN_3GK5", 31469},  SurveyName{"ETRS89_Lat-Lon", 4258}, SurveyName{"DE_DHHN92_NH", 5783},
    SurveyName{"DE_DHHN2016_NH", 7837}, SurveyName{"DE_DHHN85_NOH", 5784}};

int findEpsg(std::string_view name) {
    const auto found = std::ranges::find(surveyNames, name, &SurveyName::name);
    return found == surveyNames.end() ? 0 : found->epsg;
}

bool isNamedByAuthority(const std::string& stated) {
    return stated.starts_with("urn:ogc") || stated.starts_with("urn:x-ogc") || stated.starts_with("http");
}

glm::dvec2 inOrder(glm::dvec3 corner, bool northFirst) {
    return northFirst ? glm::dvec2(corner.y, corner.x) : glm::dvec2(corner);
}

bool isIn(const CityGmlData::Envelope& envelope, glm::dvec2 at) {
    const glm::dvec2 low(envelope.low), high(envelope.high);
    const glm::dvec2 slack = 0.01 * (high - low) + 1e-6;
    return at.x >= low.x - slack.x && at.y >= low.y - slack.y && at.x <= high.x + slack.x &&
           at.y <= high.y + slack.y;
}

/// Finds out in which order the coordinates are written.
class AxisOrder {
public:
    AxisOrder(const CrsToLonLat& crs, const CityGmlData& data) : crs_(crs), data_(data) {}

    /// `expected`: whether north comes first.
    bool decide(bool expected) {
        const auto middle = middleCorner();
        if (!middle) return expected;
        const auto& envelope = data_.envelope;
        const bool turned =
            envelope && !isIn(*envelope, inOrder(*middle, false)) && isIn(*envelope, inOrder(*middle, true));
        if (!turned) return byPlace(*middle, expected);
        return !byPlace((envelope->low + envelope->high) / 2.0, expected);
    }
    [[nodiscard]] bool isAmbiguous() const { return isAmbiguous_; }

private:
    bool byPlace(glm::dvec3 at, bool expected) {
        const bool here = isPlausible(at, expected), there = isPlausible(at, !expected);
        isAmbiguous_ = here && there;
        return !here && there ? !expected : expected;
    }

    bool isPlausible(glm::dvec3 at, bool northFirst) const {
        const std::array points{inOrder(at, northFirst)};
        const LonLat place = crs_.lonLat(points).front();
        return std::isfinite(place.lonDeg) && crs_.isPlausible(place);
    }

    // The median of the objects' first corners.
    [[nodiscard]] std::optional<glm::dvec3> middleCorner() const {
        std::vector<double> x, y;
        for (const CityJsonBlock& block : data_.city.blocks)
            if (!block.vertices.empty()) {
                x.push_back(block.vertices.front().x);
                y.push_back(block.vertices.front().y);
            }
        if (x.empty()) return std::nullopt;
        const auto half = std::ptrdiff_t(x.size() / 2);
        for (auto* list : {&x, &y}) std::nth_element(list->begin(), list->begin() + half, list->end());
        return glm::dvec3(x[std::size_t(half)], y[std::size_t(half)], 0);
    }

    const CrsToLonLat& crs_;
    const CityGmlData& data_;
    bool isAmbiguous_ = false;
};

// Six times what the faces enclose, in the file's order of axes: negative where they look inward.
double signedVolume(const CityJsonBlock& block, const std::vector<Surface>& faces) {
    double volume = 0;
    if (faces.front().empty() || faces.front().front().empty()) return volume;
    const glm::dvec3 from = block.vertices[faces.front().front().front()];
    for (const Surface& face : faces)
        for (const std::vector<std::uint32_t>& ring : face)
            for (std::size_t i = 1; i + 1 < ring.size(); ++i)
                volume +=
                    glm::dot(block.vertices[ring[0]] - from,
                             glm::cross(block.vertices[ring[i]] - from, block.vertices[ring[i + 1]] - from));
    return volume;
}

// Whether nearly all buildings would be mirror images, whose faces look inward.
bool areMirrored(const CityGmlData& data, bool northFirst) {
    std::size_t inward = 0, outward = 0;
    for (const CityJsonBlock& block : data.city.blocks)
        for (const CityJsonObject& object : block.objects) {
            if (!object.body) continue;
            for (const CityJsonBody& body : object.body->bodies)
                if (!body.empty() && !body.front().empty())
                    ++((signedVolume(block, body.front()) < 0) == northFirst ? outward : inward);
        }
    return inward > 9 * outward;
}

void swapAxes(CityGmlData& data) {
    for (CityJsonBlock& block : data.city.blocks)
        for (glm::dvec3& vertex : block.vertices) std::swap(vertex.x, vertex.y);
    for (FileOpening& opening : data.openings)
        for (glm::dvec3& corner : opening.corners) std::swap(corner.x, corner.y);
}

// The system to use; the settings' if the file's is unknown.
Result<std::string> chooseReference(CityGmlData& data, const ReadSettings& settings,
                                    const std::string& file) {
    const std::string stated = translateReference(data.city.crs);
    if (stated.empty() && !settings.crs)
        return failure("The city has no coordinate reference system", file, crsAdvice());
    if (stated.empty()) return *settings.crs;
    const auto known = parseCrs(stated);
    if (known) return stated;
    if (!settings.crs) return failure(known.error().what, file, crsAdvice());
    data.city.warnings.push_back({WarningKind::assumed,
                                  "its reference system is unknown; the one of the settings is used",
                                  fmt::format("{} ({})", file, stated)});
    return *settings.crs;
}

}  // namespace

std::string translateReference(const std::string& stated) {
    constexpr std::string_view survey = "urn:adv:crs:";
    if (!stated.starts_with(survey)) return stated;
    const std::string_view names = std::string_view(stated).substr(survey.size());
    const std::size_t star = std::min(names.find('*'), names.size());
    const int map = findEpsg(names.substr(0, star));
    const int height = star < names.size() ? findEpsg(names.substr(star + 1)) : 0;
    if (map == 0) return stated;
    return height == 0 ? fmt::format("EPSG:{}", map) : fmt::format("EPSG:{}+{}", map, height);
}

bool isGeographicReference(const std::string& stated) {
    const GdalCalls gdal;
    const auto system = parseCrs(translateReference(stated));
    return system && system->IsGeographic() != 0;
}

GmlExtent::GmlExtent(const ReadSettings& settings, const std::string& stated)
    : box_(growBox(*settings.extent, aroundExtentM)) {
    const GdalCalls gdal;
    auto crs = CrsToLonLat::of(translateReference(stated));
    if (!crs && settings.crs) crs = CrsToLonLat::of(*settings.crs);
    if (!crs) return;
    crs->removeZoneNumber();
    crs_.emplace(*std::move(crs));
}

bool GmlExtent::mayTouch(const std::vector<glm::dvec3>& vertices) const {
    if (!crs_ || vertices.empty()) return true;
    glm::dvec3 low(1e300), high(-1e300);
    for (const glm::dvec3& vertex : vertices) low = glm::min(low, vertex), high = glm::max(high, vertex);
    const GdalCalls gdal;
    const std::array corners{inOrder(low, false), inOrder(high, false), inOrder(low, true),
                             inOrder(high, true)};
    const std::vector<LonLat> places = crs_->lonLat(corners);
    for (const std::size_t first : {0, 2}) {
        LonLatBox place = emptyLonLatBox;
        place.add(places[first]), place.add(places[first + 1]);
        if (place.touches(box_)) return true;
    }
    return false;
}

Result<void> settleReference(CityGmlData& data, const ReadSettings& settings,
                             const std::filesystem::path& path) {
    const GdalCalls gdal;
    const std::string file = path.filename().string();
    const bool byAuthority = isNamedByAuthority(data.city.crs);
    Result<std::string> text = chooseReference(data, settings, file);
    if (!text) return tl::make_unexpected(text.error());
    const auto system = parseCrs(*text);
    if (!system) return failure(system.error().what, file, system.error().advice);
    auto crs = CrsToLonLat::of(*text);
    if (!crs) return failure(crs.error().what, file, crs.error().advice);
    crs->removeZoneNumber();
    const bool northFirst = system->EPSGTreatsAsLatLong() != 0 || system->EPSGTreatsAsNorthingEasting() != 0;
    const bool expected = byAuthority && northFirst;
    AxisOrder order(*crs, data);
    bool found = order.decide(expected);
    const bool isMirrored = found == expected && order.isAmbiguous() && areMirrored(data, found);
    if (isMirrored) {
        found = !found;
        data.city.warnings.push_back(
            {WarningKind::repaired,
             NM_TEXT("the coordinates are taken in the other order than that of their reference system, in "
                     "which the buildings are mirror images"),
             fmt::format("{} ({})", file, crs->name())});
    } else if (found != expected && byAuthority)
        data.city.warnings.push_back({WarningKind::repaired,
                                      "the coordinates are not in the order of their reference system",
                                      fmt::format("{} ({})", file, crs->name())});
    if (order.isAmbiguous() && !isMirrored && !byAuthority && northFirst)
        data.city.warnings.push_back({WarningKind::assumed,
                                      NM_TEXT("the coordinates are read as longitude or easting first"),
                                      fmt::format("{} ({})", file, crs->name())});
    if (found) swapAxes(data);
    data.city.crs = *std::move(text);
    return {};
}

}  // namespace noonmark
