#include "core/io/footprints/list_fields.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/io/files/plain_file.h"
#include "core/io/heights/height_facts.h"

namespace noonmark {

Result<std::vector<ListedLayer>> listLayers(const std::filesystem::path& file, const std::stop_token& stop,
                                            Formats formats) {
    const auto format = detectFormat(file, formats);
    if (!format) return tl::make_unexpected(format.error());
    const auto list = (*format)->reader.list;
    if (list == nullptr) return std::vector<ListedLayer>{};
    return list(file, stop);
}

std::string describeValues(const ListedField& field, std::size_t sampled) {
    const std::string of = formatThousands(sampled);
    if (field.values == 0) return fmt::format("no value in the first {} features", of);
    const std::string range = field.low ? fmt::format("{:g} to {:g} in ", *field.low, *field.high) : "";
    return fmt::format("{} ({}{} of {} features)", fmt::join(field.samples, ", "), range,
                       formatThousands(field.values), of);
}

std::string_view nameOfRole(std::optional<FieldRole> role) {
    if (!role) return {};
    switch (*role) {
        case FieldRole::height:
            return "height";
        case FieldRole::levels:
            return "storeys";
        case FieldRole::name:
            return "name";
        case FieldRole::topElevation:
            return "elevation of the roof";
        case FieldRole::groundElevation:
            return "elevation of the ground";
        default:
            return {};
    }
}

}  // namespace noonmark
