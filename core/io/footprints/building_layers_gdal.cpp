#include "core/io/footprints/building_layers.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>
#include <algorithm>
#include <map>
#include <memory>
#include <string_view>

#include "core/base/gdal_calls.h"
#include "core/describe/text.h"
#include "core/io/heights/height_text.h"
#include "core/io/heights/name_words.h"
#include "core/io/settings/read_settings.h"

namespace noonmark {

namespace {

constexpr std::size_t maxSampled = 1000;
constexpr std::size_t maxSampledBytes = 40;

bool isNumberType(OGRFieldType type) { return type == OFTInteger || type == OFTInteger64 || type == OFTReal; }

/// What the names and texts of a table say about its encoding.
class EncodingVotes {
public:
    void add(std::string_view bytes) {
        if (const TextEncoding found = guessEncoding(bytes); found != TextEncoding::utf8)
            bytes_[found] += bytes.size();
    }
    // One text in CP932, and one of another East Asian encoding, tell more than many that could also be
    // Windows-1252; of these encodings the one of most bytes counts.
    [[nodiscard]] TextEncoding winner() const {
        if (bytes_.contains(TextEncoding::cp932)) return TextEncoding::cp932;
        TextEncoding best = bytes_.empty() ? TextEncoding::utf8 : TextEncoding::windows1252;
        std::size_t maxBytes = 0;
        for (const auto& [encoding, bytes] : bytes_)
            if (encoding != TextEncoding::windows1252 && bytes > maxBytes) best = encoding, maxBytes = bytes;
        return best;
    }

private:
    std::map<TextEncoding, std::size_t> bytes_;
};

void addFields(const OGRFeature& feature, SampledFeature& sampled, EncodingVotes& votes) {
    for (int i = 0; i < feature.GetFieldCount(); ++i) {
        double& number = sampled.numbers.emplace_back(SampledFeature::none);
        std::string& text = sampled.texts.emplace_back();
        if (feature.IsFieldSetAndNotNull(i) == FALSE) continue;
        const OGRFieldType type = feature.GetFieldDefnRef(i)->GetType();
        if (isNumberType(type)) number = feature.GetFieldAsDouble(i);
        if (type != OFTString) continue;
        votes.add(feature.GetFieldAsString(i));
        text = readableText(feature.GetFieldAsString(i)).substr(0, maxSampledBytes);
        number = parseMetres(withDecimalPoint(text)).value_or(SampledFeature::none);
    }
}

double highestZ(const OGRGeometry& geometry) {
    if (geometry.Is3D() == FALSE) return SampledFeature::none;
    OGREnvelope3D envelope;
    geometry.getEnvelope(&envelope);
    return envelope.MaxZ;
}

double areaOf(const OGRGeometry& geometry) {
    const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
    if (OGR_GT_IsSurface(type)) return geometry.toSurface()->get_Area();
    if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection)) return geometry.toGeometryCollection()->get_Area();
    return 0;
}

void addCorners(const OGRGeometry& geometry, OGRMultiPoint& corners) {
    OGREnvelope box;
    geometry.getEnvelope(&box);
    for (const double x : {box.MinX, box.MaxX})
        for (const double y : {box.MinY, box.MaxY}) corners.addGeometryDirectly(new OGRPoint(x, y));
}

double hullArea(const OGRMultiPoint& corners) {
    const std::unique_ptr<OGRGeometry> hull(corners.ConvexHull());
    return hull ? areaOf(*hull) : 0;
}

}  // namespace

LayerSample sampleLayer(OGRLayer& layer) {
    const GdalCalls quiet;
    LayerSample sample;
    OGRMultiPoint corners;
    EncodingVotes votes;
    double areas = 0;
    for (int i = 0; i < layer.GetLayerDefn()->GetFieldCount(); ++i)
        votes.add(layer.GetLayerDefn()->GetFieldDefn(i)->GetNameRef());
    layer.ResetReading();
    for (std::size_t i = 0; i < maxSampled; ++i) {
        const OGRFeatureUniquePtr feature(layer.GetNextFeature());
        if (!feature) break;
        const OGRGeometry* const geometry = feature->GetGeometryRef();
        if (geometry == nullptr || geometry->IsEmpty() != FALSE || geometry->getDimension() < 2) continue;
        SampledFeature& sampled = sample.features.emplace_back();
        addFields(*feature, sampled, votes);
        areas += sampled.area = areaOf(*geometry);
        sampled.topZ = highestZ(*geometry);
        addCorners(*geometry, corners);
    }
    layer.ResetReading();
    sample.encoding = votes.winner();
    const double hull = hullArea(corners);
    sample.coverage = hull > 0 ? areas / hull : 0;
    return sample;
}

namespace {

// The layer that writeCityGeoPackage() writes; other layers of such a file are not buildings.
bool isOurOwn(OGRLayer& layer) {
    const OGRFeatureDefn& fields = *layer.GetLayerDefn();
    return std::string_view(layer.GetName()) == "buildings" && fields.GetFieldIndex("building_id") >= 0 &&
           fields.GetFieldIndex("height_source") >= 0;
}

// How much speaks for a layer, from nothing to its name.
enum class Likeness { other, unclear, byFields, byName };

struct JudgedLayer {
    OGRLayer* layer;
    Likeness likeness;
    std::string_view why;  // it is no layer of buildings
};

// Fields that only tables of buildings have. A name, an id or a plain "level" says nothing.
bool hasBuildingFields(OGRLayer& layer) {
    const OGRFeatureDefn& definition = *layer.GetLayerDefn();
    for (int i = 0; i < definition.GetFieldCount(); ++i) {
        const auto meaning = findMeaning(readableText(definition.GetFieldDefn(i)->GetNameRef()));
        if (!meaning) continue;
        using enum FieldRole;
        for (const FieldRole role :
             {height, levels, topElevation, roofHeight, roofShape, building, buildingPart})
            if (meaning->role == role) return true;
    }
    return false;
}

// Buildings leave streets and yards free; cells of a tessellation or parcels of a block do not.
bool fillsTheGround(OGRLayer& layer) {
    constexpr double maxBuilt = 0.85;
    constexpr std::size_t fewest = 20;
    const LayerSample sample = sampleLayer(layer);
    return sample.features.size() >= fewest && sample.coverage > maxBuilt;
}

JudgedLayer judge(OGRLayer& layer) {
    const NameWords words(readableText(layer.GetName()));
    if (words.has(NameWord::otherLayer)) return {&layer, Likeness::other, "its name says something else"};
    if (words.has(NameWord::building)) return {&layer, Likeness::byName, ""};
    if (layer.GetFeatureCount() == 0) return {&layer, Likeness::other, ""};
    // Zones have heights too: the highest that is allowed there.
    if (fillsTheGround(layer)) return {&layer, Likeness::other, "its polygons cover the ground without gaps"};
    if (hasBuildingFields(layer)) return {&layer, Likeness::byFields, ""};
    return {&layer, Likeness::unclear, ""};
}

std::string describeRejection(const JudgedLayer& layer, Likeness best) {
    if (!layer.why.empty()) return std::string(layer.why);
    return best == Likeness::byName ? "the name of another says buildings"
                                    : "another has fields of buildings";
}

}  // namespace

bool mayHavePolygons(OGRLayer& layer) {
    const OGRwkbGeometryType type = wkbFlatten(layer.GetGeomType());
    return type == wkbUnknown || OGR_GT_IsSurface(type) || OGR_GT_IsSubClassOf(type, wkbMultiSurface) ||
           type == wkbGeometryCollection;
}

std::vector<OGRLayer*> chooseBuildingLayers(GDALDataset& dataset, Warnings& warnings) {
    std::vector<JudgedLayer> judged;
    for (OGRLayer* layer : dataset.GetLayers()) {
        if (isOurOwn(*layer)) return {layer};
        if (mayHavePolygons(*layer)) judged.push_back({layer, Likeness::unclear, ""});
    }
    if (judged.size() == 1) return {judged.front().layer};
    for (JudgedLayer& one : judged) one = judge(*one.layer);
    Likeness best = Likeness::other;
    for (const JudgedLayer& one : judged) best = std::max(best, one.likeness);
    std::vector<OGRLayer*> chosen;
    for (const JudgedLayer& one : judged)
        if (one.likeness == best)
            chosen.push_back(one.layer);
        else if (one.layer->GetFeatureCount() != 0)
            warnings.push_back(
                {WarningKind::leftOut,
                 fmt::format("a layer that was taken for no layer of buildings, since {}; if it "
                             "is one, read it with {}",
                             describeRejection(one, best), readOption("layer")),
                 readableText(one.layer->GetName())});
    if (chosen.size() > 1)
        for (OGRLayer* layer : chosen)
            warnings.push_back({WarningKind::assumed,
                                NM_TEXT("one of several polygon layers; all are read as buildings"),
                                layer->GetName()});
    return chosen;
}

}  // namespace noonmark
