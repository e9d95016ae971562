#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/geo/crs_to_lon_lat.h"
#include "core/io/footprints/feature_facts.h"
#include "core/io/footprints/field_roles.h"
#include "core/io/footprints/ogr_polygons.h"
#include "core/io/footprints/place_features.h"
#include "core/io/heights/height_origins.h"

class OGRFeature;
class OGRLayer;

namespace noonmark {

/// Whose word counts for a layer, and how to name it.
struct LayerSource {
    std::string file;      ///< its name, for messages
    bool fromOsm = false;  ///< GDAL's OpenStreetMap driver
    bool shapefile = false;
    bool oneOfSeveral = false;  ///< feature ids then name their layer
};

/// Reads the features of one layer: fields, units and coordinate system are settled once. Backend:
/// footprint_layer_gdal.cpp.
class FootprintLayer {
public:
    /// Error: no coordinate system, or none that is known; the user's height field is not there.
    static Result<FootprintLayer> of(OGRLayer& layer, const ReadSettings& settings, const LayerSource& source,
                                     Warnings& warnings);

    /// Keeps the feature if it is a building and has a polygon; what cannot be used is a warning.
    void read(const OGRFeature& feature, Warnings& warnings);

    /// After all features: adds those that were kept. Error: most coordinates cannot be what the coordinate
    /// system says.
    Result<void> finish(std::vector<UnplacedFeature>& features, Warnings& warnings);

    /// After all features: the fields that heights came from; and, where more than a tenth of the features
    /// have none, those that could hold them.
    void addHeightFacts(HeightFacts& facts, Warnings& warnings) const;

    [[nodiscard]] std::size_t polygonFeatures() const { return polygonFeatures_; }

private:
    FootprintLayer(OGRLayer& layer, CrsToLonLat toLonLat, const ReadSettings& settings, LayerSource source);
    [[nodiscard]] std::string idOf(const OGRFeature& feature, const FeatureValues& values) const;
    [[nodiscard]] FeatureValues getValues(const OGRFeature& feature) const;
    void watchUnknown(const OGRFeature& feature);
    void transform(std::vector<UnplacedFeature>& features, Warnings& warnings);
    Result<void> checkPlace(Warnings& warnings) const;

    struct Kept {
        FeatureFacts facts;
        std::vector<CrsPolygon> polygons;
    };

    std::string name_;
    LayerSource source_;
    std::vector<KnownField> fields_;
    std::vector<std::pair<int, std::string>> unknownFields_;  // their index and name
    UnknownFields unknown_;
    HeightOrigins origins_;
    int otherTags_ = -1;  // index of the field; -1 where there is none
    int osmId_ = -1;
    int osmWayId_ = -1;
    LayerRules rules_;
    CrsToLonLat toLonLat_;
    bool publishedPlane_ = false;  // a projected system of a register, whose zero no city lies at
    std::vector<Kept> kept_;
    std::size_t polygonFeatures_ = 0;
    std::size_t broken_ = 0;       // features with points that are nowhere
    std::size_t implausible_ = 0;  // features outside the area their system is meant for
    std::size_t nearZero_ = 0;     // features whose coordinates could be degrees
    bool hasZ_ = false;
};

}  // namespace noonmark
