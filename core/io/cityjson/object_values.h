#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/io/cityjson/cityjson_model.h"
#include "core/io/settings/read_settings.h"

namespace noonmark {

/// An attribute of an object, as its file writes it.
struct ObjectAttribute {
    std::string name;
    std::string text;                     ///< a number in decimal; empty if it is neither text nor number
    std::optional<double> number;         ///< if the file states it as one
    std::optional<LengthUnit> unit = {};  ///< stated with the value
};

/// Finds out which attributes of the objects of a file determine heights.
class ObjectValues {
public:
    /// `settings` must outlive it. `file`: for warnings.
    ObjectValues(std::string file, const ReadSettings& settings)
        : file_(std::move(file)), settings_(settings) {}

    /// Fills the object's values and adds to the data's fields and unknown fields. Objects may have different
    /// attributes: the meaning of a field is decided among the attributes of the same object.
    void add(const std::vector<ObjectAttribute>& attributes, CityJsonObject& object, CityJsonData& data);

private:
    void learnFields(const std::vector<ObjectAttribute>& attributes, CityJsonData& data);

    std::string file_;
    const ReadSettings& settings_;
    // Of the previous object: most have the attributes of the one before.
    std::vector<std::string> names_, unknown_;
    std::vector<KnownField> fields_;
};

}  // namespace noonmark
