#pragma once

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <optional>
#include <vector>

namespace noonmark::tests {

/// Transforms to metres east, north and up of an origin, by the formulas of the WGS84 ellipsoid alone.
class EastNorthUp {
public:
    EastNorthUp(double lonDeg, double latDeg)
        : lon_(lonDeg * rad), lat_(latDeg * rad), at_(geocentric(lon_, lat_)) {}
    [[nodiscard]] glm::dvec2 operator()(double lonDeg, double latDeg) const {
        const glm::dvec3 way = geocentric(lonDeg * rad, latDeg * rad) - at_;
        return {-std::sin(lon_) * way.x + std::cos(lon_) * way.y,
                -std::sin(lat_) * std::cos(lon_) * way.x - std::sin(lat_) * std::sin(lon_) * way.y +
                    std::cos(lat_) * way.z};
    }

private:
    static constexpr double rad = std::numbers::pi / 180;
    static glm::dvec3 geocentric(double lon, double lat) {
        constexpr double a = 6378137, f = 1 / 298.257223563, ee = f * (2 - f);
        const double n = a / std::sqrt(1 - ee * std::sin(lat) * std::sin(lat));
        return {n * std::cos(lat) * std::cos(lon), n * std::cos(lat) * std::sin(lon),
                n * (1 - ee) * std::sin(lat)};
    }
    double lon_, lat_;
    glm::dvec3 at_;
};

/// The surface of a raster itself: two triangles between the centres of four neighbouring pixels, with the
/// diagonal from south-west to north-east, all in double precision. Independent of the engines and of the
/// terrain reader, except that GDAL reads the file.
class SourceSurface {
public:
    SourceSurface(const std::filesystem::path& file, double originLonDeg, double originLatDeg,
                  double originElevationM) {
        GDALAllRegister();
        const GDALDatasetUniquePtr dataset(GDALDataset::Open(file.string().c_str()));
        columns_ = dataset->GetRasterXSize();
        rows_ = dataset->GetRasterYSize();
        values_.resize(std::size_t(columns_) * std::size_t(rows_));
        if (dataset->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, columns_, rows_, values_.data(), columns_,
                                                rows_, GDT_Float64, 0, 0, nullptr) != CE_None)
            values_.clear();
        placePosts(*dataset, EastNorthUp(originLonDeg, originLatDeg), originElevationM);
        sortTriangles();
    }

    [[nodiscard]] const glm::dvec3& post(int column, int row) const {
        return posts_[std::size_t(row) * std::size_t(columns_) + std::size_t(column)];
    }
    [[nodiscard]] int columns() const { return columns_; }
    [[nodiscard]] int rows() const { return rows_; }

    /// Nothing beyond the outer posts.
    [[nodiscard]] std::optional<double> elevationAt(glm::dvec2 place) const {
        for (const auto& triangle : triangles(binOf(place))) {
            const double t = hit(triangle, {place, 1e5}, {0, 0, -1});
            if (t > 0) return 1e5 - t;
        }
        return std::nullopt;
    }

    /// Whether a ray that starts on the ground hits the surface again.
    [[nodiscard]] bool blocks(glm::dvec3 from, glm::dvec3 direction) const {
        const glm::dvec2 way = glm::normalize(glm::dvec2(direction));
        const double rising = direction.z / glm::length(glm::dvec2(direction));
        for (double far = 0; from.z + far * rising <= highest_ + 1 && far < 1e5; far += binM)
            for (int dx = -1; dx <= 1; ++dx)
                for (int dy = -1; dy <= 1; ++dy)
                    for (const auto& triangle :
                         triangles(binOf(glm::dvec2(from) + far * way) + glm::ivec2(dx, dy)))
                        if (hit(triangle, from, direction) > 1e-6) return true;
        return false;
    }

private:
    using Triangle = std::array<glm::dvec3, 3>;
    static constexpr double binM = 8;

    void placePosts(const GDALDataset& dataset, const EastNorthUp& local, double originElevationM) {
        double g[6];
        const_cast<GDALDataset&>(dataset).GetGeoTransform(g);
        OGRSpatialReference own(*dataset.GetSpatialRef()), wgs84;
        wgs84.SetWellKnownGeogCS("WGS84");
        own.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        const std::unique_ptr<OGRCoordinateTransformation> to(
            OGRCreateCoordinateTransformation(&own, &wgs84));
        for (int row = 0; row < rows_; ++row)
            for (int column = 0; column < columns_; ++column) {
                double x = g[0] + (column + 0.5) * g[1] + (row + 0.5) * g[2],
                       y = g[3] + (column + 0.5) * g[4] + (row + 0.5) * g[5];
                to->Transform(1, &x, &y);
                const glm::dvec2 place = local(x, y);
                const double drop = glm::dot(place, place) * 0.87 / 2 / 6'371'009,
                             value = values_[posts_.size()];
                posts_.emplace_back(place, value - originElevationM - drop);
                low_ = glm::min(low_, place);
                high_ = glm::max(high_, place);
                highest_ = std::max(highest_, posts_.back().z);
            }
    }

    void sortTriangles() {
        bins_ = glm::ivec2((high_ - low_) / binM) + 1;
        sorted_.resize(std::size_t(bins_.x) * std::size_t(bins_.y));
        for (int row = 0; row + 1 < rows_; ++row)
            for (int column = 0; column + 1 < columns_; ++column) {
                const glm::dvec3 southWest = post(column, row + 1), northEast = post(column + 1, row);
                add({southWest, post(column + 1, row + 1), northEast});
                add({southWest, northEast, post(column, row)});
            }
    }

    void add(const Triangle& triangle) {
        glm::dvec2 low(triangle[0]), high(triangle[0]);
        for (const glm::dvec3& corner : triangle) {
            low = glm::min(low, glm::dvec2(corner));
            high = glm::max(high, glm::dvec2(corner));
        }
        for (int y = binOf(low).y; y <= binOf(high).y; ++y)
            for (int x = binOf(low).x; x <= binOf(high).x; ++x)
                sorted_[std::size_t(y) * std::size_t(bins_.x) + std::size_t(x)].push_back(triangle);
    }

    [[nodiscard]] glm::ivec2 binOf(glm::dvec2 place) const {
        return glm::ivec2(glm::floor((place - low_) / binM));
    }
    [[nodiscard]] const std::vector<Triangle>& triangles(glm::ivec2 bin) const {
        static const std::vector<Triangle> none;
        if (bin.x < 0 || bin.y < 0 || bin.x >= bins_.x || bin.y >= bins_.y) return none;
        return sorted_[std::size_t(bin.y) * std::size_t(bins_.x) + std::size_t(bin.x)];
    }

    // The distance in lengths of `direction`; -1 if there is no hit. A shared side belongs to both triangles.
    static double hit(const Triangle& t, glm::dvec3 from, glm::dvec3 direction) {
        const glm::dvec3 a = t[1] - t[0], b = t[2] - t[0], p = glm::cross(direction, b);
        const double det = glm::dot(a, p);
        if (det == 0) return -1;
        const glm::dvec3 s = from - t[0], q = glm::cross(s, a);
        const double u = glm::dot(s, p) / det, v = glm::dot(direction, q) / det;
        constexpr double edge = -1e-12;
        if (u < edge || v < edge || u + v > 1 - edge) return -1;
        return glm::dot(b, q) / det;
    }

    int columns_ = 0, rows_ = 0;
    std::vector<double> values_;
    std::vector<glm::dvec3> posts_;
    glm::dvec2 low_{1e300}, high_{-1e300};
    double highest_ = -1e300;
    glm::ivec2 bins_{0};
    std::vector<std::vector<Triangle>> sorted_;
};

}  // namespace noonmark::tests
