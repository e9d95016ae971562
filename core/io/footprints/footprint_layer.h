#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/geo/crs.h"
#include "core/io/footprints/building_layers.h"
#include "core/io/footprints/feature_facts.h"
#include "core/io/footprints/ogr_polygons.h"
#include "core/io/footprints/place_features.h"
#include "core/io/heights/field_roles.h"
#include "core/io/heights/height_reading.h"

class OGRFeature;
class OGRGeometry;
class OGRLayer;

namespace noonmark {

/// The source of a layer, which decides how its fields and ids are read.
struct LayerSource {
    std::string file;  ///< file name, for messages
    bool shapefile = false;
    bool oneOfSeveral = false;                    ///< feature ids then include their layer
    std::shared_ptr<const KmlPolygons> kml = {};  ///< of a KML file only
    std::vector<std::string> aliases = {};        ///< listFieldAliases(); none: the fields have none
};

/// Reads the features of one layer; fields, units and coordinate system are settled once. Backend:
/// footprint_layer_gdal.cpp.
class FootprintLayer {
public:
    /// Error: no coordinate system, or an unknown one; the height field named by the user does not exist.
    static Result<FootprintLayer> of(OGRLayer& layer, const ReadSettings& settings, const LayerSource& source,
                                     Warnings& warnings);

    /// Stores the feature if it is a building and has a polygon; what cannot be used gives a warning.
    void read(const OGRFeature& feature, Warnings& warnings);

    /// Transforms the stored features to longitude and latitude and moves them to the end of `features`.
    /// Call it for some thousand features at a time: GDAL spends 0.1 ms on choosing a transformation.
    void moveStored(std::vector<UnplacedFeature>& features, Warnings& warnings);

    /// After all features. Error: most coordinates cannot belong to the coordinate system.
    Result<void> checkPlace(Warnings& warnings) const;

    /// After all features: adds the fields that heights came from and, if more than a tenth of the features
    /// have no height, unknown fields that could hold heights.
    void addHeightFacts(HeightFacts& facts, Warnings& warnings) const;

    [[nodiscard]] std::string systemName() const { return toLonLat_.name(); }
    [[nodiscard]] std::size_t polygonFeatures() const { return polygonFeatures_; }

private:
    FootprintLayer(OGRLayer& layer, CrsToLonLat toLonLat, const ReadSettings& settings, LayerSource source);
    [[nodiscard]] std::string idOf(const OGRFeature& feature, const FeatureValues& values) const;
    [[nodiscard]] FeatureValues getValues(const OGRFeature& feature) const;
    void watchUnknown(const OGRFeature& feature);
    void learn(OGRLayer& layer, const LayerSample& sample, const ReadSettings& settings, Warnings& warnings);
    void learnOutlineZ(const LayerSample& sample, const ReadSettings& settings, bool mapInFeet);
    [[nodiscard]] bool isOtherKind(const OGRFeature& feature, const std::string& id,
                                   Warnings& warnings) const;
    [[nodiscard]] std::optional<FeatureValue> outlineZOf(const OGRGeometry& geometry, const std::string& id,
                                                         Warnings& warnings) const;
    [[nodiscard]] std::optional<FieldRole> roleOfZ(const OGRGeometry& geometry, const std::string& id,
                                                   Warnings& warnings) const;

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
    std::vector<HeightDoubt> doubts_;
    std::vector<std::string> names_;  // of all fields, as they are shown and chosen
    int kindField_ = -1;              // says what kind of object a feature is; -1 without one
    std::optional<FieldRole> zRole_;  // of the outlines' highest Z; nothing: it is not used
    LengthUnit zUnit_ = LengthUnit::metres;
    TextEncoding encoding_ = TextEncoding::utf8;  // of texts that are not UTF-8
    int otherTags_ = -1;                          // index of the field; -1 if there is none
    int osmId_ = -1;
    int osmWayId_ = -1;
    LayerRules rules_;
    CrsToLonLat toLonLat_;
    // A projected system from a register, with no city near its coordinate origin
    bool publishedPlane_ = false;
    std::vector<Kept> kept_;
    std::size_t polygonFeatures_ = 0;
    std::size_t broken_ = 0;       // features with points that cannot be transformed
    std::size_t implausible_ = 0;  // features outside the area of use of their system
    std::size_t nearZero_ = 0;     // features whose coordinates could be degrees
    bool hasZ_ = false;            // of outlines whose elevations are not used
};

}  // namespace noonmark
