#include "core/io/cityjson/lod_choice.h"

#include <charconv>

namespace noonmark {

Result<LodChoice> parseLodChoice(const std::string& lod) {
    if (lod.empty()) return LodChoice{};
    double number = 0;
    const auto [end, error] = std::from_chars(lod.data(), lod.data() + lod.size(), number);
    if (error != std::errc() || end != lod.data() + lod.size())
        return failure("\"" + lod + "\" is not a level of detail", {}, "Give a number such as 1.2 or 2.2");
    return LodChoice{number};
}

bool isBetter(const LodRank& a, const LodRank& b, const LodChoice& choice) {
    const double wished = choice.wished.value_or(1e9);
    const bool aReachable = a.lod <= wished;
    const bool bReachable = b.lod <= wished;
    if (aReachable != bReachable) return aReachable;
    if (a.lod != b.lod) return aReachable ? a.lod > b.lod : a.lod < b.lod;
    return a.solid && !b.solid;
}

}  // namespace noonmark
