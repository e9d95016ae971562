#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/geo/crs.h"
#include "core/io/footprints/place_features.h"
#include "core/io/places/place_assembly.h"
#include "core/io/places/place_tags.h"
#include "core/io/places/read_places.h"

class OGRFeature;
class OGRLayer;

namespace noonmark {

/// Reads the features of one layer; fields and coordinate system are settled once. Backend:
/// place_layer_gdal.cpp.
class PlaceLayer {
public:
    /// Whether Noonmark wrote the layer: the places of a project. Their sources stay as they are stated.
    static bool isOfProject(OGRLayer& layer);
    /// Whether its fields say of which kind a place is: `kind`, or columns that bear OpenStreetMap's keys.
    static bool statesKinds(OGRLayer& layer);
    /// Error: no coordinate system, or an unknown one; the name field that the user named does not exist.
    /// `sourceStart`: before the ids of its places, "city.gpkg, plots, ".
    static Result<PlaceLayer> of(OGRLayer& layer, const PlaceSettings& settings, const std::string& file,
                                 std::string sourceStart, bool fromOsm);

    /// Stores the feature if it is an area that is a place, or a street.
    void read(const OGRFeature& feature);

    /// The areas, repaired, in the frame; one for each feature.
    std::vector<Place> placeAreas(const Frame& frame, PlacesRead& into, const std::stop_token& stop) const;
    /// The streets' lines in the frame.
    std::vector<StreetPiece> placeStreets(const Frame& frame, PlacesRead& into) const;

    /// Features whose shape can be a place: polygons, and lines of streets where they are wanted.
    [[nodiscard]] std::size_t usableFeatures() const { return usableFeatures_; }
    [[nodiscard]] std::size_t kept() const { return areas_.size() + streets_.size(); }

private:
    struct Area {
        std::string id, name;
        std::string source;  // that the layer states; empty: file and id
        PlaceKind kind = PlaceKind::other;
        std::vector<std::vector<std::vector<glm::dvec2>>> polygons;  // CrsPolygon
    };
    struct Street {
        std::string id, name;
        StreetWidth width;
        std::vector<glm::dvec2> points;
    };

    PlaceLayer(CrsToLonLat toLonLat, const PlaceSettings& settings, std::string source, bool fromOsm);
    void findFields(OGRLayer& layer);
    [[nodiscard]] PlaceTags tagsOf(const OGRFeature& feature) const;
    [[nodiscard]] std::string nameIn(const OGRFeature& feature) const;
    [[nodiscard]] std::string idOf(const OGRFeature& feature) const;
    [[nodiscard]] std::string sourceIn(const OGRFeature& feature) const;
    [[nodiscard]] std::optional<PlaceKind> kindOf(const OGRFeature& feature) const;
    [[nodiscard]] bool isWanted(PlaceKind kind, const std::string& name) const;
    void readArea(const OGRFeature& feature);
    void readStreet(const OGRFeature& feature);
    [[nodiscard]] std::optional<StreetWidth> widthOf(const PlaceTags& tags) const;

    CrsToLonLat toLonLat_;
    PlaceSettings settings_;
    std::string source_;  // "OSM ", or "parks.gpkg, "
    bool fromOsm_ = false;
    bool tagged_ = false;
    int nameField_ = -1, kindField_ = -1, sourceField_ = -1, osmId_ = -1, osmWayId_ = -1;
    std::vector<std::pair<int, std::string>> tagFields_;
    std::vector<Area> areas_;
    std::vector<Street> streets_;
    std::size_t usableFeatures_ = 0;
};

}  // namespace noonmark
