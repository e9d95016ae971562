#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/base/safe_text.h"
#include "core/geo/lon_lat.h"
#include "core/io/footprints/ogr_polygons.h"
#include "core/io/layers/feature_stream.h"
#include "core/io/places/place_layer.h"
#include "core/receivers/place_names.h"

namespace noonmark {

namespace {

// Usual fields of names, among them those of New York's and London's park registers.
constexpr std::array nameFields{"name",  "park_name", "parkname", "signname",  "place_name",
                                "title", "site_name", "street",   "full_name", "label"};

Result<int> findNameField(OGRLayer& layer, const std::string& asked, const std::string& file) {
    if (asked.empty()) {
        for (const char* standard : nameFields)
            if (const int field = layer.FindFieldIndex(standard, 0); field >= 0) return field;
        return -1;
    }
    return findNamedField(layer, asked, file);
}

bool hasTags(const OGRFeatureDefn& fields) {
    return std::ranges::any_of(std::array{"leisure", "landuse", "amenity"},
                               [&](const char* key) { return fields.GetFieldIndex(key) >= 0; });
}

// Columns of tags in any case: "WIDTH", as Shapefiles have them.
std::string lowerCase(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    return text;
}

bool isSomewhere(LonLat place) { return std::isfinite(place.lonDeg) && std::isfinite(place.latDeg); }

}  // namespace

PlaceLayer::PlaceLayer(CrsToLonLat toLonLat, const PlaceSettings& settings, std::string source, bool fromOsm)
    : toLonLat_(std::move(toLonLat)), settings_(settings), source_(std::move(source)), fromOsm_(fromOsm) {}

Result<PlaceLayer> PlaceLayer::of(OGRLayer& layer, const PlaceSettings& settings, const std::string& file,
                                  std::string sourceStart, bool fromOsm) {
    auto transform = findLayerCrs(layer, settings.crs, file);
    if (!transform) return tl::make_unexpected(transform.error());
    const auto name = findNameField(layer, fromOsm ? "" : settings.nameField, file);
    if (!name) return tl::make_unexpected(name.error());
    PlaceLayer made(*std::move(transform), settings, std::move(sourceStart), fromOsm);
    made.nameField_ = *name;
    made.findFields(layer);
    return made;
}

bool PlaceLayer::isOfProject(OGRLayer& layer) {
    const OGRFeatureDefn& fields = *layer.GetLayerDefn();
    return std::string_view(layer.GetName()) == "places" && fields.GetFieldIndex("kind") >= 0 &&
           fields.GetFieldIndex("source") >= 0;
}

bool PlaceLayer::statesKinds(OGRLayer& layer) {
    return layer.FindFieldIndex("kind", 0) >= 0 || hasTags(*layer.GetLayerDefn());
}

void PlaceLayer::findFields(OGRLayer& layer) {
    const OGRFeatureDefn& definition = *layer.GetLayerDefn();
    if (!fromOsm_ && isOfProject(layer)) sourceField_ = definition.GetFieldIndex("source");
    kindField_ = fromOsm_ ? -1 : layer.FindFieldIndex("kind", 0);
    osmId_ = definition.GetFieldIndex("osm_id");
    osmWayId_ = definition.GetFieldIndex("osm_way_id");
    for (int i = 0; i < definition.GetFieldCount(); ++i)
        tagFields_.emplace_back(i, lowerCase(definition.GetFieldDefn(i)->GetNameRef()));
    tagged_ = fromOsm_ || hasTags(definition);
}

PlaceTags PlaceLayer::tagsOf(const OGRFeature& feature) const {
    PlaceTags tags;
    for (const auto& [field, key] : tagFields_)
        if (feature.IsFieldSetAndNotNull(field) != FALSE)
            if (std::string text = trimmed(feature.GetFieldAsString(field)); !text.empty())
                tags.emplace(key, std::move(text));
    return tags;
}

std::string PlaceLayer::nameIn(const OGRFeature& feature) const {
    if (nameField_ < 0 || feature.IsFieldSetAndNotNull(nameField_) == FALSE) return {};
    return cleanName(feature.GetFieldAsString(nameField_));
}

std::string PlaceLayer::idOf(const OGRFeature& feature) const {
    const auto filled = [&](int field) { return field >= 0 && feature.IsFieldSetAndNotNull(field) != FALSE; };
    if (fromOsm_ && filled(osmWayId_)) return fmt::format("way {}", feature.GetFieldAsString(osmWayId_));
    if (fromOsm_ && filled(osmId_))
        return fmt::format("{} {}", osmWayId_ >= 0 ? "relation" : "way", feature.GetFieldAsString(osmId_));
    return fmt::format("feature {}", feature.GetFID());
}

// As a project names the source of a place that states none.
std::string PlaceLayer::sourceIn(const OGRFeature& feature) const {
    if (sourceField_ < 0) return {};
    std::string source = feature.GetFieldAsString(sourceField_);
    return source.empty() ? fmt::format("place {}", feature.GetFID()) : source;
}

std::optional<PlaceKind> PlaceLayer::kindOf(const OGRFeature& feature) const {
    if (kindField_ >= 0 && feature.IsFieldSetAndNotNull(kindField_) != FALSE)
        if (const auto kind = parsePlaceKind(trimmed(feature.GetFieldAsString(kindField_)))) return kind;
    if (tagged_) return classifyArea(tagsOf(feature));
    return settings_.kind;
}

bool PlaceLayer::isWanted(PlaceKind kind, const std::string& name) const {
    return (settings_.kinds.empty() || settings_.kinds.contains(kind)) &&
           (settings_.unnamed || !name.empty());
}

void PlaceLayer::read(const OGRFeature& feature) {
    const OGRGeometry* geometry = feature.GetGeometryRef();
    if (geometry == nullptr) return;
    const OGRwkbGeometryType type = wkbFlatten(geometry->getGeometryType());
    if (type == wkbLineString || type == wkbMultiLineString)
        readStreet(feature);
    else
        readArea(feature);
}

void PlaceLayer::readArea(const OGRFeature& feature) {
    auto polygons = readPolygons(*feature.GetGeometryRef());
    if (polygons.empty()) return;
    ++usableFeatures_;
    const auto kind = kindOf(feature);
    std::string name = nameIn(feature);
    if (kind && isWanted(*kind, name))
        areas_.push_back({idOf(feature), std::move(name), sourceIn(feature), *kind, std::move(polygons)});
}

void PlaceLayer::readStreet(const OGRFeature& feature) {
    if (!settings_.streets) return;
    ++usableFeatures_;
    const PlaceTags tags = tagsOf(feature);
    const auto width = widthOf(tags);
    std::string name = nameIn(feature);
    if (!width || !isWanted(PlaceKind::street, name)) return;
    const auto add = [&](const OGRLineString& line) {
        Street street{idOf(feature), name, *width, {}};
        for (const OGRPoint& point : line) street.points.emplace_back(point.getX(), point.getY());
        streets_.push_back(std::move(street));
    };
    const OGRGeometry& geometry = *feature.GetGeometryRef();
    if (wkbFlatten(geometry.getGeometryType()) == wkbLineString) return add(*geometry.toLineString());
    for (const OGRLineString* line : *geometry.toMultiLineString()) add(*line);
}

// A layer of lines whose classes OpenStreetMap does not know holds nothing but streets.
std::optional<StreetWidth> PlaceLayer::widthOf(const PlaceTags& tags) const {
    return fromOsm_ || tags.contains("highway") ? readStreetWidth(tags) : readLineWidth(tags);
}

// All points go through one call: GDAL spends 0.1 ms on choosing a transformation for each.
std::vector<Place> PlaceLayer::placeAreas(const Frame& frame, PlacesRead& into,
                                          const std::stop_token& stop) const {
    std::vector<glm::dvec2> points;
    for (const Area& area : areas_)
        for (const CrsPolygon& polygon : area.polygons)
            for (const auto& ring : polygon) points.insert(points.end(), ring.begin(), ring.end());
    const std::vector<LonLat> places = toLonLat_.lonLat(points);
    auto next = places.begin();
    std::vector<UnplacedFeature> features;
    for (const Area& area : areas_) {
        UnplacedFeature feature;
        feature.facts.id = area.id;
        feature.facts.name = area.name;
        feature.facts.status = nameOf(area.kind);
        bool somewhere = true;
        for (const CrsPolygon& polygon : area.polygons) {
            LonLatPolygon& rings = feature.polygons.emplace_back();
            for (const auto& ring : polygon) {
                rings.emplace_back(next, next + std::ptrdiff_t(ring.size()));
                next += std::ptrdiff_t(ring.size());
                somewhere = somewhere && std::ranges::all_of(rings.back(), isSomewhere);
            }
        }
        if (somewhere)
            features.push_back(std::move(feature));
        else
            into.warnings.push_back(
                {WarningKind::dropped, "has coordinates that are nowhere on the earth", area.id});
    }
    std::map<std::string, std::string> stated;
    for (const Area& area : areas_)
        if (!area.source.empty()) stated.emplace(area.id, area.source);
    std::vector<Place> made;
    for (PlacedFeature& feature :
         placeFeatures(std::move(features), frame, settings_.farAwayM, into.warnings, stop)) {
        const auto source = stated.find(feature.facts.id);
        made.push_back({feature.facts.name, parsePlaceKind(feature.facts.status).value_or(PlaceKind::other),
                        std::move(feature.pieces),
                        source != stated.end() ? source->second : source_ + feature.facts.id});
    }
    return made;
}

std::vector<StreetPiece> PlaceLayer::placeStreets(const Frame& frame, PlacesRead& into) const {
    std::vector<glm::dvec2> points;
    for (const Street& street : streets_)
        points.insert(points.end(), street.points.begin(), street.points.end());
    const std::vector<LonLat> places = toLonLat_.lonLat(points);
    auto next = places.begin();
    std::vector<StreetPiece> pieces;
    for (const Street& street : streets_) {
        StreetPiece piece{street.name, street.id, {{}, street.width.widthM}};
        bool near = true;
        for (std::size_t i = 0; i < street.points.size(); ++i, ++next) {
            near = near && isSomewhere(*next) &&
                   computeGreatCircleM(*next, frame.origin()) <= settings_.farAwayM;
            if (near) piece.line.points.push_back(frame.localFromLonLat(*next));
        }
        if (!near) {
            into.warnings.push_back({WarningKind::leftOut, "the street is too far from the city", street.id});
            continue;
        }
        if (street.width.assumed) {
            ++into.streetsOfAssumedWidth;
            into.warnings.push_back({WarningKind::assumed,
                                     "neither width nor lanes are stated; the usual width of its class is "
                                     "assumed",
                                     street.id});
        }
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

}  // namespace noonmark
