#include "core/io/formats/json_kind.h"

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace noonmark {

namespace {

JsonKind kindOfType(std::string_view type) {
    if (type == "CityJSON" || type == "CityJSONFeature") return JsonKind::cityJson;
    if (type == "FeatureCollection" || type == "Feature" || type == "GeometryCollection")
        return JsonKind::geoJson;
    if (type.ends_with("Polygon") || type.ends_with("Point") || type.ends_with("LineString"))
        return JsonKind::geoJson;
    return JsonKind::other;
}

JsonKind kindOfKey(std::string_view key) {
    if (key == "CityObjects") return JsonKind::cityJson;
    if (key == "features") return JsonKind::geoJson;
    if (key == "asset") return JsonKind::gltf;
    return JsonKind::other;
}

// Inspects only the keys of the outermost object; every callback returns whether to read on.
class KindFinder final : public nlohmann::json_sax<nlohmann::json> {
public:
    JsonKind kind = JsonKind::other;

    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(number_integer_t) override { return true; }
    bool number_unsigned(number_unsigned_t) override { return true; }
    bool number_float(number_float_t, const string_t&) override { return true; }
    bool binary(binary_t&) override { return true; }
    bool string(string_t& text) override {
        if (depth_ == 1 && key_ == "type") kind = kindOfType(text);
        return undecided();
    }
    bool key(string_t& text) override {
        if (depth_ != 1) return true;
        key_ = text;
        kind = kindOfKey(key_);
        return undecided();
    }
    bool start_object(std::size_t) override { return enter(); }
    bool end_object() override { return leave(); }
    bool start_array(std::size_t) override { return enter(); }
    bool end_array() override { return leave(); }
    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
        return false;
    }

private:
    [[nodiscard]] bool undecided() const { return kind == JsonKind::other; }
    bool enter() {
        ++depth_;
        return true;
    }
    bool leave() {
        --depth_;
        return true;
    }
    int depth_ = 0;
    std::string key_;
};

}  // namespace

JsonKind detectJsonKind(std::istream& stream) {
    KindFinder finder;
    nlohmann::json::sax_parse(stream, &finder, nlohmann::json::input_format_t::json, false);
    return finder.kind;
}

}  // namespace noonmark
