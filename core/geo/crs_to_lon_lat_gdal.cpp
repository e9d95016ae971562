#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <cmath>
#include <limits>
#include <regex>

#include "core/base/gdal_calls.h"
#include "core/geo/crs_to_lon_lat.h"

namespace noonmark {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Shortens every spelling of OGC's names of EPSG systems to EPSG:number; other text is unchanged.
std::string shortName(const std::string& crs) {
    static const std::regex ogc(
        R"(^\s*(?:urn:(?:x-)?ogc:def:crs:EPSG:[^:]*:|https?://(?:www\.)?opengis\.net/def/crs/EPSG/[^/]*/)(\d+)/?\s*$)",
        std::regex::icase);
    std::smatch match;
    return std::regex_match(crs, match, ogc) ? "EPSG:" + match[1].str() : crs;
}

bool understand(OGRSpatialReference& system, const std::string& crs) {
    const char* const options[] = {"ALLOW_NETWORK_ACCESS=NO", "ALLOW_FILE_ACCESS=NO", nullptr};
    if (system.SetFromUserInput(shortName(crs).c_str(), options) != OGRERR_NONE) return false;
    system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return system.IsGeographic() != 0 || system.IsProjected() != 0;
}

}  // namespace

struct CrsToLonLat::Parts {
    // Returns a transformation to GDAL's cache, for the next layer in the same system: GDAL looks
    // transformations up in a database, which takes longer than everything else about a small file.
    struct HandBack {
        void operator()(OGRCoordinateTransformation* used) const {
            OGRCoordinateTransformation::DestroyCT(used);
        }
    };

    OGRSpatialReference system;
    std::unique_ptr<OGRCoordinateTransformation, HandBack> toLonLat;
    double metresPerElevationUnit = 1;
    bool elevationUnitIsStated = false;
    double west = -180, south = -90, east = 180, north = 90;  // area of use

    void learnArea() {
        double w = 0, s = 0, e = 0, n = 0;
        if (!system.GetAreaOfUse(&w, &s, &e, &n, nullptr) || w <= -1000) return;
        west = w, south = s, east = e, north = n;
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
    auto parts = std::make_unique<Parts>();
    if (!understand(parts->system, crs))
        return failure("\"" + crs + "\" is not a known coordinate reference system", {},
                       "State it as EPSG:number");
    parts->learnArea();
    parts->learnElevationUnit();
    OGRSpatialReference horizontal(parts->system);
    horizontal.DemoteTo2D(nullptr);
    if (horizontal.IsCompound() != 0) horizontal.StripVertical();
    OGRSpatialReference wgs84;
    wgs84.SetWellKnownGeogCS("WGS84");
    for (OGRSpatialReference* system : {&horizontal, &wgs84})
        system->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    parts->toLonLat.reset(OGRCreateCoordinateTransformation(&horizontal, &wgs84));
    if (!parts->toLonLat)
        return failure("There is no transformation from \"" + crs + "\" to longitude and latitude", {},
                       "State another system");
    return CrsToLonLat(std::move(parts));
}

std::vector<LonLat> CrsToLonLat::lonLat(std::span<const glm::dvec2> points) const {
    const GdalCalls gdal;
    std::vector<double> x, y;
    x.reserve(points.size());
    y.reserve(points.size());
    for (const glm::dvec2 point : points) {
        x.push_back(point.x);
        y.push_back(point.y);
    }
    std::vector<int> worked(points.size(), 0);
    parts_->toLonLat->Transform(int(points.size()), x.data(), y.data(), nullptr, nullptr, worked.data());
    std::vector<LonLat> places;
    places.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool usable = worked[i] != 0 && std::abs(x[i]) <= 360 && std::abs(y[i]) <= 90;
        places.push_back(usable ? LonLat{std::remainder(x[i], 360.0), y[i]} : LonLat{nan, nan});
    }
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

double CrsToLonLat::metresPerElevationUnit() const { return parts_->metresPerElevationUnit; }
bool CrsToLonLat::elevationUnitIsStated() const { return parts_->elevationUnitIsStated; }
std::string CrsToLonLat::name() const {
    return parts_->system.GetName() != nullptr ? parts_->system.GetName() : "";
}

}  // namespace noonmark
