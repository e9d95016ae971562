#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/gdal_calls.h"
#include "core/base/stop_scope.h"
#include "core/geo/crs_definition.h"
#include "core/geo/crs_to_lon_lat.h"

namespace noonmark {

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
    void addPlaces(std::span<const glm::dvec2> points, std::vector<LonLat>& places) const {
        std::vector<double> x, y;
        for (const glm::dvec2 point : points) {
            x.push_back(point.x);
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
