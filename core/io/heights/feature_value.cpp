#include "core/io/heights/feature_value.h"

#include <algorithm>

namespace noonmark {

const FeatureValue* firstOf(const FeatureValues& values, FieldRole role) {
    const auto found = std::ranges::find(values, role, &FeatureValue::role);
    return found == values.end() ? nullptr : &*found;
}

}  // namespace noonmark
