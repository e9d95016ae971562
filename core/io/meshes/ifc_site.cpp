#include "core/io/meshes/ifc_site.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <string_view>
#include <vector>

#include "core/geo/crs.h"
#include "core/io/meshes/stated_axes.h"
#include "core/io/settings/read_settings.h"

namespace noonmark {

namespace {

using Words = std::vector<std::string>;

constexpr std::size_t maxDirections = 100'000;
constexpr std::size_t longestStatement = 4096;  // of those that matter; the rest of a longer one is skipped

std::optional<double> numberOf(std::string_view text) {
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool good = error == std::errc() && end != text.data() && std::isfinite(number);
    return good ? std::optional(number) : std::nullopt;
}

std::vector<double> numbersOf(const std::string& list) {
    std::vector<double> numbers;
    for (const std::string& word : ifcArguments(list))
        if (const auto number = numberOf(word)) numbers.push_back(*number);
    return numbers;
}

// (degrees, minutes, seconds, millionths of a second), all of one sign.
std::optional<double> degreesOf(const std::string& list) {
    const std::vector<double> parts = numbersOf(list);
    if (parts.size() < 3) return std::nullopt;
    const double seconds = parts[2] + (parts.size() > 3 ? parts[3] / 1e6 : 0);
    return parts[0] + parts[1] / 60 + seconds / 3600;
}

// Collects the statements that matter, which may come in any order.
class SiteReader {
public:
    void take(std::string_view statement) {
        const std::string plain = withoutIfcBlanks(statement);
        const auto equals = plain.find('=');
        if (equals == plain.npos) return;
        const std::string id = plain.substr(0, equals), body = plain.substr(equals + 1);
        const Words words = ifcArguments(body);
        if (body.starts_with("IFCSITE(")) takeSite(words);
        constexpr std::size_t maxName = 24, maxNumbers = 200;  // of statements, of three numbers
        const bool isShort = id.size() <= maxName && words.front().size() <= maxNumbers;
        if (body.starts_with("IFCDIRECTION(") && isShort && directions_.size() < maxDirections)
            directions_.emplace(id, words.front());
        if (body.starts_with("IFCGEOMETRICREPRESENTATIONCONTEXT(") && words.size() > 5 && north_.empty())
            north_ = words[5].starts_with('#') ? words[5] : "";
        if (body.starts_with("IFCPROJECTEDCRS(")) crs_ = words.front();
        if (body.starts_with("IFCMAPCONVERSION(") && words.size() > 3) takeConversion(words);
        unit_.take(id, body, words);
    }

    IfcSite site() {
        if (const auto north = directions_.find(north_); north != directions_.end()) {
            const std::vector<double> axes = numbersOf(north->second);
            const double degrees =
                axes.size() < 2 ? 0 : std::atan2(axes[0], axes[1]) * 180 / std::numbers::pi;
            if (std::abs(degrees) > 0.01) site_.trueNorthDeg = degrees;
        }
        const double metres = unit_.metres();
        if (site_.elevationM) *site_.elevationM *= metres;
        if (site_.mapHeightM) *site_.mapHeightM *= metres;
        std::erase(crs_, '\'');
        site_.mapCrs = crs_;
        if (!origin_.empty()) site_.mapConversion = crs_.empty() ? origin_ : crs_ + " " + origin_;
        return site_;
    }

private:
    // In any unit; what no place on earth has is left out.
    static std::optional<double> heightOf(const std::string& text) {
        constexpr double maxHeight = 1e8;
        const auto height = numberOf(text);
        return height && std::abs(*height) <= maxHeight ? height : std::nullopt;
    }
    void takeConversion(const Words& words) {
        origin_ = words[2] + ", " + words[3];
        const auto east = numberOf(words[2]), north = numberOf(words[3]);
        if (east && north) site_.mapOrigin = glm::dvec2(*east, *north);
        if (words.size() > 4) site_.mapHeightM = heightOf(words[4]);
        if (words.size() < 7) return;
        const auto x = numberOf(words[5]), y = numberOf(words[6]);
        if (x && y && std::hypot(*x, *y) > 1e-9) site_.mapAxis = {*x, *y};
    }
    void takeSite(const Words& words) {
        if (words.size() < 12) return;
        const auto latitude = degreesOf(words[9]), longitude = degreesOf(words[10]);
        if (latitude && longitude) site_.place = LonLat{*longitude, *latitude};
        site_.elevationM = heightOf(words[11]);
    }

    IfcSite site_;
    IfcLengthUnit unit_;
    std::map<std::string, std::string> directions_;
    std::string north_, crs_, origin_;
};

}  // namespace

IfcSite readIfcSite(const std::filesystem::path& file, const std::stop_token& stop) {
    std::filebuf bytes;
    SiteReader reader;
    if (bytes.open(file, std::ios::in | std::ios::binary) == nullptr) return reader.site();
    for (std::string statement;
         takeIfcStatement(bytes, statement, longestStatement) && !stop.stop_requested();)
        reader.take(statement);
    return reader.site();
}

namespace {

// The azimuth of a direction on the map from true north, at a place of it.
double azimuthOnMap(const CrsToLonLat& crs, glm::dvec2 at, glm::dvec2 direction) {
    constexpr double step = 100;
    const auto places =
        crs.lonLat(std::vector{at, at + step * direction / std::hypot(direction.x, direction.y)});
    const glm::dvec2 along = Frame(places[0]).localFromLonLat(places[1]);
    return std::atan2(along.x, along.y) * 180 / std::numbers::pi;
}

std::optional<IfcPlace> findPlaceOnMap(const IfcSite& site) {
    if (!site.mapOrigin || site.mapCrs.empty()) return std::nullopt;
    const auto crs = CrsToLonLat::of(site.mapCrs);
    if (!crs) return std::nullopt;
    for (const double scale : {1.0, 0.001}) {  // in the unit of the map, or in the model's millimetres
        const glm::dvec2 at = *site.mapOrigin * scale;
        const LonLat place = crs->lonLat(std::vector{at}).front();
        if (!std::isfinite(place.lonDeg + place.latDeg) || !crs->isPlausible(place)) continue;
        const glm::dvec2 north(-site.mapAxis.y, site.mapAxis.x);
        return IfcPlace{place, azimuthOnMap(*crs, at, north), "IfcMapConversion, " + crs->name(),
                        site.mapHeightM.value_or(0)};
    }
    return std::nullopt;
}

}  // namespace

std::optional<IfcPlace> findPlace(const IfcSite& site) {
    if (auto onMap = findPlaceOnMap(site)) return onMap;
    if (!site.place || (site.place->lonDeg == 0 && site.place->latDeg == 0)) return std::nullopt;
    if (std::abs(site.place->lonDeg) > 180 || std::abs(site.place->latDeg) > 90) return std::nullopt;
    return IfcPlace{*site.place, -site.trueNorthDeg.value_or(0), "IfcSite", site.elevationM.value_or(0)};
}

std::string describe(const IfcSite& site) {
    Words words;
    if (site.place)
        words.push_back(fmt::format("its place ({} {:.6f},{:.6f})", readOption("mesh_anchor"),
                                    site.place->lonDeg, site.place->latDeg));
    if (site.place && site.elevationM && *site.elevationM != 0)
        words.push_back(fmt::format("its elevation, {:g} m", *site.elevationM));
    if (site.trueNorthDeg)
        words.push_back(fmt::format("true north {:.4g} deg clockwise of its y axis ({} {:.4g})",
                                    *site.trueNorthDeg, readOption("mesh_north_deg"), -*site.trueNorthDeg));
    if (!site.mapConversion.empty()) words.push_back("its place on a map, " + site.mapConversion);
    return fmt::format("{}", fmt::join(words, "; "));
}

}  // namespace noonmark
