#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/base/warnings.h"
#include "core/io/files/readable_text.h"
#include "core/io/heights/field_roles.h"
#include "core/io/heights/unknown_fields.h"

class OGRLayer;
class GDALDataset;

namespace noonmark {

/// One of a layer's first features; by index of its fields. NaN or empty where there is no value.
struct SampledFeature {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> numbers;     ///< of number fields, and of texts that are a length or a number
    std::vector<std::string> texts;  ///< of text fields, at most 40 bytes each
    double area = 0;                 ///< in plan, squared units of the layer's coordinates
    double topZ = none;              ///< the highest of the outline
};

/// The first features of a layer with polygons, to learn what its fields and the layer hold.
struct LayerSample {
    std::vector<SampledFeature> features;
    double coverage =
        0;  ///< of their convex hull, by the sum of their areas; 1 and more: they fill a surface
    TextEncoding encoding = TextEncoding::utf8;  ///< of names and texts; another where one is not UTF-8
};

/// Reads at most 1,000 features from the layer's beginning, about 10 us each, and resets it. Messages of the
/// map library are left to the actual reading. Backend: building_layers_gdal.cpp.
LayerSample sampleLayer(OGRLayer& layer);

/// Sets the unit of height fields whose name states none where the values show it: by storeys or by another
/// height (height_text.h), or as inches if the name ends in "in". A field of heights that repeats the
/// storeys becomes one of storeys. Each is noted as the field's assumption.
void weighHeights(std::vector<KnownField>& fields, const LayerSample& sample);

/// What makes the unit of the heights doubtful, with units settled: values that no town has, or a name that
/// may have been cut off before its unit. `file`: for HeightDoubt.
std::vector<HeightDoubt> doubtHeights(const std::vector<KnownField>& fields, const LayerSample& sample,
                                      const std::string& file);

/// A height of the roof that stands for that of the building (knownFields) does not where its values, with
/// units settled, are lower than buildings: half of them below 3 m. It gives a warning. `where`: the layer.
void dropRoofsAlone(std::vector<KnownField>& fields, const LayerSample& sample, const std::string& where,
                    Warnings& warnings);

/// What the sample says about an unknown field.
FieldEvidence weighField(int index, const std::vector<KnownField>& fields, const LayerSample& sample);

/// Whether the highest points of the outlines are the roofs: they lie above the stated ground, mostly by 2 m
/// or more.
bool areOutlinesAtRoofs(const std::vector<KnownField>& fields, const LayerSample& sample);

/// The index of a field that says what kind of object a feature is ("type": "Building", "District System") if
/// it calls some of the sample buildings and others not; -1 without one.
int findKindField(const std::vector<std::string>& names, const LayerSample& sample);

/// Whether such a field's text names buildings.
bool namesBuilding(const std::string& text);
/// Whether it names what layers other than buildings hold, and no building.
bool namesOtherLayer(const std::string& text);

/// Whether a layer's type of geometry is polygons, or any.
bool mayHavePolygons(OGRLayer& layer);

/// The polygon layers of a file that hold buildings. One polygon layer is taken as it is. Of several, those
/// whose name says building are; else, of those that neither their name (plots, streets, districts) nor their
/// shapes, which fill the ground, exclude, those with fields of buildings (heights, storeys, OpenStreetMap's
/// tags); else the rest of these; else all. Of a file that Noonmark wrote, its own. Each layer that is left
/// out gives a warning that says why and how to read it, and so does each of several that are read. Backend:
/// building_layers_gdal.cpp.
std::vector<OGRLayer*> chooseBuildingLayers(GDALDataset& dataset, Warnings& warnings);

}  // namespace noonmark
