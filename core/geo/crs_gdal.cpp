#include "core/geo/crs.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <regex>

#include "core/base/gdal_calls.h"
#include "core/base/stop_scope.h"

namespace noonmark {

namespace {

constexpr std::size_t maxCharacters = 65536;
constexpr const char* codeAdvice = "State it as EPSG:number";

std::string folded(std::string_view text) {
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return lower;
}

// Shortens every spelling of EPSG's codes to EPSG:number; other text is unchanged.
std::string shortName(const std::string& crs) {
    constexpr std::size_t longest = 200;  // regular expressions recurse for every character
    static const std::regex code(
        R"(^\s*(?:urn:(?:x-)?ogc:def:crs:EPSG:[^:]*:|https?://(?:www\.)?opengis\.net/def/crs/EPSG/[^/]*/|\+init=epsg:)(\d+)/?\s*$)",
        std::regex::icase);
    std::smatch match;
    const bool found = crs.size() <= longest && std::regex_match(crs, match, code);
    return found ? "EPSG:" + match[1].str() : crs;
}

// Parameters of PROJ whose values are names of files.
constexpr std::array fileParameters{"init",    "grids", "nadgrids", "geoidgrids", "xy_grids",
                                    "z_grids", "file",  "model",    "catalog"};

bool isWordLetter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// Values in PROJ text, wherever it stands in a definition: "+nadgrids=a,b".
void addParameterFiles(std::string_view text, std::vector<std::string>& files) {
    const std::string lower = folded(text);
    for (const std::string_view key : fileParameters)
        for (std::size_t at = lower.find(key); at != lower.npos; at = lower.find(key, at + 1)) {
            const std::size_t sign = lower.find_first_not_of(" \t\r\n", at + key.size());
            if ((at > 0 && isWordLetter(lower[at - 1])) || sign == lower.npos || lower[sign] != '=') continue;
            const std::size_t from = std::min(lower.size(), lower.find_first_not_of(" \t\r\n", sign + 1));
            const std::size_t to = std::min(lower.size(), lower.find_first_of(" \t\r\n;\"]", from));
            files.emplace_back(text.substr(from, to - from));
        }
}

// The second text of PARAMETERFILE["name","file"].
void addWktFiles(std::string_view text, std::vector<std::string>& files) {
    constexpr std::string_view key = "PARAMETERFILE[";
    for (std::size_t at = text.find(key); at != text.npos; at = text.find(key, at + 1)) {
        std::array<std::size_t, 4> quotes{};
        std::size_t next = at;
        for (std::size_t& quote : quotes) next = quote = std::min(text.size(), text.find('"', next + 1));
        files.emplace_back(text.substr(std::min(text.size(), quotes[2] + 1), quotes[3] - quotes[2] - 1));
    }
}

// Whether PROJ has every grid of a list; "@" stands before those that it may do without, "null" is no file.
bool hasGrids(std::string_view list) {
    for (;;) {
        const std::size_t comma = std::min(list.size(), list.find(','));
        std::string_view name = list.substr(0, comma);
        if (name.starts_with('@')) name.remove_prefix(1);
        if (name != "null" && !isProjFile(std::string(name))) return false;
        if (comma == list.size()) return true;
        list.remove_prefix(comma + 1);
    }
}

std::string shortened(const std::string& text) {
    constexpr std::size_t maximum = 80;
    return text.size() <= maximum ? text : fmt::format("{}...", std::string_view(text).substr(0, maximum));
}

tl::unexpected<Error> unknownCrs(const std::string& text) {
    return failure(fmt::format("\"{}\" is not a known coordinate reference system", shortened(text)), {},
                   codeAdvice);
}

}  // namespace

Result<void> checkNamesNoFile(std::string_view definition) {
    std::vector<std::string> files;
    addParameterFiles(definition, files);
    addWktFiles(definition, files);
    const auto foreign = std::ranges::find_if_not(files, hasGrids);
    if (foreign == files.end()) return {};
    return failure(
        fmt::format("The coordinate reference system names the file \"{}\", which is none of PROJ's "
                    "grids and is not opened",
                    shortened(*foreign)),
        {}, codeAdvice);
}

std::string wktOf(const OGRSpatialReference* system) {
    if (system == nullptr || system->IsEmpty()) return {};
    char* text = nullptr;
    const char* const options[] = {"FORMAT=WKT2_2019", nullptr};
    system->exportToWkt(&text, options);
    std::string wkt = text != nullptr ? text : "";
    CPLFree(text);
    return wkt;
}

Result<OGRSpatialReference> parseCrs(const std::string& text) {
    if (text.size() > maxCharacters)
        return failure("The definition of the coordinate reference system has more than 65,536 characters",
                       {}, codeAdvice);
    const std::string name = shortName(text);
    if (auto harmless = checkNamesNoFile(name); !harmless) return tl::make_unexpected(harmless.error());
    const char* const options[] = {"ALLOW_NETWORK_ACCESS=NO", "ALLOW_FILE_ACCESS=NO", nullptr};
    OGRSpatialReference system;
    if (system.SetFromUserInput(name.c_str(), options) != OGRERR_NONE) return unknownCrs(text);
    if (auto harmless = checkNamesNoFile(wktOf(&system)); !harmless)
        return tl::make_unexpected(harmless.error());
    if (system.IsGeographic() == 0 && system.IsProjected() == 0) return unknownCrs(text);
    system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return system;
}

namespace {
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
}  // namespace

struct CrsToLonLat::Parts {
    // Returns a transformation to GDAL's cache, for the next layer in the same system: GDAL looks
    // transformations up in a database, which takes longer than everything else about a small file.
    struct HandBack {
        void operator()(OGRCoordinateTransformation* used) const {
            OGRCoordinateTransformation::DestroyCT(used);
        }
    };

    static constexpr double metresPerZone = 1e6;

    OGRSpatialReference system;
    std::unique_ptr<OGRCoordinateTransformation, HandBack> toLonLat;
    double metresPerElevationUnit = 1;
    bool elevationUnitIsStated = false;
    double west = -180, south = -90, east = 180, north = 90;  // area of use
    double zoneM = 0;  // what the number of its zone before an easting adds to it; 0: no UTM system
    bool takesZoneOff = false;
    std::size_t zonesTakenOff = 0;

    void learnArea() {
        double w = 0, s = 0, e = 0, n = 0;
        if (!system.GetAreaOfUse(&w, &s, &e, &n, nullptr) || w <= -1000) return;
        west = w, south = s, east = e, north = n;
    }
    // Eastings of the zone end below 1,200 km, also where a country stretches it: no zone from 2 on has such
    // eastings of its own.
    [[nodiscard]] double removeZoneNumber(double easting) {
        if (!takesZoneOff || zoneM == 0 || easting < zoneM || easting >= zoneM + metresPerZone)
            return easting;
        ++zonesTakenOff;
        return easting - zoneM;
    }
    void addPlaces(std::span<const glm::dvec2> points, std::vector<LonLat>& places) {
        std::vector<double> x, y;
        for (const glm::dvec2 point : points) {
            x.push_back(removeZoneNumber(point.x));
            y.push_back(point.y);
        }
        std::vector<int> worked(points.size(), 0);
        toLonLat->Transform(int(points.size()), x.data(), y.data(), nullptr, nullptr, worked.data());
        for (std::size_t i = 0; i < points.size(); ++i) {
            const bool usable = worked[i] != 0 && std::abs(x[i]) <= 360 && std::abs(y[i]) <= 90;
            places.push_back(usable ? LonLat{std::remainder(x[i], 360.0), y[i]} : LonLat{nan, nan});
        }
    }
    void learnElevationUnit() {
        elevationUnitIsStated = system.IsVertical() != 0 || system.GetAxesCount() == 3;
        if (system.IsVertical() != 0)
            metresPerElevationUnit = system.GetTargetLinearUnits("COMPD_CS|VERT_CS");
        else if (system.IsProjected() != 0)
            metresPerElevationUnit = system.GetLinearUnits();
    }
};

CrsToLonLat::CrsToLonLat(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
CrsToLonLat::CrsToLonLat(CrsToLonLat&&) noexcept = default;
CrsToLonLat& CrsToLonLat::operator=(CrsToLonLat&&) noexcept = default;
CrsToLonLat::~CrsToLonLat() = default;

Result<CrsToLonLat> CrsToLonLat::of(const std::string& crs) {
    const GdalCalls gdal;
    auto definition = parseCrs(crs);
    if (!definition) return tl::make_unexpected(definition.error());
    auto parts = std::make_unique<Parts>();
    parts->system = *std::move(definition);
    parts->learnArea();
    parts->learnElevationUnit();
    OGRSpatialReference horizontal(parts->system);
    horizontal.DemoteTo2D(nullptr);
    if (horizontal.IsCompound() != 0) horizontal.StripVertical();
    int isNorth = 0;
    parts->zoneM = horizontal.GetUTMZone(&isNorth) * Parts::metresPerZone;
    OGRSpatialReference wgs84;
    wgs84.SetWellKnownGeogCS("WGS84");
    for (OGRSpatialReference* system : {&horizontal, &wgs84})
        system->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    parts->toLonLat.reset(OGRCreateCoordinateTransformation(&horizontal, &wgs84));
    if (!parts->toLonLat)
        return failure(
            "There is no transformation from this coordinate reference system to longitude and "
            "latitude",
            parts->system.GetName() != nullptr ? parts->system.GetName() : "", "State another system");
    return CrsToLonLat(std::move(parts));
}

std::vector<LonLat> CrsToLonLat::lonLat(std::span<const glm::dvec2> points) const {
    constexpr std::size_t atOnce = 1U << 16U;  // some 0.1 s
    const GdalCalls gdal;
    std::vector<LonLat> places;
    places.reserve(points.size());
    for (std::size_t first = 0; first < points.size() && !StopScope::isStopped(); first += atOnce)
        parts_->addPlaces(points.subspan(first, std::min(atOnce, points.size() - first)), places);
    places.resize(points.size(), LonLat{nan, nan});
    return places;
}

bool CrsToLonLat::isPlausible(LonLat place) const {
    constexpr double slackDeg = 5;
    if (!(place.latDeg >= parts_->south - slackDeg && place.latDeg <= parts_->north + slackDeg)) return false;
    const double width =
        parts_->east >= parts_->west ? parts_->east - parts_->west : parts_->east - parts_->west + 360;
    const double eastward = std::fmod(place.lonDeg - (parts_->west - slackDeg) + 720, 360.0);
    return width + 2 * slackDeg >= 360 || eastward <= width + 2 * slackDeg;
}

void CrsToLonLat::removeZoneNumber() { parts_->takesZoneOff = true; }
bool CrsToLonLat::hasRemovedZoneNumber() const { return parts_->zonesTakenOff > 0; }
double CrsToLonLat::metresPerElevationUnit() const { return parts_->metresPerElevationUnit; }
bool CrsToLonLat::elevationUnitIsStated() const { return parts_->elevationUnitIsStated; }
std::optional<double> CrsToLonLat::metresPerUnit() const {
    if (parts_->system.IsProjected() == 0) return std::nullopt;
    return parts_->system.GetLinearUnits();
}
std::string CrsToLonLat::name() const {
    return parts_->system.GetName() != nullptr ? parts_->system.GetName() : "";
}

}  // namespace noonmark
