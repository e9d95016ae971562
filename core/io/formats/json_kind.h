#pragma once

#include <iosfwd>

namespace noonmark {

enum class JsonKind {
    cityJson,  ///< CityJSON, or CityJSONSeq (its first line is CityJSON)
    geoJson,
    gltf,
    other,  ///< something else, or not JSON
};

/// What kind of JSON a stream holds, from the keys of its outermost object. Reads as far as the first key
/// that identifies the kind; keys may come in any order, and the rest may be broken.
JsonKind detectJsonKind(std::istream& stream);

}  // namespace noonmark
