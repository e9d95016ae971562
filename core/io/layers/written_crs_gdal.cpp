#include <ogrsf_frmts.h>

#include <string_view>

#include "core/io/layers/written_crs.h"

namespace noonmark {

namespace {

/// A geometry as PostGIS writes it: "SRID=25833;POINT (...)".
struct WrittenGeometry {
    std::string_view number, shape;
};

std::optional<WrittenGeometry> splitWritten(std::string_view text) {
    constexpr std::string_view before = "SRID=";
    constexpr std::size_t maxDigits = 6;
    const auto end = text.find(';');
    if (!text.starts_with(before) || end == text.npos) return std::nullopt;
    const std::string_view number = text.substr(before.size(), end - before.size());
    const bool isNumber = !number.empty() && number.size() <= maxDigits &&
                          number.find_first_not_of("0123456789") == number.npos;
    return isNumber ? std::optional(WrittenGeometry{number, text.substr(end + 1)}) : std::nullopt;
}

std::optional<WrittenGeometry> findWritten(const OGRFeature& feature) {
    for (int i = 0; i < feature.GetFieldCount(); ++i) {
        const bool isText = feature.GetFieldDefnRef(i)->GetType() == OFTString;
        if (!isText || feature.IsFieldSetAndNotNull(i) == FALSE) continue;
        if (const auto written = splitWritten(feature.GetFieldAsString(i))) return written;
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> findWrittenCrs(OGRLayer& layer) {
    layer.ResetReading();
    const OGRFeatureUniquePtr first(layer.GetNextFeature());
    layer.ResetReading();
    const auto written = first ? findWritten(*first) : std::nullopt;
    return written ? std::optional("EPSG:" + std::string(written->number)) : std::nullopt;
}

std::unique_ptr<OGRGeometry> readWrittenGeometry(const OGRFeature& feature) {
    const auto written = findWritten(feature);
    if (!written) return nullptr;
    OGRGeometry* made = nullptr;
    if (OGRGeometryFactory::createFromWkt(std::string(written->shape).c_str(), nullptr, &made) != OGRERR_NONE)
        return nullptr;
    return std::unique_ptr<OGRGeometry>(made);
}

}  // namespace noonmark
