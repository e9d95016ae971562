#include "core/io/elements/read_glazing.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/base/gdal_calls.h"
#include "core/base/safe_text.h"
#include "core/describe/text.h"
#include "core/geo/frame.h"
#include "core/geo/lon_lat.h"
#include "core/io/files/open_dataset.h"
#include "core/io/files/plain_file.h"
#include "core/io/layers/feature_stream.h"
#include "core/receivers/place_names.h"

namespace noonmark {

namespace {

using Path = std::filesystem::path;

constexpr std::array idFields{"id", "window", "window_id", "fid", "gid", "name"};
constexpr std::array azimuthFields{"azimuth", "azimuth_deg", "facing", "orientation"};
constexpr std::array floorFields{"floor", "storey", "story", "level"};
constexpr std::array roomFields{"room", "room_id"};
constexpr std::array dwellingFields{"dwelling", "flat", "apartment", "unit", "household"};
constexpr const char* glazingAdvice =
    "Give windows as points or polygons with heights (PointZ, PolygonZ), in a format such as GeoPackage";

/// A window in the coordinates of its file.
struct FileGlazing {
    GlazingShape shape;                        // without corners
    std::size_t firstCorner = 0, corners = 0;  // in GlazingLayer::points_
};

template <std::size_t size>
int findField(OGRLayer& layer, const std::array<const char*, size>& names) {
    for (const char* name : names)
        if (const int field = layer.FindFieldIndex(name, 0); field >= 0) return field;
    return -1;
}

Result<int> findIdField(OGRLayer& layer, const std::string& asked, const std::string& file) {
    if (asked.empty()) return findField(layer, idFields);
    return findNamedField(layer, asked, file);
}

std::optional<double> numberIn(const OGRFeature& feature, int field) {
    if (field < 0 || feature.IsFieldSetAndNotNull(field) == FALSE) return std::nullopt;
    const std::string text = trimmed(feature.GetFieldAsString(field));
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(number))
        return std::nullopt;
    return number;
}

/// Collects the windows of one layer.
class GlazingLayer {
public:
    static Result<GlazingLayer> of(OGRLayer& layer, const GlazingFileSettings& settings,
                                   const std::string& file) {
        auto transform = findLayerCrs(layer, settings.crs, file);
        if (!transform) return tl::make_unexpected(transform.error());
        const auto id = findIdField(layer, settings.idField, file);
        if (!id) return tl::make_unexpected(id.error());
        GlazingLayer made(*std::move(transform));
        made.idField_ = *id;
        made.azimuthField_ = findField(layer, azimuthFields);
        made.floorField_ = findField(layer, floorFields);
        made.roomField_ = findField(layer, roomFields);
        made.dwellingField_ = findField(layer, dwellingFields);
        return made;
    }

    void read(const OGRFeature& feature, Warnings& warnings) {
        GlazingShape shape{.id = idOf(feature)};
        if (const OGRGeometry* geometry = feature.GetGeometryRef();
            geometry == nullptr || geometry->IsEmpty()) {
            warnings.push_back({WarningKind::dropped, "the window has no geometry", shape.id});
        } else {
            shape.azimuthDeg = azimuthOf(feature, shape.id, warnings);
            shape.floor = floorOf(feature);
            shape.room = nameIn(feature, roomField_);
            shape.dwelling = nameIn(feature, dwellingField_);
            addPieces(*geometry, shape, warnings);
        }
    }

    // All points go through one call: GDAL spends 0.1 ms on choosing a transformation for each.
    void place(const City& city, const GlazingFileSettings& settings, GlazingRead& into) const {
        std::vector<glm::dvec2> flat(points_.begin(), points_.end());
        const std::vector<LonLat> places = toLonLat_.lonLat(flat);
        for (const FileGlazing& window : windows_) {
            GlazingShape shape = window.shape;
            if (const char* why = placeCorners(window, places, city, settings, shape.corners)) {
                const bool far = shape.corners.empty();
                into.warnings.push_back({far ? WarningKind::leftOut : WarningKind::dropped, why, shape.id});
                continue;
            }
            into.windows.push_back(std::move(shape));
        }
    }

private:
    explicit GlazingLayer(CrsToLonLat toLonLat) : toLonLat_(std::move(toLonLat)) {}

    [[nodiscard]] std::string idOf(const OGRFeature& feature) const {
        if (idField_ >= 0 && feature.IsFieldSetAndNotNull(idField_) != FALSE)
            if (std::string id = cleanName(feature.GetFieldAsString(idField_)); !id.empty()) return id;
        return fmt::format("feature {}", feature.GetFID());
    }

    static std::string nameIn(const OGRFeature& feature, int field) {
        if (field < 0 || feature.IsFieldSetAndNotNull(field) == FALSE) return {};
        return cleanName(feature.GetFieldAsString(field));
    }

    [[nodiscard]] std::optional<double> azimuthOf(const OGRFeature& feature, const std::string& id,
                                                  Warnings& warnings) const {
        const auto azimuth = numberIn(feature, azimuthField_);
        if (azimuth && std::abs(*azimuth) <= 360) return azimuth;
        if (azimuth || (azimuthField_ >= 0 && feature.IsFieldSetAndNotNull(azimuthField_) != FALSE))
            warnings.push_back(
                {WarningKind::assumed, "the azimuth is no angle of -360 to 360 degrees; it was ignored", id});
        return std::nullopt;
    }

    [[nodiscard]] std::optional<std::int32_t> floorOf(const OGRFeature& feature) const {
        const auto floor = numberIn(feature, floorField_);
        if (!floor || std::abs(*floor) > 1000) return std::nullopt;
        return std::int32_t(std::lround(*floor));
    }

    void addPieces(const OGRGeometry& geometry, const GlazingShape& shape, Warnings& warnings) {
        const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
        if (type == wkbPoint)
            addPoint(*geometry.toPoint(), shape);
        else if (type == wkbPolygon)
            addPane(*geometry.toPolygon(), shape, warnings);
        else if (type == wkbMultiPoint || type == wkbMultiPolygon || type == wkbGeometryCollection)
            addCollection(*geometry.toGeometryCollection(), shape, warnings);
        else
            warnings.push_back(
                {WarningKind::dropped, "the window is neither a point nor a polygon", shape.id});
    }

    void addCollection(const OGRGeometryCollection& pieces, const GlazingShape& shape, Warnings& warnings) {
        if (pieces.getNumGeometries() == 1) return addPieces(*pieces.getGeometryRef(0), shape, warnings);
        for (int i = 0; i < pieces.getNumGeometries(); ++i) {
            GlazingShape piece = shape;
            piece.id = fmt::format("{}/{}", shape.id, i + 1);
            addPieces(*pieces.getGeometryRef(i), piece, warnings);
        }
    }

    void addPoint(const OGRPoint& point, const GlazingShape& shape) {
        windows_.push_back({shape, points_.size(), 1});
        points_.emplace_back(point.getX(), point.getY(), heightOf(point));
    }

    // Without the point that closes the ring.
    void addPane(const OGRPolygon& polygon, const GlazingShape& shape, Warnings& warnings) {
        const OGRLinearRing* ring = polygon.getExteriorRing();
        const int count = ring == nullptr ? 0 : std::max(0, ring->getNumPoints() - 1);
        if (count < 3) {
            warnings.push_back(
                {WarningKind::dropped, "the window's pane has fewer than three corners", shape.id});
            return;
        }
        windows_.push_back({shape, points_.size(), std::size_t(count)});
        for (int i = 0; i < count; ++i) {
            OGRPoint point;
            ring->getPoint(i, &point);
            points_.emplace_back(point.getX(), point.getY(), heightOf(point));
        }
    }

    // NaN: none is stated.
    static double heightOf(const OGRPoint& point) {
        return point.Is3D() != FALSE ? point.getZ() : std::numeric_limits<double>::quiet_NaN();
    }

    // Null, or why the window cannot be used; without corners it is too far away.
    const char* placeCorners(const FileGlazing& window, const std::vector<LonLat>& places, const City& city,
                             const GlazingFileSettings& settings, std::vector<glm::dvec3>& corners) const {
        const double unit = toLonLat_.elevationUnitIsStated() ? toLonLat_.metresPerElevationUnit() : 1;
        for (std::size_t i = window.firstCorner; i < window.firstCorner + window.corners; ++i) {
            const LonLat place = places[i];
            corners.emplace_back(0);
            if (!std::isfinite(place.lonDeg) || !std::isfinite(place.latDeg))
                return "the window has coordinates that are nowhere on the earth";
            if (!std::isfinite(points_[i].z)) return "the window has no height (z)";
            if (std::abs(points_[i].z) * unit > 20000) return "the window's height is beyond 20 km";
            if (computeGreatCircleM(place, city.frame.origin()) > settings.farAwayM) {
                corners.clear();
                return "the window is too far from the city";
            }
            const glm::dvec2 local = city.frame.localFromLonLat(place);
            corners.back() = {local, localHeight(points_[i].z * unit, local, city, settings)};
        }
        return nullptr;
    }

    static double localHeight(double z, glm::dvec2 local, const City& city,
                              const GlazingFileSettings& settings) {
        if (settings.aboveGround) return z;
        return z - city.frame.originElevationM() - (city.terrain ? earthDropM(local) : 0);
    }

    CrsToLonLat toLonLat_;
    int idField_ = -1, azimuthField_ = -1, floorField_ = -1, roomField_ = -1, dwellingField_ = -1;
    std::vector<FileGlazing> windows_;
    std::vector<glm::dvec3> points_;
};

Error noGlazing(const GlazingRead& read, const std::string& file) {
    const auto groups = groupWarnings(read.warnings);
    if (groups.empty()) return failure("It holds no windows", file, glazingAdvice).value();
    return failure(fmt::format("It holds no usable window: {}", lineOf(groups.front())), file, glazingAdvice)
        .value();
}

Result<GlazingRead> readLayers(GDALDataset& dataset, const GdalCalls& calls, const std::string& file,
                               const GlazingFileSettings& settings, const City& city, Progress& progress,
                               const std::stop_token& stop) {
    std::vector<OGRLayer*> layers;
    std::vector<GlazingLayer> readers;
    for (OGRLayer* layer : dataset.GetLayers()) {
        if (layer->GetGeomType() == wkbNone) continue;  // a table
        auto reader = GlazingLayer::of(*layer, settings, file);
        if (!reader) return tl::make_unexpected(reader.error());
        layers.push_back(layer);
        readers.push_back(*std::move(reader));
    }
    GlazingRead read;
    const auto take = [&](std::size_t layer, const OGRFeature& feature) -> Result<void> {
        readers[layer].read(feature, read.warnings);
        if (++read.features <= GlazingFileSettings::maxWindows) return {};
        return limitReached(fmt::format("It holds more than {} windows", GlazingFileSettings::maxWindows),
                            file, "Divide the file");
    };
    if (auto done = readFeatures(layers, {file, NM_TEXT("reading windows")}, calls, take, progress, stop);
        !done)
        return tl::make_unexpected(done.error());
    for (const GlazingLayer& reader : readers) reader.place(city, settings, read);
    if (stop.stop_requested()) return cancelled();
    if (read.windows.empty()) return tl::make_unexpected(noGlazing(read, file));
    return read;
}

}  // namespace

Result<GlazingRead> readGlazing(const Path& file, const GlazingFileSettings& settings, const City& city,
                                Progress& progress, const std::stop_token& stop) try {
    const GdalCalls calls(stop);
    const auto format = detectFormat(file);
    if (format && (*format)->name == "IFC") return readIfcGlazing(file, settings, city, stop);
    if (format && (*format)->reader.kind == FileKind::cityJson)
        return (*format)->name == "CityGML" ? readCityGmlGlazing(file, settings, city, progress, stop)
                                            : readCityJsonGlazing(file, settings, city, stop);
    const auto dataset = openDataset(file, DatasetContent::vectors);
    if (!dataset) return tl::make_unexpected(dataset.error());
    return readLayers(**dataset, calls, file.filename().string(), settings, city, progress, stop);
} catch (const std::exception& exception) {
    return failure(fmt::format("The windows cannot be read ({})", exception.what()), file.string(),
                   "Check that the file is complete, or export it again");
}

}  // namespace noonmark
