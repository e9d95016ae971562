#include <ogrsf_frmts.h>

#include <algorithm>
#include <memory>

#include "core/base/gdal_calls.h"
#include "core/io/files/readable_text.h"
#include "core/io/footprints/layer_sample.h"
#include "core/io/heights/height_text.h"

namespace noonmark {

namespace {

constexpr std::size_t maxSampled = 1000;
constexpr std::size_t maxTextBytes = 40;

bool isNumberType(OGRFieldType type) { return type == OFTInteger || type == OFTInteger64 || type == OFTReal; }

// One text in CP932 tells more than many that could also be Windows-1252.
void learnEncoding(const char* bytes, TextEncoding& encoding) {
    if (encoding != TextEncoding::cp932)
        if (const TextEncoding found = guessEncoding(bytes); found != TextEncoding::utf8) encoding = found;
}

void addFields(const OGRFeature& feature, SampledFeature& sampled, TextEncoding& encoding) {
    for (int i = 0; i < feature.GetFieldCount(); ++i) {
        double& number = sampled.numbers.emplace_back(SampledFeature::none);
        std::string& text = sampled.texts.emplace_back();
        if (feature.IsFieldSetAndNotNull(i) == FALSE) continue;
        const OGRFieldType type = feature.GetFieldDefnRef(i)->GetType();
        if (isNumberType(type)) number = feature.GetFieldAsDouble(i);
        if (type != OFTString) continue;
        learnEncoding(feature.GetFieldAsString(i), encoding);
        text = readableText(feature.GetFieldAsString(i)).substr(0, maxTextBytes);
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
    double areas = 0;
    for (int i = 0; i < layer.GetLayerDefn()->GetFieldCount(); ++i)
        learnEncoding(layer.GetLayerDefn()->GetFieldDefn(i)->GetNameRef(), sample.encoding);
    layer.ResetReading();
    for (std::size_t i = 0; i < maxSampled; ++i) {
        const OGRFeatureUniquePtr feature(layer.GetNextFeature());
        if (!feature) break;
        const OGRGeometry* const geometry = feature->GetGeometryRef();
        if (geometry == nullptr || geometry->IsEmpty() != FALSE || geometry->getDimension() < 2) continue;
        SampledFeature& sampled = sample.features.emplace_back();
        addFields(*feature, sampled, sample.encoding);
        areas += sampled.area = areaOf(*geometry);
        sampled.topZ = highestZ(*geometry);
        addCorners(*geometry, corners);
    }
    layer.ResetReading();
    const double hull = hullArea(corners);
    sample.coverage = hull > 0 ? areas / hull : 0;
    return sample;
}

}  // namespace noonmark
