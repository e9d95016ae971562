#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/safe_text.h"
#include "core/city/building_heights.h"
#include "core/io/files/readable_text.h"
#include "core/io/footprints/feature_facts.h"
#include "core/io/footprints/footprint_layer.h"
#include "core/io/footprints/ogr_polygons.h"
#include "core/io/heights/height_text.h"
#include "core/io/layers/feature_stream.h"
#include "core/io/pieces/read_part.h"
#include "core/io/settings/read_settings.h"

namespace noonmark {

namespace {

std::string nameOf(const OGRFieldDefn& field) { return readableText(field.GetNameRef()); }

std::string aliasAt(const LayerSource& source, int index) {
    return std::size_t(index) < source.aliases.size() ? source.aliases[std::size_t(index)] : std::string();
}

// The alias of a field is its name if only the alias says what it holds.
std::vector<std::string> knownNames(const OGRFeatureDefn& definition, const LayerSource& source) {
    std::vector<std::string> names;
    for (int i = 0; i < definition.GetFieldCount(); ++i) {
        const OGRFieldDefn& field = *definition.GetFieldDefn(i);
        const std::string alias = aliasAt(source, i);
        const bool aliasIsKnown = !findMeaning(nameOf(field), source.shapefile) && findMeaning(alias);
        names.push_back(aliasIsKnown ? alias : nameOf(field));
    }
    return names;
}

// The field that the user chose by its name or its alias, as it is called here; unchanged if there is none.
std::string knownName(const OGRFeatureDefn& definition, const LayerSource& source,
                      const std::vector<std::string>& names, const std::string& chosen) {
    for (int i = 0; i < definition.GetFieldCount() && !chosen.empty(); ++i)
        if (const OGRFieldDefn& field = *definition.GetFieldDefn(i);
            isSameField(nameOf(field), chosen) || isSameField(aliasAt(source, i), chosen))
            return names[std::size_t(i)];
    return chosen;
}

bool isInFeet(const OGRSpatialReference& system) {
    return system.IsProjected() != 0 && std::abs(system.GetLinearUnits() - 0.3048) < 1e-5;
}

bool isNumber(OGRFieldType type) { return type == OFTInteger || type == OFTInteger64 || type == OFTReal; }

// As GetFieldAsString() writes it, whose printf takes half of the time of reading a feature.
std::string textOf(const OGRFeature& feature, int index, TextEncoding encoding) {
    const OGRFieldDefn& field = *feature.GetFieldDefnRef(index);
    const bool plain = field.GetSubType() == OFSTNone && field.GetWidth() == 0;
    if (plain && field.GetType() == OFTReal) return fmt::format("{:.15g}", feature.GetFieldAsDouble(index));
    if (plain && isNumber(field.GetType())) return fmt::format("{}", feature.GetFieldAsInteger64(index));
    return trimmed(readableText(feature.GetFieldAsString(index), encoding));
}

std::optional<FeatureValue> valueOf(const OGRFeature& feature, const KnownField& field,
                                    TextEncoding encoding) {
    if (field.index < 0 || feature.IsFieldSetAndNotNull(field.index) == FALSE) return std::nullopt;
    FeatureValue value{
        field.meaning.role, field.name, textOf(feature, field.index, encoding), {}, field.unit};
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
    for (int i = 0; i < int(names.size()); ++i) {
        const auto meaning = findMeaning(names[std::size_t(i)], cutShort);
        const bool isRoof = meaning && meaning->role == FieldRole::topElevation;
        const bool isUsed = isKnownField(known, i) && (!isRoof || hasRole(known, FieldRole::groundElevation));
        if (!isUsed && (!meaning || isRoof)) unknown.emplace_back(i, names[std::size_t(i)]);
    }
    return unknown;
}

// Layers of any type of geometry do not state whether they have Z.
bool isOutlineZ(const std::string& chosen, const OGRFeatureDefn& definition, const LayerSample& sample) {
    return isSameField(chosen, outlineZ) &&
           (wkbHasZ(definition.GetGeomType()) != FALSE ||
            std::ranges::any_of(sample.features, [](const auto& one) { return std::isfinite(one.topZ); }));
}

// Whether a geometry consists of the faces of a solid, as a multipatch does.
bool isSolid(const OGRGeometry& geometry) {
    const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
    if (geometry.Is3D() == FALSE) return false;
    if (isUprightFace(geometry)) return true;
    const auto any = [](const auto& faces) {
        return std::any_of(faces.begin(), faces.end(),
                           [](const OGRGeometry* face) { return isSolid(*face); });
    };
    if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection)) return any(*geometry.toGeometryCollection());
    if (OGR_GT_IsSubClassOf(type, wkbPolyhedralSurface)) return any(*geometry.toPolyhedralSurface());
    return false;
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
    const OGRFeatureDefn& definition = *layer.GetLayerDefn();
    made.names_ = knownNames(definition, source);
    const FieldChoice choice{knownName(definition, source, made.names_, settings.heightField),
                             knownName(definition, source, made.names_, settings.levelsField),
                             knownName(definition, source, made.names_, settings.nameField)};
    const LayerSample sample = sampleLayer(layer);
    for (const std::string& chosen : {choice.height, choice.levels, choice.name})
        if (!chosen.empty() && !hasField(made.names_, chosen) && !isOutlineZ(chosen, definition, sample))
            return failure(fmt::format("There is no field \"{}\"", chosen), source.file,
                           fmt::format("Its fields are: {}", fmt::join(made.names_, ", ")));
    made.fields_ = knownFields(made.names_, choice, source.shapefile);
    made.learn(layer, sample, settings, warnings);
    const bool converted = made.otherTags_ >= 0 || made.osmWayId_ >= 0;
    made.rules_.tagged = isTagged(made.fields_, converted);
    made.rules_.sayNoBuilding = !converted;
    made.rules_.heights.decimalComma = !made.rules_.tagged;
    return made;
}

// What the values of the first features say about the fields.
void FootprintLayer::learn(OGRLayer& layer, const LayerSample& sample, const ReadSettings& settings,
                           Warnings& warnings) {
    const OGRSpatialReference system = findLayerSystem(layer, settings.crs);
    encoding_ = sample.encoding;
    if (sample.encoding != TextEncoding::utf8)
        warnings.push_back({WarningKind::assumed,
                            fmt::format("its texts are not UTF-8 and state no encoding; they are read as {}",
                                        nameOf(sample.encoding)),
                            source_.file});
    publishedPlane_ = system.IsProjected() != 0 && system.GetAuthorityCode(nullptr) != nullptr;
    if (!settings.heightUnit) weighHeights(fields_, sample);
    settleUnits(fields_, {settings.heightUnit, isInFeet(system)});
    if (settings.heightField.empty()) dropRoofsAlone(fields_, sample, source_.file, warnings);
    if (!settings.heightUnit) doubts_ = doubtHeights(fields_, sample, source_.file);
    unknownFields_ = unknownFields(names_, fields_, source_.shapefile);
    for (const auto& [index, name] : unknownFields_)
        unknown_.compare(name, weighField(index, fields_, sample));
    if (!hasRole(fields_, FieldRole::building)) kindField_ = findKindField(names_, sample);
    learnOutlineZ(sample, settings, isInFeet(system));
}

void FootprintLayer::learnOutlineZ(const LayerSample& sample, const ReadSettings& settings, bool mapInFeet) {
    zUnit_ = settings.heightUnit.value_or(mapInFeet ? LengthUnit::feet : LengthUnit::metres);
    if (isSameField(settings.heightField, outlineZ)) {
        std::erase_if(fields_, [](const KnownField& field) {
            return field.meaning.role == FieldRole::height || field.meaning.role == FieldRole::topElevation;
        });
        zRole_ = FieldRole::height;
    } else if (settings.heightField.empty() && areOutlinesAtRoofs(fields_, sample)) {
        zRole_ = FieldRole::topElevation;
    }
}

FootprintLayer::FootprintLayer(OGRLayer& layer, CrsToLonLat toLonLat, const ReadSettings& settings,
                               LayerSource source)
    : name_(layer.GetName()), source_(std::move(source)), toLonLat_(std::move(toLonLat)) {
    toLonLat_.removeZoneNumber();
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
        if (auto value = valueOf(feature, field, encoding_)) values.push_back(*std::move(value));
    if (otherTags_ < 0 || feature.IsFieldSetAndNotNull(otherTags_) == FALSE) return values;
    for (auto& [key, text] : parseTags(feature.GetFieldAsString(otherTags_)))
        if (const auto meaning = findTagMeaning(key))
            values.push_back(
                {meaning->role, key, trimmed(text), {}, meaning->unit.value_or(LengthUnit::metres)});
    return values;
}

void FootprintLayer::read(const OGRFeature& feature, Warnings& warnings) {
    FeatureValues values = getValues(feature);
    const std::string id = idOf(feature, values);
    const OGRGeometry* geometry = feature.GetGeometryRef();
    if (isOtherKind(feature, id, warnings)) return;
    if (geometry != nullptr && geometry->Is3D() != FALSE) {
        auto z = outlineZOf(*geometry, id, warnings);
        hasZ_ = hasZ_ || (!z && !zRole_);
        if (z) values.push_back(*std::move(z));
    }
    auto polygons = geometry != nullptr ? readPolygons(*geometry) : std::vector<CrsPolygon>();
    polygonFeatures_ += polygons.empty() ? 0 : 1;
    auto facts = collectFacts(values, rules_, id, warnings);
    if (!facts) return;
    if (polygons.empty()) {
        warnings.push_back({WarningKind::dropped, "has no polygon", facts->id});
        return;
    }
    ++origins_[facts->heights.origin];
    watchUnknown(feature);
    nearZero_ += couldBeDegrees(polygons) ? 1 : 0;
    kept_.push_back({*std::move(facts), std::move(polygons)});
}

bool FootprintLayer::isOtherKind(const OGRFeature& feature, const std::string& id, Warnings& warnings) const {
    if (kindField_ < 0 || feature.IsFieldSetAndNotNull(kindField_) == FALSE) return false;
    const std::string text = textOf(feature, kindField_, encoding_);
    if (!namesOtherLayer(text)) return false;
    warnings.push_back(
        {WarningKind::leftOut,
         fmt::format("is no building but \"{}\", says the field {}", text, names_[std::size_t(kindField_)]),
         id});
    return true;
}

std::optional<FieldRole> FootprintLayer::roleOfZ(const OGRGeometry& geometry, const std::string& id,
                                                 Warnings& warnings) const {
    const auto corner = source_.kml ? KmlPolygons::firstCornerOf(geometry) : std::nullopt;
    const auto standing = corner ? source_.kml->findStanding(*corner) : std::nullopt;
    if (zRole_ || !standing) return zRole_;
    if (standing == KmlStanding::onGround) return std::nullopt;
    if (standing == KmlStanding::floating)
        warnings.push_back({WarningKind::assumed,
                            "it floats at its altitude without walls; it is drawn down to the ground", id});
    return standing == KmlStanding::absolute ? FieldRole::topElevation : FieldRole::height;
}

// The height of a solid, or the highest point of the outline where its meaning is known.
std::optional<FeatureValue> FootprintLayer::outlineZOf(const OGRGeometry& geometry, const std::string& id,
                                                       Warnings& warnings) const {
    OGREnvelope3D box;
    geometry.getEnvelope(&box);
    if (isSolid(geometry)) {
        const double heightM = (box.MaxZ - box.MinZ) * metresPer(zUnit_);
        return FeatureValue{FieldRole::height, outlineZ, fmt::format("{:g}", heightM), heightM, {}};
    }
    const auto role = roleOfZ(geometry, id, warnings);
    const double topM = box.MaxZ * metresPer(zUnit_);
    if (!role || topM < minLandM) return std::nullopt;  // -1000 and the like mean "unknown"
    return FeatureValue{*role, outlineZ, fmt::format("{:g}", topM), topM, {}};
}

void FootprintLayer::watchUnknown(const OGRFeature& feature) {
    for (const auto& [index, name] : unknownFields_) {
        if (feature.IsFieldSetAndNotNull(index) == FALSE) continue;
        const bool number = isNumber(feature.GetFieldDefnRef(index)->GetType());
        const std::string text = textOf(feature, index, encoding_);
        if (!text.empty())
            unknown_.add(name, text, number ? std::optional(feature.GetFieldAsDouble(index)) : std::nullopt);
    }
    const OGRGeometry& geometry = *feature.GetGeometryRef();
    if (zRole_ || source_.kml || geometry.Is3D() == FALSE) return;
    OGREnvelope3D box;
    geometry.getEnvelope(&box);
    unknown_.add(outlineZ, {}, box.MaxZ);
}

void FootprintLayer::addHeightFacts(HeightFacts& facts, Warnings& warnings) const {
    std::vector<KnownField> fields = fields_;
    const bool fromZ =
        std::ranges::any_of(origins_, [](const auto& origin) { return origin.first.starts_with(outlineZ); });
    if (fromZ) {
        const FieldMeaning meaning{
            FieldRole::height, std::numeric_limits<int>::max(), {}, "of the outline", {}};
        fields.push_back({-1, outlineZ, meaning, LengthUnit::metres});
    }
    const std::string where = source_.oneOfSeveral ? source_.file + ": " + name_ : source_.file;
    noonmark::addHeightFacts(origins_, fields, unknown_, where, facts, warnings);
    facts.doubts.insert(facts.doubts.end(), doubts_.begin(), doubts_.end());
    for (const HeightDoubt& doubt : doubts_)
        warnings.push_back({WarningKind::assumed, "the unit of the heights is doubtful", describe(doubt)});
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
    const auto isMost = [&](std::size_t count) { return count > 0 && 2 * count > polygonFeatures_; };
    if (isMost(broken_))
        return failure(fmt::format("Its coordinates cannot belong to {}", toLonLat_.name()), source_.file,
                       crsAdvice());
    if (publishedPlane_ && isMost(nearZero_))
        return failure(fmt::format("Its coordinates look like degrees, not like {}", toLonLat_.name()),
                       source_.file, crsAdvice() + ", perhaps EPSG:4326");
    if (isMost(implausible_))
        warnings.push_back(
            {WarningKind::assumed,
             fmt::format("its position is far outside the area of use of {}", toLonLat_.name()),
             source_.file});
    if (toLonLat_.hasRemovedZoneNumber())
        warnings.push_back({WarningKind::assumed, std::string(zoneNumberRemoved), source_.file});
    if (hasZ_)
        warnings.push_back({WarningKind::leftOut, "the elevations in its polygons; only outlines are used",
                            source_.oneOfSeveral ? source_.file + ": " + name_ : source_.file});
    return {};
}

}  // namespace noonmark
