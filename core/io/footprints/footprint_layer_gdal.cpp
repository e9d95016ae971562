#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>

#include "core/io/footprints/footprint_layer.h"
#include "core/io/footprints/place_advice.h"
#include "core/io/layers/feature_stream.h"
#include "core/io/osm/other_tags.h"

namespace noonmark {

namespace {

std::vector<std::string> listFieldNames(const OGRFeatureDefn& definition) {
    std::vector<std::string> names;
    for (int i = 0; i < definition.GetFieldCount(); ++i)
        names.emplace_back(definition.GetFieldDefn(i)->GetNameRef());
    return names;
}

bool isInFeet(const OGRSpatialReference& system) {
    return system.IsProjected() != 0 && std::abs(system.GetLinearUnits() - 0.3048) < 1e-5;
}

bool isNumber(OGRFieldType type) { return type == OFTInteger || type == OFTInteger64 || type == OFTReal; }

// As GetFieldAsString() writes it, whose printf takes half of the time of reading a feature.
std::string textOf(const OGRFeature& feature, int index) {
    const OGRFieldDefn& field = *feature.GetFieldDefnRef(index);
    const bool plain = field.GetSubType() == OFSTNone && field.GetWidth() == 0;
    if (plain && field.GetType() == OFTReal) return fmt::format("{:.15g}", feature.GetFieldAsDouble(index));
    if (plain && isNumber(field.GetType())) return fmt::format("{}", feature.GetFieldAsInteger64(index));
    return trimmed(feature.GetFieldAsString(index));
}

std::optional<FeatureValue> valueOf(const OGRFeature& feature, const KnownField& field) {
    if (feature.IsFieldSetAndNotNull(field.index) == FALSE) return std::nullopt;
    FeatureValue value{field.meaning.role, field.name, textOf(feature, field.index), {}, field.unit};
    if (value.text.empty()) return std::nullopt;
    const OGRFieldDefn& definition = *feature.GetFieldDefnRef(field.index);
    if (definition.GetSubType() == OFSTBoolean)
        value.text = feature.GetFieldAsInteger(field.index) != 0 ? "true" : "false";
    else if (isNumber(definition.GetType()))
        value.number = feature.GetFieldAsDouble(field.index);
    return value;
}

// Whether the layer uses OpenStreetMap's tags: from a converter, or because it has
// building parts.
bool isTagged(const std::vector<KnownField>& fields, bool converted) {
    if (hasRole(fields, FieldRole::buildingPart)) return true;
    return converted && hasRole(fields, FieldRole::building);
}

bool hasField(const std::vector<std::string>& names, const std::string& wanted) {
    return std::ranges::any_of(names, [&](const std::string& name) { return isSameField(name, wanted); });
}

bool isKnownField(const std::vector<KnownField>& known, int index) {
    return std::ranges::find(known, index, &KnownField::index) != known.end();
}

std::vector<std::pair<int, std::string>> unknownFields(const std::vector<std::string>& names,
                                                       const std::vector<KnownField>& known, bool cutShort) {
    std::vector<std::pair<int, std::string>> unknown;
    for (int i = 0; i < int(names.size()); ++i)
        if (!isKnownField(known, i) && !findMeaning(names[std::size_t(i)], cutShort))
            unknown.emplace_back(i, names[std::size_t(i)]);
    return unknown;
}

void warnOfElevationsAlone(const std::vector<std::string>& names, const std::vector<KnownField>& known,
                           const LayerSource& source, Warnings& warnings) {
    if (hasRole(known, FieldRole::height)) return;
    for (int i = 0; i < int(names.size()); ++i) {
        const auto meaning = findMeaning(names[std::size_t(i)], source.shapefile);
        if (meaning && meaning->role == FieldRole::topElevation && !isKnownField(known, i))
            warnings.push_back({WarningKind::leftOut,
                                "the roof's elevation, which gives no height without the ground's",
                                source.file + ": " + names[std::size_t(i)]});
    }
}

bool couldBeDegrees(const std::vector<CrsPolygon>& polygons) {
    return std::ranges::all_of(polygons, [](const CrsPolygon& polygon) {
        return std::ranges::all_of(polygon.front(), [](glm::dvec2 point) {
            return std::abs(point.x) <= 180 && std::abs(point.y) <= 90;
        });
    });
}

bool isSomewhere(LonLat place) { return std::isfinite(place.lonDeg) && std::isfinite(place.latDeg); }

// Takes the transformed points of the polygons from `next`; nothing if one of them could not be transformed.
std::optional<std::vector<LonLatPolygon>> shapedLike(const std::vector<CrsPolygon>& polygons,
                                                     std::vector<LonLat>::const_iterator& next) {
    std::vector<LonLatPolygon> shaped;
    bool somewhere = true;
    for (const CrsPolygon& polygon : polygons) {
        LonLatPolygon& rings = shaped.emplace_back();
        for (const auto& ring : polygon) {
            rings.emplace_back(next, next + std::ptrdiff_t(ring.size()));
            next += std::ptrdiff_t(ring.size());
            somewhere = somewhere && std::ranges::all_of(rings.back(), isSomewhere);
        }
    }
    if (!somewhere) return std::nullopt;
    return shaped;
}

}  // namespace

Result<FootprintLayer> FootprintLayer::of(OGRLayer& layer, const ReadSettings& settings,
                                          const LayerSource& source, Warnings& warnings) {
    auto transform = findLayerCrs(layer, settings.crs, source.file);
    if (!transform) return tl::make_unexpected(transform.error());
    FootprintLayer made(layer, *std::move(transform), settings, source);
    const std::vector<std::string> names = listFieldNames(*layer.GetLayerDefn());
    made.fields_ = knownFields(names, {settings.heightField, settings.levelsField}, source.shapefile);
    for (const std::string& chosen : {settings.heightField, settings.levelsField})
        if (!chosen.empty() && !hasField(names, chosen))
            return failure(fmt::format("There is no field \"{}\"", chosen), source.file,
                           fmt::format("Its fields are: {}", fmt::join(names, ", ")));
    warnOfElevationsAlone(names, made.fields_, source, warnings);
    made.unknownFields_ = unknownFields(names, made.fields_, source.shapefile);
    const OGRSpatialReference system = findLayerSystem(layer, settings.crs);
    made.publishedPlane_ = system.IsProjected() != 0 && system.GetAuthorityCode(nullptr) != nullptr;
    settleUnits(made.fields_, {settings.heightUnit, isInFeet(system)}, source.file, warnings);
    const bool converted = made.otherTags_ >= 0 || made.osmWayId_ >= 0;
    made.rules_.tagged = isTagged(made.fields_, converted);
    made.rules_.sayNoBuilding = !converted;
    made.rules_.heights.decimalComma = !made.rules_.tagged;
    return made;
}

FootprintLayer::FootprintLayer(OGRLayer& layer, CrsToLonLat toLonLat, const ReadSettings& settings,
                               LayerSource source)
    : name_(layer.GetName()), source_(std::move(source)), toLonLat_(std::move(toLonLat)) {
    const OGRFeatureDefn& definition = *layer.GetLayerDefn();
    otherTags_ = std::max(definition.GetFieldIndex("other_tags"), definition.GetFieldIndex("all_tags"));
    osmId_ = definition.GetFieldIndex("osm_id");
    osmWayId_ = definition.GetFieldIndex("osm_way_id");
    rules_.heights = {settings.metresPerLevel, settings.defaultHeightM};
}

std::string FootprintLayer::idOf(const OGRFeature& feature, const FeatureValues& values) const {
    const auto filled = [&](int field) { return field >= 0 && feature.IsFieldSetAndNotNull(field) != FALSE; };
    if (osmWayId_ >= 0 && filled(osmWayId_))
        return fmt::format("way {}", feature.GetFieldAsString(osmWayId_));
    if (osmWayId_ >= 0 && filled(osmId_)) return fmt::format("relation {}", feature.GetFieldAsString(osmId_));
    if (const FeatureValue* id = firstOf(values, FieldRole::id)) {
        std::string text = id->text;
        if (text.starts_with("way/") || text.starts_with("relation/")) std::ranges::replace(text, '/', ' ');
        return text;
    }
    const std::string number = fmt::format("feature {}", feature.GetFID());
    return source_.oneOfSeveral ? name_ + ": " + number : number;
}

FeatureValues FootprintLayer::getValues(const OGRFeature& feature) const {
    FeatureValues values;
    for (const KnownField& field : fields_)
        if (auto value = valueOf(feature, field)) values.push_back(*std::move(value));
    if (otherTags_ < 0 || feature.IsFieldSetAndNotNull(otherTags_) == FALSE) return values;
    for (auto& [key, text] : parseTags(feature.GetFieldAsString(otherTags_)))
        if (const auto meaning = findTagMeaning(key))
            values.push_back(
                {meaning->role, key, trimmed(text), {}, meaning->unit.value_or(LengthUnit::metres)});
    return values;
}

void FootprintLayer::read(const OGRFeature& feature, Warnings& warnings) {
    const FeatureValues values = getValues(feature);
    const OGRGeometry* geometry = feature.GetGeometryRef();
    auto polygons = geometry != nullptr ? readPolygons(*geometry) : std::vector<CrsPolygon>();
    polygonFeatures_ += polygons.empty() ? 0 : 1;
    auto facts = collectFacts(values, rules_, idOf(feature, values), warnings);
    if (!facts) return;
    if (polygons.empty()) {
        warnings.push_back({WarningKind::dropped, "has no polygon", facts->id});
        return;
    }
    ++origins_[facts->heights.origin];
    watchUnknown(feature);
    hasZ_ |= geometry->Is3D() != FALSE;
    nearZero_ += couldBeDegrees(polygons) ? 1 : 0;
    kept_.push_back({*std::move(facts), std::move(polygons)});
}

void FootprintLayer::watchUnknown(const OGRFeature& feature) {
    for (const auto& [index, name] : unknownFields_) {
        if (feature.IsFieldSetAndNotNull(index) == FALSE) continue;
        const bool number = isNumber(feature.GetFieldDefnRef(index)->GetType());
        const std::string text = textOf(feature, index);
        if (!text.empty())
            unknown_.add(name, text, number ? std::optional(feature.GetFieldAsDouble(index)) : std::nullopt);
    }
}

void FootprintLayer::addHeightFacts(HeightFacts& facts, Warnings& warnings) const {
    noonmark::addHeightFacts(origins_, fields_, unknown_, source_.file, facts, warnings);
}

void FootprintLayer::moveStored(std::vector<UnplacedFeature>& features, Warnings& warnings) {
    std::vector<glm::dvec2> points;
    for (const Kept& kept : kept_)
        for (const CrsPolygon& polygon : kept.polygons)
            for (const auto& ring : polygon) points.insert(points.end(), ring.begin(), ring.end());
    const std::vector<LonLat> places = toLonLat_.lonLat(points);
    auto next = places.begin();
    for (Kept& kept : kept_) {
        auto polygons = shapedLike(kept.polygons, next);
        if (!polygons) {
            ++broken_;
            warnings.push_back(
                {WarningKind::dropped, "has coordinates that are nowhere on the earth", kept.facts.id});
            continue;
        }
        implausible_ += toLonLat_.isPlausible(polygons->front().front().front()) ? 0 : 1;
        features.push_back({std::move(kept.facts), *std::move(polygons)});
    }
    kept_.clear();
}

Result<void> FootprintLayer::checkPlace(Warnings& warnings) const {
    const auto most = [&](std::size_t count) { return count > 0 && 2 * count > polygonFeatures_; };
    if (most(broken_))
        return failure(fmt::format("Its coordinates cannot belong to {}", toLonLat_.name()), source_.file,
                       crsAdvice);
    if (publishedPlane_ && most(nearZero_))
        return failure(fmt::format("Its coordinates look like degrees, not like {}", toLonLat_.name()),
                       source_.file, std::string(crsAdvice) + ", perhaps EPSG:4326");
    if (most(implausible_))
        warnings.push_back(
            {WarningKind::assumed,
             fmt::format("its position is far outside the area of use of {}", toLonLat_.name()),
             source_.file});
    if (hasZ_)
        warnings.push_back({WarningKind::leftOut, "the elevations in its polygons; only outlines are used",
                            source_.oneOfSeveral ? source_.file + ": " + name_ : source_.file});
    return {};
}

}  // namespace noonmark
